// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeightOptions.h"

#include "vtkTerrainGeoreference.h"
#include "vtkTerrainRasterReader.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace
{
/// Empty, or why a text is no number.
std::string WhyNoNumber(const std::string& text)
{
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) && std::isfinite(value)
    ? std::string()
    : "'" + text + "' is not a finite number";
}

std::string WhyNoUnit(const std::string& text)
{
  double value = 0.0;
  const bool isNumber =
    CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value != 0.0;
  const std::string name = !text.empty() && text.front() == '-' ? text.substr(1) : text;
  return isNumber || vtkTerrainGeoreference::HeightUnitFromName(name) > 0.0
    ? std::string()
    : "'" + text + "' is neither a unit of length (m, ft, us-ft, fathom, ...) nor metres per unit";
}
}

//------------------------------------------------------------------------------
std::string HeightOptions::WhyNotFile(const std::string& name)
{
  return name.empty() ? "needs the name of a file" : "";
}

//------------------------------------------------------------------------------
void HeightOptions::Declare(CLI::App& app)
{
  const char* const group = "What the file does not say";
  app
    .add_option("--crs", this->CoordinateSystem,
      "of HEIGHTS (EPSG:n, WKT, PROJ), in place of what the file names")
    ->type_name("CRS")
    ->group(group)
    ->check([](const std::string& text)
      { return text.empty() ? std::string("needs a value") : std::string(); });
  app
    .add_option(
      "--band", this->Band, "band of heights, from 1 on; default: the first that is no colour")
    ->type_name("N")
    ->group(group)
    ->check(CLI::Range(1, 65536));
  app
    .add_option("--part", this->Part,
      "part of a file of several: name of the variable or table, or its number from 1 on; of a "
      "folder of far sites the number of one")
    ->type_name("NAME")
    ->group(group);
  app
    .add_option("--nodata", this->NoData,
      "a value that is no height, besides those the file declares; none: take all values that the "
      "file does not declare for heights")
    ->type_name("VALUE")
    ->group(group)
    ->check(
      [](const std::string& text) { return text == "none" ? std::string() : WhyNoNumber(text); });
  app
    .add_option("--height-unit", this->HeightUnit,
      "unit of the heights (m, ft, us-ft, ...; -m for depths), or metres per unit (0.3048; -1 for "
      "depths)")
    ->type_name("UNIT")
    ->group(group)
    ->check(WhyNoUnit);
  app.add_flag("--flip", this->Flip, "the first row lies at the other side than the file says")
    ->group(group);
}

//------------------------------------------------------------------------------
void HeightOptions::Apply(vtkTerrainRasterReader* reader) const
{
  reader->SetCoordinateSystem(this->CoordinateSystem);
  reader->SetBand(this->Band);
  reader->SetPart(this->Part);
  reader->SetHeightUnit(this->HeightUnit);
  reader->SetFlip(this->Flip);
  const bool isGiven = !this->NoData.empty() && this->NoData != "none";
  reader->SetUseNoDataValue(isGiven);
  reader->SetDetectNoData(this->NoData.empty());
  if (isGiven)
  {
    reader->SetNoDataValue(std::stod(this->NoData));
  }
}

//------------------------------------------------------------------------------
std::string HeightOptions::WhyNotOneSite(vtkTerrainRasterReader* reader)
{
  const int count = reader->GetNumberOfSites();
  return count < 2
    ? std::string()
    : "'" + std::string(reader->GetFileName()) + "': its tiles lie at " + std::to_string(count) +
      " sites far from each other: choose one (--part 1 to --part " + std::to_string(count) + ")";
}
