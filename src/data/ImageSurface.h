// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An image of heights as a surface for queries on the CPU (core/surface/Surface.h). Private to the
 * module.
 */
#ifndef vtkTerrain_data_ImageSurface_h
#define vtkTerrain_data_ImageSurface_h

#include "core/surface/HeightsWithDetail.h"
#include "core/surface/Surface.h"

#include "vtkImageData.h"
#include "vtkWeakPointer.h"

#include <memory>

namespace terrain
{
/**
 * The heights of an image and their bounds, kept until the image changes. The samples are those of
 * the image, not copies: a surface may be used until the image changes or is gone.
 */
class ImageSurface
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

  /// Takes over one period of detail, of which every sample must have a height; null for none.
  void SetDetail(vtkImageData* detail);

  /// The surface as drawn at an exaggeration > 0, without detail.
  Surface GetSurface(double exaggeration) const;

  /// The same with the detail of SetDetail(), if there is any: so many of its cells, a power of
  /// two, along a cell of the heights; its heights times a scale >= 0.
  Surface GetDetailedSurface(double exaggeration, int detailCells, double detailScale) const;

private:
  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  GridGeometry Frame;
  std::shared_ptr<const SurfaceHeights> Heights;
  vtkWeakPointer<vtkImageData> DetailImage;
  vtkMTimeType DetailTime = 0;
  std::shared_ptr<const DetailPeriod> Detail;
};
}
#endif
