// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Layout and preprocess: every vertex has its own record, errors and spheres are nested and hold.
#include "HierarchyTestTools.h"

#include "core/strips/HierarchyNesting.h"

#include <gtest/gtest.h>

using namespace hierarchytest;
using terrain::HierarchyLayout;
using terrain::HierarchyRecord;
using terrain::MemoryHierarchy;

namespace
{
/// Calls visit(pair, xStep, yStep) for all vertices with records.
template <typename Visit>
void ForAllVertices(const HierarchyLayout& layout, Visit&& visit)
{
  for (int pair = 0; pair < layout.Pairs(); ++pair)
  {
    for (std::int64_t y = 0; y < layout.Count(pair, 1); ++y)
    {
      for (std::int64_t x = 0; x < layout.Count(pair, 0); ++x)
      {
        if (((x | y) & 1) != 0)
        {
          visit(pair, x, y);
        }
      }
    }
  }
}
}

TEST(Hierarchy, EveryVertexHasItsOwnRecord)
{
  const std::vector<std::array<std::int64_t, 2>> sizes{ { { 1, 1 } }, { { 2, 2 } }, { { 5, 3 } },
    { { 65, 65 } }, { { 66, 200 } }, { { 1000, 7 } } };
  for (const auto& size : sizes)
  {
    const HierarchyLayout layout(size[0], size[1]);
    std::set<std::int64_t> seen;
    ForAllVertices(layout,
      [&](int pair, std::int64_t x, std::int64_t y)
      {
        const std::int64_t index = layout.Index(pair, x, y);
        EXPECT_GE(index, layout.FirstRecord(pair));
        EXPECT_LT(index, layout.FirstRecord(pair + 1));
        EXPECT_TRUE(seen.insert(index).second);
        EXPECT_EQ(layout.PairOf(x * layout.Step(pair), y * layout.Step(pair)), pair);
        EXPECT_EQ(layout.DepthOf(index), 2 * pair + ((x & y & 1) != 0 ? 0 : 1));
      });
  }
}

TEST(Hierarchy, RefusesSizesThatDoNotFit)
{
  EXPECT_EQ(HierarchyLayout::WhyNotSize(1, 1), "");
  EXPECT_EQ(HierarchyLayout::WhyNotSize(32769, 32769), "");
  EXPECT_NE(HierarchyLayout::WhyNotSize(0, 5), "");
  EXPECT_NE(HierarchyLayout::WhyNotSize(5, -1), "");
  EXPECT_NE(HierarchyLayout::WhyNotSize(32770, 5), "");
  // The largest one still has indices of 32 bits.
  EXPECT_LT(HierarchyLayout(32769, 32769).RecordCount(), std::int64_t(1) << 32);
}

TEST(Hierarchy, PackedValuesRoundUpByLittle)
{
  for (const float value : { 0.0f, 1.0e-20f, 0.1f, 1.0f, 3.14159f, 8848.86f, 1.0e7f })
  {
    HierarchyRecord record;
    record.SetDrawn(5);
    record.SetRadius(value);
    record.SetError(value);
    record.SetRough(true);
    EXPECT_GE(record.Error(), value);
    EXPECT_LE(record.Error(), value * (1.0 + terrain::kPackedErrorExcess));
    EXPECT_GE(record.Radius(), value);
    EXPECT_LE(record.Radius(), value * (1.0 + terrain::kPackedRadiusExcess));
    EXPECT_EQ(record.Drawn(), 5u);
    EXPECT_TRUE(record.IsRough());
  }
}

TEST(Hierarchy, ErrorsAndSpheresAreNested)
{
  for (const std::string& pattern : { std::string("none"), std::string("lake") })
  {
    for (const auto& size :
      std::vector<std::array<std::int64_t, 2>>{ { { 65, 65 } }, { { 130, 97 } }, { { 257, 20 } } })
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      const HierarchyLayout& layout = hierarchy.Layout;
      ForAllVertices(layout,
        [&](int pair, std::int64_t x, std::int64_t y)
        {
          const HierarchyRecord& parent = hierarchy.Records[layout.Index(pair, x, y)];
          const int depth = (x & y & 1) != 0 ? 2 * pair : 2 * pair + 1;
          if (depth + 1 >= layout.Depths())
          {
            return;
          }
          const int childPair = (depth + 1) / 2;
          for (int bit = 0; bit < 4; ++bit)
          {
            const auto& unit = HierarchyLayout::Directions[2 * bit + (depth & 1)];
            const std::int64_t cx = x * layout.Step(pair) - unit[0] * layout.Step(childPair);
            const std::int64_t cy = y * layout.Step(pair) - unit[1] * layout.Step(childPair);
            const std::int64_t column = cx / layout.Step(childPair);
            const std::int64_t row = cy / layout.Step(childPair);
            if (cx < 0 || cy < 0 || column >= layout.Count(childPair, 0) ||
              row >= layout.Count(childPair, 1))
            {
              continue;
            }
            const HierarchyRecord& child = hierarchy.Records[layout.Index(childPair, column, row)];
            EXPECT_GE(parent.Error(), child.Error());
            if (child.Error() > 0.0f)
            {
              const glm::dvec2 offset =
                glm::dvec2(layout.Sample(cx, cy) -
                  layout.Sample(x * layout.Step(pair), y * layout.Step(pair))) *
                hierarchy.Geometry.Spacing;
              const double distance =
                glm::length(glm::dvec3(offset, static_cast<double>(child.Height) - parent.Height));
              EXPECT_GE(parent.Radius(), distance + child.Radius());
            }
          }
        });
    }
  }
}

// In parallel projection they are pixels.
TEST(Hierarchy, ErrorsBoundTheHeightsOfTriangles)
{
  for (const float level : { 0.0f, 9000.0f, 1.0e6f })
  {
    for (const std::string pattern : { "none", "lake", "speckles" })
    {
      Raster raster = WithHoles(MakeHills(130, 97), pattern);
      float highest = 0.0f;
      for (float& height : raster.Heights)
      {
        height += level;
        highest = std::max(highest, std::isnan(height) ? 0.0f : std::abs(height));
      }
      const MemoryHierarchy hierarchy = Build(raster);
      terrain::Refiner refiner(hierarchy.View());
      terrain::RefinementView view = MakeView(raster, 0.5, 0.5, 1.0e7);
      view.Parallel = true;
      view.PixelsPerUnit = 1.0;
      for (const double tolerance : { 0.5, 2.0, 8.0 })
      {
        terrain::StripMesh mesh;
        refiner.Refine(view, WithTolerance(tolerance), mesh);
        const double allowed = tolerance + terrain::kHierarchyError * highest;
        for (const auto& indices : IndexTriangles(mesh))
        {
          const Drawn drawn = DrawnOf(mesh, indices);
          if (Area2(drawn.Corners) > 1)
          {
            ASSERT_LE(FindError(raster, view.Eye, drawn).Height, allowed)
              << level << " " << pattern << " tolerance " << tolerance;
          }
        }
      }
    }
  }
}

TEST(Hierarchy, GradientsAreThoseOfAPlane)
{
  Raster raster = MakeHills(70, 40);
  for (std::int64_t i = 0; i < raster.Width * raster.Height; ++i)
  {
    raster.Heights[i] = static_cast<float>(6 * (i % raster.Width) - 2 * (i / raster.Width));
  }
  const MemoryHierarchy hierarchy = Build(raster, MakeGeometry(3.0, 4.0));
  const HierarchyLayout& layout = hierarchy.Layout;
  ForAllVertices(layout,
    [&](int pair, std::int64_t x, std::int64_t y)
    {
      if (x * layout.Step(pair) < raster.Width && y * layout.Step(pair) < raster.Height)
      {
        const terrain::HierarchyGradient& gradient = hierarchy.Gradients[layout.Index(pair, x, y)];
        EXPECT_FLOAT_EQ(gradient.X(), 2.0f);
        EXPECT_FLOAT_EQ(gradient.Y(), -0.5f);
      }
    });
}

TEST(Hierarchy, IsTheSameOnAnyNumberOfThreads)
{
  const Raster raster = WithHoles(MakeHills(200, 150), "speckles");
  const MemoryHierarchy serial = Build(raster);
  const terrain::ParallelFor backwards = [](std::int64_t count, const terrain::RangeBody& body)
  {
    for (std::int64_t i = count; i-- > 0;)
    {
      body(i, i + 1);
    }
  };
  MemoryHierarchy other;
  EXPECT_EQ(terrain::BuildHierarchy(
              other, raster.Width, raster.Height, MakeGeometry(), RowsOf(raster), backwards, {}),
    "");
  ASSERT_EQ(other.Records.size(), serial.Records.size());
  EXPECT_EQ(std::memcmp(other.Records.data(), serial.Records.data(),
              serial.Records.size() * sizeof(HierarchyRecord)),
    0);
}

TEST(Hierarchy, ReadsEveryRowOnceFromTheNorth)
{
  const Raster raster = MakeHills(30, 300);
  std::int64_t next = raster.Height;
  MemoryHierarchy hierarchy;
  const terrain::HeightRows rows = [&](std::int64_t first, std::int64_t count, float* heights)
  {
    EXPECT_EQ(first + count, next);
    EXPECT_LE(count, 70);
    next = first;
    return RowsOf(raster)(first, count, heights);
  };
  EXPECT_EQ(
    terrain::BuildHierarchy(hierarchy, 30, 300, MakeGeometry(), rows, terrain::SerialFor, {}), "");
  EXPECT_EQ(next, 0);
}

TEST(Hierarchy, StopsAndFailsOnRequest)
{
  const Raster raster = MakeHills(30, 300);
  MemoryHierarchy hierarchy;
  EXPECT_EQ(terrain::BuildHierarchy(hierarchy, 30, 300, MakeGeometry(), RowsOf(raster),
              terrain::SerialFor, [](double part) { return part < 0.3; }),
    terrain::kBuildAborted);
  const terrain::HeightRows failing = [](std::int64_t, std::int64_t, float*)
  { return std::string("no such row"); };
  EXPECT_EQ(
    terrain::BuildHierarchy(hierarchy, 30, 300, MakeGeometry(), failing, terrain::SerialFor, {}),
    "no such row");
  EXPECT_NE(terrain::BuildHierarchy(
              hierarchy, 30, 300, MakeGeometry(0.0, 1.0), RowsOf(raster), terrain::SerialFor, {}),
    "");
}
