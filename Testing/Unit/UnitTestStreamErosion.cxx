// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/landscape/LatticeNoise.h"
#include "core/landscape/StreamErosion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
constexpr std::int64_t kWidth = 40;
constexpr std::int64_t kHeight = 27;

// Rough ground with a deep pit, under uniform uplift.
terrain::StreamErosion MakeRoughGround()
{
  terrain::StreamErosion erosion(kWidth, kHeight, 0.05, 3);
  for (std::int64_t j = 1; j < kHeight - 1; ++j)
  {
    for (std::int64_t i = 1; i < kWidth - 1; ++i)
    {
      const auto index = static_cast<std::size_t>(i + kWidth * j);
      erosion.Heights[index] = terrain::UnitReal(terrain::LatticeHash(i, j, 11));
      erosion.Uplift[index] = 0.1;
    }
  }
  erosion.Heights[static_cast<std::size_t>(20 + kWidth * 13)] = -5.0;
  return erosion;
}
}

TEST(StreamErosion, LeavesNoPits)
{
  terrain::StreamErosion erosion = MakeRoughGround();
  for (int step = 0; step < 5; ++step)
  {
    erosion.Step(0.2);
    for (std::size_t node = 0; node < erosion.Heights.size(); ++node)
    {
      const auto receiver = static_cast<std::size_t>(erosion.GetReceivers()[node]);
      if (receiver != node)
      {
        EXPECT_GT(erosion.Heights[node], erosion.Heights[receiver]) << node << " step " << step;
      }
    }
  }
}

TEST(StreamErosion, DrainsAllAreaOverTheBorder)
{
  terrain::StreamErosion erosion = MakeRoughGround();
  erosion.Step(0.2);
  double area = 0.0;
  for (std::int64_t j = 0; j < kHeight; ++j)
  {
    for (std::int64_t i = 0; i < kWidth; ++i)
    {
      if (i == 0 || j == 0 || i == kWidth - 1 || j == kHeight - 1)
      {
        area += erosion.GetDrainedAreas()[static_cast<std::size_t>(i + kWidth * j)];
      }
    }
  }
  EXPECT_NEAR(area, 0.05 * 0.05 * kWidth * kHeight, 1e-9);
}

TEST(StreamErosion, KeepsTheBorder)
{
  terrain::StreamErosion erosion = MakeRoughGround();
  erosion.Step(1.0);
  for (std::int64_t i = 0; i < kWidth; ++i)
  {
    EXPECT_EQ(erosion.Heights[static_cast<std::size_t>(i)], 0.0);
    EXPECT_EQ(erosion.Heights[static_cast<std::size_t>(i + kWidth * (kHeight - 1))], 0.0);
  }
}

TEST(StreamErosion, HoldsTheSteepestSlope)
{
  terrain::StreamErosion erosion = MakeRoughGround();
  erosion.Creep = 0.0;
  erosion.SteepestSlope = 0.3;
  erosion.Step(0.2);
  for (std::size_t node = 0; node < erosion.Heights.size(); ++node)
  {
    const std::int32_t receiver = erosion.GetReceivers()[node];
    const std::int64_t difference = std::abs(static_cast<std::int64_t>(node) - receiver);
    const double run = 0.05 * (difference == 1 || difference == kWidth ? 1.0 : std::sqrt(2.0));
    const double rise = erosion.Heights[node] - erosion.Heights[static_cast<std::size_t>(receiver)];
    EXPECT_LE(rise, 0.3 * run * (1.0 + 1e-12)) << node;
  }
}

TEST(StreamErosion, ReachesTheSteadySlopeOfTheStreamPowerLaw)
{
  terrain::StreamErosion erosion = MakeRoughGround();
  erosion.Creep = 0.0;
  erosion.SteepestSlope = 1e9;
  for (int step = 0; step < 400; ++step)
  {
    erosion.Step(0.5);
  }
  // U = K A^(1/2) S along the rivers, but where two go on fighting for a headwater.
  int steady = 0;
  int all = 0;
  for (std::size_t node = 0; node < erosion.Heights.size(); ++node)
  {
    const std::int32_t receiver = erosion.GetReceivers()[node];
    const std::int64_t difference = std::abs(static_cast<std::int64_t>(node) - receiver);
    if (difference == 0)
    {
      continue;
    }
    const double run = 0.05 * (difference == 1 || difference == kWidth ? 1.0 : std::sqrt(2.0));
    const double slope =
      (erosion.Heights[node] - erosion.Heights[static_cast<std::size_t>(receiver)]) / run;
    const double rate = std::sqrt(erosion.GetDrainedAreas()[node]) * slope;
    steady += std::fabs(rate - 0.1) < 1e-4 ? 1 : 0;
    ++all;
  }
  EXPECT_GT(steady, 0.95 * all);
}

TEST(StreamErosion, SmallestGridIsLegal)
{
  terrain::StreamErosion erosion(3, 3, 1.0, 0);
  erosion.Uplift[4] = 1.0;
  erosion.Step(1.0);
  EXPECT_GT(erosion.Heights[4], 0.0);
  EXPECT_TRUE(std::isfinite(erosion.Heights[4]));
}
