// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The searches: where they sample, what they find, and how default parameters agree with the
// reference.
#include "core/rays/HeightSearch.h"

#include "UnitTestHullEntries.h"
#include "core/rays/ReferenceRayCaster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{
/// A flat field at code 0 that remembers the cells it was asked for.
struct RecordingHeights
{
  glm::ivec2 size{ 1025, 1025 };
  float maximumCode = 64.0f;
  std::vector<glm::ivec2>* cells = nullptr;

  glm::vec4 CellCodes(glm::ivec2 cell) const
  {
    this->cells->push_back(cell);
    return glm::vec4(0.0f);
  }
};

terrain::TerrainRay MakeRay(const glm::vec3& origin, const glm::vec3& direction)
{
  terrain::TerrainRay ray;
  ray.originGC = origin;
  ray.directionGC = direction;
  ray.sEnd = 1e30f;
  return ray;
}

/// Coded heights of a function of the sample.
struct SearchedField
{
  template <typename Function>
  SearchedField(int width, int height, Function&& heightAt)
    : Width(width)
    , Height(height)
  {
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        this->Samples.push_back(static_cast<float>(heightAt(i, j)));
        const float code =
          std::isnan(this->Samples.back()) ? terrain::NoDataCode : this->Samples.back();
        this->Maximum = std::max(this->Maximum, code);
        this->Texels.push_back(code);
      }
    }
  }

  terrain::HeightfieldView<float> View() const
  {
    return { this->Samples.data(), this->Width, this->Height, nullptr, 0xff, false, 0.0f };
  }

  terrain::CodedHeights<float> Codes() const
  {
    return { this->Texels.data(), { this->Width, this->Height }, 0, this->Maximum };
  }

  terrain::HeightSearch<terrain::CodedHeights<float>> Search() const
  {
    terrain::HeightSearch<terrain::CodedHeights<float>> search;
    search.heights = this->Codes();
    search.parameters.Steps = 1000;
    search.parameters.StepLength = 0.25f;
    search.parameters.SecantSteps = 6;
    return search;
  }

  int Width;
  int Height;
  float Maximum = 0.0f;
  std::vector<float> Samples;
  std::vector<float> Texels;
};
}

//------------------------------------------------------------------------------
TEST(HeightSearch, ExponentialStepsAreThoseOfTheTable)
{
  std::vector<glm::ivec2> cells;
  terrain::HeightSearch<RecordingHeights> search;
  search.heights.cells = &cells;
  search.parameters.Steps = 10;
  search.SearchExponential(MakeRay({ 0.0f, 3.5f, 9.0f }, { 1.0f, 0.0f, 0.0f }));
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
  std::vector<glm::ivec2> cells;
  terrain::HeightSearch<RecordingHeights> search;
  search.heights.cells = &cells;
  search.parameters.Steps = 4;
  search.SearchLinear(MakeRay({ 0.5f, 3.5f, 9.0f }, { 3.0f, 0.0f, 0.0f }));
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
      std::vector<glm::ivec2> cells;
      terrain::HeightSearch<RecordingHeights> search;
      search.heights.cells = &cells;
      search.parameters.Steps = 5;
      search.parameters.LongSteps = 3;
      search.parameters.StepLength = 10.0f;
      search.parameters.StepRelief = 2.0f;
      search.SearchEquidistant(
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
TEST(HeightSearch, SegmentsEndAtTheCodesAndTheBorder)
{
  const SearchedField field(11, 21, [](int i, int) { return i; });
  const auto search = field.Search();
  // Down to code 0, up to the largest, with a margin of 1e-4 of the codes.
  const auto down = search.Segment(MakeRay({ 5.0f, 5.0f, 30.0f }, { 0.0f, 0.0f, -2.0f }));
  EXPECT_NEAR(down.x, 10.0f, 1e-3f);
  EXPECT_NEAR(down.y, 15.0f, 1e-3f);
  const auto up = search.Segment(MakeRay({ 5.0f, 5.0f, 5.0f }, { 0.1f, 0.0f, 1.0f }));
  EXPECT_NEAR(up.x, 0.0f, 1e-3f);
  EXPECT_NEAR(up.y, 5.0f, 2e-3f);
  auto ray = MakeRay({ 1.0f, 2.0f, 5.0f }, { -1.0f, 0.0f, 0.0f });
  ray.anchorCell = { 3, 4 };
  EXPECT_EQ(search.Segment(ray).y, 4.0f);
  ray.sEnd = 2.5f;
  EXPECT_EQ(search.Segment(ray).y, 2.5f);
  const auto past = search.Segment(MakeRay({ -1.0f, 5.0f, 5.0f }, { 0.0f, 1.0f, 0.0f }));
  EXPECT_GT(past.x, past.y);
  for (const auto& size : { glm::ivec2(1, 1), glm::ivec2(1, 9), glm::ivec2(9, 1) })
  {
    const SearchedField line(size.x, size.y, [](int, int) { return 1; });
    EXPECT_FALSE(
      line.Search().SearchLinear(MakeRay({ 0.0f, 0.0f, 3.0f }, { 0.0f, 0.0f, -1.0f })).found);
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, FindsASlopeFromBothSides)
{
  const SearchedField field(40, 40, [](int i, int) { return 2 * i; });
  const auto search = field.Search();
  for (const float side : { 1.0f, -1.0f })
  {
    // Meets z = 2 x at x = 20.25, y = 10.5.
    const glm::vec3 direction(side * 0.5f, 0.25f, -side);
    const auto ray = MakeRay(glm::vec3(20.25f, 10.5f, 40.5f) - 12.0f * direction, direction);
    for (const auto& hit : { search.SearchLinear(ray), search.SearchEquidistant(ray) })
    {
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
  const SearchedField field(40, 40, [](int, int) { return 5; });
  const auto search = field.Search();
  for (const float above : { 0.0f, 1e-6f, -4e-6f })
  {
    const auto hit =
      search.SearchEquidistant(MakeRay({ 7.0f, 7.0f, 5.0f + above }, { 0.3f, 0.4f, -0.1f }));
    EXPECT_TRUE(hit.found);
    EXPECT_NEAR(hit.s, 0.0f, 1e-3f);
  }
}

//------------------------------------------------------------------------------
TEST(HeightSearch, HolesAreNotHitTheirRimIs)
{
  const float none = std::numeric_limits<float>::quiet_NaN();
  // No surface for 10 <= x <= 20; the ray comes down there and goes on below the rest.
  const SearchedField field(40, 40, [none](int i, int) { return i > 10 && i < 20 ? none : 5.0f; });
  const auto search = field.Search();
  EXPECT_FALSE(
    search.SearchEquidistant(MakeRay({ 0.5f, 7.0f, 6.0f }, { 1.0f, 0.0f, -0.1f })).found);
  // Down through the surface a twentieth of a cell before the hole.
  const auto rim = search.SearchEquidistant(MakeRay({ -0.05f, 7.0f, 6.0f }, { 1.0f, 0.0f, -0.1f }));
  EXPECT_TRUE(rim.found);
  EXPECT_EQ(rim.cell.x, 9);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, LeavesTheMeshAndStops)
{
  const SearchedField field(400, 40, [](int i, int) { return i == 399 ? 100 : 0; });
  auto search = field.Search();
  search.parameters.LargestGap = 3.0f;
  search.parameters.Steps = 4000;
  const auto ray = MakeRay({ 0.5f, 7.0f, 1.0f }, { 1.0f, 0.0f, 0.2f });
  EXPECT_LT(search.SearchEquidistant(ray).crossings, 60);
  search.parameters.LargestGap = 3e38f;
  EXPECT_TRUE(search.SearchEquidistant(ray).found);
}

//------------------------------------------------------------------------------
TEST(HeightSearch, DefaultParametersReachAcrossTheGrid)
{
  terrain::SearchScene scene;
  scene.Width = 8192;
  scene.Height = 5120;
  scene.CellsPerQuad = 64;
  scene.LargestGap = 3000.0;
  scene.MaximumCode = 9000.0;
  scene.CodesPerCell = 5000.0;
  const auto chosen = ChooseSearchParameters(scene, terrain::SearchKind::Equidistant);
  EXPECT_GE(chosen.StepLength * static_cast<float>(chosen.Steps + 2 * chosen.LongSteps),
    std::hypot(8192.0f, 5120.0f));
  EXPECT_GT(chosen.LargestGap, 3000.0f);
  EXPECT_EQ(chosen.StepRelief, 5000.0f);
  const auto paper = PaperSearchParameters(scene, terrain::SearchKind::Equidistant);
  EXPECT_EQ(paper.Steps, 5);
  EXPECT_EQ(paper.LongSteps, 10);
  EXPECT_EQ(paper.SecantSteps, 2);
  EXPECT_NEAR(paper.StepLength, 0.025 * 8191.0 * 32.0 / 128.0, 1.0);
  EXPECT_EQ(PaperSearchParameters(scene, terrain::SearchKind::Exponential).Steps, 10);
  // A flat, empty grid gives something that runs.
  const auto none = ChooseSearchParameters(terrain::SearchScene{}, terrain::SearchKind::Linear);
  EXPECT_GT(none.Steps, 0);
  EXPECT_GT(none.StepRelief, 0.0f);
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

Agreement Compare(const SearchedField& field, const terrain::ReferenceCamera& camera)
{
  const auto view = field.View();
  const terrain::ReferenceRayCaster<float> reference(view, {}, terrain::SerialFor);
  const auto mesh = terrain::BuildCoarseMesh(view, {}, terrain::SerialFor);
  terrain::SearchScene scene{ field.Width, field.Height, mesh.CellsPerQuad, mesh.LargestGap,
    static_cast<double>(field.Maximum), 1.0 };
  terrain::HeightSearch<terrain::CodedHeights<float>> search;
  search.heights = field.Codes();
  Agreement agreement;
  for (std::int64_t pixel = 0; pixel < camera.Width * camera.Height; ++pixel)
  {
    const auto ray = camera.PixelRay(pixel % camera.Width, pixel / camera.Width);
    const HullEntries entries(mesh, mesh.MinimumHeight - 1.0, ray.Origin, ray.Direction);
    double nearest = std::numeric_limits<double>::infinity();
    for (const double entry : entries.Get())
    {
      search.parameters = ChooseSearchParameters(scene, terrain::SearchKind::Equidistant);
      const double begin = entry * (1.0 - 1e-5);
      const glm::dvec3 start = ray.Origin + begin * ray.Direction;
      terrain::TerrainRay local;
      local.anchorCell = glm::ivec2(glm::floor(glm::dvec2(start)));
      local.originGC = glm::vec3(start - glm::dvec3(local.anchorCell, 0.0));
      local.directionGC = glm::vec3(ray.Direction);
      local.sEnd = 1e30f;
      const auto hit = search.SearchEquidistant(local);
      nearest = hit.found ? std::min(nearest, begin + static_cast<double>(hit.s)) : nearest;
    }
    const auto truth = reference.Cast(ray);
    ++agreement.Pixels;
    agreement.SameHit += std::isfinite(nearest) == truth.Found ? 1 : 0;
    if (truth.Found && std::isfinite(nearest))
    {
      ++agreement.Hits;
      agreement.SameDistance += std::abs(nearest - truth.Distance) <= 1e-3 * truth.Distance ? 1 : 0;
    }
  }
  return agreement;
}
}

//------------------------------------------------------------------------------
TEST(HeightSearch, DefaultEquidistantAgreesWithTheReference)
{
  const SearchedField field(300, 240,
    [](int i, int j)
    {
      const double x = 0.02 * i;
      const double y = 0.02 * j;
      const double hills = 20.0 + 12.0 * std::sin(3.0 * x) * std::cos(2.0 * y) +
        4.0 * std::sin(11.0 * x + 5.0 * y) + 0.8 * std::sin(31.0 * x - 27.0 * y);
      return (i - 150) * (i - 150) + (j - 90) * (j - 90) < 300
        ? std::numeric_limits<double>::quiet_NaN()
        : hills;
    });
  const glm::dvec3 middle(150.0, 120.0, 20.0);
  for (const glm::dvec3& eye : { glm::dvec3(60.0, -250.0, 170.0), glm::dvec3(151.0, 122.0, 500.0),
         glm::dvec3(-60.0, -50.0, 42.0), glm::dvec3(170.0, -90.0, -220.0) })
  {
    const Agreement agreement =
      Compare(field, terrain::MakeReferenceCamera(eye, middle, { 0.0, 0.01, 1.0 }, 40.0, 120, 80));
    EXPECT_GT(agreement.Hits, 1000);
    EXPECT_GE(agreement.SameHit, 0.999 * agreement.Pixels);
    EXPECT_GE(agreement.SameDistance, 0.99 * agreement.Hits);
  }
}
