// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/HeightSearch.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Codes that count as a cell: as drawn, but so many that a vertical ray is through all codes
/// within 32 cells, however exaggerated.
double StepRelief(const SearchScene& scene)
{
  return std::max({ scene.CodesPerCell, scene.MaximumCode / 32.0, 1e-30 });
}

/// Most steps of a length that a ray over the grid takes: those over the longest way, and one more
/// for each cell where a step ends.
int LongestSteps(const SearchScene& scene, float length)
{
  const auto width = static_cast<double>(scene.Width);
  const auto height = static_cast<double>(scene.Height);
  const double way = std::hypot(width, height) + scene.MaximumCode / StepRelief(scene);
  const double steps = way / static_cast<double>(length) + width + height + 1.0;
  return static_cast<int>(std::min(steps, static_cast<double>(kMostEquidistantSteps)));
}
}

//------------------------------------------------------------------------------
int SearchParameters::StepLevel() const
{
  return std::max(std::ilogb(this->StepLength), 0);
}

//------------------------------------------------------------------------------
SearchParameters ChooseSearchParameters(const SearchScene& scene, SearchKind kind)
{
  SearchParameters parameters;
  parameters.StepLength = kDefaultStepLength;
  parameters.StepRelief = static_cast<float>(StepRelief(scene));
  parameters.LongSteps = 0;
  parameters.SecantSteps = kPaperSecantSteps;
  switch (kind)
  {
    case SearchKind::Linear:
      parameters.Steps = kDefaultLinearSteps;
      break;
    case SearchKind::Exponential:
      parameters.Steps = kDefaultExponentialSteps;
      break;
    case SearchKind::Equidistant:
      parameters.Steps = LongestSteps(scene, kDefaultStepLength);
      parameters.SecantSteps = kDefaultSecantSteps;
      break;
  }
  return parameters;
}

//------------------------------------------------------------------------------
SearchParameters PaperSearchParameters(const SearchScene& scene, SearchKind kind, int quads)
{
  SearchParameters parameters;
  const auto extent = static_cast<double>(std::max(scene.Width, scene.Height) - 1);
  parameters.Steps = kind == SearchKind::Exponential ? kDefaultExponentialSteps : 5;
  parameters.LongSteps = kind == SearchKind::Equidistant ? 10 : 0;
  parameters.SecantSteps = kPaperSecantSteps;
  parameters.StepLength =
    static_cast<float>(std::max(0.025 * extent * 32.0 / std::max(quads, 1), 1e-3));
  parameters.StepRelief =
    static_cast<float>(std::max(scene.MaximumCode / std::max(extent, 1.0), 1e-30));
  return parameters;
}

//------------------------------------------------------------------------------
SearchParameters BoundSearchParameters(const SearchParameters& parameters, SearchKind kind)
{
  SearchParameters bounded = parameters;
  const int most = kind == SearchKind::Equidistant ? kMostEquidistantSteps : kMostSteps;
  bounded.Steps = std::clamp(parameters.Steps, 0, most);
  bounded.LongSteps = std::clamp(parameters.LongSteps, 0, kMostEquidistantSteps);
  bounded.SecantSteps = std::clamp(parameters.SecantSteps, 0, kMostSecantSteps);
  const float length = parameters.StepLength;
  bounded.StepLength =
    length > kLeastStepLength ? std::min(length, kLargestStepLength) : kLeastStepLength;
  return bounded;
}
}
