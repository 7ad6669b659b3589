// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlightOptions.h"

#include "Arguments.h"
#include "Film.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <system_error>

namespace
{
const char* const kOrbit = "orbit";
const std::string kSpin = "spin:";
constexpr double kLongestFlight = 86400.0;
}

//------------------------------------------------------------------------------
bool IsFilm(const std::string& output)
{
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension == ".mp4" || extension == ".webm" || extension == ".gif" || extension == ".webp";
}

//------------------------------------------------------------------------------
std::string FramesFolder(const std::string& output)
{
  if (!IsFilm(output))
  {
    return output;
  }
  const std::filesystem::path path(output);
  return (path.parent_path() / (path.stem().string() + "-frames")).string();
}

//------------------------------------------------------------------------------
void FlightOptions::Declare(CLI::App& app)
{
  const char* const group = "Flights";
  app
    .add_option("--flight", this->Flight,
      "orbit: once round, slow at both ends; spin:SECONDS: once round, to be repeated; a track of "
      "GPX, seen from behind and above, as fast as its times say; a table of CSV: seconds, lon, "
      "lat, height[agl] or x, y, z, "
      "and look_lon, look_lat, look_height or look_x, look_y, look_z. The output is a folder of "
      "frames, or .mp4, .webm, .gif, .webp with a folder of frames or parts beside it; a flight "
      "that was stopped goes on")
    ->type_name("orbit|spin:SECONDS|FILE")
    ->group(group);
  app.add_option("--fps", this->Rate, "frames a second; default 30")
    ->type_name("N")
    ->group(group)
    ->check(CLI::Range(1.0, 240.0).description(""));
  app
    .add_option("--flight-seconds", this->Seconds,
      "duration; default: 12 of orbit, 20 of a track, that of a table")
    ->type_name("SECONDS")
    ->group(group)
    ->check(CLI::Range(0.1, kLongestFlight).description(""));
  app
    .add_flag(
      "--even-speed", this->HasEvenSpeed, "along a track at even speed, whatever its times are")
    ->group(group);
}

//------------------------------------------------------------------------------
double FlightOptions::SpinSeconds() const
{
  return this->Flight.compare(0, kSpin.size(), kSpin) == 0
    ? ParseNumber("--flight", this->Flight.substr(kSpin.size()), 0.1, kLongestFlight)
    : 0.0;
}

//------------------------------------------------------------------------------
bool FlightOptions::IsFile() const
{
  return this->IsWanted() && this->Flight != kOrbit && this->SpinSeconds() == 0.0;
}

//------------------------------------------------------------------------------
void FlightOptions::Check(const std::string& output) const
{
  if (!this->IsWanted())
  {
    if (this->Seconds > 0.0 || this->HasEvenSpeed)
    {
      Refuse(this->HasEvenSpeed ? "--even-speed" : "--flight-seconds", "needs --flight");
    }
    return;
  }
  std::error_code error;
  if (this->IsFile() && !std::filesystem::is_regular_file(this->Flight, error))
  {
    Refuse("--flight", "'" + this->Flight + "' is neither orbit, spin:SECONDS nor a file");
  }
  const std::string extension = std::filesystem::path(output).extension().string();
  if (!extension.empty() && !IsFilm(output))
  {
    Refuse("--output",
      "a flight makes many pictures: name a folder, or a film .mp4, .webm, .gif or .webp");
  }
  if (IsFilm(output) && !HasFilmMaker())
  {
    Refuse("--output",
      "films are made by ffmpeg, which is not on the PATH: install it (Debian: "
      "apt install ffmpeg), or name a folder for the frames");
  }
}
