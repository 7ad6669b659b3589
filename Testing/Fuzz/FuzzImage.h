// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers as files and programs give them at worst, and heights between them.
 */
#ifndef FuzzImage_h
#define FuzzImage_h

#include "FuzzInput.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <limits>

/// Mostly a number of about `size`, else any, no number, endless, the largest or the least.
inline double HostileNumber(FuzzInput& input, double size)
{
  using Limits = std::numeric_limits<double>;
  switch (input.Take<std::uint8_t>() % 16)
  {
    case 0:
      return input.Take<double>();
    case 1:
      return Limits::quiet_NaN();
    case 2:
      return Limits::infinity();
    case 3:
      return -Limits::infinity();
    case 4:
      return 1e308;
    case 5:
      return -1e308;
    case 6:
      return Limits::denorm_min();
    case 7:
      return 0.0;
    default:
      return size * input.Real();
  }
}

/// Heights of up to 5 x 5 samples around a place, with spacings of about `spacing`.
inline vtkSmartPointer<vtkImageData> HostileHeights(
  FuzzInput& input, double x, double y, double spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int width = 1 + static_cast<int>(input.Number(5));
  image->SetDimensions(width, 1 + static_cast<int>(input.Number(5)), 1);
  const double west = x + HostileNumber(input, 10.0 * spacing);
  image->SetOrigin(west, y + HostileNumber(input, 10.0 * spacing), HostileNumber(input, 1000.0));
  const double wide = std::abs(HostileNumber(input, spacing));
  image->SetSpacing(wide, input.Number(2) != 0 ? std::abs(HostileNumber(input, spacing)) : wide, 1);
  const vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  for (vtkIdType k = 0; k < image->GetNumberOfPoints(); ++k)
  {
    heights->InsertNextValue(static_cast<float>(HostileNumber(input, 1000.0)));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

#endif
