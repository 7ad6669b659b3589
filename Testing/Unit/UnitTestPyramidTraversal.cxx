// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestRays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace
{
using terrain::CellPiece;
using terrain::CodedField;
using terrain::RayBetween;
using terrain::TerrainHit;
using terrain::TerrainRay;

// Bound of the error of heights along a ray in float, codes: of the ray's height itself, and of its
// position times the steepest slope.
template <typename Texel>
double HeightError(const CodedField<Texel>& field, const TerrainRay& ray)
{
  const double maximum = field.Codes.MaximumCode;
  const double run = glm::length(glm::dvec2(ray.directionGC)) + field.Texels.size() / 100.0;
  return 1e-6 * (maximum + std::abs(ray.originGC.z) + std::abs(ray.directionGC.z)) +
    2e-7 * run * maximum;
}

// What every trace must satisfy: a hit lies on the surface, and no surface lies before it.
template <typename Texel>
void ExpectExact(const CodedField<Texel>& field, const TerrainRay& ray, const TerrainHit& hit)
{
  const std::vector<CellPiece> pieces = terrain::RayPieces(field.Coded.heights, ray);
  const double error = HeightError(field, ray);
  const double before = hit.found ? hit.s : std::numeric_limits<double>::infinity();
  ASSERT_LE(terrain::Penetration(pieces, before), error) << "passed through";
  if (!hit.found)
  {
    return;
  }
  const glm::dvec3 position = glm::dvec3(ray.originGC) +
    glm::dvec3(ray.directionGC) * static_cast<double>(hit.s) +
    glm::dvec3(ray.anchorCell.x, ray.anchorCell.y, 0.0);
  const glm::dvec2 fraction(hit.fraction);
  const glm::dvec4 codes(field.Coded.heights.CellCodes(hit.cell));
  const double south = codes.x * (1.0 - fraction.x) + codes.y * fraction.x;
  const double north = codes.z * (1.0 - fraction.x) + codes.w * fraction.x;
  ASSERT_GE(std::min(std::min(codes.x, codes.y), std::min(codes.z, codes.w)), 0.0);
  ASSERT_NEAR(position.z, south * (1.0 - fraction.y) + north * fraction.y, error) << "not on it";
  ASSERT_NEAR(position.x, hit.cell.x + fraction.x, 1e-5 * (1.0 + field.Coded.heights.size.x));
  ASSERT_NEAR(position.y, hit.cell.y + fraction.y, 1e-5 * (1.0 + field.Coded.heights.size.y));
}

template <typename Texel>
void TraceRandomRays(int count)
{
  unsigned seed = 1;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    CodedField<Texel> field(test);
    terrain::RayMaker maker(
      { test.Width, test.Height }, field.Codes.MaximumCode, ++seed, !field.Codes.HasNoData);
    int agree = 0;
    for (int trial = 0; trial < count; ++trial)
    {
      SCOPED_TRACE(trial);
      field.Coded.start = 1 + trial % 8;
      const TerrainRay ray = maker.Make();
      const TerrainHit hit = field.Coded.TracePyramid(ray);
      ExpectExact(field, ray, hit);
      const double reference = terrain::FirstMeeting(terrain::RayPieces(field.Coded.heights, ray));
      agree += hit.found ? std::abs(hit.s - reference) < 1e-4 : std::isinf(reference);
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
    // The rest grazes, or lies in the surface.
    EXPECT_GE(agree, 0.97 * count);
  }
}

TEST(PyramidTraversal, IsExactOnIntegers)
{
  TraceRandomRays<std::uint16_t>(2000);
}

TEST(PyramidTraversal, IsExactOnFloats)
{
  TraceRandomRays<float>(2000);
}

TEST(PyramidTraversal, FindsNothingWithoutCells)
{
  for (const auto& [width, height] : { std::pair{ 1, 1 }, { 1, 9 }, { 9, 1 } })
  {
    const CodedField<std::uint16_t> field(
      terrain::TestField("", width, height, [](int, int) { return 1.0; }));
    EXPECT_FALSE(field.Coded.TracePyramid(RayBetween({ 0.0, 0.0, 9.0 }, { 0.0, 0.0, -9.0 })).found);
    EXPECT_FALSE(field.Coded.TracePyramid(RayBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 })).found);
  }
}

TEST(PyramidTraversal, FindsNothingWithoutData)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const CodedField<std::uint16_t> field(
    terrain::TestField("", 9, 9, [=](int, int) { return none; }));
  EXPECT_FALSE(field.Coded.TracePyramid(RayBetween({ 4.0, 4.0, 9.0 }, { 5.0, 4.0, -9.0 })).found);
}

// Empty and undefined rays end, and find nothing.
TEST(PyramidTraversal, EndsForDegenerateRays)
{
  const CodedField<float> field(terrain::AdversarialFields()[7]); // hills
  const float none = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  TerrainRay ray = RayBetween({ 30.0, 30.0, 900.0 }, { 30.0, 31.0, -900.0 });
  ray.sEnd = -1.0f;
  EXPECT_FALSE(field.Coded.TracePyramid(ray).found);
  ray = RayBetween({ 30.0, 30.0, 900.0 }, { 30.0, 30.0, 900.0 });
  EXPECT_FALSE(field.Coded.TracePyramid(ray).found);
  for (const float value : { none, infinite, -infinite })
  {
    for (int component = 0; component < 3; ++component)
    {
      ray = RayBetween({ 30.0, 30.0, 900.0 }, { 31.0, 31.0, -900.0 });
      ray.directionGC[component] = value;
      EXPECT_FALSE(field.Coded.TracePyramid(ray).found);
      ray = RayBetween({ 30.0, 30.0, 900.0 }, { 31.0, 31.0, -900.0 });
      ray.originGC[component] = value;
      EXPECT_FALSE(field.Coded.TracePyramid(ray).found);
    }
  }
}

TEST(PyramidTraversal, MeetsTheSurfaceFromBothSides)
{
  const CodedField<std::uint16_t> field(terrain::AdversarialFields()[7]); // hills
  const TerrainHit above =
    field.Coded.TracePyramid(RayBetween({ 20.3, 17.8, 2e3 }, { 20.3, 17.8, -2e3 }));
  const TerrainHit below =
    field.Coded.TracePyramid(RayBetween({ 20.3, 17.8, -2e3 }, { 20.3, 17.8, 2e3 }));
  ASSERT_TRUE(above.found);
  ASSERT_TRUE(below.found);
  EXPECT_EQ(above.cell, glm::ivec2(20, 17));
  EXPECT_EQ(below.cell, above.cell);
  EXPECT_NEAR(above.s, 1.0 - below.s, 1e-6);
}

// Rays from above the surface to below it have to meet it, wherever and however steeply they go.
TEST(PyramidTraversal, LetsNoRayThroughAClosedSurface)
{
  const std::vector<terrain::TestField> fields = terrain::AdversarialFields();
  for (const int index : { 0, 1, 2, 4, 6, 7, 14 })
  {
    SCOPED_TRACE(fields[static_cast<std::size_t>(index)].Name);
    CodedField<float> field(fields[static_cast<std::size_t>(index)]);
    const double top = 1.01 * field.Codes.MaximumCode + 1e-3;
    const glm::dvec2 cells(field.Coded.heights.size - 1);
    terrain::RayMaker maker(field.Coded.heights.size, 1.0, 77);
    int missed = 0;
    for (int trial = 0; trial < 150000; ++trial)
    {
      // Some through vertices, on edges, on diagonals.
      glm::dvec2 begin(maker.Uniform(0.0, cells.x), maker.Uniform(0.0, cells.y));
      glm::dvec2 end(maker.Uniform(0.0, cells.x), maker.Uniform(0.0, cells.y));
      begin = trial % 3 == 0 ? glm::floor(begin) : begin;
      end = trial % 4 == 0 ? glm::floor(end) : end;
      end.y = trial % 5 == 0 ? begin.y : end.y;
      field.Coded.start = 1 + trial % 7;
      const bool down = trial % 2 == 0;
      const glm::dvec3 from(begin, down ? top : -0.01 * top);
      const glm::dvec3 to(end, down ? -0.01 * top : top);
      missed += !field.Coded.TracePyramid(RayBetween(from, to)).found;
    }
    EXPECT_EQ(missed, 0);
  }
}

// An eye a quarter of a code above ground of 15,000 codes, looking along it.
TEST(PyramidTraversal, ResolvesTheGroundBesideTheEye)
{
  const CodedField<float> field(terrain::TestField(
    "", 300, 6, [](int i, int j) { return i == 0 && j == 0 ? 0.0 : 15000.0 + 3.0 * i; }));
  const TerrainRay ray = RayBetween({ 20.5, 2.5, 15061.7501 }, { 220.5, 2.5, 15661.2501 });
  const TerrainHit hit = field.Coded.TracePyramid(ray);
  ASSERT_TRUE(hit.found);
  EXPECT_NEAR(hit.s, 0.5002, 1e-4);
}

// Two rays to the same edge, from the cells on its two sides: no position on it lets one through.
TEST(PyramidTraversal, SeesTheSameHeightsOnSharedEdges)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int trial = 0; trial < 10000; ++trial)
  {
    glm::vec4 west;
    glm::vec4 east;
    for (int k = 0; k < 4; ++k)
    {
      west[k] = uniform(generator) * 1e3f;
      east[k] = uniform(generator) * 1e3f;
    }
    east.x = west.y;
    east.z = west.w;
    const float v = uniform(generator);
    EXPECT_EQ(terrain::PatchCode(west, { 1.0f, v }), terrain::PatchCode(east, { 0.0f, v }));
  }
}

// From cell to cell along a ray: the height of the surface at the exit of one is, to the bit, that
// at the entry of the next.
TEST(PyramidTraversal, SeesTheSameHeightsAtExitAndEntry)
{
  const terrain::TestField test = terrain::AdversarialFields()[6]; // random
  const CodedField<float> field(test);
  const auto& coded = field.Coded;
  terrain::RayMaker maker({ test.Width, test.Height }, field.Codes.MaximumCode, 9);
  int lines = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    const auto path = coded.ClipPath(coded.MirrorRay(maker.Make()));
    auto at = coded.FirstStep(path);
    bool ended = !(path.sBegin <= path.sEnd);
    while (!ended)
    {
      at.level = 0;
      const auto span = coded.NodeSpan(path, at);
      ended = span.ends;
      const auto next = coded.NextStep(path, at, span, false, span.s);
      if (!ended)
      {
        const glm::vec2 exit =
          coded.CellFraction(path, at.cell, span.s, span.crossEast ? 1 : 2, 1.0f);
        const glm::vec2 entry = coded.CellFraction(path, next.cell, next.s, next.line, 0.0f);
        ASSERT_EQ(terrain::PatchCode(coded.heights.CellCodes(at.cell ^ path.mirror), exit),
          terrain::PatchCode(coded.heights.CellCodes(next.cell ^ path.mirror), entry));
        ++lines;
      }
      at = next;
    }
  }
  EXPECT_GT(lines, 5000);
}

TEST(PyramidTraversal, FirstRootKnowsItsCases)
{
  EXPECT_EQ(terrain::FirstRoot(0.0f, 0.0f, 0.0f), 0.0f);   // in the surface
  EXPECT_EQ(terrain::FirstRoot(0.0f, 1.0f, 0.0f), 0.0f);   // starts on it
  EXPECT_EQ(terrain::FirstRoot(1.0f, 0.0f, 0.0f), 1.0f);   // ends on it
  EXPECT_EQ(terrain::FirstRoot(1.0f, -1.0f, 0.0f), 0.5f);  // linear
  EXPECT_EQ(terrain::FirstRoot(-1.0f, 3.0f, 0.0f), 0.25f); // from below
  EXPECT_EQ(terrain::FirstRoot(1.0f, 1.0f, 0.0f), -1.0f);  // parallel
  EXPECT_EQ(terrain::FirstRoot(1.0f, 1.0f, 4.0f), 0.5f);   // touches
  EXPECT_EQ(terrain::FirstRoot(1.0f, 1.0f, 3.9f), -1.0f);
  EXPECT_EQ(terrain::FirstRoot(1.0f, 1.0f, -8.0f), -1.0f);          // bends away
  EXPECT_NEAR(terrain::FirstRoot(3.0f, 3.0f, 16.0f), 0.25f, 1e-6f); // dips: the first of two
  EXPECT_NEAR(terrain::FirstRoot(-3.0f, -3.0f, -16.0f), 0.25f, 1e-6f);
  EXPECT_NEAR(terrain::FirstRoot(1e-6f, -1.0f, 1e-12f), 1e-6f, 1e-12f); // without cancellation
}

TEST(PyramidTraversal, VisitsFewNodesWhenNothingIsMet)
{
  CodedField<std::uint16_t> field(terrain::TestField(
    "", 4097, 4097, [](int i, int j) { return i == 4096 && j == 4096 ? 1000.0 : 100.0; }));
  field.Coded.start = 12;
  const TerrainHit hit =
    field.Coded.TracePyramid(RayBetween({ 0.5, 7.5, 105.0 }, { 4095.5, 4000.5, 104.0 }));
  EXPECT_FALSE(hit.found);
  EXPECT_LE(hit.crossings, 60);
}
}
