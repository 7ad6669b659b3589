// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How steep a base is, place by place: what bounds of its sum with detail are made of
 * (RefinementDetail.h).
 */
#ifndef terrain_BaseSteepness_h
#define terrain_BaseSteepness_h

#include "core/grid/ParallelFor.h"
#include "core/strips/Hierarchy.h"

#include <cstdint>
#include <vector>

namespace terrain
{
/// How steep a base is where it is drawn.
struct BaseSteepness
{
  /// Largest slope of a patch, in height units over model units.
  float Slope = 0.0f;
  /// Largest |h00 + h11 - h10 - h01| of a cell, in height units.
  float Twist = 0.0f;
};

/// Maxima over tiles of cells. A tile of level k has 2^(TileShift + k) cells along a side, the last
/// level has one tile; so tiles are nested.
class SteepnessTiles
{
public:
  static constexpr int TileShift = 4;

  struct Level
  {
    std::int64_t Columns = 0;
    std::int64_t Rows = 0;
    /// Tile (i, j) is number i + Columns j.
    std::vector<BaseSteepness> Tiles;
  };

  /// Looks at all cells of a hierarchy; of a mapped file that reads all of it.
  void Measure(const HierarchyView& hierarchy, const ParallelFor& parallelFor);

  int Levels() const
  {
    return static_cast<int>(this->All.size());
  }
  const Level& LevelAt(int level) const
  {
    return this->All[level];
  }
  /// Over all of the base.
  const BaseSteepness& Whole() const
  {
    return this->All.back().Tiles[0];
  }

private:
  std::vector<Level> All;
};
}

#endif
