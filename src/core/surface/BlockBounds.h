// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A small min-max pyramid for queries on the CPU. Its finest level has one node for 8 x 8 cells, so
 * that it takes a hundredth of the samples' memory in each direction of bounds. The pyramid that
 * graphics cards read is another one: core/surface/MinMaxPyramid.h.
 */
#ifndef terrain_BlockBounds_h
#define terrain_BlockBounds_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace terrain
{
/// Lowest and highest sample of the cells of a node that have a surface; Low > High if none has.
template <typename T>
struct BlockNode
{
  T Low = std::numeric_limits<T>::max();
  T High = std::numeric_limits<T>::lowest();

  bool IsEmpty() const
  {
    return this->Low > this->High;
  }
  void Add(const BlockNode& other)
  {
    this->Low = std::min(this->Low, other.Low);
    this->High = std::max(this->High, other.High);
  }
};

/// Node (x, y) of level k bounds the bilinear surface over the cells x 2^k <= i < (x + 1) 2^k, y
/// likewise. The bounds are exact: they are samples. Levels run from FirstLevel to LastLevel(), of
/// which the last is one node.
template <typename T>
class BlockBounds
{
public:
  static constexpr int FirstLevel = 3;

  /// Reads every sample once, in parallel. A grid of less than 2 x 2 samples has no level.
  void Build(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
  {
    this->Levels.clear();
    if (view.Width < 2 || view.Height < 2)
    {
      return;
    }
    this->BuildFirstLevel(view, parallelFor);
    while (this->Levels.back().Nodes.size() > 1)
    {
      this->BuildNextLevel();
    }
  }

  /// FirstLevel - 1 if there is none.
  int LastLevel() const
  {
    return FirstLevel + static_cast<int>(this->Levels.size()) - 1;
  }
  /// FirstLevel <= level <= LastLevel(); 0 <= node < ceil(cells / 2^level).
  const BlockNode<T>& At(const glm::i64vec2& node, int level) const
  {
    const Level& stored = this->Levels[static_cast<std::size_t>(level - FirstLevel)];
    return stored.Nodes[static_cast<std::size_t>(node.x + stored.Size.x * node.y)];
  }
  std::size_t MemorySize() const
  {
    std::size_t nodes = 0;
    for (const Level& level : this->Levels)
    {
      nodes += level.Nodes.size();
    }
    return nodes * sizeof(BlockNode<T>);
  }

private:
  struct Level
  {
    glm::i64vec2 Size{ 0, 0 };
    std::vector<BlockNode<T>> Nodes;

    explicit Level(const glm::i64vec2& size)
      : Size(size)
      , Nodes(static_cast<std::size_t>(size.x * size.y))
    {
    }
  };

  static BlockNode<T> BoundCell(const HeightfieldView<T>& view, std::int64_t x, std::int64_t y)
  {
    BlockNode<T> node;
    if (view.IsCellValid(x, y))
    {
      const T* south = view.Samples + view.Index(x, y);
      const T* north = south + view.RowStep();
      node.Low = std::min(std::min(south[0], south[1]), std::min(north[0], north[1]));
      node.High = std::max(std::max(south[0], south[1]), std::max(north[0], north[1]));
    }
    return node;
  }

  void BuildFirstLevel(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
  {
    const glm::i64vec2 cells(view.Width - 1, view.Height - 1);
    constexpr std::int64_t block = std::int64_t{ 1 } << FirstLevel;
    this->Levels.emplace_back((cells + block - std::int64_t{ 1 }) / block);
    Level& level = this->Levels.back();
    parallelFor(level.Size.y,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t y = begin * block; y < std::min(end * block, cells.y); ++y)
        {
          for (std::int64_t x = 0; x < cells.x; ++x)
          {
            const std::int64_t node = x / block + level.Size.x * (y / block);
            level.Nodes[static_cast<std::size_t>(node)].Add(BoundCell(view, x, y));
          }
        }
      });
  }

  void BuildNextLevel()
  {
    const Level& below = this->Levels.back();
    Level level((below.Size + std::int64_t{ 1 }) / std::int64_t{ 2 });
    for (std::int64_t y = 0; y < below.Size.y; ++y)
    {
      for (std::int64_t x = 0; x < below.Size.x; ++x)
      {
        level.Nodes[static_cast<std::size_t>(x / 2 + level.Size.x * (y / 2))].Add(
          below.Nodes[static_cast<std::size_t>(x + below.Size.x * y)]);
      }
    }
    this->Levels.push_back(std::move(level));
  }

  std::vector<Level> Levels;
};
}

#endif
