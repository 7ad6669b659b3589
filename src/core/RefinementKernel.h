// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The inner loops of Refinement.h. Positions are columns + 2^32 rows, in cells; with detail
 * (RefinementDetail.h) in detail cells.
 */
#ifndef terrain_RefinementKernel_h
#define terrain_RefinementKernel_h

#include "core/RefinementSites.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace terrain
{
/// Where the strip crosses a triangle's outline.
enum class StripEdge
{
  Side,
  Bottom
};
constexpr StripEdge Flip(StripEdge edge)
{
  return edge == StripEdge::Side ? StripEdge::Bottom : StripEdge::Side;
}

/**
 * Refines with the switches of Traits (static constexpr bool):
 *   Distance   by distance alone, no records are read; else by the screen-space error
 *   Culling    against the frame's planes
 *   Holes      some triangles are not drawn
 *   Detail     refines on below the base's samples; not with Distance
 * Sink gives active vertices an index and takes the strip:
 *   std::uint32_t Vertex(const RefinementFrame&, const VertexSite& or DetailVertexSite&, left,
 * right) void Prefetch(record), ahead of Vertex void Append(index); void Reserve(); std::uint32_t
 * Count(); std::uint32_t Last(); void RepeatThird(); bool Stopped()
 */
template <typename Traits, typename Sink>
class RefinementKernel
{
  using Triangle = std::conditional_t<Traits::Detail, DetailTriangleSite, TriangleSite>;
  using Vertex = std::conditional_t<Traits::Detail, DetailVertexSite, VertexSite>;

public:
  RefinementKernel(const RefinementFrame& frame, Sink& sink)
    : Frame(frame)
    , Out(sink)
  {
  }

  std::int64_t Triangles() const
  {
    return this->TriangleCount;
  }

  /// The whole square: four triangles round its centre, south, east, north, west. `corners` are the
  /// sink's indices of the south-west, south-east, north-west and north-east corner.
  void Improved(std::uint64_t centre, std::uint32_t centreIndex, std::uint32_t drawn,
    const std::array<std::uint32_t, 4>& corners)
  {
    this->Broken = Traits::Holes;
    if (!Traits::Holes)
    {
      // The first index stands for the other end of the first triangle's entering edge: there the
      // strip turns, so it is the third.
      this->Out.Append(corners[0]);
      this->Out.Append(corners[0]);
    }
    for (int side = 0; side < 4; ++side)
    {
      Triangle triangle = this->BaseTriangle(centre, centreIndex, corners, side);
      if (triangle.Depth <= this->Frame.Deepest && this->Visit(triangle))
      {
        this->template General<StripEdge::Side, StripEdge::Side, true>(triangle);
      }
      else
      {
        this->template Leaf<StripEdge::Side, StripEdge::Side, true>(
          triangle, HalfDrawn(drawn, triangle.Direction));
      }
    }
    if (!Traits::Holes)
    {
      this->Out.RepeatThird();
    }
  }

  /// The same by the plain procedure.
  void Plain(std::uint64_t centre, std::uint32_t centreIndex, std::uint32_t drawn,
    const std::array<std::uint32_t, 4>& corners)
  {
    this->Broken = true;
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
      this->PlainTriangle(triangle, HalfDrawn(drawn, triangle.Direction));
      if (!Traits::Holes)
      {
        this->PlainAppend(triangle.Right, 1);
      }
    }
  }

private:
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
    if (half.Depth == this->Frame.FirstDetail && half.Depth <= this->Frame.Deepest &&
      !this->IsHole(half))
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

  /// Fetches what is known of the vertices that halve the triangle's halves. Most of them are
  /// looked at soon, and whether they take part is hard to predict: the answer should not wait for
  /// memory.
  TERRAIN_INLINE void Prefetch(const Triangle& triangle) const
  {
    if constexpr (!Traits::Distance)
    {
      if (!this->IsFinest(triangle) && !this->IsBelowSamples(triangle))
      {
        for (const int side : { 0, 1 })
        {
          const std::uint32_t index = this->Site(this->Half(triangle, side)).Index;
          __builtin_prefetch(&this->Frame.Records[index]);
          this->Out.Prefetch(index);
        }
      }
    }
  }

  /// True if the vertex takes part, culling aside: its error is too large to leave it out.
  TERRAIN_INLINE bool IsNeeded(Vertex& site) const
  {
    site.Distance2 = site.Column->Distance2 + site.Row->Distance2;
    if constexpr (Traits::Distance)
    {
      return site.Distance2 < site.Depth->Range2;
    }
    else
    {
      site.Record = this->Frame.Records[site.Index];
      const double dz = site.Record.Height * this->Frame.DistanceScale - this->Frame.EyeHeight;
      site.ErrorReach = site.Record.Error() * this->Frame.ErrorScale;
      site.RadiusReach = site.Record.Radius() * this->Frame.RadiusScale;
      site.Distance2 += dz * dz;
      bool hasError = site.Record.HasError();
      if constexpr (Traits::Detail)
      {
        AddDetail(this->Frame, site);
        hasError = hasError || site.Record.Drawn() != 0;
      }
      const double reach = site.ErrorReach + site.RadiusReach;
      // Both tests at once: the second alone decides too seldom for a branch of its own.
      return (int(reach * reach > site.Distance2) & int(hasError)) != 0;
    }
  }

  /// Completes a triangle whose vertex is needed; false if the vertex is culled.
  TERRAIN_INLINE bool Split(Triangle& triangle, const Vertex& site)
  {
    if constexpr (Traits::Culling)
    {
      if ((triangle.PlaneMask & site.Depth->PlaneMask) != 0 &&
        this->IsCulled(site, triangle.PlaneMask))
      {
        return false;
      }
    }
    if (this->Out.Stopped())
    {
      return false;
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
    triangle.Middle = this->Out.Vertex(this->Frame, site, triangle.Left, triangle.Right);
    return true;
  }

  /// True if the vertex that halves the triangle is active; completes the triangle then.
  TERRAIN_INLINE bool Visit(Triangle& triangle)
  {
    Vertex site = this->Site(triangle);
    if constexpr (Traits::Detail)
    {
      if (this->IsBelowSamples(triangle))
      {
        return this->VisitBelow(triangle, site);
      }
    }
    return this->IsNeeded(site) && this->Split(triangle, site);
  }

  /// The same below the samples. Not inline: the procedures stay small.
  TERRAIN_NO_INLINE bool VisitBelow(Triangle& triangle, Vertex& site)
  {
    return !this->IsHole(triangle) && IsDetailNeeded(this->Frame, triangle, site) &&
      this->Split(triangle, site);
  }

  /// True if the triangle is part of a base cell that is not drawn.
  bool IsHole(const Triangle& triangle) const
  {
    if constexpr (Traits::Detail && Traits::Holes)
    {
      return this->IsBelowSamples(triangle) && !triangle.IsDrawn;
    }
    else
    {
      return false;
    }
  }

  /// True if the sphere is outside some plane of the mask; planes that it is inside of leave it.
  TERRAIN_NO_INLINE bool IsCulled(const Vertex& site, std::uint32_t& mask) const
  {
    const auto [centre, radius] = SphereOf(this->Frame, site);
    for (int i = 0; i < this->Frame.PlaneCount; ++i)
    {
      if ((mask & (1u << i)) != 0)
      {
        const glm::dvec4& plane = this->Frame.Planes[i];
        const double distance =
          plane.x * centre.x + plane.y * centre.y + plane.z * centre.z + plane.w;
        if (distance < -radius)
        {
          return true;
        }
        if (distance > radius)
        {
          mask &= ~(1u << i);
        }
      }
    }
    return false;
  }

  /// A triangle that is not split. Last: the left end of its hypotenuse is the strip's last index;
  /// otherwise it is the other end of the entering edge.
  template <StripEdge In, StripEdge Exit, bool Last>
  void Leaf(const Triangle& triangle, bool drawn)
  {
    constexpr bool sides = In == StripEdge::Side && Exit == StripEdge::Side;
    constexpr bool leavesBottom = Exit == StripEdge::Bottom;
    if constexpr (Traits::Holes)
    {
      if (!drawn)
      {
        this->Broken = true;
        return;
      }
      if (this->Broken)
      {
        this->Start(leavesBottom ? triangle.Apex : triangle.Left,
          sides ? triangle.Apex : (leavesBottom ? triangle.Left : triangle.Right),
          In == StripEdge::Bottom ? triangle.Apex : triangle.Right, triangle.Depth->IsOdd != sides);
        ++this->TriangleCount;
        return;
      }
    }
    // The strip turns round the vertex that the entering and the leaving edge share.
    constexpr bool turns = leavesBottom ? !Last : Last;
    if constexpr (turns)
    {
      this->Out.Append(sides ? triangle.Apex : (leavesBottom ? triangle.Left : triangle.Right));
    }
    this->Out.Append(In == StripEdge::Bottom ? triangle.Apex : triangle.Right);
    ++this->TriangleCount;
  }

  /// Goes on at the triangle (first, second, third) after a gap, joined by degenerate triangles.
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
    this->Broken = false;
  }

  template <StripEdge In, StripEdge Exit, bool Last>
  void BothLeaves(const Triangle& triangle)
  {
    this->template LeftLeaf<In, Last>(triangle, this->Half(triangle, 0));
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, this->Half(triangle, 1));
  }

  template <StripEdge In, bool Last>
  void LeftLeaf(const Triangle& triangle, const Triangle& left)
  {
    this->template Leaf<Flip(In), StripEdge::Side, Last>(
      left, HalfDrawn(triangle.Drawn, left.Direction));
  }

  template <StripEdge Exit, bool Last>
  void RightLeaf(const Triangle& triangle, const Triangle& right)
  {
    this->template Leaf<StripEdge::Side, Flip(Exit), Last>(
      right, HalfDrawn(triangle.Drawn, right.Direction));
  }

  bool IsFinest(const Triangle& triangle) const
  {
    return triangle.Depth >= this->Frame.Deepest;
  }

  /// A triangle that is split, and whose halves may both be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void General(const Triangle& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    Triangle left = this->Half(triangle, 0);
    Triangle right = this->Half(triangle, 1);
    this->Prefetch(left);
    this->Prefetch(right);
    const bool isLeftActive = this->Visit(left);
    const bool isRightActive = this->Visit(right);
    if (isLeftActive && isRightActive)
    {
      this->template General<Flip(In), StripEdge::Side, Last>(left);
      this->template General<StripEdge::Side, Flip(Exit), true>(right);
    }
    else if (isLeftActive)
    {
      this->template LeftBeside<Flip(In), Last>(left, right);
      this->template RightLeaf<Exit, true>(triangle, right);
    }
    else
    {
      this->template LeftLeaf<In, Last>(triangle, left);
      if (isRightActive)
      {
        this->template RightBeside<Flip(Exit), In == StripEdge::Bottom>(right, left);
      }
      else
      {
        this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
      }
    }
  }

  /// A left half beside a right one that is not split: that forbids to split the edge between them,
  /// unless nothing is drawn there.
  template <StripEdge In, bool Last>
  void LeftBeside(const Triangle& left, const Triangle& right)
  {
    if (this->IsHole(right))
    {
      this->template General<In, StripEdge::Side, Last>(left);
      return;
    }
    this->template LeftOnly<In, StripEdge::Side, Last>(left);
  }

  /// The same with sides changed.
  template <StripEdge Exit, bool Last>
  void RightBeside(const Triangle& right, const Triangle& left)
  {
    if (this->IsHole(left))
    {
      this->template General<StripEdge::Side, Exit, Last>(right);
      return;
    }
    this->template RightOnly<StripEdge::Side, Exit, Last>(right);
  }

  /// A triangle that is split, and whose right half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void LeftOnly(const Triangle& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    Triangle left = this->Half(triangle, 0);
    if (this->Visit(left))
    {
      this->template LeftBeside<Flip(In), Last>(left, this->Half(triangle, 1));
      this->template RightLeaf<Exit, true>(triangle, this->Half(triangle, 1));
      return;
    }
    this->template LeftLeaf<In, Last>(triangle, left);
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, this->Half(triangle, 1));
  }

  /// A triangle that is split, and whose left half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void RightOnly(const Triangle& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    this->template LeftLeaf<In, Last>(triangle, this->Half(triangle, 0));
    Triangle right = this->Half(triangle, 1);
    if (this->Visit(right))
    {
      this->template RightBeside<Flip(Exit), In == StripEdge::Bottom>(
        right, this->Half(triangle, 0));
      return;
    }
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
  }

  void PlainTriangle(Triangle& triangle, bool drawn)
  {
    this->Out.Reserve();
    const bool isActive = triangle.Depth <= this->Frame.Deepest && this->Visit(triangle);
    if (isActive)
    {
      Triangle left = this->Half(triangle, 0);
      this->PlainTriangle(left, HalfDrawn(triangle.Drawn, left.Direction));
    }
    else if (drawn)
    {
      ++this->TriangleCount;
      if (Traits::Holes)
      {
        // Strips with gaps are not part of the plain procedure: each triangle starts anew.
        this->Start(triangle.Left, triangle.Right, triangle.Apex, triangle.Depth->IsOdd);
      }
    }
    if (!Traits::Holes)
    {
      this->PlainAppend(triangle.Apex, triangle.Depth->IsOdd ? 0 : 1);
    }
    if (isActive)
    {
      Triangle right = this->Half(triangle, 1);
      this->PlainTriangle(right, HalfDrawn(triangle.Drawn, right.Direction));
    }
  }

  /// Appends a vertex unless the strip ends with it, and repeats one to keep the winding.
  void PlainAppend(std::uint32_t index, int parity)
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

  const RefinementFrame& Frame;
  Sink& Out;
  std::int64_t TriangleCount = 0;
  bool Broken = false;
  std::uint32_t Before = 0;
  std::uint32_t Newest = 0;
  int Parity = 0;
};
}

#endif
