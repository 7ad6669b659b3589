// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/SunPosition.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
terrain::UtcTime At(const char* text)
{
  terrain::UtcTime time;
  std::string message;
  EXPECT_TRUE(terrain::TimeFromText(text, time, message)) << message;
  return time;
}
}

TEST(SunPosition, WorkedExampleOfReda)
{
  // I. Reda, A. Andreas, Solar position algorithm, NREL/TP-560-34302 (2008), table A5.1: elevation
  // without refraction 39.872046, azimuth 194.340241.
  const terrain::SunAngles sun =
    terrain::SunPosition({ -105.1786, 39.742476, 1830.14 }, At("2003-10-17T12:30:30-07:00"));
  EXPECT_NEAR(sun.Elevation, 39.872046, terrain::kSunPositionError);
  EXPECT_NEAR(sun.Azimuth, 194.340241, terrain::kSunPositionError);
}

TEST(SunPosition, SolsticesAndEquinox)
{
  // Declination +23.44 and -23.44 at the solstices (times of the almanac), 0 at the equinox: the
  // sun at the pole stands as high as its declination.
  const glm::dvec3 pole(0.0, 90.0, 0.0);
  EXPECT_NEAR(terrain::SunPosition(pole, At("2024-06-20T20:51Z")).Elevation, 23.436, 0.02);
  EXPECT_NEAR(terrain::SunPosition(pole, At("2024-12-21T09:20Z")).Elevation, -23.436, 0.02);
  EXPECT_NEAR(terrain::SunPosition(pole, At("2024-03-20T03:06Z")).Elevation, 0.0, 0.02);
}

TEST(SunPosition, DirectionOfMorningNoonEvening)
{
  const glm::dvec3 place(0.0, 45.0, 0.0);
  const glm::dvec3 morning = SunDirection(terrain::SunPosition(place, At("2024-06-21 06:00")));
  const glm::dvec3 noon = SunDirection(terrain::SunPosition(place, At("2024-06-21 12:00")));
  const glm::dvec3 evening = SunDirection(terrain::SunPosition(place, At("2024-06-21 18:00")));
  EXPECT_GT(morning.x, 0.8);
  EXPECT_LT(evening.x, -0.8);
  EXPECT_LT(noon.y, -0.3);
  EXPECT_GT(noon.z, 0.9);
  EXPECT_NEAR(glm::length(noon), 1.0, 1e-12);
}

TEST(SunPosition, HoursBeyondTheDay)
{
  const glm::dvec3 place(30.0, 10.0, 0.0);
  const terrain::SunAngles a = terrain::SunPosition(place, At("2024-03-01T01:00+05:30"));
  const terrain::SunAngles b = terrain::SunPosition(place, At("2024-02-29T19:30Z"));
  EXPECT_NEAR(a.Azimuth, b.Azimuth, 1e-6);
  EXPECT_NEAR(a.Elevation, b.Elevation, 1e-6);
}

TEST(SunPosition, RefusesTimes)
{
  // as many digits as a file or a command line may have
  const std::string endless = "2024-06-21T06:30:00." + std::string(1000000, '0') + "Z";
  for (const std::string& text :
    std::initializer_list<std::string>{ endless, "", "noon", "2024-13-01T00:00", "2023-02-29T00:00",
      "2024-01-01", "2024-01-01T24:00", "1800-01-01T00:00", "2024-1-1T0:00" })
  {
    terrain::UtcTime time;
    std::string message;
    EXPECT_FALSE(terrain::TimeFromText(text, time, message)) << text;
    EXPECT_FALSE(message.empty());
    EXPECT_EQ(time.Year, 2000);
  }
}
