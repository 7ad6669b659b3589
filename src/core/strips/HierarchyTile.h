// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * First pass of the preprocess (HierarchyBuild.h): exact errors of the triangles in a tile.
 */
#ifndef terrain_HierarchyTile_h
#define terrain_HierarchyTile_h

#include <cstdint>
#include <vector>

namespace terrain
{
/// Errors of the vertices of one tile, and the heights they are computed from.
class HierarchyTile
{
public:
  /// Largest side of a tile, in cells.
  static constexpr int MaximumSide = 64;
  /// Bits of a float that is no error: the vertex must be bounded by its children.
  static constexpr std::int32_t Unknown = 0x7f800000;

  /// A tile of side x side cells, side a power of two, 2 <= side <= MaximumSide.
  explicit HierarchyTile(int side);

  int Side() const
  {
    return this->TileSide;
  }
  /// Height at local (x, y), -1 <= x, y <= side + 1, NaN where there is none.
  float& HeightAt(int x, int y)
  {
    return this->Heights[(y + 1) * this->Pitch + x + 1];
  }
  float HeightAt(int x, int y) const
  {
    return this->Heights[(y + 1) * this->Pitch + x + 1];
  }
  /// Bits of the error of the vertex at local (x, y), 0 <= x, y <= side, over those triangles of
  /// its diamond that lie in this tile; bits of floats >= 0 compare like the floats.
  std::int32_t ErrorAt(int x, int y) const
  {
    return this->Errors[y * (this->TileSide + 1) + x];
  }

  /// Computes the errors of all vertices whose diamond lies in squares of the tile. Local cells
  /// x < cellsX and y < cellsY are in the raster, the others beyond it. The diagonal of the whole
  /// tile rises to the east, or falls: HierarchyLayout::DiamondDirection.
  void ComputeErrors(std::int64_t cellsX, std::int64_t cellsY, bool rising);

private:
  struct Square;
  void Diagonal(const Square& square, bool rising);
  void Sides(const Square& square);
  static std::int32_t Spoke(const Square& square, int x, int y, int dx, int dy);
  void Merge(int x, int y, std::int32_t error);

  int TileSide;
  int Pitch;
  std::vector<float> Heights;
  std::vector<std::int32_t> Errors;
};
}

#endif
