// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A prepared heightfield: what BuildHierarchy makes, files hold and refinement reads.
 */
#ifndef terrain_Hierarchy_h
#define terrain_Hierarchy_h

#include "core/grid/Coordinates.h"
#include "core/strips/HierarchyLayout.h"
#include "core/strips/HierarchyRecord.h"

#include <array>
#include <cstdint>
#include <vector>

namespace terrain
{
/// Facts about the whole hierarchy, besides its records.
struct HierarchySummary
{
  /// Heights of the corners of the square: south-west, south-east, north-west, north-east.
  std::array<float, 4> Corners{ { 0.0f, 0.0f, 0.0f, 0.0f } };
  std::array<HierarchyGradient, 4> CornerGradients;
  /// Lowest and highest height that is drawn; minimum > maximum if nothing is.
  float MinimumHeight = 1.0f;
  float MaximumHeight = 0.0f;
  /// True if some triangle within the square is not drawn: no data, or raster sides other than
  /// 2^n + 1.
  bool HasHoles = false;
};

/// A hierarchy that lies somewhere in memory; never owns it. Geometry.Exaggeration is 1: the
/// exaggeration belongs to the view.
struct HierarchyView
{
  const HierarchyLayout* Layout = nullptr;
  const HierarchyRecord* Records = nullptr;
  const HierarchyGradient* Gradients = nullptr;
  GridGeometry Geometry;
  HierarchySummary Summary;

  /// Number of the record of sample (x, y), which must not be a corner of the square.
  std::int64_t RecordOf(std::int64_t x, std::int64_t y) const
  {
    const int pair = this->Layout->PairOf(x, y);
    const int shift = this->Layout->Shift(pair);
    return this->Layout->Index(pair, x >> shift, y >> shift);
  }
  /// Number of the corner of the square at sample (x, y), in the order of the summary; -1 if there
  /// is none.
  int CornerOf(std::int64_t x, std::int64_t y) const
  {
    const std::int64_t inside = this->Layout->Cells() - 1;
    return ((x | y) & inside) != 0 ? -1 : (x != 0 ? 1 : 0) + (y != 0 ? 2 : 0);
  }
  /// Height of sample (x, y).
  float HeightAt(std::int64_t x, std::int64_t y) const
  {
    const int corner = this->CornerOf(x, y);
    return corner >= 0 ? this->Summary.Corners[corner] : this->Records[this->RecordOf(x, y)].Height;
  }
  /// True if cell (x, y) has a surface, 0 <= x < W - 1, 0 <= y < H - 1: its half at the corner that
  /// is a vertex of the last depth says so.
  bool IsCellDrawn(std::int64_t x, std::int64_t y) const
  {
    // Its half there points from the cell's centre to the vertex: to the south-west or south-east.
    const bool atWest = ((x + y) & 1) != 0;
    const std::int64_t record = this->RecordOf(atWest ? x : x + 1, y);
    return (this->Records[record].Drawn() & (atWest ? 4u : 8u)) != 0;
  }
  /// Slopes at sample (x, y).
  const HierarchyGradient& GradientAt(std::int64_t x, std::int64_t y) const
  {
    const int corner = this->CornerOf(x, y);
    return corner >= 0 ? this->Summary.CornerGradients[corner]
                       : this->Gradients[this->RecordOf(x, y)];
  }
};

/// A hierarchy in main memory.
struct MemoryHierarchy
{
  HierarchyLayout Layout;
  GridGeometry Geometry;
  HierarchySummary Summary;
  std::vector<HierarchyRecord> Records;
  std::vector<HierarchyGradient> Gradients;

  HierarchyView View() const
  {
    return { &this->Layout, this->Records.data(), this->Gradients.data(), this->Geometry,
      this->Summary };
  }
};
}

#endif
