# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless two pictures are the same but for the rounding of two versions of Mesa: compare.py A B"""
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

_LARGEST_MEAN = 0.02  # of 255


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


first, second = (read(path) for path in sys.argv[1:])
difference = np.abs(first - second) if first.shape == second.shape else np.array([255])
print(f"Pixels differ by {difference.mean():.4f} in the mean, {difference.max()} at most")
if difference.mean() > _LARGEST_MEAN:
    sys.exit("The pictures differ")
