// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Tracks on the ground or above it, as lines or tubes, in one colour or by a field.
#include "ViewMarks.h"

#include "ColorName.h"
#include "Failure.h"
#include "FieldColors.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"
#include "TextSize.h"
#include "VectorFile.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTerrainDrape.h"
#include "vtkTubeFilter.h"

#include <string>
#include <vector>

namespace
{
/// In pixels of a picture 720 pixels high.
constexpr double kTrackWidth = 3.0;
constexpr double kPointSize = 11.0;
constexpr RGB kTrackColor = { 0.85, 0.10, 0.08 };
constexpr int kTubeSides = 12;
}

//------------------------------------------------------------------------------
void ViewMarks::AddTrack(vtkPolyData* track, const std::string& path)
{
  const TrackOptions& options = this->Wanted.Track;
  const RGB color =
    options.ColorBy.empty() ? ParseColor(options.Colors).value_or(kTrackColor) : kTrackColor;
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(track);
  drape->SetHeightsData(this->Heights.Image);
  drape->SetGeoreference(this->Heights.Georeference);
  drape->SetMode(this->Wanted.Place.TrackMode);
  drape->SetExaggeration(this->Heights.Exaggeration);
  drape->Update();
  ThrowOnError(path);
  vtkPolyData* lines = drape->GetOutput();
  if (lines->GetNumberOfCells() == 0)
  {
    throw Failure(path, "it does not meet the terrain");
  }
  this->TrackPoints += lines->GetNumberOfPoints();
  const double width = options.GetPixels(kTrackWidth);
  if (options.GetMetres() > 0.0 && lines->GetNumberOfLines() > 0)
  {
    const vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(lines);
    tube->SetRadius(0.5 * options.GetMetres());
    tube->SetNumberOfSides(kTubeSides);
    tube->CappingOn();
    tube->Update();
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(tube->GetOutput());
    mapper->ScalarVisibilityOff();
    ColorByValue(mapper, this->TrackKey.Table);
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    this->Renderer->AddActor(actor);
    lines->SetLines(nullptr); // its points are left
    if (lines->GetNumberOfVerts() == 0)
    {
      return;
    }
  }
  vtkActor* actor = this->AddLines(lines, color.data(), LinePixels(width, this->Wanted),
    LinePixels(kPointSize / kTrackWidth * width, this->Wanted));
  ColorByValue(actor->GetMapper(), this->TrackKey.Table);
}

//------------------------------------------------------------------------------
void ViewMarks::ReadTracks(Statistics& statistics)
{
  const std::string& field = this->Wanted.Track.ColorBy;
  std::vector<vtkSmartPointer<vtkPolyData>> tracks;
  tracks.reserve(this->Wanted.Place.Tracks.size());
  for (const std::string& path : this->Wanted.Place.Tracks)
  {
    tracks.push_back(field.empty() ? ReadVectors(path, this->Heights.Georeference)
                                   : ReadVectorsWithField(path, this->Heights.Georeference, field));
  }
  if (!field.empty())
  {
    this->TrackKey = ColorByField(tracks, this->Wanted.Track);
  }
  for (std::size_t k = 0; k < tracks.size(); ++k)
  {
    this->AddTrack(tracks[k], this->Wanted.Place.Tracks[k]);
  }
  statistics.SetCount("track_points", this->TrackPoints);
}
