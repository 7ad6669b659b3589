// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Points, lines and polygons anywhere as places of observers: as many as there may be, those of
// areas within their polygons' bounds.
#include "FuzzInput.h"

#include "data/ObserverPlaces.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace
{
double CoordinateOf(FuzzInput& input)
{
  switch (input.Number(8))
  {
    case 0:
      return input.Take<double>();
    case 1:
      return std::floor(20.0 * input.Real());
    case 2:
      return 300.0 * input.Real();
    case 3: // so far away that neighbours are one
      return 1e17 + 64.0 * std::floor(20.0 * input.Real());
    default:
      return 50.0 * input.Real();
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  terrain::GridGeometry frame;
  frame.Spacing = { std::ldexp(1.0, static_cast<int>(input.Number(8)) - 4), 1.0 };
  frame.Origin = { CoordinateOf(input), 0.0, 0.0 };
  if (!std::isfinite(frame.Origin.x))
  {
    return 0;
  }
  const double spacing = input.Number(2) != 0 ? std::abs(CoordinateOf(input)) : 0.0;
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> lines;
  const vtkNew<vtkCellArray> areas;
  while (input.Left() > 0 && points->GetNumberOfPoints() < 200)
  {
    vtkCellArray* cells = input.Number(2) != 0 ? areas : lines;
    const int corners = static_cast<int>(input.Number(6));
    const int shared = static_cast<int>(std::min<vtkIdType>(points->GetNumberOfPoints(), 1));
    cells->InsertNextCell(corners + shared);
    if (shared != 0)
    {
      cells->InsertCellPoint(0);
    }
    for (int k = 0; k < corners; ++k)
    {
      const double x = CoordinateOf(input);
      cells->InsertCellPoint(points->InsertNextPoint(x, CoordinateOf(input), 0.0));
    }
  }
  const vtkNew<vtkPolyData> observers;
  observers->SetPoints(points);
  observers->SetLines(lines);
  observers->SetPolys(areas);
  const auto places = terrain::FindObserverPlaces(observers, frame, spacing);
  const auto count = static_cast<double>(places.Fixed.size() + places.Optional.size());
  Require(places.TooMany || count <= terrain::ObserverPlaces::Most);
  for (const glm::dvec2& place : places.Optional)
  {
    Require(std::isfinite(place.x) && std::isfinite(place.y));
  }
  return 0;
}
