// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A vtkImageData of heights as the views that src/core/ works on. Private to the module.
 *
 * Heights are an image of W x H x 1 points whose active point scalars have one component, of any
 * VTK numeric type. No data are NaN, infinities, and points whose vtkGhostType has HIDDENPOINT set.
 *
 * Rows of the image run north, or south where its direction matrix is diag(1, -1, 1), as rasters
 * have them. Core counts rows from the south in both cases.
 */
#ifndef vtkTerrain_data_ImageHeights_h
#define vtkTerrain_data_ImageHeights_h

#include "core/grid/Coordinates.h"
#include "core/grid/Heightfield.h"
#include "core/surface/MinMaxPyramid.h" // For GridRectangle

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSetGet.h" // For vtkTemplateMacro
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace terrain::ImageHeights
{
/// True if the image's first row is the northern one.
inline bool AreRowsFromNorth(vtkImageData* image)
{
  return image->GetDirectionMatrix()->GetElement(1, 1) < 0.0;
}

/// The row of the image that is row j from the south, and the reverse; both count from 0.
inline vtkIdType ImageRow(vtkImageData* image, vtkIdType j)
{
  return AreRowsFromNorth(image) ? image->GetDimensions()[1] - 1 - j : j;
}

/// The point of the image that is sample (i, j), counted from the south-west.
inline vtkIdType PointOfSample(vtkImageData* image, vtkIdType i, vtkIdType j)
{
  return i + image->GetDimensions()[0] * ImageRow(image, j);
}

/// Samples, counted from the south-west, of columns and rows of the image's extent, first and last.
inline GridRectangle SamplesOf(
  vtkImageData* image, const glm::ivec2& columns, const glm::ivec2& rows)
{
  const int* extent = image->GetExtent();
  const bool turned = AreRowsFromNorth(image);
  const int south = turned ? extent[3] - rows[1] : rows[0] - extent[2];
  const int north = turned ? extent[3] - rows[0] : rows[1] - extent[2];
  return { { columns[0] - extent[0], south }, { columns[1] - extent[0] + 1, north + 1 } };
}

/// Brings what was computed row by row from the south into the order of the image's rows, or back:
/// `rows` rows of `length` values.
template <typename T>
void ArrangeRows(vtkImageData* image, T* values, std::ptrdiff_t length, std::ptrdiff_t rows)
{
  for (std::ptrdiff_t j = 0; AreRowsFromNorth(image) && j < rows / 2; ++j)
  {
    T* row = values + length * j;
    std::swap_ranges(row, row + length, values + length * (rows - 1 - j));
  }
}

/// True if the image lies along the axes, its rows running north or south.
inline bool IsAlongAxes(vtkImageData* image)
{
  for (int i = 0; i < 9; ++i)
  {
    const double element = image->GetDirectionMatrix()->GetElement(i / 3, i % 3);
    if (element != (i % 4 == 0 ? 1.0 : 0.0) && !(i == 4 && element == -1.0))
    {
      return false;
    }
  }
  return true;
}

/// True for numbers without NaN and infinities among them.
inline bool AreFinite(const double* numbers, std::size_t count)
{
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}

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
  if (!IsAlongAxes(image))
  {
    return "heights must lie along the axes, this image has another direction matrix";
  }
  const double* spacing = image->GetSpacing();
  if (!(spacing[0] > 0.0) || !(spacing[1] > 0.0))
  {
    return "heights must have spacings above 0, this image has " + std::to_string(spacing[0]) +
      " and " + std::to_string(spacing[1]);
  }
  if (!AreFinite(image->GetBounds(), 6))
  {
    return "heights must lie at finite places, this image has an origin, or spacings, without end";
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
  geometry.Origin = { origin[0] + extent[0] * spacing[0],
    AreRowsFromNorth(image) ? origin[1] - extent[3] * spacing[1]
                            : origin[1] + extent[2] * spacing[1],
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
  const vtkIdType first = PointOfSample(image, 0, 0);
  view.Samples =
    static_cast<const T*>(image->GetPointData()->GetScalars()->GetVoidPointer(0)) + first;
  view.RowsFromNorth = AreRowsFromNorth(image);
  view.Width = image->GetDimensions()[0];
  view.Height = image->GetDimensions()[1];
  if (vtkUnsignedCharArray* ghosts = image->GetPointGhostArray())
  {
    view.Mask = ghosts->GetPointer(first);
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
