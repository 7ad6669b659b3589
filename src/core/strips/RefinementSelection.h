// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which vertices of a hierarchy take part in a mesh, found depth by depth; the strip follows
 * (RefinementStrip.h).
 *
 * A vertex v splits its diamond, two triangles that share the hypotenuse it halves. The diamond's
 * corners c0 to c3 are numbered so that its triangles are (Left, Apex, Right) = (c0, c1, c2) and
 * (c2, c3, c0), and its children e0 to e3 so that ek halves the edge from ck to ck+1.
 * A vertex m two depths below halves an edge from v to some ck. Its parents are the two vertices
 * whose triangles meet in that edge: ek and ek-1, both children of v. So each m is found from one v
 * alone, once, with both of its parents, and has the corners (ck, ek, v, ek-1). It is looked at if
 * both take part. Which they do is known of all of a depth before the next one, so vertices are
 * looked at in loops without branches that depend on them.
 *
 * A triangle that is split is known by a link, 2 x vertex + (0, or 1 for its second triangle).
 * Halves()[link] has the links of its left and right half; of halves that are not split it says
 * why.
 */
#ifndef terrain_RefinementSelection_h
#define terrain_RefinementSelection_h

#include "core/strips/RefinementBuffers.h"
#include "core/strips/RefinementFrame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace terrain
{
class ToleranceCounts;

/// What a triangle's link says if it is not split: it is drawn, or is not, or there is none.
struct UnsplitLink
{
  static constexpr std::uint32_t Drawn = 0;
  static constexpr std::uint32_t Hole = 1;
  static constexpr std::uint32_t Outside = 6;
  /// Links of triangles that are split are larger.
  static constexpr std::uint32_t Last = 7;
};

class RefinementSelection
{
public:
  using TriangleHalves = std::array<std::uint32_t, 2>;
  /// Number of the square's centre; its corners come before.
  static constexpr std::uint32_t Centre = 4;

  /// Makes the vertices of a mesh, in the memory of `vertices`.
  void MakeMesh(const RefinementFrame& frame, const SquareSites& square, bool morphing,
    std::vector<StripVertex>& vertices);
  /// Only counts triangles by the tolerance at which they appear, until there are enough.
  void Count(const RefinementFrame& frame, const SquareSites& square, ToleranceCounts& counts);

  /// Of the triangles of all vertices, by link.
  const TriangleHalves* Halves() const
  {
    return &this->Links[0];
  }
  /// Number of triangles, with those in holes.
  std::int64_t Triangles() const
  {
    return this->TriangleCount;
  }
  /// Makes the vertices of each sample one, and indices of vertices of numbers.
  void MergeSamples(std::vector<StripVertex>& vertices, std::vector<std::uint32_t>& strip);

private:
  /// A vertex that takes part.
  struct Node
  {
    /// Numbers of the diamond's corners.
    std::array<std::uint32_t, 4> Corners;
    /// Column and row, in steps of the depth.
    std::uint32_t Column;
    std::uint32_t Row;
    /// Where the first corner lies, in quarter turns.
    std::uint32_t Turn;
  };
  /// With detail: height of the base, and below the samples TriangleSite's twist.
  struct Ground
  {
    float Height;
    float Twist;
  };
  /// A vertex that is looked at.
  struct Place
  {
    /// 4 x v + k, for m on the edge from v to ck.
    std::uint32_t From;
    /// Column and row, in steps of the depth, and record.
    std::uint32_t Column;
    std::uint32_t Row;
    std::uint32_t Index;
  };
  template <typename Site>
  struct Found : Site
  {
    Place At;
    float Twist;
  };
  /// Vertices at a time, for what is known of them to stay in the first cache.
  static constexpr std::uint32_t Batch = 64;
  /// Vertices that are found from them at most.
  static constexpr std::size_t MostFound = std::size_t{ 4 } * Batch;

  void Select(const RefinementFrame& frame, const SquareSites& square);
  void BeginSquare(const SquareSites& square);
  template <typename Site, bool IsBelow>
  void SelectDepth(int depth, std::uint32_t first, std::uint32_t last);
  std::uint32_t FindCandidates(std::uint32_t first, std::uint32_t last);
  template <bool IsBelow>
  void Locate(int depth, std::uint32_t count);
  template <typename Site, bool IsBelow>
  std::uint32_t Test(int depth, std::uint32_t count, Found<Site>* found);
  template <typename Site>
  bool IsSeen(const DepthTable& table, const Found<Site>& site, std::uint32_t a, std::uint32_t b,
    std::uint32_t number);
  template <typename Site, bool IsBelow>
  void Take(int depth, Found<Site>* found, std::uint32_t count);
  bool TestBelow(Found<DetailVertexSite>& site) const;
  template <typename Site>
  static std::uint64_t PositionOf(const Found<Site>& site)
  {
    const int shift = site.Depth->Shift;
    return std::uint64_t{ site.At.Column } << shift | std::uint64_t{ site.At.Row } << (32 + shift);
  }
  void MergeVertex(const VertexSite& site, std::uint32_t number, StripVertex& vertex);
  void Reserve();
  void SetCount(std::uint32_t count);
  std::uint32_t LinkOf(std::uint32_t vertex, std::uint32_t k) const
  {
    return this->Links[2 * vertex + (k >> 1)][k & 1];
  }
  template <typename Site, bool IsBelow>
  StripVertex MakeVertex(
    Found<Site>& site, std::uint32_t number, const StripVertex& left, const StripVertex& right);

  const RefinementFrame* Frame = nullptr;
  ToleranceCounts* Counts = nullptr;
  bool Morphing = false;
  std::int64_t TriangleCount = 0;
  AppendBuffer<StripVertex> Vertices;
  AppendBuffer<Node> Nodes;
  /// Planes that cut the vertices' spheres.
  AppendBuffer<std::uint8_t> Masks;
  AppendBuffer<TriangleHalves> Links;
  AppendBuffer<Ground> Grounds;
  std::array<Place, MostFound> Places{};
  /// Numbers of those that are needed.
  std::array<std::uint32_t, MostFound> Kept{};
  /// First vertex of each sample, column + 65536 row, of the last row and column, if several
  /// vertices share them; and the others.
  std::unordered_map<std::uint32_t, std::uint32_t> Border;
  std::vector<std::array<std::uint32_t, 2>> Merged;
  std::vector<std::uint32_t> Indices;
};
}

#endif
