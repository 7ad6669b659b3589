// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From pixels to rays, in double precision: what the shader's uniforms hold, and the twin of
 * shaders/vtkTerrainView.glsl.
 */
#ifndef terrain_PixelRays_h
#define terrain_PixelRays_h

#include "core/rays/Ray.h"

#include <glm/glm.hpp>

#include <array>

namespace terrain
{
/// A vector that depends on the pixel (x, y): [0] + x * [1] + y * [2].
using PixelVector = std::array<glm::dvec3, 3>;

/// Value of a pixel vector at pixel (x, y); the centre of the lower left pixel of the window is
/// 0.5, 0.5.
inline glm::dvec3 AtPixel(const PixelVector& vector, const glm::dvec2& pixel)
{
  return vector[0] + pixel.x * vector[1] + pixel.y * vector[2];
}

/**
 * The rays of all pixels of a view: position = origin + distance * direction, with the distance
 * along the viewing direction, so that the direction in view coordinates has z = -1. Perspective,
 * oblique and parallel projections alike.
 */
struct PixelRays
{
  PixelVector OriginVC{};
  PixelVector DirectionVC{};
  PixelVector OriginGC{};
  PixelVector DirectionGC{};
  /// Takes (-dz/dx, -dz/dy, 1), in codes per cell, to the direction of the normal in view
  /// coordinates.
  glm::dmat3 NormalMatrix{ 1.0 };
  /// Depth in 0..1 at a view position p: 0.5 + 0.5 * dot(DepthRow, p) / dot(WeightRow, p).
  glm::dvec4 DepthRow{ 0.0, 0.0, 0.0, 1.0 };
  glm::dvec4 WeightRow{ 0.0, 0.0, 0.0, 1.0 };
  /// Distances of the near and the far plane along the viewing direction at the view's centre.
  double Near = 0.0;
  double Far = 0.0;
  /// Distance at which rays begin: the eye, 0, in perspective, so that the ground before the near
  /// plane is drawn, too; the near plane in parallel projections.
  double Begin = 0.0;
};

/// The rays of a viewport (x, y, width, height in pixels) from the matrices grid to view
/// coordinates and view to display (clip) coordinates, acting on column vectors; both must be
/// invertible.
PixelRays MakePixelRays(
  const glm::dmat4& gridToView, const glm::dmat4& viewToDisplay, const glm::dvec4& viewport);

/// Twin of terrainPixelRay(): the ray of a pixel from the start distance to the end distance,
/// stored relative to the cell where it starts. The shader cuts the origin's height where this
/// rounds it: its sum with originLow is the same.
TerrainRay PixelRay(const PixelRays& rays, const glm::dvec2& pixel, double start, double end);

/// Twin of terrainEnterBox(): the part of the distances [range.x, range.y] of a pixel's ray within
/// a box in grid coordinates, a little widened; range.x >= range.y if there is none. Axes along
/// which the ray does not move are left to what comes after.
glm::vec2 EnterBox(const PixelRays& rays, const glm::dvec2& pixel, glm::vec2 range,
  const glm::vec3& minimum, const glm::vec3& maximum);

/**
 * Size of what projects to a number of pixels: cells and height codes at distance 0, and their
 * change per unit of distance along the viewing direction. Of a square of cells the longer side
 * counts. Exact for perspective and for parallel projections; for oblique ones not less than that.
 */
glm::dvec4 PixelExtent(const PixelRays& rays, const glm::dmat4& gridToView, double pixels);

/// Box around the eye and the corners of the near plane, in grid coordinates: minimum, maximum.
std::array<glm::dvec3, 2> NearBoundsGC(const PixelRays& rays, const glm::dvec4& viewport);
}

#endif
