# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of terrain-render in a plotter; skipped without PyVista or GDAL's module."""
import os
import tempfile
import unittest
import warnings

import numpy as np
import vtkTerrainTesting

try:
    import pyvista
    import vtkTerrainFormats as made
    from osgeo import gdal

    from vtkterrain.scenes import add_scene, read_scene

    gdal.UseExceptions()
    WHY_NOT = ""
except ImportError as error:
    WHY_NOT = str(error)


@unittest.skipIf(WHY_NOT, WHY_NOT)
class TestSceneFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(self.plotter.close)
        self.heights = os.path.join(self.folder, "hills.tif")
        gdal.GetDriverByName("GTiff").CreateCopy(self.heights, made.dataset(made.ground(), place=made.UTM))

    def write(self, text, name="view.toml"):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("# terrain-render --scene FILE\n" + text)
        return path

    def add(self, text, **options):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", DeprecationWarning)  # of others
            return add_scene(self.plotter, self.write('heights = "hills.tif"\n' + text), **options)

    def test_options_are_those_of_the_file(self):
        options = read_scene(self.write('heights = "hills.tif"\ntrack = ["a.gpx", "/b.gpx"]\nshadows = true\n'
                                        'colors = "viridis"\nsun = "200,30"\ncontours = 5\n'))
        self.assertEqual(options, {"heights": self.heights, "track": [os.path.join(self.folder, "a.gpx"), "/b.gpx"],
                                   "shadows": True, "colors": "viridis", "sun": "200,30", "contours": 5})

    def test_looks_are_those_of_the_scene(self):
        terrain = self.add('exaggeration = 2.5\ncontours = 7\nhillshade = true\nblock = 30\nshadows = true\n'
                           'sky-light = 0.5\ntechnique = "pyramid"\nsize = "320x200"\nbackground = "black,white"\n'
                           'title = "Hills"\ncaption = "A test"\nview-angle = 20\noutput = "a.png"\n')
        mapper = terrain.GetTerrainMapper()
        self.assertEqual(terrain.exaggeration, 2.5)
        self.assertEqual((mapper.GetContours(), mapper.GetContourInterval()), (True, 7.0))
        self.assertEqual((mapper.GetHillshade(), mapper.GetSunShadows(), mapper.GetSkyLight()), (True, True, 0.5))
        heights = [0.0, 0.0]
        mapper.GetHeightRange(heights)
        self.assertAlmostEqual(mapper.GetBlockBase(), heights[0] - 30.0)
        self.assertEqual(tuple(self.plotter.window_size), (320, 200))
        self.assertEqual(self.plotter.camera.view_angle, 20.0)
        picture = self.plotter.screenshot(return_img=True)
        self.assertLess(picture[-1, 0].max(), 10)  # black below, white above
        self.assertGreater(picture[0, 0].min(), 245)

    def test_colors_and_legend(self):
        terrain = self.add('colors = "viridis"\nrange = "10,90"\nreverse = true\nlegend = "Metres"\n')
        table = terrain.GetLookupTable()
        self.assertEqual(tuple(table.GetRange()), (10.0, 90.0))
        color = [0.0, 0.0, 0.0]
        table.GetColor(10.0, color)
        np.testing.assert_allclose(color, [0.993, 0.906, 0.144], atol=0.01)  # the last of viridis
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Metres"])

    def test_the_eye_is_where_the_scene_says(self):
        self.add('camera = "1,2,3000,5,6,7"\n')
        self.assertEqual(tuple(self.plotter.camera.position), (1.0, 2.0, 3000.0))
        self.assertEqual(tuple(self.plotter.camera.focal_point), (5.0, 6.0, 7.0))

    def test_words_beside_the_file_win(self):
        self.assertEqual(self.add("exaggeration = 2.5\n", exaggeration=4.0).exaggeration, 4.0)

    def test_what_is_not_drawn_is_told(self):
        path = self.write('heights = "hills.tif"\nwater = 5\npeaks = 3\nbackground = "sky"\nstats = "a.json"\n')
        with self.assertWarnsRegex(UserWarning, "this is not drawn: water, peaks, background=sky$"):
            add_scene(self.plotter, path)

    def test_what_is_no_scene_is_a_sentence(self):
        with self.assertRaisesRegex(ValueError, "is no scene: .*line 2"):
            read_scene(self.write("heights = \n"))
        with self.assertRaisesRegex(ValueError, "section"):
            read_scene(self.write("[camera]\nup = 1\n"))
        with self.assertRaises(OSError):
            read_scene(os.path.join(self.folder, "nowhere.toml"))
        with self.assertRaisesRegex(ValueError, "names no heights"):
            add_scene(self.plotter, self.write("contours = 5\n"))
        with self.assertRaisesRegex(ValueError, "range of the scene must be 2 numbers"):
            self.add('range = "3"\n')
        with self.assertRaisesRegex(ValueError, "sun of the scene must be 2 numbers"):
            self.add('sun = "3,4,5"\n')


if __name__ == "__main__":
    vtkTerrainTesting.run()
