// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrackOptions.h"

#include <CLI/CLI.hpp>

namespace
{
const char* const kTracks = "Tracks";

/// "30m" or "4"; 0 for all other text.
double ReadWidth(const std::string& text, bool& isMetres)
{
  isMetres = !text.empty() && text.back() == 'm';
  double width = 0.0;
  const bool isNumber =
    CLI::detail::lexical_cast(text.substr(0, text.size() - (isMetres ? 1 : 0)), width);
  return isNumber && width > 0.0 && width <= 1e6 ? width : 0.0;
}

std::string WhyNoWidth(const std::string& text)
{
  bool isMetres = false;
  const double width = ReadWidth(text, isMetres);
  return width > 0.0 && (isMetres || width <= 100.0)
    ? std::string()
    : "'" + text + "' is neither a width in pixels (up to 100) nor in metres, such as 30m";
}
}

//------------------------------------------------------------------------------
void TrackOptions::Declare(CLI::App& app)
{
  this->DeclareField(app, "--track", "; height: that of each point", kTracks);
  app
    .add_option("--track-width", this->Width,
      "of lines in pixels of a picture 720 pixels high, default 3; or of tubes in metres: 30m")
    ->type_name("PIXELS|METRESm")
    ->group(kTracks)
    ->check(CLI::Validator(WhyNoWidth, ""));
}

//------------------------------------------------------------------------------
void TrackOptions::Check(bool hasTracks) const
{
  for (const auto& [option, text] : { std::pair("--track-color-by", this->ColorBy),
         std::pair("--track-colors", this->Colors), std::pair("--track-width", this->Width) })
  {
    if (!text.empty() && !hasTracks)
    {
      throw CLI::ValidationError(option, "there is no track: give --track FILE, too");
    }
  }
  this->CheckField();
}

//------------------------------------------------------------------------------
double TrackOptions::GetMetres() const
{
  bool isMetres = false;
  const double width = ReadWidth(this->Width, isMetres);
  return isMetres ? width : 0.0;
}

//------------------------------------------------------------------------------
double TrackOptions::GetPixels(double usual) const
{
  bool isMetres = false;
  const double width = ReadWidth(this->Width, isMetres);
  return width > 0.0 && !isMetres ? width : usual;
}
