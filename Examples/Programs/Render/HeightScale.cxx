// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeightScale.h"

#include "Annotations.h"
#include "FlatShapes.h"
#include "LabelPlacer.h"
#include "MarkColors.h"
#include "Options.h"
#include "TextSize.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace
{
/// In pixels of a picture 720 pixels high.
constexpr double kLineWidth = 1.6;
constexpr double kTickLength = 9.0;
constexpr TextStyle kScaleStyle = { 0.022, false, 0.0, 0.0 };
/// Most numbers, and their least distance in heights of a text.
constexpr double kMostNumbers = 6.0;
constexpr double kLeastDistance = 1.6;

/// The vertical edge that is farthest to the left, its lower end first; empty if none is in view.
std::optional<std::array<std::array<double, 3>, 2>> FindEdge(
  const LabelPlacer& placer, const std::array<double, 6>& bounds)
{
  std::optional<std::array<std::array<double, 3>, 2>> found;
  double left = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = bounds[corner % 2];
    const double y = bounds[2 + corner / 2];
    const std::array<double, 3> low = { x, y, bounds[4] };
    const std::array<double, 3> high = { x, y, bounds[5] };
    const std::optional<Pixel> at = placer.ToPixels(low.data());
    if (at && placer.ToPixels(high.data()) && (!found || (*at)[0] < left))
    {
      left = (*at)[0];
      found = { low, high };
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
bool AddHeightScale(
  vtkRenderer* renderer, LabelPlacer& placer, const ScaledBox& box, const Options& options)
{
  const auto edge = FindEdge(placer, box.Bounds);
  const double range = box.Heights[1] - box.Heights[0];
  if (!edge || !(range > 0.0))
  {
    return false;
  }
  const auto& [low, high] = *edge;
  const auto foot = placer.ToPixels(low.data());
  const auto head = placer.ToPixels(high.data());
  if (!foot || !head)
  {
    return false;
  }
  const Pixel& from = *foot;
  const Pixel& to = *head;
  const double scale = std::max(0.5, PixelScale(options));
  const double text = TextPixels(kScaleStyle.Size, options);
  const double most =
    std::clamp(std::abs(to[1] - from[1]) / (kLeastDistance * text), 1.0, kMostNumbers);
  const double step = RoundUp(range / most);
  FlatShapes lines;
  lines.AddLine(from, to, kLineWidth * scale);
  for (const double height : Multiples(step, box.Heights[0], box.Heights[1]))
  {
    const double t = (height - box.Heights[0]) / range;
    const std::array<double, 3> point = { low[0], low[1], low[2] + t * (high[2] - low[2]) };
    const std::optional<Pixel> at = placer.ToPixels(point.data());
    if (!at)
    {
      continue;
    }
    const Pixel end = { (*at)[0] - kTickLength * scale, (*at)[1] };
    lines.AddLine(*at, end, kLineWidth * scale);
    const std::string number = GroupedNumber(height, step) + " m";
    const double half = 0.5 * placer.SizeOf(number, kScaleStyle)[0];
    placer.PlaceCentred(number, end[0] - half - 4.0 * scale, end[1], kScaleStyle);
  }
  lines.AddTo(renderer, IsDarkBehind(renderer, false) ? kLightMark : kDarkMark);
  return true;
}
