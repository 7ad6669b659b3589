// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainLooks.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainStrips.h"

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
  to->SetTechnique(from->GetTechnique());
  to->SetUseStrips(from->GetUseStrips());
  to->GetStrips()->SetTolerance(from->GetStrips()->GetTolerance());
  to->SetVerticalExaggeration(from->GetVerticalExaggeration());
  to->SetLevelOfDetail(from->GetLevelOfDetail());
  vtkOpenGLTerrainMapper* source = from->GetTerrainMapper();
  vtkOpenGLTerrainMapper* mapper = to->GetTerrainMapper();
  mapper->SetColorSource(source->GetColorSource());
  mapper->SetContours(source->GetContours());
  mapper->SetContourInterval(source->GetContourInterval());
  mapper->SetContourWidth(source->GetContourWidth());
  mapper->SetHillshade(source->GetHillshade());
  mapper->SetHillshadeAzimuth(source->GetHillshadeAzimuth());
  mapper->SetHillshadeAltitude(source->GetHillshadeAltitude());
  mapper->SetBlock(source->GetBlock());
  mapper->SetBlockBase(source->GetBlockBase());
}
}
