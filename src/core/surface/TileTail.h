// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mip tail of tiles: bounds of the levels above the coarsest tile, up to a single node, packed
 * into one square of a tile's size. Without it the widest step of a ray would be a cell of that
 * tile.
 *
 * With tiles of 2^T cells a side, the level `above` levels over the top, 1 <= above <= T, has
 * 2^(T - above) nodes a side, of which those beyond the heightfield are empty. It stands in the
 * square from column TileTailColumn() on, from row 0.
 */
#ifndef terrain_TileTail_h
#define terrain_TileTail_h

#include "core/surface/TileSource.h"

#include <vector>

namespace terrain
{
/// The first column of a level in the square; 0 for above = 0, a tile. Twin: terrainSlotBounds() in
/// shaders/vtkTerrainTiles.glsl.
inline int TileTailColumn(int tileLevel, int above)
{
  const int side = 1 << tileLevel;
  return (side - ((2 * side) >> above)) & (side - 1);
}

/// The square over the coarsest tile, 2^tileLevel x 2^tileLevel nodes, row by row from the south.
std::vector<PyramidNode<float>> MakeTileTail(const Tile& top, int tileLevel);
}

#endif
