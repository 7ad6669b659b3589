// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * First pass of the preprocess (HierarchyBuild.h): streams the raster from north to south, band by
 * band, and writes heights, gradients, own errors and the whole finest depth.
 */
#ifndef terrain_HierarchyBands_h
#define terrain_HierarchyBands_h

#include "core/strips/HierarchyTarget.h"
#include "core/strips/HierarchyTile.h"

#include <vector>

namespace terrain
{
struct DiamondState;

/// Streams the raster once. Run() does it; the target then lacks only the nesting.
class HierarchyBands
{
public:
  HierarchyBands(HierarchyTarget& target, const HeightRows& rows, const ParallelFor& parallelFor);

  /// Number of bands, and their work, from band Count() - 1 down to 0. Returns an error message.
  std::int64_t Count() const
  {
    return this->BandCount;
  }
  std::string Process(std::int64_t band);
  /// Writes the coarsest vertices; after all bands.
  void Finish();

private:
  struct Tile
  {
    explicit Tile(int side)
      : Errors(side)
      , NorthErrors(static_cast<std::size_t>(side) + 1)
    {
    }
    HierarchyTile Errors;
    /// Errors of the northern row's vertices from the band before.
    std::vector<std::int32_t> NorthErrors;
    /// Stands for heights that are missing.
    float Filling = 0.0f;
    float Minimum = 0.0f;
    float Maximum = 0.0f;
    bool HasNoData = false;
    bool HasData = false;
  };
  struct Leaf;

  std::string LoadRows(std::int64_t band);
  void PrepareTile(std::int64_t band, std::int64_t column);
  void KeepLattice(std::int64_t band);
  void WriteTile(std::int64_t band, std::int64_t column);
  void WriteVertex(std::int64_t band, std::int64_t column, int x, int y);
  void WriteLeaf(HierarchyRecord& record, const Tile& tile, int x, int y, glm::i64vec2 position,
    std::int32_t errorBits);
  float LeafError(const HierarchyRecord& record, const Tile& tile, const glm::ivec2& at,
    const glm::i64vec2& position, const DiamondState& state, float peak, float error) const;
  float SampleAt(std::int64_t x, std::int64_t y) const
  {
    return this->Rows[(y - this->LowRow) * this->Layout.Width() + x];
  }
  HierarchyGradient GradientAt(std::int64_t x, std::int64_t y) const;
  std::int64_t LatticeIndex(std::int64_t x, std::int64_t y) const;

  HierarchyTarget& Target;
  const HierarchyLayout& Layout;
  const HeightRows& Source;
  const ParallelFor& Parallel;
  int Side;
  std::int64_t BandCount = 0;
  std::vector<Tile> Tiles;
  /// Rows [LowRow, LowRow + n) of the raster.
  std::vector<float> Rows;
  std::int64_t LowRow;
  /// Heights at the corners of the tiles, and the slopes there.
  std::int64_t LatticeColumns;
  std::vector<float> Lattice;
  std::vector<HierarchyGradient> LatticeGradients;
};
}

#endif
