// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkTerrainHorizon.h>

#include <cstdio>

namespace
{
void Configure(const LightOptions& light, vtkTerrainHorizon* horizon)
{
  if (light.Directions < 1 || light.Directions > vtkTerrainHorizon::MaximumDirections)
  {
    throw Failure("--directions must be 1 to " +
      std::to_string(vtkTerrainHorizon::MaximumDirections) + ", not " +
      std::to_string(light.Directions));
  }
  horizon->SetNumberOfDirections(light.Directions);
  horizon->SetEyeHeight(light.EyeHeight);
  horizon->SetCurvature(light.Curvature);
  horizon->SetRefraction(light.Refraction);
  horizon->SetPlanetRadius(light.Radius);
  horizon->SetTimeStep(light.TimeStep);
  horizon->SetTurbidity(light.Turbidity);
}

/// Runs the filter, with progress, and writes some of its arrays as bands.
void WriteArrays(const RasterOptions& raster, vtkImageData* heights, vtkTerrainHorizon* horizon,
  const std::vector<const char*>& names)
{
  ProgressBar bar(raster.Quiet);
  bar.Watch(horizon, 0.95);
  horizon->SetInputData(heights);
  horizon->Update();
  if (!horizon->GetErrorMessage().empty())
  {
    throw Failure(raster.Heights + ": " + horizon->GetErrorMessage());
  }
  ResultWriter writer(raster, heights, static_cast<int>(names.size()));
  int band = 0;
  for (const char* name : names)
  {
    auto* array = vtkFloatArray::SafeDownCast(horizon->GetOutput()->GetPointData()->GetArray(name));
    writer.SetBand(++band, name, array->GetPointer(0));
  }
  writer.Write();
}
}

//------------------------------------------------------------------------------
void WriteHorizon(const RasterOptions& raster, const LightOptions& light)
{
  vtkNew<vtkTerrainHorizon> horizon;
  Configure(light, horizon);
  const vtkSmartPointer<vtkImageData> heights = ReadHeights(raster, 20.0 + 4.0 * light.Directions);
  ProgressBar bar(raster.Quiet);
  ResultWriter writer(raster, heights, light.Directions);
  vtkNew<vtkFloatArray> degrees;
  for (int k = 0; k < light.Directions; ++k)
  {
    const double azimuth = 360.0 * k / light.Directions;
    const std::string error = horizon->ComputeHorizon(heights, azimuth, degrees);
    if (!error.empty())
    {
      throw Failure(raster.Heights + ": " + error);
    }
    char name[64];
    std::snprintf(name, sizeof(name), "horizon at azimuth %.10g", azimuth);
    writer.SetBand(k + 1, name, degrees->GetPointer(0));
    bar.Show(0.95 * (k + 1) / light.Directions);
  }
  writer.Write();
}

//------------------------------------------------------------------------------
void WriteSkyView(const RasterOptions& raster, const LightOptions& light)
{
  vtkNew<vtkTerrainHorizon> horizon;
  Configure(light, horizon);
  horizon->OutputHorizonOff();
  WriteArrays(raster, ReadHeights(raster, 32.0), horizon, { "SkyView" });
}

//------------------------------------------------------------------------------
void WriteSunlight(const RasterOptions& raster, const LightOptions& light)
{
  vtkNew<vtkTerrainHorizon> horizon;
  Configure(light, horizon);
  horizon->OutputHorizonOff();
  horizon->OutputSkyViewOff();
  horizon->SetDate(light.Date);
  WriteArrays(raster, ReadHeights(raster, 56.0), horizon,
    { "SunHours", "FirstSun", "LastSun", "DirectIrradiation" });
}
