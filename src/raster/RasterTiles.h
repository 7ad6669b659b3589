// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A directory of raster tiles as one dataset, through GDAL's C API. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterTiles_h
#define vtkTerrain_raster_RasterTiles_h

#include "raster/GDALTable.h"

namespace terrain
{
/// Opens the rasters that lie in a directory (not in those below) as one virtual raster in memory:
/// files with the extensions of usual elevation tiles, in one CRS, each with as many bands. Where
/// tiles overlap the last one by name counts; where there is none is no data. Tiles of several
/// resolutions take the finest. Throws RasterError. The caller closes the dataset.
GDALDatasetH OpenRasterTiles(const char* directory);
}
#endif
