// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/SunPosition.h"

#include "core/grid/Constants.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <regex>

namespace
{
using terrain::kDegree;

bool IsLeap(int year)
{
  return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

int DaysInMonth(int year, int month)
{
  constexpr std::array<int, 12> days{ 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  return month == 2 && IsLeap(year) ? 29 : days[static_cast<std::size_t>(month - 1)];
}

/// Days from 2000-01-01 12:00 UT.
double DaysSince2000(const terrain::UtcTime& time)
{
  // Day number of the civil calendar with years that begin in March.
  const int y = time.Month > 2 ? time.Year : time.Year - 1;
  const int m = time.Month > 2 ? time.Month - 3 : time.Month + 9;
  const double leapDays = std::floor(y / 4.0) - std::floor(y / 100.0) + std::floor(y / 400.0);
  const double day = 365.0 * y + leapDays + std::floor((153.0 * m + 2.0) / 5.0) + time.Day;
  constexpr double kDayOf20000101 = 730426.0;
  return day - kDayOf20000101 + (time.Hours - 12.0) / 24.0;
}

double Positive(double angle, double turn)
{
  const double rest = std::fmod(angle, turn);
  return rest < 0.0 ? rest + turn : rest;
}
}

namespace terrain
{
SunAngles SunPosition(const glm::dvec3& place, const UtcTime& time)
{
  const double days = DaysSince2000(time);
  // Mean longitude and anomaly, then the ecliptic longitude and obliquity, in degrees.
  const double meanLongitude = Positive(280.460 + 0.9856474 * days, 360.0);
  const double meanAnomaly = Positive(357.528 + 0.9856003 * days, 360.0) * kDegree;
  const double eclipticLongitude =
    (meanLongitude + 1.915 * std::sin(meanAnomaly) + 0.020 * std::sin(2.0 * meanAnomaly)) * kDegree;
  const double obliquity = (23.439 - 0.0000004 * days) * kDegree;
  const double rightAscension =
    std::atan2(std::cos(obliquity) * std::sin(eclipticLongitude), std::cos(eclipticLongitude));
  const double declination = std::asin(std::sin(obliquity) * std::sin(eclipticLongitude));
  // Sidereal time in hours; days counts from noon, the formula's own count of hours from midnight
  // is contained in the rate.
  const double siderealTime =
    Positive(6.697375 + 0.0657098242 * days + Positive(time.Hours, 24.0) + place.x / 15.0, 24.0);
  const double hourAngle = siderealTime * 15.0 * kDegree - rightAscension;
  const double latitude = place.y * kDegree;
  const double up = std::sin(latitude) * std::sin(declination) +
    std::cos(latitude) * std::cos(declination) * std::cos(hourAngle);
  const double east = -std::cos(declination) * std::sin(hourAngle);
  const double north = std::cos(latitude) * std::sin(declination) -
    std::sin(latitude) * std::cos(declination) * std::cos(hourAngle);
  return { Positive(std::atan2(east, north) / kDegree, 360.0),
    std::atan2(up, std::hypot(east, north)) / kDegree };
}

glm::dvec3 SunDirection(const SunAngles& angles)
{
  const double azimuth = angles.Azimuth * kDegree;
  const double elevation = angles.Elevation * kDegree;
  return { std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
    std::sin(elevation) };
}

bool TimeFromText(const std::string& text, UtcTime& time, std::string& message)
{
  static const std::regex pattern(
    "(\\d{4})-(\\d{2})-(\\d{2})[T ](\\d{2}):(\\d{2})(?::(\\d{2}(?:\\.\\d+)?))?"
    "(?:Z|([+-])(\\d{2}):?(\\d{2}))?");
  constexpr std::size_t kMostLetters = 64; // std::regex takes stack for each
  std::smatch part;
  if (text.size() > kMostLetters || !std::regex_match(text, part, pattern))
  {
    message = "'" + text + "' is no time like 2024-06-21T06:30Z or 2024-06-21T12:15+05:45";
    return false;
  }
  UtcTime read;
  read.Year = std::stoi(part[1]);
  read.Month = std::stoi(part[2]);
  read.Day = std::stoi(part[3]);
  const int hours = std::stoi(part[4]);
  const int minutes = std::stoi(part[5]);
  const double seconds = part[6].matched ? std::stod(part[6]) : 0.0;
  if (read.Month < 1 || read.Month > 12 || read.Day < 1 ||
    read.Day > DaysInMonth(read.Year, read.Month) || hours > 23 || minutes > 59 || seconds >= 61.0)
  {
    message = "'" + text + "' is not in the calendar";
    return false;
  }
  if (read.Year < 1950 || read.Year > 2050)
  {
    message = "the sun's position is computed for 1950 to 2050, not for " + part[1].str();
    return false;
  }
  double offset = 0.0;
  if (part[7].matched)
  {
    offset = std::stoi(part[8]) + std::stoi(part[9]) / 60.0;
    offset = part[7] == "-" ? -offset : offset;
  }
  read.Hours = hours + minutes / 60.0 + seconds / 3600.0 - offset;
  time = read;
  return true;
}
}
