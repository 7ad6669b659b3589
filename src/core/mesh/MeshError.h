// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far the samples of a heightfield lie from a mesh, whatever made it.
 */
#ifndef terrain_MeshError_h
#define terrain_MeshError_h

#include "core/grid/Coordinates.h"
#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"
#include "core/mesh/GreedyMesh.h"

namespace terrain
{
/**
 * Largest vertical distance, in height units, between the mesh and the samples that belong to a
 * cell with a surface; infinite if one of them is not covered. It looks at each triangle by itself.
 * rounded: null, or the geometry whose model coordinates hold vertices in 32 bits; then it is the
 * distance from the planes through the rounded vertices, which moves them by far less than a cell.
 */
template <typename T>
double FindMeshError(const HeightfieldView<T>& view, const GridMesh& mesh,
  const ParallelFor& parallelFor, const GridGeometry* rounded = nullptr);

/// How far a mesh may move when its model coordinates are rounded to 32 bits, if no triangle is
/// steeper than the steepest step between neighbours: x and y in cells, z vertically in height
/// units, what x and y do to it included.
template <typename T>
glm::dvec3 FindRoundingMargin(
  const HeightfieldView<T>& view, const GridGeometry& geometry, const ParallelFor& parallelFor);
}

#endif
