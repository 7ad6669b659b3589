// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Mean slopes of a heightfield over squares of cells, as the mip levels of a texture: for the light
 * where a pixel covers many cells. Distant ridges are shaded as what they are on average, and do
 * not shimmer.
 *
 * Mip level k of the texture averages about 2^(kFirstSlopeLevel + k) cells a side. Its size is
 * max(1, floor(C / 2^(kFirstSlopeLevel + k))) for C cells, and texel i covers the cells from
 * i C / size to (i + 1) C / size, as OpenGL samples textures of any size: a position in cells over
 * C is one in the texture. A texel holds the change of the code per cell east and north, the mean
 * of the patches of those cells that have a surface, as signed 16-bit parts of the steepest in the
 * first level, 32767 being 1; where no cell has a surface it is that of the level above. Memory: 4
 * bytes for every 192 samples, and 12 for every 256 that are kept to bring parts up to date.
 */
#ifndef terrain_HeightSlopes_h
#define terrain_HeightSlopes_h

#include "core/grid/HeightCodes.h"
#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace terrain
{
/// Base 2 logarithm of the cells along a side of a texel of the first level. Below, differences of
/// the samples themselves are as good; above, memory hardly grows.
constexpr int kFirstSlopeLevel = 4;

/// Samples beside a rectangle that Update() reads, each way at most: less than two texels of the
/// first level.
constexpr int kSlopesReach = 2 << kFirstSlopeLevel;

/// East and north.
using SlopeTexel = glm::i16vec2;

/// One mip level, row by row.
struct SlopeLevel
{
  glm::ivec2 Size{ 0, 0 };
  std::vector<SlopeTexel> Texels;
};

class HeightSlopes
{
public:
  /// Builds all levels of a view of texels (HeightCodes.h), down to one texel; none of fewer than
  /// 2 x 2 samples or without heights. T: std::uint16_t or float.
  template <typename T>
  void Build(
    const HeightfieldView<T>& view, const HeightCodes& codes, const ParallelFor& parallelFor);

  /// The same after the samples of a rectangle have changed; reads no others but those within
  /// kSlopesReach of it.
  template <typename T>
  void Update(
    const HeightfieldView<T>& view, const GridRectangle& samples, const ParallelFor& parallelFor);

  const std::vector<SlopeLevel>& GetLevels() const
  {
    return this->Levels;
  }

  /// Frees the levels, until the next Update() makes them anew.
  void ForgetLevels()
  {
    this->Levels = {};
  }

  /// Codes per cell of a texel of 1.
  double GetScale() const
  {
    return this->Scale;
  }

  /// Sum of the slopes of the cells below a texel, and the number of cells.
  struct Sum
  {
    glm::vec2 Slope{ 0.0f };
    float Count = 0.0f;
  };

private:
  void MakeLevels();

  /// Of the first level.
  glm::ivec2 Size{ 0, 0 };
  std::vector<Sum> Sums;
  std::vector<SlopeLevel> Levels;
  double Scale = 1.0;
};
}

#endif
