// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/BaseSteepness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
constexpr std::int64_t kSide = std::int64_t(1) << SteepnessTiles::TileShift;

float RoundedUp(double value)
{
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

void Enlarge(BaseSteepness& steepness, const BaseSteepness& other)
{
  steepness.Slope = std::max(steepness.Slope, other.Slope);
  steepness.Twist = std::max(steepness.Twist, other.Twist);
}

/// Of a cell with the given heights.
BaseSteepness SteepnessOf(
  const glm::dvec2& spacing, double southWest, double southEast, double northWest, double northEast)
{
  const double east =
    std::max(std::abs(southEast - southWest), std::abs(northEast - northWest)) / spacing.x;
  const double north =
    std::max(std::abs(northWest - southWest), std::abs(northEast - southEast)) / spacing.y;
  const double slope = std::sqrt(east * east + north * north);
  const double twist = std::abs(southWest + northEast - southEast - northWest);
  return { slope > 0.0 ? RoundedUp(slope) : 0.0f, twist > 0.0 ? RoundedUp(twist) : 0.0f };
}

/// The tiles of one row of level 0.
void MeasureRow(const HierarchyView& hierarchy, std::int64_t row, SteepnessTiles::Level& level)
{
  const std::int64_t width = hierarchy.Layout->Width();
  const std::int64_t last = std::min((row + 1) * kSide, hierarchy.Layout->Height() - 1);
  std::vector<float> south(static_cast<std::size_t>(width));
  std::vector<float> north(south.size());
  const auto read = [&](std::int64_t y, std::vector<float>& heights)
  {
    for (std::int64_t x = 0; x < width; ++x)
    {
      heights[x] = hierarchy.HeightAt(x, y);
    }
  };
  read(row * kSide, north);
  for (std::int64_t y = row * kSide; y < last; ++y)
  {
    south.swap(north);
    read(y + 1, north);
    for (std::int64_t x = 0; x + 1 < width; ++x)
    {
      if (hierarchy.IsCellDrawn(x, y))
      {
        Enlarge(level.Tiles[x / kSide + level.Columns * row],
          SteepnessOf(hierarchy.Geometry.Spacing, south[x], south[x + 1], north[x], north[x + 1]));
      }
    }
  }
}

/// The level of tiles twice as large.
SteepnessTiles::Level Coarser(const SteepnessTiles::Level& fine)
{
  SteepnessTiles::Level coarse;
  coarse.Columns = (fine.Columns + 1) / 2;
  coarse.Rows = (fine.Rows + 1) / 2;
  coarse.Tiles.resize(static_cast<std::size_t>(coarse.Columns * coarse.Rows));
  for (std::int64_t j = 0; j < fine.Rows; ++j)
  {
    for (std::int64_t i = 0; i < fine.Columns; ++i)
    {
      Enlarge(coarse.Tiles[i / 2 + coarse.Columns * (j / 2)], fine.Tiles[i + fine.Columns * j]);
    }
  }
  return coarse;
}
}

void SteepnessTiles::Measure(const HierarchyView& hierarchy, const ParallelFor& parallelFor)
{
  const auto tiles = [](std::int64_t samples)
  { return std::max<std::int64_t>((samples - 1 + kSide - 1) / kSide, 1); };
  Level finest;
  finest.Columns = tiles(hierarchy.Layout->Width());
  finest.Rows = tiles(hierarchy.Layout->Height());
  finest.Tiles.resize(static_cast<std::size_t>(finest.Columns * finest.Rows));
  if (hierarchy.Layout->Width() > 1 && hierarchy.Layout->Height() > 1)
  {
    parallelFor(finest.Rows,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t row = begin; row < end; ++row)
        {
          MeasureRow(hierarchy, row, finest);
        }
      });
  }
  this->All.assign(1, finest);
  while (this->All.back().Tiles.size() > 1)
  {
    this->All.push_back(Coarser(this->All.back()));
  }
}
}
