// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/LevelSamples.h"

#include <mutex>

namespace terrain
{
namespace
{
/// The rows of a tile that are its own and lie in a rectangle: a border belongs to the tile north
/// and east of it, if there is one.
void TakeTile(const TileLayout& layout, const TileKey& key, const Tile& tile, glm::i64vec2 first,
  glm::i64vec2 size, const TakeCodes& take)
{
  const glm::i64vec2 corner = layout.FirstCell(key);
  const glm::i64vec2 cells(tile.Cells);
  const glm::i64vec2 isLast = glm::i64vec2(glm::equal(corner + cells, layout.Cells(key.Level)));
  const glm::i64vec2 begin = glm::max(corner, first);
  const glm::i64vec2 end = glm::min(corner + cells + isLast, first + size);
  for (std::int64_t y = begin.y; y < end.y && begin.x < end.x; ++y)
  {
    const std::int64_t index = begin.x - corner.x + (cells.x + 1) * (y - corner.y);
    take(begin.x, y, end.x - begin.x, tile.Samples.data() + index);
  }
}
}

//------------------------------------------------------------------------------
std::string ReadLevel(const TileSource& source, int level, glm::i64vec2 first, glm::i64vec2 size,
  const ParallelFor& parallelFor, const std::function<bool(double)>& progress,
  const TakeCodes& take)
{
  const TileLayout layout = source.GetLayout();
  if (size.x < 1 || size.y < 1 || layout.LevelCount() < 1)
  {
    return {};
  }
  const glm::i64vec2 lastTile = layout.Tiles(level) - std::int64_t{ 1 };
  const glm::i64vec2 west = glm::min(first / layout.TileCells(), lastTile);
  const glm::i64vec2 east =
    glm::min((first + size - std::int64_t{ 1 }) / layout.TileCells(), lastTile);
  const glm::i64vec2 tiles = east - west + std::int64_t{ 1 };
  std::mutex mutex;
  std::string error;
  bool goesOn = true;
  std::int64_t done = 0;
  parallelFor(tiles.x * tiles.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      Tile tile;
      for (std::int64_t k = begin; k < end; ++k)
      {
        const TileKey key{ level, west.x + k % tiles.x, west.y + k / tiles.x };
        const std::string failure = source.Read(key, tile);
        if (failure.empty())
        {
          TakeTile(layout, key, tile, first, size, take);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        error = error.empty() ? failure : error;
        ++done;
        goesOn = goesOn && error.empty() &&
          progress(static_cast<double>(done) / static_cast<double>(tiles.x * tiles.y));
        if (!goesOn)
        {
          return;
        }
      }
    });
  return error;
}

//------------------------------------------------------------------------------
int FindLevel(const TileLayout& layout, std::int64_t mostAlongSide, std::int64_t mostSamples)
{
  const int top = layout.LevelCount() - 1;
  for (int level = 0; level < top; ++level)
  {
    const glm::i64vec2 size = layout.Samples(level);
    const bool fits =
      (mostAlongSide <= 0 || (size.x <= mostAlongSide && size.y <= mostAlongSide)) &&
      (mostSamples <= 0 || size.x <= mostSamples / size.y);
    if (fits)
    {
      return level;
    }
  }
  return top;
}
}
