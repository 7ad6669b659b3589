// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/Horizon.h"
#include "core/rays/HorizonLanes.h"

#include "UnitTestFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace terrain;

namespace
{
/// Height of the patch of a cell over a ground at any position, in double and without cancellation;
/// NaN where it has no surface.
double PatchHeight(
  const HeightfieldView<double>& view, glm::i64vec2 cell, const glm::dvec2& p, double ground)
{
  if (cell.x < 0 || cell.y < 0 || cell.x + 1 >= view.Width || cell.y + 1 >= view.Height ||
    !view.IsCellValid(cell.x, cell.y))
  {
    return kNaN;
  }
  const double u = p.x - static_cast<double>(cell.x);
  const double v = p.y - static_cast<double>(cell.y);
  const auto at = [&](std::int64_t i, std::int64_t j)
  { return view.At(cell.x + i, cell.y + j) - ground; };
  return (1.0 - v) * ((1.0 - u) * at(0, 0) + u * at(1, 0)) +
    v * ((1.0 - u) * at(0, 1) + u * at(1, 1));
}

/// The judge: the definition of Horizon.h by brute force, the highest of many points in every cell
/// that the ray runs through.
double JudgeHorizon(const HeightfieldView<double>& view, const HorizonOptions& options,
  const glm::dvec2& from, double azimuth)
{
  constexpr int points = 100;
  const double ground =
    view.At(static_cast<std::int64_t>(from.x), static_cast<std::int64_t>(from.y));
  if (std::isnan(ground))
  {
    return kNaN;
  }
  glm::dvec2 speed(std::sin(azimuth * kDegree), std::cos(azimuth * kDegree));
  speed =
    glm::dvec2(std::abs(speed.x) < 1e-9 ? 0.0 : speed.x, std::abs(speed.y) < 1e-9 ? 0.0 : speed.y) /
    options.Spacing;
  std::vector<double> crossings{ 0.0 };
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int line = 1; speed[axis] != 0.0 && line < std::max(view.Width, view.Height); ++line)
    {
      crossings.push_back(line / std::abs(speed[axis]));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  double best = -kInfinity;
  for (std::size_t k = 1; k < crossings.size(); ++k)
  {
    const double enter = crossings[k - 1];
    const double length = crossings[k] - enter;
    if (length < 1e-9 * crossings[k])
    {
      continue;
    }
    const glm::dvec2 middle = from + speed * (enter + 0.5 * length);
    for (const double side : { -1e-6, 1e-6 }) // the cells beside a line
    {
      const glm::i64vec2 cell(
        glm::floor(middle + glm::dvec2(speed.x == 0.0 ? side : 0.0, speed.y == 0.0 ? side : 0.0)));
      for (int point = 0; point <= points; ++point)
      {
        const double t = enter + length * std::max(static_cast<double>(point) / points, 1e-5);
        const double h = PatchHeight(view, cell, from + speed * t, ground);
        const double rise = h - options.Drop * t * t - options.EyeHeight;
        best = rise / t > best ? rise / t : best;
      }
    }
  }
  return std::atan(best) / kDegree;
}

/// Casts horizons of all samples.
std::vector<float> CastAll(const HeightfieldView<double>& view, const HorizonOptions& options,
  double azimuth, const LaneKernels& kernels = RunnableLaneKernels().back(),
  const ParallelFor& parallelFor = SerialFor)
{
  std::vector<float> degrees(static_cast<std::size_t>(view.Width * view.Height), -123.0f);
  HorizonGrid grid(view, parallelFor);
  grid.Cast(azimuth, options, { 0, view.Height }, degrees.data(), parallelFor, kernels);
  return degrees;
}

void CompareWithJudge(const TestField& field, const HorizonOptions& options, double azimuth,
  const LaneKernels& kernels, int stride = 1)
{
  const HeightfieldView<double> view = field.View();
  const std::vector<float> degrees = CastAll(view, options, azimuth, kernels);
  for (std::size_t k = 0; k < degrees.size(); k += static_cast<std::size_t>(stride))
  {
    const glm::dvec2 from(static_cast<double>(static_cast<std::int64_t>(k) % view.Width),
      static_cast<double>(static_cast<std::int64_t>(k) / view.Width));
    const double judged = JudgeHorizon(view, options, from, azimuth);
    ASSERT_EQ(std::isnan(judged), std::isnan(degrees[k]))
      << field.Name << " " << azimuth << " at " << from.x << " " << from.y;
    if (!std::isnan(judged))
    {
      ASSERT_NEAR(degrees[k], judged, kHorizonError)
        << field.Name << " " << azimuth << " at " << from.x << " " << from.y << " " << kernels.Name;
    }
  }
}
}

TEST(Horizon, ArcTangentsAreThoseOfTheLibrary)
{
  using L = Lanes<double>;
  constexpr double kLargest = 1e6;
  double worst = 0.0;
  for (double tangent = 1e-6; tangent < kLargest; tangent *= 1.0 + 1e-4)
  {
    for (const double x : { tangent, -tangent, 1.0 / tangent })
    {
      double degrees[L::Count];
      L::Store(ArcTangentDegrees<double>(L::All(x)), degrees);
      worst = std::max(worst, std::abs(degrees[0] * kDegree - std::atan(x)));
    }
  }
  EXPECT_LE(worst, kArcTangentError);
  EXPECT_GT(worst, 0.1 * kArcTangentError); // the bound says something
}

TEST(Horizon, BruteForceOnAdversarialFields)
{
  for (const TestField& field : AdversarialFields())
  {
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      for (const double azimuth :
        { 0.0, 17.0, 45.0, 90.0, 135.0, 180.0, 200.5, 270.0, 292.5, 355.0 })
      {
        CompareWithJudge(field, {}, azimuth, kernels, 29);
      }
    }
  }
}

TEST(Horizon, SpacingEyeHeightAndCurvature)
{
  HorizonOptions options;
  options.Spacing = { 20.0, 30.0 };
  for (const TestField& field : AdversarialFields())
  {
    for (const double azimuth : { 0.0, 33.0, 90.0, 213.7, 315.0 })
    {
      options.EyeHeight = 1.7;
      options.Drop = 1e-4;
      CompareWithJudge(field, options, azimuth, RunnableLaneKernels().back(), 13);
      options.EyeHeight = 0.0;
      CompareWithJudge(field, options, azimuth, RunnableLaneKernels().back(), 13);
    }
  }
}

TEST(Horizon, LargeGridIsExactAtSomeSamples)
{
  // Long rays, so that the tree of stretches is used to its top.
  const TestField field("ranges", 700, 600,
    [](int i, int j)
    {
      return 900.0 * std::sin(0.013 * i + 0.4 * std::sin(0.02 * j)) * std::cos(0.017 * j) +
        60.0 * std::sin(0.31 * i) * std::cos(0.27 * j) + ((i * 7919 + j * 104729) % 97) * 0.3;
    });
  HorizonOptions options;
  options.Spacing = { 30.0, 30.0 };
  for (const LaneKernels& kernels : RunnableLaneKernels())
  {
    for (const double azimuth : { 22.5, 112.5, 180.0, 225.0, 281.0 })
    {
      CompareWithJudge(field, options, azimuth, kernels, 40009);
    }
  }
}

TEST(Horizon, KindsOfProcessorsAgree)
{
  std::minstd_rand random(5);
  const TestField field("random", 143, 99,
    [&](int i, int j)
    { return static_cast<double>(random() % 1000u) * 0.1 + 3.0 * std::abs(i - j); });
  for (const double azimuth : { 5.0, 90.0, 222.0 })
  {
    const std::vector<float> plain = CastAll(field.View(), {}, azimuth, RunnableLaneKernels()[0]);
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      const std::vector<float> other = CastAll(field.View(), {}, azimuth, kernels, BackwardFor);
      for (std::size_t k = 0; k < plain.size(); ++k)
      {
        ASSERT_NEAR(other[k], plain[k], 2e-5) << kernels.Name << " at " << k;
      }
    }
  }
}

TEST(Horizon, PlaneRisesByItsSlope)
{
  const TestField field("plane", 50, 40, [](int i, int) { return 0.5 * i; });
  const std::vector<float> east = CastAll(field.View(), {}, 90.0);
  const std::vector<float> west = CastAll(field.View(), {}, 270.0);
  const double slope = std::atan(0.5) / kDegree;
  EXPECT_NEAR(east[50 * 20 + 10], slope, 1e-4);
  EXPECT_NEAR(west[50 * 20 + 10], -slope, 1e-4);
  // Nothing is ahead at the border.
  EXPECT_EQ(east[50 * 20 + 49], kNoHorizon);
  EXPECT_EQ(west[50 * 20], kNoHorizon);
}

TEST(Horizon, DoubleWhereFloatIsNotEnough)
{
  // Millimetres on top of 8000 km, samples 10 cm apart.
  const TestField field("fine", 40, 40,
    [](int i, int j) { return 8e6 + 1e-3 * std::sin(0.7 * i) * std::cos(0.9 * j); });
  HorizonOptions options;
  options.Spacing = { 0.1, 0.1 };
  CompareWithJudge(field, options, 31.0, RunnableLaneKernels().back());
  CompareWithJudge(field, options, 270.0, RunnableLaneKernels().front());
}

TEST(Horizon, DegenerateGrids)
{
  for (const glm::ivec2 size : { glm::ivec2(1, 1), glm::ivec2(5, 1), glm::ivec2(1, 7) })
  {
    const TestField field("line", size.x, size.y, [](int i, int j) { return 1.0 * i + j; });
    for (const double azimuth : { 0.0, 45.0, 90.0, 250.0 })
    {
      for (const float angle : CastAll(field.View(), {}, azimuth))
      {
        EXPECT_EQ(angle, kNoHorizon); // samples in a line make no surface
      }
    }
  }
  const TestField none("none", 20, 20, [](int, int) { return kNaN; });
  for (const float angle : CastAll(none.View(), {}, 45.0))
  {
    EXPECT_TRUE(std::isnan(angle));
  }
  EXPECT_TRUE(CastAll(TestField("empty", 0, 0, {}).View(), {}, 10.0).empty());
}

TEST(Horizon, RowsOneByOne)
{
  const TestField field = AdversarialFields()[7];
  const HeightfieldView<double> view = field.View();
  const std::vector<float> all = CastAll(view, {}, 77.0);
  HorizonGrid grid(view, SerialFor);
  std::vector<float> row(static_cast<std::size_t>(view.Width));
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    grid.Cast(77.0, {}, { j, j + 1 }, row.data(), SerialFor);
    EXPECT_TRUE(std::equal(row.begin(), row.end(), all.begin() + j * view.Width)) << j;
  }
}
