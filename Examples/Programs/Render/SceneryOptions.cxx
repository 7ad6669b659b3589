// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneryOptions.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace
{
const char* const kSky = "sky";
const char* const kTransparent = "transparent";
const char* const kAround = "Around the terrain";
constexpr RGB kUsualLow = { 0.90, 0.93, 0.95 };
constexpr RGB kUsualHigh = { 0.50, 0.66, 0.84 };

/// The colours of a text; none if it has no one or two.
std::optional<std::array<RGB, 2>> ParseColors(const std::string& text)
{
  const std::size_t comma = text.find(',');
  const std::optional<RGB> low = ParseColor(text.substr(0, comma));
  const std::optional<RGB> high =
    comma == std::string::npos ? low : ParseColor(text.substr(comma + 1));
  return low && high ? std::optional(std::array<RGB, 2>{ *low, *high }) : std::nullopt;
}

std::string WhyNoBackground(const std::string& text)
{
  return text == kSky || text == kTransparent || ParseColors(text) ? std::string()
                                                                   : "'" + text +
      "' is neither a colour (#rrggbb or a name of CSS), two of them with a comma, sky nor "
      "transparent";
}

std::string WhyNoLevel(const std::string& text)
{
  double level = 0.0;
  return CLI::detail::lexical_cast(text, level) && std::isfinite(level)
    ? std::string()
    : "'" + text + "' is not a finite number";
}
}

//------------------------------------------------------------------------------
void SceneryOptions::Declare(CLI::App& app)
{
  app
    .add_option("--background", this->Background,
      "a colour, #rrggbb or a name of CSS; two for the lower and the upper border; sky; or "
      "transparent")
    ->type_name("COLOUR[,COLOUR]|sky|transparent")
    ->group(kAround)
    ->check(CLI::Validator(WhyNoBackground, ""));
  app.add_option("--water", this->Water, "a plane of water at a height in metres")
    ->type_name("LEVEL")
    ->group(kAround)
    ->check(CLI::Validator(WhyNoLevel, ""));
  app.add_option("--fog", this->Fog, "fog: so many metres away half of a colour is left")
    ->type_name("METRES")
    ->group(kAround)
    ->check(CLI::Range(1e-3, 1e9).description(""));
}

//------------------------------------------------------------------------------
bool SceneryOptions::IsSky() const
{
  return this->Background == kSky;
}

//------------------------------------------------------------------------------
bool SceneryOptions::IsTransparent() const
{
  return this->Background == kTransparent;
}

//------------------------------------------------------------------------------
std::array<RGB, 2> SceneryOptions::GetColors() const
{
  const std::array<RGB, 2> usual = { kUsualLow, kUsualHigh };
  return ParseColors(this->Background).value_or(usual);
}
