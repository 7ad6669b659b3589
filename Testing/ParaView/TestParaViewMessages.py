# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin tells of terrains that do not fit, of files and of names that are refused; run by pvbatch."""
import pathlib
import re
import sys
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import terrainScene  # noqa: E402
import vtkTerrainTesting  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

terrainScene.load_plugin()
METRES_OF_A_DEGREE = 110574.3  # of latitude, from 0 to 1 on WGS84


def write_grid(name, west, south, cell, lowest=0):
    """A hill of 61 x 61 samples as a text of whole numbers, whose places are in no system that it names."""
    j, i = np.mgrid[0:61, 0:61]
    heights = lowest + (500 * np.exp(-((i - 30) ** 2 + (j - 20) ** 2) / 200.0)).astype(int)
    rows = "\n".join(" ".join(map(str, row)) for row in heights)
    path = vtkTerrainTesting.output_path(name)
    pathlib.Path(path).write_text(
        f"ncols 61\nnrows 61\nxllcenter {west}\nyllcenter {south}\ncellsize {cell}\n{rows}\n", encoding="ascii")
    return path


def read_tile(name, west, south, system="EPSG:4326", cell=1 / 60):
    reader = simple.TerrainRasterReader(FileName=write_grid(name, west, south, cell), CoordinateSystem=system)
    reader.UpdatePipeline()
    return reader


class TestMessages(unittest.TestCase):
    def setUp(self):
        self.window = vtkStringOutputWindow()
        self.window_before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        self.told = 0
        self.view = terrainScene.new_view()

    def tearDown(self):
        vtkOutputWindow.SetInstance(self.window_before)
        for source in list(simple.GetSources().values())[::-1]:
            simple.Delete(source)
        simple.Delete(self.view)

    def heard(self):
        """What was told since it was last asked for."""
        said = self.window.GetOutput()
        new, self.told = said[self.told:], len(said)
        return new

    def draw(self, *sources):
        """Draws these, and tells what is told of scenes."""
        for source in sources:
            terrainScene.show_terrain(source, self.view)
        simple.Render(self.view)
        return [line for line in self.heard().splitlines() if "scene" in line]

    def test_tiles_of_degrees_have_scenes_of_their_own(self):
        south, north = read_tile("scene-south.asc", 20, 0), read_tile("scene-north.asc", 20, 1)
        self.assertEqual(self.draw(south), [])
        told, = self.draw(north)
        self.assertIn("scene-north.asc' is drawn", told)
        self.assertIn("beside '", told)
        kilometres = float(re.search(r"drawn ([\d.]+) km", told).group(1))
        self.assertAlmostEqual(1000 * kilometres, METRES_OF_A_DEGREE, delta=0.01 * METRES_OF_A_DEGREE)
        north_display = simple.GetDisplayProperties(north, self.view)
        north_display.TerrainVerticalExaggeration = 2.0
        self.assertEqual(self.draw(), [])  # told once
        self.assertIn("Terrain Reproject with both as its Input", told)
        for tile in (south, north):
            simple.Hide(tile, self.view)
        both = simple.TerrainReproject(Input=[south, north])
        self.assertEqual(self.draw(both), [])
        b = both.GetDataInformation().GetBounds()
        self.assertAlmostEqual(b[3] - b[2], 2 * METRES_OF_A_DEGREE, delta=0.02 * METRES_OF_A_DEGREE)

    def test_zones_and_systems(self):
        here = read_tile("zone-33.asc", 500000, 5000000, "EPSG:32633", 30)
        beside = read_tile("zone-33-beside.asc", 501800, 5000000, "EPSG:32633", 30)
        self.assertEqual(self.draw(here, beside), [])
        etrs = read_tile("zone-33-etrs.asc", 503600, 5000000, "EPSG:25833", 30)
        self.assertEqual(self.draw(etrs), [])  # the same ground, by another name
        self.assertEqual(len(self.draw(read_tile("zone-34.asc", 500000, 5000000, "EPSG:32634", 30))), 1)

    def test_who_moves_a_terrain_knows_where_to(self):
        moved = "Translation" if simple.GetParaViewVersion() >= (5, 13) else "Position"
        south, north = read_tile("moved-south.asc", 20, 0), read_tile("moved-north.asc", 20, 1)
        self.assertEqual(self.draw(south), [])
        setattr(terrainScene.show_terrain(north, self.view), moved, [0.0, METRES_OF_A_DEGREE, 0.0])
        self.assertEqual(self.draw(), [])

    def test_reader_names_properties(self):
        heights = write_grid("messages-fill.asc", 0, 0, 30, lowest=200)
        text = pathlib.Path(heights).read_text(encoding="ascii").replace("\n200 200 200", "\n-9999 -9999 -9999")
        pathlib.Path(heights).write_text(text, encoding="ascii")
        reader = simple.TerrainRasterReader(FileName=heights)
        reader.UpdatePipeline()
        told = self.heard()
        self.assertIn("Detect No Data off if they are heights", told)
        self.assertNotIn("--", told.replace("---", ""))
        lowest = reader.PointData["Elevation"].GetRange()[0]
        reader.DetectNoData = 0
        reader.UpdatePipeline()
        self.assertEqual((lowest, reader.PointData["Elevation"].GetRange()[0]), (200.0, -9999.0))
        self.assertEqual(self.heard(), "")

    def test_picture_that_is_not_there_goes_back(self):
        tile = read_tile("messages-drape.asc", 500000, 5000000, "EPSG:32633", 30)
        picture = tile.FileName[0] if not isinstance(tile.FileName, str) else tile.FileName
        display = terrainScene.show_terrain(tile, self.view)
        self.heard()
        for before in ("", picture):
            display.TerrainDrape = before
            self.assertEqual(self.heard(), "")
            display.TerrainDrape = picture + ".none"
            self.assertEqual(display.TerrainDrape, before)
            self.assertIn(f"no file '{picture}.none'", self.heard())
        display.TerrainDrape = ""
        self.assertEqual(display.TerrainDrape, "")


if __name__ == "__main__":
    sys.argv[1:] = []
    vtkTerrainTesting.run()
