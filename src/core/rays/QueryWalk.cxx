// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/QueryWalk.h"

#include "core/rays/Ray.h"

namespace terrain
{
namespace
{
/// Rounding of heights along a ray, as a part of the largest of them.
constexpr double kHeightRounding = 1e-12;

/// The stops of part of a ray, ascending: its ends, and the real roots of c + b t + a t^2 between
/// them.
std::vector<double> StopsOf(const KeptPart& part, double a, double b, double c)
{
  std::vector<double> stops{ part.Begin };
  const auto add = [&](double root)
  {
    if (root > stops.back() && root < part.End)
    {
      stops.push_back(root);
    }
  };
  const double discriminant = b * b - 4.0 * a * c;
  if (a == 0.0)
  {
    add(-c / b);
  }
  else if (discriminant >= 0.0)
  {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    add(std::min(q / a, c / q));
    add(std::max(q / a, c / q));
  }
  stops.push_back(part.End);
  return stops;
}

/// A distance between two others, either of which may be infinite.
double Between(double low, double high)
{
  if (std::isinf(high))
  {
    return std::isinf(low) ? 0.0 : low + 1.0;
  }
  return std::isinf(low) ? high - 1.0 : 0.5 * (low + high);
}

/// Appends what a plane leaves of a part of a ray.
void CutPart(const GridQuery& ray, const glm::dvec4& plane, int wall, const KeptPart& part,
  std::vector<KeptPart>& kept)
{
  const double a = plane.z * ray.Bend;
  const double b = glm::dot(glm::dvec3(plane), ray.Direction);
  const double c = glm::dot(plane, glm::dvec4(ray.Origin, 1.0));
  const auto above = [&](double distance) { return c + distance * (b + distance * a); };
  const std::vector<double> stops = StopsOf(part, a, b, c);
  // a ray that begins on the plane and runs inside has been cut there by someone else
  const bool enters = above(part.Begin) == 0.0 && b + 2.0 * a * part.Begin > 0.0;
  int first = enters ? wall : part.Wall;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    if (above(Between(stops[i], stops[i + 1])) >= 0.0)
    {
      kept.push_back({ stops[i], stops[i + 1], i == 0 ? first : wall });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<KeptPart> CutByPlanes(const GridQuery& ray, const std::vector<glm::dvec4>& planes)
{
  std::vector<KeptPart> parts{ { ray.Begin, ray.End, -1 } };
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    std::vector<KeptPart> kept;
    for (const KeptPart& part : parts)
    {
      CutPart(ray, planes[i], static_cast<int>(i), part, kept);
    }
    parts = std::move(kept);
  }
  return parts;
}

//------------------------------------------------------------------------------
bool ClipToGrid(const GridQuery& ray, const glm::i64vec2& cells, double& begin, double& end)
{
  return ClipToRange(
           ray.Origin.x, ray.Direction.x, 0.0, static_cast<double>(cells.x), begin, end) &&
    ClipToRange(ray.Origin.y, ray.Direction.y, 0.0, static_cast<double>(cells.y), begin, end) &&
    std::isfinite(begin) && std::isfinite(end);
}

//------------------------------------------------------------------------------
bool ClipToHeights(const GridQuery& ray, const HeightBounds& bounds, double& begin, double& end)
{
  if (bounds.IsEmpty())
  {
    return false;
  }
  const double slack =
    kHeightRounding * (std::abs(ray.Origin.z) + std::abs(bounds.Low) + std::abs(bounds.High));
  return ray.Bend != 0.0 ||
    ClipToRange(ray.Origin.z, ray.Direction.z, bounds.Low - slack, bounds.High + slack, begin, end);
}

//------------------------------------------------------------------------------
QueryPath::QueryPath(const SurfaceHeights& heights, const GridQuery& ray, double begin, double end,
  const glm::bvec2& mirrorStill)
  : Origin(ray.Origin)
  , Direction(ray.Direction)
  , Bend(ray.Bend)
  , OriginHeight(ray.Origin.z)
  , Begin(begin)
  , End(end)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const bool mirror =
      this->Direction[axis] < 0.0 || (this->Direction[axis] == 0.0 && mirrorStill[axis]);
    this->Mirror[axis] = mirror ? -1 : 0;
    this->Origin[axis] = mirror ? -this->Origin[axis] : this->Origin[axis];
    this->Direction[axis] = std::abs(this->Direction[axis]);
  }
  const glm::i64vec2 cells = heights.CellCount();
  this->First = this->Mirror * cells;
  this->Last = this->First + cells - std::int64_t{ 1 };
  const HeightBounds bounds = heights.Bounds();
  const HeightBounds own = this->HeightsBetween(begin, end);
  this->Slack = kHeightRounding *
    (std::abs(this->OriginHeight) + std::abs(bounds.Low) + std::abs(bounds.High) +
      std::max(std::abs(own.Low), std::abs(own.High)));
}

//------------------------------------------------------------------------------
HeightBounds QueryPath::HeightsBetween(double begin, double end) const
{
  const double first = this->HeightAt(begin);
  const double last = this->HeightAt(end);
  HeightBounds range{ std::min(first, last), std::max(first, last) };
  if (this->Bend != 0.0)
  {
    const double vertex =
      this->HeightAt(std::clamp(-this->Direction.z / (2.0 * this->Bend), begin, end));
    range = { std::min(range.Low, vertex), std::max(range.High, vertex) };
  }
  return range;
}

//------------------------------------------------------------------------------
QuerySpan::QuerySpan(const QueryPath& path, const QueryStep& at)
{
  const std::int64_t within = (std::int64_t{ 1 } << at.Level) - 1;
  this->LastCell = glm::min(at.Cell | within, path.Last);
  const glm::dvec2 leave(
    path.LineDistance(0, this->LastCell.x + 1), path.LineDistance(1, this->LastCell.y + 1));
  this->CrossEast = leave.x <= leave.y;
  const double distance = std::min(leave.x, leave.y);
  this->Ends = distance >= path.End;
  this->Distance = std::min(std::max(distance, at.Distance), path.End);
}

//------------------------------------------------------------------------------
QueryStep StepDown(
  const QueryPath& path, const QueryStep& at, const QuerySpan& span, int level, double distance)
{
  if (!(distance > at.Distance))
  {
    return { at.Cell, level, at.Distance, at.Line };
  }
  return { glm::clamp(glm::i64vec2(glm::floor(path.PositionAt(distance))), at.Cell, span.LastCell),
    level, distance, 0 };
}

//------------------------------------------------------------------------------
QueryStep StepAcross(
  const SurfaceHeights& heights, const QueryPath& path, const QueryStep& at, const QuerySpan& span)
{
  const glm::i64vec2 cell =
    glm::clamp(glm::i64vec2(glm::floor(path.PositionAt(span.Distance))), at.Cell, span.LastCell);
  const std::int64_t line = (span.CrossEast ? span.LastCell.x : span.LastCell.y) + 1;
  const int above = at.Level > 0 ? at.Level + 1 : heights.FirstLevel();
  const bool up = above <= heights.LastLevel() && (line & ((std::int64_t{ 1 } << above) - 1)) == 0;
  return { span.CrossEast ? glm::i64vec2(line, cell.y) : glm::i64vec2(cell.x, line),
    up ? above : at.Level, span.Distance, span.CrossEast ? 1 : 2 };
}

//------------------------------------------------------------------------------
CellSegment SegmentIn(
  const SurfaceHeights& heights, const QueryPath& path, const QueryStep& at, const QuerySpan& span)
{
  // Positions at a line are exactly 0 or 1: both cells that share it see the same heights.
  const auto fraction = [&](double distance, int line, double side)
  {
    const glm::dvec2 position =
      glm::clamp(path.PositionAt(distance) - glm::dvec2(at.Cell), glm::dvec2(0.0), glm::dvec2(1.0));
    const glm::dvec2 exact(line == 1 ? side : position.x, line == 2 ? side : position.y);
    return glm::mix(exact, 1.0 - exact, glm::notEqual(path.Mirror, glm::i64vec2(0)));
  };
  CellSegment segment;
  segment.Corners = heights.CellHeights(at.Cell ^ path.Mirror) - path.OriginHeight;
  segment.BeginXY = fraction(at.Distance, at.Line, 0.0);
  segment.EndXY = fraction(span.Distance, span.Ends ? 0 : (span.CrossEast ? 1 : 2), 1.0);
  segment.BeginZ = path.HeightAt(at.Distance);
  segment.EndZ = path.HeightAt(span.Distance);
  const double length = span.Distance - at.Distance;
  segment.Bend = path.Bend * length * length;
  return segment;
}
}
