// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainStyle.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <array>

namespace
{
/// Part of the way to the point under the pointer that a click of the wheel goes.
constexpr double kWheelShare = 0.15;
/// Degrees from the vertical that are left: the cosine is 0.9986, and from 0.999 on the marker of
/// directions (vtkRenderer::ResetCamera) takes another view-up, with a warning.
constexpr double kFromVertical = 3.0;
}

vtkStandardNewMacro(TerrainStyle);

//------------------------------------------------------------------------------
void TerrainStyle::OnChar()
{
  if (this->KeyTyped)
  {
    this->KeyTyped(this->Interactor->GetKeyCode());
  }
}

//------------------------------------------------------------------------------
void TerrainStyle::OnLeftButtonDown()
{
  this->TurnAboutPointer();
  this->Superclass::OnLeftButtonDown();
}

//------------------------------------------------------------------------------
void TerrainStyle::OnMiddleButtonDown()
{
  this->TurnAboutPointer(); // so that the point follows the pointer
  this->Superclass::OnMiddleButtonDown();
}

//------------------------------------------------------------------------------
void TerrainStyle::OnMouseWheelForward()
{
  this->GoTowardsPointer(kWheelShare);
}

//------------------------------------------------------------------------------
void TerrainStyle::OnMouseWheelBackward()
{
  this->GoTowardsPointer(-kWheelShare / (1.0 - kWheelShare));
}

//------------------------------------------------------------------------------
void TerrainStyle::Rotate()
{
  if (!this->CurrentRenderer)
  {
    return;
  }
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  const int* now = this->Interactor->GetEventPosition();
  const int* last = this->Interactor->GetLastEventPosition();
  // as the superclass turns it
  const double up = 180.0 * (last[1] - now[1]) / this->CurrentRenderer->GetSize()[1];
  const double angle = up +
    vtkMath::DegreesFromRadians(
      vtkMath::AngleBetweenVectors(camera->GetDirectionOfProjection(), camera->GetViewUp()));
  if (angle < kFromVertical || angle > 180.0 - kFromVertical)
  {
    this->Interactor->SetEventPosition(now[0], last[1]);
  }
  this->Superclass::Rotate();
}

//------------------------------------------------------------------------------
vtkTerrainPicker* TerrainStyle::PickUnderPointer()
{
  const int* pointer = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(pointer[0], pointer[1]);
  auto* picker = vtkTerrainPicker::SafeDownCast(this->Interactor->GetPicker());
  const bool found = picker && this->CurrentRenderer &&
    picker->Pick(pointer[0] + 0.5, pointer[1] + 0.5, 0.0, this->CurrentRenderer);
  return found ? picker : nullptr;
}

//------------------------------------------------------------------------------
void TerrainStyle::TurnAboutPointer()
{
  vtkTerrainPicker* picker = this->PickUnderPointer();
  if (!picker)
  {
    return;
  }
  // the focal point moves along the viewing direction only: the picture stays
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  std::array<double, 3> toPoint{};
  std::array<double, 3> focalPoint{};
  vtkMath::Subtract(picker->GetPickPosition(), camera->GetPosition(), toPoint.data());
  const double* direction = camera->GetDirectionOfProjection();
  const double distance = vtkMath::Dot(toPoint.data(), direction);
  for (int axis = 0; axis < 3; ++axis)
  {
    focalPoint[axis] = camera->GetPosition()[axis] + distance * direction[axis];
  }
  camera->SetFocalPoint(focalPoint.data());
}

//------------------------------------------------------------------------------
void TerrainStyle::GoTowardsPointer(double share)
{
  vtkTerrainPicker* picker = this->PickUnderPointer();
  if (!this->CurrentRenderer)
  {
    return;
  }
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  const double* aim = picker ? picker->GetPickPosition() : camera->GetFocalPoint();
  std::array<double, 3> position{};
  std::array<double, 3> focalPoint{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = share * (aim[axis] - camera->GetPosition()[axis]);
    position[axis] = camera->GetPosition()[axis] + step;
    focalPoint[axis] = camera->GetFocalPoint()[axis] + step;
  }
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() * (1.0 - share));
  }
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focalPoint.data());
  this->CurrentRenderer->ResetCameraClippingRange();
  this->Interactor->Render();
}
