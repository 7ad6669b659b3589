// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainCameraStrips.h"

#include "vtkCamera.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTerrainCameraStrips);

//------------------------------------------------------------------------------
vtkTerrainCameraStrips::vtkTerrainCameraStrips()
{
  vtkNew<vtkCamera> camera;
  this->SetCamera(camera);
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  this->SetKeepBorder(processes && processes->GetNumberOfProcesses() > 1);
}

//------------------------------------------------------------------------------
void vtkTerrainCameraStrips::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkTerrainCameraStrips::SetCameraPosition(double x, double y, double z)
{
  this->GetCamera()->SetPosition(x, y, z);
}

//------------------------------------------------------------------------------
void vtkTerrainCameraStrips::SetCameraFocalPoint(double x, double y, double z)
{
  this->GetCamera()->SetFocalPoint(x, y, z);
}

//------------------------------------------------------------------------------
void vtkTerrainCameraStrips::SetCameraViewUp(double x, double y, double z)
{
  this->GetCamera()->SetViewUp(x, y, z);
}

//------------------------------------------------------------------------------
void vtkTerrainCameraStrips::SetCameraViewAngle(double degrees)
{
  this->GetCamera()->SetViewAngle(degrees);
}
