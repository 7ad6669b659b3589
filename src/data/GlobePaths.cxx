// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/GlobePaths.h"

#include "core/grid/Constants.h"
#include "data/PathBuilder.h"

#include "vtkImageData.h"
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
  Flattener(
    vtkPolyData* paths, vtkPolyData* flat, const GlobeGrid& grid, vtkImageData* heights, double sag)
    : Paths(paths, flat)
    , Grid(grid)
    , Heights(heights)
    , Step(std::sqrt(8.0 * sag / grid.Body.Equatorial))
    , First(FirstOf(grid))
  {
  }

  void Run()
  {
    this->Paths.ForEachCell(
      [this](vtkIdType id, vtkIdType cell)
      {
        const glm::dvec3 place = this->PlaceOf(id);
        this->Paths.AddVertex(this->Flat(place, this->TurnOf(place.x)), id, cell);
      },
      [this](const std::vector<vtkIdType>& ids, vtkIdType cell) { this->AddLine(ids, cell); });
    this->Paths.Finish();
  }

private:
  glm::dvec3 PlaceOf(vtkIdType id) const
  {
    return this->Grid.Body.ToPlace(this->Paths.GetPoint(id));
  }

  /// Turns by which a longitude lies east of those of the image.
  double TurnOf(double longitude) const
  {
    return std::floor((longitude - this->First) / kTurn);
  }

  glm::dvec3 Flat(const glm::dvec3& place, double turn) const
  {
    return FlatOf({ place.x - turn * kTurn, place.y, place.z }, this->Grid, this->Heights);
  }

  void AddLine(const std::vector<vtkIdType>& ids, vtkIdType cell)
  {
    glm::dvec3 last(0.0);
    double turn = 0.0;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      glm::dvec3 place = this->PlaceOf(ids[k]);
      if (!std::isfinite(place.x + place.y + place.z))
      {
        this->Paths.EndLine(cell);
        continue;
      }
      if (!this->Paths.HasLine())
      {
        turn = this->TurnOf(place.x);
        this->Paths.AddToLine(this->Flat(place, turn), ids[k], ids[k], 0.0);
      }
      else
      {
        const bool isPole = 90.0 * kDegree - std::abs(place.y) < kAtPole;
        place.x = isPole ? last.x : last.x + std::remainder(place.x - last.x, kTurn);
        turn = this->AddSegment(last, place, turn, { ids[k - 1], ids[k], cell });
      }
      last = place;
    }
    this->Paths.EndLine(cell);
  }

  /// Where a segment comes from: points and cell of the input.
  struct Source
  {
    vtkIdType From;
    vtkIdType To;
    vtkIdType Cell;
  };

  /// The line from a point, which is drawn, to another. Returns the turn of its end.
  double AddSegment(const glm::dvec3& from, const glm::dvec3& to, double turn, const Source& source)
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
        glm::dvec3 there = glm::mix(from, to, cut);
        there.x = border;
        this->Paths.AddToLine(this->Flat(there, turn), source.From, source.To, cut);
        this->Paths.EndLine(source.Cell);
        this->Paths.AddToLine(this->Flat(there, next), source.From, source.To, cut);
        turn = next;
      }
      this->Paths.AddToLine(this->Flat(place, turn), source.From, source.To, t);
    }
    return turn;
  }

  PathBuilder Paths;
  const GlobeGrid& Grid;
  vtkImageData* Heights;
  double Step;
  double First; ///< longitude from which those of the image, or its gap, count
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToFlat(
  vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights, double sag)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  Flattener(paths, flat, grid, heights, sag).Run();
  return flat;
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
