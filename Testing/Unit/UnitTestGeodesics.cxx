// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/Geodesics.h"
#include "core/place/SceneFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(Geodesics, KnownDistance)
{
  // JFK to Heathrow, the example of GeographicLib's documentation.
  const terrain::GeodesicLeg leg =
    terrain::GeodesicBetween({ -73.8, 40.6, 0.0 }, { -0.5, 51.6, 0.0 });
  EXPECT_NEAR(leg.Distance, 5551759.400, 1e-3);
  // One degree of the equator, and a quarter of the meridian.
  EXPECT_NEAR(terrain::GeodesicBetween({ 10.0, 0.0, 0.0 }, { 11.0, 0.0, 0.0 }).Distance,
    6378137.0 * 0.017453292519943295, 1e-6);
  EXPECT_NEAR(
    terrain::GeodesicBetween({ 0.0, 0.0, 0.0 }, { 0.0, 90.0, 0.0 }).Distance, 10001965.729, 1e-3);
}

TEST(Geodesics, PlacesAreEquallyFar)
{
  const glm::dvec3 from(179.0, 10.0, 100.0);
  const glm::dvec3 to(-179.0, 11.0, 300.0);
  const std::vector<glm::dvec3> places = terrain::GeodesicPlaces(from, to, 5);
  ASSERT_EQ(places.size(), 5u);
  EXPECT_EQ(places.front(), from);
  EXPECT_EQ(places.back(), to);
  EXPECT_NEAR(places[2].z, 200.0, 1e-9);
  const double leg = terrain::GeodesicBetween(from, to).Distance / 4.0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    EXPECT_NEAR(terrain::GeodesicBetween(places[i], places[i + 1]).Distance, leg, 1e-6);
  }
  EXPECT_EQ(terrain::GeodesicPlaces(from, to, 0).size(), 2u);
  for (const glm::dvec3& place : terrain::GeodesicPlaces(from, from, 3))
  {
    EXPECT_NEAR(place.y, from.y, 1e-12);
  }
}

TEST(Geodesics, PolygonAreas)
{
  // A hectare, then the eighth part of the earth.
  const terrain::SceneFrame frame =
    terrain::SceneFrame::AtOrigin(terrain::SceneKind::Plane, { 86.9, 28.0, 0.0 });
  std::vector<glm::dvec3> corners;
  for (const glm::dvec3& corner : { glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(0.0, 100.0, 0.0),
         glm::dvec3(100.0, 100.0, 0.0), glm::dvec3(100.0, 0.0, 0.0) })
  {
    corners.push_back(frame.ToPlace(corner));
  }
  const terrain::GeodesicPolygon hectare = terrain::GeodesicPolygonOf(corners);
  EXPECT_NEAR(hectare.Area, 1.0e4, 1e-4);
  EXPECT_NEAR(hectare.Perimeter, 400.0, 1e-5);
  const terrain::GeodesicPolygon octant =
    terrain::GeodesicPolygonOf({ { 0.0, 0.0, 0.0 }, { 90.0, 0.0, 0.0 }, { 0.0, 90.0, 0.0 } });
  EXPECT_NEAR(octant.Area, 510065621724088.44 / 8.0, 1.0);
  EXPECT_EQ(terrain::GeodesicPolygonOf({}).Area, 0.0);
  EXPECT_EQ(terrain::GeodesicPolygonOf({ corners[0], corners[1] }).Area, 0.0);
}

TEST(Geodesics, NowhereIsNaN)
{
  EXPECT_TRUE(std::isnan(terrain::GeodesicBetween({ 0.0, 95.0, 0.0 }, { 0.0, 0.0, 0.0 }).Distance));
  EXPECT_NEAR(terrain::EarthDrop(1.0e5), 784.8, 0.1);
}
