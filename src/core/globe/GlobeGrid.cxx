// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/globe/GlobeGrid.h"

#include "core/grid/Constants.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Parts of a cell by which longitudes of files are rounded.
constexpr double kRounding = 1e-3;

/// Least and greatest cosine of the angles from first to last, first <= last.
glm::dvec2 Cosines(double first, double last)
{
  const double begin = first - kTurn * std::floor(first / kTurn);
  const double end = begin + (last - first);
  const auto holds = [&](double angle) { return begin <= angle && angle <= end; };
  const double a = std::cos(begin);
  const double b = std::cos(end);
  const double half = 0.5 * kTurn;
  return { holds(half) || holds(half + kTurn) ? -1.0 : std::min(a, b),
    holds(0.0) || holds(kTurn) ? 1.0 : std::max(a, b) };
}
}

bool GlobeGrid::IsJoined() const
{
  return std::abs((this->Columns - 1) * this->Step - kTurn) < kRounding * this->Step;
}

std::string GlobeGrid::WhyNot() const
{
  if (!(this->Body.Equatorial > 0.0) || !std::isfinite(this->Body.Equatorial) ||
    !(this->Body.Flattening() >= 0.0) || !(this->Body.Flattening() <= kMostFlattening))
  {
    return "a globe is a sphere, or an ellipsoid with a flattening of 0 to 0.1: name a rounder one "
           "(--crs '+proj=longlat +R=METRES')";
  }
  if (this->Columns < 2 || this->Latitudes.size() < 2)
  {
    return "a globe needs at least two meridians and two parallels of heights: draw a single one "
           "as a profile";
  }
  if (!(this->Step > 0.0) || !std::isfinite(this->West) ||
    !((this->Columns - 1) * this->Step < kTurn + kRounding * this->Step))
  {
    return "the longitudes of a globe's heights go round more than once: cut the raster to 360 "
           "degrees (gdal_translate -projwin)";
  }
  for (std::size_t row = 0; row < this->Latitudes.size(); ++row)
  {
    if (!(std::abs(this->Latitudes[row]) <= 90.0 * kDegree) ||
      (row > 0 && !(this->Latitudes[row] > this->Latitudes[row - 1])))
    {
      return "the latitudes of a globe's heights must rise within -90 to 90 degrees: cut the "
             "raster to them (gdal_translate -projwin)";
    }
  }
  return {};
}

double GlobeGrid::RowOf(double latitude) const
{
  const auto next =
    std::upper_bound(this->Latitudes.begin() + 1, this->Latitudes.end() - 1, latitude);
  const double south = *(next - 1);
  return static_cast<double>(next - this->Latitudes.begin()) - 1.0 +
    (latitude - south) / (*next - south);
}

double GlobeGrid::LatitudeOf(double row) const
{
  const double last = static_cast<double>(this->Latitudes.size()) - 2.0;
  const auto first = static_cast<std::size_t>(std::clamp(std::floor(row), 0.0, last));
  const double south = this->Latitudes[first];
  return south + (row - static_cast<double>(first)) * (this->Latitudes[first + 1] - south);
}

// The distance from the axis falls with the distance of the latitude from the equator and rises
// with the height; the distance from the equator's plane rises with the latitude.
std::array<glm::dvec3, 2> GlobeGrid::BoxOf(const GlobeRange& range) const
{
  const double south = this->Latitudes.front();
  const double north = this->Latitudes.back();
  const auto at = [this](double latitude, double height)
  {
    const double sine = std::sin(latitude);
    const double cosine = std::cos(latitude);
    return this->Body.Foot(sine, cosine) + height * glm::dvec2(cosine, sine);
  };
  const double nearest = std::clamp(0.0, south, north);
  const double farthest = std::max(std::abs(south), std::abs(north));
  const double out = at(nearest, range.Highest).x;
  const double in = at(farthest, range.Lowest).x;
  const double east = this->West + this->Cells().x * this->Step;
  const glm::dvec2 x = Cosines(this->West, east);
  const glm::dvec2 y = Cosines(this->West - 0.25 * kTurn, east - 0.25 * kTurn);
  const auto least = [&](double cosine) { return std::min(cosine * in, cosine * out); };
  const auto greatest = [&](double cosine) { return std::max(cosine * in, cosine * out); };
  return { glm::dvec3(least(x[0]), least(y[0]),
             std::min(at(south, range.Lowest).y, at(south, range.Highest).y)),
    glm::dvec3(greatest(x[1]), greatest(y[1]),
      std::max(at(north, range.Lowest).y, at(north, range.Highest).y)) };
}
}
