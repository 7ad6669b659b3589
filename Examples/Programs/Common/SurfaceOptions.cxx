// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "ColorName.h"
#include "LightOptions.h"

#include <vtkOpenGLTerrainMapper.h>
#include <vtkTerrainActor.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace
{
constexpr double kLeast = 1e-3;
constexpr double kMost = 1e6;
constexpr double kContourWidth = 1.5;

/// The layers of a text; none if it is wrong.
std::vector<Stratum> ParseStrata(const std::string& text)
{
  std::vector<Stratum> strata;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string layer = text.substr(begin, end - begin);
    const std::size_t sign = layer.find('=');
    const std::optional<RGB> color = ParseColor(layer.substr(0, sign));
    Stratum stratum;
    const bool isLast = end == text.size();
    const bool hasThickness = sign != std::string::npos &&
      CLI::detail::lexical_cast(layer.substr(sign + 1), stratum.Thickness) &&
      stratum.Thickness >= kLeast && stratum.Thickness <= kMost;
    if (!color || (sign == std::string::npos ? !isLast : !hasThickness))
    {
      return {};
    }
    stratum.Color = *color;
    strata.push_back(stratum);
    begin = end + 1;
  }
  return strata;
}

std::string WhyNoStrata(const std::string& text)
{
  return ParseStrata(text).empty() ? "'" + text +
      "' is not COLOUR=METRES,COLOUR=METRES,COLOUR: layers from the surface down, the last one "
      "without a thickness if it fills the rest"
                                   : std::string();
}
}

//------------------------------------------------------------------------------
void SurfaceOptions::Declare(CLI::App& app)
{
  app.add_option("--contours", this->Contours, "contour lines so many metres apart")
    ->type_name("INTERVAL")
    ->check(CLI::Range(kLeast, kMost).description(""));
  app
    .add_option("--contour-index", this->ContourIndex,
      "every n-th contour line is twice as wide; default 5, 0 for none")
    ->type_name("N")
    ->check(CLI::Range(0, 1000).description(""));
  app.add_flag("--hillshade", this->Hillshade,
    "shade as on maps, from the north-west, in place of sun and lights");
  app
    .add_option(
      "--block", this->Block, "a solid block down to so many metres below the lowest height")
    ->type_name("DEPTH")
    ->check(CLI::Range(kLeast, kMost).description(""));
  app
    .add_option("--strata", this->Strata,
      "layers on the sides of the block, from the surface down: sienna=200,tan=350,grey")
    ->type_name("COLOUR=METRES,...,COLOUR")
    ->check(CLI::Validator(WhyNoStrata, ""));
}

//------------------------------------------------------------------------------
std::vector<Stratum> SurfaceOptions::GetStrata() const
{
  return this->Strata.empty() ? std::vector<Stratum>() : ParseStrata(this->Strata);
}

//------------------------------------------------------------------------------
void SurfaceOptions::CheckStrata() const
{
  if (!this->Strata.empty() && this->Block <= 0.0)
  {
    throw CLI::ValidationError("--strata", "are on the sides of a block: give --block DEPTH, too");
  }
}

//------------------------------------------------------------------------------
void SurfaceOptions::CheckLight(const LightOptions& light) const
{
  if (this->Hillshade && (light.Shadows || light.SkyLight > 0.0 || !light.Sun.empty()))
  {
    throw CLI::ValidationError(
      "--hillshade", "has no sun and no lights: leave out --sun, --shadows and --sky-light");
  }
}

//------------------------------------------------------------------------------
void SurfaceOptions::Apply(vtkTerrainActor* terrain, double lowest, double pixels) const
{
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  mapper->SetContours(this->Contours > 0.0);
  if (this->Contours > 0.0)
  {
    mapper->SetContourInterval(this->Contours);
    mapper->SetContourIndex(this->ContourIndex);
    mapper->SetContourWidth(kContourWidth * pixels);
  }
  mapper->SetHillshade(this->Hillshade);
  mapper->SetBlock(this->Block > 0.0);
  mapper->SetBlockBase(lowest - this->Block);
}
