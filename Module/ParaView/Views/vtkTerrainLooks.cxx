// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainLooks.h"

#include "vtkAbstractMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainImageWarp.h"
#include "vtkTerrainPieces.h"
#include "vtkTerrainStrips.h"

#include <algorithm>
#include <array>

namespace vtkTerrainLooks
{
//------------------------------------------------------------------------------
void ShareActor(vtkActor* from, vtkActor* to)
{
  to->SetProperty(from->GetProperty());
  to->SetTexture(from->GetTexture());
  to->SetPosition(from->GetPosition());
  to->SetScale(from->GetScale());
  to->SetOrientation(from->GetOrientation());
  to->SetOrigin(from->GetOrigin());
  to->SetPickable(from->GetPickable());
}

//------------------------------------------------------------------------------
void ShareTerrain(vtkTerrainActor* from, vtkTerrainActor* to)
{
  ShareActor(from, to);
  to->CopyLook(from);
}

//------------------------------------------------------------------------------
bool FindPart(vtkImageData* piece, const std::array<int, 4>& extract, std::array<int, 2>& first,
  std::array<int, 2>& last)
{
  vtkTerrainPieces::OwnSamples(piece, first, last);
  const int* extent = piece->GetExtent();
  for (int axis = 0; axis < 2; ++axis)
  {
    if (extract[2 * axis + 1] >= 0)
    {
      first[axis] = std::max(first[axis], extract[2 * axis] - extent[2 * axis]);
      last[axis] = std::min(last[axis], extract[2 * axis + 1] - extent[2 * axis]);
    }
  }
  return first[0] < last[0] && first[1] < last[1];
}

//------------------------------------------------------------------------------
void TakePiece(vtkTerrainActor* actor, vtkImageData* piece, const std::array<int, 2>& first,
  const std::array<int, 2>& last, bool isOneOfSeveral)
{
  const int* extent = piece->GetExtent();
  actor->SetInputData(piece);
  const int* dimensions = piece->GetDimensions();
  const bool isAll =
    first[0] <= 0 && first[1] <= 0 && last[0] >= dimensions[0] - 1 && last[1] >= dimensions[1] - 1;
  if (isAll && vtkTerrainPieces::IsOnGlobe(piece))
  {
    actor->GetTerrainMapper()->ExtractAll(); // a globe is drawn as a whole
  }
  else
  {
    actor->GetTerrainMapper()->SetExtract(first.data(), last.data());
  }
  vtkNew<vtkExtractVOI> own;
  own->SetInputData(piece);
  own->SetVOI(extent[0] + first[0], extent[0] + last[0], extent[2] + first[1], extent[2] + last[1],
    extent[4], extent[5]);
  actor->GetStrips()->SetInputConnection(own->GetOutputPort());
  actor->GetStrips()->SetKeepBorder(isOneOfSeveral);
}

//------------------------------------------------------------------------------
void Clip(vtkAbstractMapper* mapper, vtkPlane* plane)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkPlane* now = planes && planes->GetNumberOfItems() > 0 ? planes->GetItem(0) : nullptr;
  if (now == plane)
  {
    return; // a change would build shaders
  }
  mapper->RemoveAllClippingPlanes();
  if (plane)
  {
    mapper->AddClippingPlane(plane);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> BringPicture(
  const std::string& fileName, vtkImageData* heights, std::string& error)
{
  const vtkNew<vtkTerrainGeoreference> place;
  place->SetFromHeights(heights);
  place->SetFrame(vtkTerrainPieces::IsOnGlobe(heights) ? vtkTerrainGeoreference::FrameType::Globe
                                                       : vtkTerrainGeoreference::FrameType::Grid);
  error = place->GetWhyNot();
  if (!error.empty())
  {
    error += "; the filter Terrain Reproject brings the heights into one";
    return nullptr;
  }
  const vtkNew<vtkTerrainImageWarp> warp;
  const vtkNew<vtkCallbackCommand> silence; // the sentence is enough
  warp->AddObserver(vtkCommand::ErrorEvent, silence);
  warp->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  warp->SetInputData(heights);
  warp->SetGeoreference(place);
  warp->SetFileName(fileName);
  warp->Update();
  error = warp->GetErrorMessage();
  return error.empty() ? warp->GetOutput() : nullptr;
}
}
