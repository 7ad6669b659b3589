// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A prepared heightfield: what BuildHierarchy makes, files hold and refinement reads.
 */
#ifndef terrain_Hierarchy_h
#define terrain_Hierarchy_h

#include "core/Coordinates.h"
#include "core/HierarchyLayout.h"
#include "core/HierarchyRecord.h"

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
