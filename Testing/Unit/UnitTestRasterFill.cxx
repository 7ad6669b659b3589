// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Fill values that nobody declares, among heights of many kinds.
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
}
