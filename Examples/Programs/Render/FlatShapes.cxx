// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlatShapes.h"

#include "vtkActor2D.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void FlatShapes::AddLine(const Pixel& from, const Pixel& to, double width)
{
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  if (length > 0.0)
  {
    const double x = 0.5 * width * (from[1] - to[1]) / length;
    const double y = 0.5 * width * (to[0] - from[0]) / length;
    this->AddPolygon({ { from[0] - x, from[1] - y }, { to[0] - x, to[1] - y },
      { to[0] + x, to[1] + y }, { from[0] + x, from[1] + y } });
  }
}

//------------------------------------------------------------------------------
void FlatShapes::AddBorder(const std::vector<Pixel>& corners, double width)
{
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    this->AddLine(corners[k], corners[(k + 1) % corners.size()], width);
  }
}

//------------------------------------------------------------------------------
void FlatShapes::AddPolygon(const std::vector<Pixel>& corners)
{
  this->Cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const Pixel& corner : corners)
  {
    this->Cells->InsertCellPoint(this->Points->InsertNextPoint(corner[0], corner[1], 0.0));
  }
}

//------------------------------------------------------------------------------
void FlatShapes::AddTo(vtkRenderer* renderer, const std::array<double, 3>& color) const
{
  if (this->Cells->GetNumberOfCells() == 0)
  {
    return;
  }
  const vtkNew<vtkPolyData> shape;
  shape->SetPoints(this->Points);
  shape->SetPolys(this->Cells);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  const vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddViewProp(actor);
}
