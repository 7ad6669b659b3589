// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A directory of raster tiles as one dataset, through GDAL's C API. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterTiles_h
#define vtkTerrain_raster_RasterTiles_h

#include "raster/RasterRecord.h"

#include <gdal.h>

#include <string>
#include <vector>

namespace terrain
{
/// Paths of files with the extensions of usual elevation tiles in a directory or archive and in
/// those below it, sorted; empty if there are none. Throws RasterError if it cannot be listed.
std::vector<std::string> FindRasters(const std::string& directory);

/// Opens the rasters of a directory as one virtual raster in memory, at the finest of their
/// resolutions. They must have one horizontal CRS and lie near each other; tiles on both sides of
/// 180 degrees are joined. Units, scales, vertical axes and NoData are those of each tile; where
/// they differ the raster is in metres. Where tiles overlap, the finest counts, of equally fine
/// ones the last by name, and nothing is blended. Pictures, masks and derivatives (hillshade,
/// slope) are left out with a warning. Throws RasterError. The caller closes the dataset.
GDALDatasetH OpenRasterTiles(const std::string& directory, RasterRecord& record);
}
#endif
