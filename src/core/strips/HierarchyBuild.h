// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The preprocess: nested object-space errors, nested radii, and gradients of a heightfield.
 *
 * What is bounded. The surface is the bilinear patch of every cell (Coordinates.h). For a triangle
 * T of the hierarchy let E(T) be the largest |h(p) - T(p)| over all points p of T, h bilinear, T(p)
 * the plane through its three samples. The error of a vertex v is at least E of both triangles of
 * its diamond, and at least the error of each of its children (nested). So wherever refinement ends
 * above the finest triangles, the error that it tested bounds the distance of the bilinear surface
 * itself, not only that of the vertex which was left out. Half cells cannot be split; on them the
 * distance is |h00 + h11 - h10 - h01| / 4 at most and 0 on their edges along the grid.
 *
 *   Squares of up to 64 cells:
 *     E is computed over all samples of T. On whole cells the difference of a bilinear and a linear
 *     function has its extremes at the corners. On the cells that an edge of T cuts along their
 *     diagonal it is a parabola there, whose peak is taken.
 *   Larger squares, across the raster's border, and beside holes:
 *     E(T) <= |surface with v - surface without v| + the largest error of v's children, by the
 *     triangle inequality. A triangle of which part has no surface is not drawn at all, so that the
 *     drawn surface may end early by the triangle's diameter: that is the error then.
 *
 * The radius of a vertex is that of a sphere around it that holds its diamond, its corners, and the
 * spheres of its children, so it bounds the surface for culling and for the distance to the eye.
 * Source: Lindstrom and Pascucci 2002, sections 3 and 4; Balogh, section 4.5. Departure: their
 * incremental error |h(v) - mean of the hypotenuse| is no bound of the surface's distance.
 * A border that is kept has errors above all others: refinement goes down to every one of its
 * samples that can be seen, and what is beside it with the same samples fits without a gap.
 * Heights are rounded to float, and errors computed in float: see kHierarchyError.
 */
#ifndef terrain_HierarchyBuild_h
#define terrain_HierarchyBuild_h

#include "core/grid/ParallelFor.h"
#include "core/strips/Hierarchy.h"
#include "core/strips/HierarchyTarget.h"

#include <functional>
#include <string>

namespace terrain
{
/// What an error may be too low by, as a part of the largest absolute height.
constexpr double kHierarchyError = 1e-6;

/// Is told how much is done, 0 to 1; false stops the work.
using BuildProgress = std::function<bool(double)>;

/// The message of a build that its progress function stopped.
extern const char* const kBuildAborted;

/// Fills the target from the rows. Holds about 70 rows of the raster at a time besides the target.
/// Returns an error message, empty if all is well; the target's content is undefined else.
std::string BuildHierarchy(HierarchyTarget& target, const HeightRows& rows,
  const ParallelFor& parallelFor, const BuildProgress& progress);

/// The same, into main memory. The layout's size must be acceptable (HierarchyLayout::WhyNotSize).
std::string BuildHierarchy(MemoryHierarchy& hierarchy, std::int64_t width, std::int64_t height,
  const GridGeometry& geometry, const HeightRows& rows, const ParallelFor& parallelFor,
  const BuildProgress& progress, bool keepsBorder = false);
}

#endif
