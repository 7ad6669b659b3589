// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// B. R. Bowring, Transformation from spatial to geographical coordinates, Survey Review 23 (1976).
// C. F. F. Karney, Transverse Mercator with an accuracy of a few nanometers, J. Geodesy 85 (2011),
// through GeographicLib.
#include "core/place/SceneFrame.h"

#include "core/grid/Constants.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>

#include <cmath>
#include <limits>

namespace
{
using terrain::kDegree;

// WGS84: semi-axes in metres, squared eccentricities.
constexpr double kA = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kB = kA * (1.0 - kFlattening);
constexpr double kE2 = kFlattening * (2.0 - kFlattening);
constexpr double kSecondE2 = kE2 / (1.0 - kE2);
// Distances from the earth's centre between which Bowring's steps are used, in metres.
constexpr double kBowringNear = 4.3e6;
constexpr double kBowringFar = 9.6e7;
// False easting and northing of UTM and UPS, in metres.
constexpr double kUtmEasting = 500000.0;
constexpr double kUtmNorthingSouth = 10000000.0;
constexpr double kUpsEasting = 2000000.0;

const glm::dvec3 kNowhere(std::numeric_limits<double>::quiet_NaN());

double WrapLongitude(double longitude)
{
  return longitude >= -180.0 && longitude <= 180.0 ? longitude : std::remainder(longitude, 360.0);
}

/// Radius of curvature of the prime vertical, in metres.
double PrimeVertical(double sinLatitude)
{
  return kA / std::sqrt(1.0 - kE2 * sinLatitude * sinLatitude);
}

bool IsPlace(const glm::dvec3& place)
{
  return std::abs(place.y) <= 90.0 && std::isfinite(place.x) && std::isfinite(place.z);
}

double CentralMeridian(int zone)
{
  return 6.0 * zone - 183.0;
}

/// Rows of the rotation from meridian axes to (east, north, up).
glm::dvec3 ToEastNorthUp(const glm::dvec3& v, double sinLatitude, double cosLatitude)
{
  return { v.y, cosLatitude * v.z - sinLatitude * v.x, cosLatitude * v.x + sinLatitude * v.z };
}

glm::dvec3 FromEastNorthUp(const glm::dvec3& v, double sinLatitude, double cosLatitude)
{
  return { cosLatitude * v.z - sinLatitude * v.y, v.x, sinLatitude * v.z + cosLatitude * v.y };
}
}

namespace terrain
{
glm::dvec3 PlaceToGeocentric(const glm::dvec3& place, double longitudeOfX)
{
  if (!IsPlace(place))
  {
    return kNowhere;
  }
  const double longitude = WrapLongitude(place.x - longitudeOfX) * kDegree;
  const double sinLatitude = std::sin(place.y * kDegree);
  // Exactly on the axis at the poles, whatever the rounding of pi.
  const double cosLatitude = std::abs(place.y) == 90.0 ? 0.0 : std::cos(place.y * kDegree);
  const double n = PrimeVertical(sinLatitude);
  const double r = (n + place.z) * cosLatitude;
  return { r * std::cos(longitude), r * std::sin(longitude),
    (n * (1.0 - kE2) + place.z) * sinLatitude };
}

glm::dvec3 GeocentricToPlace(const glm::dvec3& position, double longitudeOfX)
{
  const double p = std::sqrt(position.x * position.x + position.y * position.y);
  const double r = std::sqrt(p * p + position.z * position.z);
  if (!(r >= kBowringNear && r <= kBowringFar))
  {
    if (!std::isfinite(r))
    {
      return kNowhere;
    }
    glm::dvec3 place;
    GeographicLib::Geocentric::WGS84().Reverse(
      position.x, position.y, position.z, place.y, place.x, place.z);
    place.x = WrapLongitude(place.x + longitudeOfX);
    return place;
  }
  // Reduced latitude (sine, cosine), exact on the ellipsoid to begin with.
  double up = kA * position.z;
  double out = kB * p;
  double sinLatitude = 0.0;
  double cosLatitude = 1.0;
  for (int step = 0; step < 2; ++step)
  {
    const double length = 1.0 / std::sqrt(up * up + out * out);
    const double s = up * length;
    const double c = out * length;
    sinLatitude = position.z + kSecondE2 * kB * s * s * s;
    cosLatitude = p - kE2 * kA * c * c * c;
    up = kB * sinLatitude;
    out = kA * cosLatitude;
  }
  const double latitude = std::atan2(sinLatitude, cosLatitude);
  const double length = 1.0 / std::sqrt(sinLatitude * sinLatitude + cosLatitude * cosLatitude);
  sinLatitude *= length;
  cosLatitude *= length;
  const double height = p * cosLatitude + position.z * sinLatitude -
    kA * std::sqrt(1.0 - kE2 * sinLatitude * sinLatitude);
  return { WrapLongitude(std::atan2(position.y, position.x) / kDegree + longitudeOfX),
    latitude / kDegree, height };
}

SceneFrame SceneFrame::AtOrigin(SceneKind kind, const glm::dvec3& origin, double exaggeration)
{
  SceneFrame frame;
  frame.TheKind = kind == SceneKind::Plane ? SceneKind::Plane : SceneKind::Local;
  frame.TheOrigin = origin;
  frame.SinLatitude = std::sin(origin.y * kDegree);
  frame.CosLatitude = std::abs(origin.y) == 90.0 ? 0.0 : std::cos(origin.y * kDegree);
  frame.Exaggeration = frame.TheKind == SceneKind::Local ? exaggeration : 1.0;
  const double height = frame.TheKind == SceneKind::Plane ? 0.0 : frame.RiseToScene(origin.z);
  frame.Meridian = PlaceToGeocentric({ origin.x, origin.y, height }, origin.x);
  return frame;
}

SceneFrame SceneFrame::OfZone(int zone, bool northern)
{
  SceneFrame frame;
  frame.TheKind = SceneKind::Zone;
  frame.TheZone = zone;
  frame.IsNorthern = northern;
  return frame;
}

SceneFrame SceneFrame::OfBody(const Ellipsoid& body)
{
  SceneFrame frame;
  frame.TheKind = SceneKind::Globe;
  frame.Body = body;
  return frame;
}

glm::dvec3 SceneFrame::ToScene(const glm::dvec3& place) const
{
  switch (this->TheKind)
  {
    case SceneKind::Local:
      return ToEastNorthUp(
        PlaceToGeocentric({ place.x, place.y, this->RiseToScene(place.z) }, this->TheOrigin.x) -
          this->Meridian,
        this->SinLatitude, this->CosLatitude);
    case SceneKind::Plane:
      return this->PlaneToScene(place);
    case SceneKind::Geocentric:
      return PlaceToGeocentric(place);
    case SceneKind::Zone:
      return this->ZoneToScene(place);
    case SceneKind::Globe:
      return IsPlace(place)
        ? this->Body.ToPosition({ place.x * kDegree, place.y * kDegree, place.z })
        : kNowhere;
  }
  return kNowhere;
}

glm::dvec3 SceneFrame::ToPlace(const glm::dvec3& scene) const
{
  switch (this->TheKind)
  {
    case SceneKind::Local:
    {
      glm::dvec3 place = GeocentricToPlace(
        this->Meridian + FromEastNorthUp(scene, this->SinLatitude, this->CosLatitude),
        this->TheOrigin.x);
      place.z /= this->Exaggeration;
      return place;
    }
    case SceneKind::Plane:
      return this->PlaneToPlace(scene);
    case SceneKind::Geocentric:
      return GeocentricToPlace(scene);
    case SceneKind::Zone:
      return this->ZoneToPlace(scene);
    case SceneKind::Globe:
    {
      const glm::dvec3 place = this->Body.ToPlace(scene);
      return { place.x / kDegree, place.y / kDegree, place.z };
    }
  }
  return kNowhere;
}

glm::dvec3 SceneFrame::PlaneToScene(const glm::dvec3& place) const
{
  const glm::dvec3 foot = PlaceToGeocentric({ place.x, place.y, 0.0 }, this->TheOrigin.x);
  // The outward normal is (x / a^2, y / a^2, z / b^2): the near side sees the origin's up.
  const double facing = this->CosLatitude * foot.x * (1.0 - kE2) + this->SinLatitude * foot.z;
  if (!(facing > 0.0) || !std::isfinite(place.z))
  {
    return kNowhere;
  }
  const glm::dvec3 local =
    ToEastNorthUp(foot - this->Meridian, this->SinLatitude, this->CosLatitude);
  return { local.x, local.y, place.z - this->TheOrigin.z };
}

glm::dvec3 SceneFrame::PlaneToPlace(const glm::dvec3& scene) const
{
  // The vertical line through (x, y) meets the ellipsoid where |S (P + z U)| = 1 with
  // S = diag(1/a, 1/a, 1/b); z is the root that vanishes at the origin.
  const glm::dvec3 scale(1.0 / kA, 1.0 / kA, 1.0 / kB);
  const glm::dvec3 start = this->Meridian +
    FromEastNorthUp({ scene.x, scene.y, 0.0 }, this->SinLatitude, this->CosLatitude);
  const glm::dvec3 up(this->CosLatitude, 0.0, this->SinLatitude);
  const double a = glm::dot(scale * up, scale * up);
  const double b = glm::dot(scale * start, scale * up);
  const double c = glm::dot(scale * start, scale * start) - 1.0;
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0) || !std::isfinite(scene.z))
  {
    return kNowhere;
  }
  const glm::dvec3 foot = start - (c / (b + std::sqrt(discriminant))) * up;
  const double p = std::sqrt(foot.x * foot.x + foot.y * foot.y);
  return { WrapLongitude(std::atan2(foot.y, foot.x) / kDegree + this->TheOrigin.x),
    std::atan2(foot.z, (1.0 - kE2) * p) / kDegree, scene.z + this->TheOrigin.z };
}

glm::dvec3 SceneFrame::ZoneToScene(const glm::dvec3& place) const
{
  if (!IsPlace(place))
  {
    return kNowhere;
  }
  glm::dvec3 scene(0.0, 0.0, place.z);
  if (this->TheZone == 0)
  {
    GeographicLib::PolarStereographic::UPS().Forward(
      this->IsNorthern, place.y, place.x, scene.x, scene.y);
    return scene + glm::dvec3(kUpsEasting, kUpsEasting, 0.0);
  }
  GeographicLib::TransverseMercator::UTM().Forward(
    CentralMeridian(this->TheZone), place.y, place.x, scene.x, scene.y);
  return scene + glm::dvec3(kUtmEasting, this->IsNorthern ? 0.0 : kUtmNorthingSouth, 0.0);
}

glm::dvec3 SceneFrame::ZoneToPlace(const glm::dvec3& scene) const
{
  glm::dvec3 place(0.0, 0.0, scene.z);
  if (this->TheZone == 0)
  {
    GeographicLib::PolarStereographic::UPS().Reverse(
      this->IsNorthern, scene.x - kUpsEasting, scene.y - kUpsEasting, place.y, place.x);
  }
  else
  {
    GeographicLib::TransverseMercator::UTM().Reverse(CentralMeridian(this->TheZone),
      scene.x - kUtmEasting, scene.y - (this->IsNorthern ? 0.0 : kUtmNorthingSouth), place.y,
      place.x);
  }
  return IsPlace(place) ? place : kNowhere;
}

glm::dmat3 SceneFrame::AxesAt(const glm::dvec3& place) const
{
  // Differences over 20 m, along the place's own east, north and up.
  constexpr double kStep = 10.0;
  const double longitude = place.x * kDegree;
  const double latitude = place.y * kDegree;
  const glm::dvec3 axes[3] = { { -std::sin(longitude), std::cos(longitude), 0.0 },
    { -std::sin(latitude) * std::cos(longitude), -std::sin(latitude) * std::sin(longitude),
      std::cos(latitude) },
    { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
      std::sin(latitude) } };
  const glm::dvec3 centre = PlaceToGeocentric(place);
  glm::dmat3 result;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 ahead = this->ToScene(GeocentricToPlace(centre + kStep * axes[axis]));
    const glm::dvec3 behind = this->ToScene(GeocentricToPlace(centre - kStep * axes[axis]));
    result[axis] = glm::normalize(ahead - behind);
  }
  return result;
}

void SceneFrame::ToScene(
  const double* places, double* scene, std::int64_t count, const ParallelFor& parallel) const
{
  parallel(count,
    [this, places, scene](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const glm::dvec3 point =
          this->ToScene(glm::dvec3(places[3 * i], places[3 * i + 1], places[3 * i + 2]));
        scene[3 * i] = point.x;
        scene[3 * i + 1] = point.y;
        scene[3 * i + 2] = point.z;
      }
    });
}

void SceneFrame::ToPlaces(
  const double* scene, double* places, std::int64_t count, const ParallelFor& parallel) const
{
  parallel(count,
    [this, scene, places](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const glm::dvec3 place =
          this->ToPlace(glm::dvec3(scene[3 * i], scene[3 * i + 1], scene[3 * i + 2]));
        places[3 * i] = place.x;
        places[3 * i + 1] = place.y;
        places[3 * i + 2] = place.z;
      }
    });
}
}
