// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The inner loops of Refinement.h. Positions are columns + 2^32 rows, in cells.
 */
#ifndef terrain_RefinementKernel_h
#define terrain_RefinementKernel_h

#include "core/Refinement.h"

#include <array>
#include <cmath>

/// The compiler's own choice leaves the small functions of the inner loop as calls, and takes rare
/// work into it.
#define TERRAIN_INLINE [[gnu::always_inline]] inline
#define TERRAIN_NO_INLINE [[gnu::noinline]]

namespace terrain
{
/// A column or row of vertices of a pair of depths.
struct AxisEntry
{
  /// Its part of the squared distance to the eye, in scaled space; its term of the record index.
  double Distance2;
  std::uint32_t Term;
  /// Column or row of the sample that it is drawn at.
  std::uint32_t Sample;
};

/// What all vertices of a depth share.
struct DepthTable
{
  const AxisEntry* Columns = nullptr;
  const AxisEntry* Rows = nullptr;
  int Shift = 0;
  /// Planes that vertices of this depth are tested against: all, or none (lazy culling).
  std::uint32_t PlaneMask = 0;
  /// Hypotenuses of this depth's triangles lie along the axes.
  bool IsOdd = false;
  /// Squared distance below which a vertex is active (RefineByDistance).
  double Range2 = 0.0;
};

/// One refinement: the view in scaled space, which is model space relative to the grid's origin,
/// times 1 / max(1, exaggeration): the radii hold in it whatever the exaggeration.
struct RefinementFrame
{
  std::array<DepthTable, 32> Depths;
  /// The deepest one that vertices are looked at.
  const DepthTable* Deepest = nullptr;
  const HierarchyRecord* Records = nullptr;
  /// Height of the eye and height unit, for distances; both 0 in parallel projection.
  double EyeHeight = 0.0;
  double DistanceScale = 1.0;
  /// Active: Error ErrorScale + Radius RadiusScale > d. In perspective that is
  /// Error lambda / tolerance > d - Radius, in parallel projection, where d is 1 and RadiusScale 0,
  /// Error lambda / tolerance > 1.
  double ErrorScale = 0.0;
  double RadiusScale = 1.0;
  /// Planes, and the size of a cell and of the height unit in their space.
  std::array<glm::dvec4, 8> Planes{};
  int PlaneCount = 0;
  glm::dvec3 Step{ 1.0 };
  std::uint32_t LastColumn = 0;
  std::uint32_t LastRow = 0;
};

/// A vertex that is looked at. Reach and Distance2 are compared to decide.
struct VertexSite
{
  const AxisEntry* Column;
  const AxisEntry* Row;
  const DepthTable* Depth;
  std::uint64_t Position;
  double Reach;
  double Distance2;
  HierarchyRecord Record;
  std::uint32_t Index;
};

/// A triangle of the hierarchy: the ends of its hypotenuse and its apex as indices of the sink, the
/// vertex that halves it, and from there the ways to the apex and to the left end.
struct TriangleSite
{
  std::uint64_t Position;
  std::int64_t ToApex;
  std::int64_t ToLeft;
  const DepthTable* Depth;
  std::uint32_t Left;
  std::uint32_t Apex;
  std::uint32_t Right;
  std::uint32_t Middle;
  std::uint32_t PlaneMask;
  /// Only with holes: the triangle's direction, and the drawn bits of the vertex.
  std::uint32_t Direction;
  std::uint32_t Drawn;
};

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
 * Sink gives active vertices an index and takes the strip:
 *   std::uint32_t Vertex(const RefinementFrame&, const VertexSite&, left, right)
 *   void Prefetch(record), ahead of Vertex
 *   void Append(index); void Reserve(); std::uint32_t Count(); std::uint32_t Last();
 *   void RepeatThird(); bool Stopped()
 */
template <typename Traits, typename Sink>
class RefinementKernel
{
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
      TriangleSite triangle = this->BaseTriangle(centre, centreIndex, corners, side);
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
      TriangleSite triangle = this->BaseTriangle(centre, centreIndex, corners, side);
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

  TriangleSite BaseTriangle(std::uint64_t centre, std::uint32_t centreIndex,
    const std::array<std::uint32_t, 4>& corners, int side) const
  {
    static constexpr std::array<int, 5> round{ { 0, 1, 3, 2, 0 } };
    const int direction = (2 + 2 * side) & 7;
    const std::int64_t half = std::int64_t(1) << this->Frame.Depths[0].Shift;
    TriangleSite triangle{};
    triangle.Depth = &this->Frame.Depths[1];
    triangle.PlaneMask = (1u << this->Frame.PlaneCount) - 1u;
    triangle.Direction = static_cast<std::uint32_t>(direction);
    triangle.ToApex = half * Unit(direction);
    triangle.ToLeft = half * Unit((direction + 2) & 7);
    triangle.Position = centre - static_cast<std::uint64_t>(triangle.ToApex);
    triangle.Left = corners[round[side]];
    triangle.Right = corners[round[side + 1]];
    triangle.Apex = centreIndex;
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
  TERRAIN_INLINE TriangleSite Half(const TriangleSite& triangle, int side) const
  {
    const std::int64_t sum = (triangle.ToLeft + triangle.ToApex) >> 1;
    const std::int64_t difference = (triangle.ToLeft - triangle.ToApex) >> 1;
    TriangleSite half;
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
    return half;
  }

  /// The vertex that halves the triangle.
  TERRAIN_INLINE VertexSite Site(const TriangleSite& triangle) const
  {
    const DepthTable& depth = *triangle.Depth;
    VertexSite site;
    site.Depth = &depth;
    site.Position = triangle.Position;
    site.Column = &depth.Columns[static_cast<std::uint32_t>(triangle.Position) >> depth.Shift];
    site.Row = &depth.Rows[static_cast<std::uint32_t>(triangle.Position >> 32) >> depth.Shift];
    site.Index = site.Column->Term + site.Row->Term;
    return site;
  }

  /// Fetches what is known of the vertices that halve the triangle's halves. Most of them are
  /// looked at soon, and whether they take part is hard to predict: the answer should not wait for
  /// memory.
  TERRAIN_INLINE void Prefetch(const TriangleSite& triangle) const
  {
    if constexpr (!Traits::Distance)
    {
      if (!this->IsFinest(triangle))
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
  TERRAIN_INLINE bool IsNeeded(VertexSite& site) const
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
      site.Reach = site.Record.Error() * this->Frame.ErrorScale +
        site.Record.Radius() * this->Frame.RadiusScale;
      site.Distance2 += dz * dz;
      // Both tests at once: the second alone decides too seldom for a branch of its own.
      return (int(site.Reach * site.Reach > site.Distance2) & int(site.Record.HasError())) != 0;
    }
  }

  /// Completes a triangle whose vertex is needed; false if the vertex is culled.
  TERRAIN_INLINE bool Split(TriangleSite& triangle, const VertexSite& site)
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
    if constexpr (Traits::Holes)
    {
      triangle.Drawn = site.Record.Drawn();
    }
    triangle.Middle = this->Out.Vertex(this->Frame, site, triangle.Left, triangle.Right);
    return true;
  }

  /// True if the vertex that halves the triangle is active; completes the triangle then.
  TERRAIN_INLINE bool Visit(TriangleSite& triangle)
  {
    VertexSite site = this->Site(triangle);
    return this->IsNeeded(site) && this->Split(triangle, site);
  }

  /// True if the sphere is outside some plane of the mask; planes that it is inside of leave it.
  TERRAIN_NO_INLINE bool IsCulled(const VertexSite& site, std::uint32_t& mask) const
  {
    const glm::dvec3 centre =
      this->Frame.Step * glm::dvec3(site.Column->Sample, site.Row->Sample, site.Record.Height);
    const double radius = site.Record.Radius();
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
  void Leaf(const TriangleSite& triangle, bool drawn)
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
  void BothLeaves(const TriangleSite& triangle)
  {
    this->template LeftLeaf<In, Last>(triangle, this->Half(triangle, 0));
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, this->Half(triangle, 1));
  }

  template <StripEdge In, bool Last>
  void LeftLeaf(const TriangleSite& triangle, const TriangleSite& left)
  {
    this->template Leaf<Flip(In), StripEdge::Side, Last>(
      left, HalfDrawn(triangle.Drawn, left.Direction));
  }

  template <StripEdge Exit, bool Last>
  void RightLeaf(const TriangleSite& triangle, const TriangleSite& right)
  {
    this->template Leaf<StripEdge::Side, Flip(Exit), Last>(
      right, HalfDrawn(triangle.Drawn, right.Direction));
  }

  bool IsFinest(const TriangleSite& triangle) const
  {
    return triangle.Depth >= this->Frame.Deepest;
  }

  /// A triangle that is split, and whose halves may both be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void General(const TriangleSite& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    TriangleSite left = this->Half(triangle, 0);
    TriangleSite right = this->Half(triangle, 1);
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
      this->template LeftOnly<Flip(In), StripEdge::Side, Last>(left);
      this->template RightLeaf<Exit, true>(triangle, right);
    }
    else
    {
      this->template LeftLeaf<In, Last>(triangle, left);
      if (isRightActive)
      {
        this->template RightOnly<StripEdge::Side, Flip(Exit), In == StripEdge::Bottom>(right);
      }
      else
      {
        this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
      }
    }
  }

  /// A triangle that is split, and whose right half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void LeftOnly(const TriangleSite& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    TriangleSite left = this->Half(triangle, 0);
    if (this->Visit(left))
    {
      this->template LeftOnly<Flip(In), StripEdge::Side, Last>(left);
      this->template RightLeaf<Exit, true>(triangle, this->Half(triangle, 1));
      return;
    }
    this->template LeftLeaf<In, Last>(triangle, left);
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, this->Half(triangle, 1));
  }

  /// A triangle that is split, and whose left half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void RightOnly(const TriangleSite& triangle)
  {
    this->Out.Reserve();
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      return;
    }
    this->template LeftLeaf<In, Last>(triangle, this->Half(triangle, 0));
    TriangleSite right = this->Half(triangle, 1);
    if (this->Visit(right))
    {
      this->template RightOnly<StripEdge::Side, Flip(Exit), In == StripEdge::Bottom>(right);
      return;
    }
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
  }

  void PlainTriangle(TriangleSite& triangle, bool drawn)
  {
    this->Out.Reserve();
    const bool isActive = triangle.Depth <= this->Frame.Deepest && this->Visit(triangle);
    if (isActive)
    {
      TriangleSite left = this->Half(triangle, 0);
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
      TriangleSite right = this->Half(triangle, 1);
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
