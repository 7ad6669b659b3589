// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays and hits as the shaders know them (shaders/vtkTerrainRay.glsl says the same in GLSL), and
 * the heights that their C++ twins read in place of textures.
 */
#ifndef terrain_Ray_h
#define terrain_Ray_h

#include "core/grid/HeightCodes.h"

#include <glm/glm.hpp>

namespace terrain
{
/**
 * A ray in grid coordinates, parametrized by the distance s along the viewing direction from its
 * origin (world units; VTK's view coordinates have z = -distance). The origin is stored relative to
 * the south-west corner of a cell near it: float then resolves 1e-7 of a cell near the hit, however
 * large the grid and far the eye.
 */
struct TerrainRay
{
  /// Cell whose south-west sample is the local origin; may lie outside the grid.
  glm::ivec2 anchorCell{ 0, 0 };
  /// Position at s = 0: x, y in cells relative to anchorCell; z in height codes.
  glm::vec3 originGC{ 0.0f, 0.0f, 0.0f };
  /// Change per unit of s: cells, cells, height codes.
  glm::vec3 directionGC{ 0.0f, 0.0f, 0.0f };
  /// Searched are distances sBegin <= s <= sEnd.
  float sBegin = 0.0f;
  float sEnd = 0.0f;
  /// What float cuts off originGC.z, in height codes: the height above the ground beside the eye
  /// needs it. May be left 0.
  float originLow = 0.0f;
};

/// Where a ray meets the surface.
struct TerrainHit
{
  bool found = false;
  /// Distance from the ray's origin, see TerrainRay.
  float s = 0.0f;
  /// The cell that was hit and the position within it, 0 <= fraction <= 1.
  glm::ivec2 cell{ 0, 0 };
  glm::vec2 fraction{ 0.0f, 0.0f };
  /// Work done: nodes visited by the pyramid's traversal, samples taken by the searches.
  int crossings = 0;
};

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

  /// As in terrainTexelCode(): code of a sample, NoDataCode (or any negative) if it has none.
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
}

#endif
