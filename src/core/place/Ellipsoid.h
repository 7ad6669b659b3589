// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The body that heights stand on: an oblate ellipsoid of revolution, or a sphere. Positions are
 * geocentric, in metres: x through longitude 0, z through the north pole. Angles are radians,
 * latitudes geodetic, heights metres along the ellipsoid's normal.
 */
#ifndef terrain_Ellipsoid_h
#define terrain_Ellipsoid_h

#include "core/grid/Constants.h"

#include <glm/glm.hpp>

#include <cmath>

namespace terrain
{
/// Longitudes that go round, radians.
constexpr double kTurn = 360.0 * kDegree;
/// Greatest flattening of a body.
constexpr double kMostFlattening = 0.1;

struct Ellipsoid
{
  double Equatorial = 6378137.0; ///< semi-axis, metres; WGS84
  double Polar = 6356752.314245179;

  double Flattening() const
  {
    return 1.0 - this->Polar / this->Equatorial;
  }
  /// Squared eccentricity.
  double E2() const
  {
    return this->Flattening() * (2.0 - this->Flattening());
  }
  /// Radius of curvature in the prime vertical, from the sine of the latitude.
  double PrimeVertical(double sine) const
  {
    return this->Equatorial / std::sqrt(1.0 - this->E2() * sine * sine);
  }
  /// Radius of curvature in the meridian.
  double Meridional(double sine) const
  {
    const double w2 = 1.0 - this->E2() * sine * sine;
    return this->Equatorial * (1.0 - this->E2()) / (w2 * std::sqrt(w2));
  }
  /// Least and greatest radius of curvature of all: in the meridian at the equator, and at the
  /// poles.
  double LeastRadius() const
  {
    return this->Meridional(0.0);
  }
  double GreatestRadius() const
  {
    return this->Meridional(1.0);
  }
  /// Distance from the axis and height over the equator's plane of the foot of a latitude.
  glm::dvec2 Foot(double sine, double cosine) const
  {
    const double radius = this->PrimeVertical(sine);
    return { radius * cosine, radius * (1.0 - this->E2()) * sine };
  }
  /// Geocentric position of a longitude, a latitude and a height (x, y, z of a place).
  glm::dvec3 ToPosition(const glm::dvec3& place) const;
  /// Longitude in -pi..pi, latitude and height of a geocentric position. GeographicLib's.
  glm::dvec3 ToPlace(const glm::dvec3& position) const;
};
}

#endif
