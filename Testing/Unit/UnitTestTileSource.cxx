// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/surface/MemoryTiles.h"
#include "core/surface/RepeatedTiles.h"
#include "core/surface/TilePyramid.h"
#include "core/surface/TileTail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <thread>
#include <vector>

namespace
{
using terrain::LevelPlane;
using terrain::PyramidNode;
using terrain::TestField;
using terrain::Tile;
using terrain::TileKey;
using terrain::TileLayout;

constexpr int kTileLevel = 2; // tiles of 4 x 4 cells: every field has many

// Bounds of the cells of level 0 in a cell of a level, in codes, straight from the definition.
PyramidNode<float> BruteBounds(const TestField& field, const terrain::HeightCodes& codes, int level,
  std::int64_t x, std::int64_t y)
{
  auto node = PyramidNode<float>::Empty();
  const auto view = field.View();
  const std::int64_t size = std::int64_t{ 1 } << level;
  for (std::int64_t j = y * size; j < std::min((y + 1) * size, view.Height - 1); ++j)
  {
    for (std::int64_t i = x * size; i < std::min((x + 1) * size, view.Width - 1); ++i)
    {
      for (int corner = 0; view.IsCellValid(i, j) && corner < 4; ++corner)
      {
        const auto height = static_cast<float>(view.At(i + corner % 2, j + corner / 2));
        const auto code = static_cast<float>(codes.ToCode(static_cast<double>(height)));
        node.Maximum = std::max(node.Maximum, code);
        node.Minimum = std::min(node.Minimum, code);
      }
    }
  }
  return node;
}

void ForEachTile(const TileLayout& layout, const std::function<void(const TileKey&)>& body)
{
  for (int level = 0; level < layout.LevelCount(); ++level)
  {
    for (std::int64_t row = 0; row < layout.Tiles(level).y; ++row)
    {
      for (std::int64_t column = 0; column < layout.Tiles(level).x; ++column)
      {
        body({ level, column, row });
      }
    }
  }
}

float SampleAt(const Tile& tile, std::int64_t x, std::int64_t y)
{
  return tile.Samples[static_cast<std::size_t>(x + (tile.Cells.x + 1) * y)];
}

// Every field as a source, whole numbers as short, too.
void ForEachSource(const std::function<void(const TestField&, const terrain::TileSource&)>& body)
{
  for (const TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    body(field, *terrain::MakeMemoryTiles(field.View(), kTileLevel, terrain::BackwardFor));
    const bool isShort = std::all_of(field.Samples.begin(), field.Samples.end(),
      [](double h) { return std::isnan(h) || (h == std::floor(h) && std::fabs(h) < 32767.0); });
    if (isShort)
    {
      std::vector<short> samples;
      for (const double h : field.Samples)
      {
        samples.push_back(std::isnan(h) ? terrain::NoStoredHeight<short>() : static_cast<short>(h));
      }
      const terrain::MemoryTiles<short> source(
        samples.data(), { field.Width, field.Height, kTileLevel }, terrain::SerialFor);
      body(field, source);
    }
  }
}
}

TEST(TileSource, SizesOfLevelsAreNested)
{
  for (const std::int64_t width : { 2, 3, 5, 9, 10, 257, 258, 49152, 1048577 })
  {
    const TileLayout layout{ width, 2, 8 };
    for (int level = 1; level < layout.LevelCount(); ++level)
    {
      EXPECT_EQ(layout.Cells(level).x, (layout.Cells(level - 1).x + 1) / 2);
    }
    EXPECT_EQ(layout.Tiles(layout.LevelCount() - 1), glm::i64vec2(1)) << width;
  }
  EXPECT_EQ((TileLayout{ 1, 100, 8 }.LevelCount()), 0);
  EXPECT_EQ((TileLayout{ 0, 0, 8 }.LevelCount()), 0);
  EXPECT_EQ((TileLayout{ std::int64_t{ 1 } << 31, 2, 8 }.LevelCount()), 24);
}

TEST(TileSource, BoundsAreThoseOfAllSamples)
{
  ForEachSource(
    [](const TestField& field, const terrain::TileSource& source)
    {
      const TileLayout layout = source.GetLayout();
      ForEachTile(layout,
        [&](const TileKey& key)
        {
          const auto bounds =
            BruteBounds(field, source.GetCodes(), key.Level + kTileLevel, key.Column, key.Row);
          EXPECT_EQ(source.GetBounds(key).Maximum, bounds.Maximum);
          EXPECT_EQ(source.GetBounds(key).Minimum, bounds.Minimum);
          Tile tile;
          ASSERT_EQ(source.Read(key, tile), "");
          const glm::i64vec2 first = layout.FirstCell(key);
          for (std::size_t k = 0; k < tile.Nodes.size(); ++k)
          {
            const auto x = static_cast<std::int64_t>(k) % tile.Cells.x;
            const auto y = static_cast<std::int64_t>(k) / tile.Cells.x;
            const auto node =
              BruteBounds(field, source.GetCodes(), key.Level, first.x + x, first.y + y);
            ASSERT_EQ(tile.Nodes[k].Maximum, node.Maximum);
            ASSERT_EQ(tile.Nodes[k].Minimum, node.Minimum);
          }
        });
    });
}

TEST(TileSource, PatchesLieWithinTheirBounds)
{
  ForEachSource(
    [](const TestField& /*field*/, const terrain::TileSource& source)
    {
      ForEachTile(source.GetLayout(),
        [&](const TileKey& key)
        {
          Tile tile;
          ASSERT_EQ(source.Read(key, tile), "");
          for (std::size_t k = 0; k < tile.Nodes.size(); ++k)
          {
            const auto x = static_cast<std::int64_t>(k) % tile.Cells.x;
            const auto y = static_cast<std::int64_t>(k) / tile.Cells.x;
            for (int corner = 0; corner < 4 && !tile.Nodes[k].IsEmpty(); ++corner)
            {
              const float code = SampleAt(tile, x + corner % 2, y + corner / 2);
              if (code >= 0.0F)
              {
                ASSERT_GE(code, tile.Nodes[k].Minimum);
                ASSERT_LE(code, tile.Nodes[k].Maximum);
              }
            }
          }
        });
    });
}

TEST(TileSource, NeighboursShareTheirBorder)
{
  ForEachSource(
    [](const TestField& /*field*/, const terrain::TileSource& source)
    {
      const TileLayout layout = source.GetLayout();
      ForEachTile(layout,
        [&](const TileKey& key)
        {
          Tile tile;
          ASSERT_EQ(source.Read(key, tile), "");
          Tile east;
          if (source.Read({ key.Level, key.Column + 1, key.Row }, east).empty())
          {
            for (int y = 0; y <= tile.Cells.y; ++y)
            {
              ASSERT_EQ(SampleAt(tile, tile.Cells.x, y), SampleAt(east, 0, y));
            }
          }
          Tile north;
          if (source.Read({ key.Level, key.Column, key.Row + 1 }, north).empty())
          {
            for (int x = 0; x <= tile.Cells.x; ++x)
            {
              ASSERT_EQ(SampleAt(tile, x, tile.Cells.y), SampleAt(north, x, 0));
            }
          }
        });
    });
}

TEST(TileSource, LevelZeroIsTheHeightfield)
{
  ForEachSource(
    [](const TestField& field, const terrain::TileSource& source)
    {
      const TileLayout layout = source.GetLayout();
      const terrain::HeightCodes codes = source.GetCodes();
      for (std::int64_t row = 0; layout.LevelCount() > 0 && row < layout.Tiles(0).y; ++row)
      {
        for (std::int64_t column = 0; column < layout.Tiles(0).x; ++column)
        {
          Tile tile;
          ASSERT_EQ(source.Read({ 0, column, row }, tile), "");
          const glm::i64vec2 first = layout.FirstCell({ 0, column, row });
          for (std::int64_t y = 0; y <= tile.Cells.y; ++y)
          {
            for (std::int64_t x = 0; x <= tile.Cells.x; ++x)
            {
              const auto height = static_cast<float>(field.View().At(first.x + x, first.y + y));
              const float expected = std::isfinite(height)
                ? static_cast<float>(codes.ToCode(static_cast<double>(height)))
                : terrain::kNoDataCode;
              ASSERT_EQ(SampleAt(tile, x, y), expected);
            }
          }
        }
      }
    });
}

// A plane stays a plane away from the edges, which no filter that shifts or overshoots does.
TEST(TileSource, AveragesOfAPlaneLieOnIt)
{
  const TestField plane("plane", 65, 65, [](int i, int j) { return 1000.0 + 16.0 * i - 32.0 * j; });
  const auto source = terrain::MakeMemoryTiles(plane.View(), 4, terrain::SerialFor);
  Tile tile;
  ASSERT_EQ(source->Read({ 2, 0, 0 }, tile), "");
  for (int y = 1; y < 16; ++y)
  {
    for (int x = 1; x < 16; ++x)
    {
      EXPECT_NEAR(source->GetCodes().ToHeight(static_cast<double>(SampleAt(tile, x, y))),
        plane.View().At(4 * x, 4 * y), 1e-2);
    }
  }
}

// Of whole numbers, the nearest to a sixteenth of (1 2 1) in both directions; few are brought into
// the bounds of their cells.
TEST(TileSource, AveragesOfWholeNumbersAreTheNearest)
{
  constexpr int side = 33;
  std::vector<short> samples(static_cast<std::size_t>(side) * side);
  std::uint32_t state = 1;
  for (short& sample : samples)
  {
    state = state * 1664525U + 1013904223U;
    sample = static_cast<short>(static_cast<int>(state >> 20U) - 2048);
  }
  terrain::HeightfieldView<short> view;
  view.Samples = samples.data();
  view.Width = side;
  view.Height = side;
  const auto source = terrain::MakeMemoryTiles(view, 4, terrain::SerialFor);
  Tile tile;
  ASSERT_EQ(source->Read({ 1, 0, 0 }, tile), "");
  int different = 0;
  for (int y = 1; y < 16; ++y)
  {
    for (int x = 1; x < 16; ++x)
    {
      int sum = 0;
      for (int k = 0; k < 9; ++k)
      {
        const int weight = (k % 3 == 1 ? 2 : 1) * (k / 3 == 1 ? 2 : 1);
        sum += weight * view.At(2 * x + k % 3 - 1, 2 * y + k / 3 - 1);
      }
      const double average = source->GetCodes().ToHeight(static_cast<double>(SampleAt(tile, x, y)));
      different += std::abs(16.0 * average - sum) <= 8.0 ? 0 : 1;
    }
  }
  EXPECT_LE(different, 2);
}

TEST(TileSource, RefusesTilesThatAreNot)
{
  const TestField flat("flat", 9, 9, [](int, int) { return 1.0; });
  const auto source = terrain::MakeMemoryTiles(flat.View(), kTileLevel, terrain::SerialFor);
  Tile tile;
  EXPECT_NE(source->Read({ 0, 2, 0 }, tile), "");
  EXPECT_NE(source->Read({ 0, -1, 0 }, tile), "");
  EXPECT_NE(source->Read({ 2, 0, 0 }, tile), "");
  EXPECT_NE(source->Read({ -1, 0, 0 }, tile), "");
}

// A 16-bit height that equals the value for none is a height all the same.
TEST(TileSource, KeepsAllHeightsOf16Bits)
{
  const std::vector<short> samples{ -32768, 32767, 0, 5 };
  terrain::HeightfieldView<short> view;
  view.Samples = samples.data();
  view.Width = 2;
  view.Height = 2;
  const auto source = terrain::MakeMemoryTiles(view, kTileLevel, terrain::SerialFor);
  Tile tile;
  ASSERT_EQ(source->Read({ 0, 0, 0 }, tile), "");
  EXPECT_EQ(source->GetCodes().ToHeight(static_cast<double>(tile.Samples[0])), -32768.0);
  EXPECT_EQ(source->GetCodes().ToHeight(static_cast<double>(tile.Samples[1])), 32767.0);
}

// Repeated as tiles it is what it is repeated as samples: level 0, and the bounds of all levels.
TEST(RepeatedTiles, AreTheRepeatedSamples)
{
  const TestField field("hills", 9, 9,
    [](int i, int j) { return 50.0 * std::sin(0.7 * i) + 30.0 * std::cos(0.9 * j + 0.2 * i); });
  const std::vector<float> samples(field.Samples.begin(), field.Samples.end());
  const std::vector<float> period = terrain::MirrorSamples(samples, 8);
  constexpr int kTimes = 3;
  const TestField whole("repeated", 16 * kTimes + 1, 16 * kTimes + 1,
    [&](int i, int j)
    { return static_cast<double>(period[static_cast<std::size_t>(i % 16 + 17 * (j % 16))]); });
  const terrain::RepeatedTiles tiles(period, 4, kTimes, kTileLevel, terrain::SerialFor);
  ForEachTile(tiles.GetLayout(),
    [&](const TileKey& key)
    {
      const auto bounds =
        BruteBounds(whole, tiles.GetCodes(), key.Level + kTileLevel, key.Column, key.Row);
      EXPECT_GE(tiles.GetBounds(key).Maximum, bounds.Maximum);
      EXPECT_LE(tiles.GetBounds(key).Minimum, bounds.Minimum);
      Tile tile;
      ASSERT_EQ(tiles.Read(key, tile), "");
      const glm::i64vec2 first = tiles.GetLayout().FirstCell(key);
      for (std::int64_t k = 0; k < std::int64_t{ tile.Cells.x } * tile.Cells.y; ++k)
      {
        const std::int64_t x = k % tile.Cells.x;
        const std::int64_t y = k / tile.Cells.x;
        const auto node = BruteBounds(whole, tiles.GetCodes(), key.Level, first.x + x, first.y + y);
        for (int corner = 0; corner < 4; ++corner)
        {
          const float code = SampleAt(tile, x + corner % 2, y + corner / 2);
          if (key.Level > 0)
          {
            const PyramidNode<float>& bound = tile.Nodes[static_cast<std::size_t>(k)];
            ASSERT_GE(bound.Maximum, node.Maximum);
            ASSERT_LE(bound.Minimum, node.Minimum);
            ASSERT_TRUE(code >= bound.Minimum && code <= bound.Maximum);
          }
          else
          {
            const double height =
              whole.View().At(first.x + x + corner % 2, first.y + y + corner / 2);
            ASSERT_NEAR(tiles.GetCodes().ToHeight(static_cast<double>(code)), height, 1e-4);
          }
        }
      }
    });
}

// The pass with bounded memory makes the same tiles, however the rows come.
TEST(TilePyramid, MakesTheTilesOfTheWhole)
{
  for (const TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    const std::vector<float> samples(field.Samples.begin(), field.Samples.end());
    const TileLayout layout{ field.Width, field.Height, kTileLevel };
    const terrain::MemoryTiles<float> whole(samples.data(), layout, terrain::SerialFor);
    for (const std::int64_t step : { 1, 3, 4, 1000 })
    {
      std::map<TileKey, Tile> tiles;
      terrain::TilePyramid<float> pyramid(
        layout, 1,
        [&](int level, std::int64_t row, const LevelPlane<const float>& plane,
          const LevelPlane<const PyramidNode<float>>& nodes)
        {
          for (std::int64_t column = 0; column < layout.Tiles(level).x; ++column)
          {
            const TileKey key{ level, column, row };
            terrain::CutTile<float>(layout, key, plane, nodes, whole.GetCodes(), tiles[key]);
          }
        },
        terrain::BackwardFor);
      for (std::int64_t row = 0; layout.LevelCount() > 0 && row < field.Height; row += step)
      {
        const std::int64_t count = std::min<std::int64_t>(step, field.Height - row);
        std::copy_n(
          samples.data() + row * field.Width, count * field.Width, pyramid.AddRows(count));
        pyramid.Build();
      }
      std::size_t expected = 0;
      ForEachTile(layout,
        [&](const TileKey& key)
        {
          if (key.Level == 0)
          {
            return;
          }
          ++expected;
          Tile tile;
          ASSERT_EQ(whole.Read(key, tile), "");
          ASSERT_EQ(tiles.count(key), 1U);
          const Tile& other = tiles[key];
          ASSERT_EQ(tile.Cells, other.Cells);
          ASSERT_EQ(tile.Samples, other.Samples);
          ASSERT_EQ(std::memcmp(tile.Nodes.data(), other.Nodes.data(),
                      tile.Nodes.size() * sizeof(PyramidNode<float>)),
            0);
        });
      EXPECT_EQ(tiles.size(), expected);
    }
  }
}

TEST(TileTail, HasTheBoundsOfAllSamplesUpToOneNode)
{
  ForEachSource(
    [](const TestField& field, const terrain::TileSource& source)
    {
      const int top = source.GetLayout().LevelCount() - 1;
      Tile tile;
      ASSERT_EQ(source.Read({ top, 0, 0 }, tile), "");
      const std::vector<PyramidNode<float>> square = terrain::MakeTileTail(tile, kTileLevel);
      ASSERT_EQ(square.size(), 16u);
      // 2 x 2 nodes from column 0 on, one at column 2
      for (int k = 0; k < 5; ++k)
      {
        const int above = k < 4 ? 1 : 2;
        const glm::ivec2 node(k < 4 ? k % 2 : 0, k < 4 ? k / 2 : 0);
        SCOPED_TRACE(k);
        EXPECT_EQ(terrain::TileTailColumn(kTileLevel, above), k < 4 ? 0 : 2);
        const auto brute = BruteBounds(field, source.GetCodes(), top + above, node.x, node.y);
        const PyramidNode<float>& found =
          square[static_cast<std::size_t>((k < 4 ? node.x : 2) + 4 * node.y)];
        EXPECT_EQ(found.IsEmpty(), brute.IsEmpty());
        if (!brute.IsEmpty())
        {
          EXPECT_EQ(found.Maximum, brute.Maximum);
          EXPECT_EQ(found.Minimum, brute.Minimum);
        }
      }
    });
}
