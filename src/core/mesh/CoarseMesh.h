// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The coarse mesh of a heightfield: a grid of quads, two triangles each, that lies nowhere below
 * the surface.
 *
 * Source: Zsolt Feher, "Terrain Rendering with the Combination of Mesh Simplification and
 * Displacement Mapping", section 3. Where we depart from it: the paper bounds samples; we bound the
 * bilinear patches. Above one triangle both agree, since a bilinear patch minus a plane has its
 * extremes on the border of the region looked at. But the diagonal of a quad may be a valley that
 * cuts a cell: there the patch can rise above both triangles although its samples lie below. Along
 * the cut the difference is a parabola, whose maximum is taken exactly.
 */
#ifndef terrain_CoarseMesh_h
#define terrain_CoarseMesh_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace terrain
{
/// The quads along the longer side of the grid are at most so many when their size is automatic.
constexpr std::int64_t kAutomaticQuads = 128;
/// The automatic size of a quad is at least so many cells.
constexpr std::int64_t kAutomaticCellsPerQuad = 4;

/// How to build a coarse mesh.
struct CoarseMeshOptions
{
  /// Cells along a side of a quad; 0 (default) chooses, see AutomaticCellsPerQuad().
  std::int64_t CellsPerQuad = 0;
  /// True (default): steps 2 and 3 lift the mesh above the surface. False: step 1 alone, the
  /// subsampled mesh; with one cell a quad that is the full mesh.
  bool PushUp = true;
};

/// Cells per quad side for a grid of Width x Height samples: the smallest power of two, at least
/// kAutomaticCellsPerQuad, that leaves at most kAutomaticQuads quads along the longer side.
std::int64_t AutomaticCellsPerQuad(std::int64_t width, std::int64_t height);

/**
 * A coarse mesh over a grid. Quad (qx, qy) covers the cells from sample (Column(qx), Row(qy)) to
 * sample (Column(qx + 1), Row(qy + 1)); the last quads of a row or column may be smaller. Its
 * triangles are (south-west, south-east, north-east) and (south-west, north-east, north-west).
 */
struct CoarseMesh
{
  /// Samples of the grid east and north, and cells per quad side in effect.
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::int64_t CellsPerQuad = 1;
  /// Number of quads east and north; 0 where the grid has fewer than two samples.
  std::int64_t QuadsX = 0;
  std::int64_t QuadsY = 0;
  /// Height of vertex (vx, vy) at vx + (QuadsX + 1) * vy, in height units; NaN where no kept quad
  /// meets it.
  std::vector<double> VertexHeights;
  /// Of quad (qx, qy) at qx + QuadsX * qy: 1 if at least one of its cells has a surface, else 0.
  std::vector<unsigned char> QuadKept;
  /// How far each quad was pushed up, in height units; empty unless PushUp.
  std::vector<double> QuadPushes;
  /// Largest vertical distance between the mesh and the surface, in height units.
  double LargestGap = 0.0;
  /// Range of the samples of kept quads, in height units; minimum > maximum if none is kept.
  double MinimumHeight = 0.0;
  double MaximumHeight = -1.0;

  std::int64_t Column(std::int64_t vx) const
  {
    return std::min(vx * this->CellsPerQuad, this->Width - 1);
  }
  std::int64_t Row(std::int64_t vy) const
  {
    return std::min(vy * this->CellsPerQuad, this->Height - 1);
  }
  double VertexHeight(std::int64_t vx, std::int64_t vy) const
  {
    return this->VertexHeights[vx + (this->QuadsX + 1) * vy];
  }
  bool IsKept(std::int64_t qx, std::int64_t qy) const
  {
    return qx >= 0 && qy >= 0 && qx < this->QuadsX && qy < this->QuadsY &&
      this->QuadKept[qx + this->QuadsX * qy];
  }
};

/**
 * Builds the coarse mesh of a view in the paper's three steps. With PushUp no point of any patch
 * lies above it, in exact arithmetic on the doubles of VertexHeights; a quad alone touches the
 * surface but for rounding (kPushSlack of its relief). A vertex without a height takes the mean of
 * those of its quad, before it is pushed. Same result however parallelFor splits its ranges.
 * Time: each sample is read once, and once more in the few quads that may have the largest gap. T:
 * see SampleTypes.h.
 */
template <typename T>
CoarseMesh BuildCoarseMesh(
  const HeightfieldView<T>& view, const CoarseMeshOptions& options, const ParallelFor& parallelFor);

/// Added to each push, as a fraction of the relief of the quad: covers the rounding of its sums.
constexpr double kPushSlack = 64.0 * 0x1p-53;
}

#endif
