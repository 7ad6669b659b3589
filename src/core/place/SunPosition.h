// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the sun stands at a place and time.
 *
 * Source: J. J. Michalsky, The Astronomical Almanac's algorithm for approximate solar position
 * (1950-2050), Solar Energy 40 (1988), with its errata in 41 (1988).
 */
#ifndef terrain_SunPosition_h
#define terrain_SunPosition_h

#include <glm/glm.hpp>

#include <string>

namespace terrain
{
/// Largest error of SunPosition in degrees, from 1950 to 2050.
constexpr double kSunPositionError = 0.02;

/// Universal time, Gregorian calendar.
struct UtcTime
{
  int Year = 2000;
  int Month = 1;
  int Day = 1;
  /// Hours since midnight, may be outside [0, 24).
  double Hours = 12.0;
};

struct SunAngles
{
  /// Degrees clockwise from north, in [0, 360).
  double Azimuth = 0.0;
  /// Degrees above the horizon of the sun's centre, without refraction; below 0 at night.
  double Elevation = 0.0;
};

/// Sun at a place (SceneFrame.h; its height does not matter).
SunAngles SunPosition(const glm::dvec3& place, const UtcTime& time);

/// Unit vector to the sun in (east, north, up).
glm::dvec3 SunDirection(const SunAngles& angles);

/// Reads ISO 8601, "2024-06-21T06:30", with seconds, "Z" or an offset "+05:45" if there are any;
/// without offset it is universal time. False, with the reason in message, for anything else and
/// for years outside 1950 to 2050.
bool TimeFromText(const std::string& text, UtcTime& time, std::string& message);
}

#endif
