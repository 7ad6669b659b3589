// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What shaders make of a point of the surface: its depth, its normal, its size on the screen, the
 * side that is seen, and how much of a sun's disc it sees. Twins of functions in
 * shaders/vtkTerrainView.glsl, vtkTerrainCast.glsl, vtkTerrainGradient.glsl,
 * vtkTerrainSurface.glsl, vtkTerrainLight.glsl and, for footprints, vtkTerrainColor.glsl, which
 * have the prefix terrain and document them; uniforms are arguments here. Geometry is in double
 * precision. For tests: nothing is drawn by it.
 */
#ifndef terrain_SurfaceShading_h
#define terrain_SurfaceShading_h

#include "core/rays/PixelRays.h"
#include "core/rays/Ray.h"
#include "core/surface/CodedHeights.h"
#include "core/surface/Columns.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace terrain
{
/// A point of the surface.
struct ShadedPoint
{
  glm::vec4 PositionVC{ 0.0F, 0.0F, 0.0F, 1.0F };
  glm::ivec2 Cell{ 0, 0 };
  glm::vec2 Fraction{ 0.0F, 0.0F };
  float Code = 0.0F;
  glm::vec2 Gradient{ 0.0F, 0.0F }; ///< codes per cell
  int Crossings = 0;                ///< work done, see TerrainHit
};

///@{
/// View coordinates and depth.
inline glm::vec4 PositionVC(const PixelRays& rays, const glm::dvec2& pixel, double distance)
{
  return { glm::vec3(AtPixel(rays.OriginVC, pixel) + distance * AtPixel(rays.DirectionVC, pixel)),
    1.0F };
}
inline double Depth(const PixelRays& rays, const glm::dvec4& positionVC)
{
  const double weight = std::max(glm::dot(rays.WeightRow, positionVC), 1e-30);
  return std::max(0.5 + 0.5 * glm::dot(rays.DepthRow, positionVC) / weight, 0.0);
}
inline glm::vec3 NormalVC(const PixelRays& rays, const glm::vec2& gradient)
{
  return glm::normalize(glm::vec3(rays.NormalMatrix * glm::dvec3(-gradient, 1.0)));
}
inline glm::dvec2 PlanePace(
  const PixelRays& rays, const glm::dvec2& pixel, double s, const glm::dvec2& gradient)
{
  const glm::dvec3 direction = AtPixel(rays.DirectionGC, pixel);
  const double slope = glm::dot(gradient, glm::dvec2(direction));
  const double least = 1e-3 * (std::abs(direction.z) + std::abs(slope)) + 1e-30;
  const double closing = direction.z - slope;
  glm::dvec2 pace;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto k = static_cast<std::size_t>(axis) + 1;
    const glm::dvec3 move = rays.OriginGC[k] + s * rays.DirectionGC[k];
    pace[axis] = (glm::dot(gradient, glm::dvec2(move)) - move.z) /
      std::copysign(std::max(std::abs(closing), least), closing);
  }
  return pace;
}
inline double DepthSlope(const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point)
{
  const double s = -point.PositionVC.z;
  const glm::dvec2 pace = PlanePace(rays, pixel, s, point.Gradient);
  const double here = Depth(rays, glm::dvec4(point.PositionVC));
  const glm::dvec4 right(PositionVC(rays, pixel + glm::dvec2(1.0, 0.0), s + pace.x));
  const glm::dvec4 up(PositionVC(rays, pixel + glm::dvec2(0.0, 1.0), s + pace.y));
  return std::hypot(Depth(rays, right) - here, Depth(rays, up) - here);
}
inline double ShiftedDepth(const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point,
  double factor, double offset)
{
  return Depth(rays, glm::dvec4(point.PositionVC)) + factor * DepthSlope(rays, pixel, point) +
    offset / 65000.0;
}
/// Where the ray of a fragment of the box begins.
inline double Entry(const glm::dvec4& proxyVC)
{
  return -proxyVC.z - 1e-5 * std::abs(proxyVC.z);
}
/// Of a hit behind the box.
inline double FragmentDepth(
  const PixelRays& rays, const glm::dvec4& positionVC, double fragmentDepth)
{
  return std::max(Depth(rays, positionVC), fragmentDepth);
}
inline bool IsClipped(const std::vector<glm::vec4>& planesVC, const glm::dvec4& positionVC)
{
  return std::any_of(planesVC.begin(), planesVC.end(),
    [&](const glm::dvec4& plane) { return glm::dot(plane, positionVC) < 0.0; });
}
inline glm::vec3 FacingNormal(
  const glm::vec3& normalVC, const glm::vec3& faceVC, const glm::vec3& towardsVC)
{
  const float facing = std::min(glm::dot(normalVC, towardsVC), 0.0F);
  return glm::normalize(
    glm::mix(normalVC - facing * towardsVC, faceVC, std::min(-4.0F * facing, 1.0F)));
}
///@}

///@{
/// Sides of the surface. Tolerance: whether one may have ended the search before the surface.
inline bool SeesFront(const TerrainRay& ray, const TerrainHit& hit, const glm::vec4& codes,
  float maximumCode, bool tolerance)
{
  const glm::vec2 gradient = PatchGradient(codes, hit.fraction);
  const float above = ray.originGC.z + hit.s * ray.directionGC.z - PatchCode(codes, hit.fraction);
  const float rounding = 1e-5F * (maximumCode + std::abs(ray.originGC.z));
  return ray.directionGC.z <= glm::dot(gradient, glm::vec2(ray.directionGC)) ||
    (tolerance && above > rounding);
}
/// Where a pixel's ray is at a distance: the cell, and the position in it.
inline glm::ivec2 CellAt(const TerrainRay& ray, const glm::ivec2& size, glm::vec2& fraction)
{
  const glm::ivec2 step(glm::floor(glm::vec2(ray.originGC)));
  const glm::ivec2 cell = glm::clamp(ray.anchorCell + step, glm::ivec2(0), size - 2);
  fraction = glm::clamp(glm::vec2(ray.originGC) - glm::vec2(cell - ray.anchorCell), 0.0F, 1.0F);
  return cell;
}
/// Codes: of that cell.
inline bool IsWithinBlock(
  const TerrainRay& ray, const glm::vec2& fraction, const glm::vec4& codes, bool columns = false)
{
  const float top = columns ? ColumnCode(codes, glm::greaterThanEqual(fraction, glm::vec2(0.5F)))
                            : PatchCode(codes, fraction);
  return glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0F))) && ray.originGC.z <= top;
}
///@}

///@{
/// Size of a pixel on the surface.
inline double PixelCells(const PixelRays& rays, double distance)
{
  const glm::dvec2 right(rays.OriginGC[1] + distance * rays.DirectionGC[1]);
  const glm::dvec2 up(rays.OriginGC[2] + distance * rays.DirectionGC[2]);
  return std::max(glm::length(right), glm::length(up));
}
inline glm::dmat2 Footprint(
  const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point)
{
  const double s = -point.PositionVC.z;
  const glm::dvec2 pace = PlanePace(rays, pixel, s, point.Gradient);
  const glm::dvec2 direction(AtPixel(rays.DirectionGC, pixel));
  return { glm::dvec2(rays.OriginGC[1] + s * rays.DirectionGC[1]) + pace.x * direction,
    glm::dvec2(rays.OriginGC[2] + s * rays.DirectionGC[2]) + pace.y * direction };
}
///@}

///@{
/// Numbers of cells and samples of a grid of size samples, and their colours for selection.
inline int CellId(const ShadedPoint& point, const glm::ivec2& size)
{
  return point.Cell.x + (size.x - 1) * point.Cell.y;
}
inline int SampleId(const ShadedPoint& point, const glm::ivec2& size)
{
  const glm::ivec2 nearest = point.Cell + glm::ivec2(glm::floor(point.Fraction + 0.5F));
  return nearest.x + size.x * nearest.y;
}
inline glm::vec4 IdColor(int id)
{
  return glm::vec4(id & 255, (id >> 8) & 255, (id >> 16) & 255, 255) / 255.0F;
}
///@}

///@{
/// Light.
inline double DiscShare(const glm::dvec4& disc, double tangent)
{
  const double x =
    glm::clamp((std::atan(tangent * disc.z) - disc.x) / std::max(disc.y, 1e-6), -1.0, 1.0);
  return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / glm::pi<double>();
}
inline double PlaneEnd(const std::vector<glm::vec4>& planesVC, const glm::dvec3& positionVC,
  const glm::dvec3& directionVC, double end)
{
  for (const glm::dvec4 plane : planesVC)
  {
    const double inside = std::max(glm::dot(plane, glm::dvec4(positionVC, 1.0)), 0.0);
    const double leaving = -glm::dot(glm::dvec3(plane), directionVC);
    end = leaving > 0.0 ? std::min(end, inside / leaving) : end;
  }
  return end;
}
///@}
}

#endif
