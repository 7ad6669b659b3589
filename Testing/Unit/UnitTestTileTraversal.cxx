// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"
#include "UnitTestRays.h"
#include "UnitTestTiles.h"

#include "core/surface/TileSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace
{
using terrain::CellPiece;
using terrain::CodedField;
using terrain::TerrainHit;
using terrain::TerrainRay;
using terrain::TestField;
using terrain::Tile;
using terrain::TiledField;
using terrain::TileKey;

const glm::vec4 kExact(0.0f);

// The pieces of a ray over what is shown: the finest node or cell at each place, in double.
std::vector<CellPiece> ShownPieces(const TiledField& field, const TerrainRay& ray)
{
  std::vector<CellPiece> pieces;
  for (int level = field.Slots.Top(); level >= 0; --level)
  {
    const glm::i64vec2 cells = field.Layout.Cells(level);
    const double size = std::ldexp(1.0, level);
    for (std::int64_t k = 0; k < cells.x * cells.y; ++k)
    {
      const glm::ivec2 cell(static_cast<int>(k % cells.x), static_cast<int>(k / cells.x));
      if (!field.Slots.Find(cell, level) || (level > 0 && field.Slots.Find(2 * cell, level - 1)))
      {
        continue;
      }
      const glm::dvec4 codes(field.Rays.heights.LevelCodes(cell, level));
      if (std::min(std::min(codes.x, codes.y), std::min(codes.z, codes.w)) < 0.0)
      {
        continue;
      }
      CellPiece piece = terrain::ClipToSquare(ray, size * glm::dvec2(cell), size);
      const glm::dvec3 origin(ray.originGC.x + static_cast<double>(ray.anchorCell.x),
        ray.originGC.y + static_cast<double>(ray.anchorCell.y), 0.0);
      const double twist = codes.x - codes.y - codes.z + codes.w;
      const double east = codes.y - codes.x;
      const double north = codes.z - codes.x;
      const double u = origin.x / size - cell.x;
      const double v = origin.y / size - cell.y;
      const glm::dvec3 d(ray.directionGC.x / size, ray.directionGC.y / size, ray.directionGC.z);
      piece.A = -twist * d.x * d.y;
      piece.B = d.z - east * d.x - north * d.y - twist * (u * d.y + v * d.x);
      piece.C = static_cast<double>(ray.originGC.z) + static_cast<double>(ray.originLow) - codes.x -
        east * u - north * v - twist * u * v;
      for (int axis = 0; axis < 2; ++axis)
      {
        // the grid may end within the cell
        const double last =
          static_cast<double>(axis == 0 ? field.Layout.Width - 1 : field.Layout.Height - 1);
        const double direction = ray.directionGC[axis];
        const double s = (last - origin[axis]) / direction;
        piece.End = direction > 0.0 ? std::min(piece.End, s) : piece.End;
        piece.Begin = direction < 0.0 ? std::max(piece.Begin, s) : piece.Begin;
        piece.End = direction == 0.0 && origin[axis] > last ? piece.Begin - 1.0 : piece.End;
      }
      if (piece.Begin <= piece.End)
      {
        pieces.push_back(piece);
      }
    }
  }
  SortPieces(pieces);
  return pieces;
}

// Rounding of heights along a ray, in codes.
double RayError(const TiledField& field, const TerrainRay& ray)
{
  const double reach = static_cast<double>(field.Rays.heights.maximumCode) +
    std::abs(static_cast<double>(ray.originGC.z)) +
    std::abs(static_cast<double>(ray.directionGC.z));
  return 1e-4 * (1.0 + reach);
}

// A hit lies on a patch, or on the wall between two; no surface lies before it.
// With holes, a ray may slip through a step.
void ExpectShown(const TiledField& field, const TerrainRay& ray, const TerrainHit& hit)
{
  const std::vector<CellPiece> pieces = ShownPieces(field, ray);
  const double error = RayError(field, ray);
  const double room = 1e-5; // of s, by which a wall may lie farther than in double
  const double before = hit.found ? hit.s - room : std::numeric_limits<double>::infinity();
  const bool holes = field.Source->GetCodes().HasNoData;
  ASSERT_LE(holes ? 0.0 : terrain::Penetration(pieces, before), error) << "passed through";
  if (!hit.found)
  {
    return;
  }
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const CellPiece& piece : pieces)
  {
    if (hit.s >= piece.Begin - room && hit.s <= piece.End + room)
    {
      const double s = std::clamp(static_cast<double>(hit.s), piece.Begin, piece.End);
      lowest = std::min(lowest, piece.At(s));
      highest = std::max(highest, piece.At(s));
    }
  }
  ASSERT_LE(lowest, error) << "above the surface";
  ASSERT_GE(highest, -error) << "below the surface";
}

// The step beyond the grid that a ray ends with has no tile, and is asked for.
TEST(TileTraversal, HasNoTilesBeyondTheGrid)
{
  const TestField flat("flat", 34, 19, [](int, int) { return 1.0; });
  const TiledField field(flat);
  for (const glm::ivec2 cell : { glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(4096, 0) })
  {
    EXPECT_EQ(field.Slots.TileSlot(cell, 0), -1);
  }
}

// Four planes around the lines from an eye through the corners of a square, looking along +y.
terrain::TileView ViewFrom(const glm::dvec3& eye, double halfWidth, const glm::dvec4& tolerance)
{
  terrain::TileView view;
  view.Eye = eye;
  view.Forward = { 0.0, 1.0, 0.0 };
  view.Tolerance = tolerance;
  for (const double sign : { -1.0, 1.0 })
  {
    const glm::dvec3 side(sign, halfWidth, 0.0);
    const glm::dvec3 above(0.0, halfWidth * 20.0, sign);
    view.Planes.emplace_back(side, -glm::dot(side, eye));
    view.Planes.emplace_back(above, -glm::dot(above, eye));
  }
  return view;
}

// A field in tiles before an eye, and rays of its view.
struct SelectedTiles
{
  const TestField Test{ "hills", 150, 140, [](int i, int j) {
                         return 40.0 * std::sin(0.11 * i) * std::cos(0.13 * j) +
                           7.0 * std::sin(1.1 * i + 0.7 * j);
                       } };
  TiledField Field{ Test };
  const glm::dvec3 Eye{ 70.0, -12.0, 120.0 };
  const double Pixel = 0.025; // its size at distance 1
  const terrain::TileView View = ViewFrom(Eye, 0.6, { 0.0, 0.0, 2.0 * Pixel, 8.0 * Pixel });
  // s is a share of a ray of 300 cells: the tolerance per unit of s is that of all of it.
  const glm::vec4 Tolerance = 300.0f * glm::vec4(0.0, 0.0, View.Tolerance.z, View.Tolerance.w);
  terrain::TileSelection Selection;
  std::mt19937 Generator{ 3 };

  /// Selects tiles until all that the selection asks for are read.
  void Select()
  {
    std::map<TileKey, std::shared_ptr<Tile>> read;
    int rounds = 0;
    do
    {
      this->Selection = terrain::SelectTiles(*this->Field.Source, this->View, 100000,
        [&](const TileKey& key) { return read.count(key) > 0 ? read[key]->Relief : -1.0F; });
      for (const terrain::TileWish& wish : this->Selection.Tiles)
      {
        auto& tile = read[wish.Key];
        tile = tile ? tile : std::make_shared<Tile>();
        ASSERT_EQ(this->Field.Source->Read(wish.Key, *tile), "");
      }
      ASSERT_LT(++rounds, 20);
    } while (!this->Selection.IsFinal);
  }
  std::size_t CountTiles() const
  {
    std::size_t all = 0;
    for (int level = 0; level <= this->Field.Slots.Top(); ++level)
    {
      const glm::i64vec2 tiles = this->Field.Layout.Tiles(level);
      all += static_cast<std::size_t>(tiles.x * tiles.y);
    }
    return all;
  }
  TerrainRay MakeRay()
  {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const double east = 0.6 * uniform(this->Generator);
    const glm::dvec3 way(east, 1.0, uniform(this->Generator) - 0.4);
    return terrain::RayBetween(this->Eye, this->Eye + 300.0 * way);
  }
  /// Counts the nodes of a ray whose finer tiles are missed.
  TerrainHit Trace(const TerrainRay& ray, int& asked) const
  {
    return this->Field.Rays.TraceTiles(
      ray, this->Tolerance, [&](glm::ivec2, int, bool missing) { asked += missing ? 1 : 0; });
  }
};
}

TEST(TileTraversal, IsThePyramidsWhereAllTilesAreThere)
{
  unsigned seed = 700;
  for (TestField test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    for (double& height : test.Samples)
    {
      height = static_cast<double>(static_cast<float>(height)); // as tiles keep it
    }
    TiledField field(test);
    if (field.Slots.Top() < 1)
    {
      continue;
    }
    CodedField<float> whole(test);
    field.ShowIf([](const TileKey&) { return true; });
    whole.Coded.start = field.Slots.Top();
    terrain::RayMaker maker(
      { test.Width, test.Height }, whole.Codes.MaximumCode, ++seed, !whole.Codes.HasNoData);
    for (int trial = 0; trial < 1000; ++trial)
    {
      const TerrainRay ray = maker.Make();
      const TerrainHit expected = whole.Coded.TracePyramid(ray);
      const TerrainHit hit = field.Trace(ray);
      ASSERT_EQ(hit.found, expected.found) << trial;
      if (hit.found)
      {
        ASSERT_NEAR(hit.s, expected.s, 1e-5) << trial;
      }
    }
  }
}

TEST(TileTraversal, LetsNoRayThroughWhereTilesAreMissing)
{
  unsigned seed = 800;
  int hits = 0;
  int coarse = 0;
  for (const TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    for (int round = 0; round < 6; ++round)
    {
      TiledField field(test);
      if (field.Slots.Top() < 1)
      {
        break;
      }
      std::minstd_rand generator(++seed);
      field.ShowIf([&](const TileKey&) { return generator() % 3u != 0; });
      // A ray along an edge between two levels has the choice of surfaces.
      terrain::RayMaker maker({ test.Width, test.Height },
        static_cast<double>(field.Rays.heights.maximumCode), ++seed, false);
      for (int trial = 0; trial < 400; ++trial)
      {
        SCOPED_TRACE(trial);
        const TerrainRay ray = maker.Make();
        bool missed = false;
        const TerrainHit hit = field.Rays.TraceTiles(
          ray, kExact, [&](glm::ivec2, int, bool missing) { missed = missed || missing; });
        ExpectShown(field, ray, hit);
        hits += hit.found ? 1 : 0;
        coarse += missed ? 1 : 0;
        if (testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
  EXPECT_GT(hits, 5000);
  EXPECT_GT(coarse, 5000);
}

// The order in which tiles came, and which ones were there before, does not tell.
TEST(TileTraversal, TheSameTilesGiveTheSameHits)
{
  const TestField test = terrain::AdversarialFields()[7]; // hills
  TiledField field(test);
  TiledField other(test);
  const auto choose = [](const TileKey& key) { return (key.Column + key.Row) % 2 == 0; };
  field.ShowIf(choose);
  other.ShowIf([](const TileKey&) { return true; });
  for (int level = 0; level < other.Slots.Top(); ++level)
  {
    const glm::i64vec2 tiles = other.Layout.Tiles(level);
    for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k)
    {
      const TileKey key{ level, k % tiles.x, k / tiles.x };
      if (!field.Slots.IsShown(key))
      {
        other.Hide(key);
      }
    }
  }
  terrain::RayMaker maker({ test.Width, test.Height }, 700.0, 5);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const TerrainRay ray = maker.Make();
    const TerrainHit a = field.Trace(ray);
    const TerrainHit b = other.Trace(ray);
    ASSERT_EQ(a.found, b.found);
    ASSERT_EQ(a.s, b.s);
    ASSERT_EQ(a.cell, b.cell);
    ASSERT_EQ(a.fraction, b.fraction);
  }
}

// With the selected tiles, rays of the view end within the tolerance and ask for no others; and
// with fewer tiles they would.
TEST(TileSelection, HoldsWhatTheRaysOfAViewComeTo)
{
  SelectedTiles tiles;
  ASSERT_NO_FATAL_FAILURE(tiles.Select());
  EXPECT_TRUE(tiles.Selection.Fits);
  EXPECT_LT(tiles.Selection.Tiles.size(), tiles.CountTiles() / 2);
  TiledField& field = tiles.Field;
  for (const terrain::TileWish& wish : tiles.Selection.Tiles)
  {
    ASSERT_TRUE(wish.Key.Level == field.Slots.Top() || field.Slots.IsShown(wish.Key.Parent()));
    field.Show(wish.Key);
  }
  CodedField<float> whole(tiles.Test);
  whole.Coded.start = 6;
  int found = 0;
  int asked = 0;
  for (int trial = 0; trial < 4000; ++trial)
  {
    const TerrainRay ray = tiles.MakeRay();
    const TerrainHit hit = tiles.Trace(ray, asked);
    const TerrainHit exact = whole.Coded.TracePyramid(ray);
    const TerrainHit within =
      whole.Coded.TracePyramidWithin(ray, tiles.Tolerance, [](glm::ivec2, int) {});
    ASSERT_EQ(hit.found, within.found) << trial;
    ASSERT_TRUE(hit.found || !exact.found);
    if (hit.found)
    {
      ++found;
      ASSERT_NEAR(hit.s, within.s, 1e-5);
    }
  }
  EXPECT_EQ(asked, 0);
  EXPECT_GT(found, 1000);
  // without the finest tiles, they ask
  for (const terrain::TileWish& wish : tiles.Selection.Tiles)
  {
    if (wish.Key.Level == 0)
    {
      field.Hide(wish.Key);
    }
  }
  for (int trial = 0; trial < 4000 && asked == 0; ++trial)
  {
    tiles.Trace(tiles.MakeRay(), asked);
  }
  EXPECT_GT(asked, 0);
}

TEST(TileSelection, ABudgetKeepsTheMostUrgent)
{
  const TestField test(
    "hills", 150, 140, [](int i, int j) { return 40.0 * std::sin(0.11 * i) * std::cos(0.13 * j); });
  TiledField field(test);
  std::map<TileKey, std::shared_ptr<Tile>> read;
  const auto find = [&](const TileKey& key)
  {
    auto& tile = read[key];
    if (!tile)
    {
      tile = std::make_shared<Tile>();
      EXPECT_EQ(field.Source->Read(key, *tile), "");
    }
    return tile->Relief;
  };
  const terrain::TileView view = ViewFrom({ 70.0, -12.0, 120.0 }, 0.6, { 0.0, 0.0, 0.02, 0.02 });
  const auto whole = terrain::SelectTiles(*field.Source, view, 100000, find);
  EXPECT_TRUE(whole.Fits && whole.IsFinal);
  for (const std::size_t most : { std::size_t{ 0 }, std::size_t{ 1 }, std::size_t{ 20 } })
  {
    const auto part = terrain::SelectTiles(*field.Source, view, most, find);
    EXPECT_FALSE(part.Fits);
    EXPECT_LE(part.Tiles.size(), std::max<std::size_t>(most, 1));
    for (std::size_t k = 0; k < part.Tiles.size(); ++k)
    {
      EXPECT_EQ(part.Tiles[k].Key, whole.Tiles[k].Key);
    }
  }
}
