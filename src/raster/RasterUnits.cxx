// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterUnits.h"

#include "core/grid/HeightUnits.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>

namespace terrain
{
namespace
{
// Two sizes of one unit, such as the foot and the survey foot, that nobody tells apart by name.
constexpr double kSameUnit = 1e-5;

bool Contains(const std::string& text, std::initializer_list<const char*> words)
{
  const std::string lower = LowerCase(text);
  return std::any_of(words.begin(), words.end(),
    [&lower](const char* word) { return lower.find(word) != std::string::npos; });
}

/// True for no unit, and for words that formats put in the place of one.
bool SaysNothing(const std::string& unit)
{
  return IsOneOf(LowerCase(unit),
    { "", "-", "--", "?", "unspecified", "unknown", "undefined", "none", "null", "n/a", "na" });
}

/// Names of the unit of a geopotential, which is a height times the standard gravity.
bool IsGeopotential(const std::string& unit)
{
  std::string name = LowerCase(unit);
  name.erase(std::remove_if(name.begin(), name.end(),
               [](char c) { return c == ' ' || c == '*' || c == '^' || c == '(' || c == ')'; }),
    name.end());
  return IsOneOf(name, { "m2s-2", "m2/s2", "m2.s-2", "jkg-1", "j/kg" });
}

struct Unit
{
  double Metres = 1.0;
  std::string Name;
};

/// By the band, against the vertical axis of the CRS.
Unit UnitOfBand(const HeightFacts& facts, RasterRecord& record)
{
  if (IsGeopotential(facts.BandUnit))
  {
    constexpr double kGravity = 9.80665; // metres a second squared: the 3rd CGPM, 1901
    record.Take("height unit", facts.BandUnit + ", a geopotential over 9.80665 m/s2", "band");
    return { 1.0 / kGravity, facts.BandUnit };
  }
  const bool axisSays = facts.VerticalMetres > 0.0;
  const bool isAxisName = axisSays && facts.BandUnit == facts.VerticalUnit;
  const double byName = isAxisName ? facts.VerticalMetres : MetresOfUnit(facts.BandUnit);
  if (byName <= 0.0)
  {
    record.Warn("its heights are in '" + facts.BandUnit +
      "', which is no unit of length that is known: they are taken for " +
      (axisSays ? facts.VerticalUnit + ", as its CRS says" : "metres") +
      " (--height-unit names the unit)");
    record.Take(
      "height unit", axisSays ? facts.VerticalUnit : "metre", axisSays ? "CRS" : "assumed");
    return { axisSays ? facts.VerticalMetres : 1.0, facts.BandUnit };
  }
  if (axisSays && std::abs(byName / facts.VerticalMetres - 1.0) > kSameUnit)
  {
    record.Warn("its band says that heights are in '" + facts.BandUnit +
      "', its CRS that they are in '" + facts.VerticalUnit +
      "': taken as the CRS says (--height-unit " +
      (MetresOfUnit(facts.BandUnit) == 1.0 ? "m" : facts.BandUnit) + " follows the band)");
    record.Take("height unit", facts.VerticalUnit, "CRS, against the band");
    return { facts.VerticalMetres, facts.VerticalUnit };
  }
  record.Take("height unit",
    facts.BandUnit + ", " + NumberText(axisSays ? facts.VerticalMetres : byName) + " m",
    isAxisName ? "band and CRS" : "band");
  return { axisSays ? facts.VerticalMetres : byName, facts.BandUnit };
}

Unit FindUnit(const HeightFacts& facts, RasterRecord& record)
{
  if (!SaysNothing(facts.BandUnit))
  {
    return UnitOfBand(facts, record);
  }
  if (facts.VerticalMetres > 0.0)
  {
    record.Take("height unit", facts.VerticalUnit + ", " + NumberText(facts.VerticalMetres) + " m",
      "vertical axis of the CRS");
    return { facts.VerticalMetres, facts.VerticalUnit };
  }
  const bool isFootGrid = facts.HorizontalMetres > 0.29 && facts.HorizontalMetres < 0.32;
  if (isFootGrid)
  {
    record.Warn("its heights name no unit and its x and y are in '" + facts.HorizontalUnit +
      "': the heights are taken for that too (--height-unit m if they are metres)");
    record.Take("height unit",
      facts.HorizontalUnit + ", " + NumberText(facts.HorizontalMetres) + " m",
      "guessed: unit of x and y");
    return { facts.HorizontalMetres, facts.HorizontalUnit };
  }
  record.Take("height unit", "metre", "assumed: the file names none");
  return {};
}

bool NamesDepth(const HeightFacts& facts)
{
  const auto names = [](const std::string& text)
  {
    return Contains(
             text, { "depth", "bathymetry", "bathymetrie", "tiefe", "profondeur", "sounding" }) &&
      !Contains(text, { "elevation", "height", "altitude" });
  };
  return names(facts.Description) || names(facts.Variable) || names(facts.LongName) ||
    names(facts.StandardName);
}

bool NamesHeight(const HeightFacts& facts)
{
  return Contains(facts.Description, { "elevation", "height", "altitude" }) ||
    Contains(facts.Variable, { "elevation", "height", "altitude" });
}

/// True if what was looked at lies below 0 as a whole.
bool IsBelowZero(const HeightFacts& facts)
{
  return facts.Low <= facts.High && facts.High <= 0.0 && facts.Low < 0.0;
}

bool IsMostlyAboveZero(const HeightFacts& facts)
{
  return facts.Low <= facts.High && facts.High > 0.0 && facts.High > -facts.Low;
}

bool TakeSense(RasterRecord& record, bool isDown, const std::string& source)
{
  record.Take("sense", isDown ? "depths, positive down" : "heights, positive up", source);
  return isDown;
}

bool SenseOfAxis(const HeightFacts& facts, RasterRecord& record)
{
  if (facts.Driver == "BAG") // whose elevations are up by definition, whatever axis it writes
  {
    return TakeSense(record, false, "format BAG");
  }
  const bool contradicts = NamesHeight(facts) || IsBelowZero(facts);
  const bool isDown = !contradicts;
  if (contradicts)
  {
    record.Warn(std::string("the vertical axis of its CRS points down, but ") +
      (NamesHeight(facts) ? "its band is called a height"
                          : "its values are below 0 as heights of a sea floor are") +
      ": they are taken for heights, positive up (--height-unit -1 for depths in metres)");
  }
  return TakeSense(record, isDown, "vertical axis of the CRS");
}

/// True if heights count down.
bool FindSense(const HeightFacts& facts, RasterRecord& record)
{
  const std::string positive = LowerCase(facts.Positive);
  if (positive == "down" || positive == "up")
  {
    if (positive == "down" && IsBelowZero(facts))
    {
      record.Warn(
        "it says positive: down, but all its values are below 0; they are turned as it says "
        "(--height-unit 1 if they are heights in metres)");
    }
    return TakeSense(record, positive == "down", "attribute positive");
  }
  if (!facts.StandardName.empty() &&
    Contains(facts.StandardName, { "depth", "altitude", "height" }))
  {
    const bool isDown = NamesDepth(facts) && !IsBelowZero(facts);
    return TakeSense(record, isDown, "standard name " + facts.StandardName);
  }
  if (facts.IsVerticalDown)
  {
    return SenseOfAxis(facts, record);
  }
  if (facts.Driver == "S102")
  {
    return TakeSense(record, LowerCase(facts.Description) == "depth", "format S-102");
  }
  if (NamesDepth(facts) && !NamesHeight(facts) && IsMostlyAboveZero(facts))
  {
    record.Warn(
      "it is called a depth and lies above 0, or reaches farther above than below: taken for "
      "depths, positive down "
      "(--height-unit 1 if they are heights in metres)");
    return TakeSense(record, true, "guessed: its name");
  }
  if (NamesDepth(facts) && !NamesHeight(facts) && facts.Low < 0.0 && facts.High > 0.0)
  {
    record.Warn("it is called a depth and has values below and above 0: taken for heights, "
                "positive up (--height-unit -1 if they are depths in metres)");
  }
  return TakeSense(record, false, "assumed");
}
}

//------------------------------------------------------------------------------
HeightMeaning FindHeightMeaning(const HeightFacts& facts, RasterRecord& record)
{
  if (!facts.Option.empty())
  {
    HeightMeaning meaning;
    bool isNumber = false;
    if (!HeightFactorFromText(facts.Option, meaning.Factor, isNumber))
    {
      throw RasterError("the unit of heights '" + facts.Option +
        "' is neither a known unit (m, ft, us-ft, fathom, ...) nor metres per unit (0.3048, -1 for "
        "depths)");
    }
    meaning.Unit = facts.Option;
    record.Take("height unit", facts.Option, "given");
    if (!isNumber && facts.Option.front() != '-')
    {
      meaning.Factor *= FindSense(facts, record) ? -1.0 : 1.0;
    }
    else
    {
      TakeSense(record, meaning.Factor < 0.0, "given");
    }
    return meaning;
  }
  const Unit unit = FindUnit(facts, record);
  return { unit.Metres * (FindSense(facts, record) ? -1.0 : 1.0), 0.0, unit.Name };
}
}
