// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The one answer to "what does this line meet" on the CPU: rays against a surface, in double
 * precision, through the surface's min-max pyramid.
 */
#ifndef terrain_RayQuery_h
#define terrain_RayQuery_h

#include "core/grid/Constants.h"
#include "core/rays/QueryRay.h"
#include "core/rays/SurfacePath.h"
#include "core/surface/Surface.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>

namespace terrain
{
/// Where a ray meets a surface.
struct SurfaceHit
{
  bool Found = false;
  /// In lengths of the ray's direction.
  double Distance = kNaN;
  /// The cell, and the position within it, 0 <= Fraction <= 1.
  glm::i64vec2 Cell{ -1, -1 };
  glm::dvec2 Fraction{ 0.0, 0.0 };
  /// Height of the hit in height units, not exaggerated.
  double Height = kNaN;
  /// Unit normal of the drawn surface in model coordinates: upward on bilinear patches, outward on
  /// columns and on the walls of a block.
  glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
  /// True if the ray comes from the side to which the normal points.
  bool FromAbove = true;
  /// The plane of the surface that cuts the block here; -1 where the surface itself is hit.
  int Wall = -1;
};

/// The point of a surface that is highest above a ray, or least below it.
struct SurfaceSummit
{
  /// Vertical distance from the ray up to the surface, in height units; -infinity if the ray passes
  /// over no surface.
  double Height = -kInfinity;
  /// Where: in lengths of the ray's direction.
  double Distance = kNaN;
};

/**
 * Queries of one surface. Immutable: all methods may be called from many threads at once. The
 * surface is copied, its heights are shared.
 *
 * Method: as core/rays/PyramidTraversal.h, in double precision and for bent rays. A ray goes down a
 * level of the pyramid where its heights in a node meet those of the surface, and crosses the node
 * where they do not. Each cell solves the quadratic of the ray's height minus the patch's. The
 * difference has the same sign on both sides of a line between cells, and a change of sign is a
 * hit: no ray slips between cells. Heights are taken relative to that of the ray's origin.
 *
 * Error: that of double arithmetic. The position of a hit is right to kQueryError of the largest
 * coordinate in cells of the grid and of the ray's ends. A ray that starts on the surface hits at
 * its start. A cell includes its border: so does the surface at the border of the grid and of
 * holes. A ray that passes a corner of a hole in one point only may meet or miss it.
 *
 */
class RayQuery
{
public:
  explicit RayQuery(Surface surface);

  const Surface& GetSurface() const
  {
    return this->Queried;
  }

  /// The first point of the surface, or of a wall of its block, on a ray. Both sides are met. A ray
  /// that is not finite, or has no direction, meets nothing.
  SurfaceHit First(const QueryRay& ray) const;

  /// True if a ray meets the surface, or a wall of its block, anywhere.
  bool Any(const QueryRay& ray) const;

  /// The point of the surface that is highest above a ray, planes and blocks aside: the line is
  /// free if that is below 0, and by how much. The ends of a vertical ray must be finite.
  SurfaceSummit Highest(const QueryRay& ray) const;

  /// Calls visit for every stretch of the straight way between two positions in model coordinates,
  /// in order and without gaps: the surface above each is a parabola of the part of the way, 0 to 1
  /// (core/rays/SurfacePath.h), level on columns. z and planes do not count. O(cells crossed).
  /// False if a position is not finite.
  bool Along(const glm::dvec3& from, const glm::dvec3& to,
    const std::function<void(const SurfacePiece&)>& visit) const;

  /// Height of the surface at a position in model coordinates, in height units; NaN outside and
  /// where there is no surface.
  double HeightAt(double x, double y) const;

private:
  Surface Queried;
};

/// Error of the position of a hit, see above.
constexpr double kQueryError = 1e-13;
}

#endif
