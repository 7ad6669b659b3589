// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlaceOptions.h"

#include "Arguments.h"

#include "vtkNew.h"
#include "vtkTerrainGeoid.h"
#include "vtkTerrainViewpoint.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;
using GridType = vtkTerrainGraticule::GridType;
using HeightType = vtkTerrainGeoreference::HeightType;
using ModeType = vtkTerrainDrape::ModeType;

const std::map<std::string, FrameType> kFrames = { { "plane", FrameType::Plane },
  { "local", FrameType::Local }, { "utm", FrameType::Zone }, { "grid", FrameType::Grid },
  { "geocentric", FrameType::Geocentric }, { "globe", FrameType::Globe } };
/// Instead of a frame.
const char* const kMap = "map";

const std::map<std::string, HeightType> kVerticals = { { "as-is", HeightType::AsIs },
  { "ellipsoid", HeightType::Ellipsoid }, { "geoid", HeightType::Geoid } };

const std::map<std::string, ModeType> kTrackModes = { { "clamped", ModeType::Clamped },
  { "agl", ModeType::AboveGround }, { "absolute", ModeType::Absolute } };

const std::map<std::string, GridType> kGraticules = { { "degrees", GridType::Geographic },
  { "utm", GridType::UTM } };

constexpr int kMostZone = 60;

/// Names that an option takes.
template <typename Value>
CLI::CheckedTransformer OneOf(const std::map<std::string, Value>& names)
{
  CLI::CheckedTransformer transformer(names);
  transformer.description("");
  return transformer;
}

std::array<double, 3> ParseOrigin(const std::string& text)
{
  constexpr double kFarthest = 1e7;
  std::vector<double> numbers = ParseNumbers("--origin", text, kFarthest);
  if (numbers.size() == 2)
  {
    numbers.push_back(0.0);
  }
  if (numbers.size() != 3 || std::abs(numbers[0]) > 360.0 || std::abs(numbers[1]) > 90.0)
  {
    Refuse("--origin", "'" + text + "' is not LON,LAT[,HEIGHT] in degrees and metres");
  }
  return { numbers[0], numbers[1], numbers[2] };
}

/// "45N", "19S", "0N": number and hemisphere of a zone.
std::pair<int, bool> ParseZone(const std::string& text)
{
  const char hemisphere = text.empty() ? '\0' : text.back();
  if (hemisphere != 'N' && hemisphere != 'S')
  {
    Refuse("--utm-zone", "'" + text + "' does not end in N or S");
  }
  return { ParseInteger("--utm-zone", text.substr(0, text.size() - 1), 0, kMostZone),
    hemisphere == 'N' };
}

/// Sets the frame that another option stands for, unless --frame names a different one.
void ImplyFrame(PlaceOptions& options, const std::string& option, FrameType frame)
{
  if (options.Frame && *options.Frame != frame)
  {
    Refuse(option, "does not go with the --frame that is given");
  }
  options.Frame = frame;
}

void CheckView(const PlaceOptions& options)
{
  if (options.LookFrom.empty() != options.LookAt.empty())
  {
    Refuse(options.LookFrom.empty() ? "--look-at" : "--look-from",
      "--look-from and --look-at need each other");
  }
  for (const auto& [option, text] :
    { std::pair("--look-from", options.LookFrom), std::pair("--look-at", options.LookAt) })
  {
    const std::string why = text.empty() ? std::string() : vtkTerrainViewpoint::GetWhyNoPlace(text);
    if (!why.empty())
    {
      Refuse(option, why);
    }
  }
}
}

//------------------------------------------------------------------------------
std::string PlaceOptions::GetGeoidFile() const
{
  if (this->Vertical == HeightType::AsIs && this->Geoid.empty())
  {
    return {};
  }
  const vtkNew<vtkTerrainGeoid> geoid;
  if (!this->Geoid.empty())
  {
    geoid->SetModel(this->Geoid);
  }
  return geoid->GetFileName();
}

//------------------------------------------------------------------------------
const char* PlaceOptions::FirstThatNeedsPlaces() const
{
  const std::array<std::pair<const char*, bool>, 7> needs = {
    { { "--look-from", !this->LookFrom.empty() }, { "--sun", this->HasTimeOfSun },
      { "--drape", !this->Drape.empty() }, { "--track", !this->Tracks.empty() },
      { "--polygons", this->HasPolygons }, { "--labels", this->HasLabels },
      { "--graticule", this->Graticule.has_value() } }
  };
  for (const auto& [option, isGiven] : needs)
  {
    if (isGiven)
    {
      return option;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void PlaceArguments::Declare(CLI::App& app, PlaceOptions& options)
{
  const auto add = [&app](const char* name, auto& value, const char* type, const char* help)
  {
    return app.add_option(name, value, help)
      ->type_name(type)
      ->group("Places on earth")
      ->check([](const std::string& text)
        { return text.empty() ? std::string("needs a value") : std::string(); });
  };
  const auto flag = [&app](const char* name, bool& value, const char* help)
  { app.add_flag(name, value, help)->group("Places on earth"); };
  add("--frame", this->Frame, "NAME",
    "scene: grid (of the file, where it is in metres and true to scale: the default there), globe "
    "(of HEIGHTS in degrees, of any planet: the default where they reach over 60, or lie on "
    "another world), plane "
    "(the default elsewhere: flat, east and north at its origin), local (the same, the earth "
    "round), utm, geocentric, map (the default among the flat ones)")
    ->check(CLI::Validator(
      [](const std::string& name)
      {
        return name == kMap || kFrames.count(name) > 0
          ? std::string()
          : "'" + name + "' is none of grid, globe, plane, local, utm, geocentric, map";
      },
      ""));
  flag("--curvature", this->Curvature, "the earth is round: heights sink below the horizon");
  add("--origin", this->Origin, "LON,LAT[,HEIGHT]",
    "of the frames plane and local; default: the middle of HEIGHTS");
  add("--utm-zone", this->Zone, "ZONE", "45N, 19S, 0N for UPS; default: that of the middle");
  add("--cell", this->Cell, "METRES", "distance of samples; default: that of the file");
  flag("--cubic", options.Cubic, "resample by cubic convolution, not bilinearly");
  add("--vertical", options.Vertical, "NAME",
    "heights count from: as-is (default), ellipsoid, geoid (sea level)")
    ->transform(OneOf(kVerticals));
  add("--geoid", options.Geoid, "NAME", "geoid data of GeographicLib; default egm96-5");
  add("--finer", options.Finer, "FILE",
    "heights of a part in finer cells, to which HEIGHTS give way on the globe; may be given more "
    "than once")
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add("--drape", options.Drape, "FILE", "picture of any CRS to lay onto the terrain");
  add("--track", options.Tracks, "FILE",
    "points and lines: GPX, or any vector file GDAL opens; may be given more than once")
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add("--track-mode", options.TrackMode, "NAME",
    "the track lies on the ground: clamped (default), at its heights above it: agl, or at its "
    "own heights: absolute")
    ->transform(OneOf(kTrackModes));
  add("--look-from", options.LookFrom, "LON,LAT,HEIGHT[agl]",
    "place of the eye: metres, or metres above the ground; also MGRS,HEIGHT");
  add("--look-at", options.LookAt, "LON,LAT[,HEIGHT[agl]]",
    "place that the eye looks at; default height: on the ground");
  add("--graticule", options.Graticule, "NAME", "lines of degrees, or of the utm grid")
    ->transform(OneOf(kGraticules));
  flag("--scale-bar", options.ScaleBar, "bar in round units, true at the focal point");
  flag("--north-arrow", options.NorthArrow, "arrow to the north at the focal point");
}

//------------------------------------------------------------------------------
void PlaceArguments::Interpret(PlaceOptions& options) const
{
  options.IsMap = this->Frame == kMap;
  if (!this->Frame.empty() && !options.IsMap)
  {
    options.Frame = kFrames.at(this->Frame);
  }
  if (!this->Zone.empty())
  {
    ImplyFrame(options, "--utm-zone", FrameType::Zone);
    std::tie(options.Zone, options.Northern) = ParseZone(this->Zone);
  }
  if (this->Curvature)
  {
    ImplyFrame(options, "--curvature", FrameType::Local);
  }
  if (!this->Origin.empty())
  {
    options.Origin = ParseOrigin(this->Origin);
    ImplyFrame(
      options, "--origin", options.Frame == FrameType::Local ? FrameType::Local : FrameType::Plane);
  }
  if (!this->Cell.empty())
  {
    options.Cell = ParseNumber("--cell", this->Cell, 1e-3, 1e6);
  }
  CheckView(options);
}
