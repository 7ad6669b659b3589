// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles of a folder that GDAL alone does not put where and as they are, and tiles of another CRS
 * than the others'. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterTileAlone_h
#define vtkTerrain_raster_RasterTileAlone_h

#include "raster/HeldFiles.h"
#include "raster/RasterTile.h"

#include <string>
#include <vector>

namespace terrain
{
/// The name of the data that a file is the header of, or lies beside; its own name otherwise.
/// Throws RasterError.
std::string FindDataOf(const std::string& path);

/// Reads a tile as it is read alone, into a file in memory of heights in metres whose rows run from
/// the north. Throws RasterError that names it.
void HoldAsAlone(RasterTile& tile, HeldFiles& held);

/// Puts those tiles that are not in the CRS of the first into it, bilinear, by virtual rasters of
/// GDAL; warns of it in one sentence. Tiles without a CRS beside such that have one are left as
/// they are. Throws RasterError.
void BringIntoOneSystem(std::vector<RasterTile>& tiles, HeldFiles& held, RasterRecord& record);
}
#endif
