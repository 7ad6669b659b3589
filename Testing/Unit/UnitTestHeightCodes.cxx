// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/HeightCodes.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace
{
using terrain::HeightCodes;

/// A view of 4 columns.
template <typename T>
terrain::HeightfieldView<T> ToView(const std::vector<T>& samples)
{
  terrain::HeightfieldView<T> view;
  view.Samples = samples.data();
  view.Width = 4;
  view.Height = static_cast<std::int64_t>(samples.size()) / 4;
  return view;
}

template <typename T>
HeightCodes CodesOf(const terrain::HeightfieldView<T>& view)
{
  return terrain::ChooseHeightCodes(terrain::FindHeightRange(view, terrain::SerialFor));
}

TEST(HeightCodes, HoldHeightsWithinTheirRange)
{
  std::vector<short> samples{ -5, 0, 3, 9, 1, 2, 3, 4, 5, 6, 7, 8 };
  const HeightCodes codes = CodesOf(ToView(samples));
  samples[5] = 9;
  samples[6] = -5;
  EXPECT_TRUE(terrain::HoldHeights(codes, ToView(samples), 0, 4, 0, 3));
  samples[6] = 10;
  EXPECT_FALSE(terrain::HoldHeights(codes, ToView(samples), 0, 4, 0, 3));
  EXPECT_FALSE(terrain::HoldHeights(codes, ToView(samples), 2, 3, 1, 2));
  EXPECT_TRUE(terrain::HoldHeights(codes, ToView(samples), 0, 2, 0, 3)); // it is not looked at
  EXPECT_TRUE(terrain::HoldHeights(codes, ToView(samples), 3, 4, 1, 3));
  samples[6] = -6;
  EXPECT_FALSE(terrain::HoldHeights(codes, ToView(samples), 2, 3, 1, 2));
  EXPECT_TRUE(terrain::HoldHeights(codes, ToView(samples), 2, 2, 1, 2)); // nothing
}

TEST(HeightCodes, HoldNoDataWhereTheyKnowOfSome)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> samples{ 1.5, 2.5, 3.5, 4.5, 1.0, 2.0, 3.0, 4.0 };
  const HeightCodes whole = CodesOf(ToView(samples));
  samples[2] = none;
  const HeightCodes holed = CodesOf(ToView(samples));
  EXPECT_FALSE(terrain::HoldHeights(whole, ToView(samples), 0, 4, 0, 2));
  EXPECT_TRUE(terrain::HoldHeights(whole, ToView(samples), 0, 4, 1, 2));
  samples[3] = none;
  EXPECT_TRUE(terrain::HoldHeights(holed, ToView(samples), 0, 4, 0, 2));
}
}
