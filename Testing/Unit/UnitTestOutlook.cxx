// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons of points, found in float as shaders find them, judged by rays in double.
#include "UnitTestDetail.h"
#include "UnitTestFields.h"
#include "UnitTestOutlooks.h"
#include "UnitTestTiles.h"

#include "core/rays/Horizon.h"
#include "core/rays/RayQuery.h"
#include "core/surface/SurfaceHeights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace
{
using terrain::Outlook;
using terrain::OutlookSearch;
using terrain::TestField;

/// The codes of a field as a surface: what the search works on, in double.
terrain::Surface SurfaceOf(const std::vector<float>& codes, const glm::ivec2& size, bool columns)
{
  terrain::HeightfieldView<float> view;
  view.Samples = codes.data();
  view.Width = size.x;
  view.Height = size.y;
  view.HasNoData = true;
  view.NoData = terrain::kNoDataCode;
  terrain::Surface surface;
  surface.Heights = std::make_shared<terrain::SampledHeights<float>>(view, terrain::SerialFor);
  surface.Kind = columns ? terrain::SurfaceKind::Columns : terrain::SurfaceKind::Bilinear;
  return surface;
}

/// How high the surface stands over the ray of a tangent, from a distance on.
terrain::SurfaceSummit Over(
  const terrain::RayQuery& query, const Outlook& outlook, double tangent, double begin)
{
  terrain::QueryRay ray;
  const glm::dvec2 at = glm::dvec2(outlook.cell) + glm::dvec2(outlook.fraction);
  ray.Origin = { at, query.HeightAt(at.x, at.y) };
  ray.Direction = { glm::dvec2(outlook.direction), tangent };
  ray.Begin = begin;
  ray.End = outlook.end;
  return query.Highest(ray);
}

/// True if all surface is below a ray, and there is some.
bool IsBelow(const terrain::SurfaceSummit& summit)
{
  return summit.Height < 0.0 && summit.Height > -terrain::kInfinity;
}

/// True if a way runs along lines between cells or columns, or through their corners: the judge
/// sees the surface on all sides of them.
bool IsAlongLines(const Outlook& outlook)
{
  const glm::vec2 size = glm::abs(outlook.direction);
  const glm::vec2 inside = glm::min(outlook.fraction, 1.0f - outlook.fraction);
  return (std::min(size.x, size.y) < 1e-6f || std::abs(size.x - size.y) < 1e-6f) &&
    std::min(inside.x, inside.y) == 0.0f;
}

struct Judged
{
  int Wrong = 0;
  int Between = 0;
};

/// No surface stands above the ray of the horizon, and some would above one a little lower. Both
/// hold where a hair's breadth from the point does not hide what the tangent is.
template <typename Rays>
Judged Judge(const OutlookSearch<Rays>& search, const terrain::Surface& surface, unsigned seed)
{
  const terrain::RayQuery query(surface);
  const double room =
    terrain::kOutlookError * static_cast<double>(search.rays.heights.maximumCode) + 1e-9;
  constexpr double begin = 1e-3;
  Judged judged;
  for (const Outlook& outlook : terrain::RandomOutlooks(search, seed))
  {
    const double tangent = search.HorizonTangent(outlook, [](glm::ivec2, int) {});
    if (outlook.end < 0.1 || IsAlongLines(outlook))
    {
      continue;
    }
    const bool isHigh = tangent > outlook.high;
    const bool isLow = tangent <= outlook.low;
    judged.Between += isHigh || isLow ? 0 : 1;
    const double upper = isHigh ? terrain::kInfinity : tangent;
    const double lower = isHigh ? outlook.high : tangent;
    judged.Wrong += !isHigh && Over(query, outlook, upper, begin).Height > room ? 1 : 0;
    // Lower by what lets the surface stand out by the room at the least distance.
    const double least = lower - room / begin;
    judged.Wrong += !isLow && IsBelow(Over(query, outlook, least, 1e-3 * begin)) ? 1 : 0;
  }
  return judged;
}

template <typename Texel>
Judged JudgeField(const TestField& test, bool columns, unsigned seed)
{
  terrain::CodedField<Texel> field(test);
  field.Coded.columns = columns;
  std::vector<float> codes;
  for (int k = 0; k < test.Width * test.Height; ++k)
  {
    codes.push_back(field.Coded.heights.Code({ k % test.Width, k / test.Width }));
  }
  return Judge(OutlookSearch<terrain::CodedPyramid<Texel>>{ field.Coded },
    SurfaceOf(codes, { test.Width, test.Height }, columns), seed);
}
}

//------------------------------------------------------------------------------
TEST(Outlook, TouchesTheSurfaceAndPassesOverIt)
{
  unsigned seed = 0;
  int between = 0;
  for (const TestField& field : terrain::AdversarialFields())
  {
    for (const bool columns : { false, true })
    {
      SCOPED_TRACE(field.Name + (columns ? ", columns" : ""));
      ++seed;
      const Judged judged = seed % 4 < 2 ? JudgeField<float>(field, columns, seed)
                                         : JudgeField<std::uint16_t>(field, columns, seed);
      EXPECT_EQ(judged.Wrong, 0);
      between += judged.Between;
    }
  }
  EXPECT_GT(between, 2000);
}

// Horizon.h finds the same from samples, along lines of the grid by the cells on both sides.
TEST(Outlook, IsThatOfAllSamples)
{
  for (const TestField& test : terrain::AdversarialFields())
  {
    if (test.Name != "hills" && test.Name != "random" && test.Name != "holes")
    {
      continue;
    }
    SCOPED_TRACE(test.Name);
    const terrain::CodedField<float> field(test);
    const OutlookSearch<terrain::CodedPyramid<float>> search{ field.Coded };
    const terrain::HorizonGrid grid(test.View(), terrain::SerialFor);
    std::vector<float> degrees(test.Samples.size());
    int compared = 0;
    int wrong = 0;
    for (const double azimuth : { 17.0, 133.0, 200.5, 292.0 })
    {
      grid.Cast(azimuth, {}, { 0, test.Height }, degrees.data(), terrain::SerialFor);
      for (int k = 0; k < test.Width * test.Height; ++k)
      {
        Outlook outlook;
        outlook.direction = { std::sin(azimuth * terrain::kDegree),
          std::cos(azimuth * terrain::kDegree) };
        // the cell that the ray leaves the sample through
        const glm::ivec2 back(glm::lessThan(outlook.direction, glm::vec2(0.0f)));
        outlook.cell = glm::ivec2(k % test.Width, k / test.Width) - back;
        outlook.fraction = glm::vec2(back);
        const glm::ivec2 last(test.Width - 2, test.Height - 2);
        if (outlook.cell != glm::clamp(outlook.cell, glm::ivec2(0), last))
        {
          continue;
        }
        terrain::SetCode(search, outlook);
        outlook.low = -1e9f;
        outlook.high = 1e9f;
        outlook.end = 1e30f;
        if (glm::all(glm::greaterThanEqual(outlook.codes, glm::vec4(0.0f))))
        {
          const float tangent = search.HorizonTangent(outlook, [](glm::ivec2, int) {});
          const double found = std::atan(static_cast<double>(tangent)) / terrain::kDegree;
          const double expected = degrees[static_cast<std::size_t>(k)];
          wrong += std::abs(found - expected) <= terrain::kHorizonError ? 0 : 1;
          ++compared;
        }
      }
    }
    EXPECT_GT(compared, 1000);
    EXPECT_EQ(wrong, 0);
  }
}

// With all tiles there it is that of the whole field.
TEST(Outlook, IsTheSameInTiles)
{
  for (const TestField& test : terrain::AdversarialFields())
  {
    const terrain::CodedField<float> field(test);
    terrain::TiledField tiled(test);
    // far from zero, tiles have other codes
    if (tiled.Slots.Top() < 1 || test.Name == "far from zero")
    {
      continue;
    }
    SCOPED_TRACE(test.Name);
    tiled.ShowIf([](const terrain::TileKey&) { return true; });
    const OutlookSearch<terrain::CodedPyramid<float>> whole{ field.Coded };
    const OutlookSearch<terrain::TiledPyramid> parts{ tiled.Rays };
    const float room = 1e-6f * field.Coded.heights.maximumCode;
    int different = 0;
    for (const Outlook& outlook : terrain::RandomOutlooks(whole, 5))
    {
      const auto none = [](glm::ivec2, int) {};
      const float expected = std::min(whole.HorizonTangent(outlook, none), outlook.high);
      const float found = std::min(parts.HorizonTangent(outlook, none), outlook.high);
      different += std::abs(found - expected) <= 1e-4f * std::abs(expected) + room ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
  }
}
