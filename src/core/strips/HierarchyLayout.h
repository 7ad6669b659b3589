// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the vertices of the longest-edge-bisection hierarchy lie and where their records are.
 *
 * The hierarchy is a square of N x N cells, N = 2^n, over W x H samples, its south-west corner on
 * sample (0, 0), N >= max(W, H) - 1. A vertex has a position (x, y) in cells and a depth, 0 for the
 * square's centre, 2 n - 1 for the finest:
 *   even depth 2 m     centres of the squares of side 2 s, s = N / 2^(m+1)
 *   odd depth 2 m + 1  midpoints of the sides of those squares
 * The four corners of the square have no depth and no record.
 *
 * A vertex splits its diamond, two right triangles that share the hypotenuse it halves, into four.
 * Directions count by 45 degrees, counter-clockwise, 0 = east. The direction of a triangle points
 * from the middle of its hypotenuse to its apex. A triangle of odd depth has an even direction, its
 * legs are diagonal; one of even depth has an odd direction, its legs lie along the axes. The two
 * triangles that halve triangle t of direction o have the directions o - 3 and o + 3, see
 * ChildDirection. A triangle is known by the vertex that halves it and its direction.
 *
 * Border. Vertices beyond the raster are moved onto its last row or column, axis by axis. That
 * keeps the orientation of every triangle; those outside become empty, those across the border fit
 * it. So any raster size has straight borders, and no triangle beyond.
 *
 * Order of the records (after Lindstrom and Pascucci 2002, section 4, whose interleaved quadtrees
 * leave 40 % of their slots empty; this order leaves only the rounding to whole blocks). By pair of
 * depths, coarsest first; in a pair by blocks of 32 x 32 groups, row by row; a group is the three
 * vertices of the pair in a square of side 2 s: middle of its south side, of its west side, centre.
 * A block is 24 KiB, six pages, and covers a square of the terrain. The index is a sum of a term of
 * x and a term of y, which are tabulated.
 */
#ifndef terrain_HierarchyLayout_h
#define terrain_HierarchyLayout_h

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace terrain
{
/// Sizes and indices of the hierarchy over a raster; made once, then only read.
class HierarchyLayout
{
public:
  /// Largest number of samples in a row or column.
  static constexpr std::int64_t MaximumSize = 32769;
  /// Groups in a row of a block.
  static constexpr int BlockSide = 32;

  /// One sentence if there is no hierarchy over width x height samples, else empty.
  static std::string WhyNotSize(std::int64_t width, std::int64_t height);

  HierarchyLayout() = default;
  /// The size must be one that WhyNotSize accepts.
  HierarchyLayout(std::int64_t width, std::int64_t height);

  std::int64_t Width() const
  {
    return this->Size[0];
  }
  std::int64_t Height() const
  {
    return this->Size[1];
  }
  /// Number n of pairs of depths, >= 1, and of depths, 2 n.
  int Pairs() const
  {
    return this->PairCount;
  }
  int Depths() const
  {
    return 2 * this->PairCount;
  }
  /// Side N of the square, in cells.
  std::int64_t Cells() const
  {
    return std::int64_t(1) << this->PairCount;
  }
  /// Number of records, blocks rounded up.
  std::int64_t RecordCount() const
  {
    return this->PairBegin.empty() ? 0 : this->PairBegin.back();
  }
  /// First record of a pair, 0 <= pair <= Pairs().
  std::int64_t FirstRecord(int pair) const
  {
    return this->PairBegin[pair];
  }

  /// Cells between neighbouring vertices of a pair of depths, s above, and its logarithm.
  std::int64_t Step(int pair) const
  {
    return std::int64_t(1) << this->Shift(pair);
  }
  int Shift(int pair) const
  {
    return this->PairCount - 1 - pair;
  }
  /// Number of vertex columns (axis 0) or rows (axis 1), in steps, that have records.
  std::int64_t Count(int pair, int axis) const
  {
    return static_cast<std::int64_t>(this->Terms[axis][pair].size());
  }
  /// Term of the index for column or row `step` of a pair, 0 <= step < Count; the index is the sum
  /// of both terms modulo 2^32.
  std::uint32_t Term(int pair, int axis, std::int64_t step) const
  {
    return this->Terms[axis][pair][step];
  }
  /// Index of the vertex at (x, y) steps of a pair; x or y is odd.
  std::int64_t Index(int pair, std::int64_t x, std::int64_t y) const
  {
    return static_cast<std::uint32_t>(this->Terms[0][pair][x] + this->Terms[1][pair][y]);
  }
  /// Depth of the vertex of a record.
  int DepthOf(std::int64_t index) const;
  /// Pair of depths of the vertex at (x, y) cells, -1 for a corner of the square.
  int PairOf(std::int64_t x, std::int64_t y) const;

  /// The sample of a vertex: x, y in cells moved onto the raster.
  glm::i64vec2 Sample(std::int64_t x, std::int64_t y) const
  {
    return { x < this->Size[0] ? x : this->Size[0] - 1, y < this->Size[1] ? y : this->Size[1] - 1 };
  }
  /// True if the raster's border cuts a triangle of the diamond of the vertex of the given pair at
  /// (x, y) cells; a border along an edge does not.
  bool IsAcrossBorder(int pair, std::int64_t x, std::int64_t y) const
  {
    const std::int64_t step = this->Step(pair);
    const bool evenX = (x & step) == 0;
    const bool evenY = (y & step) == 0;
    const auto cuts = [step](std::int64_t last, std::int64_t middle, bool apart)
    { return middle - step < last && last < middle + step && !(apart && last == middle); };
    return cuts(this->Size[0] - 1, x, evenX) || cuts(this->Size[1] - 1, y, evenY);
  }
  /// True if all of that diamond is beyond the raster.
  bool IsBeyond(int pair, std::int64_t x, std::int64_t y) const
  {
    const std::int64_t step = this->Step(pair);
    return x - step >= this->Size[0] - 1 || y - step >= this->Size[1] - 1;
  }

  /// Unit steps in the eight directions.
  static constexpr std::array<std::array<int, 2>, 8> Directions{ { { { 1, 0 } }, { { 1, 1 } },
    { { 0, 1 } }, { { -1, 1 } }, { { -1, 0 } }, { { -1, -1 } }, { { 0, -1 } }, { { 1, -1 } } } };

  /// Direction of the left (side 0) or right (side 1) half of a triangle, of which `depth` and
  /// `direction` are given. Left is first along the strip: the half at the left end of the
  /// hypotenuse, seen with the apex up, for odd depths, and mirrored for even ones.
  static int ChildDirection(int depth, int direction, int side)
  {
    return (direction + ((depth & 1) != side ? 5 : 3)) & 7;
  }
  /// Direction of one of the two triangles (the other is opposite) of the diamond of the vertex at
  /// (x, y) steps of a pair; -1 for the root.
  static int DiamondDirection(int pair, std::int64_t x, std::int64_t y);

  /// True if the triangle that the vertex of the given depth at (x, y) cells halves lies beyond the
  /// raster or the square, where it is empty.
  bool IsOutside(int depth, std::int64_t x, std::int64_t y, int direction) const;

private:
  std::array<std::int64_t, 2> Size{ { 0, 0 } };
  int PairCount = 0;
  std::vector<std::int64_t> PairBegin;
  std::array<std::vector<std::vector<std::uint32_t>>, 2> Terms;
};
}

#endif
