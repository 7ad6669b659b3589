// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Refinement below the samples of a base, over repeated detail (DetailHierarchy.h).
 *
 * Bounds. Let s be the step of a vertex of the detail in base cells, S the base's largest slope
 * about the vertex, K the largest |h00 + h11 - h10 - h01| of the cells there, a half the detail's
 * range, all as scaled.
 *   Circle (Balogh, section 6.3): all descendants of a vertex at depth i are within r_i =
 * l_i / (1 - 1 / sqrt 2) of it, horizontally, l_i = l_0 (1 / sqrt 2)^i its distance to its
 * children.
 *   Sphere: around the base's surface over the vertex, R_i = sqrt(1 + S^2) r_i + a; it holds the
 * sum over the vertex's diamond and the spheres of all its descendants.
 *   Error: that of the detail, plus K s^2 (even depths) or K s^2 / 4 (odd ones), the most that a
 * patch of the base bends over such triangles.
 * A sample of the base keeps its sphere, inflated by the sphere of a vertex of the detail and the
 * way to it; its error is at least its own plus the detail's range, and that of any vertex of the
 * detail below it. So both stay nested throughout.
 *   About a vertex (BaseSteepness.h): over all tiles that touch a square around it which holds its
 * diamond and all its descendants: 3 s to each side for even depths, 2 s for odd ones, since
 * children are up to s and s / 2 away. Squares are nested and so are tiles, hence S and K.
 *
 * Departure. Balogh projects errors of the detail by the horizontal distance to the circle alone,
 * and that of base vertices by the nearer one of sphere and circle. Here a vertex of the detail is
 * active only if its error is too large at the distance of its circle and at that of its sphere,
 * which are both nested. So an eye high above the ground refines no detail below it, and vertices
 * of the base need their sphere alone.
 */
#ifndef terrain_RefinementDetail_h
#define terrain_RefinementDetail_h

#include "core/strips/BaseSteepness.h"
#include "core/strips/DetailHierarchy.h"
#include "core/strips/Hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace terrain
{
/// Position modulo the size of a table; `mask` is size - 1 for powers of two, else 0.
inline std::uint32_t Wrapped(std::uint32_t position, std::uint32_t size, std::uint32_t mask)
{
  return mask + 1 == size ? position & mask : position % size;
}

/// What is known of the base about a place.
struct BaseRelief
{
  /// sqrt(1 + S^2) as scaled, and K in height units.
  float Slant = 1.0f;
  float Twist = 0.0f;
};

/// The base's relief about the vertices of a depth.
struct ReliefTable
{
  const BaseRelief* Tiles = nullptr;
  /// log2 of the detail cells along a tile, and half the side of a vertex's square in detail cells.
  int Shift = 0;
  std::uint32_t Margin = 0;
  std::uint32_t Columns = 1;
  std::uint32_t LastColumn = 0;
  std::uint32_t LastRow = 0;

  /// The relief about detail cell (x, y).
  BaseRelief About(std::uint32_t x, std::uint32_t y) const
  {
    const std::uint32_t west = this->TileOf(x - std::min(x, this->Margin), this->LastColumn);
    const std::uint32_t south = this->TileOf(y - std::min(y, this->Margin), this->LastRow);
    const std::uint32_t east = this->TileOf(x + this->Margin, this->LastColumn);
    const std::uint32_t north = this->TileOf(y + this->Margin, this->LastRow);
    BaseRelief relief = this->TileAt(west, south);
    if (((west ^ east) | (south ^ north)) != 0)
    {
      // A tile is at least as large as a square, so these are all.
      for (const BaseRelief& other :
        { this->TileAt(east, south), this->TileAt(west, north), this->TileAt(east, north) })
      {
        relief.Slant = std::max(relief.Slant, other.Slant);
        relief.Twist = std::max(relief.Twist, other.Twist);
      }
    }
    return relief;
  }

private:
  std::uint32_t TileOf(std::uint32_t position, std::uint32_t last) const
  {
    return std::min(position >> this->Shift, last);
  }
  const BaseRelief& TileAt(std::uint32_t column, std::uint32_t row) const
  {
    return this->Tiles[column + std::size_t{ this->Columns } * row];
  }
};

/// What the vertices of a depth below the base's samples share. Lengths in scaled space.
struct DetailDepth
{
  const HierarchyRecord* Records = nullptr;
  int Shift = 0;
  glm::uvec2 Count{ 1, 1 };
  glm::uvec2 Mask{ 0, 0 };
  /// Radius of the circle, and what it is for distances: 0 in parallel projection.
  double Circle = 0.0;
  double CircleReach = 0.0;
  /// The rest of the sphere's radius: half the detail's range, and rounding.
  double Half = 0.0;
  /// Part of the error that is the base's, in units of its K, and the reach of that.
  double Bend = 0.0;
  double BendReach = 0.0;

  /// Record of the vertex at detail cell (x, y).
  const HierarchyRecord& Record(std::uint32_t x, std::uint32_t y) const
  {
    const std::uint32_t column = Wrapped(x >> this->Shift, this->Count.x, this->Mask.x);
    const std::uint32_t row = Wrapped(y >> this->Shift, this->Count.y, this->Mask.y);
    return this->Records[column + this->Count.x * row];
  }
};

/// What all vertices of a terrain with detail share.
struct DetailFrame
{
  const HierarchyView* Base = nullptr;
  const float* Heights = nullptr;
  glm::uvec2 Period{ 1, 1 };
  glm::uvec2 Mask{ 0, 0 };
  /// log2 of the detail cells along a base cell.
  int Level = 0;
  /// Factor of the detail's heights, and the middle of their range, scaled.
  float Scale = 1.0f;
  double Middle = 0.0;
  /// Heights of the base: corners of the square as in the summary, and its centre.
  std::array<float, 4> Corners{};
  float Centre = 0.0f;
  /// A detail cell in scaled space, for distances and for planes.
  glm::dvec2 Step{ 1.0 };
  glm::dvec2 PlaneStep{ 1.0 };
  /// Reach of an error of 1 in the detail's own heights.
  double ErrorScale = 0.0;
  /// What is added to errors of the base's samples, and the least that they are then, as reaches;
  /// more for each unit of K.
  double RangeReach = 0.0;
  double FloorReach = 0.0;
  double BendReach = 0.0;
  /// The circle that is added to their radii.
  double Circle = 0.0;
  /// The rest that is added; factor of radii that are for distances.
  double Half = 0.0;
  double RadiusScale = 1.0;

  /// Height of the base's sample at detail cell (x, y), of the last one beyond the raster.
  float BaseHeight(std::uint32_t x, std::uint32_t y) const
  {
    const glm::i64vec2 sample = this->Base->Layout->Sample(x >> this->Level, y >> this->Level);
    return this->Base->HeightAt(sample.x, sample.y);
  }
  /// Scaled height of the detail at detail cell (x, y).
  float DetailHeight(std::uint32_t x, std::uint32_t y) const
  {
    const std::uint32_t column = Wrapped(x, this->Period.x, this->Mask.x);
    const std::uint32_t row = Wrapped(y, this->Period.y, this->Mask.y);
    return this->Scale * this->Heights[column + static_cast<std::size_t>(this->Period.x) * row];
  }
};

/// Radius of the circle of a vertex that is `length` from its children; `depths` depths, its own
/// included, are left.
inline double DetailCircle(double length, int depths)
{
  // Slack for each depth below keeps circles nested when they are rounded.
  constexpr double slack = 1.0e-9;
  return length / (1.0 - std::sqrt(0.5)) * (1.0 + slack * depths);
}
}

#endif
