# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons and viewsheds of numpy arrays, against brute force."""
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from vtkterrain import heights_from_array, vtkTerrainHorizon, vtkTerrainViewshed


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


if __name__ == "__main__":
    unittest.main()
