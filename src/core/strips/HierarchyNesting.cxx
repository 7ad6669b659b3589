// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyNesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
/// A corner of a diamond: where it is drawn, in cells, and its height.
struct Corner
{
  glm::dvec2 Position;
  double Height;
};

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Height over `position` on the line through two corners.
double AlongLine(const Corner& left, const Corner& right, const glm::dvec2& position)
{
  const glm::dvec2 line = right.Position - left.Position;
  const double length2 = glm::dot(line, line);
  const double t =
    length2 > 0.0 ? std::clamp(glm::dot(position - left.Position, line) / length2, 0.0, 1.0) : 0.0;
  return left.Height + t * (right.Height - left.Height);
}

/// Height of the plane through three corners at `position`; `area` is twice their signed area.
double OnPlane(
  const Corner& a, const Corner& b, const Corner& c, double area, const glm::dvec2& position)
{
  const double wa = Cross(b.Position - position, c.Position - position) / area;
  const double wb = Cross(c.Position - position, a.Position - position) / area;
  return wa * a.Height + wb * b.Height + (1.0 - wa - wb) * c.Height;
}

class Nesting
{
public:
  Nesting(const HierarchyTarget& target, int depth)
    : Target(target)
    , Layout(*target.Layout)
    , Depth(depth)
    , Pair(depth / 2)
    , Step(this->Layout.Step(this->Pair))
    , ChildDepth(depth + 1)
    , ChildPair((depth + 1) / 2)
    , ChildStep(this->Layout.Step(this->ChildPair))
    , ChildShift(this->Layout.Shift(this->ChildPair))
  {
  }

  /// Nests the vertices of row y, in steps.
  void Row(std::int64_t y) const
  {
    const bool odd = (this->Depth & 1) != 0;
    const std::int64_t first = odd ? (y & 1) ^ 1 : 1;
    if (!odd && (y & 1) == 0)
    {
      return;
    }
    for (std::int64_t x = first; x < this->Layout.Count(this->Pair, 0); x += 2)
    {
      this->Vertex(x, y);
    }
  }

private:
  /// What a vertex takes from its children.
  struct Children
  {
    float Error = 0.0f;
    double Radius = 0.0;
    std::uint32_t Drawn = 0;
    std::uint32_t Outside = 0;
    bool Rough = false;
  };

  void Vertex(std::int64_t xStep, std::int64_t yStep) const
  {
    const std::int64_t x = xStep * this->Step;
    const std::int64_t y = yStep * this->Step;
    HierarchyRecord& record = this->Target.Records[this->Layout.Index(this->Pair, xStep, yStep)];
    Children children;
    for (int bit = 0; bit < 4; ++bit)
    {
      this->TakeChild(x, y, record, bit, children);
    }
    const int direction = HierarchyLayout::DiamondDirection(this->Pair, xStep, yStep);
    const bool across = this->Layout.IsAcrossBorder(this->Pair, x, y);
    const DiamondState state(
      direction, across && (this->Depth & 1) == 0, children.Drawn, children.Outside);
    float error = record.Error();
    if (!state.HasSurface)
    {
      error = 0.0f;
    }
    else if (direction < 0)
    {
      error = std::numeric_limits<float>::max();
    }
    else if (state.IsMixed)
    {
      error = static_cast<float>(this->Diameter());
    }
    else if (!std::isfinite(error))
    {
      error = static_cast<float>(this->Change(x, y, record, direction, across)) + children.Error;
    }
    record.SetError(std::max(error, children.Error));
    record.SetRadius(static_cast<float>(children.Radius * (1.0 + kRadiusSlack)));
    record.SetDrawn(children.Drawn);
    record.SetRough(children.Rough || state.IsMixed || (across && state.HasSurface));
  }

  /// Adds the child that halves the triangle of the given bit.
  void TakeChild(std::int64_t x, std::int64_t y, const HierarchyRecord& record, int bit,
    Children& children) const
  {
    const int direction = 2 * bit + ((this->ChildDepth & 1) ^ 1);
    const std::int64_t cx = x - this->ChildStep * HierarchyLayout::Directions[direction][0];
    const std::int64_t cy = y - this->ChildStep * HierarchyLayout::Directions[direction][1];
    const std::int64_t column = cx >> this->ChildShift;
    const std::int64_t row = cy >> this->ChildShift;
    if (cx < 0 || cy < 0 || column >= this->Layout.Count(this->ChildPair, 0) ||
      row >= this->Layout.Count(this->ChildPair, 1))
    {
      children.Outside |= 1u << bit;
      return;
    }
    const HierarchyRecord& child =
      this->Target.Records[this->Layout.Index(this->ChildPair, column, row)];
    if (this->Layout.IsOutside(this->ChildDepth, cx, cy, direction))
    {
      children.Outside |= 1u << bit;
    }
    else if (this->IsDrawn(child, cx, cy, direction))
    {
      children.Drawn |= 1u << bit;
    }
    if (child.Error() > 0.0f || child.Drawn() != 0)
    {
      children.Error = std::max(children.Error, child.Error());
      children.Rough = children.Rough || child.IsRough();
      children.Radius =
        std::max(children.Radius, this->Distance(x, y, record, cx, cy, child) + child.Radius());
    }
  }

  /// True if the triangle in `direction` that a child halves has a surface everywhere.
  bool IsDrawn(const HierarchyRecord& child, std::int64_t x, std::int64_t y, int direction) const
  {
    const bool together =
      (this->ChildDepth & 1) == 0 && this->Layout.IsAcrossBorder(this->ChildPair, x, y);
    const std::uint32_t mask = together ? HierarchyRecord::DrawnBits : TriangleMask(direction);
    if ((child.Drawn() & mask) == mask)
    {
      return true;
    }
    std::uint32_t outside = 0;
    for (int bit = 0; bit < 4; ++bit)
    {
      outside |= this->IsHalfOutside(x, y, bit) ? 1u << bit : 0u;
    }
    return (child.Drawn() & mask) != 0 && ((child.Drawn() | outside) & mask) == mask;
  }

  /// True if the triangle of a bit of the child at (x, y) is beyond the raster.
  bool IsHalfOutside(std::int64_t x, std::int64_t y, int bit) const
  {
    if (this->ChildDepth + 1 < this->Layout.Depths())
    {
      const int pair = (this->ChildDepth + 1) / 2;
      const int direction = 2 * bit + (this->ChildDepth & 1);
      const std::int64_t step = this->Layout.Step(pair);
      return this->Layout.IsOutside(this->ChildDepth + 1,
        x - step * HierarchyLayout::Directions[direction][0],
        y - step * HierarchyLayout::Directions[direction][1], direction);
    }
    // Half cells: south-west, south-east, north-east, north-west of the vertex.
    const std::int64_t cellX = bit == 0 || bit == 3 ? x - 1 : x;
    const std::int64_t cellY = bit < 2 ? y - 1 : y;
    return cellX < 0 || cellY < 0 || cellX >= this->Layout.Width() - 1 ||
      cellY >= this->Layout.Height() - 1;
  }

  double Distance(std::int64_t x, std::int64_t y, const HierarchyRecord& record, std::int64_t cx,
    std::int64_t cy, const HierarchyRecord& child) const
  {
    const glm::i64vec2 offset = this->Layout.Sample(x, y) - this->Layout.Sample(cx, cy);
    const double dx = static_cast<double>(offset.x) * this->Target.Geometry.Spacing.x;
    const double dy = static_cast<double>(offset.y) * this->Target.Geometry.Spacing.y;
    const double dz = static_cast<double>(record.Height) - child.Height;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }

  /// Length of the hypotenuse of a triangle of this depth, in model units.
  double Diameter() const
  {
    const glm::dvec2 side = 2.0 * static_cast<double>(this->Step) * this->Target.Geometry.Spacing;
    return (this->Depth & 1) != 0 ? std::max(side.x, side.y) : glm::length(side);
  }

  Corner CornerAt(std::int64_t x, std::int64_t y) const
  {
    const glm::i64vec2 sample = this->Layout.Sample(x, y);
    const int pair = this->Layout.PairOf(x, y);
    float height = 0.0f;
    if (pair < 0)
    {
      height = this->Target.Summary.Corners[(x != 0 ? 1 : 0) + (y != 0 ? 2 : 0)];
    }
    else
    {
      const int shift = this->Layout.Shift(pair);
      height = this->Target.Records[this->Layout.Index(pair, x >> shift, y >> shift)].Height;
    }
    return { glm::dvec2(sample), height };
  }

  /// Largest vertical distance between the surfaces of the diamond with the vertex and without it.
  double Change(
    std::int64_t x, std::int64_t y, const HierarchyRecord& record, int direction, bool across) const
  {
    const auto corner = [&](int turn)
    {
      const std::array<int, 2>& unit = HierarchyLayout::Directions[(direction + turn) & 7];
      return this->CornerAt(x + unit[0] * this->Step, y + unit[1] * this->Step);
    };
    const Corner left = corner(2);
    const Corner right = corner(6);
    if (!across)
    {
      return std::abs(record.Height - 0.5 * (left.Height + right.Height));
    }
    const glm::dvec2 position(this->Layout.Sample(x, y));
    const double side = Cross(right.Position - left.Position, position - left.Position);
    if (side == 0.0)
    {
      return std::abs(record.Height - AlongLine(left, right, position));
    }
    // The vertex is off the hypotenuse, in one of the triangles: the surfaces differ most at the
    // vertex, or where its edge to the other apex crosses the hypotenuse.
    Corner near = corner(0);
    Corner far = corner(4);
    const auto sideOf = [&](const Corner& apex)
    { return Cross(right.Position - left.Position, apex.Position - left.Position); };
    if (sideOf(near) * side < 0.0)
    {
      std::swap(near, far);
    }
    double change = 0.0;
    if (sideOf(near) != 0.0)
    {
      change = std::abs(record.Height - OnPlane(left, right, near, sideOf(near), position));
    }
    const double t = side / (side - sideOf(far));
    const glm::dvec2 crossing = position + t * (far.Position - position);
    return std::max(change,
      std::abs(
        record.Height + t * (far.Height - record.Height) - AlongLine(left, right, crossing)));
  }

  const HierarchyTarget& Target;
  const HierarchyLayout& Layout;
  int Depth;
  int Pair;
  std::int64_t Step;
  int ChildDepth;
  int ChildPair;
  std::int64_t ChildStep;
  int ChildShift;
};
}

void NestDepth(const HierarchyTarget& target, int depth, const ParallelFor& parallelFor)
{
  const Nesting nesting(target, depth);
  parallelFor(target.Layout->Count(depth / 2, 1),
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        nesting.Row(row);
      }
    });
}
}
