// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/GridReference.h"
#include "core/place/SceneFrame.h"

#include <gtest/gtest.h>

#include <limits>

TEST(GridReference, KnownReferences)
{
  // The example of GeographicLib's documentation: 33.3 N 44.4 E is 38n 444140.54 3684706.36.
  EXPECT_EQ(terrain::ToMgrs({ 44.4, 33.3, 0.0 }, 2), "38SMB4484");
  EXPECT_EQ(terrain::ToUtmText({ 44.4, 33.3, 0.0 }), "38n 444141 3684706");
  const terrain::GridPosition position = terrain::ToGridPosition({ 44.4, 33.3, 0.0 });
  EXPECT_EQ(position.Zone, 38);
  EXPECT_TRUE(position.Northern);
  EXPECT_EQ(terrain::ToGridPosition({ 0.0, 87.0, 0.0 }).Zone, 0);
  EXPECT_EQ(terrain::ToGridPosition({ 5.0, 60.0, 0.0 }).Zone, 32) << "southern Norway";
}

TEST(GridReference, ReadsWhatItWrites)
{
  for (const glm::dvec3& place : { glm::dvec3(86.925, 27.988, 7.0), glm::dvec3(-70.0, -32.65, 7.0),
         glm::dvec3(179.9999, -16.0, 7.0), glm::dvec3(20.0, -88.0, 7.0) })
  {
    for (const std::string& text :
      { terrain::ToMgrs(place, 8), terrain::ToUtmText(place, 3), terrain::ToDegreesText(place, 9) })
    {
      glm::dvec3 read(0.0, 0.0, 7.0);
      std::string message;
      ASSERT_TRUE(terrain::PlaceFromText(text, read, message)) << text << ": " << message;
      EXPECT_LE(
        glm::length(terrain::PlaceToGeocentric(read) - terrain::PlaceToGeocentric(place)), 2e-3)
        << text;
    }
  }
}

TEST(GridReference, LongitudeComesFirst)
{
  glm::dvec3 place(0.0);
  std::string message;
  ASSERT_TRUE(terrain::PlaceFromText("86.925 27.988", place, message)) << message;
  EXPECT_EQ(place, glm::dvec3(86.925, 27.988, 0.0));
  ASSERT_TRUE(terrain::PlaceFromText("27d59'16.8\"N 86d55'30\"E", place, message)) << message;
  EXPECT_NEAR(place.x, 86.925, 1e-12);
  EXPECT_NEAR(place.y, 27.988, 1e-12);
}

TEST(GridReference, RefusesWithASentence)
{
  for (const char* text : { "", "Everest", "86.9", "10 95", "99ZZZ12", "45N 1 2 3", "nan nan" })
  {
    glm::dvec3 place(1.0, 2.0, 3.0);
    std::string message;
    EXPECT_FALSE(terrain::PlaceFromText(text, place, message)) << text;
    EXPECT_FALSE(message.empty());
    EXPECT_EQ(place, glm::dvec3(1.0, 2.0, 3.0));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(terrain::ToMgrs({ nan, nan, 0.0 }), "-");
  EXPECT_EQ(terrain::ToUtmText({ 0.0, 91.0, 0.0 }), "-");
  EXPECT_EQ(terrain::ToDegreesText({ 0.0, 91.0, 0.0 }), "-");
  EXPECT_EQ(terrain::ToGridPosition({ nan, 0.0, 0.0 }).Zone, -1);
}
