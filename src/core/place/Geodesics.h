// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Distances and areas on the WGS84 ellipsoid; places as in SceneFrame.h, heights ignored.
 * Source: C. F. F. Karney, Algorithms for geodesics, J. Geodesy 87 (2013), through
 * GeographicLib::Geodesic (error 15 nm) and PolygonArea.
 */
#ifndef terrain_Geodesics_h
#define terrain_Geodesics_h

#include "core/grid/Constants.h"

#include <glm/glm.hpp>

#include <vector>

namespace terrain
{
/// Shortest way between two places along the ellipsoid.
struct GeodesicLeg
{
  /// Length in metres; NaN if a place is not on earth.
  double Distance = 0.0;
  /// Directions at both ends, degrees clockwise from north, in (-180, 180].
  double StartAzimuth = 0.0;
  double EndAzimuth = 0.0;
};

GeodesicLeg GeodesicBetween(const glm::dvec3& from, const glm::dvec3& to);

/// count >= 2 places at equal distances along the geodesic, both ends included; their heights vary
/// linearly between those of the ends.
std::vector<glm::dvec3> GeodesicPlaces(
  const glm::dvec3& from, const glm::dvec3& to, std::size_t count);

/// A closed polygon on the ellipsoid, its edges geodesics.
struct GeodesicPolygon
{
  /// Square metres, >= 0 whatever the sense of rotation; the side that is smaller.
  double Area = 0.0;
  /// Metres.
  double Perimeter = 0.0;
};

/// Fewer than three corners have no area.
GeodesicPolygon GeodesicPolygonOf(const std::vector<glm::dvec3>& corners);

/// Metres by which the earth falls below the tangent plane at a distance (metres) along it,
/// d^2 / (2 R).
double EarthDrop(double distance);
}

#endif
