// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The horizon of a point of the surface in one direction, through the max pyramid or through tiles.
 * Twin, node for node, of shaders/vtkTerrainOutlook.glsl, which documents the method: the same
 * functions (there with the prefix terrain), the same arithmetic in the same order. For tests:
 * horizons of all samples are those of Horizon.h, and nothing is drawn by this.
 *
 * The judge of both is neither: Testing/Unit/UnitTestOutlook.cxx asks RayQuery, in double, whether
 * a ray at the tangent touches the surface and passes over all of it, to kOutlookError.
 */
#ifndef terrain_Outlook_h
#define terrain_Outlook_h

#include "core/rays/PyramidTraversal.h"
#include "core/rays/ShadowBounds.h"
#include "core/rays/TileTraversal.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace terrain
{
/// What the surface may stand above a ray at its horizon's tangent, as a part of the largest code.
constexpr double kOutlookError = 4e-6;

/// A way over the grid from a point of the surface.
struct Outlook
{
  glm::ivec2 cell{ 0, 0 };
  glm::vec2 fraction{ 0.0f, 0.0f };  ///< position in the cell, 0..1
  glm::vec4 codes{ 0.0f };           ///< of the cell's corners
  float code = 0.0f;                 ///< height of the point
  glm::vec2 direction{ 1.0f, 0.0f }; ///< of length 1, in cells
  float low = 0.0f;                  ///< tangents, codes per cell: lower horizons count as this
  float high = 0.0f;                 ///< the search ends where the horizon is higher
  float end = 0.0f;                  ///< distance at which it ends, cells
};

/// The highest tangent to three points of the surface, height over distance, that lie above the ray
/// of a tangent by more than rounding; else that tangent.
inline float Raise(
  float tangent, const glm::vec3& heights, const glm::vec3& distances, float rounding)
{
  const glm::vec3 tangents =
    glm::mix(glm::vec3(tangent), heights / glm::max(distances, glm::vec3(1e-9f)),
      glm::greaterThan(heights - tangent * distances, glm::vec3(rounding)));
  return std::max(std::max(tangents.x, tangents.y), std::max(tangents.z, tangent));
}

///@{
/// The tangent of a ray that has passed the columns, or the patch, of a cell between two positions
/// in it, as fractions, and two distances.
inline float PassCellColumns(float tangent, const glm::vec4& codes, float originCode,
  const glm::vec2& begin, const glm::vec2& end, const glm::vec2& span, float rounding)
{
  const glm::bvec2 from = glm::greaterThanEqual(begin, glm::vec2(0.5f));
  const glm::bvec2 to = glm::greaterThanEqual(end, glm::vec2(0.5f));
  const glm::vec2 wall = glm::mix(glm::vec2(1.0f),
    glm::clamp((0.5f - begin) / (end - begin), glm::vec2(0.0f), glm::vec2(1.0f)),
    glm::notEqual(from, to));
  const glm::bvec2 between = wall.x <= wall.y ? glm::bvec2(to.x, from.y) : glm::bvec2(from.x, to.y);
  const glm::vec3 heights =
    glm::vec3(ColumnCode(codes, from), ColumnCode(codes, between), ColumnCode(codes, to)) -
    originCode;
  const glm::vec2 walls = glm::mix(glm::vec2(span.x), glm::vec2(span.y),
    glm::vec2(std::min(wall.x, wall.y), std::max(wall.x, wall.y)));
  tangent = Raise(tangent, heights, glm::vec3(span.x, walls), rounding);
  return Raise(tangent, heights, glm::vec3(walls, span.y), rounding);
}
inline float PassCellPatch(float tangent, const glm::vec4& codes, float originCode,
  const glm::vec2& begin, const glm::vec2& end, const glm::vec2& span, float rounding)
{
  const glm::vec2 move = end - begin;
  const float bend = ((codes.x - codes.y) - (codes.z - codes.w)) * move.x * move.y;
  const float atBegin = PatchCode(codes - originCode, begin);
  const float atEnd = PatchCode(codes - originCode, end);
  const float slope = atEnd - atBegin - bend;
  const float length = span.y - span.x;
  const float square = length * (slope * span.x - length * atBegin) / std::max(-bend, 1e-30f);
  const float root = span.x + std::sqrt(std::max(span.x * span.x + square, 0.0f));
  const float summit =
    bend < 0.0f ? std::min(std::max(square / std::max(length * root, 1e-20f), 0.0f), 1.0f) : 0.0f;
  return Raise(tangent, glm::vec3(atBegin, atEnd, atBegin + summit * (slope + summit * bend)),
    glm::vec3(span, glm::mix(span.x, span.y, summit)), rounding);
}
///@}

/// Searches for horizons. Rays: a CodedPyramid, or TiledPyramid.
template <typename Rays>
struct OutlookSearch
{
  using Path = typename Rays::Path;
  using Step = typename Rays::Step;
  using Span = typename Rays::Span;
  static constexpr bool Tiled = std::is_same_v<Rays, TiledPyramid>;

  const Rays& rays;
  /// Of the rays of the outlooks, or null.
  const ShadowBounds* bounds = nullptr;

  /// The horizon of a point as a tangent: that of outlook.low if nothing is higher, and any that is
  /// above outlook.high for all such. visit(node, level) is called for each node, in order.
  template <typename Visit>
  float HorizonTangent(const Outlook& outlook, Visit&& visit) const
  {
    Step at;
    const Path path = this->OutlookPath(outlook, at);
    bool ended = false;
    const float tangent = this->LeaveCell(outlook, path, at, ended);
    ended = ended || tangent > outlook.high || !(path.sEnd > 0.0f);
    if constexpr (Tiled)
    {
      return this->OutlookTiles(outlook, path, at, tangent, ended, visit);
    }
    else
    {
      return this->OutlookNodes(outlook, path, at, tangent, ended, visit);
    }
  }

  /// Codes of the corners of a cell of level 0.
  glm::vec4 CellCodes(const glm::ivec2& cell) const
  {
    if constexpr (Tiled)
    {
      return this->rays.heights.tiles->TileCellCodes(cell);
    }
    else
    {
      return this->rays.heights.CellCodes(cell);
    }
  }

private:
  static bool CellValid(const glm::vec4& codes)
  {
    return glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0f)));
  }
  float PassCell(float tangent, const glm::vec4& codes, float originCode, const glm::vec2& begin,
    const glm::vec2& end, const glm::vec2& span, float rounding) const
  {
    return (this->rays.columns ? PassCellColumns : PassCellPatch)(
      tangent, codes, originCode, begin, end, span, rounding);
  }
  int Most() const
  {
    return 2 * (this->rays.heights.size.x + this->rays.heights.size.y) +
      this->rays.pyramid->LevelCount();
  }
  static void Aim(Path& path, Step& at, float tangent)
  {
    path.direction.z = tangent;
    path.inverse.z = std::abs(tangent) < 1e-30f ? 0.0f : 1.0f / tangent;
    at.z = path.origin.z + tangent * at.s;
  }
  static int Leaves(const Span& span)
  {
    return span.ends ? 0 : (span.crossEast ? 1 : 2);
  }

  Path OutlookPath(const Outlook& outlook, Step& at) const;
  float LeaveCell(const Outlook& outlook, const Path& path, Step& at, bool& ends) const;
  float PassNode(
    const Path& path, const Step& at, const Span& span, glm::vec4 codes, float tangent) const;
  Step PassTop(const Path& path, const Step& at, const Span& span, float topCode, bool& down) const;
  template <typename Visit>
  float OutlookNodes(
    const Outlook& outlook, Path path, Step at, float tangent, bool ended, Visit&& visit) const;
  template <typename Visit>
  float OutlookTiles(
    const Outlook& outlook, Path path, Step at, float tangent, bool ended, Visit&& visit) const;
};

template <typename Rays>
typename Rays::Path OutlookSearch<Rays>::OutlookPath(const Outlook& outlook, Step& at) const
{
  const float anchorCode = std::min(std::max(outlook.code, 0.0f), this->rays.heights.maximumCode);
  TerrainRay ray;
  ray.anchorCell = outlook.cell;
  ray.originGC = glm::vec3(outlook.fraction, anchorCode);
  ray.directionGC = glm::vec3(outlook.direction, std::max(outlook.low, 0.0f));
  ray.sBegin = 0.0f;
  ray.sEnd = outlook.end;
  ray.originLow = outlook.code - anchorCode;
  Path path = this->rays.MirrorRay(ray);
  if (!this->rays.columns)
  {
    path.origin.z = PatchCode(outlook.codes - anchorCode, outlook.fraction);
  }
  path = this->rays.ClipPath(path);
  at = { glm::clamp(outlook.cell ^ path.mirror, path.firstCell, path.lastCell), 0, 0.0f,
    path.origin.z, 0 };
  return path;
}

template <typename Rays>
float OutlookSearch<Rays>::LeaveCell(
  const Outlook& outlook, const Path& path, Step& at, bool& ends) const
{
  const glm::vec2 position = glm::vec2(path.origin) - glm::vec2(at.cell - path.anchor);
  at.cell += glm::ivec2(glm::greaterThanEqual(position, glm::vec2(1.0f))) *
    glm::ivec2(glm::greaterThan(glm::vec2(path.direction), glm::vec2(0.0f)));
  ends = glm::any(glm::greaterThan(at.cell, path.lastCell));
  at.cell = glm::min(at.cell, path.lastCell);
  const glm::ivec2 cell = at.cell ^ path.mirror;
  const glm::vec4 codes = cell == outlook.cell ? outlook.codes : this->CellCodes(cell);
  const Span span = this->rays.NodeSpan(path, at);
  const glm::vec2 begin = this->rays.CellFraction(path, at.cell, 0.0f, 0, 0.0f);
  float tangent = outlook.low;
  if (this->rays.columns)
  {
    const glm::vec2 end = this->rays.CellFraction(path, at.cell, span.s, Leaves(span), 1.0f);
    tangent = PassCellColumns(outlook.low, codes, outlook.code, begin, end, glm::vec2(0.0f, span.s),
      1e-6f * this->rays.heights.maximumCode);
  }
  else
  {
    const float slope = glm::dot(PatchGradient(codes, begin), outlook.direction);
    const float bend =
      ((codes.x - codes.y) - (codes.z - codes.w)) * outlook.direction.x * outlook.direction.y;
    tangent = std::max(outlook.low, slope + std::max(bend * span.s, 0.0f));
  }
  tangent = CellValid(codes) ? tangent : outlook.low;
  ends = ends || span.ends;
  at = this->rays.NextStep(path, at, span, false, span.s);
  at.line = Tiled ? 0 : at.line;
  return tangent;
}

template <typename Rays>
float OutlookSearch<Rays>::PassNode(
  const Path& path, const Step& at, const Span& span, glm::vec4 codes, float tangent) const
{
  const auto fraction = [&](float s, int line, float side)
  {
    if constexpr (Tiled)
    {
      return this->rays.NodeFraction(path, at.cell, at.level, s, line, side);
    }
    else
    {
      return this->rays.CellFraction(path, at.cell, s, line, side);
    }
  };
  const glm::vec2 begin = fraction(at.s, at.line, 0.0f);
  const glm::vec2 end = fraction(span.s, Leaves(span), 1.0f);
  const bool valid = CellValid(codes);
  codes -= path.anchorCode;
  const float rounding = 5e-7f * (glm::dot(glm::abs(codes), glm::vec4(1.0f)) + std::abs(at.z));
  const float passed =
    this->PassCell(tangent, codes, path.origin.z, begin, end, glm::vec2(at.s, span.s), rounding);
  return valid ? passed : tangent;
}

template <typename Rays>
typename Rays::Step OutlookSearch<Rays>::PassTop(
  const Path& path, const Step& at, const Span& span, float topCode, bool& down) const
{
  const float top = topCode - path.anchorCode + path.slack;
  down = std::min(at.z, span.z) <= top;
  const float meets = path.direction.z < 0.0f ? at.s + (top - at.z) * path.inverse.z : at.s;
  return this->rays.NextStep(
    path, at, span, down, down ? std::min(std::max(meets, at.s), span.s) : span.s);
}

template <typename Rays>
template <typename Visit>
float OutlookSearch<Rays>::OutlookNodes(
  const Outlook& outlook, Path path, Step at, float tangent, bool ended, Visit&& visit) const
{
  Aim(path, at, tangent);
  ShadowStrip strip;
  if (this->bounds)
  {
    const glm::dvec2 position = glm::dvec2(outlook.cell) + glm::dvec2(outlook.fraction);
    strip = FindShadowStrip(*this->bounds, position, outlook.code, outlook.direction);
    const bool hidden = !ended && IsHidden(*this->bounds, strip);
    tangent = hidden ? 1e30f : tangent;
    ended = ended || hidden;
  }
  const int most = this->Most();
  for (int crossings = 1; !ended; ++crossings)
  {
    if (this->bounds && at.level >= this->bounds->Level && IsFree(*this->bounds, strip, at.s))
    {
      break;
    }
    const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
    visit(node, at.level);
    const Span span = this->rays.NodeSpan(path, at);
    if (at.level > 0)
    {
      bool down = false;
      at = this->PassTop(path, at, span, this->rays.NodeExtremes(node, at.level).x, down);
      ended = (span.ends && !down) || crossings >= most;
    }
    else
    {
      tangent = this->PassNode(path, at, span, this->CellCodes(node), tangent);
      ended = span.ends || tangent > outlook.high || crossings >= most;
      at = this->rays.NextStep(path, at, span, false, span.s);
      Aim(path, at, tangent);
    }
  }
  return tangent;
}

template <typename Rays>
template <typename Visit>
float OutlookSearch<Rays>::OutlookTiles(
  const Outlook& outlook, Path path, Step at, float tangent, bool ended, Visit&& visit) const
{
  Aim(path, at, tangent);
  const TileSlots& tiles = *this->rays.heights.tiles;
  const int most = this->Most();
  for (int crossings = 1; !ended; ++crossings)
  {
    const int slot = tiles.FinestSlot(at.cell ^ path.mirror, at.level);
    const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
    visit(node, at.level);
    const Span span = this->rays.NodeSpan(path, at);
    bool down = true;
    Step next = at;
    if (at.level > 0)
    {
      next = this->PassTop(path, at, span, tiles.SlotBounds(node, at.level, slot).x, down);
    }
    const int finer = std::max(at.level - 1, 0);
    if (down && (at.level == 0 || tiles.TileSlot((next.cell >> finer) ^ path.mirror, finer) < 0))
    {
      tangent = this->PassNode(path, at, span, tiles.SlotCodes(node, slot), tangent);
      next = this->rays.NextStep(path, at, span, false, span.s);
      down = false;
    }
    ended = (span.ends && !down) || tangent > outlook.high || crossings >= most;
    at = next;
    Aim(path, at, tangent);
  }
  return tangent;
}
}

#endif
