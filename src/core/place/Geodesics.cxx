// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/Geodesics.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <GeographicLib/PolygonArea.hpp>

#include <algorithm>
#include <cmath>

namespace terrain
{
GeodesicLeg GeodesicBetween(const glm::dvec3& from, const glm::dvec3& to)
{
  GeodesicLeg leg;
  GeographicLib::Geodesic::WGS84().Inverse(
    from.y, from.x, to.y, to.x, leg.Distance, leg.StartAzimuth, leg.EndAzimuth);
  return leg;
}

std::vector<glm::dvec3> GeodesicPlaces(
  const glm::dvec3& from, const glm::dvec3& to, std::size_t count)
{
  const std::size_t steps = std::max<std::size_t>(count, 2) - 1;
  const GeographicLib::GeodesicLine line =
    GeographicLib::Geodesic::WGS84().InverseLine(from.y, from.x, to.y, to.x);
  std::vector<glm::dvec3> places(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    line.Position(t * line.Distance(), places[i].y, places[i].x);
    places[i].z = (1.0 - t) * from.z + t * to.z;
  }
  places.front() = from;
  places.back() = to;
  return places;
}

GeodesicPolygon GeodesicPolygonOf(const std::vector<glm::dvec3>& corners)
{
  GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
  for (const glm::dvec3& corner : corners)
  {
    polygon.AddPoint(corner.y, corner.x);
  }
  GeodesicPolygon result;
  double area = 0.0;
  polygon.Compute(false, true, result.Perimeter, area);
  result.Area = corners.size() < 3 ? 0.0 : std::abs(area);
  return result;
}

double EarthDrop(double distance)
{
  return distance * distance / (2.0 * kEarthRadius);
}
}
