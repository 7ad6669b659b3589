// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/LatticeNoise.h"
#include "core/ProceduralTerrain.h"

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

// Ranges of three rows, the last first.
void BackwardFor(std::int64_t count, const terrain::RangeBody& body)
{
  for (std::int64_t end = count; end > 0; end -= 3)
  {
    body(std::max<std::int64_t>(end - 3, 0), end);
  }
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
  landscape.Sample(0, 0, 64, 50, heights.data(), BackwardFor);
  EXPECT_EQ(heights, SampleWhole(parameters));
}

// If this fails on another machine while the others pass, its arithmetic is not IEEE 754's or is
// contracted. It has to change whenever the landscape does.
TEST(ProceduralTerrain, HasTheSameBitsEverywhere)
{
  EXPECT_EQ(HashBits(SampleWhole(MakeParameters(160, 100))), 104333172U);
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
  const std::vector<float> coarse = SampleWhole(MakeParameters(129, 129));
  const std::vector<float> fine = SampleWhole(MakeParameters(257, 257));
  double difference = 0.0;
  for (std::size_t j = 0; j < 129; ++j)
  {
    for (std::size_t i = 0; i < 129; ++i)
    {
      difference += std::fabs(
        static_cast<double>(coarse[i + 129 * j]) - static_cast<double>(fine[2 * i + 514 * j]));
    }
  }
  EXPECT_LT(difference / (129.0 * 129.0), 0.04 * 2500.0);
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
