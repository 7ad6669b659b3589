# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests in Python share."""
import os
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

_SKIPPED = 77  # exit status of a file of which every test was skipped
_VISIBLE = 8  # of 255: what two pixels of the same colour differ by at most


def output_path(name):
    """Where a test writes a file of its own."""
    folder = os.environ["VTKTERRAIN_TEST_OUTPUT_DIR"]
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name)


def ramp(rows, columns):
    """Heights that tell their place: 100 * row + column."""
    return 100.0 * np.arange(rows)[:, None] + np.arange(columns)


def hill(rows=41, columns=51):
    """Heights of a hill on a slope, float32."""
    y, x = np.mgrid[0:1:rows * 1j, 0:1:columns * 1j]
    return (8.0 * np.exp(-8.0 * ((x - 0.5)**2 + (y - 0.4)**2)) + x + 1.0).astype(np.float32)


def look(plotter):
    """The picture of a plotter from the south-west, above."""
    plotter.view_vector((0.2, -0.8, 0.6), viewup=(0.0, 0.0, 1.0))
    return plotter.screenshot(return_img=True).astype(int)


def read_picture(path):
    """A PNG file as an array of rows, from the bottom, columns and colours."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)


def write_ascii_grid(path, heights, west=0):
    """Heights, rows from the south, as an ESRI ASCII grid of spacing 1, at (west, 0)."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ncols {heights.shape[1]}\nnrows {heights.shape[0]}\n"
                   f"xllcenter {west}\nyllcenter 0\ncellsize 1\n")
        np.savetxt(file, heights[::-1], fmt="%.6f")


def write_picture(path, picture):
    """An array of rows, from the top, columns and colours as a PNG file."""
    rows, columns, colors = picture.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.ascontiguousarray(picture[::-1]).reshape(-1, colors), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


def compare_with_baseline(test, picture, name, largest_share=1e-3):
    """Fails if more than a share of the pixels differ from the baseline visibly."""
    drawn = output_path(f"{name}.png")
    write_picture(drawn, picture)
    baseline = read_picture(os.path.join(os.environ["VTKTERRAIN_BASELINE_DIR"], f"{name}.png"))[::-1]
    test.assertEqual(picture.shape, baseline.shape)
    share = (np.abs(picture.astype(int) - baseline) > _VISIBLE).any(axis=2).mean()
    test.assertLessEqual(share, largest_share, drawn)


class _Result(unittest.TextTestResult):
    """Counts the tests that were not skipped: testsRun counts skipped ones before Python 3.12.1, and not since."""

    passed = 0

    def addSuccess(self, test):
        super().addSuccess(test)
        self.passed += 1


class _Runner(unittest.TextTestRunner):
    resultclass = _Result


def run():
    """Runs the tests of the calling file, and says what was skipped and why."""
    result = unittest.main(argv=sys.argv, testRunner=_Runner, exit=False).result
    for test, reason in result.skipped:
        print(f"Skipped: {test.id().rpartition('.')[2]}: {reason}")
    if result.skipped and result.wasSuccessful() and not result.passed:
        sys.exit(_SKIPPED)
    sys.exit(not result.wasSuccessful())
