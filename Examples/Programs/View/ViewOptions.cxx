// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOptions.h"

#include "vtkTerrainGeoreference.h"
#include "vtkTerrainViewpoint.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>
#include <sstream>

//------------------------------------------------------------------------------
void ViewOptions::Declare(CLI::App& app)
{
  app
    .add_option("--camera", this->Camera,
      "eye, focal point and up in world coordinates, z exaggerated: EX,EY,EZ,FX,FY,FZ[,UX,UY,UZ]")
    ->type_name("NUMBERS")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        ViewOptions options;
        options.Camera = text;
        return options.GetCamera().empty() ? "'" + text + "' is not 6 or 9 numbers with commas"
                                           : std::string();
      },
      ""));
  const CLI::Validator isPlace(&vtkTerrainViewpoint::GetWhyNoPlace, "");
  app
    .add_option("--look-from", this->LookFrom,
      "place of the eye: LON,LAT,HEIGHT in metres, or metres above the ground with agl behind them")
    ->type_name("PLACE")
    ->check(isPlace);
  app
    .add_option(
      "--look-at", this->LookAt, "place that the eye looks at; without a height on the ground")
    ->type_name("PLACE")
    ->check(isPlace);
  app.add_option("--view-angle", this->Angle, "vertical field of view, in degrees; default 30")
    ->type_name("DEGREES")
    ->check(CLI::Range(0.01, 170.0).description(""));
  app
    .add_option("--technique", this->Technique,
      "how the surface is found: pyramid (default, exact), equidistant, exponential, linear, "
      "strips, mesh")
    ->type_name("NAME")
    ->check(CLI::IsMember({ "mesh", "linear", "exponential", "equidistant", "pyramid", "strips" })
              .description(""));
}

//------------------------------------------------------------------------------
void ViewOptions::Check() const
{
  if (this->LookFrom.empty() != this->LookAt.empty())
  {
    throw CLI::ValidationError(this->LookFrom.empty() ? "--look-at" : "--look-from",
      "--look-from and --look-at need each other");
  }
  if (!this->Camera.empty() && !this->LookFrom.empty())
  {
    throw CLI::ValidationError("--look-from", "--camera says where the eye is already");
  }
}

//------------------------------------------------------------------------------
std::vector<double> ViewOptions::GetCamera() const
{
  std::vector<double> numbers;
  std::istringstream text(this->Camera);
  for (std::string part; std::getline(text, part, ',');)
  {
    double number = 0.0;
    if (!CLI::detail::lexical_cast(part, number) || !std::isfinite(number))
    {
      return {};
    }
    numbers.push_back(number);
  }
  return numbers.size() == 6 || numbers.size() == 9 ? numbers : std::vector<double>();
}

//------------------------------------------------------------------------------
PlaceText ReadPlace(const std::string& text)
{
  PlaceText read;
  std::array<double, 3> place{};
  if (vtkTerrainGeoreference::PlaceFromText(text, place.data()).empty())
  {
    read.Place = { place[0], place[1] };
    return read;
  }
  const std::size_t comma = text.rfind(',');
  vtkTerrainGeoreference::PlaceFromText(text.substr(0, comma), place.data());
  read.Place = { place[0], place[1] };
  const std::string height = text.substr(comma + 1);
  read.Height = std::strtod(height.c_str(), nullptr);
  read.IsAboveGround = height.find("agl") != std::string::npos;
  return read;
}
