// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainCameraStrips.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>

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

//------------------------------------------------------------------------------
bool vtkTerrainCameraStrips::IsDefaultCamera()
{
  const vtkNew<vtkCamera> camera;
  const auto isSame = [](const double* a, const double* b) { return std::equal(a, a + 3, b); };
  return isSame(camera->GetPosition(), this->GetCamera()->GetPosition()) &&
    isSame(camera->GetFocalPoint(), this->GetCamera()->GetFocalPoint());
}

//------------------------------------------------------------------------------
int vtkTerrainCameraStrips::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* heights = vtkImageData::GetData(inputVector[0]);
  if (!heights || heights->GetNumberOfPoints() == 0 || !this->IsDefaultCamera())
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const vtkBoundingBox box(heights->GetBounds());
  std::array<double, 3> middle{};
  box.GetCenter(middle.data());
  const double distance = 0.5 * box.GetDiagonalLength() /
    std::tan(0.5 * vtkMath::RadiansFromDegrees(this->GetCamera()->GetViewAngle()));
  const vtkNew<vtkCamera> given;
  given->DeepCopy(this->GetCamera());
  this->GetCamera()->SetFocalPoint(middle.data());
  this->GetCamera()->SetPosition(middle[0], middle[1], middle[2] + distance);
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  this->GetCamera()->DeepCopy(given);
  return result;
}
