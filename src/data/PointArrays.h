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
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace terrain
{
/// Adds the image's point arrays, ghosts left out, to a mesh: tuple k, of `count`, is that of point
/// sampleOf(k) of the image. None becomes active.
template <typename SampleOf>
void AddPointArrays(
  vtkImageData* image, vtkIdType count, const SampleOf& sampleOf, vtkPolyData* mesh)
{
  constexpr vtkIdType kAtOnce = 1 << 16;
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = image->GetPointData()->GetAbstractArray(i);
    if (from == image->GetPointGhostArray())
    {
      continue;
    }
    auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(count);
    vtkNew<vtkIdList> samples;
    vtkNew<vtkIdList> tuples;
    for (vtkIdType first = 0; first < count; first += kAtOnce)
    {
      const vtkIdType size = std::min(kAtOnce, count - first);
      samples->SetNumberOfIds(size);
      tuples->SetNumberOfIds(size);
      for (vtkIdType k = 0; k < size; ++k)
      {
        samples->SetId(k, sampleOf(first + k));
        tuples->SetId(k, first + k);
      }
      to->InsertTuples(tuples, samples, from);
    }
    mesh->GetPointData()->AddArray(to);
  }
}
}

#endif
