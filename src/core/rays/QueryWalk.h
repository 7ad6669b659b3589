// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How core/rays/RayQuery.h walks a ray through the pyramid of a surface, in double precision. The
 * method is that of core/rays/PyramidTraversal.h.
 */
#ifndef terrain_QueryWalk_h
#define terrain_QueryWalk_h

#include "core/grid/Coordinates.h"
#include "core/rays/QueryCells.h"
#include "core/rays/QueryRay.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace terrain
{
/// A ray in grid coordinates and height units; see QueryRay.
struct GridQuery
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
  double Begin;
  double End;
  double Bend;

  GridQuery(const GridGeometry& frame, const QueryRay& ray)
    : Origin(frame.ToGrid(ray.Origin))
    , Direction(frame.DirectionToGrid(ray.Direction))
    , Begin(ray.Begin)
    , End(ray.End)
    , Bend(ray.Direction.x == 0.0 && ray.Direction.y == 0.0 ? 0.0 : ray.Bend)
  {
  }

  bool IsUsable() const
  {
    const double sum = glm::dot(this->Origin, glm::dvec3(1.0)) +
      glm::dot(this->Direction, glm::dvec3(1.0)) + this->Bend;
    return std::isfinite(sum) && this->Direction != glm::dvec3(0.0) && this->Begin <= this->End;
  }
  glm::dvec3 At(double distance) const
  {
    glm::dvec3 position = this->Origin + distance * this->Direction;
    position.z += this->Bend * distance * distance;
    return position;
  }
};

/// A part of a ray that no plane cuts away.
struct KeptPart
{
  double Begin;
  double End;
  int Wall; ///< the plane at which it begins, or -1
};

/// What planes leave of a ray, in order (Surface::Planes). A straight ray keeps one part at most, a
/// bent one may leave and come back.
std::vector<KeptPart> CutByPlanes(const GridQuery& ray, const std::vector<glm::dvec4>& planes);

/// Narrows begin..end to the rectangle of the grid, border included; false if nothing is left.
bool ClipToGrid(const GridQuery& ray, const glm::i64vec2& cells, double& begin, double& end);

/// Narrows begin..end to where a straight ray is within bounds of heights; false if that is
/// nowhere. A bent ray is left as it is.
bool ClipToHeights(const GridQuery& ray, const HeightBounds& bounds, double& begin, double& end);

/// True if a ray runs along a line between cells, in the plane of an axis: cells on both sides
/// count.
inline bool RunsAlongLine(const GridQuery& ray, int axis)
{
  return ray.Direction[axis] == 0.0 && std::floor(ray.Origin[axis]) == ray.Origin[axis];
}

/// A ray mirrored so that it runs north-east, with heights relative to that of its origin.
struct QueryPath
{
  glm::i64vec2 Mirror; ///< cell ^ Mirror takes cells to the grid and back: -1 or 0
  glm::i64vec2 First;  ///< range of the grid's cells, mirrored
  glm::i64vec2 Last;
  glm::dvec2 Origin;
  glm::dvec3 Direction; ///< x, y >= 0
  double Bend;
  double OriginHeight;
  double Slack; ///< above the rounding of heights on the ray
  double Begin;
  double End;

  /// mirrorStill: for axes along which the ray does not move, whether to mirror them: cells west,
  /// south of a line are met instead of those east, north.
  QueryPath(const SurfaceHeights& heights, const GridQuery& ray, double begin, double end,
    const glm::bvec2& mirrorStill);

  double HeightAt(double distance) const
  {
    return distance * (this->Direction.z + distance * this->Bend);
  }
  glm::dvec2 PositionAt(double distance) const
  {
    return this->Origin + distance * glm::dvec2(this->Direction);
  }
  /// Lowest and highest the ray gets between two distances.
  HeightBounds HeightsBetween(double begin, double end) const;
  /// Distance at which the ray crosses a mirrored line; infinity if it does not move.
  double LineDistance(int axis, std::int64_t line) const
  {
    return this->Direction[axis] == 0.0
      ? kInfinity
      : (static_cast<double>(line) - this->Origin[axis]) / this->Direction[axis];
  }
};

/// Where a walk is: a mirrored cell, and the node over it.
struct QueryStep
{
  glm::i64vec2 Cell;
  int Level;
  double Distance;
  int Line; ///< the line it stands on: 0 none, 1 runs north-south, 2 east-west
};

/// The part of a ray in a node.
struct QuerySpan
{
  glm::i64vec2 LastCell; ///< of the node, where the ray leaves
  bool CrossEast;        ///< leaves through the east side, else through the north side
  bool Ends;             ///< the ray ends in the node
  double Distance;       ///< where it leaves

  QuerySpan(const QueryPath& path, const QueryStep& at);
};

/// The next step: down to a level at a distance within the span.
QueryStep StepDown(
  const QueryPath& path, const QueryStep& at, const QuerySpan& span, int level, double distance);
/// The next step: into the next node; a level up if the line between them is that of a parent too.
QueryStep StepAcross(
  const SurfaceHeights& heights, const QueryPath& path, const QueryStep& at, const QuerySpan& span);

/// The part of a path in a cell.
CellSegment SegmentIn(
  const SurfaceHeights& heights, const QueryPath& path, const QueryStep& at, const QuerySpan& span);

/// Calls finder.VisitCell(cell, segment, begin, end) for the cells of a path in order until it
/// returns true. Nodes where finder.Meets(bounds, begin, end) is false are passed at once; bounds
/// are relative to the height of the ray's origin; Meets may move begin on to where the node
/// matters.
template <typename Finder>
void WalkCells(const SurfaceHeights& heights, const QueryPath& path, Finder& finder)
{
  const glm::dvec2 start = path.PositionAt(path.Begin);
  QueryStep at{ glm::clamp(glm::i64vec2(glm::floor(start)), path.First, path.Last),
    heights.LastLevel(), path.Begin, 0 };
  for (bool ended = false; !ended;)
  {
    const QuerySpan span(path, at);
    bool down = false;
    double begin = at.Distance;
    if (at.Level > 0)
    {
      HeightBounds bounds = heights.NodeBounds(
        glm::i64vec2(at.Cell.x >> at.Level, at.Cell.y >> at.Level) ^ path.Mirror, at.Level);
      bounds.Low -= path.OriginHeight;
      bounds.High -= path.OriginHeight;
      down = !bounds.IsEmpty() && finder.Meets(bounds, begin, span.Distance);
    }
    else
    {
      ended = finder.VisitCell(
        at.Cell ^ path.Mirror, SegmentIn(heights, path, at, span), at.Distance, span.Distance);
    }
    ended = ended || (span.Ends && !down);
    at = down ? StepDown(path, at, span, at.Level > heights.FirstLevel() ? at.Level - 1 : 0, begin)
              : StepAcross(heights, path, at, span);
  }
}
}

#endif
