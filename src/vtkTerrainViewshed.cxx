// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainViewshed.h"

#include "core/grid/HeightSampling.h"
#include "core/rays/Viewshed.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainViewshed);

namespace
{
/// Places of observers in grid coordinates: points, and between them along lines.
std::vector<glm::dvec2> FindPlaces(vtkPointSet* observers, const terrain::GridGeometry& frame)
{
  const auto toGrid = [&](vtkIdType point)
  {
    double p[3];
    observers->GetPoint(point, p);
    return glm::dvec2(frame.ToGrid({ p[0], p[1], p[2] }));
  };
  std::vector<glm::dvec2> places;
  for (vtkIdType i = 0; i < observers->GetNumberOfPoints(); ++i)
  {
    places.push_back(toGrid(i));
  }
  auto* poly = vtkPolyData::SafeDownCast(observers);
  if (!poly || !poly->GetLines())
  {
    return places;
  }
  auto line = vtk::TakeSmartPointer(poly->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    line->GetCurrentCell(count, ids);
    for (vtkIdType k = 1; k < count; ++k)
    {
      const glm::dvec2 from = toGrid(ids[k - 1]);
      const glm::dvec2 way = toGrid(ids[k]) - from;
      const int parts =
        static_cast<int>(std::min(std::ceil(std::max(std::abs(way.x), std::abs(way.y))), 1e8));
      for (int part = 1; part < parts; ++part)
      {
        places.push_back(from + way * (static_cast<double>(part) / parts));
      }
    }
  }
  return places;
}

/// Puts observers on the ground; the first one that cannot be is named.
template <typename View>
std::string StandObservers(const View& view, const std::vector<glm::dvec2>& places,
  double eyeHeight, std::vector<terrain::Observer>& observers)
{
  const glm::dvec2 last(static_cast<double>(view.Width - 1), static_cast<double>(view.Height - 1));
  for (const glm::dvec2& place : places)
  {
    terrain::Observer observer;
    const bool inside =
      place.x >= -1e-6 && place.y >= -1e-6 && place.x <= last.x + 1e-6 && place.y <= last.y + 1e-6;
    observer.Position = glm::clamp(place, glm::dvec2(0.0), last);
    // What rounding has moved off a sample.
    const glm::dvec2 sample = glm::round(observer.Position);
    observer.Position = glm::length(sample - observer.Position) < 1e-6 ? sample : observer.Position;
    observer.Ground =
      inside ? terrain::SampleBilinear(view, observer.Position.x, observer.Position.y) : 0.0;
    observer.Eye = observer.Ground + eyeHeight;
    if (!inside || std::isnan(observer.Ground))
    {
      return "observer " + std::to_string(observers.size() + 1) +
        (inside ? " stands where there is no height" : " stands outside the heights");
    }
    observers.push_back(observer);
  }
  return observers.empty() ? "there are no observers" : std::string();
}
}

//------------------------------------------------------------------------------
vtkTerrainViewshed::vtkTerrainViewshed()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkTerrainViewshed::SetObserversConnection(vtkAlgorithmOutput* observers)
{
  this->SetInputConnection(1, observers);
}

//------------------------------------------------------------------------------
int vtkTerrainViewshed::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainViewshed::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The superclass would copy the information of every port.
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  out->CopyEntry(info, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  out->CopyEntry(info, vtkDataObject::ORIGIN());
  out->CopyEntry(info, vtkDataObject::SPACING());
  out->CopyEntry(info, vtkDataObject::DIRECTION());
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainViewshed::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Any part may see any other.
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainViewshed::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  vtkPointSet* places = vtkPointSet::GetData(inputs[1]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  this->ErrorMessage = terrain::ImageHeights::WhyNotHeights(heights);
  vtkNew<vtkUnsignedIntArray> counts;
  if (this->ErrorMessage.empty())
  {
    const terrain::GridGeometry frame = terrain::ImageHeights::Geometry(heights);
    terrain::ViewshedOptions options;
    options.Spacing = frame.Spacing;
    options.TargetHeight = this->TargetHeight;
    options.Drop = this->Curvature ? (1.0 - this->Refraction) / (2.0 * this->PlanetRadius) : 0.0;
    options.NearestDistance = this->DistanceRange[0];
    options.FarthestDistance =
      this->DistanceRange[1] < VTK_DOUBLE_MAX ? this->DistanceRange[1] : terrain::kInfinity;
    options.FirstAzimuth = this->AzimuthRange[0];
    options.LastAzimuth = this->AzimuthRange[1];
    options.LowestElevation = this->ElevationRange[0];
    options.HighestElevation = this->ElevationRange[1];
    counts->SetName("Observers");
    counts->SetNumberOfTuples(heights->GetNumberOfPoints());
    counts->FillValue(0);
    terrain::ImageHeights::Dispatch(heights,
      [&](const auto& view)
      {
        std::vector<terrain::Observer> observers;
        this->ErrorMessage =
          StandObservers(view, FindPlaces(places, frame), this->EyeHeight, observers);
        if (this->ErrorMessage.empty())
        {
          const terrain::ViewshedGrid grid(view, terrain::SMPParallelFor);
          grid.Count(observers, options, counts->GetPointer(0), terrain::SMPParallelFor);
        }
      });
  }
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro("No viewshed: " << this->ErrorMessage << ".");
    return 0;
  }
  const int* size = heights->GetDimensions();
  terrain::ImageHeights::ArrangeRows(heights, counts->GetPointer(0), size[0], size[1]);
  output->ShallowCopy(heights);
  output->GetPointData()->AddArray(counts);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainViewshed::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto range = [&](const char* name, const double values[2])
  { os << indent << name << ": " << values[0] << " to " << values[1] << "\n"; };
  os << indent << "EyeHeight: " << this->EyeHeight << "\n";
  os << indent << "TargetHeight: " << this->TargetHeight << "\n";
  os << indent << "Curvature: " << (this->Curvature ? "on" : "off") << "\n";
  os << indent << "Refraction: " << this->Refraction << "\n";
  os << indent << "PlanetRadius: " << this->PlanetRadius << "\n";
  range("DistanceRange", this->DistanceRange);
  range("AzimuthRange", this->AzimuthRange);
  range("ElevationRange", this->ElevationRange);
}
