// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightOptions.h"

#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkTerrainActor.h>
#include <vtkTerrainGeoreference.h>
#include <vtkTerrainViewpoint.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace
{
constexpr int kMostSuns = 10000;
constexpr int kMinute = 60;

/// "AZIMUTH,ALTITUDE" in degrees; false if the text is no such pair of numbers.
bool ReadDirection(const std::string& text, std::array<double, 2>& direction)
{
  const std::size_t comma = text.find(',');
  return comma != std::string::npos &&
    CLI::detail::lexical_cast(text.substr(0, comma), direction[0]) &&
    CLI::detail::lexical_cast(text.substr(comma + 1), direction[1]) &&
    std::abs(direction[0]) <= 360.0 && std::abs(direction[1]) <= 90.0;
}

/// Seconds since 1970 of a date and time as vtkTerrainViewpoint takes them.
std::time_t SecondsOf(const std::string& text)
{
  std::tm time{};
  int used = 0;
  std::sscanf(text.c_str(), "%d-%d-%dT%d:%d%n", &time.tm_year, &time.tm_mon, &time.tm_mday,
    &time.tm_hour, &time.tm_min, &used);
  int more = 0;
  if (std::sscanf(text.c_str() + used, ":%d%n", &time.tm_sec, &more) == 1)
  {
    used += more;
  }
  char sign = '+';
  int hours = 0;
  int minutes = 0;
  const std::string zone = text.substr(text.find_first_of("Z+-", static_cast<std::size_t>(used)));
  std::sscanf(zone.c_str(), "%c%d:%d", &sign, &hours, &minutes);
  const int ahead = kMinute * (kMinute * hours + minutes) * (sign == '-' ? -1 : 1);
  time.tm_year -= 1900;
  time.tm_mon -= 1;
  return timegm(&time) - (zone[0] == 'Z' ? 0 : ahead);
}

/// "FROM/TO/MINUTES" in parts; fewer than three for any other text.
std::vector<std::string> PartsOf(const std::string& text)
{
  return CLI::detail::split(text, '/');
}

/// Times from the first to the last, both included.
std::vector<std::string> TimesOf(const std::vector<std::string>& parts)
{
  std::vector<std::string> times;
  double minutes = 0.0;
  CLI::detail::lexical_cast(parts[2], minutes);
  const std::time_t first = SecondsOf(parts[0]);
  const auto steps = static_cast<int>(
    std::floor(static_cast<double>(SecondsOf(parts[1]) - first) / (kMinute * minutes) + 1e-9));
  for (int k = 0; k <= steps && k < kMostSuns; ++k)
  {
    const std::time_t at = first + static_cast<std::time_t>(std::lround(kMinute * minutes * k));
    std::tm time{};
    gmtime_r(&at, &time);
    std::array<char, 40> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &time);
    times.emplace_back(text.data());
  }
  return times;
}

std::string WhyNotRange(const std::vector<std::string>& parts)
{
  for (int k = 0; k < 2; ++k)
  {
    std::string why = vtkTerrainViewpoint::GetWhyNoTime(parts[static_cast<std::size_t>(k)]);
    if (!why.empty())
    {
      return why;
    }
  }
  double minutes = 0.0;
  if (!CLI::detail::lexical_cast(parts[2], minutes) || !(minutes >= 0.1) || !(minutes <= 1e6))
  {
    return "'" + parts[2] + "' is no number of minutes from 0.1 to 1e6";
  }
  const auto length = static_cast<double>(SecondsOf(parts[1]) - SecondsOf(parts[0]));
  return length < 0.0 ? "'" + parts[1] + "' is before '" + parts[0] + "'"
    : length / (kMinute * minutes) >= kMostSuns
    ? "there are more than " + std::to_string(kMostSuns) + " pictures in that range"
    : std::string();
}

std::string WhyNotSun(const std::string& text, bool allowRange)
{
  std::array<double, 2> direction{};
  const std::vector<std::string> parts = PartsOf(text);
  if (text.find(',') != std::string::npos)
  {
    return ReadDirection(text, direction)
      ? std::string()
      : "'" + text + "' is not AZIMUTH,ALTITUDE in degrees, -360 to 360 and -90 to 90";
  }
  if (parts.size() == 3)
  {
    return allowRange ? WhyNotRange(parts) : "one window shows one time, not '" + text + "'";
  }
  return vtkTerrainViewpoint::GetWhyNoTime(text);
}
}

//------------------------------------------------------------------------------
void LightOptions::Declare(CLI::App& app, bool allowRange)
{
  const std::string range =
    allowRange ? "; FROM/TO/MINUTES draws one picture for each step, numbered" : "";
  app
    .add_option("--sun", this->Sun,
      "azimuth clockwise from north and altitude, degrees; or the sun of a time, "
      "2024-06-21T06:30Z or with +05:45" +
        range)
    ->type_name("AZIMUTH,ALTITUDE|DATE-TIME")
    ->check(CLI::Validator(
      [allowRange](const std::string& text) { return WhyNotSun(text, allowRange); }, ""));
  app.add_flag("--shadows", this->Shadows, "the terrain casts shadows on itself");
  app
    .add_option("--sun-angle", this->SunAngle,
      "angular diameter of the sun in degrees, for edges of shadows; default 0.53, 0 for hard ones")
    ->type_name("DEGREES")
    ->check(CLI::Range(0.0, 90.0).description(""));
  // as text: of a number, CLI11 2.1 counts how often the flag is given
  app
    .add_flag("--sky-light{0.35}", this->SkyText,
      "light of the sky, as far as it is seen over the terrain; --sky-light=0.5 for more than 0.35")
    ->check(CLI::Range(0.0, 10.0).description(""))
    ->each([this](const std::string& text) { this->SkyLight = std::stod(text); });
}

//------------------------------------------------------------------------------
std::vector<std::string> LightOptions::GetSuns() const
{
  const std::vector<std::string> parts = PartsOf(this->Sun);
  return parts.size() == 3 ? TimesOf(parts) : std::vector<std::string>{ this->Sun };
}

//------------------------------------------------------------------------------
bool LightOptions::NeedsPlace() const
{
  return !this->Sun.empty() && this->Sun.find(',') == std::string::npos;
}

//------------------------------------------------------------------------------
void LightOptions::Apply(vtkTerrainActor* terrain) const
{
  terrain->SetSunShadows(this->Shadows);
  terrain->SetSunAngle(this->SunAngle);
  terrain->SetSkyLight(this->SkyLight);
}

//------------------------------------------------------------------------------
std::string PlaceSun(const std::string& sun, vtkTerrainGeoreference* frame, vtkImageData* heights,
  double exaggeration, vtkLight* light)
{
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPosition(-1.0, 1.0, 1.2);
  std::array<double, 2> direction{};
  if (ReadDirection(sun, direction))
  {
    if (frame->GetFrame() == vtkTerrainGeoreference::FrameType::Geocentric)
    {
      return "an azimuth has no direction in a geocentric scene: give a date and time";
    }
    const double azimuth = vtkMath::RadiansFromDegrees(direction[0]);
    const double altitude = vtkMath::RadiansFromDegrees(direction[1]);
    light->SetPosition(std::cos(altitude) * std::sin(azimuth),
      std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
    light->SetSwitch(direction[1] > 0.0 ? 1 : 0);
  }
  else if (!sun.empty())
  {
    const vtkNew<vtkTerrainViewpoint> viewpoint;
    viewpoint->SetGeoreference(frame);
    viewpoint->SetHeights(heights);
    viewpoint->SetExaggeration(exaggeration);
    return viewpoint->SetSun(sun, light);
  }
  return {};
}
