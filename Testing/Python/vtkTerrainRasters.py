# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Raster files that tests write, and how they are read. Skipped without GDAL."""
import os
import shutil
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkObject

from vtkterrain import array_from_heights, vtkTerrainRasterReader

try:
    from osgeo import gdal, osr

    gdal.UseExceptions()
except ImportError:
    gdal = osr = None

ROWS, COLUMNS = 40, 50


def ground():
    """Row 0 in the north: a slope that rises to the east and the south, a block in the north-west."""
    row, column = np.mgrid[0:ROWS, 0:COLUMNS]
    heights = 100.0 + 2.0 * column + row
    heights[4:8, 4:8] = 400.0
    return heights


@unittest.skipIf(gdal is None, "GDAL's Python module is not installed")
class RasterCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        vtkObject.GlobalWarningDisplayOff()

    def path(self, name):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return path

    def write(self, name, heights, transform=(5e5, 10.0, 0.0, 5e6, 0.0, -10.0), system="EPSG:32631",
              kind=None, unit=None, nodata=None, driver="GTiff"):
        kind = gdal.GDT_Float32 if kind is None else kind
        memory = gdal.GetDriverByName("MEM").Create("", heights.shape[1], heights.shape[0], 1, kind)
        memory.SetGeoTransform(transform)
        if system:
            reference = osr.SpatialReference()
            reference.SetFromUserInput(system)
            memory.SetProjection(reference.ExportToWkt(["FORMAT=WKT2_2019"]))
        memory.GetRasterBand(1).WriteArray(heights)
        if unit:
            memory.GetRasterBand(1).SetUnitType(unit)
        if nodata is not None:
            memory.GetRasterBand(1).SetNoDataValue(nodata)
        gdal.GetDriverByName(driver).CreateCopy(self.path(name), memory)
        return self.path(name)

    def netcdf(self, name, heights, y, x, order=("lat", "lon"), **attributes):
        text = gdal.ExtendedDataType.CreateString()
        number = gdal.ExtendedDataType.Create(gdal.GDT_Float64)
        file = gdal.GetDriverByName("netCDF").CreateMultiDimensional(self.path(name))
        group = file.GetRootGroup()
        places = {"lat": (y, "degrees_north"), "lon": (x, "degrees_east")}
        axes = {}
        for key in order:
            axes[key] = group.CreateDimension(key, None, None, len(places[key][0]))
            array = group.CreateMDArray(key, [axes[key]], number)
            array.CreateAttribute("units", [], text).Write(places[key][1])
            array.Write(np.asarray(places[key][0], dtype=np.float64))
        z = group.CreateMDArray("z", [axes[key] for key in order], number)
        for key, value in attributes.items():
            z.CreateAttribute(key, [], text).Write(value)
        z.Write(np.ascontiguousarray(heights, dtype=np.float64))
        return self.path(name)

    def read(self, path, **options):
        reader = vtkTerrainRasterReader()
        reader.SetFileName(path)
        for name, value in options.items():
            getattr(reader, f"Set{name}")(value)
        reader.Update()
        self.assertEqual(reader.GetErrorMessage(), "")
        image = reader.GetOutput()
        return array_from_heights(image)[::-1].astype(float), image, reader.GetWarningMessage()

    def refusal(self, path, **options):
        reader = vtkTerrainRasterReader()
        reader.SetFileName(path)
        for name, value in options.items():
            getattr(reader, f"Set{name}")(value)
        reader.Update()
        return reader.GetErrorMessage()
