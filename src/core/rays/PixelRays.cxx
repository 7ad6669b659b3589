// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/PixelRays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
glm::dvec3 Unproject(const glm::dmat4& displayToView, double x, double y, double z)
{
  const glm::dvec4 p = displayToView * glm::dvec4(x, y, z, 1.0);
  return glm::dvec3(p) / p.w;
}

/// Origin and direction in view coordinates of the ray through normalised display coordinates (x,
/// y).
std::array<glm::dvec3, 2> RayThrough(const glm::dmat4& displayToView, double x, double y)
{
  const glm::dvec3 nearPoint = Unproject(displayToView, x, y, -1.0);
  const glm::dvec3 farPoint = Unproject(displayToView, x, y, 1.0);
  const glm::dvec3 direction = (farPoint - nearPoint) / (nearPoint.z - farPoint.z);
  return { nearPoint + nearPoint.z * direction, direction };
}

/// A pixel vector from its values at the lower left, lower right and upper left corner of the
/// viewport.
PixelVector FromCorners(const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight,
  const glm::dvec3& upperLeft, const glm::dvec4& viewport)
{
  const glm::dvec3 perX = (lowerRight - lowerLeft) / viewport.z;
  const glm::dvec3 perY = (upperLeft - lowerLeft) / viewport.w;
  return { lowerLeft - viewport.x * perX - viewport.y * perY, perX, perY };
}

PixelVector Transform(const glm::dmat4& matrix, const PixelVector& vector, double w)
{
  return { glm::dvec3(matrix * glm::dvec4(vector[0], w)),
    glm::dvec3(matrix * glm::dvec4(vector[1], 0.0)),
    glm::dvec3(matrix * glm::dvec4(vector[2], 0.0)) };
}

glm::dvec4 Row(const glm::dmat4& matrix, int index)
{
  return { matrix[0][index], matrix[1][index], matrix[2][index], matrix[3][index] };
}
}

PixelRays MakePixelRays(
  const glm::dmat4& gridToView, const glm::dmat4& viewToDisplay, const glm::dvec4& viewport)
{
  const glm::dmat4 displayToView = glm::inverse(viewToDisplay);
  const auto lowerLeft = RayThrough(displayToView, -1.0, -1.0);
  const auto lowerRight = RayThrough(displayToView, 1.0, -1.0);
  const auto upperLeft = RayThrough(displayToView, -1.0, 1.0);

  PixelRays rays;
  rays.OriginVC = FromCorners(lowerLeft[0], lowerRight[0], upperLeft[0], viewport);
  rays.DirectionVC = FromCorners(lowerLeft[1], lowerRight[1], upperLeft[1], viewport);
  const glm::dmat4 viewToGrid = glm::inverse(gridToView);
  rays.OriginGC = Transform(viewToGrid, rays.OriginVC, 1.0);
  rays.DirectionGC = Transform(viewToGrid, rays.DirectionVC, 0.0);
  rays.NormalMatrix = glm::transpose(glm::dmat3(viewToGrid));
  rays.DepthRow = Row(viewToDisplay, 2);
  rays.WeightRow = Row(viewToDisplay, 3);
  rays.Near = -Unproject(displayToView, 0.0, 0.0, -1.0).z;
  rays.Far = -Unproject(displayToView, 0.0, 0.0, 1.0).z;
  rays.Begin = rays.WeightRow.z != 0.0 ? 0.0 : rays.Near;
  return rays;
}

TerrainRay PixelRay(const PixelRays& rays, const glm::dvec2& pixel, double start, double end)
{
  const glm::dvec3 direction = AtPixel(rays.DirectionGC, pixel);
  const glm::dvec3 position = AtPixel(rays.OriginGC, pixel) + start * direction;
  const glm::dvec2 anchor = glm::floor(glm::dvec2(position));
  TerrainRay ray;
  ray.anchorCell = glm::ivec2(anchor);
  ray.originGC = glm::vec3(position - glm::dvec3(anchor, 0.0));
  ray.originLow = static_cast<float>(position.z - static_cast<double>(ray.originGC.z));
  ray.directionGC = glm::vec3(direction);
  ray.sBegin = 0.0f;
  ray.sEnd = static_cast<float>(end - start);
  return ray;
}

glm::vec2 EnterBox(const PixelRays& rays, const glm::dvec2& pixel, glm::vec2 range,
  const glm::vec3& minimum, const glm::vec3& maximum)
{
  const glm::vec3 origin(AtPixel(rays.OriginGC, pixel));
  const glm::vec3 direction(AtPixel(rays.DirectionGC, pixel));
  float enter = -std::numeric_limits<float>::infinity();
  float leave = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool still = direction[axis] == 0.0f;
    const float lower = (minimum[axis] - origin[axis]) / direction[axis];
    const float upper = (maximum[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, still ? range.x : std::min(lower, upper));
    leave = std::min(leave, still ? range.y : std::max(lower, upper));
  }
  const float slack = 1e-5f * std::max(std::abs(enter), std::abs(leave));
  return { std::max(range.x, enter - slack), std::min(range.y, leave + slack) };
}

glm::dvec4 PixelExtent(const PixelRays& rays, const glm::dmat4& gridToView, double pixels)
{
  const auto length = [&gridToView](int axis) { return glm::length(glm::dvec3(gridToView[axis])); };
  const auto shorter = [](const PixelVector& vector)
  { return std::min(glm::length(vector[1]), glm::length(vector[2])); };
  const glm::dvec2 perUnit = pixels / glm::dvec2(std::max(length(0), length(1)), length(2));
  return { shorter(rays.OriginVC) * perUnit, shorter(rays.DirectionVC) * perUnit };
}

std::array<glm::dvec3, 2> NearBoundsGC(const PixelRays& rays, const glm::dvec4& viewport)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<glm::dvec3, 2> bounds{ glm::dvec3(infinity), glm::dvec3(-infinity) };
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::dvec2 pixel(
      viewport.x + (corner & 1 ? viewport.z : 0.0), viewport.y + (corner & 2 ? viewport.w : 0.0));
    const glm::dvec3 origin = AtPixel(rays.OriginGC, pixel);
    const glm::dvec3 nearPoint = origin + rays.Near * AtPixel(rays.DirectionGC, pixel);
    bounds[0] = glm::min(bounds[0], glm::min(origin, nearPoint));
    bounds[1] = glm::max(bounds[1], glm::max(origin, nearPoint));
  }
  return bounds;
}
}
