// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A vtkImageData of heights as the views that src/core/ works on. Private to the module.
 *
 * Heights are an image of W x H x 1 points whose active point scalars have one component, of any
 * VTK numeric type. No data are NaN, infinities, and points whose vtkGhostType has HIDDENPOINT set.
 */
#ifndef vtkTerrain_data_ImageHeights_h
#define vtkTerrain_data_ImageHeights_h

#include "core/grid/Coordinates.h"
#include "core/grid/Heightfield.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSetGet.h" // For vtkTemplateMacro
#include "vtkUnsignedCharArray.h"

#include <string>

namespace terrain::ImageHeights
{
/// Empty if the image holds heights (above), else one sentence that says why not.
inline std::string WhyNotHeights(vtkImageData* image)
{
  if (!image)
  {
    return "no heights are given";
  }
  const int* dims = image->GetDimensions();
  if (dims[0] < 1 || dims[1] < 1 || dims[2] != 1)
  {
    return "heights must be an image of W x H x 1 points, this one has " + std::to_string(dims[0]) +
      " x " + std::to_string(dims[1]) + " x " + std::to_string(dims[2]);
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    return "heights must lie along the axes, this image has a direction matrix";
  }
  const double* spacing = image->GetSpacing();
  if (!(spacing[0] > 0.0) || !(spacing[1] > 0.0))
  {
    return "heights must have spacings above 0, this image has " + std::to_string(spacing[0]) +
      " and " + std::to_string(spacing[1]);
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars)
  {
    return "heights must be point scalars, this image has none";
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    return "heights must have one component, this array has " +
      std::to_string(scalars->GetNumberOfComponents());
  }
  return {};
}

/// Where the samples of the image lie in model coordinates, drawn at an exaggeration > 0.
inline GridGeometry Geometry(vtkImageData* image, double exaggeration = 1.0)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const int* extent = image->GetExtent();
  GridGeometry geometry;
  geometry.Origin = { origin[0] + extent[0] * spacing[0], origin[1] + extent[2] * spacing[1],
    origin[2] + extent[4] * spacing[2] };
  geometry.Spacing = { spacing[0], spacing[1] };
  geometry.Exaggeration = exaggeration;
  return geometry;
}

/// View of the samples; T must be the scalars' own type.
template <typename T>
HeightfieldView<T> View(vtkImageData* image)
{
  HeightfieldView<T> view;
  view.Samples = static_cast<const T*>(image->GetPointData()->GetScalars()->GetVoidPointer(0));
  view.Width = image->GetDimensions()[0];
  view.Height = image->GetDimensions()[1];
  if (vtkUnsignedCharArray* ghosts = image->GetPointGhostArray())
  {
    view.Mask = ghosts->GetPointer(0);
    view.MaskBits = vtkDataSetAttributes::HIDDENPOINT;
  }
  return view;
}

/// Calls worker(view) with the view of the scalars' own type; the image must hold heights.
template <typename Worker>
void Dispatch(vtkImageData* image, Worker&& worker)
{
  switch (image->GetPointData()->GetScalars()->GetDataType())
  {
    vtkTemplateMacro(worker(View<VTK_TT>(image)));
    default:
      break;
  }
}
}
#endif
