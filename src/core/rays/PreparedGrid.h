// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights and their pyramid, ready for lanes.
 */
#ifndef terrain_PreparedGrid_h
#define terrain_PreparedGrid_h

#include "core/grid/PaddedGrid.h"
#include "core/rays/LaneKernels.h"
#include "core/surface/MinMaxPyramid.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace terrain
{
/// Not to be copied: the view refers to the rest.
template <typename Real>
struct PreparedGrid
{
  PaddedGrid<Real> Grid;
  MinMaxPyramid<Real> Pyramid;
  std::vector<typename LaneGrid<Real>::Level> Levels;
  LaneGrid<Real> View;

  PreparedGrid(PaddedGrid<Real> grid, const ParallelFor& parallelFor)
    : Grid(std::move(grid))
  {
    this->Pyramid.Build(this->Grid.WithMargin(), parallelFor);
    for (int level = 1; level <= this->Pyramid.LevelCount(); ++level)
    {
      const glm::ivec2 size = this->Pyramid.LevelSize(level);
      this->Levels.push_back({ this->Pyramid.LevelNodes(level), size.x, size.y });
    }
    this->View = { this->Grid.Width, this->Grid.Height, this->Grid.Stride, this->Grid.At(0, 0),
      static_cast<int>(this->Grid.Margin), this->Pyramid.CellCount().x, this->Pyramid.CellCount().y,
      this->Pyramid.LevelCount(), this->Levels.data() };
  }
  PreparedGrid(const PreparedGrid&) = delete;
  void operator=(const PreparedGrid&) = delete;
};
} // namespace terrain

#endif
