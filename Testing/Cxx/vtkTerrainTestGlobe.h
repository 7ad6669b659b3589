// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights in longitude and latitude, and on a globe, for tests.
 */
#ifndef vtkTerrainTestGlobe_h
#define vtkTerrainTestGlobe_h

#include "vtkTerrainGlobe.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

namespace vtkTerrainTesting
{
/// Heights from their column and row, whole numbers, step degrees apart.
template <typename Height>
vtkSmartPointer<vtkImageData> MakeDegrees(
  double west, double south, double step, int columns, int rows, const Height& height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetOrigin(west, south, 0.0);
  image->SetSpacing(step, step, 1.0);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, height(i, j));
    }
  }
  return image;
}

/// On a body of its semi-axes in metres; 0: that of the heights.
inline vtkSmartPointer<vtkImageData> LayOnGlobe(
  vtkImageData* heights, double equatorial = 0.0, double polar = 0.0)
{
  const vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(heights);
  globe->SetRadii(equatorial, polar);
  globe->Update();
  return globe->GetOutput();
}
}

#endif
