// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels of contour lines.
#include "ViewMarks.h"

#include "Annotations.h"
#include "LabelPlacer.h"
#include "Options.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace
{
/// Between labels of one height, in widths of the picture.
constexpr double kApart = 0.22;
constexpr std::size_t kMostContourLabels = 60;
/// Steps of turn of a text, in degrees, in which places are taken: level ones first.
constexpr double kTurnStep = 20.0;
constexpr TextStyle kContourStyle = { 0.019, false, 0.55, 0.0 };

/// A place in the picture, and how its line runs there.
struct SeenPlace
{
  std::array<double, 2> Pixel;
  std::array<double, 3> Point;
  double Turn;
  double Level;
};
}

//------------------------------------------------------------------------------
void ViewMarks::AddContourLabels(LabelPlacer& placer)
{
  std::vector<SeenPlace> seen;
  for (const ContourPlace& place : this->ContourPlaces)
  {
    const std::array<double, 2>& at = place.Point;
    const double z = this->Sight->GetGround(at[0], at[1]);
    const std::array<double, 3> point = { at[0], at[1], z };
    const std::array<double, 3> next = { at[0] + place.Along[0], at[1] + place.Along[1], z };
    const auto here = placer.ToPixels(point.data());
    const auto there = placer.ToPixels(next.data());
    if (here && there)
    {
      double turn =
        vtkMath::DegreesFromRadians(std::atan2((*there)[1] - (*here)[1], (*there)[0] - (*here)[0]));
      turn = turn > 90.0 ? turn - 180.0 : (turn < -90.0 ? turn + 180.0 : turn);
      seen.push_back({ *here, point, turn, place.Level });
    }
  }
  const auto step = [](const SeenPlace& one) { return std::floor(std::abs(one.Turn) / kTurnStep); };
  std::stable_sort(seen.begin(), seen.end(),
    [&step](const SeenPlace& a, const SeenPlace& b) { return step(a) < step(b); });
  std::map<double, std::vector<std::array<double, 2>>> labelled;
  const std::size_t most = this->Placed.size() + kMostContourLabels;
  for (const SeenPlace& one : seen)
  {
    std::vector<std::array<double, 2>>& others = labelled[one.Level];
    const bool isApart = std::none_of(others.begin(), others.end(),
      [&](const std::array<double, 2>& other)
      {
        return std::hypot(other[0] - one.Pixel[0], other[1] - one.Pixel[1]) <
          kApart * this->Wanted.Size[0];
      });
    TextStyle style = kContourStyle;
    style.Turn = one.Turn;
    const std::string text = GroupedNumber(one.Level, this->Wanted.Surface.Contours);
    if (isApart && this->Placed.size() < most && this->Find(placer, one.Point.data(), 0.0))
    {
      if (const auto box = placer.PlaceCentred(text, one.Pixel[0], one.Pixel[1], style))
      {
        others.push_back(one.Pixel);
        this->Tell(text, *box);
      }
    }
  }
}
