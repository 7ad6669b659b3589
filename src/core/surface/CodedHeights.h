// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights as the texels that shaders read (shaders/vtkTerrainHeights.glsl says the same in GLSL),
 * and the bilinear patch between the codes of a cell's corners.
 */
#ifndef terrain_CodedHeights_h
#define terrain_CodedHeights_h

#include "core/grid/HeightCodes.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace terrain
{
/// Height code of the bilinear patch of a cell at 0 <= fraction <= 1; codes:
/// CodedHeights::CellCodes.
inline float PatchCode(const glm::vec4& codes, const glm::vec2& fraction)
{
  const float south = codes.x * (1.0f - fraction.x) + codes.y * fraction.x;
  const float north = codes.z * (1.0f - fraction.x) + codes.w * fraction.x;
  return south * (1.0f - fraction.y) + north * fraction.y;
}

/// Change of the code per cell east and north at a position in a cell, 0 <= fraction <= 1, from the
/// codes of its corners (CodedHeights::CellCodes).
inline glm::vec2 PatchGradient(const glm::vec4& codes, const glm::vec2& fraction)
{
  return { glm::mix(codes.y - codes.x, codes.w - codes.z, fraction.y),
    glm::mix(codes.z - codes.x, codes.w - codes.y, fraction.x) };
}

/// Codes of a heightfield in memory, with the functions of shaders/vtkTerrainHeights.glsl.
template <typename Texel>
struct CodedHeights
{
  const Texel* texels = nullptr;
  glm::ivec2 size{ 0, 0 };
  int bias = 0;
  float maximumCode = 0.0f;

  /// As in terrainTexelCode(): code of a sample, kNoDataCode (or any negative) if it has none.
  float Code(glm::ivec2 sample) const
  {
    return static_cast<float>(
             this->texels[sample.x + static_cast<std::int64_t>(this->size.x) * sample.y]) -
      static_cast<float>(this->bias);
  }

  /// Twin of terrainCellCodes(): south-west, south-east, north-west, north-east.
  glm::vec4 CellCodes(glm::ivec2 cell) const
  {
    return { this->Code(cell), this->Code(cell + glm::ivec2(1, 0)),
      this->Code(cell + glm::ivec2(0, 1)), this->Code(cell + glm::ivec2(1, 1)) };
  }
};

/// The heights and the pyramid that rays are traced through, by their texels.
template <typename Texel>
struct CodedTypes
{
  using Heights = CodedHeights<Texel>;
  using Pyramid = MinMaxPyramid<Texel>;
};
}

#endif
