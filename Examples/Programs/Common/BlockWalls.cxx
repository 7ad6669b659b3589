// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockWalls.h"

#include "DataRim.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
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
#include <array>
#include <cmath>

namespace
{
constexpr double kLayerAmbient = 0.6;
constexpr std::array<double, 3> kDown{ 0.0, 0.0, -1.0 };

/// Polygons with one colour each.
class LayerBuilder
{
public:
  LayerBuilder()
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetNumberOfComponents(3);
    this->Colors->SetNumberOfComponents(3);
  }

  /// Of corners, with the direction that each faces.
  void Add(const std::array<std::array<double, 3>, 4>& corners,
    const std::array<std::array<double, 3>, 4>& facings, const std::array<double, 3>& color)
  {
    std::array<vtkIdType, 4> ids{};
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      ids[k] = this->Points->InsertNextPoint(corners[k].data());
      this->Normals->InsertNextTuple(facings[k].data());
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
    block->GetPointData()->SetNormals(this->Normals);
    block->GetCellData()->SetScalars(this->Colors);
    return block;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/// Facings of the corners of a wall: from, to, to, from.
std::array<std::array<double, 3>, 4> FacingsOf(const std::array<DataRim::Facing, 2>& side)
{
  const std::array<double, 3> from{ side[0][0], side[0][1], 0.0 };
  const std::array<double, 3> to{ side[1][0], side[1][1], 0.0 };
  return { from, to, to, from };
}

/// An actor of walls with the material and the place of a terrain.
vtkSmartPointer<vtkActor> MakeActor(vtkTerrainActor* terrain, vtkPolyDataMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->DeepCopy(terrain->GetProperty());
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
  const vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  const std::vector<DataRim::Side> sides = rim.FindSides();
  const auto facings = rim.FindFacings(sides);
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    const DataRim::Side& side = sides[k];
    if (!side.IsBorder)
    {
      for (const std::array<double, 3>& facing : FacingsOf(facings[k]))
      {
        normals->InsertNextTuple(facing.data());
      }
      const vtkIdType corners[] = { add(side.From, true), add(side.To, true), add(side.To, false),
        add(side.From, false) };
      cells->InsertNextCell(4, corners);
    }
  }
  auto walls = vtkSmartPointer<vtkPolyData>::New();
  walls->SetPoints(points);
  walls->SetPolys(cells);
  walls->GetPointData()->SetScalars(values);
  walls->GetPointData()->SetNormals(normals);
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
  const std::vector<DataRim::Side> sides = rim.FindSides();
  const auto facings = rim.FindFacings(sides);
  for (std::size_t index = 0; index < sides.size(); ++index)
  {
    const DataRim::Side& side = sides[index];
    const double deepest = std::max(rim.GetHeight(side.From), rim.GetHeight(side.To)) - base;
    double top = 0.0;
    for (std::size_t k = 0; k < strata.size() && top < deepest; ++k)
    {
      const bool isLast = k + 1 == strata.size() || strata[k].Thickness <= 0.0;
      const double bottom = isLast ? deepest : std::min(deepest, top + strata[k].Thickness);
      builder.Add(
        { at(side.From, bottom), at(side.To, bottom), at(side.To, top), at(side.From, top) },
        FacingsOf(facings[index]), strata[k].Color);
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
        { kDown, kDown, kDown, kDown }, strata.back().Color);
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
