// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/Viewshed.h"

#include "core/grid/HeightSampling.h"

#include "UnitTestFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace terrain;

namespace
{
/// Height of the patch of a cell at any position, NaN where it has no surface.
double CellHeight(const HeightfieldView<double>& view, glm::i64vec2 cell, const glm::dvec2& p)
{
  if (cell.x < 0 || cell.y < 0 || cell.x + 1 >= view.Width || cell.y + 1 >= view.Height ||
    !view.IsCellValid(cell.x, cell.y))
  {
    return kNaN;
  }
  const double u = p.x - static_cast<double>(cell.x);
  const double v = p.y - static_cast<double>(cell.y);
  return (1.0 - v) * ((1.0 - u) * view.At(cell.x, cell.y) + u * view.At(cell.x + 1, cell.y)) +
    v * ((1.0 - u) * view.At(cell.x, cell.y + 1) + u * view.At(cell.x + 1, cell.y + 1));
}

/// Calls visit(t, h) for many points of the surface under the sight to a target, at parts 0 to 1 of
/// the way, in each cell that the line runs through.
template <typename Visit>
void VisitSight(const HeightfieldView<double>& view, const Observer& observer,
  const glm::i64vec2& target, int points, const Visit& visit)
{
  const glm::dvec2 way = glm::dvec2(target) - observer.Position;
  std::vector<double> crossings{ 0.0, 1.0 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::min(observer.Position[axis], observer.Position[axis] + way[axis]);
    const double high = std::max(observer.Position[axis], observer.Position[axis] + way[axis]);
    for (double line = std::ceil(low); way[axis] != 0.0 && line <= high; line += 1.0)
    {
      crossings.push_back((line - observer.Position[axis]) / way[axis]);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t k = 1; k < crossings.size(); ++k)
  {
    const double length = crossings[k] - crossings[k - 1];
    if (length < 1e-9)
    {
      continue;
    }
    const glm::dvec2 middle = observer.Position + way * (crossings[k - 1] + 0.5 * length);
    for (const double side : { -1e-6, 1e-6 }) // the cells beside a line
    {
      const glm::i64vec2 cell(
        glm::floor(middle + glm::dvec2(way.x == 0.0 ? side : 0.0, way.y == 0.0 ? side : 0.0)));
      for (int point = 0; point <= points; ++point)
      {
        const double t = crossings[k - 1] + length * point / points;
        if (t < 1.0 - 1e-9)
        {
          visit(t, CellHeight(view, cell, observer.Position + way * t));
        }
      }
    }
  }
}

/// The judge: how high the surface stands over the sight to a target. Above 0: it is hidden.
double JudgeAbove(const HeightfieldView<double>& view, const ViewshedOptions& options,
  const Observer& observer, const glm::i64vec2& target)
{
  const double far = glm::length((glm::dvec2(target) - observer.Position) * options.Spacing);
  const double top = view.At(target.x, target.y) + options.TargetHeight;
  double most = -kInfinity;
  VisitSight(view, observer, target, 25,
    [&](double t, double h)
    {
      const double lift = options.Drop * far * far * t * (1.0 - t);
      const double above = h - (observer.Eye + (top - observer.Eye) * t - lift);
      most = above > most ? above : most;
    });
  return most;
}

/// The judge of rises: how high the target must be for its sight to pass over every point.
double JudgeRise(const HeightfieldView<double>& view, const ViewshedOptions& options,
  const Observer& observer, const glm::i64vec2& target)
{
  const double far = glm::length((glm::dvec2(target) - observer.Position) * options.Spacing);
  const double top = view.At(target.x, target.y) + options.TargetHeight;
  double least = top;
  VisitSight(view, observer, target, 300,
    [&](double t, double h)
    {
      const double lift = options.Drop * far * far * t * (1.0 - t);
      const double needed = observer.Eye + (h - observer.Eye + lift) / t;
      least = t > 0.0 && needed > least ? needed : least;
    });
  return least - top;
}

Observer ObserverAt(const HeightfieldView<double>& view, const glm::dvec2& position, double height)
{
  Observer observer;
  observer.Position = position;
  observer.Ground = SampleBilinear(view, position.x, position.y);
  observer.Eye = observer.Ground + height;
  return observer;
}

/// Highest less lowest height of the samples that have one.
double ReliefOf(const TestField& field)
{
  double low = kInfinity;
  double high = -kInfinity;
  for (const double height : field.Samples)
  {
    low = height < low ? height : low; // not so for NaN
    high = height > high ? height : high;
  }
  return high - low;
}

/// Compares one viewshed with the judge, but for lines that touch the surface. Parts of the targets
/// with heights that were judged; NaN for an observer in a hole.
double CompareWithJudge(const TestField& field, const ViewshedOptions& options,
  const glm::dvec2& position, double height, const LaneKernels& kernels, int stride = 1)
{
  const HeightfieldView<double> view = field.View();
  const Observer observer = ObserverAt(view, position, height);
  if (std::isnan(observer.Ground))
  {
    return kNaN;
  }
  const ViewshedGrid grid(view, SerialFor);
  std::vector<std::uint32_t> counts(field.Samples.size(), 0);
  grid.Count({ observer }, options, counts.data(), BackwardFor, kernels);
  // What hides rises over the sight by more than the grid lets pass; a sight that nothing rises
  // over by more than what doubles round is free. The surface comes to the sight at the target.
  const double scale = ReliefOf(field) + std::min(options.Spacing.x, options.Spacing.y);
  const double touch = 2.0 * terrain::kSightTolerance * scale;
  const double clear = 1e-12 * (scale + std::abs(observer.Eye));
  int targets = 0;
  int judged = 0;
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    for (std::int64_t i = j % stride; i < view.Width; i += stride)
    {
      const std::uint32_t seen = counts[static_cast<std::size_t>(i + view.Width * j)];
      if (std::isnan(view.At(i, j)))
      {
        EXPECT_EQ(seen, 0u) << field.Name << " " << i << " " << j;
        continue;
      }
      ++targets;
      const double above = JudgeAbove(view, options, observer, { i, j });
      // Along a diagonal the corners of holes are touched, which may hide or not.
      const glm::dvec2 way = glm::abs(glm::dvec2(i, j) - position);
      const bool corners = way.x == way.y && field.Name == "half";
      if ((above > touch || above <= clear) && !corners)
      {
        ++judged;
        EXPECT_EQ(seen, above > touch ? 0u : 1u)
          << field.Name << " " << kernels.Name << " from " << position.x << " " << position.y
          << " to " << i << " " << j << ": " << above;
      }
    }
  }
  return static_cast<double>(judged) / targets;
}

/// The judge must have had something to judge.
void ExpectJudged(double part, const TestField& field)
{
  const bool hasHoles =
    std::any_of(field.Samples.begin(), field.Samples.end(), [](double h) { return std::isnan(h); });
  // sights along a plane touch it
  EXPECT_TRUE(part > 0.5 || (hasHoles && std::isnan(part))) << field.Name << " " << part;
}
}

TEST(Viewshed, BruteForceOnAdversarialFields)
{
  for (const TestField& field : AdversarialFields())
  {
    const glm::dvec2 last(field.Width - 1, field.Height - 1);
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      for (const glm::dvec2& part : { glm::dvec2(0.0), glm::dvec2(1.0), glm::dvec2(0.37, 0.61) })
      {
        ExpectJudged(CompareWithJudge(field, {}, part * last, 1.7, kernels), field);
        ExpectJudged(CompareWithJudge(field, {}, glm::floor(0.5 * last), 300.0, kernels), field);
      }
    }
  }
}

TEST(Viewshed, SpacingTargetHeightAndCurvature)
{
  ViewshedOptions options;
  options.Spacing = { 20.0, 30.0 };
  options.TargetHeight = 12.5;
  options.Drop = 1e-4;
  for (const TestField& field : AdversarialFields())
  {
    const glm::dvec2 last(field.Width - 1, field.Height - 1);
    ExpectJudged(
      CompareWithJudge(field, options, 0.7 * last, 5.0, RunnableLaneKernels().back()), field);
    ExpectJudged(
      CompareWithJudge(field, options, glm::ceil(0.3 * last), 50.0, RunnableLaneKernels().front()),
      field);
  }
}

TEST(Viewshed, LargeGrid)
{
  const TestField field("ranges", 190, 170,
    [](int i, int j)
    {
      return 300.0 * std::sin(0.043 * i + 0.4 * std::sin(0.05 * j)) * std::cos(0.037 * j) +
        30.0 * std::sin(0.31 * i) * std::cos(0.27 * j) + ((i * 7919 + j * 104729) % 97) * 0.1;
    });
  ViewshedOptions options;
  options.Spacing = { 30.0, 30.0 };
  for (const LaneKernels& kernels : RunnableLaneKernels())
  {
    ExpectJudged(CompareWithJudge(field, options, { 95.0, 84.0 }, 20.0, kernels, 13), field);
    ExpectJudged(CompareWithJudge(field, options, { 3.3, 160.7 }, 2.0, kernels, 13), field);
  }
}

TEST(Viewshed, ObserversAddUp)
{
  const TestField field = AdversarialFields()[7];
  const HeightfieldView<double> view = field.View();
  const ViewshedGrid grid(view, SerialFor);
  const std::vector<Observer> observers{ ObserverAt(view, { 3.0, 4.0 }, 9.0),
    ObserverAt(view, { 30.5, 20.0 }, 9.0), ObserverAt(view, { 60.0, 60.25 }, 9.0) };
  std::vector<std::uint32_t> all(field.Samples.size(), 0);
  std::vector<std::uint32_t> sum(field.Samples.size(), 0);
  grid.Count(observers, {}, all.data(), SerialFor);
  for (const Observer& observer : observers)
  {
    grid.Count({ observer }, {}, sum.data(), BackwardFor);
  }
  EXPECT_EQ(all, sum);
  EXPECT_GT(*std::max_element(all.begin(), all.end()), 1u);
}

TEST(Viewshed, Limits)
{
  const TestField field("flat", 101, 101, [](int, int) { return 5.0; });
  const HeightfieldView<double> view = field.View();
  const ViewshedGrid grid(view, SerialFor);
  ViewshedOptions options;
  options.NearestDistance = 5.0;
  options.FarthestDistance = 20.0;
  options.FirstAzimuth = 315.0;
  options.LastAzimuth = 405.0; // a quarter round north
  std::vector<std::uint32_t> counts(field.Samples.size(), 0);
  grid.Count({ ObserverAt(view, { 50.0, 50.0 }, 2.0) }, options, counts.data(), SerialFor);
  for (int j = 0; j < 101; ++j)
  {
    for (int i = 0; i < 101; ++i)
    {
      const int x = i - 50;
      const int y = j - 50;
      const bool expected = x * x + y * y >= 25 && x * x + y * y <= 400 && y > 0 && std::abs(x) < y;
      const bool border = std::abs(x) == y;
      const bool seen = counts[static_cast<std::size_t>(i + 101 * j)] != 0;
      EXPECT_TRUE(border || seen == expected) << x << " " << y;
    }
  }
  options = {};
  options.HighestElevation = -45.0;
  std::fill(counts.begin(), counts.end(), 0u);
  grid.Count({ ObserverAt(view, { 50.0, 50.0 }, 10.5) }, options, counts.data(), SerialFor);
  EXPECT_EQ(counts[50 + 101 * 60], 1u);
  EXPECT_EQ(counts[50 + 101 * 61], 0u);
  EXPECT_EQ(counts[50 + 101 * 50], 1u);
}

TEST(Viewshed, EyesBelowTheGroundSeeNothing)
{
  const TestField field = AdversarialFields()[7];
  const HeightfieldView<double> view = field.View();
  const ViewshedGrid grid(view, SerialFor);
  std::vector<std::uint32_t> counts(field.Samples.size(), 0);
  grid.Count({ ObserverAt(view, { 10.5, 20.5 }, -3.0), ObserverAt(view, { 7.0, 9.0 }, -3.0) }, {},
    counts.data(), SerialFor);
  EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 0u);
}

TEST(Viewshed, DegenerateGrids)
{
  for (const glm::ivec2 size : { glm::ivec2(1, 1), glm::ivec2(6, 1), glm::ivec2(1, 5) })
  {
    // Samples in a line make no surface: nothing hides.
    const TestField field(
      "line", size.x, size.y, [](int i, int j) { return (i + j) % 2 ? 9.0 : 0.0; });
    std::vector<std::uint32_t> counts(field.Samples.size(), 0);
    const ViewshedGrid grid(field.View(), SerialFor);
    grid.Count({ ObserverAt(field.View(), { 0.0, 0.0 }, 1.0) }, {}, counts.data(), SerialFor);
    EXPECT_EQ(*std::min_element(counts.begin(), counts.end()), 1u);
  }
  const ViewshedGrid empty(TestField("empty", 0, 0, {}).View(), SerialFor);
  empty.Count({}, {}, nullptr, SerialFor);
}

namespace
{
struct Measured
{
  std::vector<std::uint32_t> Counts;
  std::vector<float> Rises;

  Measured(const TestField& field, const std::vector<Observer>& observers,
    const ViewshedOptions& options, const LaneKernels& kernels, bool holesBlock = false)
    : Counts(field.Samples.size(), 0)
    , Rises(field.Samples.size(), std::numeric_limits<float>::infinity())
  {
    const ViewshedGrid grid(field.View(), SerialFor, holesBlock);
    grid.Measure(observers, options, this->Counts.data(), this->Rises.data(), BackwardFor, kernels);
  }
};
}

TEST(Viewshed, RisesAgainstTheJudge)
{
  ViewshedOptions options;
  options.Spacing = { 20.0, 30.0 };
  options.TargetHeight = 1.5;
  options.Drop = 1e-5;
  for (const TestField& field : { AdversarialFields()[0], AdversarialFields()[5],
         AdversarialFields()[6], AdversarialFields()[7] })
  {
    const HeightfieldView<double> view = field.View();
    for (const glm::dvec2& place : { glm::dvec2(3.0, 4.0), glm::dvec2(12.25, 9.5) })
    {
      const Observer observer = ObserverAt(view, place, 2.0);
      for (const LaneKernels& kernels : RunnableLaneKernels())
      {
        const Measured measured(field, { observer }, options, kernels);
        for (std::int64_t j = 0; j < view.Height; j += 4)
        {
          for (std::int64_t i = j % 5; i < view.Width; i += 5)
          {
            const auto index = static_cast<std::size_t>(i + view.Width * j);
            const double rise = static_cast<double>(measured.Rises[index]);
            EXPECT_EQ(measured.Counts[index] == 1u, rise == 0.0);
            const double expected = JudgeRise(view, options, observer, { i, j });
            EXPECT_NEAR(rise, expected, 0.01 + 1e-3 * expected)
              << field.Name << " " << kernels.Name << " " << i << " " << j;
          }
        }
      }
    }
  }
}

TEST(Viewshed, RisesWithinLimitsAndTheLeastOfObservers)
{
  const TestField field("wall", 61, 21, [](int i, int) { return i == 30 ? 40.0 : 0.0; });
  const HeightfieldView<double> view = field.View();
  const Observer near = ObserverAt(view, { 20.0, 10.0 }, 10.0);
  const Observer far = ObserverAt(view, { 5.0, 10.0 }, 10.0);
  const auto at = [&](const Measured& measured, int i)
  { return static_cast<double>(measured.Rises[static_cast<std::size_t>(i + 61 * 10)]); };
  const LaneKernels& kernels = RunnableLaneKernels().back();
  const Measured both(field, { near, far }, {}, kernels);
  EXPECT_NEAR(at(both, 40), 10.0 + 30.0 * 35.0 / 25.0, 0.01); // over the wall from afar
  EXPECT_EQ(at(both, 25), 0.0);
  ViewshedOptions options;
  options.FarthestDistance = 25.0;
  const Measured within(field, { near, far }, options, kernels);
  EXPECT_NEAR(at(within, 40), 10.0 + 30.0 * 20.0 / 10.0, 0.01); // only the near one may
  EXPECT_EQ(at(within, 50), kInfinity);
  options = {};
  options.HighestElevation = 60.0;
  EXPECT_EQ(at(Measured(field, { near }, options, kernels), 40), kInfinity);
  options.HighestElevation = 90.0;
  options.LowestElevation = 80.0;
  EXPECT_NEAR(at(Measured(field, { near }, options, kernels), 40),
    10.0 + 20.0 * std::tan(80.0 * kDegree), 0.01);
  EXPECT_EQ(at(Measured(field, { ObserverAt(view, { 20.0, 10.0 }, -1.0) }, {}, kernels), 22),
    kInfinity); // below the ground
}

TEST(Viewshed, HolesBlockIfAsked)
{
  const TestField field(
    "lake", 61, 21, [](int i, int) { return i == 30 || i == 31 ? kNaN
                                       : i == 50               ? 9.0
                                                               : 0.0; });
  const HeightfieldView<double> view = field.View();
  const Observer observer = ObserverAt(view, { 10.0, 10.5 }, 5.0);
  for (const LaneKernels& kernels : RunnableLaneKernels())
  {
    for (const bool blocks : { false, true })
    {
      const Measured found(field, { observer }, {}, kernels, blocks);
      std::vector<std::uint32_t> counts(field.Samples.size(), 0);
      ViewshedGrid(view, SerialFor, blocks)
        .Count({ observer }, {}, counts.data(), SerialFor, kernels);
      EXPECT_EQ(counts, found.Counts);
      EXPECT_EQ(counts[20 + 61 * 10], 1u);
      EXPECT_EQ(counts[30 + 61 * 10], 0u);
      EXPECT_EQ(counts[40 + 61 * 10], blocks ? 0u : 1u);
      EXPECT_EQ(found.Rises[40 + 61 * 10], blocks ? std::numeric_limits<float>::infinity() : 0.0f);
      // whoever stands far above the sea does not see through walls without end, either
      const Measured high(field, { ObserverAt(view, { 10.0, 10.5 }, 5000.0) }, {}, kernels, blocks);
      EXPECT_EQ(high.Counts[40 + 61 * 10], blocks ? 0u : 1u);
    }
  }
}
