// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/RefinementDetail.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Relative slack of circles for each depth below: keeps them nested when they are rounded.
constexpr double kCircleSlack = 1.0e-9;

/// True if a cell has a surface: its half at the corner that is a vertex of the last depth says so.
bool IsCellDrawn(const HierarchyView& hierarchy, std::int64_t x, std::int64_t y)
{
  // Its half there points from the cell's centre to the vertex: to the south-west or south-east.
  const bool atWest = ((x + y) & 1) != 0;
  const std::int64_t record = hierarchy.RecordOf(atWest ? x : x + 1, y);
  return (hierarchy.Records[record].Drawn() & (atWest ? 4u : 8u)) != 0;
}
}

DetailRadii DetailRadiiOf(double length, int depths, const DetailRelief& relief)
{
  const double circle = length / (1.0 - std::sqrt(0.5)) * (1.0 + kCircleSlack * depths);
  return { circle, relief.Slant * circle + relief.Half + relief.Rounding * depths };
}

BaseSteepness MeasureSteepness(const HierarchyView& hierarchy)
{
  BaseSteepness steepness;
  const glm::dvec2 spacing = hierarchy.Geometry.Spacing;
  for (std::int64_t y = 0; y + 1 < hierarchy.Layout->Height(); ++y)
  {
    double southWest = hierarchy.HeightAt(0, y);
    double northWest = hierarchy.HeightAt(0, y + 1);
    for (std::int64_t x = 0; x + 1 < hierarchy.Layout->Width(); ++x)
    {
      const double southEast = hierarchy.HeightAt(x + 1, y);
      const double northEast = hierarchy.HeightAt(x + 1, y + 1);
      if (IsCellDrawn(hierarchy, x, y))
      {
        const double east =
          std::max(std::abs(southEast - southWest), std::abs(northEast - northWest)) / spacing.x;
        const double north =
          std::max(std::abs(northWest - southWest), std::abs(northEast - southEast)) / spacing.y;
        steepness.Slope = std::max(steepness.Slope, std::hypot(east, north));
        steepness.Twist =
          std::max(steepness.Twist, std::abs(southWest + northEast - southEast - northWest));
      }
      southWest = southEast;
      northWest = northEast;
    }
  }
  return steepness;
}
}
