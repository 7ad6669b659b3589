// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles of a raster whose coarse levels are in a file (TileFile.h): finer levels are made of the
 * raster's samples when they are read.
 */
#ifndef terrain_PreparedTiles_h
#define terrain_PreparedTiles_h

#include "core/surface/TileFile.h"

#include <functional>
#include <memory>
#include <vector>

namespace terrain
{
/// Reads samples [first, first + size) of level 0 row by row from the south; called by several
/// threads at once. Returns an error message, empty if all is well.
template <typename T>
using ReadTileSamples =
  std::function<std::string(glm::i64vec2 first, glm::i64vec2 size, T* samples)>;

/// T is the type of the file. Memory: the bounds of all tiles, 4 to 8 bytes for 256 x 256 samples.
template <typename T>
class PreparedTiles : public TileSource
{
public:
  /// Takes an open file over and reads the bounds of all tiles. Returns an error message, empty if
  /// all is well.
  std::string Open(std::unique_ptr<TileFile> file, ReadTileSamples<T> read);

  TileLayout GetLayout() const override
  {
    return this->File->GetContent().Layout;
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
  /// A tile as it is stored: samples, and from level 1 on the nodes of its cells.
  std::string ReadStored(
    const TileKey& key, std::vector<T>& samples, std::vector<PyramidNode<T>>& nodes) const;

private:
  /// First <= position < End in both directions.
  struct Rectangle
  {
    glm::i64vec2 First{ 0, 0 };
    glm::i64vec2 End{ 0, 0 };
  };
  /// A part of a level.
  struct Window
  {
    std::vector<T> Samples;
    std::vector<PyramidNode<T>> Nodes;
    LevelPlane<const T> SamplePlane;
    LevelPlane<const PyramidNode<T>> NodePlane;
  };

  std::string ReadBounds();
  std::string MakeWindow(
    int level, const Rectangle& samples, const Rectangle& cells, Window& window) const;

  std::unique_ptr<TileFile> File;
  ReadTileSamples<T> ReadSamples;
  HeightCodes Codes;
  /// Bounds of the cells of levels from BoundsLevel up, one for each tile of levels from
  /// BoundsLevel - TileLevel up.
  int BoundsLevel = 0;
  std::vector<std::vector<PyramidNode<T>>> Bounds;
};
}

#endif
