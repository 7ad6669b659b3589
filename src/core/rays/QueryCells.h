// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a ray meets in one cell, in double precision: the quadratics of core/rays/RayQuery.h.
 */
#ifndef terrain_QueryCells_h
#define terrain_QueryCells_h

#include "core/rays/SurfacePath.h"
#include "core/surface/SurfaceHeights.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace terrain
{
/// First t in 0..1 with c + b t + a t^2 = 0, where c and e are the values at 0 and 1; -1 if there
/// is none. There is one if c and e differ in sign.
inline double FirstRootBetween(double c, double e, double a)
{
  const double side = c < 0.0 ? -1.0 : 1.0;
  c *= side;
  e *= side;
  a *= side;
  if (c == 0.0)
  {
    return 0.0;
  }
  const double b = e - c - a;
  const double discriminant = b * b - 4.0 * a * c;
  const bool dips = b < 0.0 && b > -2.0 * a && discriminant >= 0.0;
  if (e > 0.0 && !dips)
  {
    return -1.0;
  }
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double t = b <= 0.0 ? 2.0 * c / (root - b) : (b + root) / (-2.0 * a);
  return std::clamp(t, 0.0, 1.0);
}

/// The part of a ray over one cell: from u = 0 to u = 1.
struct CellSegment
{
  /// Heights of the cell's corners relative to the origin of the ray's heights.
  glm::dvec4 Corners;
  /// Positions in the cell, 0..1.
  glm::dvec2 BeginXY;
  glm::dvec2 EndXY;
  /// Relative heights of the ray at both ends, and its bend: z(u) = BeginZ + u (EndZ - BeginZ) -
  /// Bend u (1 - u).
  double BeginZ;
  double EndZ;
  double Bend;

  double HeightAt(double u) const
  {
    return this->BeginZ + u * (this->EndZ - this->BeginZ) - this->Bend * u * (1.0 - u);
  }
  glm::dvec2 PositionAt(double u) const
  {
    return this->BeginXY + u * (this->EndXY - this->BeginXY);
  }
};

/// A stretch of a segment over which the ray's height minus the surface's is one quadratic
/// c + b t + a t^2 of t = 0..1, with the values c at its begin and e at its end.
struct CellStretch
{
  double BeginU = 0.0;
  double EndU = 1.0;
  double C = 0.0;
  double E = 0.0;
  double A = 0.0;
};

/// The stretches of a segment: one over a bilinear patch; over columns up to three, which meet at
/// walls.
struct CellStretches
{
  std::array<CellStretch, 3> Stretches{};
  int Count = 0;
  /// The axis along which wall i, at the end of stretch i, is crossed: 0 east, 1 north.
  std::array<int, 2> WallAxes{};

  /// The bilinear patch.
  static CellStretches OfPatch(const CellSegment& segment)
  {
    const glm::dvec2 move = segment.EndXY - segment.BeginXY;
    const glm::dvec4& h = segment.Corners;
    const double twist = (h.x - h.y) - (h.z - h.w);
    CellStretches result;
    result.Count = 1;
    result.Stretches[0] = { 0.0, 1.0, segment.BeginZ - PatchHeight(h, segment.BeginXY),
      segment.EndZ - PatchHeight(h, segment.EndXY), segment.Bend - twist * move.x * move.y };
    return result;
  }

  /// Quarters of the columns of the four corners.
  static CellStretches OfColumns(const CellSegment& segment)
  {
    CellStretches result;
    std::array<int, 2> quarter{};
    std::array<double, 2> walls{ 1.0, 1.0 };
    for (int axis = 0; axis < 2; ++axis)
    {
      const double begin = segment.BeginXY[axis];
      const double end = segment.EndXY[axis];
      quarter[static_cast<std::size_t>(axis)] = begin >= 0.5 ? 1 : 0;
      if ((begin >= 0.5) != (end >= 0.5))
      {
        walls[static_cast<std::size_t>(axis)] = std::clamp((0.5 - begin) / (end - begin), 0.0, 1.0);
        result.WallAxes[static_cast<std::size_t>(result.Count)] = axis;
        ++result.Count;
      }
    }
    if (result.Count == 2 && walls[1] < walls[0])
    {
      std::swap(result.WallAxes[0], result.WallAxes[1]);
    }
    ++result.Count;
    double begin = 0.0;
    for (int i = 0; i < result.Count; ++i)
    {
      const auto index = static_cast<std::size_t>(i);
      const bool last = i + 1 == result.Count;
      const double end = last ? 1.0 : walls[static_cast<std::size_t>(result.WallAxes[index])];
      const double column = segment.Corners[quarter[0] + 2 * quarter[1]];
      const double part = end - begin;
      const double beginZ = begin == 0.0 ? segment.BeginZ : segment.HeightAt(begin);
      const double endZ = last ? segment.EndZ : segment.HeightAt(end);
      result.Stretches[index] = { begin, end, beginZ - column, endZ - column,
        segment.Bend * part * part };
      begin = end;
      if (!last)
      {
        quarter[static_cast<std::size_t>(result.WallAxes[index])] ^= 1;
      }
    }
    return result;
  }

  /// Which stretch the segment first meets the surface in, -1 if in none, and where; or, if wall is
  /// set, the wall at which it begins. side: -1 or 1 if the ray is known to be below or above the
  /// surface where the segment begins, else 0.
  struct Meeting
  {
    int Stretch = -1;
    bool Wall = false;
    double U = 0.0;
  };
  Meeting First(double side) const
  {
    for (int i = 0; i < this->Count; ++i)
    {
      const CellStretch& stretch = this->Stretches[static_cast<std::size_t>(i)];
      if (side * stretch.C < 0.0)
      {
        return { i, i > 0, stretch.BeginU };
      }
      const double t = FirstRootBetween(stretch.C, stretch.E, stretch.A);
      if (t >= 0.0)
      {
        return { i, false, stretch.BeginU + t * (stretch.EndU - stretch.BeginU) };
      }
      side = stretch.E;
    }
    return {};
  }

  /// Highest the surface gets above the ray, and where.
  Highest Summit() const
  {
    Highest best{ 0.0, -kInfinity };
    for (int i = 0; i < this->Count; ++i)
    {
      const CellStretch& stretch = this->Stretches[static_cast<std::size_t>(i)];
      const Highest here =
        HighestOf(-stretch.C, -(stretch.E - stretch.C - stretch.A), -stretch.A, 0.0, 1.0);
      if (here.Value > best.Value)
      {
        best = { stretch.BeginU + here.Parameter * (stretch.EndU - stretch.BeginU), here.Value };
      }
    }
    return best;
  }
};
}

#endif
