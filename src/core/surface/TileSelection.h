// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which tiles (TileSource.h) the rays of a view come to.
 *
 * A ray leaves a node for its finer ones unless the node is within the tolerance (IsWithin() in
 * PyramidTraversal.h). So the finer tiles of a tile are needed where a cell of it may exceed the
 * tolerance: where the cells' width, or the greatest range of heights in one of them, is more than
 * the tolerance is at the nearest point of the tile. What lies outside the view is not needed, nor
 * what hides behind mountains, which is not looked at.
 */
#ifndef terrain_TileSelection_h
#define terrain_TileSelection_h

#include "core/surface/TileSource.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace terrain
{
/// A view in grid coordinates: x and y in cells of level 0, z in height codes.
struct TileView
{
  /// What is seen: dot(plane, (x, y, z, 1)) >= 0 for each.
  std::vector<glm::dvec4> Planes;
  glm::dvec3 Eye{ 0.0 };
  /// The distance s of a point along the direction of view is dot(Forward, point - Eye).
  glm::dvec3 Forward{ 0.0 };
  /// Tolerance in cells and in codes, and their change per unit of s.
  glm::dvec4 Tolerance{ 0.0 };
};

/// A tile that is needed; the more its parent exceeds the tolerance, the more urgent.
struct TileWish
{
  TileKey Key;
  double Urgency = 0.0;
};

struct TileSelection
{
  /// Parents come before their children, and else the most urgent first.
  std::vector<TileWish> Tiles;
  /// False if more tiles are needed than may be shown.
  bool Fits = true;
  /// False if tiles are missing that must be read before it is known which finer ones are needed.
  bool IsFinal = true;
};

/// Tile::Relief of a tile, or less than 0 if it has not been read.
using FindRelief = std::function<float(const TileKey&)>;

/// Selects at most `most` tiles, at least the top one. The same tiles for the same view, whatever
/// has been read before, once IsFinal.
TileSelection SelectTiles(
  const TileSource& source, const TileView& view, std::size_t most, const FindRelief& findRelief);
}

#endif
