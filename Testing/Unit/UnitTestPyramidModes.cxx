// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The other surface of the traversal, columns around the samples, and its tolerance.
#include "UnitTestRays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using terrain::CellPiece;
using terrain::CodedField;
using terrain::RayBetween;
using terrain::TerrainHit;
using terrain::TerrainRay;

// True if the columns' surface, tops and walls, passes within error (codes) of the ray at s.
bool IsOnColumns(const std::vector<CellPiece>& pieces, double s, double error)
{
  bool above = false;
  bool below = false;
  for (const CellPiece& piece : pieces)
  {
    if (s >= piece.Begin - 1e-5 && s <= piece.End + 1e-5)
    {
      above = above || piece.At(s) >= -error;
      below = below || piece.At(s) <= error;
    }
  }
  return above && below;
}

TEST(PyramidColumns, AreExact)
{
  unsigned seed = 40;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    CodedField<std::uint16_t> field(test);
    field.Coded.columns = true;
    terrain::RayMaker maker(
      { test.Width, test.Height }, field.Codes.MaximumCode, ++seed, !field.Codes.HasNoData);
    int hits = 0;
    for (int trial = 0; trial < 1500; ++trial)
    {
      SCOPED_TRACE(trial);
      field.Coded.start = 1 + trial % 8;
      const TerrainRay ray = maker.Make();
      const TerrainHit hit = field.Coded.TracePyramid(ray);
      std::vector<CellPiece> pieces = terrain::RayPieces(field.Coded.heights, ray, true);
      const double error =
        2e-6 * (field.Codes.MaximumCode + std::abs(ray.originGC.z) + std::abs(ray.directionGC.z));
      // Float does not tell apart from a miss what cuts a wall's corner by 1e-4 of a cell, or
      // slides along it.
      const double before = hit.found ? hit.s - 1e-5 : std::numeric_limits<double>::infinity();
      hits += hit.found;
      const double steep = 1e-5 * std::abs(ray.directionGC.z);
      if (hit.found)
      {
        ASSERT_TRUE(IsOnColumns(pieces, hit.s, error + steep));
      }
      pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                     [&](const CellPiece& piece)
                     {
                       const double run = glm::length(glm::dvec2(ray.directionGC));
                       return run > 0.0 && (piece.End - piece.Begin) * run < 1e-4;
                     }),
        pieces.end());
      ASSERT_LE(terrain::Penetration(pieces, before), error + steep);
    }
    EXPECT_GT(hits, 200);
  }
}

TEST(PyramidColumns, MeetTopsAndWalls)
{
  // One column of height 10 around sample (2, 2), on ground 0.
  CodedField<std::uint16_t> field(
    terrain::TestField("", 5, 5, [](int i, int j) { return i == 2 && j == 2 ? 10.0 : 0.0; }));
  field.Coded.columns = true;
  const TerrainHit top =
    field.Coded.TracePyramid(RayBetween({ 2.4, 1.6, 20.0 }, { 2.4, 1.6, -20.0 }));
  ASSERT_TRUE(top.found);
  EXPECT_FLOAT_EQ(top.s, 0.25f);
  const TerrainHit wall =
    field.Coded.TracePyramid(RayBetween({ 0.0, 2.25, 5.0 }, { 4.0, 2.25, 5.0 }));
  ASSERT_TRUE(wall.found);
  EXPECT_FLOAT_EQ(wall.s, 1.5f / 4.0f);
  EXPECT_EQ(wall.cell, glm::ivec2(1, 2));
  EXPECT_FLOAT_EQ(wall.fraction.x, 0.5f);
  const TerrainHit inside =
    field.Coded.TracePyramid(RayBetween({ 2.0, 2.0, 5.0 }, { 2.0, 4.0, 5.0 }));
  ASSERT_TRUE(inside.found); // the wall from within
  EXPECT_FLOAT_EQ(inside.s, 0.25f);
  EXPECT_FALSE(field.Coded.TracePyramid(RayBetween({ 0.0, 2.75, 5.0 }, { 4.0, 2.75, 5.0 })).found);
}

TEST(PyramidColumns, LetNoRayThrough)
{
  const std::vector<terrain::TestField> fields = terrain::AdversarialFields();
  for (const int index : { 0, 1, 2, 6, 7 })
  {
    SCOPED_TRACE(fields[static_cast<std::size_t>(index)].Name);
    CodedField<float> field(fields[static_cast<std::size_t>(index)]);
    field.Coded.columns = true;
    const double top = 1.01 * field.Codes.MaximumCode + 1e-3;
    const glm::dvec2 cells(field.Coded.heights.size - 1);
    terrain::RayMaker maker(field.Coded.heights.size, 1.0, 78);
    int missed = 0;
    for (int trial = 0; trial < 50000; ++trial)
    {
      // Some through the middle of cells, where four columns meet, and along their walls.
      glm::dvec2 begin(maker.Uniform(0.0, cells.x), maker.Uniform(0.0, cells.y));
      glm::dvec2 end(maker.Uniform(0.0, cells.x), maker.Uniform(0.0, cells.y));
      begin = trial % 3 == 0 ? glm::floor(begin) + 0.5 : begin;
      end = trial % 4 == 0 ? glm::floor(end) + 0.5 : end;
      end.y = trial % 5 == 0 ? begin.y : end.y;
      const bool down = trial % 2 == 0;
      missed += !field.Coded
                   .TracePyramid(RayBetween(glm::dvec3(begin, down ? top : -0.01 * top),
                     glm::dvec3(end, down ? -0.01 * top : top)))
                   .found;
    }
    EXPECT_EQ(missed, 0);
  }
}

TEST(PyramidColumns, HaveFacesAlongTheAxes)
{
  const glm::vec4 codes(
    10.0f, 30.0f, 10.0f, 5.0f); // south-west, south-east, north-west, north-east
  const auto face = [&codes](float x, float y, const glm::vec3& direction) {
    return terrain::FindColumnFace(codes, { x, y }, direction);
  };
  // a top, from above and from below
  terrain::ColumnFace found = face(0.2f, 0.7f, { 1.0f, 1.0f, -1.0f });
  EXPECT_EQ(found.normal, glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_TRUE(found.front);
  EXPECT_EQ(found.code, 10.0f);
  EXPECT_FALSE(face(0.2f, 0.7f, { 1.0f, 1.0f, 1.0f }).front);
  // the wall between 10 and 30, from the low side and from within the high column
  found = face(0.5f, 0.2f, { 1.0f, 0.5f, -1.0f });
  EXPECT_EQ(found.normal, glm::vec3(-1.0f, 0.0f, 0.0f));
  EXPECT_TRUE(found.front);
  EXPECT_EQ(found.code, 30.0f);
  found = face(0.5f, 0.2f, { -1.0f, 0.5f, -1.0f });
  EXPECT_EQ(found.normal, glm::vec3(-1.0f, 0.0f, 0.0f));
  EXPECT_FALSE(found.front);
  // between 30 and 5, going north: the high column comes first
  found = face(0.8f, 0.5f, { 0.2f, 1.0f, 0.0f });
  EXPECT_EQ(found.normal, glm::vec3(0.0f, 1.0f, 0.0f));
  EXPECT_FALSE(found.front);
  // no wall where columns are equally high
  EXPECT_EQ(face(0.2f, 0.5f, { 0.2f, 1.0f, -1.0f }).normal, glm::vec3(0.0f, 0.0f, 1.0f));
  // straight down there is none either
  EXPECT_EQ(face(0.5f, 0.5f, { 0.0f, 0.0f, -1.0f }).normal, glm::vec3(0.0f, 0.0f, 1.0f));
}

// With a tolerance the hit comes no later than the exact one, and a surface is within a node's box.
TEST(PyramidTolerance, EndsInBoxesOfItsSize)
{
  unsigned seed = 60;
  int early = 0;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    CodedField<std::uint16_t> field(test);
    field.Coded.start = 6;
    terrain::RayMaker maker({ test.Width, test.Height }, field.Codes.MaximumCode, ++seed);
    int exactVisits = 0;
    int visits = 0;
    for (int trial = 0; trial < 500; ++trial)
    {
      const TerrainRay ray = maker.Make();
      const double cells = maker.Uniform(0.0, 9.0);
      const double codes = maker.Uniform(0.0, 1.0) * field.Codes.MaximumCode;
      const TerrainHit exact = field.Coded.TracePyramid(ray);
      const TerrainHit hit = field.Coded.TracePyramidWithin(
        ray, glm::vec4(cells, codes, 0.0f, 0.0f), [](glm::ivec2, int) {});
      exactVisits += exact.crossings;
      visits += hit.crossings;
      ASSERT_TRUE(hit.found || !exact.found);
      if (!hit.found || (exact.found && hit.s == exact.s))
      {
        continue;
      }
      ++early;
      ASSERT_TRUE(field.Coded.IsCellValid(hit.cell));
      ASSERT_TRUE(!exact.found || hit.s <= exact.s + 1e-5);
      // Some sample near the hit lies within the tolerance of its height.
      const double z = ray.originGC.z + static_cast<double>(ray.directionGC.z) * hit.s;
      double nearest = std::numeric_limits<double>::infinity();
      const int reach = static_cast<int>(cells) + 1;
      for (int j = std::max(hit.cell.y - reach, 0);
           j < std::min(hit.cell.y + reach + 2, test.Height); ++j)
      {
        for (int i = std::max(hit.cell.x - reach, 0);
             i < std::min(hit.cell.x + reach + 2, test.Width); ++i)
        {
          const float code = field.Coded.heights.Code({ i, j });
          nearest = code < 0.0f ? nearest : std::min(nearest, std::abs(z - code));
        }
      }
      ASSERT_LE(nearest, codes + 1e-5 * (field.Codes.MaximumCode + std::abs(ray.directionGC.z)));
    }
    EXPECT_LE(visits, exactVisits);
  }
  EXPECT_GT(early, 500);
}

TEST(PyramidTolerance, GrowsWithDistance)
{
  CodedField<std::uint16_t> field(terrain::AdversarialFields()[7]); // hills
  field.Coded.start = 6;
  const TerrainRay ray = RayBetween({ 2.0, 3.0, 900.0 }, { 60.0, 55.0, 100.0 });
  int lowest = 99;
  const auto visit = [&](glm::ivec2, int level) { lowest = std::min(lowest, level); };
  field.Coded.TracePyramidWithin(ray, glm::vec4(0.0f, 0.0f, 1.0f, 1e4f), visit);
  EXPECT_EQ(lowest, 0); // less than one cell all the way
  lowest = 99;
  field.Coded.TracePyramidWithin(ray, glm::vec4(0.0f, 0.0f, 20.0f, 1e4f), visit);
  EXPECT_GE(lowest, 2);
}
}
