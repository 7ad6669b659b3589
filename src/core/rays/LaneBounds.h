// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the kernels of lanes (LaneKernels.h) ask the pyramid over their grid.
 */
#ifndef terrain_LaneBounds_h
#define terrain_LaneBounds_h

#include "core/grid/Lanes.h"
#include "core/rays/LaneKernels.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
/// Cells of a LaneGrid: west <= x <= east, south <= y <= north, counted in the grid. They may lie
/// outside, where there is no surface.
struct LaneCells
{
  int West;
  int East;
  int South;
  int North;
};

TERRAIN_LANES_INLINE int LaneNode(int cell, int cells, int level, int size)
{
  cell = cell < 0 ? 0 : cell;
  cell = cell < cells ? cell : cells - 1;
  const int node = cell >> level;
  return node < size ? node : size - 1;
}

/// Highest sample of the surface over the nodes of a level that touch cells; not above any sample
/// if there is no surface. level >= 1; the last one stands for those beyond.
template <typename Real>
TERRAIN_LANES_INLINE Real MaximumOver(const LaneGrid<Real>& grid, const LaneCells& cells, int level)
{
  level = level < grid.LevelCount ? level : grid.LevelCount;
  const auto& table = grid.Levels[level - 1];
  const int west = LaneNode(cells.West + grid.Margin, grid.PyramidWidth, level, table.Width);
  const int east = LaneNode(cells.East + grid.Margin, grid.PyramidWidth, level, table.Width);
  const int south = LaneNode(cells.South + 1, grid.PyramidHeight, level, table.Height);
  const int north = LaneNode(cells.North + 1, grid.PyramidHeight, level, table.Height);
  const PyramidNode<Real>* row = table.Nodes + static_cast<std::int64_t>(table.Width) * south;
  Real maximum = row[west].Maximum;
  for (int y = south; y <= north; ++y, row += table.Width)
  {
    for (int x = west; x <= east; ++x)
    {
      maximum = row[x].Maximum > maximum ? row[x].Maximum : maximum;
    }
  }
  return maximum;
}
} // namespace TERRAIN_LANES_KIND
} // namespace terrain

#endif
