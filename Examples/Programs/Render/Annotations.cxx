// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Annotations.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"
#include "VectorFile.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainViewpoint.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <string>

namespace
{
using Color = std::array<double, 3>;

/// Part of their distance from the eye by which lines and labels are drawn nearer than they are, so
/// that the ground beside them does not hide them: their place in the picture stays the same.
constexpr double kNearer = 0.005;
/// In pixels of a picture 720 pixels high.
constexpr double kTrackWidth = 3.0;
constexpr double kPointSize = 11.0;
constexpr double kGraticuleWidth = 1.3;
constexpr double kLabelSize = 15.0;
constexpr double kUsualHeight = 720.0;
constexpr Color kTrackColor = { 0.85, 0.10, 0.08 };
constexpr Color kGraticuleColor = { 0.10, 0.12, 0.20 };

double Pixels(double usual, const Options& options)
{
  return usual * std::max(0.5, options.Size[1] / kUsualHeight);
}

/// Moves points towards the eye.
void BringNearer(vtkPoints* points, vtkCamera* camera)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> point{};
    points->GetPoint(i, point.data());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] += kNearer * (camera->GetPosition()[axis] - point[axis]);
    }
    points->SetPoint(i, point.data());
  }
}

/// Lines and points on the terrain, in one colour that light does not change.
void AddActor(
  vtkRenderer* renderer, vtkPolyData* lines, const Color& color, double width, double pointSize)
{
  BringNearer(lines->GetPoints(), renderer->GetActiveCamera());
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  const vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->LightingOff();
  property->SetLineWidth(static_cast<float>(width));
  property->SetPointSize(static_cast<float>(pointSize));
  property->RenderPointsAsSpheresOn();
  renderer->AddActor(actor);
}

/// Adds the points and lines of a file; returns their number of points as drawn.
vtkIdType AddTrack(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  const std::string& path)
{
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(ReadVectors(path, heights.Georeference));
  drape->SetHeightsData(heights.Image);
  drape->SetGeoreference(heights.Georeference);
  drape->SetMode(options.Place.TrackMode);
  drape->SetExaggeration(heights.Exaggeration);
  drape->Update();
  ThrowOnError(path);
  vtkPolyData* lines = drape->GetOutput();
  if (lines->GetNumberOfCells() == 0)
  {
    throw Failure(path, "it does not meet the terrain");
  }
  AddActor(renderer, lines, kTrackColor, Pixels(kTrackWidth, options), Pixels(kPointSize, options));
  return lines->GetNumberOfPoints();
}

/// False for points behind the eye, which the projection would mirror into the picture.
bool IsInFront(vtkCamera* camera, const double point[3])
{
  std::array<double, 3> way{};
  vtkMath::Subtract(point, camera->GetPosition(), way.data());
  return vtkMath::Dot(way.data(), camera->GetDirectionOfProjection()) > 0.0;
}

/// Texts at points of the terrain that the eye sees.
void AddLabels(
  vtkRenderer* renderer, vtkPolyData* labels, const PlacedHeights& heights, const Options& options)
{
  auto* texts = vtkStringArray::SafeDownCast(labels->GetPointData()->GetAbstractArray("Label"));
  vtkCamera* camera = renderer->GetActiveCamera();
  BringNearer(labels->GetPoints(), camera);
  const vtkNew<vtkTerrainViewpoint> viewpoint;
  viewpoint->SetHeights(heights.Image);
  viewpoint->SetExaggeration(heights.Exaggeration);
  viewpoint->SetRefraction(1.0); // straight lines, as the picture has them
  for (vtkIdType i = 0; texts && i < labels->GetNumberOfPoints(); ++i)
  {
    if (!IsInFront(camera, labels->GetPoint(i)) ||
      !viewpoint->IsVisible(camera->GetPosition(), labels->GetPoint(i)))
    {
      continue;
    }
    const vtkNew<vtkTextActor> label;
    label->SetInput(texts->GetValue(i).c_str());
    label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    label->GetPositionCoordinate()->SetValue(labels->GetPoint(i));
    vtkTextProperty* property = label->GetTextProperty();
    property->SetFontSize(static_cast<int>(Pixels(kLabelSize, options)));
    property->SetColor(kGraticuleColor[0], kGraticuleColor[1], kGraticuleColor[2]);
    property->SetBackgroundColor(1.0, 1.0, 1.0);
    property->SetBackgroundOpacity(0.75);
    property->SetJustificationToCentered();
    property->SetVerticalJustificationToCentered();
    renderer->AddViewProp(label);
  }
}

void AddGraticule(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  vtkTerrainGraticule::GridType grid)
{
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(heights.Image);
  graticule->SetGeoreference(heights.Georeference);
  graticule->SetGrid(grid);
  graticule->SetExaggeration(heights.Exaggeration);
  if (heights.IsGlobe())
  {
    // above what VTK's depth buffer can tell from space
    constexpr double kOffset = 1500.0;
    graticule->SetOffset(kOffset);
    graticule->SetStep(15.0);
  }
  graticule->Update();
  ThrowOnError("--graticule");
  if (graticule->GetOutput()->GetNumberOfCells() > 0)
  {
    AddActor(
      renderer, graticule->GetOutput(), kGraticuleColor, Pixels(kGraticuleWidth, options), 1.0);
    AddLabels(renderer, graticule->GetOutput(1), heights, options);
  }
}
}

//------------------------------------------------------------------------------
void AddLines(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  Statistics& statistics)
{
  if (options.Place.Graticule)
  {
    AddGraticule(renderer, heights, options, *options.Place.Graticule);
  }
  vtkIdType points = 0;
  for (const std::string& path : options.Place.Tracks)
  {
    points += AddTrack(renderer, heights, options, path);
  }
  if (points > 0)
  {
    statistics.SetCount("track_points", points);
  }
}
