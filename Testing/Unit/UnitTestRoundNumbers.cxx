// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/RoundNumbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(RoundNumbers, LargestNotAbove)
{
  for (double value = 1e-6; value < 1e9; value *= 1.37)
  {
    const double round = terrain::RoundDown(value);
    EXPECT_LE(round, value * (1.0 + 1e-9));
    EXPECT_GT(round * 2.5, value * (1.0 - 1e-9));
    const double digit = round / std::pow(10.0, std::floor(std::log10(round) + 1e-9));
    EXPECT_TRUE(
      std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6)
      << round;
  }
  EXPECT_DOUBLE_EQ(terrain::RoundDown(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(terrain::RoundDown(0.5), 0.5);
}

TEST(RoundNumbers, Angles)
{
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(1.0), 1.0);
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(0.9), 0.5);
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(0.3), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(14.0), 10.0);
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(400.0), 90.0);
  EXPECT_DOUBLE_EQ(terrain::RoundAngleDown(0.3 / 3600.0), 0.2 / 3600.0);
}

TEST(RoundNumbers, DegenerateIsZero)
{
  for (double value : { 0.0, -1.0, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_EQ(terrain::RoundDown(value), 0.0);
    EXPECT_EQ(terrain::RoundAngleDown(value), 0.0);
  }
}

TEST(RoundNumbers, Labels)
{
  EXPECT_EQ(terrain::LengthLabel(500.0), "500 m");
  EXPECT_EQ(terrain::LengthLabel(2000.0), "2 km");
  EXPECT_EQ(terrain::LengthLabel(0.5), "50 cm");
  EXPECT_EQ(terrain::AngleLabel(27.0, 1.0, 'N', 'S'), "27\u00b0N");
  EXPECT_EQ(terrain::AngleLabel(-86.5, 0.5, 'E', 'W'), "86\u00b030'W");
  EXPECT_EQ(terrain::AngleLabel(86.0 + 1.0 / 3.0, 1.0 / 6.0, 'E', 'W'), "86\u00b020'E");
  EXPECT_EQ(terrain::AngleLabel(0.0, 1.0, 'N', 'S'), "0\u00b0");
  EXPECT_EQ(terrain::AngleLabel(1.0 / 240.0, 1.0 / 240.0, 'N', 'S'), "0\u00b000'15\"N");
}
