// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where tiles of heights come from: heightfields that are too large to be held as a whole.
 *
 * A heightfield of W x H samples has levels; level 0 is the heightfield itself. Level k has cells
 * of 2^k x 2^k cells of level 0, counted from the south-west: cell (i, j) of level k is node (i, j)
 * of level k of the min-max pyramid (MinMaxPyramid.h). A level has ceil((W - 1) / 2^k) cells east
 * and one sample more. Sample (i, j) of level k lies at sample (i * 2^k, j * 2^k) of level 0. The
 * last column and row may lie beyond the heightfield's edge; no ray comes there.
 *
 *   samples  level 0: the heights. Level k: for looks, the average of level k - 1 with the weights
 *            1 2 1 in both directions, clamped to the bounds of the cells around. So the bilinear
 *            patch of every cell of every level lies within the cell's bounds.
 *   bounds   of a cell of level k: highest and lowest sample of the cells of level 0 in it that
 *            have a surface. They are made of all samples, so they are true for level 0.
 *
 * Heights are codes (HeightCodes.h), with the same offset and scale in all tiles of all levels:
 * both sides of a line between tiles then see the same float height, and the traversal stays
 * watertight. A tile holds the samples of its border, too: neighbours share them.
 */
#ifndef terrain_TileSource_h
#define terrain_TileSource_h

#include "core/grid/HeightCodes.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace terrain
{
/// A tile of a level; column from the west, row from the south, both from 0.
struct TileKey
{
  int Level = 0;
  std::int64_t Column = 0;
  std::int64_t Row = 0;

  bool operator==(const TileKey& other) const
  {
    return this->Level == other.Level && this->Column == other.Column && this->Row == other.Row;
  }
  bool operator<(const TileKey& other) const
  {
    return std::tie(this->Level, this->Row, this->Column) <
      std::tie(other.Level, other.Row, other.Column);
  }
  /// The tile of the next coarser level that covers this one.
  TileKey Parent() const
  {
    return { this->Level + 1, this->Column / 2, this->Row / 2 };
  }
};

/// How a heightfield is divided into levels and tiles.
struct TileLayout
{
  /// Samples of level 0.
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  /// log2 of the cells along a side of a tile.
  int TileLevel = 8;

  std::int64_t TileCells() const
  {
    return std::int64_t{ 1 } << this->TileLevel;
  }
  /// Cells of a level; 0, 0 if the heightfield has none.
  glm::i64vec2 Cells(int level) const
  {
    if (this->Width < 2 || this->Height < 2)
    {
      return { 0, 0 };
    }
    const std::int64_t last = (std::int64_t{ 1 } << level) - 1;
    return { (this->Width - 1 + last) >> level, (this->Height - 1 + last) >> level };
  }
  /// Samples of a level.
  glm::i64vec2 Samples(int level) const
  {
    return this->Cells(level) + std::int64_t{ 1 };
  }
  /// Tiles of a level.
  glm::i64vec2 Tiles(int level) const
  {
    return this->Cells(level + this->TileLevel);
  }
  /// Levels, of which the last has one tile; 0 if the heightfield has no cells.
  int LevelCount() const
  {
    int count = this->Cells(0).x > 0 ? 1 : 0;
    while (count > 0 && this->Tiles(count - 1) != glm::i64vec2(1))
    {
      ++count;
    }
    return count;
  }
  bool Contains(const TileKey& key) const
  {
    return key.Level >= 0 && key.Level < this->LevelCount() && key.Column >= 0 && key.Row >= 0 &&
      key.Column < this->Tiles(key.Level).x && key.Row < this->Tiles(key.Level).y;
  }
  /// First cell of a tile, and how many it has: fewer at the east and north edges.
  glm::i64vec2 FirstCell(const TileKey& key) const
  {
    return glm::i64vec2(key.Column, key.Row) * this->TileCells();
  }
  glm::i64vec2 CellCount(const TileKey& key) const
  {
    return glm::min(this->Cells(key.Level) - this->FirstCell(key), glm::i64vec2(this->TileCells()));
  }
  bool operator==(const TileLayout& other) const
  {
    return this->Width == other.Width && this->Height == other.Height &&
      this->TileLevel == other.TileLevel;
  }
};

/// The heights of a tile, in codes.
struct Tile
{
  /// Cells east and north.
  glm::ivec2 Cells{ 0, 0 };
  /// (Cells.x + 1) x (Cells.y + 1) samples, row by row from the south; kNoDataCode where there is
  /// no height.
  std::vector<float> Samples;
  /// Bounds of the cells, Cells.x x Cells.y; empty for level 0, whose cells have their samples.
  std::vector<PyramidNode<float>> Nodes;
  /// The greatest range of heights in one of the cells; 0 for level 0.
  float Relief = 0.0F;

  std::size_t MemorySize() const
  {
    return this->Samples.size() * sizeof(float) + this->Nodes.size() * sizeof(PyramidNode<float>);
  }
};

/// A heightfield by tiles. All methods may be called by several threads at once.
class TileSource
{
public:
  TileSource() = default;
  virtual ~TileSource() = default;
  TileSource(const TileSource&) = delete;
  TileSource& operator=(const TileSource&) = delete;

  virtual TileLayout GetLayout() const = 0;
  /// Of all tiles.
  virtual HeightCodes GetCodes() const = 0;
  /// True if bounds are made of all samples; false if they are guessed, from overviews for example.
  virtual bool AreBoundsTrue() const = 0;
  /// Bounds of the surface in a tile, in codes, without reading its samples.
  virtual PyramidNode<float> GetBounds(const TileKey& key) const = 0;
  /// Reads a tile. Returns an empty string, or one sentence that says why the tile cannot be read.
  virtual std::string Read(const TileKey& key, Tile& tile) const = 0;
};
}

#endif
