# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a made-up town as a surface model with a sample a metre: python3 make-town.py town.tif

Houses with flat and gabled roofs, a church, trees, streets and a hill beside, 600 x 600 metres, heights in metres.
Takes GDAL's Python module.
"""
import sys

import numpy as np
from osgeo import gdal, osr

SIZE = 600
BLOCK = 30  # metres from a street to the next


def make_town():
    """Heights of the surface, float32, rows from the north."""
    random = np.random.default_rng(20261130)
    y, x = np.mgrid[:SIZE, :SIZE].astype(float)
    ground = 60.0 * np.exp(-((x - 480.0)**2 + (y - 120.0)**2) / 180.0**2)
    top = np.zeros((SIZE, SIZE))
    for row in range(0, SIZE, BLOCK):
        for column in range(0, SIZE, BLOCK):
            depth, width = random.integers(10, BLOCK - 8, 2)
            wall, gable = random.uniform(6.0, 15.0), random.choice([0.0, 4.0])
            roof = wall + gable * (1.0 - np.abs(np.linspace(-1.0, 1.0, width)))
            top[row + 6:row + 6 + depth, column + 6:column + 6 + width] = roof
            for _ in range(2):
                distance = np.hypot(x - column - random.uniform(0, BLOCK), y - row - random.uniform(0, BLOCK))
                radius = random.uniform(2.0, 4.0)
                crown = random.uniform(5.0, 12.0) * np.sqrt(np.clip(1.0 - (distance / radius)**2, 0.0, None))
                top = np.maximum(top, crown)
    top[290:320, 280:292] = 18.0
    top[292:304, 282:290] = 45.0  # the church's tower
    return (ground + top).astype(np.float32)


def write(path):
    """Writes the town as a GeoTIFF in UTM zone 32."""
    gdal.UseExceptions()
    system = osr.SpatialReference()
    system.ImportFromEPSG(32632)
    file = gdal.GetDriverByName("GTiff").Create(path, SIZE, SIZE, 1, gdal.GDT_Float32, ["COMPRESS=DEFLATE"])
    file.SetProjection(system.ExportToWkt())
    file.SetGeoTransform([500000.0, 1.0, 0.0, 5300600.0, 0.0, -1.0])
    file.GetRasterBand(1).WriteArray(make_town())


if __name__ == "__main__":
    write(sys.argv[1])
