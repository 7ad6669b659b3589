// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fields in tiles, of which some are missing.
 */
#ifndef UnitTestTiles_h
#define UnitTestTiles_h

#include "UnitTestFields.h"

#include "core/rays/TileTraversal.h"
#include "core/surface/MemoryTiles.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace terrain
{
/// Tiles of 4 x 4 cells: small fields then have several levels.
constexpr int kRayTileLevel = 2;

/// A field in tiles, of which any may be shown.
struct TiledField
{
  std::unique_ptr<TileSource> Source;
  TileLayout Layout;
  TileSlots Slots;
  TiledPyramid Rays;
  std::size_t Shown = 0;

  explicit TiledField(const TestField& field)
    : TiledField(MakeMemoryTiles(field.View(), kRayTileLevel, SerialFor))
  {
  }
  explicit TiledField(std::unique_ptr<TileSource> source)
    : Source(std::move(source))
    , Layout(this->Source->GetLayout())
    , Slots(this->Layout)
  {
    this->Rays.heights = { &this->Slots, glm::ivec2(this->Layout.Width, this->Layout.Height), 0,
      static_cast<float>(this->Source->GetCodes().MaximumCode) };
    this->Levels.tiles = &this->Slots;
    this->Rays.pyramid = &this->Levels;
    this->Rays.start = this->Slots.PyramidTop();
    this->Rays.holes = this->Source->GetCodes().HasNoData;
  }
  TiledField(const TiledField&) = delete;
  TiledField& operator=(const TiledField&) = delete;

  void Show(const TileKey& key)
  {
    auto tile = std::make_shared<Tile>();
    ASSERT_EQ(this->Source->Read(key, *tile), "");
    this->Slots.Show(key, this->Shown++, tile);
  }
  void Hide(const TileKey& key)
  {
    this->Slots.Show(key, this->Slots.GetPages().At(key) - 1, nullptr);
  }
  /// Shows the top and each finer tile, whose parent is shown, if `choose` says so.
  void ShowIf(const std::function<bool(const TileKey&)>& choose)
  {
    for (int level = this->Slots.Top(); level >= 0; --level)
    {
      const glm::i64vec2 tiles = this->Layout.Tiles(level);
      for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k)
      {
        const TileKey key{ level, k % tiles.x, k / tiles.x };
        if (level == this->Slots.Top() || (this->Slots.IsShown(key.Parent()) && choose(key)))
        {
          this->Show(key);
        }
      }
    }
  }
  TerrainHit Trace(const TerrainRay& ray, const glm::vec4& tolerance = glm::vec4(0.0f)) const
  {
    return this->Rays.TraceTiles(ray, tolerance, [](glm::ivec2, int, bool) {});
  }

  TiledLevels Levels;
};
}

#endif
