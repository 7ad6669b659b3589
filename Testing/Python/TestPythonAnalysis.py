# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons, viewsheds and derivatives of arrays, against brute force and gdaldem."""
import importlib.util
import math
import shutil
import subprocess
import unittest

import numpy as np
import vtkTerrainTesting
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from vtkterrain import analysis, array_from_heights, heights_from_array, vtkTerrainHorizon, vtkTerrainViewshed
from vtkterrain.viewer import read_heights

HAS_XARRAY = importlib.util.find_spec("xarray") is not None


def array_of(algorithm, name):
    """A point array of an algorithm's output, by rows from the south and columns."""
    output = algorithm.GetOutput()
    values = vtk_to_numpy(output.GetPointData().GetArray(name))
    return values.reshape(output.GetDimensions()[1], output.GetDimensions()[0], -1)


class TestAnalysis(unittest.TestCase):
    def test_horizon_along_rows(self):
        heights = np.random.default_rng(7).uniform(0.0, 50.0, (40, 30)).astype(np.float32)
        horizon = vtkTerrainHorizon()
        horizon.SetNumberOfDirections(4)
        horizon.SetInputData(heights_from_array(heights, spacing=(10.0, 10.0)))
        horizon.Update()
        east = array_of(horizon, "Horizon")[:, :, 1]
        for column in range(29):  # to the east surface lines are straight between samples
            rises = heights[:, column + 1:].astype(float) - heights[:, column:column + 1]
            expected = np.degrees(np.arctan((rises / (10.0 * np.arange(1, 30 - column))).max(axis=1)))
            np.testing.assert_allclose(east[:, column], expected, atol=0.01)
        self.assertTrue((east[:, 29] == -90.0).all())
        sky = array_of(horizon, "SkyView")
        self.assertTrue(((sky >= 0.0) & (sky <= 1.0)).all())

    def test_refuses_directions(self):
        horizon = vtkTerrainHorizon()
        horizon.SetInputData(heights_from_array(np.zeros((3, 3))))
        for directions in (0, 1000000):
            horizon.SetNumberOfDirections(directions)
            horizon.GlobalWarningDisplayOff()
            horizon.Update()
            self.assertIn("1 to 3600", horizon.GetErrorMessage())
            horizon.GlobalWarningDisplayOn()

    def test_viewshed_behind_a_wall(self):
        heights = np.zeros((21, 41))
        heights[:, 20] = 30.0
        points = vtkPoints()
        points.InsertNextPoint(5.0, 10.0, 0.0)
        observers = vtkPolyData()
        observers.SetPoints(points)
        viewshed = vtkTerrainViewshed()
        viewshed.SetInputData(0, heights_from_array(heights))
        viewshed.SetInputData(1, observers)
        viewshed.Update()
        seen = array_of(viewshed, "Observers")[:, :, 0]
        self.assertTrue((seen[:, :20] == 1).all())
        self.assertTrue((seen[:, 21:] == 0).all())

    def test_areas_without_samples(self):
        """Between two columns of samples, or where columns cannot be counted any more, nobody stands."""
        heights = heights_from_array(np.zeros((21, 41)))
        for corners in ([(3.2, 0.0), (3.4, 0.0), (3.4, 1e15)], [(1e17, 0.0), (1e17 + 64.0, 0.0), (1e17, 9.0)]):
            points = vtkPoints()
            points.SetDataType(VTK_DOUBLE)
            points.InsertNextPoint(5.0, 10.0, 0.0)
            areas = vtkCellArray()
            areas.InsertNextCell(len(corners))
            for x, y in corners:
                areas.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
            observers = vtkPolyData()
            observers.SetPoints(points)
            observers.SetPolys(areas)
            viewshed = vtkTerrainViewshed()
            viewshed.SetInputData(0, heights)
            viewshed.SetInputData(1, observers)
            viewshed.Update()
            self.assertTrue((array_of(viewshed, "Observers") == 1).all())


def rough(rows, columns):
    return np.random.default_rng(3).uniform(100.0, 160.0, (rows, columns)).astype(np.float32)


def horn(heights, j, i, dx, dy):
    """Rise to the east and the north at an inner sample, written out."""
    z = heights.astype(float)
    east = (z[j + 1, i + 1] + 2 * z[j, i + 1] + z[j - 1, i + 1] - z[j + 1, i - 1] - 2 * z[j, i - 1] - z[j - 1, i - 1])
    north = (z[j + 1, i - 1] + 2 * z[j + 1, i] + z[j + 1, i + 1] - z[j - 1, i - 1] - 2 * z[j - 1, i] - z[j - 1, i + 1])
    return east / (8 * dx), north / (8 * dy)


class TestDerivatives(unittest.TestCase):
    def test_slope_and_aspect_by_their_definition(self):
        for first_row in ("south", "north"):
            heights = rough(7, 9)
            heights[3, 3] = np.nan
            image = heights_from_array(heights, (10.0, 20.0), first_row=first_row)
            from_south = array_from_heights(image)
            slope, aspect = analysis.slope(image), analysis.aspect(image)
            for j in range(7):
                for i in range(9):
                    window = from_south[max(j - 1, 0):j + 2, max(i - 1, 0):i + 2]
                    if window.shape != (3, 3) or np.isnan(window).any():
                        self.assertTrue(math.isnan(slope[j, i]) and math.isnan(aspect[j, i]), (j, i))
                        continue
                    east, north = horn(from_south, j, i, 10.0, 20.0)
                    self.assertAlmostEqual(slope[j, i], math.degrees(math.atan(math.hypot(east, north))), 4)
                    self.assertAlmostEqual(aspect[j, i], math.degrees(math.atan2(-east, -north)) % 360, 3)

    def test_plane_bowl_and_flat(self):
        x, y = np.meshgrid(np.arange(6.0), np.arange(5.0))
        plane = heights_from_array(y, (1.0, 1.0))  # rises to the north: goes down to the south
        np.testing.assert_allclose(analysis.slope(plane)[1:-1, 1:-1], 45.0)
        np.testing.assert_allclose(analysis.aspect(plane)[1:-1, 1:-1], 180.0)
        bowl = heights_from_array(0.5 * (x - 2.0)**2)
        profile, plan = analysis.curvature(bowl)
        self.assertAlmostEqual(profile[2, 4], 1.0, 5)
        self.assertAlmostEqual(plan[2, 4], 0.0, 5)
        flat = heights_from_array(np.zeros((3, 3)))
        self.assertEqual(analysis.slope(flat)[1, 1], 0.0)
        self.assertTrue(np.isnan(analysis.aspect(flat)).all())
        self.assertEqual(analysis.curvature(flat)[0][1, 1], 0.0)
        self.assertEqual(analysis.ruggedness(heights_from_array([[0, 0, 0], [0, 3, 0], [0, 0, 0]]))[1, 1],
                         np.float32(math.sqrt(72.0)))
        for size in ((1, 5), (2, 2), (5, 1)):
            self.assertTrue(np.isnan(analysis.slope(heights_from_array(np.zeros(size)))).all())

    @unittest.skipUnless(shutil.which("gdaldem"), "gdaldem is not installed")
    def test_gdaldem_agrees(self):
        source = vtkTerrainTesting.output_path("derivatives.asc")
        vtkTerrainTesting.write_ascii_grid(source, rough(40, 50))
        for command, values in (("slope", analysis.slope), ("aspect", analysis.aspect)):
            other = vtkTerrainTesting.output_path(f"{command}.asc")
            subprocess.run(["gdaldem", command, "-q", "-of", "AAIGrid", "-co", "FORCE_CELLSIZE=YES", source, other],
                           check=True)
            theirs = array_from_heights(read_heights(other)).astype(float)
            ours = values(read_heights(source))
            has_both = np.isfinite(theirs) & np.isfinite(ours)
            self.assertEqual(has_both.sum(), 38 * 48, command)
            np.testing.assert_allclose(ours[has_both], theirs[has_both], atol=2e-3)

    def test_degrees_get_their_width(self):
        latitudes = 60.0 + np.arange(5) / 1000.0
        source = vtkTerrainTesting.output_path("degrees.asc")
        heights = np.tile(np.arange(6.0), (5, 1)) * 10.0
        with open(source, "w", encoding="ascii") as file:
            file.write(f"ncols 6\nnrows 5\nxllcenter 10\nyllcenter {latitudes[0]}\ncellsize 0.001\n")
            np.savetxt(file, heights[::-1], fmt="%.1f")
        from vtkterrain import vtkTerrainRasterReader

        reader = vtkTerrainRasterReader()
        reader.SetFileName(source)
        reader.SetCoordinateSystem("EPSG:4326")
        reader.Update()
        slope = analysis.slope(reader.GetOutput())
        metres = 0.001 * math.radians(1.0) * 6378137.0 * math.cos(math.radians(latitudes[2]))
        metres /= math.sqrt(1.0 - 0.00669438 * math.sin(math.radians(latitudes[2]))**2)
        self.assertAlmostEqual(slope[2, 2] / math.degrees(math.atan(10.0 / metres)), 1.0, 4)
        with self.assertRaisesRegex(ValueError, "metric CRS"):
            analysis.viewshed(reader.GetOutput(), [(10.002, 60.002)])


@unittest.skipUnless(HAS_XARRAY, "xarray is not installed")
class TestAccessor(unittest.TestCase):
    """Results lie where the array's own coordinates say, however these run."""

    def setUp(self):
        import xarray

        import vtkterrain.xarrays  # noqa: F401

        x, y = 5e5 + 10.0 * np.arange(9), 3e6 + 20.0 * np.arange(7)
        self.plain = xarray.DataArray(rough(7, 9), dims=("y", "x"), coords={"y": y, "x": x}, name="z",
                                      attrs={"crs": "EPSG:32645", "units": "m"})
        self.image = heights_from_array(self.plain.values, (10.0, 20.0), (x[0], y[0]))
        self.observers = [(5e5 + 41.0, 3e6 + 62.0), (5e5 + 11.0, 3e6 + 21.0)]

    def results(self, data):
        terrain = data.terrain
        return {"slope": terrain.slope(), "aspect": terrain.aspect(), "profile": terrain.curvature().profile,
                "plan": terrain.curvature().plan, "ruggedness": terrain.ruggedness(), "sky": terrain.sky_view(4),
                "horizon": terrain.horizon(4), "viewshed": terrain.viewshed(self.observers),
                "hours": terrain.sunlight("2024-06-21", time_step=120).hours}

    def test_the_same_wherever_rows_begin(self):
        import xarray

        expected = self.results(self.plain)
        np.testing.assert_array_equal(expected["slope"], analysis.slope(self.image))
        np.testing.assert_array_equal(expected["horizon"].sel(azimuth=90), analysis.horizon(self.image, 4)[..., 1])
        np.testing.assert_array_equal(expected["viewshed"], analysis.viewshed(self.image, self.observers))
        self.assertEqual(set(np.unique(expected["viewshed"])), {0, 1, 2})
        for other in (self.plain[::-1], self.plain[:, ::-1], self.plain.transpose("x", "y"),
                      self.plain[::-1].transpose("x", "y"), self.plain.expand_dims("band")):
            for name, result in self.results(other).items():
                self.assertEqual(result.dims[-2:], other.squeeze().dims)
                xarray.testing.assert_equal(result.x, other.x)
                turned = result.transpose(*expected[name].dims).sortby(["y", "x"])
                xarray.testing.assert_allclose(turned, expected[name], atol=2e-4)
                self.assertEqual(result.attrs["crs"], "EPSG:32645")

    def test_refusals(self):
        uneven = self.plain.assign_coords(x=5e5 + 3.0 * np.arange(9)**2)
        with self.assertRaisesRegex(ValueError, "resample"):
            uneven.terrain.slope()
        with self.assertRaisesRegex(ValueError, "observers"):
            self.plain.terrain.viewshed([])
        with self.assertRaises(ValueError):
            self.plain.terrain.viewshed([(0.0, 0.0)])
        with self.assertRaisesRegex(ValueError, "CRS"):
            self.plain.drop_attrs().terrain.sunlight("2024-06-21")

    @unittest.skipUnless(importlib.util.find_spec("rioxarray"), "rioxarray is not installed")
    def test_rioxarray(self):
        import rioxarray  # noqa: F401

        data = self.plain.drop_attrs().rio.write_crs("EPSG:32645")[::-1]
        result = data.terrain.slope()
        self.assertEqual(result.rio.crs, data.rio.crs)
        self.assertEqual(result.rio.transform(), data.rio.transform())
        result.rio.to_raster(vtkTerrainTesting.output_path("slope.tif"))
        np.testing.assert_array_equal(result, analysis.slope(self.image)[::-1])

    @unittest.skipUnless(importlib.util.find_spec("odc") and importlib.util.find_spec("odc.geo"),
                         "odc-geo is not installed")
    def test_odc_geo(self):
        from odc.geo.geobox import GeoBox
        from odc.geo.xr import wrap_xr

        for box in (GeoBox.from_bbox((5e5, 3e6, 5e5 + 90, 3e6 + 140), "EPSG:32645", shape=(7, 9)),
                    GeoBox.from_bbox((10.0, 60.0, 10.09, 60.07), "EPSG:4326", shape=(7, 9))):
            data = wrap_xr(rough(7, 9), box)
            result = data.terrain.slope()
            self.assertEqual(result.odc.geobox, box)
            self.assertEqual(result.dims, data.dims)
            self.assertEqual(int(np.isfinite(result).sum()), 5 * 7)

    @unittest.skipUnless(importlib.util.find_spec("geopandas"), "GeoPandas is not installed")
    def test_geopandas_observers(self):
        import geopandas

        x, y = zip(*self.observers)
        frame = geopandas.GeoDataFrame(geometry=geopandas.points_from_xy(x, y), crs="EPSG:32645")
        expected = self.plain.terrain.viewshed(self.observers)
        for other in (frame, frame.to_crs(4326), frame.set_crs(None, allow_override=True)):
            np.testing.assert_array_equal(self.plain.terrain.viewshed(other), expected)


if __name__ == "__main__":
    vtkTerrainTesting.run()
