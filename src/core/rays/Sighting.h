// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the ray of a pixel sees first, as a texel of the texture between the compute shader that
 * casts rays and the shader that draws: twin of shaders/vtkTerrainSighting.glsl.
 */
#ifndef terrain_Sighting_h
#define terrain_Sighting_h

#include <glm/glm.hpp>

#include <cmath>

namespace terrain
{
/// The first point of the surface on a pixel's ray.
struct Sighting
{
  bool found = false;
  float distanceVC = -1.0f; ///< along the viewing direction
  glm::ivec2 cell{ 0, 0 };
  glm::vec2 fraction{ 0.0f, 0.0f }; ///< position in the cell, 0..1
  bool front = true;                ///< seen from above
  int crossings = 0;                ///< work done, see TerrainHit
  int wall = -1;                    ///< clipping plane at which a block is cut, or -1: the surface
};

/// A texel: x the distance, < 0 for none; yz the position in cells;
/// w = +-(work + 1 + (wall + 1) / 32), minus where the back is seen. Walls: below 31.
inline glm::vec4 PackSighting(const Sighting& sighting)
{
  float work = static_cast<float>(sighting.crossings + 1);
  if (!sighting.found)
  {
    return { -1.0f, 0.0f, 0.0f, work };
  }
  work += static_cast<float>(sighting.wall + 1) / 32.0f;
  return { sighting.distanceVC, glm::vec2(sighting.cell) + sighting.fraction,
    sighting.front ? work : -work };
}

/// The work of a texel's ray, whether it met the surface or not.
inline int UnpackCrossings(const glm::vec4& texel)
{
  return static_cast<int>(std::abs(texel.w)) - 1;
}

/// The sighting of a texel, over a grid of size samples.
inline Sighting UnpackSighting(const glm::vec4& texel, glm::ivec2 size)
{
  const glm::vec2 position(texel.y, texel.z);
  const glm::ivec2 cell = glm::clamp(glm::ivec2(position), glm::ivec2(0), size - 2);
  return { texel.x >= 0.0f, texel.x, cell, position - glm::vec2(cell), texel.w > 0.0f,
    UnpackCrossings(texel), static_cast<int>(32.0f * glm::fract(std::abs(texel.w))) - 1 };
}
}

#endif
