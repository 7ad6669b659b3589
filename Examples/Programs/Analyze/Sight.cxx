// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sight.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTerrainGeoreference.h>
#include <vtkTerrainOutputFile.h>
#include <vtkTerrainReproject.h>
#include <vtkTerrainViewpoint.h>
#include <vtkTerrainViewshed.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <sstream>

namespace
{
/// Heights in a metric scene, with the two places of a sight in it.
struct Scene
{
  vtkNew<vtkTerrainGeoreference> Georeference;
  vtkNew<vtkTerrainViewpoint> Viewpoint;
  double From[3];
  double To[3];

  Scene(const RasterOptions& raster, const SightOptions& sight)
  {
    vtkSmartPointer<vtkImageData> heights = ReadHeights(raster);
    this->Georeference->SetFromHeights(heights);
    if (this->Georeference->IsGeographic())
    {
      vtkNew<vtkTerrainReproject> reproject;
      reproject->SetGeoreference(this->Georeference);
      reproject->SetInputData(heights);
      reproject->Update();
      Check(raster.Heights, reproject->GetErrorMessage());
      heights = reproject->GetOutput();
    }
    else
    {
      this->Georeference->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
    }
    Check(raster.Heights, this->Georeference->GetWhyNot());
    this->Viewpoint->SetGeoreference(this->Georeference);
    this->Viewpoint->SetHeights(heights);
    this->Viewpoint->SetRefraction(sight.Refraction);
    Check(sight.From, this->Viewpoint->FindPlace(sight.From, this->From));
    Check(sight.To, this->Viewpoint->FindPlace(sight.To, this->To));
  }

  static void Check(const std::string& what, const std::string& whyNot)
  {
    if (!whyNot.empty())
    {
      throw Failure(what + ": " + whyNot);
    }
  }
};
}

//------------------------------------------------------------------------------
void WriteProfile(const RasterOptions& raster, const SightOptions& sight)
{
  Scene scene(raster, sight);
  vtkNew<vtkPolyData> profile;
  Scene::Check(
    raster.Heights, scene.Viewpoint->GetProfile(scene.From, scene.To, sight.Count, profile));
  vtkDataArray* distances = profile->GetPointData()->GetArray("Distance");
  vtkDataArray* heights = profile->GetPointData()->GetArray("Height");
  std::ostringstream text;
  text << "distance,height\n";
  text.precision(10);
  for (vtkIdType i = 0; i < profile->GetNumberOfPoints(); ++i)
  {
    const double height = heights->GetComponent(i, 0);
    text << distances->GetComponent(i, 0) << ",";
    if (!std::isnan(height))
    {
      text << height;
    }
    text << "\n";
  }
  const std::string lines = text.str();
  vtkNew<vtkTerrainOutputFile> file;
  OpenOutput(file, raster);
  if (!file->Write(lines.data(), lines.size()) || !file->Commit())
  {
    throw Failure(file->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void PrintLineOfSight(const RasterOptions& raster, const SightOptions& sight)
{
  Scene scene(raster, sight);
  double obstruction[3];
  if (scene.Viewpoint->IsVisible(scene.From, scene.To, obstruction))
  {
    std::cout << "visible\n";
    return;
  }
  double place[3];
  scene.Georeference->SceneToPlaces(obstruction, place, 1);
  std::printf("hidden by the terrain at %.6f,%.6f, %.0f m from the eye\n", place[0], place[1],
    scene.Viewpoint->GetDistance(scene.From, obstruction));
}

//------------------------------------------------------------------------------
void WriteViewshed(const RasterOptions& raster, const ViewshedOptions& viewshed)
{
  const vtkSmartPointer<vtkImageData> heights = ReadHeights(raster);
  vtkNew<vtkTerrainGeoreference> georeference;
  georeference->SetFromHeights(heights);
  if (georeference->IsGeographic())
  {
    throw Failure(raster.Heights +
      ": it is in degrees; warp it to a metric CRS first (gdalwarp -t_srs EPSG:...)");
  }
  ProgressBar bar(raster.Quiet);
  std::vector<double> origin = GetNumbers(heights, "LayoutOrigin");
  std::vector<double> scale = GetNumbers(heights, "LayoutScale");
  if (origin.size() < 2 || scale.size() < 2)
  {
    origin = { 0.0, 0.0 };
    scale = { 1.0, 1.0 };
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 1 < viewshed.Observers.size(); i += 2)
  {
    points->InsertNextPoint((viewshed.Observers[i] - origin[0]) * scale[0],
      (viewshed.Observers[i + 1] - origin[1]) * scale[1], 0.0);
  }
  vtkNew<vtkPolyData> observers;
  observers->SetPoints(points);
  vtkNew<vtkTerrainViewshed> filter;
  filter->SetInputData(0, heights);
  filter->SetInputData(1, observers);
  filter->SetEyeHeight(viewshed.EyeHeight);
  filter->SetTargetHeight(viewshed.TargetHeight);
  filter->SetCurvature(viewshed.Curvature);
  filter->SetRefraction(viewshed.Refraction);
  filter->SetPlanetRadius(viewshed.Radius);
  if (viewshed.Distance > 0.0)
  {
    filter->SetDistanceRange(0.0, viewshed.Distance);
  }
  filter->Update();
  Scene::Check(raster.Heights, filter->GetErrorMessage());
  bar.Show(0.8);
  vtkDataArray* counts = filter->GetOutput()->GetPointData()->GetArray("Observers");
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  std::vector<float> values(static_cast<std::size_t>(counts->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    const bool hidden = ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    values[static_cast<std::size_t>(i)] = hidden || std::isnan(scalars->GetComponent(i, 0))
      ? std::numeric_limits<float>::quiet_NaN()
      : static_cast<float>(counts->GetComponent(i, 0));
  }
  ResultWriter writer(raster, heights, 1);
  writer.SetBand(1, "observers", values.data());
  writer.Write();
}
