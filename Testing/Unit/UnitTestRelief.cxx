// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/Relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

TEST(Relief, LeavesOutSpikesAndHoles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> heights(100.0, 600.0);
  std::vector<double> samples(5001);
  std::generate(samples.begin(), samples.end(), [&] { return heights(random); });
  std::vector<double> sorted = samples;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_DOUBLE_EQ(terrain::ReliefOf(samples), sorted[4900] - sorted[100]);
  for (int k = 0; k < 40; ++k)
  {
    samples.push_back(k % 2 == 0 ? 1e9 : -1e9);
    samples.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_NEAR(terrain::ReliefOf(samples), 480.0, 10.0);
  std::vector<double> one = { 3.0 };
  EXPECT_EQ(terrain::ReliefOf(one), 0.0);
  std::vector<double> none;
  EXPECT_EQ(terrain::ReliefOf(none), 0.0);
}

TEST(Relief, SuggestsRoundFactors)
{
  // relief and extent in metres: mountains, a country of hills, a continent, a spire
  EXPECT_EQ(terrain::SuggestExaggeration(2000.0, 15000.0), 1.0);
  EXPECT_EQ(terrain::SuggestExaggeration(3000.0, 500000.0), 5.0);
  EXPECT_EQ(terrain::SuggestExaggeration(2500.0, 4e6), 20.0);
  EXPECT_EQ(terrain::SuggestExaggeration(1000.0, 200.0), 0.1);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double odd : { 0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_EQ(terrain::SuggestExaggeration(odd, 1.0), 1.0);
    EXPECT_EQ(terrain::SuggestExaggeration(1.0, odd), 1.0);
  }
}

TEST(Relief, ScalesOfSlopesEndWhereFewAreSteeper)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> gentle(0.0, 33.0);
  std::vector<double> slopes(5000);
  std::generate(slopes.begin(), slopes.end(), [&] { return gentle(random); });
  EXPECT_EQ(terrain::SuggestSteepest(slopes), 35.0);
  slopes.insert(slopes.end(), 90, 80.0); // less than 2 % are cliffs
  slopes.insert(slopes.end(), 50, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(terrain::SuggestSteepest(slopes), 35.0);
  slopes.insert(slopes.end(), 200, 80.0);
  EXPECT_EQ(terrain::SuggestSteepest(slopes), 80.0);
  for (const auto& [slope, end] : { std::pair(0.0, 0.1), std::pair(0.15, 0.2), std::pair(1.3, 2.0),
         std::pair(4.0, 5.0), std::pair(89.9, 90.0) })
  {
    std::vector<double> plane(9, slope);
    EXPECT_EQ(terrain::SuggestSteepest(plane), end);
  }
  std::vector<double> none(3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(terrain::SuggestSteepest(none), 60.0);
}

TEST(Relief, DrawnReliefIsSeen)
{
  double last = 0.0;
  for (double share = 1e-9; share < 1e4; share *= 1.07)
  {
    const double factor = terrain::SuggestExaggeration(share, 1.0);
    EXPECT_GE(factor, 1e-3);
    EXPECT_LE(factor, 1e3);
    const double drawn = share * factor;
    EXPECT_GE(drawn * 1.7, last) << "what is higher is drawn higher, but for rounding";
    last = std::max(last, drawn);
    if (share > 1e-4 && share < 100.0)
    {
      EXPECT_GT(drawn, terrain::kFlattestRelief * 0.4) << share;
      EXPECT_LT(drawn, terrain::kSteepestRelief * 1.3) << share;
    }
  }
}
