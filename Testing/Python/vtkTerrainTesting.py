# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests in Python share."""
import os
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

_SKIPPED = 77  # exit status of a file of which every test was skipped


def output_path(name):
    """Where a test writes a file of its own."""
    folder = os.environ["VTKTERRAIN_TEST_OUTPUT_DIR"]
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name)


def ramp(rows, columns):
    """Heights that tell their place: 100 * row + column."""
    return 100.0 * np.arange(rows)[:, None] + np.arange(columns)


def read_picture(path):
    """A PNG file as an array of rows, columns and colours."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)


def run():
    """Runs the tests of the calling file."""
    result = unittest.main(argv=sys.argv, exit=False).result
    if result.testsRun == len(result.skipped):
        sys.exit(_SKIPPED)
    sys.exit(not result.wasSuccessful())
