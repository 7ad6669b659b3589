// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What integer samples without a height hold. Private to the module.
 */
#ifndef vtkTerrain_data_HiddenSamples_h
#define vtkTerrain_data_HiddenSamples_h

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace terrain
{
/// Gives the hidden ones of count samples the lowest of the others, so that ranges are those of the
/// heights; leaves them where all are hidden.
template <typename T>
void FillHidden(T* samples, const unsigned char* ghosts, vtkIdType count)
{
  constexpr auto isHidden = vtkDataSetAttributes::HIDDENPOINT;
  T lowest = std::numeric_limits<T>::max();
  bool hasHeight = false;
  for (vtkIdType k = 0; k < count; ++k)
  {
    if ((ghosts[k] & isHidden) == 0)
    {
      lowest = std::min(lowest, samples[k]);
      hasHeight = true;
    }
  }
  if (!hasHeight)
  {
    return;
  }
  for (vtkIdType k = 0; k < count; ++k)
  {
    samples[k] = (ghosts[k] & isHidden) != 0 ? lowest : samples[k];
  }
}

/// The same for the scalars of an image, if it has hidden points.
inline void FillHidden(vtkImageData* image)
{
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!ghosts || !scalars)
  {
    return;
  }
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(FillHidden(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)),
      ghosts->GetPointer(0), image->GetNumberOfPoints()));
  }
}

/// The smallest type that has NaN and every value of another.
inline int FloatingTypeOf(int type)
{
  const bool isWide = type == VTK_INT || type == VTK_UNSIGNED_INT || type == VTK_DOUBLE;
  return isWide ? VTK_DOUBLE : VTK_FLOAT;
}
}
#endif
