// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainReproject.h"

#include "core/grid/Constants.h"
#include "core/grid/HeightSampling.h"
#include "data/FieldData.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "place/ReprojectInternals.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

using terrain::kNaN;
// Samples of a block, the unit of progress and abort.
constexpr vtkIdType kBlockSamples = 1 << 18;
// Heights from which a search begins anew where it met no data.
constexpr int kTrials = 8;
constexpr double kEarthRadius = 6371008.8;
// Samples handed to one thread at a time.
constexpr vtkIdType kSamplesPerTask = 4096;

/// Height at grid coordinates whose columns repeat after `turn` of them (0: never). Between the
/// last and the first column it is the bilinear patch.
template <typename T>
double SampleTurned(
  const terrain::HeightfieldView<T>& heights, double x, double y, double turn, bool cubic)
{
  x = turn > 0.0 && x < 0.0 ? x + turn : x;
  const double last = turn - 1.0;
  if (turn > 0.0 && x > last)
  {
    const double t = x - last;
    return (1.0 - t) * terrain::SampleBilinear(heights, last, y) +
      t * terrain::SampleBilinear(heights, 0.0, y);
  }
  return cubic ? terrain::SampleCubic(heights, x, y) : terrain::SampleBilinear(heights, x, y);
}

/// Height at grid coordinates that may lie up to `edge` cells beyond the outer samples: the line
/// through the two nearest ones goes on there.
template <typename T>
double SampleBeyond(
  const terrain::HeightfieldView<T>& heights, double x, double y, double edge, bool cubic)
{
  const double size[2] = { static_cast<double>(heights.Width) - 1.0,
    static_cast<double>(heights.Height) - 1.0 };
  const double inside[2] = { std::clamp(x, 0.0, size[0]), std::clamp(y, 0.0, size[1]) };
  const double beyond[2] = { x - inside[0], y - inside[1] };
  const double at = cubic ? terrain::SampleCubic(heights, inside[0], inside[1])
                          : terrain::SampleBilinear(heights, inside[0], inside[1]);
  if (beyond[0] == 0.0 && beyond[1] == 0.0)
  {
    return at;
  }
  if (!(std::max(std::abs(beyond[0]), std::abs(beyond[1])) <= edge))
  {
    return kNaN;
  }
  double rise = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    double inner[2] = { inside[0], inside[1] };
    const double step = std::min(1.0, size[axis]);
    inner[axis] -= std::copysign(step, beyond[axis]);
    const double before = terrain::SampleBilinear(heights, inner[0], inner[1]);
    rise += beyond[axis] != 0.0 && step > 0.0 && std::isfinite(before)
      ? (at - before) / step * std::abs(beyond[axis])
      : 0.0;
  }
  return at + rise;
}

/// Copies heights to scalars of type float or double from an index on.
void CopyHeights(const std::vector<double>& heights, vtkDataArray* scalars, vtkIdType first)
{
  if (scalars->GetDataType() == VTK_DOUBLE)
  {
    std::copy(heights.begin(), heights.end(), static_cast<double*>(scalars->GetVoidPointer(first)));
    return;
  }
  std::transform(heights.begin(), heights.end(),
    static_cast<float*>(scalars->GetVoidPointer(first)),
    [](double height) { return static_cast<float>(height); });
}
}

vtkStandardNewMacro(vtkTerrainReproject);

vtkTerrainReproject::vtkTerrainReproject()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetGeoreference(nullptr);
}

vtkTerrainReproject::~vtkTerrainReproject() = default;

void vtkTerrainReproject::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  if (!georeference || this->Internals->Georeference != georeference)
  {
    this->Internals->Georeference = georeference
      ? vtkSmartPointer<vtkTerrainGeoreference>(georeference)
      : vtkSmartPointer<vtkTerrainGeoreference>::New();
    this->Internals->OwnTime = 0;
    this->Modified();
  }
}

vtkTerrainGeoreference* vtkTerrainReproject::GetGeoreference() const
{
  return this->Internals->Georeference;
}

void vtkTerrainReproject::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

void vtkTerrainReproject::SetInterpolation(InterpolationType interpolation)
{
  terrain::Setting::Set(this, this->Interpolation, interpolation);
}

vtkMTimeType vtkTerrainReproject::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  const vtkMTimeType scene = this->Internals->Georeference->GetMTime();
  return scene == this->Internals->OwnTime ? time : std::max(time, scene);
}

int vtkTerrainReproject::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkTerrainReproject::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (int i = 0; i < this->GetNumberOfInputConnections(0); ++i)
  {
    vtkAlgorithmOutput* connection = this->GetInputConnection(0, i);
    connection->GetProducer()->Update(connection->GetIndex());
  }
  this->WarningMessage.clear();
  this->ErrorMessage = this->Plan(inputs[0]);
  vtkInformation* info = outputs->GetInformationObject(0);
  const vtkInternals& internals = *this->Internals;
  if (!this->ErrorMessage.empty())
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }
  this->CheckFlatness();
  if (!this->WarningMessage.empty())
  {
    vtkWarningMacro(<< this->WarningMessage);
  }
  const double spacing[3] = { internals.Spacing, internals.Spacing, 1.0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), internals.Extent, 6);
  info->Set(vtkDataObject::ORIGIN(), internals.Origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Remove(vtkDataObject::DIRECTION()); // rows run north, whichever way those of inputs do
  const bool isDouble = std::any_of(internals.Tiles.begin(), internals.Tiles.end(),
    [](const std::unique_ptr<Tile>& tile)
    { return tile->Image->GetPointData()->GetScalars()->GetDataType() == VTK_DOUBLE; });
  vtkDataObject::SetPointDataActiveScalarInfo(info, isDouble ? VTK_DOUBLE : VTK_FLOAT, 1);
  return 1;
}

int vtkTerrainReproject::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputs[0]->GetInformationObject(i);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
  return 1;
}

//------------------------------------------------------------------------------------------------
// The samples.

void vtkTerrainReproject::SampleTiles(const std::vector<double>& scene,
  const std::vector<double>& places, const double bounds[4], double* heights)
{
  const vtkIdType count = static_cast<vtkIdType>(scene.size() / 3);
  const bool onEarth = this->Internals->Georeference->IsOnEarth();
  std::fill_n(heights, count, kNaN);
  std::vector<double> file(scene.size());
  std::vector<double> found(static_cast<std::size_t>(count));
  for (const std::unique_ptr<Tile>& tile : this->Internals->Tiles)
  {
    if (bounds[0] > tile->Bounds[1] || bounds[1] < tile->Bounds[0] || bounds[2] > tile->Bounds[3] ||
      bounds[3] < tile->Bounds[2])
    {
      continue;
    }
    if (onEarth)
    {
      tile->Reference->PlacesToFile(places.data(), file.data(), count);
    }
    else
    {
      tile->Reference->SceneToFile(scene.data(), file.data(), count);
    }
    const bool cubic = this->Interpolation == InterpolationType::Cubic;
    terrain::ImageHeights::Dispatch(tile->Image,
      [&](const auto& view)
      {
        vtkSMPTools::For(0, count, kSamplesPerTask,
          [&](vtkIdType begin, vtkIdType end)
          {
            for (vtkIdType i = begin; i < end; ++i)
            {
              double x = 0.0;
              double y = 0.0;
              tile->ToGrid(file.data() + 3 * i, x, y);
              found[static_cast<std::size_t>(i)] = this->EdgeCells > 0.0 && tile->Turn == 0.0
                ? SampleBeyond(view, x, y, this->EdgeCells, cubic)
                : SampleTurned(view, x, y, tile->Turn, cubic);
            }
          });
      });
    tile->Reference->FileHeightsToPlaces(places.data(), found.data(), count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (std::isnan(heights[i]))
      {
        heights[i] = found[static_cast<std::size_t>(i)];
      }
    }
  }
}

void vtkTerrainReproject::PlaceBlock(const int extent[4], std::vector<double>& scene) const
{
  const vtkInternals& internals = *this->Internals;
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType count = width * (extent[3] - extent[2] + 1);
  const bool round = internals.Georeference->GetFrame() == Frame::Local;
  double origin[3];
  internals.Georeference->GetOrigin(origin);
  const double originHeight = internals.Georeference->GetSceneRise(origin[2]);
  scene.resize(static_cast<std::size_t>(3 * count));
  vtkSMPTools::For(0, count, kSamplesPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double* point = scene.data() + 3 * i;
        const vtkIdType row = i / width;
        point[0] =
          internals.Origin[0] + static_cast<double>(extent[0] + i % width) * internals.Spacing;
        point[1] = internals.Origin[1] + static_cast<double>(extent[2] + row) * internals.Spacing;
        const double squared = point[0] * point[0] + point[1] * point[1];
        point[2] = round ? -squared / (2.0 * kEarthRadius) - originHeight : 0.0;
      }
    });
}

std::vector<terrain::VerticalSearch> vtkTerrainReproject::vtkInternals::BeginSearches(
  const std::vector<double>& scene) const
{
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  for (const std::unique_ptr<Tile>& tile : this->Tiles)
  {
    lowest = std::min(lowest, tile->Heights[0] * tile->Reference->GetHeightUnit());
    highest = std::max(highest, tile->Heights[1] * tile->Reference->GetHeightUnit());
  }
  const double range = this->Georeference->GetSceneRise(highest);
  // Terrain that stands so high that its foot lies more than a cell off may be where its foot is
  // not: beyond the border, or in a hole.
  const double reach = std::max(
    std::hypot(scene[0], scene[1]), std::hypot(scene[scene.size() - 3], scene[scene.size() - 2]));
  const double sideways = std::abs(range) * reach / kEarthRadius;
  const int trials = lowest <= highest && sideways > this->Spacing ? kTrials : 0;
  std::vector<terrain::VerticalSearch> searches;
  searches.reserve(scene.size() / 3);
  for (std::size_t i = 2; i < scene.size(); i += 3)
  {
    searches.emplace_back(scene[i], range, trials);
  }
  return searches;
}

void vtkTerrainReproject::FillBlock(const int extent[4], double* heights, double* placeHeights)
{
  vtkTerrainGeoreference* reference = this->Internals->Georeference;
  const bool round = reference->GetFrame() == Frame::Local;
  std::vector<double> scene;
  this->PlaceBlock(extent, scene);
  const vtkIdType count = static_cast<vtkIdType>(scene.size() / 3);
  const double bounds[4] = { scene[0], scene[scene.size() - 3], scene[1], scene[scene.size() - 2] };
  std::vector<double> places(scene.size(), 0.0);
  std::vector<terrain::VerticalSearch> searches;
  if (round)
  {
    searches = this->Internals->BeginSearches(scene);
  }
  const double riseOfMetre = reference->GetSceneRise(1.0);
  bool isMoving = true;
  while (isMoving)
  {
    reference->SceneToPlaces(scene.data(), places.data(), count);
    this->SampleTiles(scene, places, bounds, heights);
    std::copy(heights, heights + count, placeHeights);
    if (!round)
    {
      break;
    }
    // Up the scene's vertical by what the place's own vertical lacks.
    std::atomic<bool> moved{ false };
    vtkSMPTools::For(0, count, kSamplesPerTask,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          terrain::VerticalSearch& search = searches[static_cast<std::size_t>(i)];
          if (search.Take(riseOfMetre * (heights[i] - places[3 * i + 2]), VerticalTolerance))
          {
            moved = true;
          }
          scene[3 * i + 2] = search.GetZ();
          heights[i] = search.IsFound() ? search.GetZ() : kNaN;
        }
      });
    isMoving = moved;
  }
  if (reference->GetFrame() == Frame::Plane)
  {
    double origin[3];
    reference->GetOrigin(origin);
    std::for_each(heights, heights + count, [&origin](double& z) { z -= origin[2]; });
  }
}

void vtkTerrainReproject::AddFieldData(vtkImageData* output) const
{
  const vtkInternals& internals = *this->Internals;
  const double width = internals.Extent[1] + 1;
  const double height = internals.Extent[3] + 1;
  const double s = internals.Spacing;
  const std::string wkt = internals.Georeference->GetSceneCoordinateSystem();
  if (!wkt.empty())
  {
    terrain::FieldData::AddText(output, "CRS", wkt);
  }
  terrain::FieldData::AddTuple(output, "GeoTransform",
    { internals.Origin[0] - 0.5 * s, s, 0.0, internals.Origin[1] + (height - 0.5) * s, 0.0, -s });
  terrain::FieldData::AddTuple(output, "RasterSize", { width, height });
  terrain::FieldData::AddTuple(output, "LayoutOrigin", { 0.0, 0.0 });
  terrain::FieldData::AddTuple(output, "LayoutScale", { 1.0, 1.0 });
  terrain::FieldData::AddText(output, "VerticalUnit", "metre");
  terrain::FieldData::AddTuple(output, "VerticalScale", { 1.0 });
}

int vtkTerrainReproject::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const vtkInternals& internals = *this->Internals;
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outputs);
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    return 0;
  }
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  output->SetExtent(extent);
  output->SetOrigin(internals.Origin);
  output->SetSpacing(internals.Spacing, internals.Spacing, 1.0);
  output->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  output->AllocateScalars(info);
  vtkDataArray* scalars = output->GetPointData()->GetScalars();
  const char* name = internals.Tiles.front()->Image->GetPointData()->GetScalars()->GetName();
  scalars->SetName(name ? name : "Elevation");
  const vtkIdType width = extent[1] - extent[0] + 1;
  const int rows =
    static_cast<int>(std::max<vtkIdType>(1, kBlockSamples / std::max(width, vtkIdType(1))));
  std::vector<double> heights;
  std::vector<double> placeHeights;
  vtkSmartPointer<vtkFloatArray> placeArray;
  if (internals.Georeference->GetFrame() == Frame::Local)
  {
    placeArray = vtkSmartPointer<vtkFloatArray>::New();
    placeArray->SetName("PlaceHeight");
    placeArray->SetNumberOfValues(output->GetNumberOfPoints());
    output->GetPointData()->AddArray(placeArray);
  }
  for (int row = extent[2]; row <= extent[3] && !this->GetAbortExecute(); row += rows)
  {
    const int block[4] = { extent[0], extent[1], row, std::min(row + rows - 1, extent[3]) };
    const vtkIdType count = width * (block[3] - block[2] + 1);
    heights.resize(static_cast<std::size_t>(count));
    placeHeights.resize(heights.size());
    this->FillBlock(block, heights.data(), placeHeights.data());
    CopyHeights(heights, scalars, width * (row - extent[2]));
    if (placeArray)
    {
      CopyHeights(placeHeights, placeArray, width * (row - extent[2]));
    }
    this->UpdateProgress(
      static_cast<double>(block[3] - extent[2] + 1) / (extent[3] - extent[2] + 1));
  }
  if (this->GetAbortExecute())
  {
    output->Initialize();
    return 1;
  }
  this->AddFieldData(output);
  return 1;
}

void vtkTerrainReproject::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "EdgeCells: " << this->EdgeCells << "\n";
  os << indent << "Interpolation: "
     << (this->Interpolation == InterpolationType::Cubic ? "cubic" : "bilinear") << "\n";
  os << indent << "MaximumNumberOfSamples: " << this->MaximumNumberOfSamples << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "WarningMessage: " << this->WarningMessage << "\n";
  os << indent << "Georeference:\n";
  this->Internals->Georeference->PrintSelf(os, indent.GetNextIndent());
}
