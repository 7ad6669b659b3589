// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which vertices a refinement splits triangles at (RefinementKernel.h). Positions are columns +
 * 2^32 rows, in cells; with detail (RefinementDetail.h) in detail cells.
 */
#ifndef terrain_RefinementVisits_h
#define terrain_RefinementVisits_h

#include "core/RefinementBuffers.h"
#include "core/RefinementSites.h"

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
 * Triangles and the tests of the vertices that halve them, with the switches and the sink of
 * RefinementKernel.
 */
template <typename Traits, typename Sink>
class RefinementVisits
{
protected:
  using Triangle = std::conditional_t<Traits::Detail, DetailTriangleSite, TriangleSite>;
  using Vertex = std::conditional_t<Traits::Detail, DetailVertexSite, VertexSite>;

  RefinementVisits(const RefinementFrame& frame, Sink& sink, WaitingVertices& waiting)
    : Frame(frame)
    , Out(sink)
    , Waiting(waiting)
  {
    waiting.Clear();
  }

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

  /// Fetches the records of the vertices that may be looked at in the halves of a triangle's
  /// halves: whether they take part is hard to predict, and the answer should not wait for memory.
  TERRAIN_INLINE void PrefetchBelow(const Triangle& triangle) const
  {
    if constexpr (!Traits::Distance)
    {
      const DepthTable* depth = triangle.Depth + 2;
      if (depth > this->Frame.Deepest || (Traits::Detail && depth >= this->Frame.FirstDetail))
      {
        return;
      }
      // The middle of what both halves share, and of the halves of the bottom.
      this->PrefetchAt(*depth, triangle.Position + (triangle.ToApex >> 1));
      if ((triangle.Edges & EdgeBits::BottomDone) == 0)
      {
        this->PrefetchAt(*depth, triangle.Position + (triangle.ToLeft >> 1));
        this->PrefetchAt(*depth, triangle.Position - (triangle.ToLeft >> 1));
      }
    }
  }
  TERRAIN_INLINE void PrefetchAt(const DepthTable& depth, std::uint64_t position) const
  {
    __builtin_prefetch(&this->Frame.Records[IndexOf(depth, position)]);
  }
  static std::uint32_t IndexOf(const DepthTable& depth, std::uint64_t position)
  {
    return depth.Columns[static_cast<std::uint32_t>(position) >> depth.Shift].Term +
      depth.Rows[static_cast<std::uint32_t>(position >> 32) >> depth.Shift].Term;
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

  /// Completes a triangle whose vertex is needed; false if the vertex is culled. `Recalls`: the
  /// vertex may be known from the first triangle.
  template <bool Recalls>
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
    if constexpr (Recalls && !Traits::Distance)
    {
      if ((triangle.Edges & EdgeBits::BottomDone) != 0 && this->Recall(triangle, 0))
      {
        return true;
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
    triangle.Middle = this->Out.Vertex(this->Frame, site, triangle.Left, triangle.Right);
    return true;
  }

  /// True if the vertex that halves the triangle is active, by what is known of it; completes the
  /// triangle then.
  template <bool Recalls>
  TERRAIN_INLINE bool Test(Triangle& triangle)
  {
    Vertex site = this->Site(triangle);
    if constexpr (!Traits::Distance)
    {
      triangle.Waiting = 0;
    }
    if constexpr (Traits::Detail)
    {
      if (this->IsBelowSamples(triangle))
      {
        return this->template TestBelow<Recalls>(triangle, site);
      }
    }
    return this->IsNeeded(site) && this->template Split<Recalls>(triangle, site);
  }

  /// The same below the samples. Not inline: the procedures stay small.
  template <bool Recalls>
  TERRAIN_NO_INLINE bool TestBelow(Triangle& triangle, Vertex& site)
  {
    return IsDrawn(triangle) && IsDetailNeeded(this->Frame, triangle, site) &&
      this->template Split<Recalls>(triangle, site);
  }

  /// Completes a triangle whose vertex waits for it, below `above` others; false if it does not.
  TERRAIN_INLINE bool Recall(Triangle& triangle, std::uint32_t above)
  {
    const WaitingVertex& vertex = this->Waiting.Top(triangle.Depth->IsOdd, above);
    if (vertex.Position != triangle.Position)
    {
      return false;
    }
    triangle.Middle = vertex.Index;
    triangle.Waiting = vertex.Count;
    if constexpr (Traits::Culling)
    {
      triangle.PlaneMask &= vertex.PlaneMask;
    }
    if constexpr (Traits::Holes)
    {
      triangle.Drawn = vertex.Drawn;
    }
    if constexpr (Traits::Detail)
    {
      triangle.MiddleBase = vertex.BaseHeight;
    }
    this->Out.Repeat(triangle.Middle);
    return true;
  }

  /// True if the vertex that halves the triangle is active; completes the triangle then. The first
  /// of the two triangles of the vertex decides for both. `above`: so many vertices of an edge that
  /// comes before the bottom wait, too.
  TERRAIN_INLINE bool Visit(Triangle& triangle, std::uint32_t above = 0)
  {
    if constexpr (!Traits::Distance)
    {
      if ((triangle.Edges & EdgeBits::BottomDone) != 0)
      {
        // A hole has not decided.
        return this->Recall(triangle, above) ||
          (Traits::Detail && Traits::Holes && this->template Test<false>(triangle));
      }
    }
    return this->template Test<false>(triangle);
  }

  /// Begins the halves of a triangle whose vertex is active; returns what Leave() takes.
  TERRAIN_INLINE std::uint32_t Enter(const Triangle& triangle)
  {
    this->Out.Reserve();
    if constexpr (Traits::Distance)
    {
      return 0;
    }
    if (triangle.Waiting != 0)
    {
      this->Waiting.Pop(triangle.Depth->IsOdd);
    }
    return this->Waiting.Count(triangle.Depth->IsOdd);
  }
  /// Ends them: the vertex waits for the triangle beyond the bottom, if there is one and it is
  /// still to come.
  TERRAIN_INLINE void Leave(const Triangle& triangle, std::uint32_t entered)
  {
    if constexpr (!Traits::Distance)
    {
      if ((triangle.Edges & (EdgeBits::BottomDone | EdgeBits::BottomOutside)) == 0)
      {
        const bool isOdd = triangle.Depth->IsOdd;
        WaitingVertex vertex;
        vertex.Position = triangle.Position;
        vertex.Index = triangle.Middle;
        vertex.Count = this->Waiting.Count(isOdd) - entered + 1;
        if constexpr (Traits::Detail)
        {
          vertex.BaseHeight = triangle.MiddleBase;
        }
        if constexpr (Traits::Holes)
        {
          vertex.Drawn = static_cast<std::uint8_t>(triangle.Drawn);
        }
        vertex.PlaneMask = static_cast<std::uint8_t>(triangle.PlaneMask);
        this->Waiting.Push(isOdd, vertex);
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

  /// True if a half of a triangle is a hole. With detail the vertices beside a hole may be active
  /// without those in it, which have no error there.
  bool IsHole(const Triangle& triangle, const Triangle& half) const
  {
    return Traits::Detail && Traits::Holes && !HalfDrawn(triangle.Drawn, half.Direction);
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

  const RefinementFrame& Frame;
  Sink& Out;
  WaitingVertices& Waiting;
};
}

#endif
