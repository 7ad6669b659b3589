// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles of a heightfield in memory, all levels of which are kept.
 */
#ifndef terrain_MemoryTiles_h
#define terrain_MemoryTiles_h

#include "core/grid/ParallelFor.h"
#include "core/surface/TileReduction.h"

#include <memory>
#include <vector>

namespace terrain
{
/// Memory: 2.3 times the samples as short or unsigned short (integers of up to 16 bits), or as
/// float (all others).
template <typename T>
class MemoryTiles : public TileSource
{
public:
  /// Copies the samples: row by row from the south, NoStoredHeight<T>() where there is none.
  MemoryTiles(const T* samples, const TileLayout& layout, const ParallelFor& parallelFor);

  TileLayout GetLayout() const override
  {
    return this->Layout;
  }
  HeightCodes GetCodes() const override
  {
    return this->Codes;
  }
  bool AreBoundsTrue() const override
  {
    return true;
  }
  PyramidNode<float> GetBounds(const TileKey& key) const override;
  std::string Read(const TileKey& key, Tile& tile) const override;

private:
  struct Level
  {
    glm::i64vec2 Cells{ 0, 0 };
    std::vector<T> Samples;
    std::vector<PyramidNode<T>> Nodes;

    LevelPlane<const T> SamplePlane() const
    {
      return { this->Samples.data(), { 0, 0 }, this->Cells + std::int64_t{ 1 } };
    }
    LevelPlane<const PyramidNode<T>> NodePlane() const
    {
      return { this->Nodes.data(), { 0, 0 }, this->Cells };
    }
  };

  TileLayout Layout;
  HeightCodes Codes;
  std::vector<Level> Levels; // up to the one whose nodes are tiles of the top level
};

/// Tiles of samples of any type; those that are no short or unsigned short are kept as float.
template <typename T>
std::unique_ptr<TileSource> MakeMemoryTiles(
  const HeightfieldView<T>& view, int tileLevel, const ParallelFor& parallelFor);
}

#endif
