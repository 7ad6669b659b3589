// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Exact ray casting through the min-max pyramid. Twin, node for node, of
 * shaders/vtkTerrainPyramid.glsl: the same functions (there with the prefix terrain), the same
 * arithmetic in the same order.
 *
 * Source: S. Park, K. Oh, "GPU-only Terrain Rendering for Walk-through", sections 4 and 5. A ray
 * goes down a level where its heights in a node meet those of the surface, crosses the node where
 * they do not, and goes up a level where that leads into a new parent. In a cell it is intersected
 * with the bilinear patch (figure 7), taking the first root on the ray (figure 12).
 *
 * Departures from the paper:
 * - Both sides: a node is crossed if the ray is wholly above its maximum or wholly below its
 *   minimum. Where it is not, a falling ray goes down a level where it meets the maximum, a rising
 *   one where it meets the minimum.
 * - Integer stepping: the ray is mirrored to run north-east; the next node is the neighbour across
 *   the side the ray leaves by, in integers, and the other coordinate is clamped to the node's
 *   range. No distance is ever added to get over a line.
 * - Watertight: at a line between cells both see the same position, the same height on the ray and
 *   the same height of the surface, hence the same sign of their difference; a change of sign from
 *   entry to exit is a hit by definition. A node is crossed only if the ray clears it by more than
 *   the rounding of heights (Path::slack, about ten units in the last place).
 * - Heights are relative to that of the ray's origin, so that float resolves the height of an eye
 *   above the ground next to it, however high that is.
 * - The quadratic is that of the difference along the segment in the cell, from 0 at its entry to
 *   1 at its exit, so that no term depends on how far the ray has come, and is solved in the form
 *   that does not cancel.
 *
 * Number of nodes visited: every step crosses a line in the direction of the ray, of which there
 * are less than W + H, or goes down a level; levels rise by one with a crossed line at most. So
 * there are no more than 2 (W + H) + top visits, for any input.
 */
#ifndef terrain_PyramidTraversal_h
#define terrain_PyramidTraversal_h

#include "core/rays/Ray.h"
#include "core/surface/CodedHeights.h"
#include "core/surface/Columns.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace terrain
{
/// First t in 0..1 with c + b t + a t^2 = 0, where c and e are the values at 0 and 1; -1 if there
/// is none. There is one if c and e differ in sign.
template <typename Real>
Real FirstRoot(Real c, Real e, Real a)
{
  const Real side = c < 0 ? Real(-1) : Real(1);
  c *= side;
  e *= side;
  a *= side;
  const Real b = e - c - a;
  const Real discriminant = b * b - 4 * a * c;
  const bool dips = b < 0 && b > -2 * a && discriminant >= 0;
  const Real root = std::sqrt(std::max(discriminant, Real(0)));
  Real t = b <= 0 ? 2 * c / (root - b) : (b + root) / (-2 * a);
  t = c > 0 ? std::min(std::max(t, Real(0)), Real(1)) : Real(0);
  return c == 0 || e <= 0 || dips ? t : Real(-1);
}

/// Where the segment from one position in a cell to another first meets the cell's patch, as a
/// fraction of the segment; -1 if it does not. Positions: fractions of the cell and height codes.
inline float IntersectPatch(const glm::vec4& codes, const glm::vec3& begin, const glm::vec3& end)
{
  const glm::vec2 move = glm::vec2(end) - glm::vec2(begin);
  const float twist = (codes.x - codes.y) - (codes.z - codes.w);
  return FirstRoot(begin.z - PatchCode(codes, glm::vec2(begin)),
    end.z - PatchCode(codes, glm::vec2(end)), -twist * move.x * move.y);
}

/// Heights and their pyramid, both as texels, and the functions that trace rays through them.
template <typename Texel>
struct CodedPyramid
{
  typename CodedTypes<Texel>::Heights heights;
  const typename CodedTypes<Texel>::Pyramid* pyramid = nullptr;
  /// Level of the first node, 1..LevelCount(); more is taken as LevelCount().
  int start = 1;
  /// The surface of constant columns (TERRAIN_COLUMNS in the shader) instead of bilinear patches.
  bool columns = false;

  /// A ray mirrored so that it runs north-east; cells are mirrored likewise.
  struct Path
  {
    glm::ivec2 mirror;    ///< cell ^ mirror takes cells to the grid and back: -1 or 0
    glm::ivec2 anchor;    ///< corner that origin is relative to
    glm::ivec2 firstCell; ///< range of the grid's cells
    glm::ivec2 lastCell;
    float anchorCode;     ///< code that heights are relative to
    glm::vec3 origin;     ///< position at s = 0: cells, height code, both relative
    glm::vec3 direction;  ///< change per unit of s; x, y >= 0
    glm::vec2 lineOrigin; ///< origin for distances to grid lines
    glm::vec3 inverse;    ///< 1 / direction; 0 in z if the ray is level
    float slack;          ///< above the rounding of heights on the ray, codes
    float sBegin;
    float sEnd;
  };

  /// Where a ray is: the cell in which it runs on, and the node over it.
  struct Step
  {
    glm::ivec2 cell; ///< mirrored
    int level;
    float s;
    float z;  ///< height code
    int line; ///< the grid line it stands on: 0 none, 1 runs north-south, 2 east-west
  };

  /// The part of a ray in a node.
  struct Span
  {
    glm::ivec2 lastCell; ///< of the node, where the ray leaves
    bool crossEast;      ///< leaves through the east side, else through the north side
    bool ends;           ///< the ray ends in the node
    float s;             ///< where it leaves
    float z;
  };

  glm::vec2 NodeExtremes(glm::ivec2 node, int level) const
  {
    const auto& extremes = this->pyramid->At(node, level);
    return glm::vec2(static_cast<float>(extremes.Maximum), static_cast<float>(extremes.Minimum)) -
      static_cast<float>(this->heights.bias);
  }

  bool IsCellValid(glm::ivec2 cell) const
  {
    return glm::all(glm::greaterThanEqual(this->heights.CellCodes(cell), glm::vec4(0.0f)));
  }

  Path MirrorRay(const TerrainRay& ray) const;
  /// Clips to the grid's rectangle and to the codes; empty if sBegin > sEnd.
  Path ClipPath(Path path) const;
  Step FirstStep(const Path& path) const;
  Span NodeSpan(const Path& path, const Step& at) const;
  /// The next step: down a level at distance s; or else into the next node, one level up if the
  /// line between them is that of a parent too, and s is where the ray leaves.
  Step NextStep(const Path& path, const Step& at, const Span& span, bool down, float s) const;
  /// Highest and lowest code that the path must not pass in a node, widened by the slack.
  glm::vec2 NodeBounds(const Path& path, const Step& at) const;
  /// Visits the node of a step: down if the path's heights meet the bounds, from where they do;
  /// small if the node where they do is within the tolerance.
  Step VisitNode(const Path& path, const Step& at, const Span& span, const glm::vec4& tolerance,
    bool& down, bool& small) const;
  glm::vec2 CellFraction(const Path& path, glm::ivec2 cell, float s, int line, float side) const;
  TerrainHit MeetCell(const Path& path, const Step& at, const Span& span) const;
  /// Where a path enters the box of a node that is small enough.
  TerrainHit MeetBox(const Path& path, const Step& at) const
  {
    return { true, at.s, at.cell ^ path.mirror,
      this->CellFraction(path, at.cell, at.s, at.line, 0.0f), 0 };
  }

  /// The first point of the surface on a ray. The search may end at a node of the pyramid that, in
  /// cells and in height codes, is no larger than tolerance.xy + s * tolerance.zw: the hit is then
  /// where the ray enters the node's box, hence off the surface by less than that, and found even
  /// if the ray would pass by the surface within the box. 0 is exact; less than 2 cells has no
  /// effect. A ray that enters such a box in a cell without surface goes on exactly. Visit(node,
  /// level) is called for every node visited, in order, node counted from the south-west.
  template <typename Visit>
  TerrainHit TracePyramidWithin(const TerrainRay& ray, glm::vec4 tolerance, Visit&& visit) const;
  /// The first point of the surface on a ray.
  template <typename Visit>
  TerrainHit TracePyramid(const TerrainRay& ray, Visit&& visit) const
  {
    return this->TracePyramidWithin(ray, glm::vec4(0.0f), visit);
  }
  TerrainHit TracePyramid(const TerrainRay& ray) const
  {
    return this->TracePyramid(ray, [](glm::ivec2, int) {});
  }
};

template <typename Texel>
typename CodedPyramid<Texel>::Path CodedPyramid<Texel>::MirrorRay(const TerrainRay& ray) const
{
  Path path;
  const glm::bvec2 backward = glm::lessThan(glm::vec2(ray.directionGC), glm::vec2(0.0f));
  path.mirror = -glm::ivec2(backward);
  path.anchor = (ray.anchorCell ^ path.mirror) - path.mirror;
  path.anchorCode = std::min(std::max(ray.originGC.z, 0.0f), this->heights.maximumCode);
  path.origin = glm::vec3(glm::mix(glm::vec2(ray.originGC), -glm::vec2(ray.originGC), backward),
    ray.originGC.z - path.anchorCode + ray.originLow);
  path.direction = glm::vec3(glm::abs(glm::vec2(ray.directionGC)), ray.directionGC.z);
  const glm::bvec2 still = glm::lessThan(glm::vec2(path.direction), glm::vec2(1e-20f));
  path.direction.x = still.x ? 0.0f : path.direction.x;
  path.direction.y = still.y ? 0.0f : path.direction.y;
  const bool level = std::abs(path.direction.z) < 1e-30f;
  path.inverse = glm::vec3(glm::mix(1.0f / glm::vec2(path.direction), glm::vec2(1e20f), still),
    level ? 0.0f : 1.0f / path.direction.z);
  path.lineOrigin = glm::mix(glm::vec2(path.origin), glm::vec2(-1e8f), still);
  const glm::ivec2 cells = this->heights.size - 1;
  path.firstCell = path.mirror * cells;
  path.lastCell = path.firstCell + cells - 1;
  path.slack = 1e-6f * (this->heights.maximumCode + std::abs(path.origin.z));
  path.sBegin = ray.sBegin;
  path.sEnd = ray.sEnd;
  return path;
}

template <typename Texel>
typename CodedPyramid<Texel>::Path CodedPyramid<Texel>::ClipPath(Path path) const
{
  const glm::bvec2 still = glm::equal(glm::vec2(path.direction), glm::vec2(0.0f));
  const glm::vec2 firstLine = glm::vec2(path.firstCell - path.anchor);
  const glm::vec2 lastLine = glm::vec2(path.lastCell + 1 - path.anchor);
  const glm::vec2 enter = glm::mix(
    (firstLine - glm::vec2(path.origin)) * glm::vec2(path.inverse), glm::vec2(path.sBegin), still);
  const glm::vec2 leave = (lastLine - path.lineOrigin) * glm::vec2(path.inverse);
  path.sBegin = std::max(std::max(enter.x, enter.y), path.sBegin);
  path.sEnd = std::min(std::min(leave.x, leave.y), path.sEnd);

  const bool level = path.inverse.z == 0.0f;
  const glm::vec2 planes = glm::vec2(0.0f, this->heights.maximumCode) - path.anchorCode -
    path.origin.z + glm::vec2(-path.slack, path.slack);
  const glm::vec2 meet = planes * path.inverse.z;
  path.sBegin = level ? path.sBegin : std::max(path.sBegin, std::min(meet.x, meet.y));
  path.sEnd = level ? path.sEnd : std::min(path.sEnd, std::max(meet.x, meet.y));

  const glm::bvec2 beside(path.origin.x < firstLine.x || path.origin.x > lastLine.x,
    path.origin.y < firstLine.y || path.origin.y > lastLine.y);
  bool outside = (still.x && beside.x) || (still.y && beside.y) ||
    (level && (planes.x > 0.0f || planes.y < 0.0f)) || this->pyramid->LevelCount() < 1;
  const float sum =
    glm::dot(path.origin, glm::vec3(1.0f)) + glm::dot(path.direction, glm::vec3(1.0f));
  outside = outside || !(std::abs(sum) < 1e38f); // not a number, or infinite
  path.sEnd = outside ? path.sBegin - 1.0f : path.sEnd;
  return path;
}

template <typename Texel>
typename CodedPyramid<Texel>::Step CodedPyramid<Texel>::FirstStep(const Path& path) const
{
  const glm::vec2 position = glm::vec2(path.origin) + glm::vec2(path.direction) * path.sBegin;
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(position)) + path.anchor, path.firstCell, path.lastCell);
  return { cell, std::min(this->start, this->pyramid->LevelCount()), path.sBegin,
    path.origin.z + path.direction.z * path.sBegin, 0 };
}

template <typename Texel>
typename CodedPyramid<Texel>::Span CodedPyramid<Texel>::NodeSpan(
  const Path& path, const Step& at) const
{
  Span span;
  span.lastCell = glm::min(at.cell | ((1 << at.level) - 1), path.lastCell);
  const glm::vec2 leave =
    (glm::vec2(span.lastCell + 1 - path.anchor) - path.lineOrigin) * glm::vec2(path.inverse);
  span.crossEast = leave.x <= leave.y;
  const float s = std::min(leave.x, leave.y);
  span.ends = s >= path.sEnd;
  span.s = std::min(std::max(s, at.s), path.sEnd);
  span.z = path.origin.z + path.direction.z * span.s;
  return span;
}

template <typename Texel>
typename CodedPyramid<Texel>::Step CodedPyramid<Texel>::NextStep(
  const Path& path, const Step& at, const Span& span, bool down, float s) const
{
  const glm::vec2 position = glm::vec2(path.origin) + glm::vec2(path.direction) * s;
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(position)) + path.anchor, at.cell, span.lastCell);
  const bool moves = s > at.s;
  const int line = (span.crossEast ? span.lastCell.x : span.lastCell.y) + 1;
  const int up = ((line >> at.level) & 1) ^ 1;
  const glm::ivec2 across = span.crossEast ? glm::ivec2(line, cell.y) : glm::ivec2(cell.x, line);
  return { down ? (moves ? cell : at.cell) : across,
    down ? at.level - 1 : std::min(at.level + up, this->pyramid->LevelCount()), s,
    moves ? path.origin.z + path.direction.z * s : at.z,
    down ? (moves ? 0 : at.line) : (span.crossEast ? 1 : 2) };
}

template <typename Texel>
glm::vec2 CodedPyramid<Texel>::NodeBounds(const Path& path, const Step& at) const
{
  const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
  return this->NodeExtremes(node, at.level) - path.anchorCode + glm::vec2(path.slack, -path.slack);
}

/// True if a node is no larger than a tolerance allows at a distance.
inline bool IsWithin(const glm::vec4& tolerance, float s, int level, const glm::vec2& bounds)
{
  const glm::vec2 allowed =
    glm::vec2(tolerance.x, tolerance.y) + s * glm::vec2(tolerance.z, tolerance.w);
  return static_cast<float>(1 << level) <= allowed.x && bounds.x - bounds.y <= allowed.y;
}

template <typename Texel>
typename CodedPyramid<Texel>::Step CodedPyramid<Texel>::VisitNode(const Path& path, const Step& at,
  const Span& span, const glm::vec4& tolerance, bool& down, bool& small) const
{
  const glm::vec2 bounds = this->NodeBounds(path, at);
  down = std::min(at.z, span.z) <= bounds.x && std::max(at.z, span.z) >= bounds.y;
  small = down && IsWithin(tolerance, at.s, at.level, bounds);
  const float bound = path.direction.z < 0.0f ? bounds.x : bounds.y;
  const float s = std::min(std::max(at.s + (bound - at.z) * path.inverse.z, at.s), span.s);
  return this->NextStep(path, at, span, down, down ? s : span.s);
}

/// Position on a path in a cell, as fractions of the cell in the grid; line: see Step, side 0 or 1.
template <typename Texel>
glm::vec2 CodedPyramid<Texel>::CellFraction(
  const Path& path, glm::ivec2 cell, float s, int line, float side) const
{
  glm::vec2 fraction = glm::clamp(
    glm::vec2(path.origin) + glm::vec2(path.direction) * s - glm::vec2(cell - path.anchor),
    glm::vec2(0.0f), glm::vec2(1.0f));
  fraction = { line == 1 ? side : fraction.x, line == 2 ? side : fraction.y };
  return glm::mix(fraction, 1.0f - fraction, glm::notEqual(path.mirror, glm::ivec2(0)));
}

template <typename Texel>
TerrainHit CodedPyramid<Texel>::MeetCell(const Path& path, const Step& at, const Span& span) const
{
  TerrainHit hit;
  hit.cell = at.cell ^ path.mirror;
  const bool valid = this->IsCellValid(hit.cell);
  const glm::vec4 codes = this->heights.CellCodes(hit.cell) - path.anchorCode;
  const glm::vec2 begin = this->CellFraction(path, at.cell, at.s, at.line, 0.0f);
  const glm::vec2 end =
    this->CellFraction(path, at.cell, span.s, span.ends ? 0 : (span.crossEast ? 1 : 2), 1.0f);
  const glm::vec3 begin3(begin, at.z);
  const glm::vec3 end3(end, span.z);
  const float t =
    this->columns ? IntersectColumns(codes, begin3, end3) : IntersectPatch(codes, begin3, end3);
  hit.found = valid && t >= 0.0f;
  hit.s = at.s + t * (span.s - at.s);
  hit.fraction = begin + t * (end - begin);
  return hit;
}

template <typename Texel>
template <typename Visit>
TerrainHit CodedPyramid<Texel>::TracePyramidWithin(
  const TerrainRay& ray, glm::vec4 tolerance, Visit&& visit) const
{
  const Path path = this->ClipPath(this->MirrorRay(ray));
  TerrainHit hit;
  if (!(path.sBegin <= path.sEnd))
  {
    return hit;
  }
  Step at = this->FirstStep(path);
  const int most = 2 * (this->heights.size.x + this->heights.size.y) + this->pyramid->LevelCount();
  bool ended = false;
  int crossings = 0;
  while (!ended && crossings < most)
  {
    ++crossings;
    visit((at.cell >> at.level) ^ path.mirror, at.level);
    const Span span = this->NodeSpan(path, at);
    if (at.level > 0)
    {
      bool down = false;
      bool small = false;
      at = this->VisitNode(path, at, span, tolerance, down, small);
      if (small && !this->IsCellValid(at.cell ^ path.mirror))
      {
        tolerance = glm::vec4(0.0f);
        small = false;
      }
      ended = (span.ends && !down) || small;
      if (small)
      {
        hit = this->MeetBox(path, at);
      }
    }
    else
    {
      hit = this->MeetCell(path, at, span);
      ended = span.ends || hit.found;
      at = this->NextStep(path, at, span, false, span.s);
    }
  }
  hit.crossings = crossings;
  return hit;
}
}

#endif
