// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tiles of a heightfield that rays can see, as the GPU has them: slots that hold tiles, a page
 * table that tells for each tile of each level which slot holds it, and a slot behind all others
 * for the mip tail (TileTail.h), which holds bounds only.
 */
#ifndef terrain_TileSlots_h
#define terrain_TileSlots_h

#include "core/surface/CodedHeights.h"
#include "core/surface/TileSource.h"
#include "core/surface/TileTail.h"

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
  /// As terrainTileSlot() in shaders/vtkTerrainTiles.glsl finds it.
  std::size_t PlaceOf(const TileKey& key) const
  {
    const int depth = this->Top() - key.Level;
    return LevelBegin(depth) + (static_cast<std::size_t>(key.Row) << depth) +
      static_cast<std::size_t>(key.Column);
  }
  /// True for the tiles of a level, and those that would be if both sides had as many as the longer
  /// one and these were a power of two.
  bool HasRoomFor(const TileKey& key) const
  {
    const std::int64_t tiles = std::int64_t{ 1 } << (this->Top() - key.Level);
    return key.Column >= 0 && key.Row >= 0 && key.Column < tiles && key.Row < tiles;
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
  /// The coarsest level of the mip tail, which has one node.
  int PyramidTop() const
  {
    return this->Top() + this->Pages.GetLayout().TileLevel;
  }
  /// The slot of the mip tail.
  int TailSlot() const
  {
    return static_cast<int>(this->Slots.size());
  }
  const std::vector<PyramidNode<float>>& GetTail() const
  {
    return this->Tail;
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
    if (tile && key.Level == this->Top())
    {
      this->Tail = MakeTileTail(*tile, this->Pages.GetLayout().TileLevel);
    }
    this->Slots[slot] = std::move(tile);
  }

  /// The tile over a cell of a level, or null.
  const Tile* Find(glm::ivec2 cell, int level) const
  {
    const int slot = this->TileSlot(cell, level);
    return slot < 0 ? nullptr : this->Slots[static_cast<std::size_t>(slot)].get();
  }

  /// What a slot holds; null if nothing.
  const Tile* GetTile(std::size_t slot) const
  {
    return this->Slots[slot].get();
  }

  ///@{
  /// Twins of the functions in shaders/vtkTerrainTiles.glsl, which have the prefix terrain and
  /// document them.
  int TileSlot(glm::ivec2 cell, int level) const
  {
    if (level > this->Top())
    {
      return this->TailSlot();
    }
    const glm::ivec2 tile = cell >> this->Pages.GetLayout().TileLevel;
    // a ray that ends at the border asks beyond it, and does not look at the answer
    const bool isThere = this->Pages.HasRoomFor({ level, tile.x, tile.y });
    return isThere ? static_cast<int>(this->Pages.At({ level, tile.x, tile.y })) - 1 : -1;
  }
  glm::vec4 SlotCodes(glm::ivec2 cell, int slot) const
  {
    const Tile& tile = *this->Slots[static_cast<std::size_t>(slot)];
    const glm::ivec2 at = this->InTile(cell);
    const float* south = &tile.Samples[static_cast<std::size_t>(at.x) +
      static_cast<std::size_t>(tile.Cells.x + 1) * static_cast<std::size_t>(at.y)];
    const float* north = south + tile.Cells.x + 1;
    return { south[0], south[1], north[0], north[1] };
  }
  glm::vec2 SlotBounds(glm::ivec2 cell, int level, int slot) const
  {
    if (level > this->Top())
    {
      const int tileLevel = this->Pages.GetLayout().TileLevel;
      const int column = TileTailColumn(tileLevel, level - this->Top()) + cell.x;
      const PyramidNode<float>& node = this->Tail[static_cast<std::size_t>(column) +
        (static_cast<std::size_t>(cell.y) << tileLevel)];
      return { node.Maximum, node.Minimum };
    }
    const Tile& tile = *this->Slots[static_cast<std::size_t>(slot)];
    const glm::ivec2 at = this->InTile(cell);
    const PyramidNode<float>& node = tile.Nodes[static_cast<std::size_t>(at.x) +
      static_cast<std::size_t>(tile.Cells.x) * static_cast<std::size_t>(at.y)];
    return { node.Maximum, node.Minimum };
  }
  int FinestSlot(glm::ivec2 cell, int& level) const
  {
    int slot = this->TileSlot(cell >> level, level);
    while (slot < 0 && level < this->Top())
    {
      ++level;
      slot = this->TileSlot(cell >> level, level);
    }
    return slot;
  }
  glm::vec4 TileCellCodes(glm::ivec2 cell) const;
  float TileHeight(glm::ivec2 cell, glm::vec2 position, int level, glm::ivec2 size) const;
  ///@}

private:
  /// Place of a cell in its tile.
  glm::ivec2 InTile(glm::ivec2 cell) const
  {
    return cell & ((1 << this->Pages.GetLayout().TileLevel) - 1);
  }
  /// Code of a patch at a position in it; negative where a corner has no height.
  static float SlotHeight(const glm::vec4& codes, const glm::vec2& fraction)
  {
    const bool valid = glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0F)));
    return valid ? PatchCode(codes, fraction) : -1.0F;
  }

  TilePages Pages;
  std::vector<std::shared_ptr<const Tile>> Slots;
  std::vector<PyramidNode<float>> Tail;
};

inline glm::vec4 TileSlots::TileCellCodes(glm::ivec2 cell) const
{
  int level = 0;
  const int slot = this->FinestSlot(cell, level);
  const glm::vec4 codes = slot < 0 ? glm::vec4(-1.0F) : this->SlotCodes(cell >> level, slot);
  if (level == 0)
  {
    return codes;
  }
  const float width = 1.0F / static_cast<float>(1 << level);
  const glm::vec2 low = glm::vec2(cell & ((1 << level) - 1)) * width;
  const glm::vec2 high = low + width;
  return { SlotHeight(codes, low), SlotHeight(codes, { high.x, low.y }),
    SlotHeight(codes, { low.x, high.y }), SlotHeight(codes, high) };
}

inline float TileSlots::TileHeight(
  glm::ivec2 cell, glm::vec2 position, int level, glm::ivec2 size) const
{
  const glm::ivec2 at =
    glm::clamp(cell + glm::ivec2(glm::floor(position)), glm::ivec2(0), size - 2);
  const int slot = this->FinestSlot(at, level);
  const glm::ivec2 first = (at >> level) << level;
  const glm::vec2 fraction =
    glm::clamp((position - glm::vec2(first - cell)) / static_cast<float>(1 << level), 0.0F, 1.0F);
  return slot < 0 ? -1.0F : SlotHeight(this->SlotCodes(at >> level, slot), fraction);
}
}

#endif
