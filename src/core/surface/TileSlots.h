// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tiles of a heightfield that rays can see, as the GPU has them: slots that hold tiles, and a
 * page table that tells for each tile of each level which slot holds it.
 */
#ifndef terrain_TileSlots_h
#define terrain_TileSlots_h

#include "core/surface/TileSource.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace terrain
{
/// A page for each tile: 0, or the slot that holds the tile plus 1. Whoever shows a tile shows its
/// parents too, up to the top.
///
/// A level has pages for a square of tiles, 2^(top - level) along a side, row by row; the levels
/// come from the top down. So places follow from bits.
class TilePages
{
public:
  TilePages() = default;
  explicit TilePages(const TileLayout& layout)
    : Layout(layout)
    , Pages(layout.LevelCount() > 0 ? LevelBegin(layout.LevelCount()) : 0)
  {
  }

  const TileLayout& GetLayout() const
  {
    return this->Layout;
  }
  /// The coarsest level, whose only tile rays begin in.
  int Top() const
  {
    return this->Layout.LevelCount() - 1;
  }
  const std::vector<std::uint32_t>& Get() const
  {
    return this->Pages;
  }
  /// Twin: terrainTilePage() in shaders/vtkTerrainTiles.glsl.
  std::size_t PlaceOf(const TileKey& key) const
  {
    const int depth = this->Top() - key.Level;
    return LevelBegin(depth) + (static_cast<std::size_t>(key.Row) << depth) +
      static_cast<std::size_t>(key.Column);
  }
  std::uint32_t At(const TileKey& key) const
  {
    return this->Pages[this->PlaceOf(key)];
  }
  void Set(const TileKey& key, std::uint32_t page)
  {
    this->Pages[this->PlaceOf(key)] = page;
  }
  bool IsShown(const TileKey& key) const
  {
    return this->At(key) != 0;
  }
  void Clear()
  {
    std::fill(this->Pages.begin(), this->Pages.end(), 0);
  }

private:
  /// Pages of the levels above: 1 + 4 + 16 + ...
  static std::size_t LevelBegin(int depth)
  {
    return std::size_t{ 0x5555555555555555 } & ((std::size_t{ 1 } << (2 * depth)) - 1);
  }

  TileLayout Layout;
  std::vector<std::uint32_t> Pages;
};

/// Pages, and the tiles in the slots.
class TileSlots
{
public:
  TileSlots() = default;
  explicit TileSlots(const TileLayout& layout)
    : Pages(layout)
  {
  }

  const TilePages& GetPages() const
  {
    return this->Pages;
  }
  int Top() const
  {
    return this->Pages.Top();
  }
  bool IsShown(const TileKey& key) const
  {
    return this->Pages.IsShown(key);
  }
  /// Shows a tile in a slot; null hides it.
  void Show(const TileKey& key, std::size_t slot, std::shared_ptr<const Tile> tile)
  {
    this->Pages.Set(key, tile ? static_cast<std::uint32_t>(slot + 1) : 0);
    this->Slots.resize(std::max(this->Slots.size(), slot + 1));
    this->Slots[slot] = std::move(tile);
  }

  /// The tile over a cell of a level, or null.
  const Tile* Find(glm::ivec2 cell, int level) const
  {
    const glm::ivec2 tile = cell >> this->Pages.GetLayout().TileLevel;
    const std::uint32_t page = this->Pages.At({ level, tile.x, tile.y });
    return page == 0 ? nullptr : this->Slots[page - 1].get();
  }
  /// Place of a cell in its tile.
  glm::ivec2 InTile(glm::ivec2 cell) const
  {
    return cell & ((1 << this->Pages.GetLayout().TileLevel) - 1);
  }

private:
  TilePages Pages;
  std::vector<std::shared_ptr<const Tile>> Slots;
};
}

#endif
