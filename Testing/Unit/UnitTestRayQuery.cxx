// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Queries against every cell of a field in double precision, and against closed forms.
#include "UnitTestQueries.h"

#include "core/grid/HeightSampling.h"
#include "core/surface/Cutting.h"
#include "core/surface/HeightsWithDetail.h"

#include <gtest/gtest.h>

#include <memory>
#include <tuple>

namespace
{
using terrain::FieldCodes;
using terrain::QueryRay;
using terrain::RayQuery;
using terrain::SurfaceHit;
using terrain::SurfaceOf;
using terrain::ToQuery;

/// Height of the ray above the lowest height.
double RayCode(const QueryRay& ray, double distance, double low)
{
  return ray.Origin.z - low + distance * (ray.Direction.z + distance * ray.Bend);
}

/// The largest coordinate in cells, and more, of which kQueryError is a part.
double LargestCoordinate(const QueryRay& ray, const glm::ivec2& size)
{
  return glm::length(glm::dvec2(ray.Origin)) + glm::length(glm::dvec2(ray.Direction)) +
    glm::length(glm::dvec2(size));
}

/// Heights: a position that is off is on another part of a slope; and what doubles round.
double HeightTolerance(const QueryRay& ray, const FieldCodes& codes, double bend)
{
  const double steepest = 1.0 + codes.High - codes.Low + std::abs(ray.Direction.z) + std::abs(bend);
  return terrain::kQueryError *
    ((1.0 + LargestCoordinate(ray, codes.size)) * steepest + std::abs(codes.Low) +
      std::abs(ray.Origin.z));
}

/// Checks queries of a field with rays of all kinds against all its cells.
void ExpectExact(const terrain::TestField& field, terrain::SurfaceKind kind, bool bent)
{
  SCOPED_TRACE(field.Name);
  const FieldCodes codes(field);
  const RayQuery query(SurfaceOf(field, kind));
  const bool columns = kind == terrain::SurfaceKind::Columns;
  const double relief = std::max(codes.High - codes.Low, 1e-3);
  // rays on edges have a choice at the rim of holes
  const bool holes =
    std::any_of(field.Samples.begin(), field.Samples.end(), [](double h) { return std::isnan(h); });
  terrain::RayMaker maker(codes.size, codes.High - codes.Low, 41, !holes && !columns);
  int hits = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const terrain::TerrainRay ray = maker.Make();
    const bool vertical = ray.directionGC.x == 0.0f && ray.directionGC.y == 0.0f;
    const double bend = bent && !vertical ? maker.Uniform(-2.0, 4.0) * relief : 0.0;
    const QueryRay asked = ToQuery(ray, codes.Low, bend);
    std::vector<terrain::CellPiece> pieces = terrain::RayPieces(codes, ray, columns);
    for (terrain::CellPiece& piece : pieces)
    {
      piece.A += bend;
    }
    const double largest = LargestCoordinate(asked, codes.size);
    const double tolerance = HeightTolerance(asked, codes, bend);
    const SurfaceHit hit = query.First(asked);
    EXPECT_EQ(hit.Found, query.Any(asked));
    EXPECT_LE(
      terrain::Penetration(pieces, hit.Found ? hit.Distance - 1e-9 : terrain::kInfinity), tolerance)
      << i;
    if (hit.Found)
    {
      ++hits;
      const glm::dvec2 position = glm::dvec2(hit.Cell) + hit.Fraction;
      const glm::dvec2 expected =
        glm::dvec2(asked.Origin) + hit.Distance * glm::dvec2(asked.Direction);
      EXPECT_LE(glm::length(position - expected), terrain::kQueryError * largest) << i;
      EXPECT_NEAR(hit.Height - codes.Low, RayCode(asked, hit.Distance, codes.Low), tolerance) << i;
    }
  }
  EXPECT_GT(hits, columns || holes ? 50 : 200);
}

//------------------------------------------------------------------------------
// The part of a ray within a block, and the axis of the face where it enters: -1 if it begins
// within.
std::tuple<double, double, int> EnterBlock(
  const QueryRay& ray, const glm::dvec3& low, const glm::dvec3& high)
{
  double begin = ray.Begin;
  double end = ray.End;
  int axis = -1;
  for (int k = 0; k < 3; ++k)
  {
    const double to[2] = { (low[k] - ray.Origin[k]) / ray.Direction[k],
      (high[k] - ray.Origin[k]) / ray.Direction[k] };
    const double enter = ray.Direction[k] == 0.0
      ? (ray.Origin[k] < low[k] || ray.Origin[k] > high[k] ? 2.0 : 0.0)
      : std::min(to[0], to[1]);
    axis = enter > begin ? k : axis;
    begin = std::max(begin, enter);
    end = std::min(end, ray.Direction[k] == 0.0 ? end : std::max(to[0], to[1]));
  }
  return { begin, end, axis };
}
}

//------------------------------------------------------------------------------
// Nothing to meet, and rays that are none, first.
TEST(RayQuery, MeetsNothingWhereThereIsNothing)
{
  QueryRay down;
  down.Origin = { 0.5, 0.5, 10.0 };
  EXPECT_FALSE(RayQuery(terrain::Surface{}).First(down).Found);
  EXPECT_TRUE(std::isnan(RayQuery(terrain::Surface{}).HeightAt(0.0, 0.0)));
  const auto none = [](int, int) { return terrain::kNaN; };
  const auto flat = [](int, int) { return 1.0; };
  for (const auto& field :
    { terrain::TestField("empty", 0, 0, flat), terrain::TestField("sample", 1, 1, flat),
      terrain::TestField("row", 9, 1, flat), terrain::TestField("hole", 9, 9, none) })
  {
    SCOPED_TRACE(field.Name);
    const RayQuery query(SurfaceOf(field));
    EXPECT_FALSE(query.First(down).Found);
    EXPECT_FALSE(query.Any(down));
    QueryRay level = down;
    level.Direction = { 1.0, 0.0, 0.0 };
    EXPECT_EQ(query.Highest(level).Height, -terrain::kInfinity);
    EXPECT_TRUE(query.GetSurface().GetBounds().IsEmpty());
  }
}

//------------------------------------------------------------------------------
TEST(RayQuery, RefusesRaysThatAreNone)
{
  const terrain::TestField field("flat", 5, 5, [](int, int) { return 1.0; });
  const RayQuery query(SurfaceOf(field));
  QueryRay ray;
  ray.Origin = { 1.5, 1.5, 10.0 };
  EXPECT_TRUE(query.First(ray).Found);
  for (const glm::dvec3& direction : { glm::dvec3(0.0), glm::dvec3(0.0, 0.0, terrain::kNaN),
         glm::dvec3(0.0, 0.0, -terrain::kInfinity), glm::dvec3(0.0, 0.0, 1.0) })
  {
    QueryRay other = ray;
    other.Direction = direction;
    EXPECT_FALSE(query.First(other).Found);
  }
  QueryRay other = ray;
  other.Origin.x = terrain::kNaN;
  EXPECT_FALSE(query.First(other).Found);
  other = ray;
  other.End = -1.0;
  EXPECT_FALSE(query.First(other).Found);
  other = ray;
  other.Begin = terrain::kNaN;
  EXPECT_FALSE(query.First(other).Found);
}

//------------------------------------------------------------------------------
TEST(RayQuery, IsExactOnAdversarialFields)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    ExpectExact(field, terrain::SurfaceKind::Bilinear, false);
  }
}

//------------------------------------------------------------------------------
TEST(RayQuery, IsExactForBentRays)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    ExpectExact(field, terrain::SurfaceKind::Bilinear, true);
  }
}

//------------------------------------------------------------------------------
TEST(RayQuery, IsExactForColumns)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    ExpectExact(field, terrain::SurfaceKind::Columns, false);
    ExpectExact(field, terrain::SurfaceKind::Columns, true);
  }
}

//------------------------------------------------------------------------------
// Both cells of a line count, so that a ray along the rim of a hole meets the cell beside it.
TEST(RayQuery, MeetsCellsOnBothSidesOfALine)
{
  const terrain::TestField west(
    "west", 5, 5, [](int i, int) { return i > 2 ? terrain::kNaN : 2.0; });
  const terrain::TestField east(
    "east", 5, 5, [](int i, int) { return i < 2 ? terrain::kNaN : 2.0; });
  for (const terrain::TestField& field : { west, east })
  {
    SCOPED_TRACE(field.Name);
    const RayQuery query(SurfaceOf(field));
    QueryRay ray;
    ray.Origin = { 2.0, 2.0, 10.0 };
    EXPECT_DOUBLE_EQ(query.First(ray).Distance, 8.0);
    ray.Direction = { 0.0, 0.25, -1.0 };
    EXPECT_DOUBLE_EQ(query.First(ray).Distance, 8.0);
  }
}

//------------------------------------------------------------------------------
// The frame: origin, spacing and exaggeration, and what comes back in model coordinates.
TEST(RayQuery, WorksInTheFrame)
{
  const terrain::TestField field("slope", 9, 9, [](int i, int) { return 10.0 * i; });
  terrain::Surface surface = SurfaceOf(field);
  surface.Frame.Origin = { 500000.0, 4000000.0, 100.0 };
  surface.Frame.Spacing = { 20.0, 30.0 };
  surface.Frame.Exaggeration = 2.0;
  const RayQuery query(surface);
  QueryRay ray;
  ray.Origin = { 500050.0, 4000045.0, 1000.0 };
  const SurfaceHit hit = query.First(ray);
  ASSERT_TRUE(hit.Found);
  EXPECT_DOUBLE_EQ(hit.Height, 25.0);
  EXPECT_DOUBLE_EQ(hit.Distance, 1000.0 - (100.0 + 2.0 * 25.0));
  EXPECT_NEAR(glm::length(hit.Normal - glm::normalize(glm::dvec3(-1.0, 0.0, 1.0))), 0.0, 1e-15);
  EXPECT_TRUE(hit.FromAbove);
  EXPECT_DOUBLE_EQ(query.HeightAt(500050.0, 4000045.0), 25.0);
  ray.Origin.z = 0.0;
  ray.Direction.z = 1.0;
  EXPECT_FALSE(query.First(ray).FromAbove);
  const terrain::ModelBounds bounds = surface.GetBounds();
  EXPECT_EQ(bounds.Low, glm::dvec3(500000.0, 4000000.0, 100.0));
  EXPECT_EQ(bounds.High, glm::dvec3(500160.0, 4000240.0, 260.0));
}

//------------------------------------------------------------------------------
// Over a flat map of the round earth a level line of sight of 10 km passes 6.8 m above the ground.
TEST(RayQuery, BendsLinesOfSightOverTheRoundEarth)
{
  const terrain::TestField field("sea", 101, 5, [](int, int) { return 0.0; });
  terrain::Surface surface = SurfaceOf(field);
  surface.Frame.Spacing = { 100.0, 100.0 };
  const RayQuery query(surface);
  QueryRay ray;
  ray.Origin = { 0.0, 150.0, 2.0 };
  ray.Direction = { 1000.0, 0.0, 0.0 };
  ray.Bend = terrain::EarthBend(1000.0, 0.13);
  EXPECT_NEAR(ray.Bend, 1e6 * 0.87 / (2.0 * 6371008.8), 1e-15);
  EXPECT_FALSE(query.Any(ray));
  const terrain::SurfaceSummit summit = query.Highest(ray);
  EXPECT_DOUBLE_EQ(summit.Height, -2.0);
  EXPECT_DOUBLE_EQ(summit.Distance, 0.0);
  // the horizon of an eye at 2 m: the line that touches the sea
  const double horizon = std::sqrt(2.0 / ray.Bend);
  ray.Direction.z = -2.0 * ray.Bend * horizon * (1.0 + 1e-9);
  EXPECT_TRUE(query.Any(ray));
  EXPECT_NEAR(query.First(ray).Distance, horizon, 1e-3);
  ray.Direction.z = -2.0 * ray.Bend * horizon * (1.0 - 1e-9);
  EXPECT_FALSE(query.Any(ray));
}

//------------------------------------------------------------------------------
TEST(RayQuery, FindsTheHighestPointAboveALine)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    const FieldCodes codes(field);
    const RayQuery query(SurfaceOf(field));
    terrain::RayMaker maker(codes.size, codes.High - codes.Low, 97, false);
    for (int i = 0; i < 500; ++i)
    {
      const terrain::TerrainRay ray = maker.Make();
      if (ray.directionGC.x == 0.0f && ray.directionGC.y == 0.0f)
      {
        continue;
      }
      const double bend = i % 2 == 0 ? 0.0 : maker.Uniform(-1.0, 1.0) * (codes.High - codes.Low);
      double highest = -terrain::kInfinity;
      for (terrain::CellPiece& piece : terrain::RayPieces(codes, ray))
      {
        piece.A += bend;
        highest = std::max(highest, -piece.Extremes(terrain::kInfinity)[0]);
      }
      const QueryRay asked = ToQuery(ray, codes.Low, bend);
      const terrain::SurfaceSummit summit = query.Highest(asked);
      const double tolerance = HeightTolerance(asked, codes, bend);
      if (std::isfinite(highest))
      {
        EXPECT_NEAR(summit.Height, highest, tolerance) << i;
      }
      else
      {
        EXPECT_EQ(summit.Height, highest) << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The sum of base and detail is the heightfield that HeightsWithDetail does not make.
TEST(RayQuery, MeetsDetail)
{
  constexpr int level = 3;
  constexpr double scale = 2.5;
  const std::vector<terrain::TestField> bases = terrain::AdversarialFields();
  for (const glm::ivec2& period : { glm::ivec2(16, 8), glm::ivec2(5, 7), glm::ivec2(1, 1) })
  {
    const terrain::TestField detail("detail", period.x, period.y,
      [](int i, int j) { return -3.0 + (7 * i * i + 11 * j * (i + 1)) % 13; });
    for (const char* name : { "random", "holes", "one cell", "3 x 5" })
    {
      const terrain::TestField& base = *std::find_if(bases.begin(), bases.end(),
        [&](const terrain::TestField& field) { return field.Name == name; });
      const int cells = 1 << level;
      const terrain::TestField sum(base.Name, (base.Width - 1) * cells + 1,
        (base.Height - 1) * cells + 1,
        [&](int i, int j)
        {
          const double h =
            terrain::SampleBilinear(base.View(), double(i) / cells, double(j) / cells);
          return h + scale * detail.View().At(i % period.x, j % period.y);
        });
      SCOPED_TRACE(base.Name);
      terrain::Surface surface;
      surface.Heights = std::make_shared<terrain::HeightsWithDetail>(SurfaceOf(base).Heights,
        std::make_shared<terrain::DetailPeriod>(detail.View()), level, scale);
      const RayQuery query(surface);
      const RayQuery expected(SurfaceOf(sum));
      const FieldCodes codes(sum);
      terrain::RayMaker maker(codes.size, codes.High - codes.Low, 5, false);
      for (int i = 0; i < 400; ++i)
      {
        const QueryRay ray = ToQuery(maker.Make(), codes.Low);
        const SurfaceHit hit = query.First(ray);
        const SurfaceHit other = expected.First(ray);
        ASSERT_EQ(hit.Found, other.Found) << i;
        if (hit.Found)
        {
          EXPECT_NEAR(hit.Distance, other.Distance, 1e-9) << i;
          EXPECT_NEAR(hit.Height, other.Height, 1e-6) << i;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// A block is met at its surface, or at the wall where a ray enters it below the surface.
TEST(RayQuery, MeetsTheWallsOfBlocks)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    if (field.Width < 8 || field.Height < 8 || field.Name == "holes" || field.Name == "half")
    {
      continue;
    }
    SCOPED_TRACE(field.Name);
    const FieldCodes codes(field);
    terrain::Surface block = SurfaceOf(field);
    const RayQuery plain(block);
    terrain::Cutting cutting;
    cutting.Extracts = true;
    cutting.First = { 2, 1 };
    cutting.Last = { 6, 5 };
    cutting.Block = true;
    const double base = codes.Low - 0.5 * (codes.High - codes.Low) - 1.0;
    block.Planes = cutting.PlanesGC(cutting.Drawn(codes.size, 1), base);
    block.Block = true;
    const RayQuery query(block);
    const glm::dvec3 low(2.0, 1.0, base);
    const glm::dvec3 high(6.0, 5.0, terrain::kInfinity);
    terrain::RayMaker maker({ 8, 7 }, codes.High - codes.Low, 23, false);
    int walls = 0;
    for (int i = 0; i < 1500; ++i)
    {
      QueryRay ray = ToQuery(maker.Make(), codes.Low);
      const SurfaceHit hit = query.First(ray);
      const auto [begin, end, axis] = EnterBlock(ray, low, high);
      if (begin > end)
      {
        EXPECT_FALSE(hit.Found) << i;
        continue;
      }
      const glm::dvec3 entry = ray.Origin + begin * ray.Direction;
      const double above = entry.z - plain.HeightAt(entry.x, entry.y);
      if (axis >= 0 && above < -1e-6)
      {
        ++walls;
        ASSERT_TRUE(hit.Found) << i;
        EXPECT_GE(hit.Wall, 0) << i;
        EXPECT_NEAR(hit.Distance, begin, 1e-9) << i;
        EXPECT_EQ(std::abs(hit.Normal[axis]), 1.0) << i;
        EXPECT_LT(glm::dot(hit.Normal, ray.Direction), 0.0) << i;
      }
      else if (axis < 0 || above > 1e-6)
      {
        ray.Begin = begin;
        ray.End = end;
        const SurfaceHit expected = plain.First(ray);
        EXPECT_EQ(hit.Found, expected.Found) << i;
        EXPECT_EQ(hit.Wall, -1) << i;
        EXPECT_TRUE(!hit.Found || std::abs(hit.Distance - expected.Distance) < 1e-9) << i;
      }
    }
    EXPECT_GT(walls, 50);
  }
}

//------------------------------------------------------------------------------
// Plain bounds: memory is a small part of the samples', and every level bounds its cells.
TEST(RayQuery, BoundsEveryNode)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    const auto heights = SurfaceOf(field).Heights;
    for (int level = heights->FirstLevel(); level <= heights->LastLevel(); ++level)
    {
      for (int j = 0; j < field.Height - 1; ++j)
      {
        for (int i = 0; i < field.Width - 1; ++i)
        {
          const glm::dvec4 corners = heights->CellHeights({ i, j });
          const terrain::HeightBounds bounds =
            heights->NodeBounds({ i >> level, j >> level }, level);
          for (int k = 0; k < 4 && terrain::HasSurface(corners); ++k)
          {
            EXPECT_LE(bounds.Low, corners[k]);
            EXPECT_GE(bounds.High, corners[k]);
          }
        }
      }
    }
  }
}
