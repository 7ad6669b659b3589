// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/ImageSurface.h"

#include "core/surface/DetailHeights.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

namespace terrain
{
namespace
{
template <typename T>
std::shared_ptr<const SurfaceHeights> HeightsOf(const HeightfieldView<T>& view)
{
  return std::make_shared<SampledHeights<T>>(view, SMPParallelFor);
}

template <typename T>
std::shared_ptr<const DetailPeriod> PeriodOf(const HeightfieldView<T>& view)
{
  return std::make_shared<DetailPeriod>(view);
}
}

//------------------------------------------------------------------------------
bool ImageSurface::SetImage(vtkImageData* image)
{
  if (this->Image == image && this->ImageTime == image->GetMTime())
  {
    return false;
  }
  this->Image = image;
  this->ImageTime = image->GetMTime();
  this->Frame = ImageHeights::Geometry(image);
  ImageHeights::Dispatch(image, [&](const auto& view) { this->Heights = HeightsOf(view); });
  return true;
}

//------------------------------------------------------------------------------
void ImageSurface::SetDetail(vtkImageData* detail)
{
  if (this->DetailImage == detail && (!detail || this->DetailTime == detail->GetMTime()))
  {
    return;
  }
  this->DetailImage = detail;
  this->DetailTime = detail ? detail->GetMTime() : 0;
  this->Detail.reset();
  if (detail)
  {
    ImageHeights::Dispatch(detail, [&](const auto& view) { this->Detail = PeriodOf(view); });
  }
}

//------------------------------------------------------------------------------
Surface ImageSurface::GetSurface(double exaggeration) const
{
  Surface surface;
  surface.Heights = this->Heights;
  surface.Frame = this->Frame;
  surface.Frame.Exaggeration = exaggeration;
  return surface;
}

//------------------------------------------------------------------------------
Surface ImageSurface::GetDetailedSurface(
  double exaggeration, int detailCells, double detailScale) const
{
  Surface surface = this->GetSurface(exaggeration);
  if (this->Detail)
  {
    surface.Heights = std::make_shared<HeightsWithDetail>(
      this->Heights, this->Detail, LevelOfCells(detailCells), detailScale);
    surface.Frame = FrameOfDetail(surface.Frame, detailCells);
  }
  return surface;
}
}
