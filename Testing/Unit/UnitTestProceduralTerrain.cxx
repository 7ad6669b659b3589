// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/landscape/LatticeNoise.h"
#include "core/landscape/ProceduralTerrain.h"

#include "UnitTestFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace
{
terrain::ProceduralTerrainParameters MakeParameters(
  std::int64_t width, std::int64_t height, std::uint32_t seed = 1)
{
  terrain::ProceduralTerrainParameters parameters;
  parameters.Width = width;
  parameters.Height = height;
  parameters.Seed = seed;
  return parameters;
}

std::vector<float> SampleWhole(const terrain::ProceduralTerrainParameters& parameters)
{
  const terrain::ProceduralTerrain landscape(parameters);
  std::vector<float> heights(static_cast<std::size_t>(parameters.Width * parameters.Height));
  landscape.Sample(0, 0, parameters.Width, parameters.Height, heights.data(), terrain::SerialFor);
  return heights;
}

// Fowler-Noll-Vo hash (FNV-1a) of the bits.
std::uint32_t HashBits(const std::vector<float>& values)
{
  std::uint32_t hash = 2166136261U;
  for (const float value : values)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    for (int byte = 0; byte < 4; ++byte)
    {
      hash = (hash ^ ((bits >> (8 * byte)) & 0xffU)) * 16777619U;
    }
  }
  return hash;
}
}

TEST(ProceduralTerrain, DegenerateSizesGiveFiniteHeights)
{
  const std::int64_t sizes[][2] = { { 1, 1 }, { 1, 50 }, { 50, 1 }, { 2, 2 }, { 3, 400 },
    { 900, 2 } };
  for (const auto& size : sizes)
  {
    for (const float height : SampleWhole(MakeParameters(size[0], size[1])))
    {
      EXPECT_TRUE(height >= 0.0F && height <= 2500.0F) << size[0] << " x " << size[1];
    }
  }
}

TEST(ProceduralTerrain, EmptyWindowWritesNothing)
{
  const terrain::ProceduralTerrain landscape(MakeParameters(16, 16));
  float untouched = -1.0F;
  landscape.Sample(3, 3, 0, 5, &untouched, terrain::SerialFor);
  landscape.Sample(3, 3, 5, 0, &untouched, terrain::SerialFor);
  EXPECT_EQ(untouched, -1.0F);
}

TEST(ProceduralTerrain, WindowsEqualThePartsOfTheWhole)
{
  const terrain::ProceduralTerrainParameters parameters = MakeParameters(131, 97);
  const std::vector<float> whole = SampleWhole(parameters);
  const terrain::ProceduralTerrain landscape(parameters);
  const std::int64_t windows[][4] = { { 0, 0, 131, 1 }, { 130, 96, 1, 1 }, { 37, 11, 64, 53 },
    { 0, 48, 66, 49 } };
  for (const auto& window : windows)
  {
    std::vector<float> part(static_cast<std::size_t>(window[2] * window[3]));
    landscape.Sample(window[0], window[1], window[2], window[3], part.data(), terrain::SerialFor);
    for (std::int64_t j = 0; j < window[3]; ++j)
    {
      const float* expected = &whole[static_cast<std::size_t>(window[0] + 131 * (window[1] + j))];
      EXPECT_TRUE(
        std::equal(expected, expected + window[2], &part[static_cast<std::size_t>(window[2] * j)]))
        << "row " << j;
    }
  }
}

TEST(ProceduralTerrain, IsTheSameHoweverTheRowsAreSplit)
{
  const terrain::ProceduralTerrainParameters parameters = MakeParameters(64, 50);
  const terrain::ProceduralTerrain landscape(parameters);
  std::vector<float> heights(3200);
  landscape.Sample(0, 0, 64, 50, heights.data(), terrain::BackwardFor);
  EXPECT_EQ(heights, SampleWhole(parameters));
}

// If this fails on another machine while the others pass, its arithmetic is not IEEE 754's or is
// contracted. It has to change whenever the landscape does.
TEST(ProceduralTerrain, HasTheSameBitsEverywhere)
{
  EXPECT_EQ(HashBits(SampleWhole(MakeParameters(160, 100))), 2306260450U);
}

TEST(ProceduralTerrain, SeedsGiveDifferentLandscapes)
{
  const std::vector<float> first = SampleWhole(MakeParameters(65, 65, 1));
  const std::vector<float> second = SampleWhole(MakeParameters(65, 65, 2));
  double difference = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k)
  {
    difference += std::fabs(static_cast<double>(first[k]) - static_cast<double>(second[k]));
  }
  EXPECT_GT(difference / static_cast<double>(first.size()), 100.0);
}

TEST(ProceduralTerrain, UsesItsRelief)
{
  for (std::uint32_t seed = 0; seed < 6; ++seed)
  {
    const std::vector<float> heights = SampleWhole(MakeParameters(64, 64, seed));
    const auto range = std::minmax_element(heights.begin(), heights.end());
    EXPECT_GT(*range.second - *range.first, 1250.0F) << seed;
  }
}

TEST(ProceduralTerrain, MoreSamplesShowTheSameMountains)
{
  const std::vector<float> coarse = SampleWhole(MakeParameters(65, 65));
  const std::vector<float> fine = SampleWhole(MakeParameters(129, 129));
  double difference = 0.0;
  for (std::size_t j = 0; j < 65; ++j)
  {
    for (std::size_t i = 0; i < 65; ++i)
    {
      difference += std::fabs(
        static_cast<double>(coarse[i + 65 * j]) - static_cast<double>(fine[2 * i + 258 * j]));
    }
  }
  EXPECT_LT(difference / (65.0 * 65.0), 0.04 * 2500.0);
}

TEST(ProceduralTerrain, NoiseStaysWithinItsBound)
{
  const terrain::LatticeAxis axis(-5000, 10000, 0.37, 0.0731);
  std::vector<float> values(10000);
  float largest = 0.0F;
  for (std::int64_t cell = -20; cell < 20; ++cell)
  {
    terrain::NoiseRow(axis, cell, 0.025F * static_cast<float>(cell + 20), 9, values.data());
    for (const float value : values)
    {
      largest = std::max(largest, std::fabs(value));
    }
  }
  EXPECT_LE(largest, 1.0F);
  EXPECT_GT(largest, 0.5F);
}

TEST(ProceduralTerrain, WavesStayWithinTheirBoundAndFollowTheirDirection)
{
  constexpr float kStep = 1e-3F;
  const terrain::LatticeAxis axis(-300, 600, 0.11, 0.05);
  const std::size_t count = axis.Cells.size();
  std::vector<float> values(count);
  std::vector<float> rates(count);
  std::vector<float> further(count);
  std::vector<float> unused(count);
  // Waves that run north: the rate is the change to the north, but for the blending.
  const std::vector<float> acrossX(count, 0.0F);
  const std::vector<float> acrossY(count, 1.0F);
  double error = 0.0;
  double change = 0.0;
  double largest = 0.0;
  for (std::int64_t cell = -5; cell < 5; ++cell)
  {
    terrain::FlowNoiseRow(
      axis, cell, 0.02F, 3, acrossX.data(), acrossY.data(), values.data(), rates.data());
    terrain::FlowNoiseRow(
      axis, cell, 0.02F + kStep, 3, acrossX.data(), acrossY.data(), further.data(), unused.data());
    for (std::size_t k = 0; k < count; ++k)
    {
      EXPECT_LE(std::fabs(values[k]), 1.0F);
      largest = std::max(largest, std::fabs(static_cast<double>(values[k])));
      const double slope = static_cast<double>((further[k] - values[k]) / kStep);
      change += std::fabs(slope);
      error += std::fabs(slope - 6.2832 * static_cast<double>(rates[k]));
    }
  }
  EXPECT_GT(largest, 0.8);
  EXPECT_LT(error, 0.15 * change);
}

TEST(ProceduralTerrain, PeriodicCosineIsNearTheCosine)
{
  for (int k = -300; k < 300; ++k)
  {
    const float x = 0.01F * static_cast<float>(k);
    EXPECT_NEAR(
      terrain::PeriodicCosine(x), std::cos(6.283185307F * x), terrain::kPeriodicCosineError)
      << x;
  }
}

TEST(ProceduralTerrain, RoughnessZeroHasNoGullies)
{
  terrain::ProceduralTerrainParameters parameters = MakeParameters(513, 2);
  const std::vector<float> rough = SampleWhole(parameters);
  parameters.Roughness = 0.0;
  const std::vector<float> smooth = SampleWhole(parameters);
  const auto bend = [](const std::vector<float>& heights)
  {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < 513; ++i)
    {
      sum += std::fabs(static_cast<double>(heights[i - 1]) - 2.0 * static_cast<double>(heights[i]) +
        static_cast<double>(heights[i + 1]));
    }
    return sum;
  };
  EXPECT_GT(bend(rough), 1.2 * bend(smooth));
}
