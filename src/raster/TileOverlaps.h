// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles of a folder that lie in one place with different heights. Private to the module.
 */
#ifndef vtkTerrain_raster_TileOverlaps_h
#define vtkTerrain_raster_TileOverlaps_h

#include "raster/RasterRecord.h"
#include "raster/RasterTile.h"

#include <vector>

namespace terrain
{
/// Warns once where tiles in cells of one size overlap by 2 % of the smaller one's place or more,
/// and differ in height there: names two of them, which one is on top and why, and what to do. Of
/// finer tiles over coarser ones nothing is told, nor of borders (less than a quarter) that differ
/// in less than a tenth of their samples. Compared are some windows of at most 32 pairs:
/// what differs in few samples only may be missed. Tiles that only touch are not opened.
/// `tiles`: in one CRS, in the order in which they are laid on one another, the last on top.
void TellOfOverlaps(const std::vector<RasterTile>& tiles, RasterRecord& record);
}
#endif
