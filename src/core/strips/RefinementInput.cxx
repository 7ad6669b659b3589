// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/Refinement.h"

#include <cmath>
#include <string>

namespace terrain
{
namespace
{
bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

std::string Refiner::WhyNotRefine(const RefinementView& view, const RefinementOptions& options)
{
  if (!std::isfinite(options.Tolerance) || options.Tolerance <= 0.0)
  {
    return "the tolerance must be a positive number of pixels, not " +
      std::to_string(options.Tolerance);
  }
  if (options.TriangleBudget < 0)
  {
    return "the triangle budget must not be negative, it is " +
      std::to_string(options.TriangleBudget);
  }
  if (!std::isfinite(view.PixelsPerUnit) || view.PixelsPerUnit <= 0.0)
  {
    return "the viewport must have a height and the camera a view angle between 0 and 180 degrees";
  }
  if (!IsFinite(view.Eye))
  {
    return "the camera's position is not finite";
  }
  if (!std::isfinite(view.Exaggeration) || view.Exaggeration <= 0.0)
  {
    return "the exaggeration must be positive, not " + std::to_string(view.Exaggeration);
  }
  if (!std::isfinite(view.DetailScale) || view.DetailScale < 0.0)
  {
    return "the factor of the detail must not be negative, it is " +
      std::to_string(view.DetailScale);
  }
  for (const glm::dvec4& plane : view.Planes)
  {
    if (!IsFinite(glm::dvec3(plane)) || !std::isfinite(plane.w))
    {
      return "the camera's planes are not finite";
    }
  }
  return {};
}
}
