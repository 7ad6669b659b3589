// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockWalls.h"

#include "DataRim.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
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

#include <algorithm>
#include <cmath>

namespace
{
constexpr double kLayerAmbient = 0.6;

/// Polygons with one colour each.
class LayerBuilder
{
public:
  LayerBuilder()
  {
    this->Points->SetDataTypeToDouble();
    this->Colors->SetNumberOfComponents(3);
  }

  void Add(const std::array<std::array<double, 3>, 4>& corners, const std::array<double, 3>& color)
  {
    std::array<vtkIdType, 4> ids{};
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      ids[k] = this->Points->InsertNextPoint(corners[k].data());
    }
    this->Cells->InsertNextCell(4, ids.data());
    constexpr double kFull = 255.0;
    this->Colors->InsertNextTuple3(kFull * color[0], kFull * color[1], kFull * color[2]);
  }

  vtkSmartPointer<vtkPolyData> Take() const
  {
    auto block = vtkSmartPointer<vtkPolyData>::New();
    block->SetPoints(this->Points);
    block->SetPolys(this->Cells);
    block->GetCellData()->SetScalars(this->Colors);
    return block;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/// An actor of walls with the material and the place of a terrain.
vtkSmartPointer<vtkActor> MakeActor(vtkTerrainActor* terrain, vtkPolyDataMapper* mapper)
{
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
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBlockWalls(vtkImageData* heights, double base, const char* colors)
{
  const DataRim rim(heights);
  vtkDataArray* shown = heights->GetPointData()->GetArray(colors);
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  const vtkNew<vtkDoubleArray> values;
  const auto add = [&](vtkIdType sample, bool isFloor)
  {
    const double height = rim.GetHeight(sample);
    const double color = shown ? shown->GetComponent(sample, 0) : height;
    values->InsertNextValue(isFloor ? color - (height - base) : color);
    return points->InsertNextPoint(rim.GetPoint(sample, isFloor ? base : height).data());
  };
  for (const DataRim::Side& side : rim.FindSides())
  {
    if (!side.IsBorder)
    {
      const vtkIdType corners[] = { add(side.From, true), add(side.To, true), add(side.To, false),
        add(side.From, false) };
      cells->InsertNextCell(4, corners);
    }
  }
  auto walls = vtkSmartPointer<vtkPolyData>::New();
  walls->SetPoints(points);
  walls->SetPolys(cells);
  walls->GetPointData()->SetScalars(values);
  return walls;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLayeredBlock(
  vtkImageData* heights, double base, const std::vector<Stratum>& strata)
{
  const DataRim rim(heights);
  LayerBuilder builder;
  const auto at = [&](vtkIdType sample, double depth)
  { return rim.GetPoint(sample, std::max(base, rim.GetHeight(sample) - depth)); };
  for (const DataRim::Side& side : rim.FindSides())
  {
    const double deepest = std::max(rim.GetHeight(side.From), rim.GetHeight(side.To)) - base;
    double top = 0.0;
    for (std::size_t k = 0; k < strata.size() && top < deepest; ++k)
    {
      const bool isLast = k + 1 == strata.size() || strata[k].Thickness <= 0.0;
      const double bottom = isLast ? deepest : std::min(deepest, top + strata[k].Thickness);
      builder.Add(
        { at(side.From, bottom), at(side.To, bottom), at(side.To, top), at(side.From, top) },
        strata[k].Color);
      top = bottom;
    }
  }
  const vtkIdType width = heights->GetDimensions()[0];
  for (vtkIdType row = 0; row < rim.GetRows(); ++row)
  {
    for (const auto& [first, last] : rim.FindRuns(row))
    {
      const vtkIdType low = width * row;
      builder.Add(
        { rim.GetPoint(low + first, base), rim.GetPoint(low + last + 1, base),
          rim.GetPoint(low + width + last + 1, base), rim.GetPoint(low + width + first, base) },
        strata.back().Color);
    }
  }
  return builder.Take();
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
  return MakeActor(terrain, mapper);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeLayerActor(
  vtkTerrainActor* terrain, vtkImageData* heights, const std::vector<Stratum>& strata)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(
    MakeLayeredBlock(heights, terrain->GetTerrainMapper()->GetBlockBase(), strata));
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarModeToUseCellData();
  terrain->GetTerrainMapper()->SetBlock(false);
  vtkSmartPointer<vtkActor> block = MakeActor(terrain, mapper);
  // colours that tell layers apart are seen on sides that turn away from the sun, too
  block->GetProperty()->SetAmbient(kLayerAmbient);
  block->GetProperty()->SetDiffuse(1.0 - kLayerAmbient);
  return block;
}
