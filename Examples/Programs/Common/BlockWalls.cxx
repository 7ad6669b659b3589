// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockWalls.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLTerrainMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarsToColors.h>
#include <vtkTerrainActor.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
class WallBuilder
{
public:
  WallBuilder(vtkImageData* heights, double base, const char* colors)
    : Heights(heights)
    , Samples(heights->GetPointData()->GetScalars())
    , Ghosts(heights->GetPointGhostArray())
    , ColorArray(heights->GetPointData()->GetArray(colors))
    , Base(base)
    , Width(heights->GetDimensions()[0])
    , Height(heights->GetDimensions()[1])
  {
    this->Points->SetDataTypeToDouble();
  }

  vtkSmartPointer<vtkPolyData> Build()
  {
    this->FindCells();
    for (vtkIdType j = 0; j + 1 < this->Height; ++j)
    {
      for (vtkIdType i = 0; i + 1 < this->Width; ++i)
      {
        const bool is = this->IsCell(i, j);
        const vtkIdType corner = i + this->Width * j;
        if (i + 2 < this->Width && is != this->IsCell(i + 1, j))
        {
          this->AddWall(corner + 1, corner + 1 + this->Width);
        }
        if (j + 2 < this->Height && is != this->IsCell(i, j + 1))
        {
          this->AddWall(corner + this->Width, corner + this->Width + 1);
        }
      }
    }
    auto walls = vtkSmartPointer<vtkPolyData>::New();
    walls->SetPoints(this->Points);
    walls->SetPolys(this->Cells);
    walls->GetPointData()->SetScalars(this->Colors);
    return walls;
  }

private:
  bool HasHeight(vtkIdType sample) const
  {
    const bool hidden =
      this->Ghosts && (this->Ghosts->GetValue(sample) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    return !hidden && std::isfinite(this->Samples->GetComponent(sample, 0));
  }

  void FindCells()
  {
    std::vector<bool> samples(static_cast<std::size_t>(this->Width * this->Height));
    for (std::size_t k = 0; k < samples.size(); ++k)
    {
      samples[k] = this->HasHeight(static_cast<vtkIdType>(k));
    }
    this->AreCells.resize(samples.size());
    const auto width = static_cast<std::size_t>(this->Width);
    for (std::size_t k = 0; k + width + 1 < samples.size(); ++k)
    {
      this->AreCells[k] =
        samples[k] && samples[k + 1] && samples[k + width] && samples[k + width + 1];
    }
  }

  bool IsCell(vtkIdType i, vtkIdType j) const
  {
    return this->AreCells[static_cast<std::size_t>(i + this->Width * j)];
  }

  /// The point of a sample, or the one below it on the floor.
  vtkIdType AddPoint(vtkIdType sample, bool isFloor)
  {
    double point[3];
    this->Heights->GetPoint(sample, point);
    const double height = this->Samples->GetComponent(sample, 0);
    const double color = this->ColorArray ? this->ColorArray->GetComponent(sample, 0) : height;
    this->Colors->InsertNextValue(isFloor ? color - (height - this->Base) : color);
    return this->Points->InsertNextPoint(
      point[0], point[1], point[2] + (isFloor ? this->Base : height));
  }

  void AddWall(vtkIdType from, vtkIdType to)
  {
    const vtkIdType corners[] = { this->AddPoint(from, true), this->AddPoint(to, true),
      this->AddPoint(to, false), this->AddPoint(from, false) };
    this->Cells->InsertNextCell(4, corners);
  }

  vtkImageData* Heights;
  vtkDataArray* Samples;
  vtkUnsignedCharArray* Ghosts;
  vtkDataArray* ColorArray;
  double Base;
  vtkIdType Width;
  vtkIdType Height;
  /// At the number of its first sample: true for a cell with four heights.
  std::vector<bool> AreCells;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkDoubleArray> Colors;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBlockWalls(vtkImageData* heights, double base, const char* colors)
{
  return WallBuilder(heights, base, colors).Build();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeWallActor(vtkTerrainActor* terrain, vtkImageData* heights)
{
  const vtkSmartPointer<vtkPolyData> walls =
    MakeBlockWalls(heights, terrain->GetTerrainMapper()->GetBlockBase());
  if (walls->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(walls);
  mapper->SetLookupTable(terrain->GetLookupTable());
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->DeepCopy(terrain->GetProperty());
  actor->GetProperty()->SetInterpolationToFlat();
  // a wall sees half of the sky
  actor->GetProperty()->SetAmbient(
    terrain->GetProperty()->GetAmbient() + 0.5 * terrain->GetSkyLight());
  terrain->PlaceAsDrawn(actor);
  return actor;
}
