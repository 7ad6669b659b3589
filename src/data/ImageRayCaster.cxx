// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/ImageRayCaster.h"

#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include <memory>

namespace terrain
{
namespace
{
/// The caster over a view, as a function that keeps it.
template <typename T>
std::function<ReferenceHit(const ReferenceRay&)> castOver(
  const HeightfieldView<T>& view, const GridGeometry& geometry)
{
  auto caster = std::make_shared<ReferenceRayCaster<T>>(view, geometry, SMPParallelFor);
  return [caster](const ReferenceRay& ray) { return caster->Cast(ray); };
}
}

//------------------------------------------------------------------------------
bool ImageRayCaster::SetImage(vtkImageData* image)
{
  if (this->Image == image && this->ImageTime == image->GetMTime())
  {
    return false;
  }
  this->Image = image;
  this->ImageTime = image->GetMTime();
  const GridGeometry geometry = ImageHeights::Geometry(image);
  this->BaseHeight = geometry.Origin.z;
  ImageHeights::Dispatch(
    image, [&](const auto& view) { this->CastTrue = castOver(view, geometry); });
  return true;
}

//------------------------------------------------------------------------------
ReferenceHit ImageRayCaster::Cast(const ReferenceRay& ray, double exaggeration) const
{
  // The ray is brought to the true heights, so that a change of exaggeration scans nothing.
  ReferenceRay trueRay = ray;
  trueRay.Origin.z = this->BaseHeight + (ray.Origin.z - this->BaseHeight) / exaggeration;
  trueRay.Direction.z = ray.Direction.z / exaggeration;
  ReferenceHit hit = this->CastTrue(trueRay);
  hit.Normal = glm::normalize(hit.Normal * glm::dvec3(exaggeration, exaggeration, 1.0));
  return hit;
}
}
