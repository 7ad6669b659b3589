// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainLooks.h"

#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainPieces.h"
#include "vtkTerrainStrips.h"

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
void TakePiece(vtkTerrainActor* actor, vtkImageData* piece, bool isOneOfSeveral)
{
  std::array<int, 2> first{};
  std::array<int, 2> last{};
  vtkTerrainPieces::OwnSamples(piece, first, last);
  actor->SetInputData(piece);
  actor->GetTerrainMapper()->SetExtract(first.data(), last.data());
  const int* extent = piece->GetExtent();
  vtkNew<vtkExtractVOI> own;
  own->SetInputData(piece);
  own->SetVOI(extent[0] + first[0], extent[0] + last[0], extent[2] + first[1], extent[2] + last[1],
    extent[4], extent[5]);
  actor->GetStrips()->SetInputConnection(own->GetOutputPort());
  actor->GetStrips()->SetKeepBorder(isOneOfSeveral);
}
}
