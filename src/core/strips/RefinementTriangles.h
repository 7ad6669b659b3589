// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Triangles of which RefinementStrip.h makes a strip.
 */
#ifndef terrain_RefinementTriangles_h
#define terrain_RefinementTriangles_h

#include "core/strips/RefinementFrame.h"
#include "core/strips/RefinementSelection.h"

#include <array>

namespace terrain
{
/// The square's corners, south-west, south-east, north-west, north-east, in the order of the four
/// triangles round its centre.
constexpr std::array<std::uint32_t, 5> kSquareRound{ { 0, 1, 3, 2, 0 } };

/// The triangles of a selection. Holes: some are not drawn.
template <bool HasHoles>
class SelectedTriangles
{
public:
  static constexpr bool Holes = HasHoles;

  struct Triangle
  {
    /// Numbers of the vertices.
    std::uint32_t Left;
    std::uint32_t Apex;
    std::uint32_t Right;
    std::uint32_t Link;
    /// Only with holes: the hypotenuse lies along the axes.
    bool IsOdd;
  };

  explicit SelectedTriangles(const RefinementSelection& selection)
    : Halves(selection.Halves())
  {
  }

  TERRAIN_INLINE Triangle Half(const Triangle& triangle, int side) const
  {
    return { side == 0 ? triangle.Left : triangle.Apex, triangle.Link >> 1,
      side == 0 ? triangle.Apex : triangle.Right,
      this->Halves[triangle.Link][static_cast<std::size_t>(side)], HasHoles && !triangle.IsOdd };
  }
  TERRAIN_INLINE bool IsSplit(Triangle& triangle) const
  {
    return triangle.Link > UnsplitLink::Last;
  }
  static constexpr bool IsFinest(const Triangle&)
  {
    return false;
  }
  static bool IsDrawn(const Triangle& triangle)
  {
    return !HasHoles || triangle.Link == UnsplitLink::Drawn;
  }

private:
  const RefinementSelection::TriangleHalves* Halves;
};

/// Triangles that are split by the distance to the eye (Refiner::RefineByDistance). Vertices are
/// samples: column + 65536 row.
class DistanceTriangles
{
public:
  static constexpr bool Holes = false;

  struct Triangle
  {
    /// Position of the vertex that halves it, as column + 2^32 row, and from there the ways to the
    /// apex and to the left end of the hypotenuse.
    std::uint64_t Position;
    std::int64_t ToApex;
    std::int64_t ToLeft;
    const DepthTable* Depth;
    std::uint32_t Left;
    std::uint32_t Apex;
    std::uint32_t Right;
    /// Of a triangle that is split: that vertex.
    std::uint32_t Middle;
  };

  explicit DistanceTriangles(const RefinementFrame& frame)
    : Deepest(frame.Deepest)
  {
  }

  /// Sums and differences of the two ways are even until the deepest depth, so halving them halves
  /// both of their coordinates.
  TERRAIN_INLINE Triangle Half(const Triangle& triangle, int side) const
  {
    const std::int64_t sum = (triangle.ToLeft + triangle.ToApex) >> 1;
    const std::int64_t difference = (triangle.ToLeft - triangle.ToApex) >> 1;
    Triangle half;
    half.Left = side == 0 ? triangle.Left : triangle.Apex;
    half.Apex = triangle.Middle;
    half.Right = side == 0 ? triangle.Apex : triangle.Right;
    half.Depth = triangle.Depth + 1;
    half.ToApex = side == 0 ? -sum : difference;
    half.ToLeft = side == 0 ? difference : sum;
    half.Position = triangle.Position - static_cast<std::uint64_t>(half.ToApex);
    return half;
  }
  TERRAIN_INLINE bool IsSplit(Triangle& triangle) const
  {
    const DepthTable& depth = *triangle.Depth;
    const DistanceEntry& column = depth.ColumnDistance(triangle.Position);
    const DistanceEntry& row = depth.RowDistance(triangle.Position);
    if (column.Distance2 + row.Distance2 < depth.Range2)
    {
      triangle.Middle = column.Sample | (row.Sample << 16);
      return true;
    }
    return false;
  }
  TERRAIN_INLINE bool IsFinest(const Triangle& triangle) const
  {
    return triangle.Depth >= this->Deepest;
  }
  static constexpr bool IsDrawn(const Triangle&)
  {
    return true;
  }

private:
  const DepthTable* Deepest;
};
}

#endif
