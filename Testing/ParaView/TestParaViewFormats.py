# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The formats of docs/formats.md through ParaView's reader: the heights that their makers wrote. Skipped without GDAL's
Python module."""
import pathlib
import shutil
import sys
import tempfile
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import terrainScene  # noqa: E402
from paraview import servermanager, simple  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

try:
    from osgeo import gdal
    from vtkTerrainFormatList import FORMATS

    gdal.UseExceptions()
    gdal.PushErrorHandler("CPLQuietErrorHandler")
except ImportError:
    print("Skipped: GDAL's Python module is not installed")
    sys.exit(77)

terrainScene.load_plugin()


def heights_of(image):
    columns, rows, _ = image.GetDimensions()
    heights = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns).astype(float)
    ghosts = image.GetPointData().GetArray("vtkGhostType")
    if ghosts:
        heights[vtk_to_numpy(ghosts).reshape(rows, columns) != 0] = np.nan
    return heights[::-1]


class TestFormats(unittest.TestCase):
    def test_heights(self):
        count = 0
        for form in FORMATS:
            if callable(form.heights) or form.needs or not (
                    form.driver.startswith("(none)") or gdal.GetDriverByName(form.driver)):
                continue
            folder = tempfile.mkdtemp()
            with self.subTest(form.title):
                reader = simple.TerrainRasterReader(FileName=[form.write(folder)], **form.options)
                reader.UpdatePipeline()
                np.testing.assert_allclose(heights_of(servermanager.Fetch(reader)), form.heights, atol=form.tolerance)
                simple.Delete(reader)
                count += 1
            shutil.rmtree(folder)
        self.assertGreater(count, 60)


if __name__ == "__main__":
    result = unittest.main(exit=False, argv=[sys.argv[0]]).result
    sys.exit(0 if result.wasSuccessful() else 1)
