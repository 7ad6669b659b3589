// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the passes of the preprocess (HierarchyBuild.h) read and write.
 */
#ifndef terrain_HierarchyTarget_h
#define terrain_HierarchyTarget_h

#include "core/grid/ParallelFor.h"
#include "core/strips/Hierarchy.h"

#include <cstdint>
#include <functional>
#include <string>

namespace terrain
{
/// Delivers rows [first, first + count) of the raster, south row of them first, as heights with NaN
/// where there are none. Is called from one thread, from the north to the south, each row once.
/// Returns an error message, empty if all is well.
using HeightRows =
  std::function<std::string(std::int64_t first, std::int64_t count, float* heights)>;

/// What the preprocess writes to. Both arrays hold Layout.RecordCount() zeroed elements.
struct HierarchyTarget
{
  const HierarchyLayout* Layout = nullptr;
  GridGeometry Geometry;
  HierarchyRecord* Records = nullptr;
  HierarchyGradient* Gradients = nullptr;
  HierarchySummary Summary;
  bool KeepsBorder = false;
};
}

#endif
