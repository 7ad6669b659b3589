// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The strip through a refinement's triangles by the improved procedures (Refinement.h).
 */
#ifndef terrain_RefinementStrip_h
#define terrain_RefinementStrip_h

#include "core/strips/RefinementBuffers.h"

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
 * The three procedures. Triangles: with Left, Apex and Right, indices of the strip, Half(), which
 * makes a half without knowing whether it is split, IsSplit(), which finds out and completes the
 * triangle, IsFinest(), whose halves never are split, and IsDrawn().
 */
template <typename Triangles>
class RefinementStrip
{
  using Triangle = typename Triangles::Triangle;

public:
  RefinementStrip(const Triangles& triangles, AppendBuffer<std::uint32_t>& strip)
    : All(triangles)
    , Strip(strip)
  {
  }

  /// Triangles that are drawn.
  std::int64_t Count() const
  {
    return this->TriangleCount;
  }

  /// The whole square: four triangles round its centre, the halves of the south-eastern and those
  /// of the north-western half.
  void Run(std::array<Triangle, 4>& triangles)
  {
    this->Broken = Triangles::Holes;
    End end = this->Strip.Reserved();
    if (!Triangles::Holes)
    {
      // The first index stands for the other end of the first triangle's entering edge: there the
      // strip turns, so it is the third.
      *end++ = triangles[0].Left;
      *end++ = triangles[0].Left;
    }
    for (Triangle& triangle : triangles)
    {
      if (this->All.IsSplit(triangle))
      {
        end = this->template General<StripEdge::Side, StripEdge::Side, true>(triangle, end);
      }
      else
      {
        end = this->template Leaf<StripEdge::Side, StripEdge::Side, true>(triangle, end);
      }
    }
    this->Strip.SetEnd(end);
    if (!Triangles::Holes)
    {
      this->Strip[0] = this->Strip[2];
    }
  }

private:
  /// Where the strip goes on: the procedures pass it on, so that it stays in a register.
  using End = std::uint32_t*;

  /// A triangle that is not split. Last: the left end of its hypotenuse is the strip's last index;
  /// otherwise it is the other end of the entering edge.
  template <StripEdge In, StripEdge Exit, bool Last>
  End Leaf(const Triangle& triangle, End end)
  {
    constexpr bool sides = In == StripEdge::Side && Exit == StripEdge::Side;
    constexpr bool leavesBottom = Exit == StripEdge::Bottom;
    if constexpr (Triangles::Holes)
    {
      if (!Triangles::IsDrawn(triangle))
      {
        this->Broken = true;
        return end;
      }
      if (this->Broken)
      {
        ++this->TriangleCount;
        return this->Start(end, leavesBottom ? triangle.Apex : triangle.Left,
          sides ? triangle.Apex : (leavesBottom ? triangle.Left : triangle.Right),
          In == StripEdge::Bottom ? triangle.Apex : triangle.Right, triangle.IsOdd != sides);
      }
    }
    // The strip turns round the vertex that the entering and the leaving edge share.
    constexpr bool turns = leavesBottom ? !Last : Last;
    if constexpr (turns)
    {
      *end++ = sides ? triangle.Apex : (leavesBottom ? triangle.Left : triangle.Right);
    }
    *end++ = In == StripEdge::Bottom ? triangle.Apex : triangle.Right;
    ++this->TriangleCount;
    return end;
  }

  /// Goes on at the triangle (first, second, third) after a gap, joined by degenerate triangles.
  TERRAIN_NO_INLINE End Start(
    End end, std::uint32_t first, std::uint32_t second, std::uint32_t third, bool counterClockwise)
  {
    const std::uint32_t* const begin = &this->Strip[0];
    if (end != begin)
    {
      *end = end[-1];
      ++end;
      *end++ = first;
    }
    *end++ = first;
    if ((((end - begin) & 1) != 0) != counterClockwise)
    {
      *end++ = first;
    }
    *end++ = second;
    *end++ = third;
    this->Broken = false;
    return end;
  }

  template <StripEdge In, StripEdge Exit, bool Last>
  End BothLeaves(const Triangle& left, const Triangle& right, End end)
  {
    end = this->template Leaf<Flip(In), StripEdge::Side, Last>(left, end);
    return this->template Leaf<StripEdge::Side, Flip(Exit), In == StripEdge::Bottom>(right, end);
  }

  /// A triangle that is split, and whose halves may both be.
  template <StripEdge In, StripEdge Exit, bool Last>
  End General(const Triangle& triangle, End end)
  {
    end = this->Strip.Reserve(end);
    Triangle left = this->All.Half(triangle, 0);
    Triangle right = this->All.Half(triangle, 1);
    if (this->All.IsFinest(triangle))
    {
      return this->template BothLeaves<In, Exit, Last>(left, right, end);
    }
    const bool isLeftSplit = this->All.IsSplit(left);
    const bool isRightSplit = this->All.IsSplit(right);
    if (isLeftSplit && isRightSplit)
    {
      end = this->template General<Flip(In), StripEdge::Side, Last>(left, end);
      return this->template General<StripEdge::Side, Flip(Exit), true>(right, end);
    }
    if (isLeftSplit)
    {
      end = this->template LeftOf<Flip(In), Last>(left, end);
      return this->template Leaf<StripEdge::Side, Flip(Exit), true>(right, end);
    }
    if (isRightSplit)
    {
      end = this->template Leaf<Flip(In), StripEdge::Side, Last>(left, end);
      return this->template RightOf<Flip(Exit), In == StripEdge::Bottom>(right, end);
    }
    return this->template BothLeaves<In, Exit, Last>(left, right, end);
  }

  /// A left half beside a right one that is not split: that forbids to split the edge between them,
  /// unless nothing is drawn there.
  template <StripEdge In, bool Last>
  TERRAIN_INLINE End LeftOf(const Triangle& left, End end)
  {
    if constexpr (Triangles::Holes)
    {
      return this->template General<In, StripEdge::Side, Last>(left, end);
    }
    else
    {
      return this->template LeftOnly<In, StripEdge::Side, Last>(left, end);
    }
  }

  /// The same with sides changed.
  template <StripEdge Exit, bool Last>
  TERRAIN_INLINE End RightOf(const Triangle& right, End end)
  {
    if constexpr (Triangles::Holes)
    {
      return this->template General<StripEdge::Side, Exit, Last>(right, end);
    }
    else
    {
      return this->template RightOnly<StripEdge::Side, Exit, Last>(right, end);
    }
  }

  /// A triangle that is split, and whose right half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  End LeftOnly(const Triangle& triangle, End end)
  {
    end = this->Strip.Reserve(end);
    Triangle left = this->All.Half(triangle, 0);
    const Triangle right = this->All.Half(triangle, 1);
    if (!this->All.IsFinest(triangle) && this->All.IsSplit(left))
    {
      end = this->template LeftOf<Flip(In), Last>(left, end);
      return this->template Leaf<StripEdge::Side, Flip(Exit), true>(right, end);
    }
    return this->template BothLeaves<In, Exit, Last>(left, right, end);
  }

  /// A triangle that is split, and whose left half cannot be.
  template <StripEdge In, StripEdge Exit, bool Last>
  End RightOnly(const Triangle& triangle, End end)
  {
    end = this->Strip.Reserve(end);
    const Triangle left = this->All.Half(triangle, 0);
    Triangle right = this->All.Half(triangle, 1);
    if (!this->All.IsFinest(triangle) && this->All.IsSplit(right))
    {
      end = this->template Leaf<Flip(In), StripEdge::Side, Last>(left, end);
      return this->template RightOf<Flip(Exit), In == StripEdge::Bottom>(right, end);
    }
    return this->template BothLeaves<In, Exit, Last>(left, right, end);
  }

  Triangles All;
  AppendBuffer<std::uint32_t>& Strip;
  std::int64_t TriangleCount = 0;
  bool Broken = false;
};

/// Makes the strip through a square of four triangles in the memory of `strip`; returns the number
/// of triangles.
template <typename Triangles>
std::int64_t StripThrough(const Triangles& triangles,
  std::array<typename Triangles::Triangle, 4>& square, std::vector<std::uint32_t>& strip)
{
  AppendBuffer<std::uint32_t> indices;
  indices.Begin(strip);
  indices.Reserve();
  RefinementStrip<Triangles> procedures(triangles, indices);
  procedures.Run(square);
  indices.Finish(strip);
  return procedures.Count();
}
}

#endif
