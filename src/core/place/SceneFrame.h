// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From places on earth to the scene and back.
 *
 * A place is a dvec3: longitude in x and latitude in y (degrees, WGS84), height in z (metres). The
 * scene is metric. These kinds of frame are metric everywhere (E east, N north, U up at an origin):
 *
 *   Local       east-north-up Cartesian coordinates: the earth is round in them, and heights above
 *               it may be exaggerated
 *   Plane       x and y of Local for the place's foot on the ellipsoid, z = height - origin height:
 *               EPSG method 9840 (ellipsoidal orthographic), the earth is flat in it
 *   Geocentric  X through (0 E, 0 N), Z through the north pole, origin at the earth's centre
 *   Zone        easting, northing, height of a UTM zone or, zone 0, of UPS
 *   Globe       as Geocentric, of any ellipsoid, whose own longitudes and latitudes places are
 *
 * Points that have no image (a latitude beyond 90 degrees, the far side of the earth in Plane, NaN)
 * become NaN in all three coordinates. Errors: kSceneFrameError.
 */
#ifndef terrain_SceneFrame_h
#define terrain_SceneFrame_h

#include "core/grid/ParallelFor.h"
#include "core/place/Ellipsoid.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace terrain
{
/// Largest error of a round trip place -> scene -> place, and of each way against GeographicLib, in
/// metres; within 1,000 km of the origin (Local, Plane), 1,000 km of the earth's surface
/// (Geocentric) or 10 degrees of the zone's meridian (Zone).
constexpr double kSceneFrameError = 1e-6;

enum class SceneKind
{
  Local,
  Plane,
  Geocentric,
  Zone,
  Globe
};

class SceneFrame
{
public:
  /// Geocentric.
  SceneFrame() = default;

  /// Frame of kind Local or Plane whose origin is the given place. An exaggeration > 0 multiplies
  /// heights in Local: the earth below them stays as it is.
  static SceneFrame AtOrigin(SceneKind kind, const glm::dvec3& origin, double exaggeration = 1.0);
  /// UTM zone 1 to 60, or 0 for UPS, of the northern or southern hemisphere.
  static SceneFrame OfZone(int zone, bool northern);

  /// Frame of kind Globe.
  static SceneFrame OfBody(const Ellipsoid& body);

  SceneKind Kind() const
  {
    return this->TheKind;
  }
  const glm::dvec3& Origin() const
  {
    return this->TheOrigin;
  }
  int Zone() const
  {
    return this->TheZone;
  }
  bool Northern() const
  {
    return this->IsNorthern;
  }

  /// How much higher in the scene a point is whose place is higher by so many metres.
  double RiseToScene(double metres) const
  {
    return this->Exaggeration * metres;
  }
  glm::dvec3 ToScene(const glm::dvec3& place) const;
  /// Longitudes are in [-180, 180].
  glm::dvec3 ToPlace(const glm::dvec3& scene) const;
  /// Unit vectors east, north and up at a place, in scene axes (columns); in frames that distort
  /// angles they need not be orthogonal. NaN where the place has no image.
  glm::dmat3 AxesAt(const glm::dvec3& place) const;

  /// As above for count points, three doubles a point; input and output may be the same array.
  void ToScene(const double* places, double* scene, std::int64_t count,
    const ParallelFor& parallel = SerialFor) const;
  void ToPlaces(const double* scene, double* places, std::int64_t count,
    const ParallelFor& parallel = SerialFor) const;

private:
  glm::dvec3 PlaneToScene(const glm::dvec3& place) const;
  glm::dvec3 PlaneToPlace(const glm::dvec3& scene) const;
  glm::dvec3 ZoneToScene(const glm::dvec3& place) const;
  glm::dvec3 ZoneToPlace(const glm::dvec3& scene) const;

  SceneKind TheKind = SceneKind::Geocentric;
  glm::dvec3 TheOrigin{ 0.0, 0.0, 0.0 };
  int TheZone = -1;
  bool IsNorthern = true;
  double Exaggeration = 1.0;
  Ellipsoid Body;
  // Local and Plane: sine and cosine of the origin's latitude, and the origin's foot (Plane) or the
  // origin itself (Local) in the half plane of its meridian (x off the axis, z along the axis).
  double SinLatitude = 0.0;
  double CosLatitude = 1.0;
  glm::dvec3 Meridian{ 0.0, 0.0, 0.0 };
};

/// Geocentric position (metres) of a place, in axes turned so that X goes through the given
/// longitude (degrees). Source: GeographicLib::Geocentric.
glm::dvec3 PlaceToGeocentric(const glm::dvec3& place, double longitudeOfX = 0.0);

/// Inverse of PlaceToGeocentric. Bowring 1976, two steps with reduced latitudes, whose error is
/// below kSceneFrameError from 2,000 km below to 90,000 km above the ellipsoid;
/// GeographicLib::Geocentric elsewhere.
glm::dvec3 GeocentricToPlace(const glm::dvec3& position, double longitudeOfX = 0.0);
}

#endif
