// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Slopes of a heightfield as shaders see them. Twin of shaders/vtkTerrainGradient.glsl (there with
 * the prefix terrain). For tests: nothing is drawn by it.
 */
#ifndef terrain_HeightGradient_h
#define terrain_HeightGradient_h

#include "core/surface/CodedHeights.h"
#include "core/surface/DetailHeights.h"
#include "core/surface/HeightSlopes.h"
#include "core/surface/TileSlots.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

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

/// Mean slope along x and y from low to high, positions on both sides of one in a cell, per unit of
/// the positions; here, atLow and atHigh: codes there, negative where there is no height. A
/// difference ends at the position on a side without height; without any on both sides it is
/// `none`.
inline glm::vec2 Difference(const glm::vec2& position, const glm::vec2& low, const glm::vec2& high,
  float here, const glm::vec2& atLow, const glm::vec2& atHigh, glm::vec2 none)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    if (atLow[axis] >= 0.0f || atHigh[axis] >= 0.0f)
    {
      const float begin = atLow[axis] < 0.0f ? position[axis] : low[axis];
      const float end = atHigh[axis] < 0.0f ? position[axis] : high[axis];
      const float rise =
        (atHigh[axis] < 0.0f ? here : atHigh[axis]) - (atLow[axis] < 0.0f ? here : atLow[axis]);
      none[axis] = rise / std::max(end - begin, 1e-3f);
    }
  }
  return none;
}

/// Gradient at a position in a cell, in codes per cell, as the central difference over a width in
/// cells: the mean slope along it. Continuous away from holes, and for a width of 1 the gradient of
/// the patch at the centre of a cell. The difference ends at the border, and at the position where
/// there are no heights; without any it is the patch's own. Codes: of the cell's corners.
template <typename Heights>
glm::vec2 WideGradient(
  const Heights& heights, glm::ivec2 cell, glm::vec2 fraction, const glm::vec4& codes, float width)
{
  const glm::vec2 low = glm::max(fraction - 0.5f * width, glm::vec2(-cell));
  const glm::vec2 high = glm::min(fraction + 0.5f * width, glm::vec2(heights.size - 1 - cell));
  const auto at = [&](float x, float y) { return TexelHeight(heights, cell, { x, y }); };
  return Difference(fraction, low, high, PatchCode(codes, fraction),
    { at(low.x, fraction.y), at(fraction.x, low.y) },
    { at(high.x, fraction.y), at(fraction.x, high.y) }, PatchGradient(codes, fraction));
}

/// The mean gradient over squares of 2^level cells a side, level >= kFirstSlopeLevel, at a position
/// in cells of a grid of size samples: between texels and levels, as OpenGL samples a texture that
/// ends at its edge.
inline glm::dvec2 MeanGradient(
  const HeightSlopes& slopes, const glm::ivec2& size, const glm::dvec2& position, double level)
{
  const std::vector<SlopeLevel>& levels = slopes.GetLevels();
  const auto in = [&](std::size_t k)
  {
    const SlopeLevel& texels = levels[k];
    const glm::dvec2 at = position / glm::dvec2(size - 1) * glm::dvec2(texels.Size) - 0.5;
    const glm::ivec2 low(glm::floor(at));
    const glm::dvec2 part = at - glm::dvec2(low);
    glm::dvec2 sum(0.0);
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::ivec2 offset(corner & 1, corner >> 1);
      const glm::ivec2 texel = glm::clamp(low + offset, glm::ivec2(0), texels.Size - 1);
      sum += (offset.x == 1 ? part.x : 1.0 - part.x) * (offset.y == 1 ? part.y : 1.0 - part.y) *
        glm::dvec2(texels.Texels[static_cast<std::size_t>(texel.x + texels.Size.x * texel.y)]);
    }
    return slopes.GetScale() / 32767.0 * sum;
  };
  const double last = static_cast<double>(levels.size()) - 1.0;
  const double place = glm::clamp(level - kFirstSlopeLevel, 0.0, last);
  const auto below = static_cast<std::size_t>(place);
  return glm::mix(
    in(below), in(std::min(below + 1, levels.size() - 1)), place - static_cast<double>(below));
}

/// Gradient at a position in a cell over squares of 2^level cells a side; of one cell if level < 0.
/// Codes: of the cell's corners.
template <typename Heights>
glm::vec2 TexelGradient(const Heights& heights, const HeightSlopes& slopes, glm::ivec2 cell,
  glm::vec2 fraction, const glm::vec4& codes, float level)
{
  constexpr auto first = static_cast<float>(kFirstSlopeLevel);
  const float coarse = glm::clamp(level - first + 1.0f, 0.0f, 1.0f);
  glm::vec2 gradient(0.0f);
  if (coarse < 1.0f)
  {
    const float fine = glm::clamp(level, 0.0f, first);
    gradient = WideGradient(heights, cell, fraction, codes, std::exp2(fine));
  }
  if (coarse > 0.0f)
  {
    const glm::vec2 mean(MeanGradient(
      slopes, heights.size, glm::dvec2(cell) + glm::dvec2(fraction), std::max(level, first)));
    gradient = glm::mix(gradient, mean, coarse);
  }
  return gradient;
}

/// The surface of the finest tiles that are there, with the functions of CodedHeights.
struct FinestHeights
{
  const TileSlots* tiles = nullptr;
  glm::ivec2 size{ 0, 0 };

  glm::vec4 CellCodes(glm::ivec2 cell) const
  {
    return this->tiles->TileCellCodes(cell);
  }
};

/// The same in tiles, of the level that has cells of that size.
inline glm::vec2 TexelGradient(const FinestHeights& heights, glm::ivec2 cell, glm::vec2 fraction,
  const glm::vec4& codes, float level)
{
  if (level < 1.0f)
  {
    return WideGradient(heights, cell, fraction, codes, std::exp2(std::max(level, 0.0f)));
  }
  const int from = std::min(static_cast<int>(level), heights.tiles->Top());
  const float width = std::exp2(level);
  const glm::vec2 low = glm::max(fraction - 0.5f * width, glm::vec2(-cell));
  const glm::vec2 high = glm::min(fraction + 0.5f * width, glm::vec2(heights.size - 1 - cell));
  const auto at = [&](float x, float y) {
    return heights.tiles->TileHeight(cell, { x, y }, from, heights.size);
  };
  const float here = at(fraction.x, fraction.y);
  return here < 0.0f
    ? PatchGradient(codes, fraction)
    : Difference(fraction, low, high, here, { at(low.x, fraction.y), at(fraction.x, low.y) },
        { at(high.x, fraction.y), at(fraction.x, high.y) }, glm::vec2(0.0f));
}

/// Gradient of repeated detail, of which the period is a square with a power of two of samples a
/// side, over squares of 2^level of its cells a side, level >= 0: differences of means over
/// squares, between texels and levels as OpenGL samples a repeated texture.
template <typename Texel>
glm::dvec2 DetailGradient(
  const DetailedHeights<Texel>& heights, glm::ivec2 cell, const glm::dvec2& fraction, double level)
{
  const int top = WholeLevels(heights.period);
  const auto mean = [&](const glm::ivec2& texel, int k)
  {
    const glm::ivec2 first = Wrap(texel + (heights.period >> k), heights.period >> k) << k;
    double sum = 0.0;
    for (int part = 0; part < (1 << k) << k; ++part)
    {
      sum += heights.DetailCode(first + glm::ivec2(part & ((1 << k) - 1), part >> k));
    }
    return sum / (1 << k) / (1 << k);
  };
  const auto in = [&](const glm::dvec2& position, int k)
  {
    const glm::dvec2 at = position / std::exp2(k) - 0.5;
    const glm::ivec2 low(glm::floor(at));
    const glm::dvec2 part = at - glm::dvec2(low);
    return glm::mix(glm::mix(mean(low, k), mean(low + glm::ivec2(1, 0), k), part.x),
      glm::mix(mean(low + glm::ivec2(0, 1), k), mean(low + 1, k), part.x), part.y);
  };
  const double place = glm::clamp(level, 0.0, 1.0 * top);
  const int below = static_cast<int>(place);
  const auto code = [&](const glm::dvec2& position)
  {
    return glm::mix(
      in(position, below), in(position, std::min(below + 1, top)), place - 1.0 * below);
  };
  const glm::dvec2 at = glm::dvec2(Wrap(cell, heights.period)) + fraction + 0.5;
  const double step = 0.5 * std::exp2(level);
  const glm::dvec2 east(step, 0.0);
  const glm::dvec2 north(0.0, step);
  return std::exp2(-level) *
    glm::dvec2(code(at + east) - code(at - east), code(at + north) - code(at - north));
}

///@{
/// Gradient of what a pixel shows of the surface, which is so many cells wide there. With detail it
/// is the sum of both gradients, each over its own cells.
template <typename Texel>
glm::vec2 Gradient(const CodedHeights<Texel>& heights, const HeightSlopes& slopes, glm::ivec2 cell,
  glm::vec2 fraction, const glm::vec4& codes, float pixelCells)
{
  return TexelGradient(
    heights, slopes, cell, fraction, codes, std::log2(std::max(pixelCells, 1e-6f)));
}
template <typename Texel>
glm::vec2 Gradient(const DetailedHeights<Texel>& heights, const HeightSlopes& slopes,
  glm::ivec2 cell, glm::vec2 fraction, const glm::vec4& /*codes*/, float pixelCells)
{
  const float level = std::log2(std::max(pixelCells, 1e-6f));
  const glm::ivec2 texel = cell >> heights.level;
  const float width = 1.0f / static_cast<float>(1 << heights.level);
  const glm::vec2 position = (glm::vec2(cell - (texel << heights.level)) + fraction) * width;
  return width *
    TexelGradient(heights.base, slopes, texel, position, heights.base.CellCodes(texel),
      level - static_cast<float>(heights.level)) +
    glm::vec2(DetailGradient(heights, cell, fraction, std::max(level, 0.0f)));
}
inline glm::vec2 Gradient(const FinestHeights& heights, const HeightSlopes& /*slopes*/,
  glm::ivec2 cell, glm::vec2 fraction, const glm::vec4& codes, float pixelCells)
{
  return TexelGradient(heights, cell, fraction, codes, std::log2(std::max(pixelCells, 1e-6f)));
}
///@}
}

#endif
