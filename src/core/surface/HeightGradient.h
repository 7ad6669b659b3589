// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Slopes of a heightfield as shaders see them. Twin of the part of shaders/vtkTerrainGradient.glsl
 * that reads samples (there with the prefix terrain).
 */
#ifndef terrain_HeightGradient_h
#define terrain_HeightGradient_h

#include "core/surface/CodedHeights.h"

#include <glm/glm.hpp>

namespace terrain
{
/// Code of the surface at a position relative to a cell; negative where there is none. Positions
/// beside the grid continue the patch at its border. Heights: with the functions of CodedHeights.
template <typename Heights>
float TexelHeight(const Heights& heights, glm::ivec2 cell, glm::vec2 position)
{
  const glm::ivec2 at =
    glm::clamp(cell + glm::ivec2(glm::floor(position)), glm::ivec2(0), heights.size - 2);
  const glm::vec4 codes = heights.CellCodes(at);
  return glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0f)))
    ? PatchCode(codes, position - glm::vec2(at - cell))
    : kNoDataCode;
}

/// Gradient at a position in a cell, in codes per cell, as the central difference over a width in
/// cells: the mean slope along it. Continuous away from holes, and for a width of 1 the gradient of
/// the patch at the centre of a cell. The difference ends at the border, and at the position where
/// there are no heights; without any it is the patch's own. Codes: of the cell's corners.
template <typename Heights>
glm::vec2 WideGradient(
  const Heights& heights, glm::ivec2 cell, glm::vec2 fraction, const glm::vec4& codes, float width)
{
  const float here = PatchCode(codes, fraction);
  glm::vec2 gradient = PatchGradient(codes, fraction);
  for (int axis = 0; axis < 2; ++axis)
  {
    glm::vec2 low = fraction;
    glm::vec2 high = fraction;
    low[axis] = std::max(fraction[axis] - 0.5f * width, static_cast<float>(-cell[axis]));
    high[axis] = std::min(
      fraction[axis] + 0.5f * width, static_cast<float>(heights.size[axis] - 1 - cell[axis]));
    const float atLow = TexelHeight(heights, cell, low);
    const float atHigh = TexelHeight(heights, cell, high);
    if (atLow >= 0.0f || atHigh >= 0.0f)
    {
      const float begin = atLow < 0.0f ? fraction[axis] : low[axis];
      const float end = atHigh < 0.0f ? fraction[axis] : high[axis];
      gradient[axis] = ((atHigh < 0.0f ? here : atHigh) - (atLow < 0.0f ? here : atLow)) /
        std::max(end - begin, 1e-3f);
    }
  }
  return gradient;
}
}

#endif
