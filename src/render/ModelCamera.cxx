// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ModelCamera.h"

#include "core/grid/Coordinates.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <array>
#include <cmath>

namespace terrain
{
//------------------------------------------------------------------------------
double AxisScale(vtkMatrix4x4* matrix, int axis)
{
  return std::hypot(
    matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis));
}

//------------------------------------------------------------------------------
void Exaggerate(vtkMatrix4x4* toWorld, double originZ, double exaggeration)
{
  GridGeometry drawn;
  drawn.Origin.z = originZ;
  drawn.Exaggeration = exaggeration;
  const glm::dmat4 rows = glm::transpose(drawn.TrueToDrawn());
  vtkMatrix4x4::Multiply4x4(toWorld->GetData(), &rows[0][0], toWorld->GetData());
}

//------------------------------------------------------------------------------
void PlaceInModel(vtkCamera* world, vtkMatrix4x4* toWorld, vtkCamera* model)
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(toWorld, toModel);
  const auto place = [&toModel](const double* vector, double w)
  {
    std::array<double, 4> placed{ vector[0], vector[1], vector[2], w };
    toModel->MultiplyPoint(placed.data(), placed.data());
    return placed;
  };
  model->SetPosition(place(world->GetPosition(), 1.0).data());
  model->SetFocalPoint(place(world->GetFocalPoint(), 1.0).data());
  model->SetViewUp(place(world->GetViewUp(), 0.0).data());
  model->SetParallelProjection(world->GetParallelProjection());
  model->SetParallelScale(world->GetParallelScale() / AxisScale(toWorld, 0));
  model->SetUseHorizontalViewAngle(world->GetUseHorizontalViewAngle());
  model->SetViewAngle(world->GetViewAngle());
  model->SetWindowCenter(world->GetWindowCenter()[0], world->GetWindowCenter()[1]);
}
}
