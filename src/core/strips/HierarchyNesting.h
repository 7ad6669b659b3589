// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Second pass of the preprocess (HierarchyBuild.h): from the finest depth up, errors and radii are
 * nested and triangles without surface are marked.
 */
#ifndef terrain_HierarchyNesting_h
#define terrain_HierarchyNesting_h

#include "core/strips/HierarchyTarget.h"

namespace terrain
{
/// The drawn bits of the two halves of the triangle in `direction` of a vertex's diamond.
inline std::uint32_t TriangleMask(int direction)
{
  return (1u << (((direction + 3) & 7) >> 1)) | (1u << (((direction + 5) & 7) >> 1));
}

/// What is known of the two triangles of a diamond from their halves.
struct DiamondState
{
  /// Part of a triangle has a surface and part has none.
  bool IsMixed = false;
  /// Some half has a surface.
  bool HasSurface = false;

  /// `direction` is that of one of the two triangles, -1 for the root; `drawn` and `outside` have a
  /// bit for every half. `together`: both triangles are one, for a split that is not along the
  /// hypotenuse.
  DiamondState(int direction, bool together, std::uint32_t drawn, std::uint32_t outside)
  {
    const std::uint32_t missing = ~(drawn | outside) & HierarchyRecord::DrawnBits;
    this->HasSurface = drawn != 0;
    const std::uint32_t first =
      together || direction < 0 ? HierarchyRecord::DrawnBits : TriangleMask(direction);
    const std::uint32_t second = HierarchyRecord::DrawnBits & ~first;
    this->IsMixed = direction >= 0 &&
      (((drawn & first) != 0 && (missing & first) != 0) ||
        ((drawn & second) != 0 && (missing & second) != 0));
  }
};

/// Relative slack of the radii, above all rounding of distances in double precision.
constexpr double kRadiusSlack = 1.0e-6;

/// Nests the vertices of one depth after all finer ones; 0 <= depth <= Depths() - 2.
void NestDepth(const HierarchyTarget& target, int depth, const ParallelFor& parallelFor);
}

#endif
