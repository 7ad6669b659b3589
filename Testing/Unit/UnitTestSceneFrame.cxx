// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/SceneFrame.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using terrain::SceneFrame;
using terrain::SceneKind;

/// Distance in metres of two places.
double Apart(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::length(terrain::PlaceToGeocentric(a) - terrain::PlaceToGeocentric(b));
}

/// A place at random within about radius metres of the origin, from 500 m below to 9000 m above it.
glm::dvec3 Near(const glm::dvec3& origin, double radius, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(-0.7, 0.7);
  std::uniform_real_distribution<double> height(-500.0, 9000.0);
  const SceneFrame frame = SceneFrame::AtOrigin(SceneKind::Plane, origin);
  return frame.ToPlace({ radius * share(random), radius * share(random), height(random) });
}

const std::vector<glm::dvec3> kOrigins{ { 86.925, 27.988, 0.0 }, { -70.01, -32.65, 500.0 },
  { 179.999, -16.5, 0.0 }, { -180.0, 65.0, 0.0 }, { 12.0, 90.0, 0.0 }, { 0.0, -90.0, 2800.0 },
  { 0.0, 0.0, 0.0 }, { 30.0, 89.99999, 10.0 } };
}

TEST(SceneFrame, LocalAgreesWithGeographicLib)
{
  std::mt19937 random(1);
  for (const glm::dvec3& origin : kOrigins)
  {
    const SceneFrame frame = SceneFrame::AtOrigin(SceneKind::Local, origin);
    const GeographicLib::LocalCartesian reference(origin.y, origin.x, origin.z);
    for (int i = 0; i < 2000; ++i)
    {
      const glm::dvec3 place = Near(origin, 1.0e6, random);
      glm::dvec3 expected;
      reference.Forward(place.y, place.x, place.z, expected.x, expected.y, expected.z);
      const glm::dvec3 scene = frame.ToScene(place);
      EXPECT_LE(glm::length(scene - expected), terrain::kSceneFrameError);
      EXPECT_LE(Apart(frame.ToPlace(scene), place), terrain::kSceneFrameError);
    }
  }
}

TEST(SceneFrame, PlaneIsTheFootOfLocal)
{
  std::mt19937 random(2);
  for (const glm::dvec3& origin : kOrigins)
  {
    const SceneFrame frame = SceneFrame::AtOrigin(SceneKind::Plane, origin);
    const GeographicLib::LocalCartesian reference(origin.y, origin.x, 0.0);
    for (int i = 0; i < 2000; ++i)
    {
      const glm::dvec3 place = Near(origin, 1.0e6, random);
      glm::dvec3 expected;
      reference.Forward(place.y, place.x, 0.0, expected.x, expected.y, expected.z);
      expected.z = place.z - origin.z;
      const glm::dvec3 scene = frame.ToScene(place);
      EXPECT_LE(glm::length(scene - expected), terrain::kSceneFrameError);
      EXPECT_LE(Apart(frame.ToPlace(scene), place), terrain::kSceneFrameError);
    }
  }
}

TEST(SceneFrame, GeocentricAgreesWithGeographicLib)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> longitude(-180.0, 180.0);
  std::uniform_real_distribution<double> latitude(-90.0, 90.0);
  std::uniform_real_distribution<double> height(-1.0e6, 1.0e6);
  const SceneFrame frame;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 place(longitude(random), latitude(random), height(random));
    glm::dvec3 expected;
    GeographicLib::Geocentric::WGS84().Forward(
      place.y, place.x, place.z, expected.x, expected.y, expected.z);
    const glm::dvec3 scene = frame.ToScene(place);
    EXPECT_LE(glm::length(scene - expected), terrain::kSceneFrameError);
    EXPECT_LE(Apart(frame.ToPlace(scene), place), terrain::kSceneFrameError);
  }
  // Where Bowring's steps give way to GeographicLib.
  for (double radius : { 0.0, 1.0, 1.0e5, 4.29e6, 4.31e6, 9.59e7, 9.61e7, 1.0e9 })
  {
    const glm::dvec3 scene(0.6 * radius, 0.0, 0.8 * radius);
    const double error = glm::length(frame.ToScene(frame.ToPlace(scene)) - scene);
    EXPECT_LE(error, terrain::kSceneFrameError * std::max(1.0, radius / 1.0e7)) << radius;
  }
}

TEST(SceneFrame, ZonesAgreeWithUtmUps)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> longitude(-180.0, 180.0);
  std::uniform_real_distribution<double> latitude(-90.0, 90.0);
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 place(longitude(random), latitude(random), 12.0);
    int zone = 0;
    bool northern = true;
    glm::dvec3 expected(0.0, 0.0, 12.0);
    GeographicLib::UTMUPS::Forward(place.y, place.x, zone, northern, expected.x, expected.y);
    const SceneFrame frame = SceneFrame::OfZone(zone, northern);
    const glm::dvec3 scene = frame.ToScene(place);
    EXPECT_LE(glm::length(scene - expected), terrain::kSceneFrameError);
    EXPECT_LE(Apart(frame.ToPlace(scene), place), terrain::kSceneFrameError);
  }
}

TEST(SceneFrame, PlacesWithoutImageAreNaN)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<glm::dvec3> bad{ { 0.0, 90.5, 0.0 }, { nan, 0.0, 0.0 }, { 0.0, nan, 0.0 },
    { 0.0, 0.0, nan }, { inf, 0.0, 0.0 }, { 0.0, 0.0, inf } };
  const glm::dvec3 origin(10.0, 45.0, 0.0);
  const std::vector<SceneFrame> frames{ SceneFrame(),
    SceneFrame::AtOrigin(SceneKind::Local, origin), SceneFrame::AtOrigin(SceneKind::Plane, origin),
    SceneFrame::OfZone(32, true), SceneFrame::OfZone(0, true) };
  for (const SceneFrame& frame : frames)
  {
    for (const glm::dvec3& place : bad)
    {
      const glm::dvec3 scene = frame.ToScene(place);
      // Heights pass through zones; all else makes the whole point NaN.
      EXPECT_FALSE(std::isfinite(scene.x) && std::isfinite(scene.y) && std::isfinite(scene.z));
    }
    EXPECT_FALSE(std::isfinite(frame.ToPlace({ nan, 0.0, 0.0 }).y));
  }
  // The far side of the earth, and beyond its edge.
  EXPECT_TRUE(std::isnan(frames[2].ToScene({ -170.0, -45.0, 0.0 }).x));
  EXPECT_TRUE(std::isnan(frames[2].ToPlace({ 7.0e6, 0.0, 0.0 }).x));
}

TEST(SceneFrame, AxesPointEastNorthUp)
{
  const glm::dvec3 origin(86.9, 28.0, 0.0);
  const glm::dmat3 local = SceneFrame::AtOrigin(SceneKind::Local, origin).AxesAt(origin);
  const glm::dmat3 plane = SceneFrame::AtOrigin(SceneKind::Plane, origin).AxesAt(origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(local[axis][axis], 1.0, 1e-9);
    EXPECT_NEAR(plane[axis][axis], 1.0, 1e-9);
  }
  // The convergence of UTM: east of its meridian, north leans to the east by dlon * sin(lat).
  const glm::dmat3 zone = SceneFrame::OfZone(45, true).AxesAt({ 88.0, 30.0, 0.0 });
  EXPECT_NEAR(std::atan2(zone[1].x, zone[1].y) * 57.29577951308232, -0.5, 1e-3);
  const glm::dmat3 geocentric = SceneFrame().AxesAt({ 0.0, 0.0, 0.0 });
  EXPECT_NEAR(geocentric[2].x, 1.0, 1e-9);
  EXPECT_NEAR(geocentric[0].y, 1.0, 1e-9);
}

TEST(SceneFrame, ArraysInPlaceInAnySplit)
{
  std::mt19937 random(5);
  const SceneFrame frame = SceneFrame::AtOrigin(SceneKind::Local, kOrigins[0]);
  std::vector<double> places;
  for (int i = 0; i < 1001; ++i)
  {
    const glm::dvec3 place = Near(kOrigins[0], 1.0e5, random);
    places.insert(places.end(), { place.x, place.y, place.z });
  }
  std::vector<double> whole(places.size());
  frame.ToScene(places.data(), whole.data(), 1001);
  std::vector<double> inPlace = places;
  frame.ToScene(inPlace.data(), inPlace.data(), 1001,
    [](std::int64_t count, const terrain::RangeBody& body)
    {
      for (std::int64_t i = count - 1; i >= 0; --i)
      {
        body(i, i + 1);
      }
    });
  EXPECT_EQ(whole, inPlace);
  frame.ToPlaces(inPlace.data(), inPlace.data(), 1001);
  for (std::size_t i = 0; i < places.size(); i += 3)
  {
    EXPECT_LE(Apart({ places[i], places[i + 1], places[i + 2] },
                { inPlace[i], inPlace[i + 1], inPlace[i + 2] }),
      terrain::kSceneFrameError);
  }
  frame.ToScene(nullptr, nullptr, 0);
}
