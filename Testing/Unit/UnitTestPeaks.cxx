// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/Peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace
{
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Whatever a flood from a sample reaches over samples not lower than a level.
std::vector<bool> Flood(
  const std::vector<double>& heights, std::size_t width, std::size_t from, double level)
{
  std::vector<bool> isReached(heights.size(), false);
  std::vector<std::size_t> next = { from };
  isReached[from] = true;
  const auto rows = static_cast<long>(heights.size() / width);
  while (!next.empty())
  {
    const std::size_t at = next.back();
    next.pop_back();
    for (int k = 0; k < 9; ++k)
    {
      const long i = static_cast<long>(at % width) + k % 3 - 1;
      const long j = static_cast<long>(at / width) + k / 3 - 1;
      if (i < 0 || j < 0 || i >= static_cast<long>(width) || j >= rows)
      {
        continue;
      }
      const auto there = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
      if (!isReached[there] && heights[there] >= level)
      {
        isReached[there] = true;
        next.push_back(there);
      }
    }
  }
  return isReached;
}

/// By definition: the highest level at which a flood from the sample reaches something above it
/// (higher, or alike and before it); the sample's height itself if a neighbour is above it.
double BruteProminence(const std::vector<double>& heights, std::size_t width, std::size_t sample)
{
  std::vector<double> levels;
  std::copy_if(heights.begin(), heights.end(), std::back_inserter(levels),
    [&](double height) { return height <= heights[sample]; });
  std::sort(levels.rbegin(), levels.rend());
  double lowest = heights[sample];
  for (const double level : levels)
  {
    const std::vector<bool> isReached = Flood(heights, width, sample, level);
    for (std::size_t k = 0; k < heights.size(); ++k)
    {
      if (isReached[k] &&
        (heights[k] > heights[sample] || (heights[k] == heights[sample] && k < sample)))
      {
        return heights[sample] - level;
      }
      lowest = isReached[k] ? std::min(lowest, heights[k]) : lowest;
    }
  }
  return heights[sample] - lowest;
}

bool IsInside(const std::vector<double>& heights, std::size_t width, std::size_t sample)
{
  const std::size_t i = sample % width;
  const std::size_t j = sample / width;
  if (i == 0 || j == 0 || i + 1 == width || j + 1 == heights.size() / width)
  {
    return false;
  }
  for (int k = 0; k < 9; ++k)
  {
    if (std::isnan(heights[(j + k / 3 - 1) * width + i + k % 3 - 1]))
    {
      return false;
    }
  }
  return true;
}

void CompareWithBruteForce(const std::vector<double>& heights, std::size_t width)
{
  std::map<std::size_t, double> expected;
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    if (IsInside(heights, width, k))
    {
      // a summit: whatever a flood at its own height reaches is neither higher nor before it
      const std::vector<bool> isReached = Flood(heights, width, k, heights[k]);
      bool isSummit = true;
      for (std::size_t other = 0; other < heights.size(); ++other)
      {
        isSummit = isSummit && !(isReached[other] && (heights[other] > heights[k] || other < k));
      }
      if (isSummit)
      {
        expected[k] = BruteProminence(heights, width, k);
      }
    }
  }
  double last = std::numeric_limits<double>::infinity();
  for (const terrain::Peak& peak : terrain::FindPeaks(heights, width))
  {
    const std::size_t sample = peak.Row * width + peak.Column;
    EXPECT_EQ(peak.Height, heights[sample]);
    EXPECT_LE(peak.Prominence, last);
    last = peak.Prominence;
    ASSERT_EQ(expected.count(sample), 1U) << peak.Column << ", " << peak.Row;
    EXPECT_DOUBLE_EQ(peak.Prominence, expected[sample]);
    expected.erase(sample);
  }
  EXPECT_TRUE(expected.empty()) << expected.size() << " are missing";
}
}

TEST(Peaks, AsBruteForceHasThem)
{
  std::mt19937 random(11);
  for (const int levels : { 4, 12, 1000 })
  {
    std::uniform_int_distribution<int> height(0, levels);
    std::vector<double> heights(17 * 13);
    for (double& sample : heights)
    {
      sample = height(random);
    }
    CompareWithBruteForce(heights, 17);
    for (std::size_t k = 5; k < heights.size(); k += 29)
    {
      heights[k] = kNone;
    }
    CompareWithBruteForce(heights, 17);
  }
}

TEST(Peaks, SmoothHillsAndAPass)
{
  // two hills 90 and 60 high on a plain of 10, their pass at 30
  const std::size_t width = 41;
  std::vector<double> heights(width * 21);
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    const double i = static_cast<double>(k % width);
    const double j = std::abs(static_cast<double>(k / width) - 10.0);
    const double along =
      i < 20.0 ? 90.0 - 6.0 * std::abs(i - 10.0) : 60.0 - 3.0 * std::abs(i - 30.0);
    heights[k] = std::max(10.0, along - 8.0 * j);
  }
  const std::vector<terrain::Peak> peaks = terrain::FindPeaks(heights, width);
  ASSERT_GE(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].Column, 10U);
  EXPECT_EQ(peaks[0].Row, 10U);
  EXPECT_EQ(peaks[0].Prominence, 80.0);
  EXPECT_EQ(peaks[1].Column, 30U);
  EXPECT_EQ(peaks[1].Prominence, 30.0);
  CompareWithBruteForce(heights, width);
}

TEST(Peaks, Degenerate)
{
  EXPECT_TRUE(terrain::FindPeaks({}, 0).empty());
  EXPECT_TRUE(terrain::FindPeaks({ 1.0 }, 1).empty());
  EXPECT_TRUE(terrain::FindPeaks({ kNone, kNone, kNone, kNone }, 2).empty());
  // a slope has its highest sample at the border
  std::vector<double> slope(100);
  for (std::size_t k = 0; k < slope.size(); ++k)
  {
    slope[k] = static_cast<double>(k % 10);
  }
  EXPECT_TRUE(terrain::FindPeaks(slope, 10).empty());
  // a plain has none either: all of it is one summit, whose first sample lies at the border
  EXPECT_TRUE(terrain::FindPeaks(std::vector<double>(100, 5.0), 10).empty());
}
