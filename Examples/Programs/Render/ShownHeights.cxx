// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShownHeights.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPointData.h"
#include "vtkTerrainActor.h"

namespace
{
/// Point array of vtkTerrainReproject in round scenes.
const char* const kPlaceHeight = "PlaceHeight";
}

//------------------------------------------------------------------------------
vtkDataArray* HeightsOf(vtkImageData* heights)
{
  vtkDataArray* ofPlaces = heights->GetPointData()->GetArray(kPlaceHeight);
  return ofPlaces ? ofPlaces : heights->GetPointData()->GetScalars();
}

//------------------------------------------------------------------------------
std::array<double, 2> HeightRange(vtkTerrainActor* actor, vtkImageData* heights)
{
  std::array<double, 2> range{};
  if (vtkDataArray* array = heights->GetPointData()->GetArray(kPlaceHeight))
  {
    array->GetFiniteRange(range.data());
    return range;
  }
  actor->GetHeightRange(range.data());
  return range;
}

//------------------------------------------------------------------------------
void ColorByPlaceHeight(vtkTerrainActor* actor, vtkImageData* heights)
{
  vtkDataArray* array = heights->GetPointData()->GetArray(kPlaceHeight);
  if (!array)
  {
    return;
  }
  std::array<double, 2> range{};
  array->GetFiniteRange(range.data());
  actor->SetLookupTable(vtkTerrainActor::MakeReliefColors(range[0], range[1]));
  actor->GetTerrainMapper()->SetScalarModeToUsePointFieldData();
  actor->GetTerrainMapper()->SelectColorArray(kPlaceHeight);
}
