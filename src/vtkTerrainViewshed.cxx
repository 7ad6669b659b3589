// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainViewshed.h"

#include "core/grid/HeightSampling.h"
#include "core/rays/Viewshed.h"
#include "data/ImageHeights.h"
#include "data/ObserverPlaces.h"
#include "data/SMPParallelFor.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainViewshed);

namespace
{
/// Observers that are looked after between two reports of progress.
constexpr std::size_t kBatch = 32;

/// Puts an observer on the ground; where there is none Ground is NaN. False if it is outside.
template <typename View>
bool Stand(const View& view, const glm::dvec2& place, double eyeHeight, terrain::Observer& observer)
{
  const glm::dvec2 last(static_cast<double>(view.Width - 1), static_cast<double>(view.Height - 1));
  const bool inside =
    place.x >= -1e-6 && place.y >= -1e-6 && place.x <= last.x + 1e-6 && place.y <= last.y + 1e-6;
  if (!inside)
  {
    return false;
  }
  observer.Position = glm::clamp(place, glm::dvec2(0.0), last);
  // What rounding has moved off a sample.
  const glm::dvec2 sample = glm::round(observer.Position);
  observer.Position = glm::length(sample - observer.Position) < 1e-6 ? sample : observer.Position;
  observer.Ground = terrain::SampleBilinear(view, observer.Position.x, observer.Position.y);
  observer.Eye = observer.Ground + eyeHeight;
  return true;
}

/// Puts observers on the ground; the first one that cannot be is named.
template <typename View>
std::string StandObservers(const View& view, const terrain::ObserverPlaces& places,
  double eyeHeight, std::vector<terrain::Observer>& observers)
{
  if (places.TooMany)
  {
    return "there are more than 10 million observers: a greater ObserverSpacing makes fewer";
  }
  terrain::Observer observer;
  for (const glm::dvec2& place : places.Fixed)
  {
    const bool inside = Stand(view, place, eyeHeight, observer);
    if (!inside || std::isnan(observer.Ground))
    {
      return "observer " + std::to_string(observers.size() + 1) +
        (inside ? " stands where there is no height" : " stands outside the heights");
    }
    observers.push_back(observer);
  }
  for (const glm::dvec2& place : places.Optional)
  {
    if (Stand(view, place, eyeHeight, observer) && !std::isnan(observer.Ground))
    {
      observers.push_back(observer);
    }
  }
  return observers.empty()
    ? "there are no observers: no sample with a height lies inside of an area"
    : std::string();
}

/// NaN where there is no height, and where no rise would do.
template <typename View>
void MarkNoRise(const View& view, float* values)
{
  terrain::SMPParallelFor(view.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < view.Width; ++i)
        {
          float& value = values[i + view.Width * j];
          value = std::isinf(value) || std::isnan(static_cast<double>(view.At(i, j)))
            ? std::numeric_limits<float>::quiet_NaN()
            : value;
        }
      }
    });
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
std::string vtkTerrainViewshed::WhyNot() const
{
  const auto isRange = [](const double range[2]) { return range[0] <= range[1]; };
  if (!isRange(this->DistanceRange) || !isRange(this->AzimuthRange) ||
    !isRange(this->ElevationRange))
  {
    return std::string("the range of ") +
      (!isRange(this->DistanceRange)     ? "distances"
          : !isRange(this->AzimuthRange) ? "azimuths (north is 0 and 360, as in 315 to 405)"
                                         : "elevations") +
      " must go from a number to one that is not less";
  }
  if (this->AzimuthRange[1] - this->AzimuthRange[0] > 360.0)
  {
    return "the range of azimuths must not be wider than 360 degrees";
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkTerrainViewshed::LookAround(
  vtkImageData* heights, vtkPointSet* places, vtkUnsignedIntArray* counts, vtkFloatArray* rises)
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
  float* const lowest = this->OutputRise ? rises->GetPointer(0) : nullptr;
  std::string whyNot;
  terrain::ImageHeights::Dispatch(heights,
    [&](const auto& view)
    {
      std::vector<terrain::Observer> observers;
      whyNot =
        StandObservers(view, terrain::FindObserverPlaces(places, frame, this->ObserverSpacing),
          this->EyeHeight, observers);
      if (!whyNot.empty())
      {
        return;
      }
      const terrain::ViewshedGrid grid(view, terrain::SMPParallelFor, this->NoDataBlocks);
      for (std::size_t k = 0; k < observers.size() && !this->AbortExecute; k += kBatch)
      {
        this->UpdateProgress(static_cast<double>(k) / static_cast<double>(observers.size()));
        const auto first = observers.begin() + static_cast<std::ptrdiff_t>(k);
        const auto count = static_cast<std::ptrdiff_t>(std::min(kBatch, observers.size() - k));
        grid.Measure({ first, first + count }, options, counts->GetPointer(0), lowest,
          terrain::SMPParallelFor);
      }
      if (lowest)
      {
        MarkNoRise(view, lowest);
      }
    });
  return whyNot;
}

//------------------------------------------------------------------------------
int vtkTerrainViewshed::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  this->ErrorMessage = this->WhyNot();
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = terrain::ImageHeights::WhyNotHeights(heights);
  }
  vtkNew<vtkUnsignedIntArray> counts;
  vtkNew<vtkFloatArray> rises;
  if (this->ErrorMessage.empty())
  {
    counts->SetName("Observers");
    counts->SetNumberOfTuples(heights->GetNumberOfPoints());
    counts->FillValue(0);
    rises->SetName("RiseToBeSeen");
    rises->SetNumberOfTuples(this->OutputRise ? heights->GetNumberOfPoints() : 0);
    rises->FillValue(std::numeric_limits<float>::infinity());
    this->ErrorMessage = this->LookAround(heights, vtkPointSet::GetData(inputs[1]), counts, rises);
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
  if (this->OutputRise)
  {
    terrain::ImageHeights::ArrangeRows(heights, rises->GetPointer(0), size[0], size[1]);
    output->GetPointData()->AddArray(rises);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainViewshed::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto range = [&](const char* name, const double values[2])
  { os << indent << name << ": " << values[0] << " to " << values[1] << "\n"; };
  os << indent << "EyeHeight: " << this->EyeHeight << "\n";
  os << indent << "ObserverSpacing: " << this->ObserverSpacing << "\n";
  os << indent << "NoDataBlocks: " << (this->NoDataBlocks ? "on" : "off") << "\n";
  os << indent << "OutputRise: " << (this->OutputRise ? "on" : "off") << "\n";
  os << indent << "TargetHeight: " << this->TargetHeight << "\n";
  os << indent << "Curvature: " << (this->Curvature ? "on" : "off") << "\n";
  os << indent << "Refraction: " << this->Refraction << "\n";
  os << indent << "PlanetRadius: " << this->PlanetRadius << "\n";
  range("DistanceRange", this->DistanceRange);
  range("AzimuthRange", this->AzimuthRange);
  range("ElevationRange", this->ElevationRange);
}
