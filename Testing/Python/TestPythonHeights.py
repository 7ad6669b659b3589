# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""numpy arrays as heights, and heights as numpy arrays."""
import gc
import tracemalloc
import unittest
import weakref

import numpy as np
import vtkTerrainTesting
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData

from vtkterrain import array_from_heights, heights_from_array, vtkTerrainCoarseMesh, vtkTerrainSource


def resident(key):
    """Bytes of memory that the process holds (VmRSS) or has held at most (VmHWM)."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith(key + ":"))


def forget_peak():
    """Lets the peak of memory begin anew, at what is held now."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")


class TestHeights(unittest.TestCase):
    def test_memory_is_shared_where_vtk_has_the_type(self):
        for kind in "bBhHiIqQfd":
            array = vtkTerrainTesting.ramp(1, 5).astype(kind)
            image = heights_from_array(array)
            self.assertTrue(np.shares_memory(array, array_from_heights(image)), kind)
            array[0, 3] = 77
            self.assertEqual(image.GetScalarComponentAsDouble(3, 0, 0, 0), 77.0, kind)

    def test_nothing_is_copied_from_either_side(self):
        # 32 to 64 MiB, so that a copy of the samples cannot hide, neither of numpy's nor of C++'s.
        for kind in ("float32", "uint16", "int16"):
            for first_row in ("south", "north"):
                array = (vtkTerrainTesting.ramp(1, 4096) + np.zeros((4096, 1))).astype(kind)
                array[17] = 3
                heights_from_array(array[:2], first_row=first_row)  # what is loaded once
                forget_peak()  # that of the array's own making is higher than that of a copy
                before = resident("VmRSS")
                tracemalloc.start()
                image = heights_from_array(array, (30.0, 20.0), (5.0, 7.0), first_row=first_row)
                traced = tracemalloc.get_traced_memory()[1]
                tracemalloc.stop()
                more = resident("VmHWM") - before
                scalars = image.GetPointData().GetScalars()
                self.assertEqual(vtk_to_numpy(scalars).ctypes.data, array.ctypes.data, (kind, first_row))
                self.assertLess(traced, 0.05 * array.nbytes, (kind, first_row))
                self.assertLess(more, 0.25 * array.nbytes, (kind, first_row))
                row = 17 if first_row == "south" else 4096 - 18
                self.assertEqual(array_from_heights(image)[row, 5], 3)
                self.assertEqual(image.GetPoint(17 * 4096), (5.0, 7.0 + 20.0 * row, 0.0))

    def test_views_and_files_in_memory_are_shared(self):
        array = vtkTerrainTesting.ramp(1, 30).repeat(20, axis=0).astype(np.float32)
        path = vtkTerrainTesting.output_path("mapped.npy")
        np.save(path, array)
        for samples in (array[::-1], np.load(path, mmap_mode="r"), np.load(path, mmap_mode="r")[::-1]):
            self.assertTrue(np.shares_memory(samples, array_from_heights(heights_from_array(samples))))

    def test_image_keeps_the_array_alive(self):
        array = np.arange(200_000, dtype=np.float32).reshape(400, 500)
        alive = weakref.ref(array)
        image = heights_from_array(array)
        del array
        gc.collect()
        self.assertEqual(image.GetScalarComponentAsDouble(499, 399, 0, 0), 199_999.0)
        del image
        gc.collect()
        self.assertIsNone(alive())

    def test_place(self):
        image = heights_from_array(vtkTerrainTesting.ramp(3, 4), (10.0, 20.0), (5e5, 3e6), name="z",
                                   coordinate_system="EPSG:32645")
        self.assertEqual(image.GetDimensions(), (4, 3, 1))
        self.assertEqual(image.GetSpacing(), (10.0, 20.0, 1.0))
        self.assertEqual(image.GetOrigin(), (5e5, 3e6, 0.0))
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "z")
        self.assertEqual(image.GetFieldData().GetAbstractArray("CRS").GetValue(0), "EPSG:32645")
        self.assertEqual(image.GetScalarComponentAsDouble(2, 1, 0, 0), 102.0)
        self.assertEqual(heights_from_array([[1.0]], origin=(1, 2, 3)).GetOrigin(), (1.0, 2.0, 3.0))

    def test_first_row_in_the_north(self):
        array = vtkTerrainTesting.ramp(3, 4)
        image = heights_from_array(array, (1.0, 10.0), (5.0, 6.0), first_row="north")
        self.assertEqual(image.GetScalarComponentAsDouble(2, 0, 0, 0), 2.0)
        self.assertEqual(image.GetPoint(2), (7.0, 26.0, 0.0))
        self.assertEqual(image.GetBounds(), (5.0, 8.0, 6.0, 26.0, 0.0, 0.0))
        np.testing.assert_array_equal(array_from_heights(image), array[::-1])

    def test_other_layouts_and_types_are_copied(self):
        array = vtkTerrainTesting.ramp(5, 6)
        samples = (array.T, array[::2, 1::2], np.asfortranarray(array), array.astype(np.float16),
                   array.astype(">f4"), array.astype(">i2"), array > 100, array.tolist(),
                   array.astype(np.longdouble))
        for other in samples:
            image = heights_from_array(other)
            np.testing.assert_array_equal(array_from_heights(image), np.asarray(other))

    def test_masked_samples_have_no_height(self):
        for kind in ("int16", "int32", "float32", "float64"):
            array = np.ma.masked_equal(vtkTerrainTesting.ramp(3, 3).astype(kind), 101)
            heights = array_from_heights(heights_from_array(array))
            self.assertTrue(np.isnan(heights[1, 1]), kind)
            self.assertEqual(np.isnan(heights).sum(), 1, kind)
            self.assertEqual(heights[2, 2], 202, kind)
        self.assertEqual(array_from_heights(heights_from_array(
            np.ma.masked_array([[1, 2]], False))).dtype.kind, "i")

    def test_hidden_points_have_no_height(self):
        image = heights_from_array(vtkTerrainTesting.ramp(3, 3).astype(np.int16))
        image.AllocatePointGhostArray()
        image.GetPointGhostArray().SetValue(4, vtkDataSetAttributes.HIDDENPOINT)
        heights = array_from_heights(image)
        self.assertTrue(np.isnan(heights[1, 1]))
        self.assertEqual(heights[2, 1], 201.0)

    def test_refusals(self):
        for wrong in (np.zeros(3), np.zeros((2, 2, 2)), np.zeros((0, 3)), 5.0):
            self.assertRaises(ValueError, heights_from_array, wrong)
        for wrong in ([[1j]], [["a"]], np.zeros((2, 2), "M8[s]")):
            self.assertRaises(TypeError, heights_from_array, wrong)
        good = [[1.0, 2.0]]
        self.assertRaises(ValueError, heights_from_array, good, (1.0, 0.0))
        self.assertRaises(ValueError, heights_from_array, good, (np.nan, 1.0))
        self.assertRaises(ValueError, heights_from_array, good, (1.0, 1.0, 1.0))
        self.assertRaises(ValueError, heights_from_array, good, origin=(0.0, np.inf))
        self.assertRaises(ValueError, heights_from_array, good, first_row="top")
        self.assertRaises(ValueError, array_from_heights, vtkImageData())

    def test_filters_take_them(self):
        mesh = vtkTerrainCoarseMesh()
        mesh.SetInputData(heights_from_array(vtkTerrainTesting.ramp(40, 50).astype(np.float32)))
        mesh.Update()
        self.assertEqual(mesh.GetHeightRange(), (0.0, 3949.0))
        source = vtkTerrainSource()
        source.SetDimensions(17, 9)
        source.Update()
        self.assertEqual(array_from_heights(source.GetOutput()).shape, (9, 17))


if __name__ == "__main__":
    vtkTerrainTesting.run()
