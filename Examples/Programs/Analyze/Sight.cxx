// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sight.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTerrainGeoreference.h>
#include <vtkTerrainOutputFile.h>
#include <vtkTerrainReproject.h>
#include <vtkTerrainViewpoint.h>
#include <vtkTerrainViewshed.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

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
    vtkSmartPointer<vtkImageData> heights = ReadHeights(raster, 24.0);
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

/// Counts as floats, NaN where there is no height.
std::vector<float> CountsOf(vtkImageData* heights, vtkUnsignedIntArray* counts)
{
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  std::vector<float> values(static_cast<std::size_t>(counts->GetNumberOfValues()));
  using Dispatcher = vtkArrayDispatch::Dispatch;
  const auto convert = [&](auto* scalars)
  {
    const auto samples = vtk::DataArrayValueRange<1>(scalars);
    for (vtkIdType i = 0; i < counts->GetNumberOfValues(); ++i)
    {
      const bool hidden = ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0;
      values[static_cast<std::size_t>(i)] = hidden || std::isnan(static_cast<double>(samples[i]))
        ? std::numeric_limits<float>::quiet_NaN()
        : static_cast<float>(counts->GetValue(i));
    }
  };
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  if (!Dispatcher::Execute(scalars, convert))
  {
    convert(scalars);
  }
  return values;
}
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
  const vtkSmartPointer<vtkImageData> heights = ReadHeights(raster, 48.0);
  vtkNew<vtkTerrainGeoreference> georeference;
  georeference->SetFromHeights(heights);
  if (georeference->IsGeographic())
  {
    throw Failure(raster.Heights +
      ": it is in degrees; warp it to a metric CRS first (gdalwarp -t_srs EPSG:...)");
  }
  ProgressBar bar(raster.Quiet);
  vtkNew<vtkTerrainViewshed> filter;
  filter->SetInputData(0, heights);
  filter->SetInputData(1, MakeObservers(viewshed.Observers, heights));
  filter->SetEyeHeight(viewshed.EyeHeight);
  filter->SetTargetHeight(viewshed.TargetHeight);
  filter->SetObserverSpacing(viewshed.Spacing);
  filter->SetNoDataBlocks(viewshed.NoDataBlocks);
  filter->SetOutputRise(viewshed.Rise);
  filter->SetCurvature(viewshed.Curvature);
  filter->SetRefraction(viewshed.Refraction);
  filter->SetPlanetRadius(viewshed.Radius);
  filter->SetDistanceRange(
    viewshed.Distance[0], viewshed.Distance[1] > 1e9 ? VTK_DOUBLE_MAX : viewshed.Distance[1]);
  filter->SetAzimuthRange(viewshed.Azimuth[0], viewshed.Azimuth[1]);
  filter->SetElevationRange(viewshed.Elevation[0], viewshed.Elevation[1]);
  bar.Watch(filter, 0.9);
  filter->Update();
  Scene::Check(raster.Heights, filter->GetErrorMessage());
  vtkPointData* found = filter->GetOutput()->GetPointData();
  ResultWriter writer(raster, heights, viewshed.Rise ? 2 : 1);
  const std::vector<float> counts =
    CountsOf(heights, vtkUnsignedIntArray::SafeDownCast(found->GetArray("Observers")));
  writer.SetBand(1, "observers", counts.data());
  if (viewshed.Rise)
  {
    auto* rises = vtkFloatArray::SafeDownCast(found->GetArray("RiseToBeSeen"));
    writer.SetBand(2, "rise to be seen, metres", rises->GetPointer(0));
  }
  writer.Write();
}
