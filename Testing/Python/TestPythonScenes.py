# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""One frame for all terrain in a plotter, whatever it comes from; skipped without PyVista, xarray or GDAL's module."""
import os
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np
import vtkTerrainTesting
from vtkmodules.vtkCommonCore import vtkOutputWindow

from vtkterrain import (
    array_from_heights,
    heights_from_array,
    vtkTerrainActor,
    vtkTerrainHierarchy,
    vtkTerrainRasterReader,
)

try:
    import pyvista
    import vtkTerrainFormats as made
    import xarray
    from osgeo import gdal

    import vtkterrain.xarrays  # noqa: F401
    from vtkterrain import plotting

    gdal.UseExceptions()
    WHY_NOT = ""
except ImportError as error:
    WHY_NOT = str(error)

MARS = "+proj=longlat +a=3396190 +b=3396190 +no_defs"


def drawn_bounds(terrain):
    return np.array(terrain.GetHeights().GetBounds()[:4])


@unittest.skipIf(WHY_NOT, WHY_NOT)
class TestScenes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.plotter = pyvista.Plotter(off_screen=True)
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", DeprecationWarning)  # of others

    def tearDown(self):
        warnings.resetwarnings()
        self.folder.cleanup()

    def tile(self, name, heights, place, **options):
        path = os.path.join(self.folder.name, name)
        gdal.GetDriverByName("GTiff").CreateCopy(path, made.dataset(heights, place=place, **options))
        return path

    def halves(self, place):
        """Two files of one ground, side by side."""
        t, system = place
        middle = made.COLUMNS // 2
        west = self.tile("west.tif", made.ground()[:, :middle], place)
        east = self.tile("east.tif", made.ground()[:, middle:], ((t[0] + middle * t[1], *t[1:]), system))
        return west, east

    def add(self, heights, **options):
        return plotting.add_terrain(self.plotter, heights, show_scalar_bar=False, **options)

    def data(self, path):
        """A DataArray as rioxarray opens it."""
        file = gdal.Open(path)
        t = file.GetGeoTransform()
        samples = file.ReadAsArray()
        return xarray.DataArray(samples, dims=("y", "x"), coords={
            "x": t[0] + t[1] * (np.arange(samples.shape[1]) + 0.5),
            "y": t[3] + t[5] * (np.arange(samples.shape[0]) + 0.5),
            "spatial_ref": ((), 0, {"crs_wkt": file.GetSpatialRef().ExportToWkt()})})

    def test_tiles_meet_by_every_road(self):
        for place in (made.UTM, made.DEGREES):
            west, east = self.halves(place)
            for one, other in ((west, east), (west, self.data(east)), (self.data(west), east)):
                self.plotter = pyvista.Plotter(off_screen=True)
                terrains = [self.add(one), self.add(other)]
                bounds = [drawn_bounds(terrain) for terrain in terrains]
                cell = terrains[0].GetHeights().GetSpacing()[0]
                self.assertLess(abs(bounds[1][0] - bounds[0][1]), 2.5 * cell)
                self.assertLess(np.abs(bounds[0][2:] - bounds[1][2:]).max(), 2.5 * cell)

    def test_colors_of_another_raster(self):
        heights = self.tile("heights.tif", made.ground(), made.UTM)
        rain = self.tile("rain.tif", 2.0 * made.ground(), made.UTM)
        terrain = self.add(heights, scalars=rain)
        image = pyvista.wrap(terrain.GetHeights())
        both = np.isfinite(image["Values"])
        self.assertGreater(both.mean(), 0.9)
        np.testing.assert_allclose(image["Values"][both], 2.0 * image.active_scalars[both], atol=1e-3)
        with self.assertRaisesRegex(ValueError, "no array 'nowhere.tif'"):
            self.add(heights, scalars="nowhere.tif")
        far = self.tile("far.tif", made.ground(), ((0.0, 30.0, 0.0, 5000000.0, 0.0, -30.0), "EPSG:32631"))
        with self.assertRaisesRegex(ValueError, "no values on the terrain"):
            self.add(heights, scalars=far)

    def test_accessor_joins(self):
        west, east = self.halves(made.DEGREES)
        first = self.add(west)
        second = self.data(east).terrain.add_to(self.plotter, show_scalar_bar=False)
        self.assertLess(abs(drawn_bounds(second)[0] - drawn_bounds(first)[1]), 2.5 * first.GetHeights().GetSpacing()[0])

    def test_images_and_arrays_with_a_system_join(self):
        west, east = self.halves(made.DEGREES)
        first = self.add(west)
        reader = vtkTerrainRasterReader()
        reader.SetFileName(east)
        reader.Update()
        second = self.add(reader.GetOutput())
        cell = first.GetHeights().GetSpacing()[0]
        self.assertLess(abs(drawn_bounds(second)[0] - drawn_bounds(first)[1]), 2.5 * cell)
        # an array in metres of a UTM zone, round the first one's middle
        self.plotter = pyvista.Plotter(off_screen=True)
        centre = self.add(west)
        zone = self.add(np.full((20, 20), 5.0), spacing=(100.0, 100.0), origin=(581000.0, 5536000.0), crs="EPSG:32632")
        self.assertLess(np.abs(drawn_bounds(zone)).max(), 50e3)
        self.assertLess(np.abs(drawn_bounds(centre)).max(), 50e3)

    def test_what_has_no_system_says_so_once_there_is_a_scene(self):
        self.add(made.ground())  # alone it has nothing to say
        self.plotter = pyvista.Plotter(off_screen=True)
        self.add(self.halves(made.UTM)[0])
        with self.assertWarnsRegex(UserWarning, "no coordinate system .*not in their place"):
            self.add(made.ground())
        with self.assertWarnsRegex(UserWarning, "no coordinate system"):
            self.add(heights_from_array(made.ground()))

    def prepared(self, path, name):
        reader = vtkTerrainRasterReader()
        reader.SetFileName(path)
        reader.Update()
        hierarchy = vtkTerrainHierarchy()
        self.assertTrue(hierarchy.SetHeights(reader.GetOutput()))
        file = os.path.join(self.folder.name, name)
        self.assertTrue(hierarchy.WriteFile(file), hierarchy.GetErrorMessage())
        return file

    def test_prepared_files(self):
        west, east = self.halves(made.UTM)
        for technique in ("pyramid", "strips"):
            self.plotter = pyvista.Plotter(off_screen=True)
            self.add(self.prepared(west, "west.hierarchy"), technique=technique)
            second = self.add(east)
            self.assertEqual(drawn_bounds(second)[0], made.UTM[0][0] + 16.5 * 30.0)
        degrees = self.prepared(self.halves(made.DEGREES)[0], "degrees.hierarchy")
        with self.assertWarnsRegex(UserWarning, "drawn as they stand, in degrees"):
            self.add(degrees)
        self.plotter = pyvista.Plotter(off_screen=True)
        self.add(degrees)
        with self.assertWarnsRegex(UserWarning, "was added before"):
            self.add(east)

    def test_files_drawn_from_tiles(self):
        with unittest.mock.patch.object(plotting, "_is_large", return_value=True):
            west, east = self.halves(made.UTM)
            first, second = self.add(west), self.add(east)
            other = self.tile("zone.tif", made.ground(), (made.UTM[0], "EPSG:32632"))
            with self.assertWarnsRegex(UserWarning, "in 'WGS 84 / UTM zone 32N'"):
                self.add(other)
        self.assertEqual(drawn_bounds(second)[0] - drawn_bounds(first)[1], 30.0)

    def test_other_worlds(self):
        t = (137.0, 0.01, 0.0, -4.0, 0.0, -0.01)
        west, east = self.halves((t, MARS))
        terrains = [self.add(west), self.add(east)]
        bounds = [drawn_bounds(terrain) for terrain in terrains]
        cell = np.radians(0.01) * 3396190.0
        self.assertAlmostEqual(bounds[1][0] - bounds[0][1], cell, delta=0.01 * cell)
        np.testing.assert_allclose(bounds[0][2:], bounds[1][2:], atol=1.0)
        with self.assertWarnsRegex(UserWarning, "the scene is of"):
            self.add(self.tile("earth.tif", made.ground(), made.UTM))
        low = self.tile("low.tif", made.ground() - 4500.0, (t, MARS))
        sea = self.tile("sea.tif", made.ground() - 4500.0, made.UTM)
        for path, is_blue in ((low, False), (sea, True)):
            self.plotter = pyvista.Plotter(off_screen=True)
            colors = self.add(path).GetLookupTable()
            color = [0.0, 0.0, 0.0]
            colors.GetColor(-4470.0, color)
            red, _, blue = color
            self.assertEqual(blue > red, is_blue)

    def test_a_missing_file_is_one_sentence(self):
        texts = []
        window = vtkOutputWindow.GetInstance()
        tag = window.AddObserver("ErrorEvent", lambda *_: texts.append("error"))
        try:
            reader = vtkTerrainRasterReader()
            reader.SetFileName("/nowhere.tif")
            reader.Update()
            self.assertEqual(len(texts), 1)
            self.assertFalse(vtkTerrainActor().SetFileName("/nowhere.tif"))
            self.assertEqual(len(texts), 2)
            with self.assertRaisesRegex(OSError, "there is no such file"):
                self.add("/nowhere.tif")
            self.assertEqual(len(texts), 2)
        finally:
            window.RemoveObserver(tag)

    def test_heights_stay(self):
        terrain = self.add(self.halves(made.UTM)[0])
        np.testing.assert_array_equal(array_from_heights(terrain.GetHeights())[::-1], made.ground()[:, :16])


if __name__ == "__main__":
    if WHY_NOT:
        print("Skipped:", WHY_NOT)
        sys.exit(77)
    vtkTerrainTesting.run()
