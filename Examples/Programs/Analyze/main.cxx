// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// terrain-analyze COMMAND HEIGHTS [options]: maps of what terrain hides, shades and how it lies.
//
// Exit status 0; 2 for a wrong command line; 1 otherwise, with one line on stderr that names the
// file and the reason, and no output left behind.
#include "Derivatives.h"
#include "EmptyValues.h"
#include "Ending.h"
#include "Light.h"
#include "NotNumbers.h"
#include "Raster.h"
#include "Sight.h"

#include <vtkObject.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
/// The commands and what their options are read into.
class CommandLine
{
public:
  CommandLine()
    : App("Maps of what terrain hides and shades, and of how it lies.", "terrain-analyze")
  {
    this->App.require_subcommand(1);
    this->AddLightCommands();
    this->AddSightCommands();
    this->AddViewshed();
    const std::vector<std::pair<const char*, const char*>> derivatives{
      { "slope", "Slope in degrees (Horn)" },
      { "aspect", "Where the slope goes down, degrees clockwise from grid north" },
      { "curvature", "Profile and plan curvature in 1/m (Zevenbergen and Thorne)" },
      { "ruggedness", "Terrain ruggedness index in metres (Riley)" }
    };
    for (const auto& [name, text] : derivatives)
    {
      const std::string command = name;
      this->AddCommand(name, text, [this, command] { WriteDerivative(this->Raster, command); });
    }
  }

  /// Reads the command line; returns false, with the exit status, if there is nothing to run.
  bool Parse(int argc, char** argv, int& status)
  {
    try
    {
      RefuseEmptyValues(argc, argv);
      this->App.parse(argc, argv);
      RefuseNotANumber(this->App);
    }
    catch (const CLI::ParseError& error)
    {
      if (error.get_exit_code() == 0)
      {
        status = this->App.exit(error); // --help
        return false;
      }
      std::cerr << "terrain-analyze: " << error.what() << '\n';
      status = 2;
      return false;
    }
    return true;
  }
  void Run()
  {
    this->Raster.Inputs = this->Viewshed.Observers.Files;
    CheckOutput(this->Raster); // before the work
    this->Chosen();
  }

private:
  CLI::App* AddCommand(
    const std::string& name, const std::string& text, const std::function<void()>& run)
  {
    CLI::App* command = this->App.add_subcommand(name, text);
    command
      ->add_option("HEIGHTS", this->Raster.Heights,
        "Any raster that GDAL opens, or a folder or an archive (.zip, .tar, .tgz) of them")
      ->required()
      ->check(CLI::Validator(HeightOptions::WhyNotFile, ""));
    this->Raster.Input.Declare(*command);
    command->add_flag("--quiet", this->Raster.Quiet, "No progress bar, no warnings");
    if (name != "line-of-sight")
    {
      command->add_option("--output", this->Raster.Output, "File to write")->required();
    }
    command->add_option("--compression", this->Raster.Compression, "Of the output")
      ->check(CLI::IsMember({ "NONE", "DEFLATE", "LZW", "ZSTD" }));
    command->callback([this, run] { this->Chosen = run; });
    return command;
  }

  void AddEarth(CLI::App* command)
  {
    command->add_option("--eye-height", this->Light.EyeHeight, "Above the ground, metres")
      ->check(CLI::NonNegativeNumber);
    command->add_flag("--curvature", this->Light.Curvature, "The planet is round");
    command->add_option("--refraction", this->Light.Refraction, "Share of the curvature, 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
    command->add_option("--radius", this->Light.Radius, "Of the planet, metres")
      ->check(CLI::PositiveNumber);
  }

  void AddLightCommands()
  {
    CLI::App* horizon = this->AddCommand("horizon",
      "Degrees above the horizontal; band k + 1 looks to azimuth 360 k / N, clockwise from north",
      [this] { WriteHorizon(this->Raster, this->Light); });
    CLI::App* sky = this->AddCommand("skyview", "Share of an even sky's light on a level plate",
      [this] { WriteSkyView(this->Raster, this->Light); });
    CLI::App* sun = this->AddCommand("sunlight",
      "Hours, first and last time (UTC) of direct sun, and clear-sky Wh/m^2 on the surface",
      [this] { WriteSunlight(this->Raster, this->Light); });
    for (CLI::App* command : { horizon, sky })
    {
      command->add_option("--directions", this->Light.Directions, "Number of azimuths, default 16");
    }
    for (CLI::App* command : { horizon, sky, sun })
    {
      this->AddEarth(command);
    }
    sun->add_option("--date", this->Light.Date, "As 2024-06-21")->required();
    sun->add_option("--time-step", this->Light.TimeStep, "Minutes, default 10")
      ->check(CLI::Range(0.1, 120.0));
    sun->add_option("--turbidity", this->Light.Turbidity, "Linke's factor, default 3")
      ->check(CLI::Range(1.0, 10.0));
  }

  void AddSightCommands()
  {
    CLI::App* profile = this->AddCommand("profile", "Heights along a geodesic, as a table",
      [this] { WriteProfile(this->Raster, this->Sight); });
    profile->add_option("--count", this->Sight.Count, "Points, default 200")
      ->check(CLI::Range(2, 10000000));
    CLI::App* line = this->AddCommand("line-of-sight", "Whether one place is seen from another",
      [this] { PrintLineOfSight(this->Raster, this->Sight); });
    line->add_option("--refraction", this->Sight.Refraction, "Share of the curvature, default 0.13")
      ->check(CLI::Range(0.0, 1.0));
    for (CLI::App* command : { profile, line })
    {
      command->add_option("--from", this->Sight.From, "LON,LAT[,HEIGHT[agl]], MGRS or UTM")
        ->required();
      command->add_option("--to", this->Sight.To, "The same")->required();
    }
  }

  void AddViewshed()
  {
    CLI::App* command = this->AddCommand("viewshed", "How many observers see each sample",
      [this] { WriteViewshed(this->Raster, this->Viewshed); });
    ViewshedOptions& viewshed = this->Viewshed;
    command
      ->add_option("--observer", viewshed.Observers.Points,
        "X,Y in the CRS of HEIGHTS; may be given again for more observers")
      ->type_name("X,Y")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(CLI::Validator(WhyNotCorner, ""));
    command->add_option("--line", viewshed.Observers.Lines,
      "\"X,Y X,Y ...\": observers along it, a cell apart; may be given again");
    command->add_option("--area", viewshed.Observers.Areas,
      "\"X,Y X,Y X,Y ...\": observers at the samples inside; may be given again");
    command->add_option("--observers", viewshed.Observers.Files,
      "File of points, lines and areas that GDAL opens, in any CRS");
    command
      ->add_option("--observer-spacing", viewshed.Spacing,
        "Metres between observers along lines and in areas, default one cell")
      ->check(CLI::PositiveNumber);
    command->add_option("--eye-height", viewshed.EyeHeight, "Metres, default 1.75")
      ->check(CLI::NonNegativeNumber);
    command->add_option("--target-height", viewshed.TargetHeight, "Metres, default 0")
      ->check(CLI::NonNegativeNumber);
    command->add_option("--distance", viewshed.Distance[1], "Farthest, metres; default any")
      ->check(CLI::PositiveNumber);
    command->add_option("--nearest", viewshed.Distance[0], "Least distance, metres; default 0")
      ->check(CLI::NonNegativeNumber);
    command
      ->add_option("--azimuth", viewshed.Azimuth,
        "FROM,TO: degrees clockwise from grid north, as 315,405; default all")
      ->delimiter(',')
      ->expected(2);
    command
      ->add_option("--elevation", viewshed.Elevation, "FROM,TO: degrees of the sight; default all")
      ->delimiter(',')
      ->expected(2);
    command->add_flag(
      "--nodata-blocks", viewshed.NoDataBlocks, "Nobody sees across what there are no data for");
    command->add_flag("--rise", viewshed.Rise,
      "Band 2: metres by which a target would have to rise to be seen, NoData where none would do");
    command->add_flag("--curvature", viewshed.Curvature, "The planet is round");
    command->add_option("--refraction", viewshed.Refraction, "Share of the curvature, 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
    command->add_option("--radius", viewshed.Radius, "Of the planet, metres")
      ->check(CLI::PositiveNumber);
  }

  CLI::App App;
  RasterOptions Raster;
  LightOptions Light;
  SightOptions Sight;
  ViewshedOptions Viewshed;
  std::function<void()> Chosen;
};

int Run(int argc, char** argv)
{
  CommandLine line;
  int status = 0;
  if (!line.Parse(argc, argv, status))
  {
    return status;
  }
  EndOnSignals("terrain-analyze: stopped on request\n");
  vtkObject::GlobalWarningDisplayOff();
  line.Run();
  return 0;
}
}

int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "terrain-analyze: %s\n", error.what());
    return 1;
  }
}
