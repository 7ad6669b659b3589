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

namespace terrain
{
/// A column or row of vertices: where it is drawn, its term of the record index, its sample.
struct AxisEntry
{
  double Position;
  std::uint32_t Term;
  std::uint32_t Sample;
};

/// What all vertices of a depth share.
struct DepthTable
{
  const AxisEntry* Columns = nullptr;
  const AxisEntry* Rows = nullptr;
  int Shift = 0;
  /// From the vertex of a triangle to that of its half of this depth in each direction.
  std::array<std::uint64_t, 8> Offsets{};
  /// Distance below which a vertex is active, squared (RefineByDistance).
  double Range2 = 0.0;
};

/// One refinement: the view in the scaled space where positions are tabulated. Scaling by
/// 1 / max(1, exaggeration) lets the radii hold whatever the exaggeration.
struct RefinementFrame
{
  std::array<DepthTable, 32> Depths;
  int DepthCount = 0;
  const HierarchyRecord* Records = nullptr;
  glm::dvec3 Eye{ 0.0 };
  /// Height unit in scaled space.
  double HeightScale = 1.0;
  /// Active: (Error ErrorScale + Radius RadiusScale)^2 > d^2 DistanceScale + DistanceOffset. In
  /// perspective that is Error lambda / tolerance > d - Radius, in parallel projection Error lambda
  /// / tolerance > 1.
  double ErrorScale = 0.0;
  double RadiusScale = 1.0;
  double DistanceScale = 1.0;
  double DistanceOffset = 0.0;
  std::array<glm::dvec4, 8> Planes{};
  int PlaneCount = 0;
  /// Vertices of this depth and deeper are not culled.
  int LazyDepth = 32;
  std::uint32_t LastColumn = 0;
  std::uint32_t LastRow = 0;
};

/// A vertex that is looked at.
struct VertexSite
{
  const AxisEntry* Column;
  const AxisEntry* Row;
  std::uint32_t Record;
  double Distance2;
  std::uint64_t Position;
  int Depth;
};

/// A triangle of the hierarchy: the ends of its hypotenuse and its apex as indices of the sink, and
/// the vertex that halves it.
struct TriangleSite
{
  std::uint64_t Position;
  std::uint32_t Left;
  std::uint32_t Apex;
  std::uint32_t Right;
  std::uint32_t Middle;
  std::uint32_t PlaneMask;
  std::uint32_t Drawn;
  int Depth;
  int Direction;
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
    const std::array<std::uint32_t, 4>& corners, std::uint32_t mask)
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
      if (this->Frame.DepthCount > 1 && this->Visit(triangle, mask))
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
    const std::array<std::uint32_t, 4>& corners, std::uint32_t mask)
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
      this->PlainTriangle(triangle, mask, HalfDrawn(drawn, triangle.Direction));
      if (!Traits::Holes)
      {
        this->PlainAppend(triangle.Right, 1);
      }
    }
  }

private:
  static bool HalfDrawn(std::uint32_t drawn, int direction)
  {
    return !Traits::Holes || ((drawn >> (direction >> 1)) & 1u) != 0;
  }

  TriangleSite BaseTriangle(std::uint64_t centre, std::uint32_t centreIndex,
    const std::array<std::uint32_t, 4>& corners, int side) const
  {
    static constexpr std::array<int, 5> round{ { 0, 1, 3, 2, 0 } };
    TriangleSite triangle{};
    triangle.Depth = 1;
    triangle.Direction = (2 + 2 * side) & 7;
    triangle.Position = centre + this->Frame.Depths[1].Offsets[triangle.Direction];
    triangle.Left = corners[round[side]];
    triangle.Right = corners[round[side + 1]];
    triangle.Apex = centreIndex;
    return triangle;
  }

  /// Half of a triangle that is split: side 0 left, 1 right.
  TriangleSite Half(const TriangleSite& triangle, int side) const
  {
    TriangleSite half{};
    half.Depth = triangle.Depth + 1;
    half.Direction = HierarchyLayout::ChildDirection(triangle.Depth, triangle.Direction, side);
    half.Position = triangle.Position + this->Frame.Depths[half.Depth].Offsets[half.Direction];
    half.Left = side == 0 ? triangle.Left : triangle.Apex;
    half.Right = side == 0 ? triangle.Apex : triangle.Right;
    half.Apex = triangle.Middle;
    return half;
  }

  /// True if the vertex that halves the triangle is active; completes the triangle then.
  bool Visit(TriangleSite& triangle, std::uint32_t mask)
  {
    const DepthTable& depth = this->Frame.Depths[triangle.Depth];
    VertexSite site;
    site.Column = &depth.Columns[static_cast<std::uint32_t>(triangle.Position) >> depth.Shift];
    site.Row = &depth.Rows[static_cast<std::uint32_t>(triangle.Position >> 32) >> depth.Shift];
    site.Position = triangle.Position;
    site.Depth = triangle.Depth;
    const double dx = site.Column->Position - this->Frame.Eye.x;
    const double dy = site.Row->Position - this->Frame.Eye.y;
    if constexpr (Traits::Distance)
    {
      const double dz = this->Frame.Eye.z;
      if (!(dx * dx + dy * dy + dz * dz < depth.Range2))
      {
        return false;
      }
    }
    else
    {
      site.Record = site.Column->Term + site.Row->Term;
      const HierarchyRecord& record = this->Frame.Records[site.Record];
      const double error = record.Error();
      const double radius = record.Radius();
      const double z = record.Height * this->Frame.HeightScale;
      const double dz = z - this->Frame.Eye.z;
      const double reach = error * this->Frame.ErrorScale + radius * this->Frame.RadiusScale;
      site.Distance2 =
        (dx * dx + dy * dy + dz * dz) * this->Frame.DistanceScale + this->Frame.DistanceOffset;
      if (!(reach * reach > site.Distance2) || error == 0.0)
      {
        return false;
      }
      if (Traits::Culling && mask != 0 && triangle.Depth < this->Frame.LazyDepth &&
        this->IsCulled(glm::dvec3(site.Column->Position, site.Row->Position, z), radius, mask))
      {
        return false;
      }
      triangle.Drawn = record.Drawn();
    }
    if (this->Out.Stopped())
    {
      return false;
    }
    triangle.PlaneMask = mask;
    triangle.Middle = this->Out.Vertex(this->Frame, site, triangle.Left, triangle.Right);
    return true;
  }

  /// True if the sphere is outside some plane of the mask; planes that it is inside of leave it.
  bool IsCulled(const glm::dvec3& centre, double radius, std::uint32_t& mask) const
  {
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
          In == StripEdge::Bottom ? triangle.Apex : triangle.Right,
          ((triangle.Depth & 1) != 0) != sides);
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
  void Start(std::uint32_t first, std::uint32_t second, std::uint32_t third, bool counterClockwise)
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
    return triangle.Depth + 1 >= this->Frame.DepthCount;
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
    const bool isLeftActive = this->Visit(left, triangle.PlaneMask);
    const bool isRightActive = this->Visit(right, triangle.PlaneMask);
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
    if (this->Visit(left, triangle.PlaneMask))
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
    if (this->Visit(right, triangle.PlaneMask))
    {
      this->template RightOnly<StripEdge::Side, Flip(Exit), In == StripEdge::Bottom>(right);
      return;
    }
    this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
  }

  void PlainTriangle(TriangleSite& triangle, std::uint32_t mask, bool drawn)
  {
    this->Out.Reserve();
    const bool isActive = triangle.Depth < this->Frame.DepthCount && this->Visit(triangle, mask);
    if (isActive)
    {
      TriangleSite left = this->Half(triangle, 0);
      this->PlainTriangle(left, triangle.PlaneMask, HalfDrawn(triangle.Drawn, left.Direction));
    }
    else if (drawn)
    {
      ++this->TriangleCount;
      if (Traits::Holes)
      {
        // Strips with gaps are not part of the plain procedure: each triangle starts anew.
        this->Start(triangle.Left, triangle.Right, triangle.Apex, (triangle.Depth & 1) != 0);
      }
    }
    if (!Traits::Holes)
    {
      this->PlainAppend(triangle.Apex, (triangle.Depth & 1) ^ 1);
    }
    if (isActive)
    {
      TriangleSite right = this->Half(triangle, 1);
      this->PlainTriangle(right, triangle.PlaneMask, HalfDrawn(triangle.Drawn, right.Direction));
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
