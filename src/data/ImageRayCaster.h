// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays against an image of heights on the CPU, in double precision: the reference ray caster
 * (core/rays/ReferenceRayCaster.h) over the image's own type, kept until the image changes. Private
 * to the module.
 */
#ifndef vtkTerrain_data_ImageRayCaster_h
#define vtkTerrain_data_ImageRayCaster_h

#include "core/rays/ReferenceRayCaster.h"

#include "vtkImageData.h"
#include "vtkWeakPointer.h"

#include <functional>

namespace terrain
{
class ImageRayCaster
{
public:
  /// Takes over an image of heights (data/ImageHeights.h), and scans it if it has changed since
  /// the last call. Returns true if it was scanned.
  bool SetImage(vtkImageData* image);

  /// The image; null if there is none any more.
  vtkImageData* GetImage() const
  {
    return this->Image;
  }

  /// First hit of a ray in model coordinates with the heights as drawn at an exaggeration > 0.
  ReferenceHit Cast(const ReferenceRay& ray, double exaggeration) const;

private:
  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  double BaseHeight = 0.0;
  std::function<ReferenceHit(const ReferenceRay&)> CastTrue;
};
}
#endif
