// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The inner loops of Refinement.h. Positions are columns + 2^32 rows, in cells; with detail
 * (RefinementDetail.h) in detail cells.
 */
#ifndef terrain_RefinementKernel_h
#define terrain_RefinementKernel_h

#include "core/RefinementVisits.h"

#include <array>

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
 * right); void Repeat(index), for the second triangle of a vertex; void Append(index); void
 * Reserve(); std::uint32_t Count(); std::uint32_t Last(); void RepeatThird(); bool Stopped()
 */
template <typename Traits, typename Sink>
class RefinementKernel : private RefinementVisits<Traits, Sink>
{
  using Visits = RefinementVisits<Traits, Sink>;
  using typename Visits::Triangle;

public:
  RefinementKernel(const RefinementFrame& frame, Sink& sink, WaitingVertices& waiting)
    : Visits(frame, sink, waiting)
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
          triangle, Visits::HalfDrawn(drawn, triangle.Direction));
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
      this->PlainTriangle(triangle, Visits::HalfDrawn(drawn, triangle.Direction));
      if (!Traits::Holes)
      {
        this->PlainAppend(triangle.Right, 1);
      }
    }
  }

private:
  /// A triangle that is not split. Last: the left end of its hypotenuse is the strip's last index;
  /// otherwise it is the other end of the entering edge.
  template <StripEdge In, StripEdge Exit, bool Last>
  void Leaf(const Triangle& triangle, bool drawn)
  {
    constexpr bool sides = In == StripEdge::Side && Exit == StripEdge::Side;
    constexpr bool leavesBottom = Exit == StripEdge::Bottom;
    this->Pass(triangle, drawn);
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
      left, Visits::HalfDrawn(triangle.Drawn, left.Direction));
  }

  template <StripEdge Exit, bool Last>
  void RightLeaf(const Triangle& triangle, const Triangle& right)
  {
    this->template Leaf<StripEdge::Side, Flip(Exit), Last>(
      right, Visits::HalfDrawn(triangle.Drawn, right.Direction));
  }

  bool IsFinest(const Triangle& triangle) const
  {
    return triangle.Depth >= this->Frame.Deepest;
  }

  /// A triangle that is split, and whose halves may both be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void General(const Triangle& triangle)
  {
    const std::uint32_t entered = this->Enter(triangle);
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      this->Leave(triangle, entered);
      return;
    }
    this->PrefetchBelow(triangle);
    Triangle left = this->Half(triangle, 0);
    Triangle right = this->Half(triangle, 1);
    const bool isLeftActive = this->Visit(left);
    if (!isLeftActive)
    {
      this->Pass(left, !this->IsHole(triangle, left));
    }
    const bool isRightActive = this->Visit(right, isLeftActive ? left.Waiting : 0);
    if (isLeftActive && isRightActive)
    {
      this->template General<Flip(In), StripEdge::Side, Last>(left);
      this->template General<StripEdge::Side, Flip(Exit), true>(right);
    }
    else if (isLeftActive)
    {
      this->template LeftBeside<Flip(In), Last>(left, this->IsHole(triangle, right));
      this->template RightLeaf<Exit, true>(triangle, right);
    }
    else
    {
      this->template LeftLeaf<In, Last>(triangle, left);
      if (isRightActive)
      {
        this->template RightBeside<Flip(Exit), In == StripEdge::Bottom>(
          right, this->IsHole(triangle, left));
      }
      else
      {
        this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
      }
    }
    this->Leave(triangle, entered);
  }

  /// A left half beside a right one that is not split: that forbids to split the edge between them,
  /// unless nothing is drawn there.
  template <StripEdge In, bool Last>
  void LeftBeside(const Triangle& left, bool hole)
  {
    if (hole)
    {
      this->template General<In, StripEdge::Side, Last>(left);
      return;
    }
    this->template LeftOnly<In, StripEdge::Side, Last>(left);
  }

  /// The same with sides changed.
  template <StripEdge Exit, bool Last>
  void RightBeside(const Triangle& right, bool hole)
  {
    if (hole)
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
    const std::uint32_t entered = this->Enter(triangle);
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      this->Leave(triangle, entered);
      return;
    }
    Triangle left = this->Half(triangle, 0);
    if (this->Visit(left))
    {
      this->template LeftBeside<Flip(In), Last>(
        left, this->IsHole(triangle, this->Half(triangle, 1)));
      this->template RightLeaf<Exit, true>(triangle, this->Half(triangle, 1));
    }
    else
    {
      this->template LeftLeaf<In, Last>(triangle, left);
      this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, this->Half(triangle, 1));
    }
    this->Leave(triangle, entered);
  }

  /// A triangle that is split, and whose left half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  void RightOnly(const Triangle& triangle)
  {
    const std::uint32_t entered = this->Enter(triangle);
    if (this->IsFinest(triangle))
    {
      this->template BothLeaves<In, Exit, Last>(triangle);
      this->Leave(triangle, entered);
      return;
    }
    this->template LeftLeaf<In, Last>(triangle, this->Half(triangle, 0));
    Triangle right = this->Half(triangle, 1);
    if (this->Visit(right))
    {
      this->template RightBeside<Flip(Exit), In == StripEdge::Bottom>(
        right, this->IsHole(triangle, this->Half(triangle, 0)));
    }
    else
    {
      this->template RightLeaf<Exit, In == StripEdge::Bottom>(triangle, right);
    }
    this->Leave(triangle, entered);
  }

  /// Looks at every vertex from both of its triangles.
  void PlainTriangle(Triangle& triangle, bool drawn)
  {
    this->Out.Reserve();
    const bool isActive =
      triangle.Depth <= this->Frame.Deepest && this->template Test<true>(triangle);
    const std::uint32_t entered = isActive ? this->Enter(triangle) : 0;
    if (isActive)
    {
      Triangle left = this->Half(triangle, 0);
      this->PlainTriangle(left, Visits::HalfDrawn(triangle.Drawn, left.Direction));
    }
    else
    {
      this->Pass(triangle, drawn);
      this->PlainLeaf(triangle, drawn);
    }
    if (!Traits::Holes)
    {
      this->PlainAppend(triangle.Apex, triangle.Depth->IsOdd ? 0 : 1);
    }
    if (isActive)
    {
      Triangle right = this->Half(triangle, 1);
      this->PlainTriangle(right, Visits::HalfDrawn(triangle.Drawn, right.Direction));
      this->Leave(triangle, entered);
    }
  }

  void PlainLeaf(const Triangle& triangle, bool drawn)
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

  std::int64_t TriangleCount = 0;
  bool Broken = false;
  std::uint32_t Before = 0;
  std::uint32_t Newest = 0;
  int Parity = 0;
};
}

#endif
