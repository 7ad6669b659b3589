// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the inner loops of a refinement work on (RefinementSelection.h, RefinementPlainKernel.h).
 * Positions are columns + 2^32 rows, in cells; with detail (RefinementDetail.h) in detail cells.
 */
#ifndef terrain_RefinementFrame_h
#define terrain_RefinementFrame_h

#include "core/strips/HierarchyRecord.h"
#include "core/strips/RefinementDetail.h"
#include "core/strips/StripMesh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

/// The compiler's own choice leaves the small functions of the inner loop as calls, and takes rare
/// work into it.
#define TERRAIN_INLINE [[gnu::always_inline]] inline
#define TERRAIN_NO_INLINE [[gnu::noinline]]

namespace terrain
{
/// A column or row of vertices of a pair of depths.
struct AxisEntry
{
  /// Its term of the record index.
  std::uint32_t Term;
  /// Column or row of the sample that it is drawn at.
  std::uint32_t Sample;
};

/// The same for refinement by distance: its part of the squared distance to the eye, in scaled
/// space.
struct DistanceEntry
{
  double Distance2;
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
  /// RefineByDistance only: squared distance below which a vertex is active.
  const DistanceEntry* ColumnDistances = nullptr;
  const DistanceEntry* RowDistances = nullptr;
  double Range2 = 0.0;
  /// With detail only; of depths below the base's samples only.
  ReliefTable Relief;
  DetailDepth Detail;

  TERRAIN_INLINE const DistanceEntry& ColumnDistance(std::uint64_t position) const
  {
    return this->ColumnDistances[static_cast<std::uint32_t>(position) >> this->Shift];
  }
  TERRAIN_INLINE const DistanceEntry& RowDistance(std::uint64_t position) const
  {
    return this->RowDistances[static_cast<std::uint32_t>(position >> 32) >> this->Shift];
  }
};

/// One refinement: the view in scaled space, which is model space relative to the grid's origin,
/// times 1 / max(1, exaggeration): the radii hold in it whatever the exaggeration.
struct RefinementFrame
{
  std::array<DepthTable, 52> Depths;
  /// The deepest one that vertices are looked at.
  const DepthTable* Deepest = nullptr;
  const HierarchyRecord* Records = nullptr;
  /// For distances: the eye and the size of a cell and of the height unit. In parallel projection
  /// sizes are 0 and the eye is such that all distances are 1.
  glm::dvec2 Eye{ 0.0 };
  glm::dvec2 DistanceStep{ 1.0 };
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
  /// Some depths are not tested against them.
  bool IsLazy = false;
  glm::dvec3 Step{ 1.0 };
  /// Some triangles are not drawn; some vertices share a sample of the last row or column.
  bool HasHoles = false;
  bool SharesSamples = false;
  std::uint32_t LastColumn = 0;
  std::uint32_t LastRow = 0;
  /// The first depth below the base's samples, and what it and all after it share.
  const DepthTable* FirstDetail = nullptr;
  DetailFrame Detail;
};

/// A vertex that is looked at. It is needed if the reaches of its error and of its radius are
/// together longer than its distance.
struct VertexSite
{
  const AxisEntry* Column;
  const AxisEntry* Row;
  const DepthTable* Depth;
  std::uint64_t Position;
  double ErrorReach;
  double RadiusReach;
  double Distance2;
  HierarchyRecord Record;
  std::uint32_t Index;
};

/// The square itself: its corners in the order of HierarchySummary, which are drawn at samples of
/// the base, and the vertex of depth 0.
struct SquareSites
{
  std::array<StripVertex, 4> Corners;
  std::array<std::uint32_t, 4> Samples;
  VertexSite Centre;

  /// Column + 65536 row of the sample of a corner or, number 4, of the centre.
  std::uint32_t SampleAt(std::uint32_t number) const
  {
    return number < 4 ? this->Samples[number]
                      : this->Centre.Column->Sample | (this->Centre.Row->Sample << 16);
  }
};

/// With detail: a sample of the base, or a vertex below them, which has no column, row and index.
struct DetailVertexSite : VertexSite
{
  /// Height of the base there.
  float BaseHeight;
  /// Sphere of the sum around the middle of the detail's range there.
  double Radius;
  /// Horizontal distance and circle, compared too; 0 for samples of the base.
  double FlatDistance2;
  double CircleReach;
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
  /// EdgeBits (RefinementPlainKernel.h).
  std::uint32_t Edges;
  /// Middle waited for this triangle.
  bool IsRecalled;
  /// Only with holes: the triangle's direction, and the drawn bits of the vertex.
  std::uint32_t Direction;
  std::uint32_t Drawn;
};

/// With detail: the same, and the base's heights at its corners and at the vertex that halves it.
struct DetailTriangleSite : TriangleSite
{
  float LeftBase;
  float ApexBase;
  float RightBase;
  float MiddleBase;
  /// Below the samples: (h00 + h11 - h10 - h01) of the base's cell times the square of the depth's
  /// step in base cells.
  float Twist;
  /// Only with holes: the triangle itself is drawn.
  bool IsDrawn;
};
}

#endif
