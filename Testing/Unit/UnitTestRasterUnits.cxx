// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Units and sense of heights from all that rasters say of them.
#include "raster/RasterUnits.h"

#include "core/grid/HeightUnits.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using terrain::HeightFacts;
using terrain::RasterRecord;

constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

struct Found
{
  double Factor = 0.0;
  std::string Warnings;
};

Found Find(const HeightFacts& facts)
{
  RasterRecord record;
  Found found;
  found.Factor = terrain::FindHeightMeaning(facts, record).Factor;
  for (const std::string& warning : record.GetWarnings())
  {
    found.Warnings += warning + "\n";
  }
  return found;
}

TEST(UnitTestRasterUnits, MetresWhereNobodySaysAnything)
{
  const Found found = Find({});
  EXPECT_EQ(found.Factor, 1.0);
  EXPECT_EQ(found.Warnings, "");
}

TEST(UnitTestRasterUnits, BandsByName)
{
  for (const auto& [name, metres] :
    { std::pair<const char*, double>("m", 1.0), { "metre", 1.0 }, { "Meters", 1.0 },
      { "ft", kFoot }, { "feet", kFoot }, { "US survey foot", kSurveyFoot },
      { "US_survey_foot", kSurveyFoot }, { "US feet", kSurveyFoot }, { "Feet (US)", kSurveyFoot },
      { "us-ft", kSurveyFoot }, { "fathom", 1.8288 }, { "yd", 0.9144 }, { "mm", 1e-3 },
      { "cm", 1e-2 }, { "km", 1000.0 }, { "international feet", kFoot } })
  {
    HeightFacts facts;
    facts.BandUnit = name;
    const Found found = Find(facts);
    EXPECT_NEAR(found.Factor, metres, 1e-9 * metres) << name;
    EXPECT_EQ(found.Warnings, "") << name;
  }
}

// A factor before a name, once, and such that metres are a number.
TEST(UnitTestRasterUnits, FactorsAreFinite)
{
  EXPECT_DOUBLE_EQ(terrain::MetresOfUnit("0.5 km"), 500.0);
  for (const char* name : { "inf metre", "inf kelvin", "1e308 km", "1e999 metre" })
  {
    EXPECT_EQ(terrain::MetresOfUnit(name), 0.0) << name;
  }
  std::string endless;
  for (int k = 0; k < 100000; ++k)
  {
    endless += "1 ";
  }
  EXPECT_EQ(terrain::MetresOfUnit(endless + "parsec"), 0.0);
}

TEST(UnitTestRasterUnits, GeopotentialsAreHeightsTimesGravity)
{
  for (const char* name : { "m**2 s**-2", "m2 s-2", "m^2/s^2", "J/kg" })
  {
    HeightFacts facts;
    facts.BandUnit = name;
    EXPECT_NEAR(9.80665 * Find(facts).Factor, 1.0, 1e-12) << name;
    EXPECT_EQ(Find(facts).Warnings, "");
  }
}

TEST(UnitTestRasterUnits, WordsForNoUnitAreNone)
{
  for (const char* name : { "-", "unspecified", "Unknown", "none" })
  {
    HeightFacts facts;
    facts.BandUnit = name;
    EXPECT_EQ(Find(facts).Warnings, "") << name;
    facts.VerticalMetres = 0.3048;
    facts.VerticalUnit = "foot";
    EXPECT_EQ(Find(facts).Factor, 0.3048) << name;
  }
}

TEST(UnitTestRasterUnits, AnUnknownUnitIsToldWithItsRemedy)
{
  HeightFacts facts;
  facts.BandUnit = "kelvin";
  const Found found = Find(facts);
  EXPECT_EQ(found.Factor, 1.0);
  EXPECT_NE(found.Warnings.find("--height-unit"), std::string::npos);
}

TEST(UnitTestRasterUnits, TheAxisCountsByItsNumber)
{
  HeightFacts facts;
  facts.VerticalUnit = "British foot (1936)";
  facts.VerticalMetres = 0.3048007491;
  EXPECT_DOUBLE_EQ(Find(facts).Factor, 0.3048007491);
  facts.BandUnit = "metre"; // as gdalwarp leaves it
  EXPECT_DOUBLE_EQ(Find(facts).Factor, 0.3048007491);
  EXPECT_NE(Find(facts).Warnings, "");
}

TEST(UnitTestRasterUnits, FeetOfAFootGridAreGuessedAndTold)
{
  HeightFacts facts;
  facts.HorizontalUnit = "US survey foot";
  facts.HorizontalMetres = kSurveyFoot;
  EXPECT_DOUBLE_EQ(Find(facts).Factor, kSurveyFoot);
  EXPECT_NE(Find(facts).Warnings.find("--height-unit m"), std::string::npos);
  facts.BandUnit = "m";
  EXPECT_DOUBLE_EQ(Find(facts).Factor, 1.0);
}

TEST(UnitTestRasterUnits, SenseByEachRoad)
{
  HeightFacts positive;
  positive.Positive = "Down";
  HeightFacts standard;
  standard.StandardName = "sea_floor_depth_below_geoid";
  HeightFacts axis;
  axis.IsVerticalDown = true;
  axis.Low = 3.0;
  axis.High = 900.0;
  HeightFacts named;
  named.Variable = "bathymetry";
  named.Low = 3.0;
  named.High = 900.0;
  for (const HeightFacts& facts : { positive, standard, axis, named })
  {
    EXPECT_EQ(Find(facts).Factor, -1.0);
  }
  // heights of a sea floor, whatever they are called
  axis.Low = named.Low = -900.0;
  axis.High = named.High = -3.0;
  EXPECT_EQ(Find(axis).Factor, 1.0);
  EXPECT_NE(Find(axis).Warnings, "");
  EXPECT_EQ(Find(named).Factor, 1.0);
}

TEST(UnitTestRasterUnits, DepthsOfBothSignsAreTold)
{
  HeightFacts facts;
  facts.Variable = "depth";
  facts.Low = -150.0;
  facts.High = 213.0;
  EXPECT_EQ(Find(facts).Factor, -1.0);
  EXPECT_NE(Find(facts).Warnings.find("farther above than below"), std::string::npos);
  facts.Low = -900.0;
  EXPECT_EQ(Find(facts).Factor, 1.0);
  EXPECT_NE(Find(facts).Warnings.find("--height-unit -1"), std::string::npos);
}

TEST(UnitTestRasterUnits, WhatIsGivenCounts)
{
  HeightFacts facts;
  facts.BandUnit = "ft";
  facts.Positive = "down";
  facts.Option = "m";
  EXPECT_EQ(Find(facts).Factor, -1.0); // a name keeps the file's sense
  facts.Option = "1";
  EXPECT_EQ(Find(facts).Factor, 1.0); // a number says all
  facts.Option = "-ft";
  EXPECT_DOUBLE_EQ(Find(facts).Factor, -kFoot);
  facts.Option = "parsnip";
  EXPECT_THROW(Find(facts), terrain::RasterError);
}
}
