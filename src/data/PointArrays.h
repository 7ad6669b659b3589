// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Point arrays of an image, carried on to a mesh whose vertices are its samples. Private to the
 * module.
 */
#ifndef vtkTerrain_data_PointArrays_h
#define vtkTerrain_data_PointArrays_h

#include "vtkAbstractArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace terrain
{
/// Adds the image's point arrays, ghosts left out, to a mesh: tuple k is that of point samples[k]
/// of the image. None becomes active.
inline void AddPointArrays(vtkImageData* image, vtkIdList* samples, vtkPolyData* mesh)
{
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = image->GetPointData()->GetAbstractArray(i);
    if (from != image->GetPointGhostArray())
    {
      auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
      to->SetName(from->GetName());
      to->SetNumberOfComponents(from->GetNumberOfComponents());
      to->SetNumberOfTuples(samples->GetNumberOfIds());
      from->GetTuples(samples, to);
      mesh->GetPointData()->AddArray(to);
    }
  }
}
}

#endif
