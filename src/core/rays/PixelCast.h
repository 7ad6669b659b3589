// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the ray of a pixel sees of a heightfield: twin of shaders/vtkTerrainCast.glsl, whose
 * uniforms are members here. Pixels are in double precision, the trace is that of
 * PyramidTraversal.h. For tests: nothing is drawn by it.
 */
#ifndef terrain_PixelCast_h
#define terrain_PixelCast_h

#include "core/rays/PixelRays.h"
#include "core/rays/PyramidTraversal.h"
#include "core/rays/Sighting.h"
#include "core/rays/SurfaceShading.h"
#include "core/surface/Cutting.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace terrain
{
/// Cells that a ray may be long before what float rounds along it counts.
constexpr double kLongRay = 256.0;

/// Casts the rays of pixels at a heightfield.
template <typename Texel>
struct PixelCast
{
  const PixelRays& Rays;
  const CodedPyramid<Texel>& Coded;
  glm::vec3 BoxMinimum{ 0.0F }; ///< of the terrain, in grid coordinates
  glm::vec3 BoxMaximum{ 0.0F };
  double Begin = 0.0; ///< where rays begin and end, along the viewing direction
  double Far = 0.0;
  int Layer = 0;                     ///< surfaces that rays pass by
  glm::ivec2 Culled{ 0 };            ///< 1 if hits from above, from below are passed by
  std::vector<glm::vec4> PlanesVC{}; ///< kept is dot(plane, position) >= 0
  bool Block = false;                ///< the planes cut a block

  /// The first hit of a pixel's ray between two distances, and the codes of its cell; hit.s counts
  /// from range.x. Again: whether a ray whose hit is far is traced again from near it.
  TerrainHit TraceRange(const glm::dvec2& pixel, const glm::vec2& range, bool& front,
    glm::vec4& codes, bool again = true) const
  {
    const double pace = glm::length(glm::dvec2(AtPixel(this->Rays.DirectionGC, pixel)));
    const auto trace = [&](float begin)
    {
      const TerrainRay ray = PixelRay(this->Rays, pixel, range.x + begin, range.y);
      TerrainHit hit = this->Coded.TracePyramid(ray);
      if (hit.found || begin == 0.0F)
      {
        codes = this->Coded.heights.CellCodes(hit.cell);
        front = this->SeesFrontOf(ray, hit, codes);
      }
      hit.s += begin;
      return hit;
    };
    TerrainHit hit = trace(0.0F);
    if (again && hit.found && hit.s * pace > kLongRay)
    {
      const TerrainHit next = trace(static_cast<float>(hit.s - 4.0 / std::max(pace, 1e-30)));
      const int crossings = hit.crossings + next.crossings;
      hit = next.found ? next : hit;
      hit.crossings = next.found ? crossings : hit.crossings;
    }
    return hit;
  }

  /// What the ray of a pixel sees from a distance on.
  Sighting Cast(const glm::dvec2& pixel, float entryDistance) const
  {
    const glm::vec2 whole(std::max(static_cast<double>(entryDistance), this->Begin), this->Far);
    glm::vec2 range = EnterBox(this->Rays, pixel, whole, this->BoxMinimum, this->BoxMaximum);
    int wall = -1;
    range = ClipRange(this->PlanesVC, glm::vec3(AtPixel(this->Rays.OriginVC, pixel)),
      glm::vec3(AtPixel(this->Rays.DirectionVC, pixel)), range, wall);
    int layer = this->Layer;
    Sighting sighting;
    if (this->Block && wall >= 0 && range.x < range.y)
    {
      const TerrainRay ray = PixelRay(this->Rays, pixel, range.x, range.x);
      glm::vec2 fraction;
      const glm::ivec2 cell = CellAt(ray, this->Coded.heights.size, fraction);
      if (IsWithinBlock(ray, fraction, this->Coded.heights.CellCodes(cell), this->Coded.columns))
      {
        if (layer == 0)
        {
          return { true, range.x, cell, fraction, true, 0, wall };
        }
        --layer;
      }
    }
    const double pace =
      0.01 / std::max(glm::length(glm::dvec2(AtPixel(this->Rays.DirectionGC, pixel))), 1e-30);
    while (range.x < range.y)
    {
      bool front = true;
      glm::vec4 codes;
      const TerrainHit hit = this->TraceRange(pixel, range, front, codes);
      sighting = { hit.found, range.x + hit.s, hit.cell, hit.fraction, front,
        sighting.crossings + hit.crossings, -1 };
      const bool culled = hit.found && (front ? this->Culled.x : this->Culled.y) == 1;
      if (!hit.found || (!culled && layer == 0))
      {
        break;
      }
      layer -= culled ? 0 : 1;
      range.x += hit.s + static_cast<float>(std::max(pace, 1e-6 * sighting.distanceVC));
      sighting.found = false;
    }
    return sighting;
  }

private:
  bool SeesFrontOf(const TerrainRay& ray, const TerrainHit& hit, const glm::vec4& codes) const
  {
    return this->Coded.columns ? FindColumnFace(codes, hit.fraction, ray.directionGC).front
                               : SeesFront(ray, hit, codes, this->Coded.heights.maximumCode, false);
  }
};
}

#endif
