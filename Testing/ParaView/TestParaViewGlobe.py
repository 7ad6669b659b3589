# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planets from files, through the reader, the filter Terrain Globe and the representation; run by pvbatch."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import terrainScene  # noqa: E402
import vtkTerrainTesting  # noqa: E402
from paraview import simple  # noqa: E402

terrainScene.load_plugin()
WORLDS = (("earth", "EPSG:4326", 6378137.0, -180.0), ("mars", "IAU_2015:49900", 3396190.0, 0.0),
          ("moon", "IAU_2015:30100", 1737400.0, -180.0))


def write_world(name, west):
    """Cells of two degrees; high where the longitude is 30, in hills of a hundred kilometres."""
    longitude, latitude = np.meshgrid(west + np.arange(1.0, 360.0, 2.0), np.arange(89.0, -90.0, -2.0))
    heights = 3000.0 * np.cos(np.radians(longitude - 30.0)) * np.cos(np.radians(latitude))
    path = vtkTerrainTesting.output_path(f"paraview-{name}.asc")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ncols 180\nnrows 90\nxllcorner {west}\nyllcorner -90\ncellsize 2\n")
        np.savetxt(file, heights, fmt="%.1f")
    return path


def picture(view, name):
    path = vtkTerrainTesting.output_path(f"{name}.png")
    terrainScene.save(view, path)
    return vtkTerrainTesting.read_picture(path).astype(int)


class TestGlobe(unittest.TestCase):
    def setUp(self):
        self.view = terrainScene.new_view()

    def tearDown(self):
        for source in list(simple.GetSources().values())[::-1]:
            simple.Delete(source)
        simple.Delete(self.view)

    def show(self, name, system, west, **options):
        reader = simple.TerrainRasterReader(FileName=write_world(name, west), CoordinateSystem=system)
        globe = simple.TerrainGlobe(reader)
        display = simple.Show(globe, self.view)
        display.SetRepresentationType("Terrain")
        for option, value in options.items():
            setattr(display, option, value)
        return globe, display

    def look(self, radius, longitude=30.0):
        angle = np.radians(longitude)
        self.view.CameraPosition = [5.0 * radius * np.cos(angle), 5.0 * radius * np.sin(angle), 0.0]
        self.view.CameraFocalPoint = [0.0, 0.0, 0.0]
        self.view.CameraViewUp = [0.0, 0.0, 1.0]
        self.view.CameraViewAngle = 30.0

    def test_planets_are_as_large_as_their_systems_say(self):
        for name, system, radius, west in WORLDS:
            with self.subTest(name):
                self.show(name, system, west)
                self.look(radius)
                drawn = picture(self.view, f"globe-{name}")
                shown = (drawn != drawn[0, 0]).any(axis=2)
                height = drawn.shape[0]
                disc = np.tan(np.arcsin(0.2)) / np.tan(np.radians(15.0)) * 0.5 * height
                self.assertAlmostEqual(np.sqrt(shown.sum() / np.pi) / disc, 1.0, delta=0.02)
                self.tearDown()
                self.setUp()

    def test_camera_sees_the_whole_planet(self):
        self.show("earth", "EPSG:4326", -180.0)
        simple.Render(self.view)
        self.view.ResetCamera()
        camera = self.view.GetActiveCamera()
        self.assertLess(np.linalg.norm(camera.GetFocalPoint()), 1e5)
        self.assertGreater(camera.GetDistance(), 1.5e7)
        drawn = picture(self.view, "globe-reset")
        shown = (drawn != drawn[0, 0]).any(axis=2)
        self.assertGreater(shown.mean(), 0.15)
        self.assertFalse(shown[0].any() or shown[-1].any() or shown[:, 0].any() or shown[:, -1].any())

    def test_colours_follow_longitudes(self):
        for name, system, radius, west in WORLDS:
            _, display = self.show(name, system, west)
            simple.ColorBy(display, ("POINTS", "Elevation"))
            colors = simple.GetColorTransferFunction("Elevation")
            colors.RGBPoints = [-3000.0, 0.0, 0.0, 1.0, 3000.0, 1.0, 0.0, 0.0]
            colors.ColorSpace = "RGB"
            for longitude, channel in ((30.0, 0), (210.0, 2)):
                self.look(radius, longitude)
                drawn = picture(self.view, f"globe-{name}-{longitude:.0f}")
                middle = drawn[drawn.shape[0] // 2, drawn.shape[1] // 2]
                self.assertGreater(middle[channel], 2 * middle[2 - channel] + 20, (name, longitude))
            self.tearDown()
            self.setUp()

    def test_properties_change_the_picture(self):
        _, display = self.show("earth", "EPSG:4326", -180.0)
        self.look(6378137.0)
        plain = picture(self.view, "globe-plain")
        for name, default, value, least in (("TerrainContours", 0, 1, 0.005),
                                            ("TerrainVerticalExaggeration", 1.0, 100.0, 0.01)):
            setattr(display, name, value)
            changed = picture(self.view, f"globe-{name}")
            self.assertGreater((np.abs(changed - plain) > 8).any(axis=2).mean(), least, name)
            setattr(display, name, default)
            self.assertEqual(np.abs(picture(self.view, "globe-again") - plain).max(), 0, name)

    def test_other_radii_make_another_planet(self):
        globe, _ = self.show("earth", "EPSG:4326", -180.0)
        self.look(6378137.0)
        wide = picture(self.view, "globe-wide")
        globe.Radii = [3e6, 3e6]
        small = picture(self.view, "globe-small")
        count = [(drawn != drawn[0, 0]).any(axis=2).sum() for drawn in (wide, small)]
        self.assertLess(count[1], 0.4 * count[0])
        self.assertGreater(count[1], 0)


if __name__ == "__main__":
    sys.argv[1:] = []
    vtkTerrainTesting.run()
