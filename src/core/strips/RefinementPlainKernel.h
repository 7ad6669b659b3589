// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The inner loop of the plain procedure (Refinement.h). Positions are columns + 2^32 rows, in
 * cells; with detail (RefinementDetail.h) in detail cells.
 */
#ifndef terrain_RefinementPlainKernel_h
#define terrain_RefinementPlainKernel_h

#include "core/strips/RefinementBuffers.h"
#include "core/strips/RefinementSites.h"

#include <array>
#include <cstdlib>
#include <type_traits>

namespace terrain
{
/// What lies beyond the edges of a triangle: a triangle that the path has passed (done), or none
/// (outside). Left and right are the legs, bottom is the hypotenuse.
struct EdgeBits
{
  static constexpr std::uint32_t LeftDone = 1;
  static constexpr std::uint32_t RightDone = 2;
  static constexpr std::uint32_t BottomDone = 4;
  static constexpr std::uint32_t LeftOutside = 16;
  static constexpr std::uint32_t RightOutside = 32;
  static constexpr std::uint32_t BottomOutside = 64;
};

/// Edges of a half, 0 left, 1 right: its bottom is a leg of the whole; half of the whole's bottom
/// is its outer leg; the path goes through the inner one.
constexpr std::uint32_t EdgesOfHalf(std::uint32_t edges, int side)
{
  constexpr std::uint32_t left = EdgeBits::LeftDone | EdgeBits::LeftOutside;
  constexpr std::uint32_t right = EdgeBits::RightDone | EdgeBits::RightOutside;
  constexpr std::uint32_t bottom = EdgeBits::BottomDone | EdgeBits::BottomOutside;
  return side == 0 ? ((edges & left) << 2) | ((edges & bottom) >> 2)
                   : ((edges & right) << 1) | ((edges & bottom) >> 1) | EdgeBits::LeftDone;
}

/**
 * Refines with the switches of Traits (static constexpr bool):
 *   Distance   by distance alone, no records are read; else by the screen-space error
 *   Culling    against the frame's planes
 *   Holes      some triangles are not drawn
 *   Detail     refines on below the base's samples; not with Distance
 * Sink gives active vertices an index and takes the strip:
 *   std::uint32_t Vertex(const RefinementFrame&, const VertexSite& or DetailVertexSite&, left,
 * right); void Append(index); void Reserve(); std::uint32_t Count(); std::uint32_t Last()
 */
template <typename Traits, typename Sink>
class PlainKernel
{
public:
  PlainKernel(const RefinementFrame& frame, Sink& sink, WaitingVertices& waiting)
    : Frame(frame)
    , Out(sink)
    , Waiting(waiting)
  {
    waiting.Clear();
  }

  /// The whole square: four triangles round its centre, south, east, north, west. `corners` are the
  /// sink's indices of the south-west, south-east, north-west and north-east corner. Returns the
  /// number of triangles.
  std::int64_t Run(std::uint64_t centre, std::uint32_t centreIndex, std::uint32_t drawn,
    const std::array<std::uint32_t, 4>& corners)
  {
    if (!Traits::Holes)
    {
      this->Out.Append(corners[0]);
      this->Before = corners[0];
      this->Newest = corners[0];
      this->Parity = 0;
    }
    for (int side = 0; side < 4; ++side)
    {
      Triangle triangle = this->BaseTriangle(centre, centreIndex, corners, side);
      this->Visit(triangle, HalfDrawn(drawn, triangle.Direction));
      if (!Traits::Holes)
      {
        this->Append(triangle.Right, 1);
      }
    }
    return this->TriangleCount;
  }

private:
  using Triangle = std::conditional_t<Traits::Detail, DetailTriangleSite, TriangleSite>;
  using Vertex = std::conditional_t<Traits::Detail, DetailVertexSite, VertexSite>;

  static bool HalfDrawn(std::uint32_t drawn, std::uint32_t direction)
  {
    return !Traits::Holes || ((drawn >> (direction >> 1)) & 1u) != 0;
  }

  Triangle BaseTriangle(std::uint64_t centre, std::uint32_t centreIndex,
    const std::array<std::uint32_t, 4>& corners, int side) const
  {
    static constexpr std::array<int, 5> round{ { 0, 1, 3, 2, 0 } };
    const int direction = (2 + 2 * side) & 7;
    const std::int64_t half = std::int64_t(1) << this->Frame.Depths[0].Shift;
    Triangle triangle{};
    triangle.Depth = &this->Frame.Depths[1];
    triangle.PlaneMask = (1u << this->Frame.PlaneCount) - 1u;
    triangle.Direction = static_cast<std::uint32_t>(direction);
    triangle.ToApex = half * Unit(direction);
    triangle.ToLeft = half * Unit((direction + 2) & 7);
    triangle.Position = centre - static_cast<std::uint64_t>(triangle.ToApex);
    triangle.Left = corners[round[side]];
    triangle.Right = corners[round[side + 1]];
    triangle.Apex = centreIndex;
    // The first triangle begins where the last one ends.
    triangle.Edges = EdgeBits::BottomOutside | (side > 0 ? EdgeBits::LeftDone : 0u) |
      (side == 3 ? EdgeBits::RightDone : 0u);
    if constexpr (Traits::Detail)
    {
      triangle.LeftBase = this->Frame.Detail.Corners[round[side]];
      triangle.RightBase = this->Frame.Detail.Corners[round[side + 1]];
      triangle.ApexBase = this->Frame.Detail.Centre;
    }
    return triangle;
  }

  /// A step in a direction, as positions are written.
  static std::int64_t Unit(int direction)
  {
    const std::array<int, 2>& unit = HierarchyLayout::Directions[direction];
    return unit[0] + unit[1] * (std::int64_t(1) << 32);
  }

  /// Half of a triangle that is split: side 0 left, 1 right. It has the triangle's vertex as apex
  /// and a leg as hypotenuse. Sums and differences of the two ways are even until the deepest
  /// depth, so halving them halves both of their coordinates.
  TERRAIN_INLINE Triangle Half(const Triangle& triangle, int side) const
  {
    const std::int64_t sum = (triangle.ToLeft + triangle.ToApex) >> 1;
    const std::int64_t difference = (triangle.ToLeft - triangle.ToApex) >> 1;
    Triangle half;
    half.Depth = triangle.Depth + 1;
    half.ToApex = side == 0 ? -sum : difference;
    half.ToLeft = side == 0 ? difference : sum;
    half.Position = triangle.Position - static_cast<std::uint64_t>(half.ToApex);
    half.PlaneMask = triangle.PlaneMask;
    half.Left = side == 0 ? triangle.Left : triangle.Apex;
    half.Right = side == 0 ? triangle.Apex : triangle.Right;
    half.Apex = triangle.Middle;
    if constexpr (!Traits::Distance)
    {
      half.Edges = EdgesOfHalf(triangle.Edges, side);
    }
    if constexpr (Traits::Holes)
    {
      half.Direction = static_cast<std::uint32_t>(HierarchyLayout::ChildDirection(
        triangle.Depth->IsOdd ? 1 : 0, static_cast<int>(triangle.Direction), side));
    }
    if constexpr (Traits::Detail)
    {
      this->SetBase(triangle, side, half);
    }
    return half;
  }

  bool IsBelowSamples(const Triangle& triangle) const
  {
    return Traits::Detail && triangle.Depth >= this->Frame.FirstDetail;
  }

  /// False if the triangle is part of a base cell that is not drawn.
  static bool IsDrawn(const Triangle& triangle)
  {
    if constexpr (Traits::Detail && Traits::Holes)
    {
      return triangle.IsDrawn;
    }
    else
    {
      return true;
    }
  }

  /// What a half has of the base.
  TERRAIN_INLINE void SetBase(const Triangle& triangle, int side, Triangle& half) const
  {
    half.LeftBase = side == 0 ? triangle.LeftBase : triangle.ApexBase;
    half.RightBase = side == 0 ? triangle.ApexBase : triangle.RightBase;
    half.ApexBase = triangle.MiddleBase;
    half.Twist = half.Depth->IsOdd ? triangle.Twist : 0.25f * triangle.Twist;
    if constexpr (Traits::Holes)
    {
      half.IsDrawn = HalfDrawn(triangle.Drawn, half.Direction);
    }
    if (half.Depth == this->Frame.FirstDetail && half.Depth <= this->Frame.Deepest && IsDrawn(half))
    {
      EnterCell(this->Frame, half);
    }
  }

  /// The vertex that halves the triangle.
  TERRAIN_INLINE Vertex Site(const Triangle& triangle) const
  {
    const DepthTable& depth = *triangle.Depth;
    Vertex site;
    site.Depth = &depth;
    site.Position = triangle.Position;
    if (this->IsBelowSamples(triangle))
    {
      return site;
    }
    site.Column = &depth.Columns[static_cast<std::uint32_t>(triangle.Position) >> depth.Shift];
    site.Row = &depth.Rows[static_cast<std::uint32_t>(triangle.Position >> 32) >> depth.Shift];
    site.Index = site.Column->Term + site.Row->Term;
    return site;
  }

  /// True if the vertex takes part, culling aside: its error is too large to leave it out.
  TERRAIN_INLINE bool IsNeeded(Vertex& site) const
  {
    if constexpr (Traits::Distance)
    {
      return site.Depth->ColumnDistance(site.Position).Distance2 +
        site.Depth->RowDistance(site.Position).Distance2 <
        site.Depth->Range2;
    }
    else
    {
      return IsSampleNeeded(this->Frame, site);
    }
  }

  /// Completes a triangle whose vertex is needed; false if the vertex is culled.
  TERRAIN_INLINE bool Split(Triangle& triangle, const Vertex& site)
  {
    if constexpr (Traits::Culling)
    {
      if ((triangle.PlaneMask & site.Depth->PlaneMask) != 0 &&
        IsCulled(this->Frame, site, triangle.PlaneMask))
      {
        return false;
      }
    }
    if constexpr (Traits::Detail)
    {
      triangle.MiddleBase = site.BaseHeight;
    }
    if constexpr (Traits::Holes)
    {
      // Only drawn triangles are split below the samples.
      triangle.Drawn =
        this->IsBelowSamples(triangle) ? HierarchyRecord::DrawnBits : site.Record.Drawn();
    }
    if (!this->Recall(triangle))
    {
      triangle.Middle = this->Out.Vertex(this->Frame, site, triangle.Left, triangle.Right);
    }
    return true;
  }

  /// True if the vertex that halves the triangle is active, by what is known of it; completes the
  /// triangle then.
  TERRAIN_INLINE bool Test(Triangle& triangle)
  {
    Vertex site = this->Site(triangle);
    if constexpr (!Traits::Distance)
    {
      triangle.IsRecalled = false;
    }
    if constexpr (Traits::Detail)
    {
      if (this->IsBelowSamples(triangle))
      {
        return this->TestBelow(triangle, site);
      }
    }
    return this->IsNeeded(site) && this->Split(triangle, site);
  }

  /// The same below the samples. Not inline: the procedures stay small.
  TERRAIN_NO_INLINE bool TestBelow(Triangle& triangle, Vertex& site)
  {
    return IsDrawn(triangle) && IsDetailNeeded(this->Frame, BaseAt(triangle), site) &&
      this->Split(triangle, site);
  }

  /// Completes a triangle whose vertex waits for it; false if it does not.
  TERRAIN_INLINE bool Recall(Triangle& triangle) const
  {
    if constexpr (!Traits::Distance)
    {
      const WaitingVertex& vertex = this->Waiting.Top(triangle.Depth->IsOdd);
      if ((triangle.Edges & EdgeBits::BottomDone) != 0 && vertex.Position == triangle.Position)
      {
        triangle.Middle = vertex.Index;
        triangle.IsRecalled = true;
        return true;
      }
    }
    return false;
  }

  /// Begins the halves of a triangle whose vertex is active.
  TERRAIN_INLINE void Enter(const Triangle& triangle)
  {
    if constexpr (!Traits::Distance)
    {
      if (triangle.IsRecalled)
      {
        this->Waiting.Pop(triangle.Depth->IsOdd);
      }
    }
  }
  /// Ends them: the vertex waits for the triangle beyond the bottom, if there is one and it is
  /// still to come.
  TERRAIN_INLINE void Leave(const Triangle& triangle)
  {
    if constexpr (!Traits::Distance)
    {
      if ((triangle.Edges & (EdgeBits::BottomDone | EdgeBits::BottomOutside)) == 0)
      {
        this->Waiting.Push(triangle.Depth->IsOdd, { triangle.Position, triangle.Middle });
      }
    }
  }

  /// A triangle that is not split although vertices on its outline may be active: where vertices
  /// are not tested against the planes, and in holes. Those that wait for it wait no longer.
  void Pass(const Triangle& triangle, bool drawn)
  {
    const bool isLazy = Traits::Culling && this->Frame.IsLazy && triangle.PlaneMask != 0;
    const bool isHole = Traits::Detail && Traits::Holes && !drawn;
    if (!Traits::Distance && (isLazy || isHole) && triangle.Depth <= this->Frame.Deepest)
    {
      this->ForgetOutline(triangle);
    }
  }
  TERRAIN_NO_INLINE void ForgetOutline(const Triangle& triangle)
  {
    for (const bool isOdd : { false, true })
    {
      while (IsOnOutline(triangle, this->Waiting.Top(isOdd).Position))
      {
        this->Waiting.Pop(isOdd);
      }
    }
  }
  /// True for positions in a triangle besides its corners.
  static bool IsOnOutline(const Triangle& triangle, std::uint64_t position)
  {
    const auto column = [](std::uint64_t way)
    { return std::int64_t{ static_cast<std::int32_t>(way) }; };
    const auto row = [&](std::uint64_t way)
    { return static_cast<std::int64_t>(way - static_cast<std::uint64_t>(column(way))) >> 32; };
    const auto dot = [&](std::uint64_t a, std::uint64_t b)
    { return column(a) * column(b) + row(a) * row(b); };
    const std::uint64_t way = position - triangle.Position;
    const auto toApex = static_cast<std::uint64_t>(triangle.ToApex);
    const std::int64_t whole = dot(toApex, toApex);
    const std::int64_t up = dot(way, toApex);
    const std::int64_t aside = std::abs(dot(way, static_cast<std::uint64_t>(triangle.ToLeft)));
    return up >= 0 && up + aside <= whole && up != whole && aside != whole;
  }

  /// Looks at every vertex from both of its triangles.
  void Visit(Triangle& triangle, bool drawn)
  {
    this->Out.Reserve();
    const bool isActive = triangle.Depth <= this->Frame.Deepest && this->Test(triangle);
    if (isActive)
    {
      this->Enter(triangle);
      Triangle left = this->Half(triangle, 0);
      this->Visit(left, HalfDrawn(triangle.Drawn, left.Direction));
    }
    else
    {
      this->Pass(triangle, drawn);
      this->Leaf(triangle, drawn);
    }
    if (!Traits::Holes)
    {
      this->Append(triangle.Apex, triangle.Depth->IsOdd ? 0 : 1);
    }
    if (isActive)
    {
      Triangle right = this->Half(triangle, 1);
      this->Visit(right, HalfDrawn(triangle.Drawn, right.Direction));
      this->Leave(triangle);
    }
  }

  void Leaf(const Triangle& triangle, bool drawn)
  {
    if (drawn)
    {
      ++this->TriangleCount;
      if (Traits::Holes)
      {
        // Strips with gaps are not part of the plain procedure: each triangle starts anew.
        this->Start(triangle.Left, triangle.Right, triangle.Apex, triangle.Depth->IsOdd);
      }
    }
  }

  /// Appends a vertex unless the strip ends with it, and repeats one to keep the winding.
  void Append(std::uint32_t index, int parity)
  {
    if (index == this->Newest || index == this->Before)
    {
      return;
    }
    if (parity != this->Parity)
    {
      this->Parity = parity;
    }
    else
    {
      this->Out.Append(this->Before);
      this->Newest = this->Before;
    }
    this->Out.Append(index);
    this->Before = this->Newest;
    this->Newest = index;
  }

  /// Goes on at the triangle (first, second, third), joined by degenerate triangles.
  TERRAIN_NO_INLINE void Start(
    std::uint32_t first, std::uint32_t second, std::uint32_t third, bool counterClockwise)
  {
    if (this->Out.Count() != 0)
    {
      this->Out.Append(this->Out.Last());
      this->Out.Append(first);
    }
    this->Out.Append(first);
    if (((this->Out.Count() & 1u) != 0) != counterClockwise)
    {
      this->Out.Append(first);
    }
    this->Out.Append(second);
    this->Out.Append(third);
  }

  const RefinementFrame& Frame;
  Sink& Out;
  WaitingVertices& Waiting;
  std::int64_t TriangleCount = 0;
  std::uint32_t Before = 0;
  std::uint32_t Newest = 0;
  int Parity = 0;
};
}

#endif
