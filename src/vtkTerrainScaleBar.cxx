// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainScaleBar.h"

#include "core/grid/RoundNumbers.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
constexpr int kParts = 4;
// Half the arrow's width, and the depth of its notch, in shares of its length.
constexpr double kHalfWidth = 0.3;
constexpr double kNotch = 0.2;

void MakeBar(double length, double thickness, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> fill;
  fill->SetName("Fill");
  for (int part = 0; part <= kParts; ++part)
  {
    points->InsertNextPoint(length * part / kParts, 0.0, 0.0);
    points->InsertNextPoint(length * part / kParts, thickness, 0.0);
  }
  for (vtkIdType part = 0; part < kParts; ++part)
  {
    const vtkIdType corners[4] = { 2 * part, 2 * part + 2, 2 * part + 3, 2 * part + 1 };
    cells->InsertNextCell(4, corners);
    fill->InsertNextValue(part % 2 == 0 ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->SetScalars(fill);
}

void MakeArrow(double length, const double north[2], vtkPolyData* output)
{
  const double norm = std::hypot(north[0], north[1]);
  const double nx = norm > 0.0 ? north[0] / norm : 0.0;
  const double ny = norm > 0.0 ? north[1] / norm : 1.0;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto add = [&](double east, double along)
  {
    points->InsertNextPoint(
      length * (along * nx + east * ny), length * (along * ny - east * nx), 0.0);
  };
  add(0.0, 1.0);
  add(-kHalfWidth, 0.0);
  add(0.0, kNotch);
  add(kHalfWidth, 0.0);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> fill;
  fill->SetName("Fill");
  const vtkIdType west[3] = { 0, 1, 2 };
  const vtkIdType east[3] = { 0, 2, 3 };
  cells->InsertNextCell(3, west);
  cells->InsertNextCell(3, east);
  fill->InsertNextValue(1);
  fill->InsertNextValue(0);
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->SetScalars(fill);
}
}

vtkStandardNewMacro(vtkTerrainScaleBar);

vtkTerrainScaleBar::vtkTerrainScaleBar()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

double vtkTerrainScaleBar::GetLength() const
{
  return terrain::RoundDown(this->MaximumLength);
}

std::string vtkTerrainScaleBar::GetLabel() const
{
  return terrain::LengthLabel(this->GetLength());
}

int vtkTerrainScaleBar::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  MakeBar(
    this->GetLength() * this->UnitsPerMetre, this->Thickness, vtkPolyData::GetData(outputs, 0));
  MakeArrow(this->ArrowLength, this->North, vtkPolyData::GetData(outputs, 1));
  return 1;
}

void vtkTerrainScaleBar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "UnitsPerMetre: " << this->UnitsPerMetre << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "ArrowLength: " << this->ArrowLength << "\n";
  os << indent << "North: " << this->North[0] << ", " << this->North[1] << "\n";
  os << indent << "Length: " << this->GetLength() << "\n";
}
