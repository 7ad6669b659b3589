// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainScenes.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainPieces.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace
{
/// Corners and middle.
constexpr std::size_t kPoints = 5;
using Points = std::array<double, 3 * kPoints>;

std::string GetText(vtkImageData* heights, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(heights->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

/// A number of the layout (vtkTerrainRasterReader) for an axis.
double GetLayout(vtkImageData* heights, const char* name, int axis, double otherwise)
{
  vtkDataArray* array = heights->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 2 && array->GetNumberOfTuples() > 0
    ? array->GetComponent(0, axis)
    : otherwise;
}

/// Points of the scene as those of the file's coordinate system, or back.
void LayOut(vtkImageData* heights, bool isBack, Points& points)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const int axis = static_cast<int>(k % 3);
    const double origin = axis < 2 ? GetLayout(heights, "LayoutOrigin", axis, 0.0) : 0.0;
    const double scale = axis < 2 ? GetLayout(heights, "LayoutScale", axis, 1.0) : 1.0;
    points[k] = isBack ? (points[k] - origin) * scale : origin + points[k] / scale;
  }
}

Points PointsOf(vtkImageData* heights)
{
  const double* b = heights->GetBounds();
  return { b[0], b[2], 0.0, b[1], b[2], 0.0, b[0], b[3], 0.0, b[1], b[3], 0.0, 0.5 * (b[0] + b[1]),
    0.5 * (b[2] + b[3]), 0.0 };
}

/// Brings points of one coordinate system into another; false if that is not known.
bool Transform(vtkImageData* from, vtkImageData* to, Points& points)
{
  const std::string systems[2] = { GetText(from, "CRS"), GetText(to, "CRS") };
  if (systems[0] == systems[1])
  {
    return !systems[0].empty();
  }
  const vtkNew<vtkTerrainGeoreference> places[2];
  for (std::size_t k = 0; k < 2; ++k)
  {
    places[k]->SetCoordinateSystem(systems[k]);
    places[k]->SetFrame(vtkTerrainGeoreference::FrameType::Geocentric);
    if (!places[k]->IsOnEarth() || !places[k]->GetWhyNot().empty())
    {
      return false;
    }
  }
  return places[0]->FileToPlaces(points.data(), points.data(), vtkIdType{ kPoints }) &&
    places[1]->PlacesToFile(points.data(), points.data(), vtkIdType{ kPoints });
}

/// How far a point lies from its place at most; infinite where one has none, 0 if it is not known.
double DistanceApart(vtkImageData* first, vtkImageData* other)
{
  const Points drawn = PointsOf(other);
  Points meant = drawn;
  LayOut(other, false, meant);
  if (!Transform(other, first, meant))
  {
    return 0.0;
  }
  LayOut(first, true, meant);
  double largest = 0.0;
  for (std::size_t k = 0; k < meant.size(); k += 3)
  {
    const double distance = std::hypot(meant[k] - drawn[k], meant[k + 1] - drawn[k + 1]);
    largest = std::isfinite(distance) ? std::max(largest, distance) : HUGE_VAL;
  }
  return largest;
}

std::string DistanceText(double metres)
{
  if (!std::isfinite(metres))
  {
    return "far";
  }
  constexpr double kKilometre = 1000.0;
  constexpr double kManyKilometres = 1e5;
  char text[40];
  std::snprintf(text, sizeof(text), metres < kManyKilometres ? "%.3g %s" : "%.0f %s",
    metres < kKilometre ? metres : metres / kKilometre, metres < kKilometre ? "m" : "km");
  return text;
}

std::string NameOf(vtkImageData* heights, const char* otherwise)
{
  const std::string name = GetText(heights, "FileName");
  return name.empty() ? otherwise : "'" + name + "'";
}
}

namespace vtkTerrainScenes
{
//------------------------------------------------------------------------------
std::string WhyApart(vtkImageData* first, vtkImageData* other)
{
  const std::string names[2] = { NameOf(first, "the first terrain"), NameOf(other, "a terrain") };
  const bool isOnGlobe = vtkTerrainPieces::IsOnGlobe(first);
  if (isOnGlobe != vtkTerrainPieces::IsOnGlobe(other))
  {
    return names[isOnGlobe ? 1 : 0] + " is flat and " + names[isOnGlobe ? 0 : 1] +
      " on a globe: they do not lie in one scene (a filter Terrain Globe for each does that)";
  }
  const double* spacings[2] = { first->GetSpacing(), other->GetSpacing() };
  const double distance = isOnGlobe ? 0.0 : DistanceApart(first, other);
  if (distance <= std::max({ spacings[0][0], spacings[0][1], spacings[1][0], spacings[1][1] }))
  {
    return {};
  }
  return names[1] + " is drawn " + DistanceText(distance) + " from its place beside " + names[0] +
    ": each has a scene of its own (one filter Terrain Reproject with both as its Input puts them "
    "into one)";
}
}
