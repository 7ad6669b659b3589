// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRayCaster.h"

#include "vtkTerrainHeightfield.h"
#include "vtkTerrainParallelFor.h"

#include <memory>

namespace
{
/// The caster over a view, as a function that keeps it.
template <typename T>
std::function<terrain::ReferenceHit(const terrain::ReferenceRay&)> castOver(
  const terrain::HeightfieldView<T>& view, const terrain::GridGeometry& geometry)
{
  auto caster =
    std::make_shared<terrain::ReferenceRayCaster<T>>(view, geometry, vtkTerrainParallelFor);
  return [caster](const terrain::ReferenceRay& ray) { return caster->Cast(ray); };
}
}

//------------------------------------------------------------------------------
bool vtkTerrainRayCaster::SetImage(vtkImageData* image)
{
  if (this->Image == image && this->ImageTime == image->GetMTime())
  {
    return false;
  }
  this->Image = image;
  this->ImageTime = image->GetMTime();
  const terrain::GridGeometry geometry = vtkTerrainHeightfield::Geometry(image);
  this->BaseHeight = geometry.Origin.z;
  vtkTerrainHeightfield::Dispatch(
    image, [&](const auto& view) { this->CastTrue = castOver(view, geometry); });
  return true;
}

//------------------------------------------------------------------------------
terrain::ReferenceHit vtkTerrainRayCaster::Cast(
  const terrain::ReferenceRay& ray, double exaggeration) const
{
  // The ray is brought to the true heights, so that a change of exaggeration scans nothing.
  terrain::ReferenceRay trueRay = ray;
  trueRay.Origin.z = this->BaseHeight + (ray.Origin.z - this->BaseHeight) / exaggeration;
  trueRay.Direction.z = ray.Direction.z / exaggeration;
  terrain::ReferenceHit hit = this->CastTrue(trueRay);
  hit.Normal = glm::normalize(hit.Normal * glm::dvec3(exaggeration, exaggeration, 1.0));
  return hit;
}
