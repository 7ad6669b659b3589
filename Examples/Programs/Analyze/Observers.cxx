// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Observers.h"

#include "Failure.h"
#include "Raster.h"
#include "VectorFile.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTerrainGeoreference.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace
{
using Corners = std::vector<std::array<double, 2>>;

enum class Kind
{
  Point,
  Polyline,
  Polygon
};

class Collector
{
public:
  explicit Collector(vtkImageData* heights)
  {
    this->Points->SetDataTypeToDouble();
    const std::vector<double> origin = GetNumbers(heights, "LayoutOrigin");
    const std::vector<double> scale = GetNumbers(heights, "LayoutScale");
    if (origin.size() >= 2 && scale.size() >= 2)
    {
      this->Origin = { origin[0], origin[1] };
      this->Scale = { scale[0], scale[1] };
    }
  }

  void Add(Kind kind, const Corners& corners)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (const std::array<double, 2>& corner : corners)
    {
      this->Points->InsertNextPoint((corner[0] - this->Origin[0]) * this->Scale[0],
        (corner[1] - this->Origin[1]) * this->Scale[1], 0.0);
    }
    if (kind != Kind::Point)
    {
      vtkCellArray* cells = kind == Kind::Polyline ? this->Lines : this->Areas;
      cells->InsertNextCell(static_cast<int>(corners.size()));
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        cells->InsertCellPoint(first + static_cast<vtkIdType>(k));
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Get()
  {
    vtkNew<vtkPolyData> observers;
    observers->SetPoints(this->Points);
    observers->SetLines(this->Lines);
    observers->SetPolys(this->Areas);
    return observers;
  }

private:
  std::array<double, 2> Origin{ 0.0, 0.0 };
  std::array<double, 2> Scale{ 1.0, 1.0 };
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Areas;
};

/// "X,Y"; false for any other text.
bool ReadCorner(const std::string& text, std::array<double, 2>& corner)
{
  char rest = 0;
  return std::sscanf(text.c_str(), "%lf,%lf%c", &corner[0], &corner[1], &rest) == 2 &&
    std::isfinite(corner[0]) && std::isfinite(corner[1]);
}

/// "X,Y X,Y ...".
Corners ParseCorners(const std::string& option, const std::string& text, std::size_t least)
{
  Corners corners;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    std::array<double, 2> corner{};
    if (!ReadCorner(word, corner))
    {
      throw Failure(option, WhyNotCorner(word));
    }
    corners.push_back(corner);
  }
  if (corners.size() < least)
  {
    throw Failure(option + ": \"" + text + "\" has fewer than " + std::to_string(least) +
      " corners, as in \"X,Y X,Y X,Y\"");
  }
  return corners;
}
}

//------------------------------------------------------------------------------
std::string WhyNotCorner(const std::string& text)
{
  std::array<double, 2> corner{};
  return ReadCorner(text, corner)
    ? std::string()
    : "'" + text + "' is not X,Y: two numbers, for observers stand on the ground";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeObservers(const ObserverOptions& options, vtkImageData* heights)
{
  Collector observers(heights);
  for (const std::string& point : options.Points)
  {
    observers.Add(Kind::Point, ParseCorners("--observer", point, 1));
  }
  for (const std::string& line : options.Lines)
  {
    observers.Add(Kind::Polyline, ParseCorners("--line", line, 2));
  }
  for (const std::string& area : options.Areas)
  {
    observers.Add(Kind::Polygon, ParseCorners("--area", area, 3));
  }
  vtkNew<vtkTerrainGeoreference> scene;
  scene->SetFromHeights(heights);
  scene->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  all->AddInputData(observers.Get());
  for (const std::string& file : options.Files)
  {
    all->AddInputData(ReadVectors(file, scene, Polygons::Areas));
  }
  all->Update();
  if (all->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw Failure(
      "there are no observers: --observer, --line, --area or --observers say where they "
      "stand");
  }
  return all->GetOutput();
}
