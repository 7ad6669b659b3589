// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which rays of one direction are free from some place on, and which are hidden, told by one look.
 */
#ifndef terrain_ShadowBounds_h
#define terrain_ShadowBounds_h

#include "core/grid/Constants.h"
#include "core/grid/ParallelFor.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrain
{
/// How the rays of one light run over a grid; coordinates in cells.
struct ShadowRays
{
  /// Horizontal direction, of length 1.
  glm::dvec2 Direction{ 1.0, 0.0 };
  /// Height codes that the lowest and the highest rays rise a cell, Low <= High; Low > 0.
  double Low = 1.0;
  double High = 1.0;
};

/// Part of their numbers by which rays may differ from those that bounds are made for.
constexpr double kSameShadowRays = 0x1p-24;

/// True if bounds made for some rays are right for others, too: the same but for rounding, as that
/// of a direction which is computed from where a camera looks.
inline bool AreSameRays(const ShadowRays& a, const ShadowRays& b)
{
  const auto isNear = [](double first, double second)
  { return std::abs(first - second) <= kSameShadowRays * std::abs(first); };
  return glm::length(a.Direction - b.Direction) <= kSameShadowRays && isNear(a.Low, b.Low) &&
    isNear(a.High, b.High);
}

/**
 * The grid is laid out along the longer part of the rays' direction, its major axis: a = 0 where
 * rays come in, growing along them; b is the other coordinate. A ray keeps w = b - Slope a, and
 * falls into one of the strips of w; a column is a stretch of a. Both are as wide as the nodes of a
 * level of the pyramid. On a ray of height z at a, the number z - Rise a stays the same, so that
 * the surface at q is above the ray if h(q) - Rise a(q) is more than that number. The texel of a
 * column and a strip has the bounds of it over that column and all behind it:
 *
 * x: more than that of any surface, with the rise of the lowest rays: a ray with more is free;
 * y: less than that of the surface somewhere, all across the strip, with the rise of the highest
 *    rays: a ray with less that starts before the column is hidden.
 *
 * Both hold by the extremes of nodes, of which a strip meets up to three in a column. A position
 * may be off by half of kShadowMargin of a node. Twin of what reads it:
 * shaders/vtkTerrainOutlook.glsl.
 *
 * Cost: three nodes for each texel, of which there are one to two for each node of the level.
 */
struct ShadowBounds
{
  int Level = 1;
  /// Columns and strips.
  glm::ivec2 Size{ 0, 0 };
  /// b grows by so much where a grows by 1; -1 to 1.
  double Slope = 0.0;
  /// a = dot(Major, (x, y)) + MajorStart, b = dot(Minor, (x, y)).
  glm::dvec2 Major{ 1.0, 0.0 };
  double MajorStart = 0.0;
  glm::dvec2 Minor{ 0.0, 1.0 };
  /// w of the first strip's border.
  double FirstStrip = 0.0;
  /// Rises a unit of a.
  double LowRise = 0.0;
  double HighRise = 0.0;
  /// Row by row: one strip after the other.
  std::vector<glm::vec2> Texels;
};

/// Part of a node by which positions may be off. terrainShadowMargin in GLSL.
constexpr double kShadowMargin = 0.02;

/// A ray among the bounds. Twin, with the functions below: TerrainStrip in
/// shaders/vtkTerrainOutlook.glsl.
struct ShadowStrip
{
  int Strip = 0;
  double Column = 0.0;     ///< where it starts
  double Pace = 0.0;       ///< columns a cell
  glm::dvec2 Codes{ 0.0 }; ///< its own numbers with both rises
};

/// The ray from a position in cells and a height code in the direction of the bounds' rays.
inline ShadowStrip FindShadowStrip(const ShadowBounds& bounds, const glm::dvec2& positionGC,
  double code, const glm::dvec2& direction)
{
  const double nodes = std::exp2(-bounds.Level);
  const double major = glm::dot(bounds.Major, positionGC) + bounds.MajorStart;
  const double across = glm::dot(bounds.Minor, positionGC) - bounds.Slope * major;
  return { static_cast<int>((across - bounds.FirstStrip) * nodes), major * nodes,
    glm::dot(bounds.Major, direction) * nodes,
    code - glm::dvec2(bounds.LowRise, bounds.HighRise) * major };
}

inline glm::vec2 ShadowTexel(const ShadowBounds& bounds, int column, int strip)
{
  return bounds.Texels[static_cast<std::size_t>(column) +
    static_cast<std::size_t>(bounds.Size.x) * static_cast<std::size_t>(strip)];
}

/// True if something hides the highest ray from the next column on.
inline bool IsHidden(const ShadowBounds& bounds, const ShadowStrip& strip)
{
  const int column = static_cast<int>(strip.Column + 0.5 * kShadowMargin) + 1;
  return column < bounds.Size.x && strip.Codes.y < ShadowTexel(bounds, column, strip.Strip).y;
}

/// True if the lowest ray meets nothing from a distance in cells on.
inline bool IsFree(const ShadowBounds& bounds, const ShadowStrip& strip, double s)
{
  const int column =
    std::max(static_cast<int>(strip.Column + s * strip.Pace - 0.5 * kShadowMargin), 0);
  return strip.Codes.x > ShadowTexel(bounds, std::min(column, bounds.Size.x - 1), strip.Strip).x;
}

/// The number of nothing that would hide a ray: less than any surface's.
constexpr double kNoShadow = -1e30;

/// Bounds of rays without their texels, over nodes of a level, so many each way.
inline ShadowBounds LayOutShadowBounds(const glm::ivec2& nodes, int level, const ShadowRays& rays)
{
  ShadowBounds bounds;
  bounds.Level = level;
  const double side = std::exp2(level);
  const bool swaps = std::abs(rays.Direction.y) > std::abs(rays.Direction.x);
  const int columns = swaps ? nodes.y : nodes.x;
  const int rows = swaps ? nodes.x : nodes.y;
  const double along = swaps ? rays.Direction.y : rays.Direction.x;
  const double across = swaps ? rays.Direction.x : rays.Direction.y;
  const bool backward = along < 0.0;
  bounds.Slope = across / std::abs(along);
  bounds.Major = (swaps ? glm::dvec2(0.0, 1.0) : glm::dvec2(1.0, 0.0)) * (backward ? -1.0 : 1.0);
  bounds.MajorStart = backward ? columns * side : 0.0;
  bounds.Minor = swaps ? glm::dvec2(1.0, 0.0) : glm::dvec2(0.0, 1.0);
  bounds.LowRise = rays.Low / std::abs(along);
  bounds.HighRise = rays.High / std::abs(along);
  const double shear = bounds.Slope * columns * side;
  bounds.FirstStrip = std::min(0.0, -shear);
  bounds.Size = { columns, static_cast<int>(std::ceil(rows + std::abs(shear) / side)) + 1 };
  return bounds;
}

/// The extremes of codes that a strip meets in a column: x the highest; y the lowest, kNoShadow
/// where rays of the strip leave the grid or meet a hole, and everywhere unless complete.
template <typename Texel>
glm::dvec2 ExtremesOfShadowStrip(const ShadowBounds& bounds, const MinMaxPyramid<Texel>& pyramid,
  double bias, int column, std::int64_t strip, bool complete)
{
  const bool swaps = bounds.Major.y != 0.0;
  const bool backward = bounds.MajorStart > 0.0;
  const double side = std::exp2(bounds.Level);
  const double extent = (swaps ? pyramid.CellCount().x : pyramid.CellCount().y) / side;
  const double from = bounds.Slope * column;
  const double to = bounds.Slope * (column + 1);
  const double first = static_cast<double>(strip) + bounds.FirstStrip / side;
  const double least = first + std::min(from, to) - kShadowMargin;
  const double most = first + 1.0 + std::max(from, to) + kShadowMargin;
  const int low = std::max(static_cast<int>(std::floor(least)), 0);
  const int high =
    std::min(static_cast<int>(std::floor(most)), static_cast<int>(std::ceil(extent)) - 1);
  const bool within = least >= 0.0 && most <= extent; // else rays leave the grid
  const int major = backward ? bounds.Size.x - 1 - column : column;
  glm::dvec2 extremes(kNoShadow, within && complete ? -kNoShadow : kNoShadow);
  for (int row = low; row <= high; ++row)
  {
    const PyramidNode<Texel> node =
      pyramid.At(swaps ? glm::ivec2(row, major) : glm::ivec2(major, row), bounds.Level);
    if (node.IsEmpty())
    {
      extremes.y = kNoShadow;
      continue;
    }
    extremes.x = std::max(extremes.x, static_cast<double>(node.Maximum) - bias);
    extremes.y = std::min(extremes.y, static_cast<double>(node.Minimum) - bias);
  }
  return extremes;
}

/// The bounds of a pyramid of texels, which are codes 0 to maximumCode plus a bias, from nodes of a
/// level. complete: there are no holes, and nothing is cut away; else no ray is told to be hidden.
template <typename Texel>
ShadowBounds MakeShadowBounds(const MinMaxPyramid<Texel>& pyramid, int level, double bias,
  const ShadowRays& rays, double maximumCode, bool complete, const ParallelFor& parallelFor)
{
  const double side = std::exp2(level);
  const glm::ivec2 nodes = (pyramid.CellCount() + (1 << level) - 1) >> level;
  ShadowBounds bounds = LayOutShadowBounds(nodes, level, rays);
  const auto columns = static_cast<std::size_t>(bounds.Size.x);
  bounds.Texels.resize(columns * static_cast<std::size_t>(bounds.Size.y));
  // What float cuts off heights and rises, and kSameShadowRays lets them be off.
  const double slack = 6e-7 * (maximumCode + bounds.HighRise * bounds.Size.x * side);
  parallelFor(bounds.Size.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t strip = begin; strip < end; ++strip)
      {
        glm::dvec2 most(kNoShadow);
        glm::vec2* texels = bounds.Texels.data() + columns * static_cast<std::size_t>(strip);
        for (int column = bounds.Size.x - 1; column >= 0; --column)
        {
          const glm::dvec2 rises(bounds.LowRise, bounds.HighRise);
          const glm::dvec2 extremes =
            ExtremesOfShadowStrip(bounds, pyramid, bias, column, strip, complete);
          most = glm::max(most, extremes - rises * (side * column));
          texels[column] = most + glm::dvec2(slack, -slack);
        }
      }
    });
  return bounds;
}
}

#endif
