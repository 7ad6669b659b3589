// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the ray of a pixel sees of a globe, and the axes of the grid there. Twins of
 * terrainGlobeTraceRange() in shaders/vtkTerrainGlobeTrace.glsl and of terrainGlobeSetLocal() in
 * vtkTerrainGlobeLines.glsl; grid coordinates are metres in the axes of the anchor. For tests:
 * nothing is drawn by it.
 */
#ifndef terrain_GlobePixels_h
#define terrain_GlobePixels_h

#include "core/globe/GlobeTraversal.h"
#include "core/rays/PixelRays.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace terrain
{
/// The first hit of a pixel's ray between two distances; hit.s counts from range.x.
template <typename Texel>
TerrainHit GlobeTraceRange(const GlobeTraversal<float, Texel>& traversal, const PixelRays& rays,
  const glm::dvec2& pixel, const glm::vec2& range, bool& front)
{
  const glm::dvec3 origin = AtPixel(rays.OriginGC, pixel);
  const glm::dvec3 direction = AtPixel(rays.DirectionGC, pixel);
  GlobeRay<float> ray;
  ray.Origin = glm::vec3(origin);
  ray.Direction = glm::vec3(direction);
  ray.Begin = range.x;
  ray.End = range.y;
  const glm::vec2 outer = traversal.MeetShell(traversal.MakePath(ray), traversal.lines->Outer);
  front = true;
  if (!(outer.x < outer.y && outer.y > range.x && outer.x < range.y))
  {
    return {};
  }
  const float start = std::max(range.x, outer.x - 1e-5F * std::abs(outer.x));
  ray.Origin = glm::vec3(origin + static_cast<double>(start) * direction);
  ray.Begin = 0.0F;
  ray.End = range.y - start;
  const GlobeHit<float> hit = traversal.Trace(ray);
  front = hit.Front;
  return { hit.Found, hit.T + start - range.x, hit.Cell, hit.Fraction, hit.Crossings };
}

/// From a direction in metres to cells east, cells north and height codes, at a place in a cell and
/// at a height above the ellipsoid, metres. The meridian's radius is that of the cell's southern
/// line. codeScale: metres a code.
inline glm::dmat3 GlobeSetLocal(const GlobeGrid& grid, const GlobeAnchor& anchor,
  const glm::ivec2& cell, const glm::dvec2& fraction, double height, double codeScale)
{
  const auto row = static_cast<std::size_t>(cell.y);
  const double south = grid.Latitudes[row];
  const double rows = grid.Latitudes[row + 1] - south;
  const double longitude = (cell.x + fraction.x - anchor.Column) * grid.Step;
  const double latitude = south + fraction.y * rows;
  const glm::dvec2 east(std::sin(longitude), std::cos(longitude));
  const glm::dvec2 north(std::sin(latitude), std::cos(latitude));
  const double offAxis = (grid.Body.PrimeVertical(north.x) + height) * north.y;
  const double meridian = grid.Body.Meridional(std::sin(south)) + height;
  return glm::transpose(
    glm::dmat3(1.0 / (grid.Step * std::max(offAxis, 1.0)) * glm::dvec3(-east.x, east.y, 0.0),
      1.0 / (rows * meridian) * glm::dvec3(-north.x * east.y, -north.x * east.x, north.y),
      1.0 / codeScale * glm::dvec3(north.y * east.y, north.y * east.x, north.x)));
}
}

#endif
