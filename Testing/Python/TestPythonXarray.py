# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""DataArrays as heights; skipped without xarray."""
import unittest

import numpy as np
import vtkTerrainTesting

try:
    import xarray

    from vtkterrain import array_from_heights
    from vtkterrain.xarrays import heights_from_dataarray
except ImportError:
    xarray = None


def elevation(x, y, dims=("y", "x"), **attributes):
    """100 * row + column, whatever the coordinates."""
    heights = vtkTerrainTesting.ramp(len(y), len(x)).astype(np.float32)
    return xarray.DataArray(heights, dims=dims, coords={dims[0]: y, dims[1]: x}, attrs=attributes)


@unittest.skipIf(xarray is None, "xarray is not installed")
class TestXarray(unittest.TestCase):
    def test_rows_from_the_north(self):
        data = elevation(5e5 + 30.0 * np.arange(4), 3.1e6 - 20.0 * np.arange(3), crs="EPSG:32645")
        image = heights_from_dataarray(data)
        self.assertEqual(image.GetSpacing(), (30.0, 20.0, 1.0))
        self.assertEqual(image.GetBounds(), (5e5, 5e5 + 90.0, 3.1e6 - 40.0, 3.1e6, 0.0, 0.0))
        np.testing.assert_array_equal(array_from_heights(image), data.values[::-1])
        self.assertEqual(image.GetFieldData().GetAbstractArray("CRS").GetValue(0), "EPSG:32645")

    def test_memory_is_shared(self):
        for y in (np.arange(3.0), np.arange(3.0)[::-1]):
            data = elevation(np.arange(4.0), y)
            self.assertTrue(np.shares_memory(array_from_heights(heights_from_dataarray(data)), data.values))

    def test_order_of_dimensions_and_falling_columns(self):
        data = elevation(np.arange(4.0)[::-1], np.arange(3.0))
        expected = data.values[:, ::-1]
        for other in (data, data.transpose("x", "y"), data.expand_dims("band")):
            np.testing.assert_array_equal(array_from_heights(heights_from_dataarray(other)), expected)

    def test_coordinate_systems_of_rioxarray_and_cf(self):
        data = elevation(5e5 + np.arange(4.0), 3e6 + np.arange(3.0))
        rio = data.assign_coords(spatial_ref=xarray.DataArray(0, attrs={"crs_wkt": "EPSG:32633"}))
        climate = data.assign_coords(utm=xarray.DataArray(0, attrs={"spatial_ref": "EPSG:32633"}))
        climate.encoding["grid_mapping"] = "utm"
        for other in (rio, climate):
            field = heights_from_dataarray(other).GetFieldData().GetAbstractArray("CRS")
            self.assertEqual(field.GetValue(0), "EPSG:32633")
        self.assertIsNone(heights_from_dataarray(data).GetFieldData().GetAbstractArray("CRS"))

    def test_degrees_are_laid_out_in_metres(self):
        data = elevation(10.0 + np.arange(41) / 1000, 47.0 + np.arange(31) / 1000, ("lat", "lon"))
        image = heights_from_dataarray(data)
        bounds = image.GetBounds()
        metres_of_a_degree = 111_200.0
        self.assertAlmostEqual((bounds[3] - bounds[2]) / (0.030 * metres_of_a_degree), 1.0, 1)
        self.assertAlmostEqual((bounds[1] - bounds[0]) / (0.040 * 0.68 * metres_of_a_degree), 1.0, 1)
        middle = image.GetPointData().GetScalars().GetValue(image.FindPoint(0.0, 0.0, 0.0))
        self.assertAlmostEqual(middle, 1520.0, delta=120.0)

    def test_fill_values_are_no_heights(self):
        data = elevation(np.arange(3.0), np.arange(2.0), _FillValue=101.0)
        heights = array_from_heights(heights_from_dataarray(data))
        self.assertTrue(np.isnan(heights[1, 1]))
        self.assertEqual(np.isnan(heights).sum(), 1)

    def test_uneven_coordinates_are_resampled(self):
        heights = array_from_heights(heights_from_dataarray(elevation([0.0, 1.0, 3.0], [0.0, 1.0])))
        np.testing.assert_allclose(heights, [[0.0, 1.0, 1.5, 2.0], [100.0, 101.0, 101.5, 102.0]])

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "neither rise nor fall"):
            heights_from_dataarray(elevation([0.0, 3.0, 1.0], [0.0, 1.0]))
        with self.assertRaisesRegex(ValueError, "at least two"):
            heights_from_dataarray(elevation([0.0], [0.0, 1.0]))
        with self.assertRaisesRegex(ValueError, "no dimension"):
            heights_from_dataarray(xarray.DataArray(np.zeros((2, 2)), dims=("a", "b")))
        with self.assertRaisesRegex(ValueError, "select one"):
            heights_from_dataarray(xarray.DataArray(np.zeros((2, 2, 2)), dims=("band", "y", "x")))
        with self.assertRaises(ValueError):
            heights_from_dataarray(elevation([0.0, 1.0], [0.0, 1.0], crs="no such system"))


if __name__ == "__main__":
    vtkTerrainTesting.run()
