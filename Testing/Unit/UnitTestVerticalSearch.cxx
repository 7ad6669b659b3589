// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/VerticalSearch.h"

#include "gtest/gtest.h"

#include <cmath>
#include <functional>

namespace
{
constexpr double kTolerance = 1e-3;

/// The z at which a search ends; its number of steps is at most the one given.
double Search(terrain::VerticalSearch search, const std::function<double(double)>& rise,
  int mostSteps, bool isThere = true)
{
  int steps = 1;
  while (search.Take(rise(search.GetZ()), kTolerance))
  {
    ++steps;
  }
  EXPECT_LE(steps, mostSteps);
  EXPECT_EQ(search.IsFound(), isThere);
  return search.GetZ();
}
}

TEST(VerticalSearch, ConvergesWherePlainStepsDo)
{
  // terrain that rises by 0.3 for each unit up
  EXPECT_NEAR(Search(
                terrain::VerticalSearch(0.0), [](double z) { return 700.0 + 0.3 * z - z; }, 16),
    1000.0, 2.0 * kTolerance);
  // the same place at every height: one step, and one that says so
  EXPECT_EQ(Search(
              terrain::VerticalSearch(0.0), [](double z) { return 42.0 - z; }, 2),
    42.0);
}

TEST(VerticalSearch, ConvergesWherePlainStepsDoNot)
{
  // plain steps would grow threefold: a cliff that falls by 3 for each unit up
  EXPECT_NEAR(
    Search(
      terrain::VerticalSearch(0.0), [](double z) { return 2000.0 - 3.0 * (z - 500.0) - z; },
      terrain::VerticalSearch::MostSteps),
    875.0, 2.0 * kTolerance);
  // a step, where only a bracket helps; 400 km high, as exaggerated as any picture needs
  EXPECT_NEAR(
    Search(
      terrain::VerticalSearch(0.0), [](double z) { return (z < 123456.0 ? 4e5 : 0.0) - z; },
      terrain::VerticalSearch::MostSteps),
    123456.0, 2.0 * kTolerance);
}

TEST(VerticalSearch, LooksHigherUpWhereThereIsNothing)
{
  // terrain at 900 that is met from 300 to 1200 only
  const auto rise = [](double z) { return z < 300.0 || z > 1200.0 ? std::nan("") : 900.0 - z; };
  EXPECT_NEAR(Search(terrain::VerticalSearch(0.0, 1600.0, 8), rise, 8), 900.0, kTolerance);
  // without trials it stays where nothing is
  EXPECT_EQ(Search(terrain::VerticalSearch(0.0), rise, 1, false), 0.0);
  // no terrain at any height: an end in any case
  Search(
    terrain::VerticalSearch(0.0, 1600.0, 8), [](double) { return std::nan(""); }, 9, false);
  // the line leaves the terrain while it is below it
  const auto gone = [](double z) { return z > 500.0 ? std::nan("") : 900.0 - z; };
  Search(
    terrain::VerticalSearch(0.0, 1600.0, 8), gone, terrain::VerticalSearch::MostSteps + 1, false);
  Search(terrain::VerticalSearch(0.0), gone, 2, false);
  // a step beyond the terrain goes half way back
  const auto narrow = [](double z) { return z > 1000.0 ? std::nan("") : 1.8 * (900.0 - z); };
  EXPECT_NEAR(Search(terrain::VerticalSearch(0.0, 1600.0, 8), narrow, 40), 900.0, 2.0 * kTolerance);
}
