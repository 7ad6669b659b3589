// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One surface: all that rays, pickers, horizons and textures need to know of a heightfield.
 */
#ifndef terrain_Surface_h
#define terrain_Surface_h

#include "core/grid/Coordinates.h"
#include "core/surface/SurfaceHeights.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace terrain
{
/// The surface between the samples.
enum class SurfaceKind
{
  Bilinear, ///< the bilinear patch of each cell
  Columns   ///< columns around the samples (core/surface/Columns.h)
};

/// A box in model coordinates; empty if Low > High in a direction.
struct ModelBounds
{
  glm::dvec3 Low{ kInfinity };
  glm::dvec3 High{ -kInfinity };

  bool IsEmpty() const
  {
    return glm::any(glm::greaterThan(this->Low, this->High));
  }
};

/**
 * A surface in its frame. Copies share the heights. Where the heights have detail
 * (core/surface/HeightsWithDetail.h), a cell is a cell of the detail, and the frame is that of the
 * detail's cells (FrameOfDetail()).
 */
struct Surface
{
  /// Null, or heights without cells: there is no surface.
  std::shared_ptr<const SurfaceHeights> Heights;
  /// Where samples lie in model coordinates, exaggeration included.
  GridGeometry Frame;
  SurfaceKind Kind = SurfaceKind::Bilinear;
  /// What is cut away, in grid coordinates with z in height units: kept is
  /// dot(plane, (x, y, z, 1)) >= 0 (Cutting::PlanesGC in core/surface/Cutting.h).
  std::vector<glm::dvec4> Planes;
  /// True if the surface is the top of a solid block: the planes show the block's inside as walls.
  bool Block = false;

  bool HasCells() const
  {
    return this->Heights && glm::all(glm::greaterThan(this->Heights->CellCount(), glm::i64vec2(0)));
  }

  /// Bounds of the surface as drawn; planes and walls of a block do not count.
  ModelBounds GetBounds() const
  {
    const HeightBounds heights = this->HasCells() ? this->Heights->Bounds() : HeightBounds{};
    return heights.IsEmpty()
      ? ModelBounds{}
      : ModelBounds{ this->Frame.ToModel({ 0.0, 0.0 }, heights.Low),
          this->Frame.ToModel(glm::dvec2(this->Heights->CellCount()), heights.High) };
  }
};

/// The frame of the cells of detail, so many along a cell of the frame of its base.
inline GridGeometry FrameOfDetail(GridGeometry base, int cells)
{
  base.Spacing /= static_cast<double>(cells);
  return base;
}
}

#endif
