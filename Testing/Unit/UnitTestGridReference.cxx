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

TEST(GridReference, ReadsAnglesInManyWays)
{
  for (const char* text : { "86.925 27.988", "86.925,27.988", "27.988N,86.925E", "n27.988 e86.925",
         "86d55.5 27d59.28", "86:55:30 27:59:16.8", "27:59.28N 86:55.5E",
         "27d59'16.8\"N 86d55'30\"E", "27\u00b059\u203216.8\u2033N 86\u00b055\u203230\u2033E",
         "27d59'16.8''N 86d55'30''E", "+86.925 +27.988", "86d55'30 27d59'16.8" })
  {
    glm::dvec3 place(0.0);
    std::string message;
    ASSERT_TRUE(terrain::PlaceFromText(text, place, message)) << message;
    EXPECT_NEAR(place.x, 86.925, 1e-12) << text;
    EXPECT_NEAR(place.y, 27.988, 1e-12) << text;
  }
}

// Harmless texts of every kind that is never shown to GeographicLib.
TEST(GridReference, RefusesWhatDoesNotLookLikeAPlace)
{
  for (const char* text : { "N E", "d d", "' '", "\" \"", ": :", "- -", "1: 2:", "1.5d30 2",
         "1d2d3 4", "1'2d 4", "N1N 2E", "1+2 3", "1:2'3 4", "1:2:3:4 5", "1..2 3", "1e5 2", "1_2 3",
         "1 2 3", "45N 1e5 2", "45N inf nan", "45northern 1 2", "45N 12345678901 2", "45RVL123",
         "123RVL12", "45RVLL12", "86.925 27.988 0 0", "1234 5" })
  {
    glm::dvec3 place(1.0, 2.0, 3.0);
    std::string message;
    EXPECT_FALSE(terrain::PlaceFromText(text, place, message)) << text;
    EXPECT_EQ(message.find(std::string("'") + text + "' is no place"), 0U) << message;
    EXPECT_EQ(place, glm::dvec3(1.0, 2.0, 3.0));
  }
  glm::dvec3 place(0.0);
  std::string message;
  EXPECT_FALSE(terrain::PlaceFromText(std::string(100000, '1'), place, message));
  const std::string withNull("45n 493004\0 5460", 16);
  EXPECT_FALSE(terrain::PlaceFromText(withNull, place, message));
  EXPECT_FALSE(terrain::PlaceFromText("86.925" + std::string(100, ' ') + "27.988", place, message));
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
