// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A directory of raster tiles as one dataset, through GDAL's C API. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterTiles_h
#define vtkTerrain_raster_RasterTiles_h

#include "raster/HeldFiles.h"
#include "raster/RasterRecord.h"

#include <gdal.h>

#include <string>

namespace terrain
{
/// Opens the rasters of a directory as one virtual raster in memory, at the finest of their
/// resolutions. Tiles of another horizontal CRS than the first's are resampled into it, with a
/// warning; tiles on both sides of 180 degrees are joined.
/// Units, scales, vertical axes and NoData are those of each tile; where they differ the raster is
/// in metres. Where tiles overlap, the finest counts, of equally fine ones the last by name, and
/// nothing is blended. Pictures, masks and derivatives (hillshade, slope) are left out with a
/// warning. Of tiles at sites far from each other those of one are opened: of the one that covers
/// most, with a warning, or of the one with the number `site`, from 1 on. Throws RasterError. The
/// caller closes the dataset. A FolderOpener (RasterOpen.h).
GDALDatasetH OpenRasterTiles(
  const std::string& directory, const std::string& site, RasterRecord& record, HeldFiles& held);
}
#endif
