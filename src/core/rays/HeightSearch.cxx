// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/HeightSearch.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Codes that count as a cell: as drawn, but so many that a vertical ray is through the gap between
/// mesh and surface within eight cells.
double StepRelief(const SearchScene& scene)
{
  return std::max({ scene.CodesPerCell, scene.LargestGap / 8.0, 1e-30 });
}

/// Longest way of a ray over the grid, in cells.
double LongestWay(const SearchScene& scene)
{
  return std::hypot(static_cast<double>(scene.Width), static_cast<double>(scene.Height)) +
    scene.MaximumCode / StepRelief(scene);
}

float GapWithMargin(const SearchScene& scene)
{
  return static_cast<float>(1.001 * scene.LargestGap + 1e-5 * scene.MaximumCode);
}

int ToSteps(double count)
{
  return static_cast<int>(std::clamp(std::ceil(count), 1.0, 1e6));
}
}

//------------------------------------------------------------------------------
SearchParameters ChooseSearchParameters(const SearchScene& scene, SearchKind kind)
{
  SearchParameters parameters;
  parameters.SecantSteps = kDefaultSecantSteps;
  parameters.StepLength = kDefaultStepLength;
  parameters.StepRelief = static_cast<float>(StepRelief(scene));
  parameters.LargestGap = GapWithMargin(scene);
  parameters.LongSteps = 0;
  const double steps = LongestWay(scene) / static_cast<double>(kDefaultStepLength);
  switch (kind)
  {
    case SearchKind::Linear:
      parameters.Steps = std::min(ToSteps(steps), kDefaultLinearSteps);
      break;
    case SearchKind::Exponential:
      parameters.Steps = kDefaultExponentialSteps;
      break;
    case SearchKind::Equidistant:
      // Short steps through several quads, where nearly all hits are; long ones for the rest.
      parameters.Steps = ToSteps(std::min(steps,
        16.0 * static_cast<double>(scene.CellsPerQuad) / static_cast<double>(kDefaultStepLength)));
      parameters.LongSteps = ToSteps(0.5 * (steps - parameters.Steps)) + 1;
      break;
  }
  return parameters;
}

//------------------------------------------------------------------------------
SearchParameters PaperSearchParameters(const SearchScene& scene, SearchKind kind)
{
  SearchParameters parameters;
  const double extent = static_cast<double>(std::max(scene.Width, scene.Height) - 1);
  const double quads = extent / static_cast<double>(std::max<std::int64_t>(scene.CellsPerQuad, 1));
  parameters.Steps = kind == SearchKind::Exponential ? 10 : 5;
  parameters.LongSteps = kind == SearchKind::Equidistant ? 10 : 0;
  parameters.SecantSteps = 2;
  parameters.StepLength =
    static_cast<float>(std::max(0.025 * extent * 32.0 / std::max(quads, 1.0), 1e-3));
  parameters.StepRelief =
    static_cast<float>(std::max(scene.MaximumCode / std::max(extent, 1.0), 1e-30));
  parameters.LargestGap = GapWithMargin(scene);
  return parameters;
}
}
