// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ray casting in double precision, exact for bilinear patches: the judge of every technique. Made
 * to be right, not to be fast.
 */
#ifndef terrain_ReferenceRayCaster_h
#define terrain_ReferenceRayCaster_h

#include "core/grid/Coordinates.h"
#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace terrain
{
/// A ray in model coordinates: position = Origin + distance * Direction, Begin <= distance <= End.
/// The unit of distances is the length of Direction.
struct ReferenceRay
{
  glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 };
  double Begin = 0.0;
  double End = std::numeric_limits<double>::infinity();
};

/// The first point of the surface on a ray.
struct ReferenceHit
{
  bool Found = false;
  /// In lengths of the ray's direction.
  double Distance = std::numeric_limits<double>::quiet_NaN();
  /// The cell, and the position within it, 0 <= fraction <= 1.
  std::int64_t CellX = -1;
  std::int64_t CellY = -1;
  glm::dvec2 Fraction{ 0.0, 0.0 };
  /// Unit normal of the drawn surface in model coordinates, upward.
  glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
  /// True if the ray comes from above the surface.
  bool FromAbove = true;
};

/// A camera as the rays through the centres of Width x Height pixels, row 0 on top. With u, v in
/// -1..1 across the picture (v up), a perspective ray starts at Eye with direction
/// Forward + u Right + v Up, a parallel ray at Eye + u Right + v Up with direction Forward. Forward
/// has unit length: distances are along the viewing direction.
struct ReferenceCamera
{
  glm::dvec3 Eye{ 0.0, 0.0, 0.0 };
  glm::dvec3 Forward{ 0.0, 1.0, 0.0 };
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 0.0, 1.0 };
  bool Parallel = false;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  /// Range of distances that is seen.
  double Near = 0.0;
  double Far = std::numeric_limits<double>::infinity();

  /// The ray through the centre of pixel (x, y); 0 <= x < Width, 0 <= y < Height.
  ReferenceRay PixelRay(std::int64_t x, std::int64_t y) const;
};

/// A perspective camera; viewAngle is the vertical field of view in degrees, 0 < viewAngle < 180.
/// viewUp must not be parallel to the direction to the focal point.
ReferenceCamera MakeReferenceCamera(const glm::dvec3& eye, const glm::dvec3& focalPoint,
  const glm::dvec3& viewUp, double viewAngle, std::int64_t width, std::int64_t height);

/**
 * Casts rays against the bilinear patches of a view, from both sides; a cell with a corner without
 * height has no surface. A ray is walked cell by cell in grid coordinates (Coordinates.h), and its
 * height minus the patch, a quadratic along the ray, is solved in each. Whole tiles of cells are
 * passed only where the ray clears the range of their samples.
 *
 * Error: positions in cells are those of double arithmetic, 1e-15 of the grid's and the eye's
 * coordinates. A root is taken as in a cell if it lies within kReferenceTolerance of it, so that no
 * ray slips between cells. A ray that starts on the surface hits at its start; one that runs within
 * a patch hits where it enters it.
 *
 * Keeps a copy of the view, not of the samples. T: see SampleTypes.h.
 */
template <typename T>
class ReferenceRayCaster
{
public:
  /// Scans the samples once for the ranges of the tiles.
  ReferenceRayCaster(
    const HeightfieldView<T>& view, const GridGeometry& geometry, const ParallelFor& parallelFor);

  /// The first hit of a ray.
  ReferenceHit Cast(const ReferenceRay& ray) const;

  /// Distances along the viewing direction of all pixels, row 0 on top; NaN where no surface.
  std::vector<double> RenderDepth(
    const ReferenceCamera& camera, const ParallelFor& parallelFor) const;

  /// True if moving the ray sideways by at most the given distance, in cells (of the smaller
  /// spacing), changes whether it hits, or from which side, or moves the hit by more than
  /// kSilhouetteJump cells. Tried are kSilhouetteDirections directions around the ray.
  bool IsNearSilhouette(const ReferenceRay& ray, double cells) const;

  /// How near a ray passes a silhouette, in cells: the smallest power of ten from 1e-9 at which
  /// IsNearSilhouette(); infinite if it is not at largestCells.
  double SilhouetteDistance(const ReferenceRay& ray, double largestCells) const;

private:
  /// A ray in grid coordinates and height units.
  struct GridRay
  {
    glm::dvec3 Origin;
    glm::dvec3 Direction;
    double Begin;
    double End;
    /// Column and row to look at where the ray runs along the line between two: 0, or -1 for the
    /// western or southern one.
    glm::dvec2 Bias;
  };
  struct Tile
  {
    double Low;
    double High;
  };

  void ScanTile(std::int64_t tile);
  bool ClearsTile(
    const GridRay& ray, std::int64_t tx, std::int64_t ty, double begin, double end) const;
  bool Clip(GridRay& ray) const;
  ReferenceHit CastGrid(const GridRay& ray) const;
  bool CastCell(const GridRay& ray, std::int64_t x, std::int64_t y, double begin, double end,
    ReferenceHit& hit) const;
  void Complete(const ReferenceRay& ray, ReferenceHit& hit) const;

  const HeightfieldView<T> View;
  const GridGeometry Geometry;
  std::int64_t TilesX = 0;
  std::int64_t TilesY = 0;
  std::vector<Tile> Tiles;
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
};

/// How far outside a cell a root may lie, in cells.
constexpr double kReferenceTolerance = 1e-9;
/// Cells along a side of a tile.
constexpr std::int64_t kReferenceTileCells = 32;
/// A hit that moves by more cells than this crosses a silhouette, or as good as.
constexpr double kSilhouetteJump = 1.0;
/// Directions in which rays are moved to look for silhouettes.
constexpr int kSilhouetteDirections = 16;
}

#endif
