// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestDetail.h"
#include "UnitTestRays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using terrain::CodedSum;
using terrain::TestField;

/// The lattices that are tried: base, its parts and the period of the detail.
struct Trial
{
  TestField Base;
  TestField Detail;
  int Level;
  double Scale;
};

std::vector<Trial> Trials()
{
  std::vector<Trial> result;
  int count = 0;
  const glm::ivec2 periods[] = { { 1, 1 }, { 8, 8 }, { 16, 4 }, { 12, 6 }, { 7, 5 }, { 32, 32 } };
  for (const TestField& base : terrain::AdversarialFields())
  {
    const glm::ivec2 period = periods[count % 6];
    const double relief = count % 2 ? 40.0 : 3.0;
    result.push_back({ base, terrain::RandomDetail(period, relief, count), count % 3,
      count % 5 == 4 ? 0.0 : 0.7 });
    ++count;
  }
  return result;
}

/// Bilinear height of a field in double precision, from a sample and a position beyond it, 0..1;
/// samples beyond the last are the first ones again.
double Bilinear(const TestField& field, glm::ivec2 sample, glm::dvec2 fraction)
{
  const auto at = [&](int i, int j)
  {
    const int column = (sample.x + i) % field.Width;
    const int row = (sample.y + j) % field.Height;
    return field.Samples[static_cast<std::size_t>(column + field.Width * row)];
  };
  return (at(0, 0) * (1.0 - fraction.x) + at(1, 0) * fraction.x) * (1.0 - fraction.y) +
    (at(0, 1) * (1.0 - fraction.x) + at(1, 1) * fraction.x) * fraction.y;
}

/// Height of the sum from its definition, at a position in a cell of the sum.
double Definition(const Trial& trial, glm::ivec2 cell, glm::dvec2 fraction)
{
  const glm::ivec2 baseCell = cell >> trial.Level;
  const double cells = 1 << trial.Level;
  const glm::dvec2 inBase = (glm::dvec2(cell) + fraction) / cells - glm::dvec2(baseCell);
  return Bilinear(trial.Base, baseCell, inBase) +
    trial.Scale * Bilinear(trial.Detail, cell, fraction);
}

template <typename Texel>
void CompareSamples(const Trial& trial)
{
  const CodedSum<Texel> sum(trial.Base, trial.Detail, trial.Level, trial.Scale);
  const glm::ivec2 cells = sum.Coded.heights.size - 1;
  std::minstd_rand random(5);
  for (int k = 0; k < 300; ++k)
  {
    const glm::ivec2 cell(static_cast<int>(random() % static_cast<unsigned>(cells.x)),
      static_cast<int>(random() % static_cast<unsigned>(cells.y)));
    const glm::vec2 fraction(random() % 17u / 16.0f, random() % 17u / 16.0f);
    const glm::vec4 codes = sum.Coded.heights.CellCodes(cell);
    const double height = Definition(trial, cell, fraction);
    if (!std::isfinite(height))
    {
      ASSERT_LT(codes.x, 0.0f);
      continue;
    }
    ASSERT_NEAR(sum.Codes.ToHeight(terrain::PatchCode(codes, fraction)), height,
      1e-6 * (sum.Codes.MaximumCode + 1.0));
  }
}

TEST(DetailHeights, AreTheSumOfBaseAndRepeatedDetail)
{
  for (const Trial& trial : Trials())
  {
    SCOPED_TRACE(trial.Base.Name);
    CompareSamples<float>(trial);
    if (trial.Base.Name != "far from zero") // which integers cannot hold
    {
      CompareSamples<std::uint16_t>(trial);
    }
  }
}

// Every sample of every cell of a node lies between the node's bounds, but for rounding.
TEST(DetailHeights, LieWithinTheBoundsOfTheirNodes)
{
  for (const Trial& trial : Trials())
  {
    SCOPED_TRACE(trial.Base.Name);
    const CodedSum<std::uint16_t> sum(trial.Base, trial.Detail, trial.Level, trial.Scale);
    const glm::ivec2 cells = sum.Coded.heights.size - 1;
    const float rounding = 1e-6f * (sum.Coded.heights.maximumCode + 1.0f);
    for (int level = 1; level <= sum.Pyramid.LevelCount(); ++level)
    {
      for (int j = 0; j < cells.y; ++j)
      {
        for (int i = 0; i < cells.x; ++i)
        {
          const glm::vec4 codes = sum.Coded.heights.CellCodes({ i, j });
          const terrain::CodeBounds bounds = sum.Pyramid.At({ i >> level, j >> level }, level);
          ASSERT_TRUE(codes.x < 0.0f ||
            (glm::all(glm::lessThanEqual(codes, glm::vec4(bounds.Maximum + rounding))) &&
              glm::all(glm::greaterThanEqual(codes, glm::vec4(bounds.Minimum - rounding)))))
            << "cell " << i << ", " << j << " level " << level;
        }
      }
    }
  }
}

// Neighbouring cells have the same codes where they touch, to the bit: else rays slip through.
TEST(DetailHeights, AreContinuousAcrossCells)
{
  for (const Trial& trial : Trials())
  {
    SCOPED_TRACE(trial.Base.Name);
    const CodedSum<float> sum(trial.Base, trial.Detail, trial.Level, trial.Scale);
    const auto& heights = sum.Coded.heights;
    for (int j = 0; j + 2 < heights.size.y; ++j)
    {
      for (int i = 0; i + 2 < heights.size.x; ++i)
      {
        const glm::vec4 here = heights.CellCodes({ i, j });
        const glm::vec4 east = heights.CellCodes({ i + 1, j });
        const glm::vec4 north = heights.CellCodes({ i, j + 1 });
        ASSERT_TRUE(here.x < 0.0f || east.x < 0.0f || (here.y == east.x && here.w == east.z));
        ASSERT_TRUE(here.x < 0.0f || north.x < 0.0f || (here.z == north.x && here.w == north.y));
      }
    }
  }
}

// Rays through base and detail meet what brute force meets on the cells of the sum.
TEST(DetailHeights, AreTracedExactly)
{
  unsigned seed = 3;
  for (const Trial& trial : Trials())
  {
    SCOPED_TRACE(trial.Base.Name);
    CodedSum<std::uint16_t> sum(trial.Base, trial.Detail, trial.Level, trial.Scale);
    terrain::RayMaker maker(
      sum.Coded.heights.size, sum.Codes.MaximumCode, ++seed, !sum.Codes.HasNoData);
    int agree = 0;
    const int count = 300;
    for (int k = 0; k < count; ++k)
    {
      sum.Coded.start = 1 + k % 8;
      const terrain::TerrainRay ray = maker.Make();
      const terrain::TerrainHit hit = sum.Coded.TracePyramid(ray);
      const double reference = terrain::FirstMeeting(terrain::RayPieces(sum.Coded.heights, ray));
      agree += hit.found ? std::abs(hit.s - reference) < 1e-4 : std::isinf(reference);
    }
    EXPECT_GE(agree, 0.97 * count); // the rest grazes, or lies in the surface
  }
}

// Detail makes rays work more only where it is: the nodes visited stay of the order of the levels.
TEST(DetailHeights, AreCrossedInFewNodes)
{
  const TestField base = terrain::AdversarialFields()[7]; // hills
  const CodedSum<std::uint16_t> sum(base, terrain::RandomDetail({ 32, 32 }, 0.5, 1), 6, 1.0);
  terrain::RayMaker maker(sum.Coded.heights.size, sum.Codes.MaximumCode, 11, true);
  int crossings = 0;
  const int count = 500;
  for (int k = 0; k < count; ++k)
  {
    crossings += sum.Coded.TracePyramid(maker.Make()).crossings;
  }
  EXPECT_LT(crossings, 80 * count); // of up to 8192 cells along the way
}
}
