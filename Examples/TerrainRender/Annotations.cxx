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
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
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
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>

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

void AddTrack(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  Statistics& statistics)
{
  const std::string& path = options.Place.Track;
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(ReadVectors(path, heights.Georeference));
  drape->SetHeightsData(heights.Image);
  drape->SetMode(options.Place.TrackMode);
  drape->SetExaggeration(options.Exaggeration);
  drape->Update();
  ThrowOnError(path);
  vtkPolyData* lines = drape->GetOutput();
  if (lines->GetNumberOfCells() == 0)
  {
    throw Failure(path, "it does not meet the terrain");
  }
  statistics.SetCount("track_points", lines->GetNumberOfPoints());
  AddActor(renderer, lines, kTrackColor, Pixels(kTrackWidth, options), Pixels(kPointSize, options));
}

void AddLabels(vtkRenderer* renderer, vtkPolyData* labels, const Options& options)
{
  auto* texts = vtkStringArray::SafeDownCast(labels->GetPointData()->GetAbstractArray("Label"));
  BringNearer(labels->GetPoints(), renderer->GetActiveCamera());
  for (vtkIdType i = 0; texts && i < labels->GetNumberOfPoints(); ++i)
  {
    const vtkNew<vtkBillboardTextActor3D> label;
    label->SetInput(texts->GetValue(i).c_str());
    label->SetPosition(labels->GetPoint(i));
    vtkTextProperty* property = label->GetTextProperty();
    property->SetFontSize(static_cast<int>(Pixels(kLabelSize, options)));
    property->SetColor(kGraticuleColor[0], kGraticuleColor[1], kGraticuleColor[2]);
    property->SetBackgroundColor(1.0, 1.0, 1.0);
    property->SetBackgroundOpacity(1.0);
    property->SetJustificationToCentered();
    renderer->AddActor(label);
  }
}

void AddGraticule(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options)
{
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(heights.Image);
  graticule->SetGeoreference(heights.Georeference);
  graticule->SetGrid(*options.Place.Graticule);
  graticule->SetExaggeration(options.Exaggeration);
  graticule->Update();
  ThrowOnError("--graticule");
  if (graticule->GetOutput()->GetNumberOfCells() > 0)
  {
    AddActor(
      renderer, graticule->GetOutput(), kGraticuleColor, Pixels(kGraticuleWidth, options), 1.0);
    AddLabels(renderer, graticule->GetOutput(1), options);
  }
}
}

//------------------------------------------------------------------------------
void AddLines(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  Statistics& statistics)
{
  if (options.Place.Graticule)
  {
    AddGraticule(renderer, heights, options);
  }
  if (!options.Place.Track.empty())
  {
    AddTrack(renderer, heights, options, statistics);
  }
}
