// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The searches: where they sample, what they find, and how default parameters agree with the
// reference.
#include "core/rays/HeightSearch.h"

#include "UnitTestRays.h"
#include "UnitTestTown.h"
#include "core/rays/ReferenceRayCaster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{
using terrain::SearchKind;
using terrain::SearchParameters;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

terrain::TerrainRay MakeRay(const glm::vec3& origin, const glm::vec3& direction)
{
  terrain::TerrainRay ray;
  ray.originGC = origin;
  ray.directionGC = direction;
  ray.sEnd = 1e30f;
  return ray;
}

terrain::HeightSearch<float> MakeSearch(
  const terrain::CodedField<float>& field, SearchKind kind, const SearchParameters& parameters)
{
  terrain::HeightSearch<float> search{ field.Coded, parameters, kind };
  search.Coded.start = field.Pyramid.LevelCount();
  return search;
}

SearchParameters FineParameters()
{
  SearchParameters parameters;
  parameters.Steps = 4000;
  parameters.StepLength = 0.25f;
  parameters.SecantSteps = 6;
  return parameters;
}

/// Code 0, beside a wall two rows away that lets no node of the pyramid be passed by: rays in
/// cells (i, 3) take steps from their beginning to their end.
const terrain::CodedField<float>& Lane()
{
  static const terrain::CodedField<float> field(
    terrain::TestField("lane", 1025, 9, [](int, int j) { return j == 2 || j == 5 ? 64.0 : 0.0; }));
  return field;
}

/// The cells that a search samples.
std::vector<glm::ivec2> SampledCells(
  SearchKind kind, const SearchParameters& parameters, const terrain::TerrainRay& ray)
{
  std::vector<glm::ivec2> cells;
  MakeSearch(Lane(), kind, parameters)
    .Search(ray, [&cells](const glm::ivec2& cell) { cells.push_back(cell); });
  return cells;
}
}

//------------------------------------------------------------------------------
TEST(HeightSearch, ExponentialStepsAreThoseOfTheTable)
{
  SearchParameters parameters;
  parameters.Steps = 10;
  const auto cells = SampledCells(
    SearchKind::Exponential, parameters, MakeRay({ 0.0f, 3.5f, 9.0f }, { 1.0f, 0.0f, 0.0f }));
  // 1024 (1 - H) for H = 0.998046875 ... 0.5, 0; the last sample is on the border.
  ASSERT_EQ(cells.size(), 11U);
  EXPECT_EQ(cells[0].x, 0);
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(cells[i + 1].x, 2 << i);
  }
  EXPECT_EQ(cells[10].x, 1023);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, LinearStepsAreEqualPartsOfTheSegment)
{
  SearchParameters parameters;
  parameters.Steps = 4;
  const auto cells = SampledCells(
    SearchKind::Linear, parameters, MakeRay({ 0.5f, 3.5f, 9.0f }, { 3.0f, 0.0f, 0.0f }));
  ASSERT_EQ(cells.size(), 5U);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(cells[i].x, 0.5 + 1023.5 / 4.0 * i, 1.0);
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, EquidistantStepsHaveOneLengthWhateverTheSlope)
{
  for (const float slope : { 0.0f, 0.01f, 0.05f })
  {
    for (const float scale : { 0.1f, 20.0f })
    {
      SearchParameters parameters;
      parameters.Steps = 5;
      parameters.LongSteps = 3;
      parameters.StepLength = 10.0f;
      parameters.StepRelief = 2.0f;
      const auto cells = SampledCells(SearchKind::Equidistant, parameters,
        MakeRay({ 0.01f, 3.5f, 9.0f }, scale * glm::vec3(1.0f, 0.0f, slope * 2.0f)));
      ASSERT_EQ(cells.size(), 9U);
      const double step = 10.0 / std::hypot(1.0, static_cast<double>(slope));
      for (int i = 0; i < 9; ++i)
      {
        const int count = i <= 5 ? i : 5 + 2 * (i - 5);
        EXPECT_EQ(cells[i].x, static_cast<int>(0.01 + step * count)) << "sample " << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, StepsAreTakenOnlyWhereTheSurfaceCanBe)
{
  // A hill of 16 cells in a plain of 1024: the ray is level and passes over the plain.
  const terrain::CodedField<float> field(terrain::TestField(
    "hill", 1025, 9, [](int i, int) { return i > 504 && i <= 520 ? 50.0 : 0.0; }));
  SearchParameters parameters;
  parameters.Steps = 4;
  parameters.StepLength = 4.0f;
  parameters.SecantSteps = 8;
  std::vector<glm::ivec2> cells;
  const auto hit = MakeSearch(field, SearchKind::Equidistant, parameters)
                     .Search(MakeRay({ 0.3f, 3.5f, 30.0f }, { 1.0f, 0.0f, 0.0f }),
                       [&cells](const glm::ivec2& cell) { cells.push_back(cell); });
  ASSERT_TRUE(hit.found);
  EXPECT_NEAR(hit.s, 504.3f, 1e-3f);
  ASSERT_FALSE(cells.empty());
  EXPECT_GE(cells.front().x, 500);
  EXPECT_LT(hit.crossings, 40);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, ShortStepsPassByNothingInACell)
{
  // A saddle, over which a ray from corner to corner dips into the middle of the cell only.
  const terrain::CodedField<float> field(
    terrain::TestField("saddle", 2, 2, [](int i, int j) { return i == j ? 0.0 : 40.0; }));
  SearchParameters parameters = FineParameters();
  parameters.StepLength = 1.9f;
  parameters.StepRelief = 40.0f;
  const auto search = MakeSearch(field, SearchKind::Equidistant, parameters);
  // On the diagonal the surface is 80 t (1 - t): at most 20.
  EXPECT_FALSE(search.Search(MakeRay({ 0.0f, 0.0f, 20.001f }, { 1.0f, 1.0f, 0.0f })).found);
  const auto hit = search.Search(MakeRay({ 0.0f, 0.0f, 19.99f }, { 1.0f, 1.0f, 0.0f }));
  ASSERT_TRUE(hit.found);
  EXPECT_NEAR(hit.s, 0.5f - 0.5f * std::sqrt(1.0f - 19.99f / 20.0f), 1e-3f);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, TinyGridsHaveNoSurface)
{
  for (const auto& size : { glm::ivec2(1, 1), glm::ivec2(1, 9), glm::ivec2(9, 1) })
  {
    const terrain::CodedField<float> line(
      terrain::TestField("line", size.x, size.y, [](int, int) { return 1.0; }));
    for (const auto kind : { SearchKind::Linear, SearchKind::Exponential, SearchKind::Equidistant })
    {
      EXPECT_FALSE(MakeSearch(line, kind, FineParameters())
                     .Search(MakeRay({ 0.0f, 0.0f, 3.0f }, { 0.0f, 0.0f, -1.0f }))
                     .found);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, FindsASlopeFromBothSides)
{
  const terrain::CodedField<float> field(
    terrain::TestField("slope", 40, 40, [](int i, int) { return 2.0 * i; }));
  for (const float side : { 1.0f, -1.0f })
  {
    // Meets z = 2 x at x = 20.25, y = 10.5.
    const glm::vec3 direction(side * 0.5f, 0.25f, -side);
    const auto ray = MakeRay(glm::vec3(20.25f, 10.5f, 40.5f) - 12.0f * direction, direction);
    for (const auto kind : { SearchKind::Linear, SearchKind::Equidistant })
    {
      const auto hit = MakeSearch(field, kind, FineParameters()).Search(ray);
      ASSERT_TRUE(hit.found);
      EXPECT_NEAR(hit.s, 12.0f, 1e-4f);
      EXPECT_EQ(hit.cell, glm::ivec2(20, 10));
      EXPECT_NEAR(hit.fraction.x, 0.25f, 1e-4f);
      EXPECT_NEAR(hit.fraction.y, 0.5f, 1e-4f);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, StartOnAFlatSurfaceIsAHit)
{
  const terrain::CodedField<float> field(
    terrain::TestField("floor", 40, 40, [](int i, int j) { return i == 0 && j == 0 ? 0.0 : 5.0; }));
  const auto search = MakeSearch(field, SearchKind::Equidistant, FineParameters());
  for (const float above : { 0.0f, 1e-6f, -4e-6f })
  {
    for (const float down : { 0.1f, -0.1f })
    {
      const auto hit = search.Search(MakeRay({ 7.0f, 7.0f, 5.0f + above }, { 0.3f, 0.4f, -down }));
      EXPECT_TRUE(hit.found);
      EXPECT_NEAR(hit.s, 0.0f, 1e-3f);
    }
  }
}

//------------------------------------------------------------------------------
// Steps over a floor of one height begin on it, where rounding decides the side. A floor without
// relief has code 0.
TEST(HeightSearch, FindsEveryHitOnAFlatFloor)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(1.0f, 38.0f);
  std::uniform_real_distribution<float> height(0.1f, 4.0f);
  for (const float floor : { 0.0f, 5.0f })
  {
    const terrain::CodedField<float> field(terrain::TestField("floor", 40, 40,
      [floor](int i, int j) { return i == 0 && j == 0 ? 0.0 : static_cast<double>(floor); }));
    const auto search = MakeSearch(field, SearchKind::Equidistant, FineParameters());
    for (int k = 0; k < 2000; ++k)
    {
      const float side = k % 2 == 0 ? 1.0f : -1.0f;
      const glm::vec3 eye(place(random), place(random), floor + side * height(random));
      const glm::vec3 ground(place(random), place(random), floor);
      const auto hit = search.Search(MakeRay(eye, 2.0f * (ground - eye)));
      ASSERT_TRUE(hit.found) << floor << ", " << k;
      ASSERT_NEAR(hit.s, 0.5f, 1e-5f) << floor << ", " << k;
    }
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, HolesAreNotHitTheirRimIs)
{
  // No surface for 10 <= x <= 20; the ray comes down there and goes on below the rest.
  const terrain::CodedField<float> field(terrain::TestField("hole", 40, 40,
    [](int i, int j) { return i > 10 && i < 20 ? kNone : (i == 39 && j == 39 ? 0.0 : 5.0); }));
  const auto search = MakeSearch(field, SearchKind::Equidistant, FineParameters());
  EXPECT_FALSE(search.Search(MakeRay({ 0.5f, 7.0f, 6.0f }, { 1.0f, 0.0f, -0.1f })).found);
  // Down through the surface a twentieth of a cell before the hole.
  const auto rim = search.Search(MakeRay({ -0.05f, 7.0f, 6.0f }, { 1.0f, 0.0f, -0.1f }));
  EXPECT_TRUE(rim.found);
  EXPECT_EQ(rim.cell.x, 9);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, DefaultsAreThePapersOrReachAcrossTheGrid)
{
  const terrain::SearchScene scene{ 8192, 5120, 9000.0, 5000.0 };
  const auto chosen = ChooseSearchParameters(scene, SearchKind::Equidistant);
  EXPECT_GE(chosen.StepLength * static_cast<float>(chosen.Steps), std::hypot(8192.0f, 5120.0f));
  EXPECT_EQ(chosen.StepRelief, 5000.0f);
  EXPECT_EQ(chosen.StepLevel(), 0);
  EXPECT_EQ(ChooseSearchParameters(scene, SearchKind::Linear).Steps, 5);
  EXPECT_EQ(ChooseSearchParameters(scene, SearchKind::Exponential).Steps, 10);
  const auto paper = PaperSearchParameters(scene, SearchKind::Equidistant, 128);
  EXPECT_EQ(paper.Steps, 5);
  EXPECT_EQ(paper.LongSteps, 10);
  EXPECT_EQ(paper.SecantSteps, 2);
  EXPECT_NEAR(paper.StepLength, 0.025 * 8191.0 * 32.0 / 128.0, 1.0);
  EXPECT_EQ(paper.StepLevel(), 5);
  // A flat, empty grid gives something that runs.
  const auto none = ChooseSearchParameters(terrain::SearchScene{}, SearchKind::Linear);
  EXPECT_GT(none.Steps, 0);
  EXPECT_GT(none.StepRelief, 0.0f);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, BoundsHoldForAnyParameters)
{
  const auto field = terrain::CodedField<float>(
    terrain::TestField("hills", 200, 200, [](int i, int j) { return (i * 7 + j * 13) % 97; }));
  const float huge = std::numeric_limits<float>::infinity();
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (const int steps : { std::numeric_limits<int>::min(), -1, 0, 1, 1000000000 })
  {
    for (const float length : { -huge, -1.0f, 0.0f, none, 1e-30f, 1e9f, huge })
    {
      for (const auto kind :
        { SearchKind::Linear, SearchKind::Exponential, SearchKind::Equidistant })
      {
        const SearchParameters parameters =
          BoundSearchParameters({ steps, steps, steps, length, 1.0f }, kind);
        const auto hit = MakeSearch(field, kind, parameters)
                           .Search(MakeRay({ -1.0f, 3.3f, 99.0f }, { 1.0f, 0.9f, -0.4f }));
        // Twice a cell's diagonal in the shortest steps, and a node or two for each.
        EXPECT_LT(hit.crossings, 400 * 24);
        EXPECT_EQ(hit.found && steps <= 0, false);
      }
    }
  }
}

namespace
{
/// Shares of pixels of a small picture on which a search agrees with the reference.
struct Agreement
{
  int Pixels = 0;
  int SameHit = 0;
  int Hits = 0;
  int SameDistance = 0;
};

/// The whole of a ray in grid coordinates, relative to its origin's cell.
terrain::TerrainRay LocalRay(const terrain::ReferenceRay& ray)
{
  terrain::TerrainRay local = terrain::RayBetween(ray.Origin, ray.Origin + ray.Direction);
  local.sEnd = 1e30f;
  return local;
}

Agreement Compare(const terrain::TestField& test, const terrain::ReferenceCamera& camera)
{
  const terrain::CodedField<float> field(test);
  const auto view = test.View();
  const terrain::ReferenceRayCaster<double> reference(view, {}, terrain::SerialFor);
  const terrain::SearchScene scene{ test.Width, test.Height, field.Codes.MaximumCode, 1.0 };
  const auto search = MakeSearch(
    field, SearchKind::Equidistant, ChooseSearchParameters(scene, SearchKind::Equidistant));
  Agreement agreement;
  for (std::int64_t pixel = 0; pixel < camera.Width * camera.Height; ++pixel)
  {
    auto ray = camera.PixelRay(pixel % camera.Width, pixel / camera.Width);
    const auto truth = reference.Cast(ray);
    ray.Origin.z = field.Codes.ToCode(ray.Origin.z);
    ray.Direction.z /= field.Codes.Scale;
    const auto hit = search.Search(LocalRay(ray));
    ++agreement.Pixels;
    agreement.SameHit += hit.found == truth.Found ? 1 : 0;
    if (truth.Found && hit.found)
    {
      ++agreement.Hits;
      const double error = std::abs(static_cast<double>(hit.s) - truth.Distance);
      agreement.SameDistance += error <= 1e-3 * truth.Distance ? 1 : 0;
    }
  }
  return agreement;
}

void ExpectAgreement(
  const terrain::TestField& field, const std::vector<glm::dvec3>& eyes, const glm::dvec3& focus)
{
  for (const glm::dvec3& eye : eyes)
  {
    const Agreement agreement =
      Compare(field, terrain::MakeReferenceCamera(eye, focus, { 0.0, 0.01, 1.0 }, 40.0, 200, 150));
    EXPECT_GT(agreement.Hits, 3000);
    EXPECT_GE(agreement.SameHit, 0.9995 * agreement.Pixels);
    EXPECT_GE(agreement.SameDistance, 0.995 * agreement.Hits);
  }
}
}

//------------------------------------------------------------------------------
TEST(HeightSearch, DefaultEquidistantAgreesWithTheReferenceOnHills)
{
  const terrain::TestField field("hills", 300, 240,
    [](int i, int j)
    {
      const double x = 0.02 * i;
      const double y = 0.02 * j;
      const double hills = 20.0 + 12.0 * std::sin(3.0 * x) * std::cos(2.0 * y) +
        4.0 * std::sin(11.0 * x + 5.0 * y) + 0.8 * std::sin(31.0 * x - 27.0 * y);
      return (i - 150) * (i - 150) + (j - 90) * (j - 90) < 300 ? kNone : hills;
    });
  ExpectAgreement(field,
    { glm::dvec3(60.0, -250.0, 170.0), glm::dvec3(151.0, 122.0, 500.0),
      glm::dvec3(-60.0, -50.0, 42.0), glm::dvec3(170.0, -90.0, -220.0) },
    { 150.0, 120.0, 20.0 });
}

//------------------------------------------------------------------------------
TEST(HeightSearch, DefaultEquidistantAgreesWithTheReferenceInATown)
{
  ExpectAgreement(terrain::MakeTown(1000),
    { glm::dvec3(500.0, -300.0, 500.0), glm::dvec3(430.0, 420.0, 160.0),
      glm::dvec3(503.0, 310.0, 108.0), glm::dvec3(500.0, 499.0, 1000.0) },
    { 520.0, 500.0, 105.0 });
}
