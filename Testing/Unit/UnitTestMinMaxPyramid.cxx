// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

namespace
{
using terrain::GridRectangle;
using terrain::HeightfieldView;
using terrain::MinMaxPyramid;

// Bounds of all cells with a surface under node (x, y), straight from the definition.
template <typename T>
terrain::PyramidNode<T> Expected(
  const HeightfieldView<T>& view, int level, std::int64_t x, std::int64_t y)
{
  auto node = terrain::PyramidNode<T>::Empty();
  const std::int64_t size = std::int64_t{ 1 } << level;
  for (std::int64_t j = y * size; j < std::min((y + 1) * size, view.Height - 1); ++j)
  {
    for (std::int64_t i = x * size; i < std::min((x + 1) * size, view.Width - 1); ++i)
    {
      if (view.IsCellValid(i, j))
      {
        for (const std::int64_t index : { view.Index(i, j), view.Index(i + 1, j),
               view.Index(i, j + 1), view.Index(i + 1, j + 1) })
        {
          node.Maximum = std::max(node.Maximum, view.Samples[index]);
          node.Minimum = std::min(node.Minimum, view.Samples[index]);
        }
      }
    }
  }
  return node;
}

// All nodes of all levels, bit for bit.
template <typename T>
void ExpectSame(const MinMaxPyramid<T>& a, const MinMaxPyramid<T>& b)
{
  ASSERT_EQ(a.LevelCount(), b.LevelCount());
  for (int level = 1; level <= a.LevelCount(); ++level)
  {
    ASSERT_EQ(a.LevelSize(level), b.LevelSize(level));
    const auto size = static_cast<std::size_t>(a.LevelSize(level).x * a.LevelSize(level).y);
    EXPECT_EQ(
      std::memcmp(a.LevelNodes(level), b.LevelNodes(level), size * sizeof(terrain::PyramidNode<T>)),
      0);
  }
}

// Every node bounds its cells; away from the east and north edges, where places are shared,
// exactly.
template <typename T>
void ExpectBounds(const HeightfieldView<T>& view, const MinMaxPyramid<T>& pyramid)
{
  for (int level = 1; level <= pyramid.LevelCount(); ++level)
  {
    const glm::ivec2 size = pyramid.LevelSize(level);
    const glm::ivec2 nodes = (pyramid.CellCount() + (1 << level) - 1) >> level;
    for (int y = 0; y < nodes.y; ++y)
    {
      for (int x = 0; x < nodes.x; ++x)
      {
        const auto& node = pyramid.At({ x, y }, level);
        const auto expected = Expected(view, level, x, y);
        const bool shared = x >= size.x - 1 || y >= size.y - 1;
        EXPECT_TRUE(shared ? node.Maximum >= expected.Maximum : node.Maximum == expected.Maximum)
          << "level " << level << " node " << x << ", " << y;
        EXPECT_TRUE(shared ? node.Minimum <= expected.Minimum : node.Minimum == expected.Minimum)
          << "level " << level << " node " << x << ", " << y;
      }
    }
  }
}

// Highest and lowest sample of all cells with a surface: what the top node must say exactly.
template <typename T>
void ExpectTop(const HeightfieldView<T>& view, const MinMaxPyramid<T>& pyramid)
{
  const auto expected = Expected(view, 20, 0, 0);
  const auto& top = pyramid.At({ 0, 0 }, pyramid.LevelCount());
  EXPECT_EQ(top.Maximum, expected.Maximum);
  EXPECT_EQ(top.Minimum, expected.Minimum);
}

TEST(MinMaxPyramid, BoundsEveryFieldInEveryType)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    MinMaxPyramid<double> pyramid;
    pyramid.Build(field.View(), terrain::SerialFor);
    ExpectBounds(field.View(), pyramid);
    ExpectTop(field.View(), pyramid);
    const terrain::CodedField<std::uint16_t> integers(field);
    ExpectBounds(integers.TexelView, integers.Pyramid);
    ExpectTop(integers.TexelView, integers.Pyramid);
    const terrain::CodedField<float> floats(field);
    ExpectBounds(floats.TexelView, floats.Pyramid);
    ExpectTop(floats.TexelView, floats.Pyramid);
  }
}

TEST(MinMaxPyramid, HasNoLevelsWithoutCells)
{
  const std::vector<double> samples(10, 1.0);
  for (const auto& [width, height] : { std::pair{ 0, 0 }, { 1, 1 }, { 1, 10 }, { 10, 1 } })
  {
    HeightfieldView<double> view;
    view.Samples = samples.data();
    view.Width = width;
    view.Height = height;
    MinMaxPyramid<double> pyramid;
    pyramid.Build(view, terrain::SerialFor);
    EXPECT_EQ(pyramid.LevelCount(), 0);
    EXPECT_EQ(pyramid.MemorySize(), 0U);
    EXPECT_TRUE(pyramid.Update(view, { { 0, 0 }, { width, height } }, terrain::SerialFor).empty());
  }
}

TEST(MinMaxPyramid, SizesAreThoseOfMipLevels)
{
  for (const glm::ivec2 size :
    { glm::ivec2(8193, 8193), glm::ivec2(5120, 8192), glm::ivec2(4097, 3) })
  {
    const std::vector<std::uint8_t> samples(
      static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 7);
    HeightfieldView<std::uint8_t> view;
    view.Samples = samples.data();
    view.Width = size.x;
    view.Height = size.y;
    MinMaxPyramid<unsigned char> pyramid;
    pyramid.Build(view, terrain::SerialFor);
    EXPECT_EQ(pyramid.LevelSize(1), size / 2);
    for (int level = 2; level <= pyramid.LevelCount(); ++level)
    {
      EXPECT_EQ(
        pyramid.LevelSize(level), glm::max(pyramid.LevelSize(level - 1) / 2, glm::ivec2(1)));
    }
    EXPECT_EQ(pyramid.LevelSize(pyramid.LevelCount()), glm::ivec2(1));
    // With the heights themselves at most 1.7 times their memory.
    EXPECT_LE(static_cast<double>(pyramid.MemorySize()), 0.7 * static_cast<double>(samples.size()));
  }
}

// Levels do not overlap in the array of all nodes, which is hardly longer than they are.
TEST(MinMaxPyramid, LaysLevelsOutInLittleRoom)
{
  for (const glm::ivec2 first : { glm::ivec2(1, 1), { 16, 16 }, { 2048, 2048 }, { 8192, 8192 },
         { 3, 2 }, { 1, 4096 }, { 5000, 2 }, { 1000, 37 }, { 777, 1023 }, { 8191, 4095 } })
  {
    SCOPED_TRACE(std::to_string(first.x) + " x " + std::to_string(first.y));
    std::vector<glm::ivec2> sizes{ first };
    while (sizes.back() != glm::ivec2(1))
    {
      sizes.push_back(glm::max(sizes.back() / 2, glm::ivec2(1)));
    }
    const auto layout = terrain::PyramidLayout::Of(sizes);
    std::int64_t nodes = 0;
    std::int64_t end = 0;
    for (int level = layout.Top; level >= 1; --level)
    {
      const glm::i64vec2 size(sizes[static_cast<std::size_t>(level) - 1]);
      EXPECT_GE(layout.Begin(level), end) << "level " << level;
      end = layout.Begin(level) + size.x * size.y;
      nodes += size.x * size.y;
    }
    EXPECT_LE(end, nodes + nodes / 100 + 2 * layout.Top);
  }
}

TEST(MinMaxPyramid, DoesNotDependOnHowWorkIsSplit)
{
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    MinMaxPyramid<double> serial;
    serial.Build(field.View(), terrain::SerialFor);
    MinMaxPyramid<double> split;
    split.Build(field.View(), terrain::BackwardFor);
    ASSERT_EQ(serial.MemorySize(), split.MemorySize());
    ExpectSame(serial, split);
  }
}

TEST(MinMaxPyramid, HonoursMasksAndNoDataAndInfinities)
{
  std::vector<float> samples(6 * 6, 2.0f);
  std::vector<unsigned char> mask(samples.size(), 1);
  mask[7] = 2;
  samples[3] = std::numeric_limits<float>::infinity();
  samples[28] = -99.0f;
  samples[20] = 5.0f;
  HeightfieldView<float> view;
  view.Samples = samples.data();
  view.Width = 6;
  view.Height = 6;
  view.Mask = mask.data();
  view.MaskBits = 2;
  view.HasNoData = true;
  view.NoData = -99.0f;
  MinMaxPyramid<float> pyramid;
  pyramid.Build(view, terrain::SerialFor);
  ExpectBounds(view, pyramid);
  ExpectTop(view, pyramid);
  EXPECT_TRUE(pyramid.At({ 0, 0 }, 1).IsEmpty());
  EXPECT_FALSE(pyramid.At({ 1, 1 }, 1).IsEmpty());
}

TEST(MinMaxPyramid, BoundingMapIsTheExtremeOfFourSamples)
{
  const std::vector<terrain::TestField> fields = terrain::AdversarialFields();
  const HeightfieldView<double> view = fields[12].View(); // with holes
  std::vector<terrain::PyramidNode<double>> cells(static_cast<std::size_t>(view.Width) - 1);
  for (int j = 0; j < view.Height - 1; ++j)
  {
    MinMaxPyramid<double>::CellExtremes(view, 3, view.Width - 1, j, cells.data());
    for (int i = 3; i < view.Width - 1; ++i)
    {
      const auto expected = Expected(view, 0, i, j);
      EXPECT_EQ(cells[static_cast<std::size_t>(i) - 3].Maximum, expected.Maximum);
      EXPECT_EQ(cells[static_cast<std::size_t>(i) - 3].Minimum, expected.Minimum);
    }
  }
}

// A rectangle of samples changes: only what Update() names is written, and it suffices.
TEST(MinMaxPyramid, UpdateEqualsBuildAndNamesWhatItWrites)
{
  std::mt19937 generator(4);
  for (terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    for (int trial = 0; trial < 20; ++trial)
    {
      MinMaxPyramid<double> before;
      before.Build(field.View(), terrain::SerialFor);
      MinMaxPyramid<double> updated;
      updated.Build(field.View(), terrain::SerialFor);
      const glm::ivec2 size(field.Width, field.Height);
      GridRectangle window;
      window.First = { generator() % field.Width, generator() % field.Height };
      window.End = window.First + glm::ivec2(1 + generator() % 5, 1 + generator() % 5);
      for (int j = window.First.y; j < std::min(window.End.y, size.y); ++j)
      {
        for (int i = window.First.x; i < std::min(window.End.x, size.x); ++i)
        {
          field.Samples[i + static_cast<std::size_t>(j) * size.x] = generator() % 2000;
        }
      }
      const std::vector<GridRectangle> written =
        updated.Update(field.View(), window, terrain::SerialFor);
      MinMaxPyramid<double> after;
      after.Build(field.View(), terrain::SerialFor);
      ExpectSame(after, updated);
      ASSERT_EQ(written.size(), static_cast<std::size_t>(after.LevelCount()));
      for (int level = 1; level <= after.LevelCount(); ++level)
      {
        const GridRectangle& nodes = written[static_cast<std::size_t>(level) - 1];
        EXPECT_LE(nodes.End.x - nodes.First.x, 4);
        for (int y = 0; y < after.LevelSize(level).y; ++y)
        {
          for (int x = 0; x < after.LevelSize(level).x; ++x)
          {
            const bool inside =
              x >= nodes.First.x && x < nodes.End.x && y >= nodes.First.y && y < nodes.End.y;
            EXPECT_TRUE(inside ||
              (before.At({ x, y }, level).Maximum == after.At({ x, y }, level).Maximum &&
                before.At({ x, y }, level).Minimum == after.At({ x, y }, level).Minimum));
          }
        }
      }
    }
  }
}

TEST(MinMaxPyramid, UpdateOfNothingWritesNothing)
{
  const std::vector<terrain::TestField> fields = terrain::AdversarialFields();
  MinMaxPyramid<double> pyramid;
  pyramid.Build(fields[0].View(), terrain::SerialFor);
  for (const GridRectangle& window :
    { GridRectangle{ { 3, 3 }, { 3, 9 } }, GridRectangle{ { 40, 40 }, { 50, 50 } } })
  {
    for (const GridRectangle& nodes : pyramid.Update(fields[0].View(), window, terrain::SerialFor))
    {
      EXPECT_TRUE(nodes.IsEmpty());
    }
  }
}
}
