// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/HeightSampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
terrain::HeightfieldView<double> View(const std::vector<double>& samples, std::int64_t width)
{
  terrain::HeightfieldView<double> view;
  view.Samples = samples.data();
  view.Width = width;
  view.Height = width > 0 ? static_cast<std::int64_t>(samples.size()) / width : 0;
  return view;
}

std::vector<double> SamplesOf(std::int64_t width, std::int64_t height, double (*h)(double, double))
{
  std::vector<double> samples;
  for (std::int64_t j = 0; j < height; ++j)
  {
    for (std::int64_t i = 0; i < width; ++i)
    {
      samples.push_back(h(static_cast<double>(i), static_cast<double>(j)));
    }
  }
  return samples;
}
}

TEST(HeightSampling, BilinearIsThePatch)
{
  const std::vector<double> samples =
    SamplesOf(5, 4, [](double x, double y) { return 3.0 + 2.0 * x - y + 0.5 * x * y; });
  const auto view = View(samples, 5);
  for (double y = 0.0; y <= 3.0; y += 0.125)
  {
    for (double x = 0.0; x <= 4.0; x += 0.125)
    {
      EXPECT_NEAR(terrain::SampleBilinear(view, x, y), 3.0 + 2.0 * x - y + 0.5 * x * y, 1e-12);
    }
  }
}

TEST(HeightSampling, CubicIsExactForQuadratics)
{
  const std::vector<double> samples =
    SamplesOf(8, 7, [](double x, double y) { return x * x - 0.3 * y * y + x * y; });
  const auto view = View(samples, 8);
  for (double y = 1.0; y < 5.0; y += 0.25)
  {
    for (double x = 1.0; x < 6.0; x += 0.25)
    {
      EXPECT_NEAR(terrain::SampleCubic(view, x, y), x * x - 0.3 * y * y + x * y, 1e-12);
    }
  }
  // At the border there are no four neighbours.
  EXPECT_EQ(terrain::SampleCubic(view, 0.5, 0.5), terrain::SampleBilinear(view, 0.5, 0.5));
}

TEST(HeightSampling, BorderAndOutside)
{
  const std::vector<double> samples =
    SamplesOf(3, 3, [](double x, double y) { return x + 10.0 * y; });
  const auto view = View(samples, 3);
  EXPECT_EQ(terrain::SampleBilinear(view, 2.0, 2.0), 22.0);
  EXPECT_EQ(terrain::SampleBilinear(view, 2.0 + 1e-7, -1e-7), 2.0);
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(view, 2.1, 0.0)));
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(view, 0.0, -0.1)));
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(view, std::nan(""), 0.0)));
}

TEST(HeightSampling, NoDataSpreadsOverItsCellsOnly)
{
  std::vector<double> samples = SamplesOf(6, 6, [](double x, double y) { return x + 10.0 * y; });
  samples[2 + 6 * 2] = std::nan("");
  const auto view = View(samples, 6);
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(view, 1.5, 1.5)));
  EXPECT_TRUE(std::isnan(terrain::SampleCubic(view, 2.5, 2.5)));
  EXPECT_EQ(terrain::SampleBilinear(view, 1.0, 1.5), 16.0) << "a neighbour without weight";
  EXPECT_NEAR(terrain::SampleCubic(view, 3.5, 3.5), 38.5, 1e-12);
  // Integers with a mask.
  const std::vector<short> codes{ 1, 2, 3, 4 };
  const unsigned char mask[4] = { 0, 0, 0, 2 };
  terrain::HeightfieldView<short> masked;
  masked.Samples = codes.data();
  masked.Width = masked.Height = 2;
  masked.Mask = mask;
  masked.MaskBits = 2;
  EXPECT_EQ(terrain::SampleBilinear(masked, 0.5, 0.0), 1.5);
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(masked, 0.5, 0.5)));
}

TEST(HeightSampling, DegenerateGrids)
{
  const std::vector<double> one{ 7.0 };
  EXPECT_EQ(terrain::SampleBilinear(View(one, 1), 0.0, 0.0), 7.0);
  EXPECT_EQ(terrain::SampleCubic(View(one, 1), 0.0, 0.0), 7.0);
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(View(one, 1), 0.5, 0.0)));
  const std::vector<double> line{ 1.0, 3.0, 5.0 };
  EXPECT_EQ(terrain::SampleBilinear(View(line, 3), 1.5, 0.0), 4.0);
  EXPECT_EQ(terrain::SampleBilinear(View(line, 1), 0.0, 0.5), 2.0);
  EXPECT_TRUE(std::isnan(terrain::SampleBilinear(terrain::HeightfieldView<double>(), 0.0, 0.0)));
}
