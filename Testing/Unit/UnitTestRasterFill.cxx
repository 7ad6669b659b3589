// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Fill values that nobody declares, among heights of many kinds, and needles that are none.
#include "UnitTestTown.h"

#include "raster/RasterHoles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using terrain::FillFindings;
using terrain::FindFill;

/// Heights of hills between two bounds, every height near to another.
std::vector<double> Hills(double low, double high, std::size_t count, unsigned seed = 7)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(low, high);
  std::vector<double> values(count);
  std::generate(
    values.begin(), values.end(), [&] { return std::round(height(random) * 10.0) / 10.0; });
  return values;
}

void ExpectFill(std::vector<double> heights, std::vector<double> fill, std::size_t count = 50)
{
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double ends[2] = { *low, *high };
  for (const double value : fill)
  {
    heights.insert(heights.end(), count, value);
  }
  std::shuffle(heights.begin(), heights.end(), std::mt19937(3));
  FillFindings found = FindFill(heights);
  std::sort(found.Values.begin(), found.Values.end());
  std::sort(fill.begin(), fill.end());
  EXPECT_EQ(found.Values, fill);
  EXPECT_EQ(found.Low, ends[0]);
  EXPECT_EQ(found.High, ends[1]);
}

TEST(UnitTestRasterFill, UsualValuesAmongHills)
{
  for (const double value : { -9999.0, -999.0, -99999.0, -10000.0, 1e6, 1e20, 32767.0, -32768.0,
         -32767.0, 65535.0, 9999.0, -3.4e28 })
  {
    SCOPED_TRACE(value);
    ExpectFill(Hills(100.0, 600.0, 3000), { value });
  }
}

TEST(UnitTestRasterFill, BothEndsAndSeveralValues)
{
  ExpectFill(Hills(100.0, 600.0, 3000), { -9999.0, 32767.0 });
  ExpectFill(Hills(100.0, 600.0, 3000), { -32768.0, -32767.0, -32766.0 });
}

TEST(UnitTestRasterFill, HeightsAreNoFill)
{
  for (const std::vector<double>& heights :
    { Hills(0.0, 8848.0, 3000), Hills(-11000.0, 8000.0, 5000), Hills(-430.0, -390.0, 500),
      Hills(-5.0, 5.0, 500), Hills(990.0, 1010.0, 500) })
  {
    EXPECT_TRUE(FindFill(heights).Values.empty());
  }
}

TEST(UnitTestRasterFill, RoundHeightsInTheirRangeStay)
{
  std::vector<double> heights = Hills(500.0, 1500.0, 3000);
  heights.insert(heights.end(), 400, 999.0); // a lake
  EXPECT_TRUE(FindFill(heights).Values.empty());
}

TEST(UnitTestRasterFill, APlainWithOneSummitIsNotFilled)
{
  std::vector<double> heights = Hills(10.0, 12.0, 1000);
  heights.push_back(812.5);
  EXPECT_TRUE(FindFill(heights).Values.empty());
}

TEST(UnitTestRasterFill, WhatIsNoNumberIsLeftOut)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> heights = Hills(100.0, 600.0, 100);
  heights.insert(heights.end(), { nan, HUGE_VAL, -HUGE_VAL, -3.4e38, 1.7e38 });
  const FillFindings found = FindFill(heights);
  EXPECT_TRUE(found.Values.empty());
  EXPECT_GE(found.Low, 100.0);
  EXPECT_LE(found.High, 600.0);
}

TEST(UnitTestRasterFill, FewOrNoValues)
{
  EXPECT_TRUE(FindFill({}).Values.empty());
  EXPECT_GT(FindFill({}).Low, FindFill({}).High);
  EXPECT_TRUE(FindFill({ 1.0, -9999.0 }).Values.empty());
  EXPECT_TRUE(FindFill(std::vector<double>(100, -9999.0)).Values.empty());
  EXPECT_TRUE(FindFill(std::vector<double>(100, std::nan(""))).Values.empty());
}

TEST(UnitTestRasterFill, SharesAndGaps)
{
  std::vector<double> heights(90, 5.0);
  heights.insert(heights.end(), { 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 114.0 });
  const FillFindings found = FindFill(heights);
  EXPECT_DOUBLE_EQ(found.LowShare, 0.9);
  EXPECT_DOUBLE_EQ(found.HighShare, 0.01);
  EXPECT_EQ(found.LevelCount, 11U);
  EXPECT_DOUBLE_EQ(found.WidestGap, 100.0);
  EXPECT_DOUBLE_EQ(found.GapShare, 0.01);
  EXPECT_FALSE(found.IsGapLow);
}

/// A town with a sample a metre, roofs up to 30 m and 38 with chimneys.
class TownWith
{
public:
  /// A square of samples from the middle of the town on, of heights that a function gives.
  template <typename Height>
  TownWith& Square(int side, const Height& height)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        this->Values[kSize * (kMiddle + j) + kMiddle + i] = height(i, j);
      }
    }
    return *this;
  }
  TownWith& One(double height)
  {
    return this->Square(1, [height](int, int) { return height; });
  }
  bool HasNeedles(double cell = 1.0, double perUnit = 1.0) const
  {
    FillFindings findings = FindFill(this->Values);
    terrain::FindLone(this->Values, kSize, findings);
    return terrain::AreNeedles(findings, perUnit, cell);
  }
  const std::vector<double>& GetValues() const
  {
    return this->Values;
  }

private:
  static constexpr int kSize = 250;
  static constexpr int kMiddle = 100;
  std::vector<double> Values = terrain::MakeTown(kSize).Samples;
};

TEST(UnitTestRasterFill, TowersAreNoNeedles)
{
  const auto roof = [](double height)
  { return [height](int i, int j) { return height + 0.1 * (i % 3) + 0.2 * (j % 2); }; };
  EXPECT_FALSE(TownWith().HasNeedles());
  EXPECT_FALSE(TownWith().Square(12, roof(280.0)).HasNeedles());
  EXPECT_FALSE(TownWith().Square(20, roof(928.0)).HasNeedles()); // the tallest there is
  // a block of one height, as models of building blocks have it
  EXPECT_FALSE(TownWith().Square(12, [](int, int) { return 283.0; }).HasNeedles());
  // a spire that one sample shows above the roofs, and a mast
  EXPECT_FALSE(TownWith().One(190.0).HasNeedles());
  EXPECT_FALSE(TownWith().Square(2, roof(420.0)).HasNeedles());
  EXPECT_FALSE(TownWith().Square(12, roof(280.0)).HasNeedles(2.5));
  // in centimetres
  EXPECT_FALSE(TownWith().Square(12, roof(28000.0)).HasNeedles(1.0, 0.01));
}

TEST(UnitTestRasterFill, NeedlesAreFound)
{
  const auto flat = [](double height) { return [height](int, int) { return height; }; };
  EXPECT_TRUE(TownWith().One(400.0).HasNeedles());
  EXPECT_TRUE(TownWith().One(1733.0).HasNeedles());
  EXPECT_TRUE(TownWith().One(-40.0).HasNeedles());
  EXPECT_TRUE(TownWith().Square(12, flat(-40.0)).HasNeedles());
  EXPECT_TRUE(TownWith().Square(12, flat(0.0)).HasNeedles()); // the town stands at 100 m
  EXPECT_TRUE(TownWith().Square(12, flat(255.0)).HasNeedles());
  EXPECT_TRUE(TownWith().Square(12, flat(500.0)).HasNeedles());
  EXPECT_TRUE(TownWith().Square(12, flat(1733.0)).HasNeedles());
  // in cells of open country nothing that is built rises so far
  EXPECT_TRUE(TownWith().Square(2, flat(733.0)).HasNeedles(30.0));
  // heights that are depths rise where the numbers fall
  EXPECT_TRUE(TownWith().Square(12, flat(283.0)).HasNeedles(1.0, -1.0));
  // and what is not far, or not rare, is none
  EXPECT_FALSE(TownWith().One(400.0).HasNeedles(40.0));
  EXPECT_FALSE(TownWith().Square(60, flat(-40.0)).HasNeedles());
}

TEST(UnitTestRasterFill, ZeroFarBelowAllIsAVoid)
{
  const auto withZeros = [](std::vector<double> heights, std::size_t zeros)
  {
    heights.insert(heights.end(), zeros, 0.0);
    return terrain::HasZeroVoids(FindFill(heights));
  };
  EXPECT_TRUE(withZeros(Hills(300.0, 960.0, 3000), 200));
  EXPECT_TRUE(withZeros(Hills(300.0, 960.0, 3000), 3));
  EXPECT_FALSE(withZeros(Hills(300.0, 960.0, 3000), 0));
  EXPECT_FALSE(withZeros(Hills(300.0, 960.0, 3000), 4000)); // told as the most frequent value
  EXPECT_FALSE(withZeros(Hills(1.0, 960.0, 3000), 800));    // the sea before a coast
  EXPECT_FALSE(withZeros(Hills(-50.0, 960.0, 3000), 800));
  EXPECT_FALSE(withZeros({ 100.0, 200.0, 300.0 }, 40)); // steps
}

TEST(UnitTestRasterFill, OneValueFarFromAllOthersIsTold)
{
  const auto withValue = [](double value, std::size_t count)
  {
    std::vector<double> heights = Hills(400.0, 760.0, 3000);
    heights.insert(heights.end(), count, value);
    return terrain::FindAloof(FindFill(heights), 1.0);
  };
  EXPECT_EQ(withValue(-3047.6952, 200), -3047.6952);
  EXPECT_EQ(withValue(-1.0, 200), -1.0);
  EXPECT_EQ(withValue(0.0, 5000), 0.0); // most of it
  EXPECT_EQ(withValue(1200.0, 200), 1200.0);
  EXPECT_TRUE(std::isnan(withValue(1203.5, 200))); // towers
  EXPECT_TRUE(std::isnan(withValue(-1.0, 20)));    // few: AreNeedles()
  EXPECT_TRUE(std::isnan(withValue(300.0, 200)));  // a lake
  EXPECT_TRUE(std::isnan(withValue(390.0, 2000))); // the sea before a coast
}

TEST(UnitTestRasterFill, FillAmongTowersIsFound)
{
  for (const double value : { 32767.0, -9999.0, 1e6, 65535.0, -32768.0 })
  {
    SCOPED_TRACE(value);
    TownWith town;
    town.Square(12, [](int i, int) { return 280.0 + 0.1 * i; });
    town.Square(4, [value](int, int) { return value; });
    EXPECT_EQ(FindFill(town.GetValues()).Values, std::vector<double>{ value });
    EXPECT_FALSE(town.HasNeedles()); // without them
  }
}
}
