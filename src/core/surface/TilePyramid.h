// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All levels of tiles (TileSource.h) in one pass over the samples, with bounded memory.
 */
#ifndef terrain_TilePyramid_h
#define terrain_TilePyramid_h

#include "core/grid/ParallelFor.h"
#include "core/surface/TileReduction.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace terrain
{
/// Takes the rows of a heightfield from the south and hands out rows of tiles of all levels.
///
/// Memory: the rows that were added last, and of each coarser level the rows of one row of tiles:
/// about 14 bytes x width x the rows of a tile for 16-bit heights.
template <typename T>
class TilePyramid
{
public:
  /// Samples and bounds that hold a whole row of tiles of a level; for level 0 without bounds.
  using TakeRow = std::function<void(int level, std::int64_t tileRow,
    const LevelPlane<const T>& samples, const LevelPlane<const PyramidNode<T>>& nodes)>;

  /// Hands out levels from `firstLevel` on.
  TilePyramid(const TileLayout& layout, int firstLevel, TakeRow take, ParallelFor parallelFor);

  /// Room for the next rows of level 0, row by row; at most those that are left.
  T* AddRows(std::int64_t count);
  /// Builds what the rows that were added make possible.
  void Build();

private:
  /// The rows of a level that are still needed.
  struct Level
  {
    glm::i64vec2 Cells{ 0, 0 };
    std::vector<T> Samples;
    std::vector<PyramidNode<T>> Nodes;
    std::int64_t FirstSampleRow = 0;
    std::int64_t EndSampleRow = 0;
    std::int64_t FirstNodeRow = 0;
    std::int64_t EndNodeRow = 0;
    std::int64_t TileRows = 0; // handed out

    LevelPlane<const T> SamplePlane() const
    {
      return { this->Samples.data(), { 0, this->FirstSampleRow },
        { this->Cells.x + 1, this->EndSampleRow - this->FirstSampleRow } };
    }
    LevelPlane<const PyramidNode<T>> NodePlane() const
    {
      return { this->Nodes.data(), { 0, this->FirstNodeRow },
        { this->Cells.x, this->EndNodeRow - this->FirstNodeRow } };
    }
  };

  void BuildNodes(int level);
  void BuildSamples(int level);
  void HandOut(int level);
  void Trim(int level);

  TileLayout Layout;
  int FirstLevel;
  TakeRow Take;
  ParallelFor For;
  std::vector<Level> Levels;
};
}

#endif
