// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The triangle strip that a refinement makes, and its vertices.
 */
#ifndef terrain_StripMesh_h
#define terrain_StripMesh_h

#include <cstdint>
#include <vector>

namespace terrain
{
/// One vertex of a refined mesh: a sample of the raster, or with detail of the sum.
struct StripVertex
{
  /// In cells; with detail in detail cells.
  std::uint32_t Column = 0;
  std::uint32_t Row = 0;
  /// Height of the sample, and what the morph adds to it, both without exaggeration.
  float Height = 0.0f;
  float Displacement = 0.0f;
  /// Record of the vertex; NoRecord + corner for the corners of the square, BelowSamples for
  /// vertices that are no samples of the base.
  std::uint32_t Record = 0;

  static constexpr std::uint32_t NoRecord = 0xfffffff0u;
  static constexpr std::uint32_t BelowSamples = 0xfffffff8u;
};

/// A generalized triangle strip: each index makes a triangle with the two before it, every second
/// one turned round; those with an index twice are degenerate. Seen from above the others are
/// counter-clockwise.
struct StripMesh
{
  std::vector<StripVertex> Vertices;
  std::vector<std::uint32_t> Strip;
  /// Triangles that are not degenerate.
  std::int64_t Triangles = 0;
  /// The tolerance that was kept: that of the options, or what the budget allowed.
  double Tolerance = 0.0;

  /// No vertices, no strip; their memory is kept.
  void Clear()
  {
    this->Vertices.clear();
    this->Strip.clear();
    this->Triangles = 0;
  }
};
}

#endif
