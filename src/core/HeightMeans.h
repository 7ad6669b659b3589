// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Means of height codes over squares of samples, as the mip levels of a texture: for the slope of
 * the surface where a pixel covers many cells. The gradient of the mean is the mean of the
 * gradient, so distant ridges are shaded as what they are on average, and do not shimmer.
 *
 * Mip level k of the texture averages about 2^(kFirstMeanLevel + k) samples a side. Its size is
 * max(1, floor(S / 2^(kFirstMeanLevel + k))) for S samples, and texel i covers the samples from
 * i S / size to (i + 1) S / size, as OpenGL samples textures of any size. A texel is the mean of
 * the samples that have heights over the largest code, in 16 bits, 65535 being 1; where no sample
 * has a height it is that of the level above. Memory: 2 bytes for every 48 samples, and 8 for every
 * 64 that are kept to bring parts up to date.
 */
#ifndef terrain_HeightMeans_h
#define terrain_HeightMeans_h

#include "core/HeightCodes.h"
#include "core/Heightfield.h"
#include "core/MinMaxPyramid.h"
#include "core/ParallelFor.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace terrain
{
/// Base 2 logarithm of the samples along a side of a texel of the first level. Below, differences
/// of the samples themselves are as good; above, memory hardly grows.
constexpr int kFirstMeanLevel = 3;

/// One mip level, row by row.
struct MeanLevel
{
  glm::ivec2 Size{ 0, 0 };
  std::vector<std::uint16_t> Texels;
};

class HeightMeans
{
public:
  /// Builds all levels of a view of texels (HeightCodes.h), down to one texel; none of fewer than
  /// 2 x 2 samples or without heights. T: std::uint16_t or float.
  template <typename T>
  void Build(
    const HeightfieldView<T>& view, const HeightCodes& codes, const ParallelFor& parallelFor);

  /// The same after the samples of a rectangle have changed; reads no others but those beside it.
  template <typename T>
  void Update(const HeightfieldView<T>& view, const HeightCodes& codes,
    const GridRectangle& samples, const ParallelFor& parallelFor);

  const std::vector<MeanLevel>& GetLevels() const
  {
    return this->Levels;
  }

  /// Sum of the codes below a texel and their number.
  struct Sum
  {
    float Codes = 0.0f;
    float Count = 0.0f;
  };

private:
  void MakeLevels(const HeightCodes& codes);

  /// Of the first level.
  glm::ivec2 Size{ 0, 0 };
  std::vector<Sum> Sums;
  std::vector<MeanLevel> Levels;
};
}

#endif
