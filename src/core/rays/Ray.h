// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays and hits as the shaders know them (shaders/vtkTerrainRay.glsl says the same in GLSL).
 */
#ifndef terrain_Ray_h
#define terrain_Ray_h

#include <glm/glm.hpp>

#include <algorithm>

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

/// Narrows begin..end to where a coordinate is between low and high; false if that is nowhere.
inline bool ClipToRange(
  double origin, double direction, double low, double high, double& begin, double& end)
{
  if (direction == 0.0)
  {
    return origin >= low && origin <= high;
  }
  const double atLow = (low - origin) / direction;
  const double atHigh = (high - origin) / direction;
  begin = std::max(begin, std::min(atLow, atHigh));
  end = std::min(end, std::max(atLow, atHigh));
  return begin <= end;
}
}

#endif
