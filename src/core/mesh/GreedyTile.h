// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One tile of a greedy mesh (GreedyMesh.h): a Delaunay triangulation of samples of a rectangle,
 * into which the worst sample of a triangle is inserted until no sample is worse than the
 * tolerance.
 *
 * Notation: vertices, triangles and half-edges are numbers from 0. Triangle t has the half-edges
 * 3t, 3t + 1 and 3t + 2, counter-clockwise (x east, y north); half-edge e begins at vertex
 * Origins[e] and is the other side of half-edge Twins[e], -1 on the tile's border. Positions are
 * whole samples, so that all predicates are exact in 64-bit integers for tiles of up to
 * kMostTileCells.
 */
#ifndef terrain_GreedyTile_h
#define terrain_GreedyTile_h

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace terrain
{
/// Most cells along a side of a tile: the determinant of InCircle() stays below 2^62.
constexpr int kMostTileCells = 4096;

/// Triangles that wait to be improved, roughly the worst first: 16 buckets for each factor of two
/// of error, so that putting in and taking out cost the same whatever waits.
class ErrorQueue
{
public:
  /// Only errors above the tolerance, > 0, are put in.
  explicit ErrorQueue(double tolerance);
  void Push(int triangle, double error);
  /// Takes out a triangle of the highest bucket; -1 if the queue is empty.
  int Pop();
  /// True if a triangle with this error belongs into the bucket of the last Pop().
  bool IsTop(double error) const
  {
    return this->BucketOf(error) == this->Highest;
  }

private:
  static constexpr int BucketCount = 64 * 16; ///< 64 octaves
  int BucketOf(double error) const;

  std::array<std::vector<int>, BucketCount> Buckets;
  double Tolerance;
  int Highest = -1;
};

class GreedyTile
{
public:
  /// Two triangles over width x height samples, each >= 2 and at most kMostTileCells + 1. heights:
  /// of sample (x, y) at x + width * y, in height units; NaN where nothing is asked of the surface.
  /// The vector is the caller's and must outlive the tile.
  GreedyTile(int width, int height, const std::vector<double>& heights);

  /// Inserts a sample wherever it lies; nothing happens if it is a vertex already.
  void Insert(const glm::ivec2& position);

  /// Inserts samples until none is farther than the tolerance (height units, >= 0) from the
  /// triangle it lies on, measured vertically.
  void Refine(double tolerance);

  const std::vector<glm::ivec2>& GetVertices() const
  {
    return this->Vertices;
  }
  /// Vertices of triangle t at 3 t, 3 t + 1, 3 t + 2; counter-clockwise seen from above.
  const std::vector<int>& GetTriangles() const
  {
    return this->Origins;
  }

private:
  struct Candidate
  {
    int Sample = -1; ///< x + Width * y, -1: none
    double Error = 0.0;
  };

  static int Next(int edge)
  {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
  }
  static int Previous(int edge)
  {
    return edge % 3 == 0 ? edge + 2 : edge - 1;
  }

  void SetTriangle(int triangle, int a, int b, int c, int twinAB, int twinBC, int twinCA);
  void Link(int edge, int twin);
  int NewTriangle();
  int Locate(const glm::ivec2& position) const;
  void InsertInto(int triangle, const glm::ivec2& position);
  void SplitTriangle(int triangle, int vertex);
  void SplitEdge(int edge, int vertex);
  void Legalize(int vertex);
  /// > 0 if the other diagonal of the two triangles at an edge is that of Delaunay, < 0 if the edge
  /// is or lies on the border, 0 if all four corners lie on one circle.
  std::int64_t Preference(int edge) const;
  void Flip(int edge);
  /// Flips an edge of a triangle if both diagonals are Delaunay's and the other has a smaller
  /// error.
  bool FlipIfBetter(int triangle);
  /// The plane of a triangle: height at one corner, and slopes per column and row.
  struct Plane
  {
    glm::ivec2 Origin;
    double Height;
    double X;
    double Y;
  };
  /// Makes a sample of a row, of columns begin to end, the worst one if it is.
  void ScanRow(int y, int begin, int end, const Plane& plane, Candidate& worst) const;
  /// The worst sample on the triangle between three vertices, borders included.
  Candidate FindWorst(std::array<int, 3> corners) const;
  double Height(int vertex) const;

  int Width;
  const std::vector<double>& Heights;
  std::vector<glm::ivec2> Vertices;
  std::vector<int> Origins;
  std::vector<int> Twins;
  std::vector<Candidate> Candidates; ///< of each triangle, once Refine() has begun
  std::vector<int> Pending;          ///< half-edges opposite the new vertex, to be made legal
  std::vector<int> Changed;          ///< triangles that the last insertion made or changed
  int Last = 0;                      ///< where Locate() begins
};
}

#endif
