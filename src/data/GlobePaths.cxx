// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/GlobePaths.h"

#include "core/grid/Constants.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace terrain::GlobePaths
{
namespace
{
/// Radians from a pole within which a point has no longitude of its own.
constexpr double kAtPole = 1e-9;
/// Most points of a line between two of the input.
constexpr double kMostPoints = 1e5;

/// Longitude from which those of the image, or its gap, count: half a turn west of its middle.
double FirstOf(const GlobeGrid& grid)
{
  return grid.West + 0.5 * grid.Cells().x * grid.Step - 0.5 * kTurn;
}

/// A longitude that is not turned any more, a latitude and a height.
glm::dvec3 FlatOf(const glm::dvec3& place, const GlobeGrid& grid, vtkImageData* heights)
{
  const double* origin = heights->GetOrigin();
  const double* spacing = heights->GetSpacing();
  return { origin[0] + (place.x - grid.West) / grid.Step * spacing[0],
    origin[1] + grid.RowOf(place.y) * spacing[1], place.z };
}

/// Paths while they become flat. Longitudes and latitudes are radians.
class Flattener
{
public:
  Flattener(vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights, double sag)
    : Paths(paths)
    , Grid(grid)
    , Heights(heights)
    , Step(std::sqrt(8.0 * sag / grid.Body.Equatorial))
    , First(FirstOf(grid))
  {
    this->Points->SetDataTypeToDouble();
    this->Flat->GetPointData()->InterpolateAllocate(paths->GetPointData());
  }

  void AddVertices(vtkCellArray* cells)
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell, ++this->Source)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, count, ids);
      for (vtkIdType k = 0; k < count; ++k)
      {
        const glm::dvec3 place = this->PlaceOf(ids[k]);
        const vtkIdType id = this->AddPoint(place, this->TurnOf(place.x), ids[k], ids[k], 0.0);
        this->Vertices->InsertNextCell(1, &id);
        this->VertexSources.push_back(this->Source);
      }
    }
  }

  void AddLines(vtkCellArray* cells, bool closed)
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell, ++this->Source)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, count, ids);
      std::vector<vtkIdType> line(ids, ids + count);
      if (closed && count > 0)
      {
        line.push_back(ids[0]);
      }
      this->AddLine(line);
    }
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    this->Flat->SetPoints(this->Points);
    this->Flat->SetVerts(this->Vertices);
    this->Flat->SetLines(this->Lines);
    vtkCellData* data = this->Flat->GetCellData();
    data->CopyAllocate(this->Paths->GetCellData());
    std::vector<vtkIdType> sources = this->VertexSources;
    sources.insert(sources.end(), this->LineSources.begin(), this->LineSources.end());
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      data->CopyData(this->Paths->GetCellData(), sources[i], static_cast<vtkIdType>(i));
    }
    return this->Flat;
  }

private:
  glm::dvec3 PlaceOf(vtkIdType id) const
  {
    glm::dvec3 position;
    this->Paths->GetPoint(id, &position.x);
    return this->Grid.Body.ToPlace(position);
  }

  /// Turns by which a longitude lies east of those of the image.
  double TurnOf(double longitude) const
  {
    return std::floor((longitude - this->First) / kTurn);
  }

  vtkIdType AddPoint(const glm::dvec3& place, double turn, vtkIdType from, vtkIdType to, double t)
  {
    const glm::dvec3 flat =
      FlatOf({ place.x - turn * kTurn, place.y, place.z }, this->Grid, this->Heights);
    const vtkIdType id = this->Points->InsertNextPoint(flat.x, flat.y, flat.z);
    this->Flat->GetPointData()->InterpolateEdge(this->Paths->GetPointData(), id, from, to, t);
    return id;
  }

  void EndLine()
  {
    if (this->Line.size() > 1)
    {
      this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Line.size()), this->Line.data());
      this->LineSources.push_back(this->Source);
    }
    this->Line.clear();
  }

  void AddLine(const std::vector<vtkIdType>& ids)
  {
    glm::dvec3 last(0.0);
    double turn = 0.0;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      glm::dvec3 place = this->PlaceOf(ids[k]);
      if (!std::isfinite(place.x + place.y + place.z))
      {
        this->EndLine();
        continue;
      }
      if (this->Line.empty())
      {
        turn = this->TurnOf(place.x);
        this->Line.push_back(this->AddPoint(place, turn, ids[k], ids[k], 0.0));
      }
      else
      {
        const bool isPole = 90.0 * kDegree - std::abs(place.y) < kAtPole;
        place.x = isPole ? last.x : last.x + std::remainder(place.x - last.x, kTurn);
        turn = this->AddSegment(last, place, turn, ids[k - 1], ids[k]);
      }
      last = place;
    }
    this->EndLine();
  }

  /// The line from a point, which is drawn, to another. Returns the turn of its end.
  double AddSegment(
    const glm::dvec3& from, const glm::dvec3& to, double turn, vtkIdType fromId, vtkIdType toId)
  {
    const double nearest = from.y * to.y < 0.0 ? 0.0 : std::min(std::abs(from.y), std::abs(to.y));
    const double angle = std::hypot((to.x - from.x) * std::cos(nearest), to.y - from.y);
    const double parts = std::clamp(std::ceil(angle / this->Step), 1.0, kMostPoints);
    for (double k = 1.0; k <= parts; k += 1.0)
    {
      const double t = k / parts;
      const glm::dvec3 place = glm::mix(from, to, t);
      const double next = this->TurnOf(place.x);
      if (next != turn)
      {
        const double border = this->First + std::max(turn, next) * kTurn;
        const double cut = (border - from.x) / (to.x - from.x);
        const glm::dvec3 there(
          border, glm::dvec2(glm::mix(from, to, cut).y, glm::mix(from, to, cut).z));
        this->Line.push_back(this->AddPoint(there, turn, fromId, toId, cut));
        this->EndLine();
        this->Line.push_back(this->AddPoint(there, next, fromId, toId, cut));
        turn = next;
      }
      this->Line.push_back(this->AddPoint(place, turn, fromId, toId, t));
    }
    return turn;
  }

  vtkPolyData* Paths;
  const GlobeGrid& Grid;
  vtkImageData* Heights;
  double Step;
  double First; ///< longitude from which those of the image, or its gap, count
  vtkSmartPointer<vtkPolyData> Flat = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;
  std::vector<vtkIdType> VertexSources;
  std::vector<vtkIdType> LineSources;
  std::vector<vtkIdType> Line;
  vtkIdType Source = 0;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToFlat(
  vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights, double sag)
{
  Flattener flattener(paths, grid, heights, sag);
  flattener.AddVertices(paths->GetVerts());
  flattener.AddLines(paths->GetLines(), false);
  flattener.AddLines(paths->GetPolys(), true);
  return flattener.Finish();
}

//------------------------------------------------------------------------------
void ToFlat(double* points, std::size_t count, const GlobeGrid& grid, vtkImageData* heights)
{
  const double first = FirstOf(grid);
  for (double* point = points; point != points + 3 * count; point += 3)
  {
    glm::dvec3 place = grid.Body.ToPlace({ point[0], point[1], point[2] });
    place.x -= kTurn * std::floor((place.x - first) / kTurn);
    const glm::dvec3 flat = FlatOf(place, grid, heights);
    std::copy_n(&flat.x, 3, point);
  }
}

//------------------------------------------------------------------------------
void FromFlat(double* points, std::size_t count, const GlobeGrid& grid, vtkImageData* heights)
{
  const double* origin = heights->GetOrigin();
  const double* spacing = heights->GetSpacing();
  for (double* point = points; point != points + 3 * count; point += 3)
  {
    const double column = (point[0] - origin[0]) / spacing[0];
    const double row = (point[1] - origin[1]) / spacing[1];
    const glm::dvec3 position =
      grid.Body.ToPosition({ grid.West + column * grid.Step, grid.LatitudeOf(row), point[2] });
    std::copy_n(&position.x, 3, point);
  }
}

//------------------------------------------------------------------------------
void FromFlat(vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights)
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(paths->GetNumberOfPoints());
  for (vtkIdType i = 0; i < paths->GetNumberOfPoints(); ++i)
  {
    double point[3];
    paths->GetPoint(i, point);
    FromFlat(point, 1, grid, heights);
    points->SetPoint(i, point);
  }
  paths->SetPoints(points);
}
}
