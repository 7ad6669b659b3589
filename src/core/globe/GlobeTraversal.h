// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Exact ray casting at a globe, through the min-max pyramid of its grid in longitude and latitude.
 * Twin, step for step, of shaders/vtkTerrainGlobeTrace.glsl, where Real is float; with double it is
 * what picks and tests use. GlobeAnchor.h has the axes and the equations of the lines.
 *
 * Along a straight line
 * - longitudes change in one direction only, by less than half a turn: the next meridian is met in
 *   closed form, and the only one;
 * - a cone of normals is met at most once on the way north and once on the way south, in closed
 *   form (RowCrossing());
 * - the height above the ellipsoid is convex, being the distance from a convex body, with a second
 *   derivative of no more than the greatest curvature: between two heights it lies below their
 *   chord and above a parabola. So bounds of a node are safe without any search.
 *
 * A node's height is taken from the circle that touches the ellipsoid at a parallel in the node:
 * Blaschke's theorem bounds its error by the spread of the radii of curvature, as a part of the
 * circle's own drop. In a cell the meridian is followed exactly, by the radius of curvature and its
 * derivatives; the difference of heights along the ray is fitted by a parabola and the root
 * refined.
 *
 * Rays go on in the region outside a partial raster, where nothing is met.
 */
#ifndef terrain_GlobeTraversal_h
#define terrain_GlobeTraversal_h

#include "core/globe/GlobeLines.h"
#include "core/globe/GlobeRoot.h"
#include "core/rays/PyramidTraversal.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
/// atan(x), which the shader takes to kGlobeAngleError from its series for the small angles of a
/// cell.
template <typename Real>
Real GlobeAngle(Real x)
{
  return std::atan(x);
}

template <typename Real, typename Texel>
struct GlobeTraversal
{
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Vec4 = glm::vec<4, Real>;
  using Path = GlobePath<Real>;
  using Step = GlobeStep<Real>;
  using Span = GlobeSpan<Real>;
  using Hit = GlobeHit<Real>;
  using Meeting = GlobeMeeting<Real>;

  const GlobeLines<Real>* lines = nullptr;
  CodedHeights<Texel> heights;
  const MinMaxPyramid<Texel>* pyramid = nullptr;
  Real codeScale = 1; ///< metres a code, as drawn
  Real codeBase = 0;  ///< height of anchorCode less the anchor's
  float anchorCode = 0.0f;

  /// Takes heights as drawn of codes: base + scale * code. The anchor's height is that of the
  /// lines.
  void SetHeights(double base, double scale, double anchorHeight)
  {
    this->anchorCode = static_cast<float>(std::clamp(
      (anchorHeight - base) / scale, 0.0, static_cast<double>(this->heights.maximumCode)));
    this->codeScale = static_cast<Real>(scale);
    this->codeBase =
      static_cast<Real>(base + scale * static_cast<double>(this->anchorCode) - anchorHeight);
  }

  Path MakePath(const GlobeRay<Real>& ray) const;
  /// Distances at which a path meets a shell; x > y if it does not.
  Vec2 MeetShell(const Path& path, const Vec3& shell) const;
  /// x: distance from the axis; y: how much farther that is than the anchor's.
  Vec2 OffAxis(const Path& path, Real t) const;
  Real North(const Path& path, const Vec4& row, Real t, Real off) const
  {
    return row.z + (path.Origin.z + t * path.Direction.z) * row.y - off * row.x;
  }
  Real Above(const Path& path, const Vec4& row, Real t, Real off) const
  {
    return row.w + (path.Origin.z + t * path.Direction.z) * row.x + off * row.y;
  }
  /// Distance east of a meridian's plane, and along it from the axis.
  Vec2 East(const Path& path, const Vec2& column, Real t) const
  {
    const Real x = path.Origin.x + t * path.Direction.x;
    const Real y = path.Origin.y + t * path.Direction.y;
    return { y * column.y - x * column.x, x * column.y + y * column.x };
  }
  /// Distance at which a path crosses a meridian in its own direction.
  Real ColumnCrossing(const Path& path, const Vec2& column) const;
  /// Distance from t on at which a path crosses a parallel to the north or south.
  Real RowCrossing(const Path& path, const Vec4& row, Real t, bool north) const;
  GlobeFence Fence(const Step& at) const;
  /// The coarsest level that is stepped through.
  int Top() const
  {
    return std::min(this->lines->Top, this->pyramid->LevelCount());
  }
  /// True for nodes, and for what lies outside of a partial raster.
  static bool IsWide(const Step& at)
  {
    return at.Level > 0 || at.Node.x < 0 || at.Node.y < 0;
  }
  Step FirstStep(const Path& path, Real t) const;
  Span NodeSpan(const Path& path, const Step& at, const GlobeFence& fence) const;
  Step Across(const Path& path, const Step& at, const Span& span, const GlobeFence& fence) const;
  Step Down(const Path& path, const Step& at, Real t) const;
  /// Least and greatest height, less the anchor's, that a path may have at t.
  Vec2 HeightNear(const Path& path, int row, Real t) const;
  /// True if the path may meet the node; then from is where from, and side as in MeetCell().
  bool VisitNode(
    const Path& path, const Step& at, const Span& span, int row, Real& from, Real& side) const;
  /// Height of a path in a cell less that of the surface, and the position in the cell.
  Real Difference(
    const Path& path, glm::ivec2 cell, const glm::vec4& codes, Real t, Vec2& fraction) const;
  /// side: the sign of the difference where the path left the cell before, 0 if not known.
  Meeting MeetCell(const Path& path, const Step& at, Real end, Real& side) const;
  /// The hit where a path meets a cell, its root refined. None where only the parabola dips
  /// through the surface; then T is where the path leaves the cell.
  Hit Refine(const Path& path, glm::ivec2 cell, const Meeting& meeting) const;
  /// The first point of the surface on a part of a ray that is within the shells. Where there is
  /// none, T is 0, or beyond Begin where the path is to go on.
  Hit TracePart(const Path& path) const;
  /// The first point of the surface on a ray.
  Hit Trace(const GlobeRay<Real>& ray) const;
};

template <typename Real, typename Texel>
GlobePath<Real> GlobeTraversal<Real, Texel>::MakePath(const GlobeRay<Real>& ray) const
{
  const Vec3& o = ray.Origin;
  const Vec3& d = ray.Direction;
  Path path;
  path.Origin = { this->lines->Radius + o.x, o.y, o.z };
  path.Direction = d;
  path.Squares = { (this->lines->Radius + path.Origin.x) * o.x + o.y * o.y,
    path.Origin.x * d.x + o.y * d.y, d.x * d.x + d.y * d.y };
  path.East = path.Origin.x * d.y - o.y * d.x >= 0;
  path.Sag = this->lines->Curvature * (path.Squares.z + d.z * d.z);
  path.Begin = ray.Begin;
  path.End = ray.End;
  return path;
}

template <typename Real, typename Texel>
glm::vec<2, Real> GlobeTraversal<Real, Texel>::MeetShell(const Path& path, const Vec3& shell) const
{
  const Real z = path.Origin.z;
  const Real dz = path.Direction.z;
  const Real c = shell.z + path.Squares.x * shell.x + z * (2 * this->lines->Axis + z) * shell.y;
  const Real b = path.Squares.y * shell.x + (this->lines->Axis + z) * dz * shell.y;
  const Real a = path.Squares.z * shell.x + dz * dz * shell.y;
  const Real discriminant = b * b - a * c;
  if (!(discriminant > 0))
  {
    return { 1, 0 };
  }
  const Real q = b < 0 ? std::sqrt(discriminant) - b : -std::sqrt(discriminant) - b;
  return { std::min(q / a, c / q), std::max(q / a, c / q) };
}

template <typename Real, typename Texel>
glm::vec<2, Real> GlobeTraversal<Real, Texel>::OffAxis(const Path& path, Real t) const
{
  const Real x = path.Origin.x + t * path.Direction.x;
  const Real y = path.Origin.y + t * path.Direction.y;
  const Real r = std::sqrt(x * x + y * y);
  const Real squares = path.Squares.x + t * (2 * path.Squares.y + t * path.Squares.z);
  return { r, squares / std::max(r + this->lines->Radius, Real(1e-20)) };
}

template <typename Real, typename Texel>
Real GlobeTraversal<Real, Texel>::ColumnCrossing(const Path& path, const Vec2& column) const
{
  const Real east = path.Origin.y * column.y - path.Origin.x * column.x;
  const Real change = path.Direction.y * column.y - path.Direction.x * column.x;
  return (path.East ? change > 0 : change < 0) ? -east / change : Real(kGlobeNever);
}

// q sin = g + k t and q^2 + 2 Radius q = Squares are a quadratic in t, a t^2 + 2 b t + c = 0. At a
// root a t + b = r sin * d(north)/dt, so that the sign before the root tells north from south. Its
// discriminant is sin^2 times what is called inner here, which does not cancel near the equator.
template <typename Real, typename Texel>
Real GlobeTraversal<Real, Texel>::RowCrossing(
  const Path& path, const Vec4& row, Real t, bool north) const
{
  const Real s = row.x;
  const Real radius = this->lines->Radius;
  const Vec3& m = path.Squares;
  const Real g = row.z + path.Origin.z * row.y;
  const Real k = path.Direction.z * row.y;
  const Real a = k * k - s * s * m.z;
  const Real inner1 = radius * k - s * m.y;
  const Real inner2 = 2 * radius * g - s * m.x;
  const Real b = g * k + s * inner1;
  const Real c = g * g + s * inner2;
  const Real inner = inner1 * inner1 + k * (k * m.x - 2 * g * m.y) + m.z * (g * g + s * inner2);
  const bool towardsPole = north == (s > 0);
  if (row.y == 0 || (a >= 0 ? !(north ? k > 0 : k < 0) : towardsPole && !(inner > 0)))
  {
    return Real(kGlobeNever); // a pole, the other way only, or past beside the cone
  }
  // without root where there must be one, the ray is at the middle
  const Real root = (north ? s : -s) * std::sqrt(std::max(inner, Real(0)));
  const Real sum = root - b;
  const Real rest = -root - b;
  const Real at = std::abs(sum) >= std::abs(rest) ? sum / a : c / rest;
  // on the far nappe of the cone, or beyond the middle of its chord already
  const bool far =
    a < 0 && ((radius * s + g - k * (b / a)) * s < 0 || (towardsPole && a * t + b < 0));
  return far ? Real(kGlobeNever) : std::max(at, t);
}

template <typename Real, typename Texel>
GlobeFence GlobeTraversal<Real, Texel>::Fence(const Step& at) const
{
  const glm::ivec2 first = at.Node * (1 << at.Level); // below 0 outside of the grid
  return { first, glm::min(first + (1 << at.Level), this->lines->Cells) };
}

template <typename Real, typename Texel>
GlobeStep<Real> GlobeTraversal<Real, Texel>::FirstStep(const Path& path, Real t) const
{
  const GlobeLines<Real>& grid = *this->lines;
  Step at{ { -1, -1 }, this->Top(), t };
  const Real angle =
    std::atan2(path.Origin.y + t * path.Direction.y, path.Origin.x + t * path.Direction.x);
  Real column = grid.AnchorFraction + angle * grid.PerStep + Real(grid.AnchorCell);
  column -= grid.Turn * std::floor(column / grid.Turn);
  const int cell = static_cast<int>(column);
  if (cell < grid.Cells.x || grid.Joined)
  {
    at.Node.x = std::min(cell, grid.Cells.x - 1) >> at.Level;
  }
  const Real off = this->OffAxis(path, t).y;
  if (this->North(path, grid.Rows[static_cast<std::size_t>(grid.Cells.y)], t, off) > 0 &&
    grid.Rows[static_cast<std::size_t>(grid.Cells.y)].y > 0)
  {
    at.Node.y = -2;
    return at;
  }
  // rows of nodes are few
  while (((at.Node.y + 1) << at.Level) < grid.Cells.y &&
    (this->North(path, grid.Rows[static_cast<std::size_t>(at.Node.y + 1) << at.Level], t, off) >=
        0 ||
      grid.Rows[static_cast<std::size_t>(at.Node.y + 1) << at.Level].y == 0))
  {
    ++at.Node.y;
  }
  return at;
}

template <typename Real, typename Texel>
GlobeSpan<Real> GlobeTraversal<Real, Texel>::NodeSpan(
  const Path& path, const Step& at, const GlobeFence& fence) const
{
  const GlobeLines<Real>& grid = *this->lines;
  const auto column = [&grid](int i) { return grid.Columns[static_cast<std::size_t>(i)]; };
  const auto row = [&grid](int j) { return grid.Rows[static_cast<std::size_t>(j)]; };
  Span span{ Real(kGlobeNever), 0, false };
  if (at.Node.x >= 0)
  {
    span.T = this->ColumnCrossing(path, column(path.East ? fence.Last.x : fence.First.x));
  }
  else
  {
    const Vec2 line = column(path.East ? 0 : grid.Cells.x);
    const Real east = this->East(path, line, at.T).x;
    span.T =
      (path.East ? east < 0 : east > 0) ? this->ColumnCrossing(path, line) : Real(kGlobeNever);
  }
  span.T = std::max(span.T, at.T);
  if (at.Node.y != -2)
  {
    const Real north = this->RowCrossing(path, row(at.Node.y >= 0 ? fence.Last.y : 0), at.T, true);
    span.Side = north < span.T ? 1 : span.Side;
    span.T = std::min(span.T, north);
  }
  if (at.Node.y != -1)
  {
    const Real south =
      this->RowCrossing(path, row(at.Node.y >= 0 ? fence.First.y : grid.Cells.y), at.T, false);
    span.Side = south < span.T ? 2 : span.Side;
    span.T = std::min(span.T, south);
  }
  span.Ends = span.T >= path.End;
  span.T = std::min(span.T, path.End);
  return span;
}

template <typename Real, typename Texel>
GlobeStep<Real> GlobeTraversal<Real, Texel>::Across(
  const Path& path, const Step& at, const Span& span, const GlobeFence& fence) const
{
  const GlobeLines<Real>& grid = *this->lines;
  Step next{ at.Node, at.Level, span.T };
  int line = 0;
  if (span.Side == 0)
  {
    const bool inside = at.Node.x >= 0;
    line = inside ? (path.East ? fence.Last.x : fence.First.x) : (path.East ? 0 : grid.Cells.x);
    const bool border = inside && line == (path.East ? grid.Cells.x : 0);
    line = border && grid.Joined ? grid.Cells.x - line : line;
    next.Node.x = border && !grid.Joined ? -1 : (path.East ? line : line - 1) >> at.Level;
  }
  else
  {
    const bool north = span.Side == 1;
    const bool inside = at.Node.y >= 0;
    line = inside ? (north ? fence.Last.y : fence.First.y) : (north ? 0 : grid.Cells.y);
    const bool border = inside && line == (north ? grid.Cells.y : 0);
    next.Node.y = border ? (north ? -2 : -1) : (north ? line : line - 1) >> at.Level;
  }
  if (((line >> at.Level) & 1) == 0 && at.Level < this->Top())
  {
    next.Node = { next.Node.x < 0 ? next.Node.x : next.Node.x >> 1,
      next.Node.y < 0 ? next.Node.y : next.Node.y >> 1 };
    ++next.Level;
  }
  return next;
}

template <typename Real, typename Texel>
GlobeStep<Real> GlobeTraversal<Real, Texel>::Down(const Path& path, const Step& at, Real t) const
{
  const GlobeLines<Real>& grid = *this->lines;
  Step next{ at.Node << 1, at.Level - 1, t };
  const glm::ivec2 middle = (next.Node + 1) << next.Level;
  if (middle.x < grid.Cells.x)
  {
    next.Node.x +=
      this->East(path, grid.Columns[static_cast<std::size_t>(middle.x)], t).x >= 0 ? 1 : 0;
  }
  if (middle.y < grid.Cells.y)
  {
    const Real off = this->OffAxis(path, t).y;
    next.Node.y +=
      this->North(path, grid.Rows[static_cast<std::size_t>(middle.y)], t, off) >= 0 ? 1 : 0;
  }
  return next;
}

template <typename Real, typename Texel>
glm::vec<2, Real> GlobeTraversal<Real, Texel>::HeightNear(const Path& path, int row, Real t) const
{
  const GlobeLines<Real>& grid = *this->lines;
  const Vec4& line = grid.Rows[static_cast<std::size_t>(row)];
  const Real off = this->OffAxis(path, t).y;
  const Real north = this->North(path, line, t, off);
  const Real above = this->Above(path, line, t, off);
  const Real radius = grid.Curves[static_cast<std::size_t>(row)].x + grid.Height + above;
  const Real drop = north * north / (std::sqrt(north * north + radius * radius) + radius);
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon() *
    (std::abs(off) + std::abs(line.w) + std::abs(path.Origin.z + t * path.Direction.z) +
      std::abs(t) * glm::dot(glm::abs(path.Direction), Vec3(1)));
  const Real slack = grid.Spread * drop + rounding;
  return { above + drop - slack, above + drop + slack };
}

template <typename Real, typename Texel>
bool GlobeTraversal<Real, Texel>::VisitNode(
  const Path& path, const Step& at, const Span& span, int row, Real& from, Real& side) const
{
  const auto& extremes = this->pyramid->At(at.Node, at.Level);
  const float bias = static_cast<float>(this->heights.bias) + this->anchorCode;
  const Real highest =
    this->codeBase + this->codeScale * Real(static_cast<float>(extremes.Maximum) - bias);
  const Real lowest =
    this->codeBase + this->codeScale * Real(static_cast<float>(extremes.Minimum) - bias);
  const Vec2 begin = this->HeightNear(path, row, at.T);
  const Vec2 end = this->HeightNear(path, row, span.T);
  const Real length = span.T - at.T;
  const Real change = end.x - begin.x;
  const Real sag = Real(0.5) * path.Sag * length * length;
  // the parabola through both lower bounds is lowest between them, or at one
  const Real least = std::abs(change) < sag
    ? begin.x + Real(0.5) * change - Real(0.25) * (sag + change * change / sag)
    : std::min(begin.x, end.x);
  from = at.T;
  // float may round the place of a path past flat ground: one that came to the node from above and
  // is below all of it met the surface there, and the cell there is to say so
  if ((side > 0 && begin.y < lowest) || (side < 0 && begin.x > highest))
  {
    return true;
  }
  if (!(least <= highest && std::max(begin.y, end.y) >= lowest))
  {
    return false;
  }
  // from where the parabola's tangent meets the highest, or the chord the lowest
  const Real fall = begin.x > highest ? (begin.x - highest) / (sag - change) : Real(0);
  const Real rise = begin.y < lowest ? (lowest - begin.y) / (end.y - begin.y) : Real(0);
  from = at.T + std::min(std::max(std::max(fall, rise), Real(0)), Real(1)) * length;
  // what comes from above or below all of the node is on that side there
  side = begin.x > highest ? Real(1) : (begin.y < lowest ? Real(-1) : side);
  return true;
}

template <typename Real, typename Texel>
Real GlobeTraversal<Real, Texel>::Difference(
  const Path& path, glm::ivec2 cell, const glm::vec4& codes, Real t, Vec2& fraction) const
{
  const GlobeLines<Real>& grid = *this->lines;
  const Vec4& line = grid.Rows[static_cast<std::size_t>(cell.y)];
  const Vec4& curve = grid.Curves[static_cast<std::size_t>(cell.y)];
  const Real off = this->OffAxis(path, t).y;
  const Real north = this->North(path, line, t, off);
  const Real above = this->Above(path, line, t, off);
  const Real radius = curve.x + grid.Height + above;
  // a normal's foot at d north of the line: the integrals of M cos and M sin with M to d^2, less
  // those of a circle
  Vec2 move(0);
  Real d = 0;
  for (int i = 0; i < 3; ++i)
  {
    d = GlobeAngle((north - move.x) / (radius - move.y));
    move = { d * d * (curve.y * (Real(0.5) - Real(0.125) * d * d) + curve.z * d * Real(1.0 / 6.0)),
      -d * d * d * (curve.y * Real(1.0 / 3.0) + curve.z * d * Real(0.125)) };
  }
  const Vec2 foot(north - move.x, radius - move.y);
  const Real height =
    above - move.y + foot.x * foot.x / (std::sqrt(foot.x * foot.x + foot.y * foot.y) + foot.y);
  const Vec2 east = this->East(path, grid.Columns[static_cast<std::size_t>(cell.x)], t);
  fraction =
    glm::clamp(Vec2(GlobeAngle(east.x / std::max(east.y, Real(1e-20))) * grid.PerStep, d * curve.w),
      Real(0), Real(1));
  const Real south = Real(codes.x) * (1 - fraction.x) + Real(codes.y) * fraction.x;
  const Real northern = Real(codes.z) * (1 - fraction.x) + Real(codes.w) * fraction.x;
  return height - this->codeBase -
    this->codeScale * (south * (1 - fraction.y) + northern * fraction.y);
}

template <typename Real, typename Texel>
GlobeMeeting<Real> GlobeTraversal<Real, Texel>::MeetCell(
  const Path& path, const Step& at, Real end, Real& side) const
{
  Meeting meeting;
  const glm::vec4 raw = this->heights.CellCodes(at.Node);
  if (!glm::all(glm::greaterThanEqual(raw, glm::vec4(0.0f))))
  {
    side = 0;
    return meeting;
  }
  const glm::vec4 codes = raw - this->anchorCode;
  meeting.Begin = at.T;
  meeting.Length = end - at.T;
  Vec2 fraction;
  const Real last = this->Difference(path, at.Node, codes, end, fraction);
  const Real middle =
    this->Difference(path, at.Node, codes, at.T + Real(0.5) * meeting.Length, fraction);
  const Real first = this->Difference(path, at.Node, codes, at.T, fraction);
  // a change of sign on the line between two cells is a hit on it
  meeting.Between = side * first < 0;
  meeting.A = 2 * (first + last - 2 * middle);
  meeting.B = last - first - meeting.A;
  meeting.C = first;
  meeting.Front = side != 0 ? side > 0 : first > 0 || (first == 0 && meeting.B <= 0);
  meeting.Part = meeting.Between ? Real(0) : FirstRoot(first, last, meeting.A);
  side = last > 0 ? Real(1) : (last < 0 ? Real(-1) : Real(0));
  return meeting;
}

template <typename Real, typename Texel>
GlobeHit<Real> GlobeTraversal<Real, Texel>::Refine(
  const Path& path, glm::ivec2 cell, const Meeting& meeting) const
{
  const glm::vec4 codes = this->heights.CellCodes(cell) - this->anchorCode;
  Hit hit;
  const Real t = RefineGlobeRoot(
    meeting, [&](Real at) { return this->Difference(path, cell, codes, at, hit.Fraction); });
  hit.Found = t >= 0;
  hit.T = meeting.Begin + (hit.Found ? t : Real(1)) * meeting.Length;
  hit.Cell = cell;
  hit.Front = meeting.Front;
  return hit;
}

template <typename Real, typename Texel>
GlobeHit<Real> GlobeTraversal<Real, Texel>::TracePart(const Path& path) const
{
  Hit hit;
  const Vec2 begin =
    Vec2(path.Origin.x, path.Origin.y) + path.Begin * Vec2(path.Direction.x, path.Direction.y);
  // on the axis a path is on all meridians, a millimetre on it is beside one
  const Real off = begin == Vec2(0) ? Real(1e-3) / glm::length(path.Direction) : Real(0);
  Step at = this->FirstStep(path, path.Begin + off);
  // Lines ahead are crossed once at each level, and a level is gone down for each crossed.
  const int most = 8 * (this->lines->Cells.x + this->lines->Cells.y) + 64;
  Real side = 0;
  bool ended = false;
  int crossings = 0;
  while (!ended && crossings < most)
  {
    ++crossings;
    const GlobeFence fence = this->Fence(at);
    const Span span = this->NodeSpan(path, at, fence);
    Real from = at.T;
    bool down = false;
    if (IsWide(at))
    {
      down = at.Node.x >= 0 && at.Node.y >= 0 &&
        this->VisitNode(path, at, span, (fence.First.y + fence.Last.y) >> 1, from, side);
      // down in the node the ray is where it left the last cell, or above or below all of it
      side = down ? side : Real(0);
    }
    else
    {
      const Meeting meeting = this->MeetCell(path, at, span.T, side);
      hit = meeting.Part >= 0 ? this->Refine(path, at.Node, meeting) : Hit();
    }
    ended = hit.Found || hit.T > path.Begin || (span.Ends && !down);
    at = down ? this->Down(path, at, from) : this->Across(path, at, span, fence);
  }
  hit.Crossings = crossings;
  return hit;
}

template <typename Real, typename Texel>
GlobeHit<Real> GlobeTraversal<Real, Texel>::Trace(const GlobeRay<Real>& ray) const
{
  Hit hit;
  const Path whole = this->MakePath(ray);
  const Vec2 outer = this->MeetShell(whole, this->lines->Outer);
  if (!(outer.x < outer.y) || this->pyramid->LevelCount() < 1)
  {
    return hit;
  }
  // heights are convex: what lies deeper than the lowest is one part of the ray
  const Vec2 inner = this->MeetShell(whole, this->lines->Inner);
  const bool dives = inner.x < inner.y;
  const Real first = std::max(whole.Begin, outer.x);
  const Real second = std::max(first, inner.y);
  Path path = whole;
  path.Begin = first;
  int crossings = 0;
  int part = 0;
  for (int i = 0; i < kGlobeSteps && part < 2; ++i)
  {
    path.End = std::min(whole.End, part == 0 && dives ? inner.x : outer.y);
    bool goesOn = false;
    if (path.Begin < path.End)
    {
      hit = this->TracePart(path);
      crossings += hit.Crossings;
      goesOn = !hit.Found && hit.T > path.Begin;
    }
    part += goesOn ? 0 : (hit.Found || !dives ? 2 : 1);
    path.Begin = goesOn ? hit.T : second;
  }
  hit.Crossings = crossings;
  return hit;
}
}

#endif
