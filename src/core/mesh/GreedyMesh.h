// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A triangle mesh of a heightfield within a vertical error at every sample, with few triangles.
 *
 * Source: Michael Garland and Paul S. Heckbert, "Fast Polygonal Approximation of Terrains and
 * Height Fields", 1995: greedy insertion into a Delaunay triangulation. The worst sample of a
 * triangle becomes a vertex, until no sample is farther from its triangle than the tolerance. Where
 * we depart from it:
 * - The grid is cut into tiles, which are independent of each other. The border of a tile is made
 *   first, sample by sample of its lines, so that neighbours have the same vertices there: no
 * crack, and no error beyond the tolerance on a border.
 * - Triangles wait in buckets of nearly equal error in place of a heap.
 * - Where four vertices lie on one circle both diagonals are Delaunay's; the one with the smaller
 *   error is taken before a vertex is spent.
 * - Holes: every sample that belongs to a cell with and a cell without a surface becomes a vertex.
 * Two such neighbours are always joined by an edge of the Delaunay triangulation, since the circle
 * over them holds no other sample. So no triangle crosses the border of a hole, and those inside of
 * holes are left out.
 */
#ifndef terrain_GreedyMesh_h
#define terrain_GreedyMesh_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace terrain
{
/// Tiles of a greedy mesh that chooses them.
constexpr int kFewTileCells = 128;
constexpr int kManyTileCells = 1024;
constexpr int kFewTileVertices = 64;

/// How to build a greedy mesh.
struct GreedyMeshOptions
{
  /// Largest vertical distance of a sample to the mesh, in height units, >= 0; 0: no sample is off
  /// but for rounding, so that only flat parts have fewer triangles than two a cell.
  double MaximumError = 1.0;
  /// Cells along a side of a tile, 1 to kMostTileCells (GreedyTile.h), or 0: kFewTileCells, whose
  /// tiles stay in a processor's cache, unless these come to fewer than kFewTileVertices each; then
  /// kManyTileCells, which save triangles. Many vertices take 2.3 times as long in large tiles.
  int CellsPerTile = 0;
};

/// What is kept back from the tolerance, and is the smallest tolerance, as a fraction of the
/// largest height: covers the rounding of planes.
constexpr double kMeshErrorSlack = 0x1p-44;

/// Triangles over samples of a grid.
struct GridMesh
{
  /// Column and row of the sample that each vertex is, each used by a triangle and listed once.
  std::vector<glm::ivec2> Vertices;
  /// Three vertices a triangle, counter-clockwise seen from above.
  std::vector<std::int32_t> Triangles;
};

/**
 * Builds the mesh of a view. It covers exactly the cells whose four samples have heights, with no
 * vertex inside of another triangle's edge. Empty where there is no such cell. Same result however
 * parallelFor splits its ranges. Error: FindMeshError() (MeshError.h)
 * <= max(MaximumError, 2 kMeshErrorSlack times the largest height). T: see SampleTypes.h.
 */
template <typename T>
GridMesh BuildGreedyMesh(
  const HeightfieldView<T>& view, const GreedyMeshOptions& options, const ParallelFor& parallelFor);

/// Edges with a triangle on one side only, two vertices each, the triangle to the left of the way
/// from the first to the second.
std::vector<glm::ivec2> FindBorderEdges(const GridMesh& mesh);
}

#endif
