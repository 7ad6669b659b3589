// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDrape.h"

#include "core/rays/SurfacePath.h"
#include "data/GlobeData.h"
#include "data/GlobePaths.h"
#include "data/ImageHeights.h"
#include "data/PathBuilder.h"
#include "data/Setting.h"
#include "place/GroundPlaces.h"
#include "vtkTerrainGeoreference.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{
// Most points that Tolerance inserts between two grid lines.
constexpr double kMostPointsPerCell = 1000.0;

/// Settings of the filter that the points need.
struct Rule
{
  terrain::GridGeometry Geometry;
  vtkTerrainDrape::ModeType Mode = vtkTerrainDrape::ModeType::Clamped;
  double Offset = 0.0;
  double Tolerance = 0.0;

  /// Scene position over a ground height; along is the interpolated point of the input.
  glm::dvec3 Place(const glm::dvec3& along, double ground) const
  {
    double height = ground + this->Offset;
    if (this->Mode == vtkTerrainDrape::ModeType::AboveGround)
    {
      height += along.z;
    }
    if (this->Mode == vtkTerrainDrape::ModeType::Absolute)
    {
      height = along.z - this->Geometry.Origin.z + this->Offset;
    }
    return { along.x, along.y, this->Geometry.ToModel({ 0.0, 0.0 }, height).z };
  }
};

template <typename T>
void DrapeSegment(const terrain::HeightfieldView<T>& heights, const Rule& rule,
  terrain::PathBuilder& paths, const vtkIdType ids[2], vtkIdType source)
{
  const glm::dvec3 ends[2] = { paths.GetPoint(ids[0]), paths.GetPoint(ids[1]) };
  glm::dvec2 grid[2];
  for (int i = 0; i < 2; ++i)
  {
    grid[i] = glm::dvec2(rule.Geometry.ToGrid(ends[i]));
  }
  if (!std::isfinite(grid[0].x + grid[0].y + grid[1].x + grid[1].y))
  {
    paths.EndLine(source);
    return;
  }
  const auto add = [&](double t, double ground)
  {
    const glm::dvec3 along = (1.0 - t) * ends[0] + t * ends[1];
    paths.AddToLine(rule.Place(along, ground), ids[0], ids[1], t);
  };
  terrain::WalkSurface(heights, grid[0], grid[1],
    [&](const terrain::SurfacePiece& piece)
    {
      if (!piece.HasSurface)
      {
        paths.EndLine(source);
        return;
      }
      if (!paths.HasLine())
      {
        add(piece.Begin, piece.HeightAt(piece.Begin));
      }
      const double parts = std::clamp(
        std::ceil(std::sqrt(piece.ChordError() / rule.Tolerance)), 1.0, kMostPointsPerCell);
      for (double k = 1.0; k <= parts; k += 1.0)
      {
        const double t = piece.Begin + (piece.End - piece.Begin) * k / parts;
        add(t, piece.HeightAt(t));
      }
    });
}

template <typename T>
void DrapeLine(const terrain::HeightfieldView<T>& heights, const Rule& rule,
  terrain::PathBuilder& paths, const std::vector<vtkIdType>& ids, vtkIdType source)
{
  for (std::size_t k = 0; k + 1 < ids.size(); ++k)
  {
    if (rule.Mode == vtkTerrainDrape::ModeType::Absolute)
    {
      for (std::size_t end = paths.HasLine() ? 1 : 0; end < 2; ++end)
      {
        const vtkIdType id = ids[k + end];
        paths.AddToLine(rule.Place(paths.GetPoint(id), 0.0), id, id, 0.0);
      }
      continue;
    }
    DrapeSegment(heights, rule, paths, &ids[k], source);
  }
  paths.EndLine(source);
}

template <typename T>
void DrapeVertex(const terrain::HeightfieldView<T>& heights, const Rule& rule,
  terrain::PathBuilder& paths, vtkIdType id, vtkIdType source)
{
  const glm::dvec3 point = paths.GetPoint(id);
  const glm::dvec2 grid(rule.Geometry.ToGrid(point));
  if (!std::isfinite(grid.x + grid.y))
  {
    return;
  }
  terrain::SurfacePiece piece;
  terrain::WalkSurface(
    heights, grid, grid, [&piece](const terrain::SurfacePiece& only) { piece = only; });
  if (piece.HasSurface || rule.Mode == vtkTerrainDrape::ModeType::Absolute)
  {
    paths.AddVertex(rule.Place(point, piece.HeightAt(0.0)), id, source);
  }
}

/// The input with its points on the surface, each on the vertical of its place; z counts from the
/// surface, as drawn. Points above or below no surface stay where they are.
vtkSmartPointer<vtkPolyData> OnVerticals(
  vtkPolyData* input, vtkTerrainGeoreference* georeference, vtkImageData* heights)
{
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<double> scene(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, scene.data() + 3 * i);
  }
  std::vector<double> places(scene.size());
  georeference->SceneToPlaces(scene.data(), places.data(), count);
  std::vector<double> ground = places;
  terrain::LowerToGround(georeference, heights, ground);
  georeference->PlacesToScene(ground.data(), ground.data(), count);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* from =
      std::isnan(ground[static_cast<std::size_t>(3 * i)]) ? scene.data() : ground.data();
    points->SetPoint(i, from[3 * i], from[3 * i + 1],
      georeference->GetSceneRise(places[static_cast<std::size_t>(3 * i + 2)]));
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(input);
  output->SetPoints(points);
  return output;
}

/// Drapes all vertices, lines and polygons of the input.
void DrapeCells(vtkImageData* image, const Rule& rule, terrain::PathBuilder& paths)
{
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& heights)
    {
      paths.ForEachCell([&](vtkIdType id, vtkIdType cell)
        { DrapeVertex(heights, rule, paths, id, cell); },
        [&](const std::vector<vtkIdType>& ids, vtkIdType cell)
        { DrapeLine(heights, rule, paths, ids, cell); });
    });
  paths.Finish();
}
}

vtkStandardNewMacro(vtkTerrainDrape);

vtkTerrainDrape::vtkTerrainDrape()
{
  this->SetNumberOfInputPorts(2);
}

vtkTerrainDrape::~vtkTerrainDrape() = default;

void vtkTerrainDrape::SetHeightsData(vtkImageData* heights)
{
  this->SetInputDataInternal(1, heights);
}

void vtkTerrainDrape::SetHeightsConnection(vtkAlgorithmOutput* heights)
{
  this->SetInputConnection(1, heights);
}

void vtkTerrainDrape::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainDrape::GetGeoreference() const
{
  return this->Georeference;
}

vtkMTimeType vtkTerrainDrape::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

void vtkTerrainDrape::SetMode(ModeType mode)
{
  terrain::Setting::Set(this, this->Mode, mode);
}

int vtkTerrainDrape::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkTerrainDrape::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputs, outputs))
  {
    return 0;
  }
  // lines may cross the heights of other pieces
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* heights = inputs[1]->GetInformationObject(0);
  if (heights->Has(Pipeline::WHOLE_EXTENT()))
  {
    heights->Set(Pipeline::UPDATE_EXTENT(), heights->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

int vtkTerrainDrape::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkSmartPointer<vtkPolyData> input = vtkPolyData::GetData(inputs[0]);
  vtkImageData* image = vtkImageData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const std::string why = terrain::ImageHeights::WhyNotHeights(image);
  if (!why.empty())
  {
    vtkErrorMacro(<< why);
    return 0;
  }
  if (this->Georeference && this->Mode != ModeType::Absolute &&
    this->Georeference->GetFrame() == vtkTerrainGeoreference::FrameType::Local &&
    this->Georeference->IsOnEarth())
  {
    input = OnVerticals(input, this->Georeference, image);
  }
  const std::unique_ptr<terrain::GlobeGrid> globe = terrain::GlobeData::Get(image);
  Rule rule;
  rule.Geometry = terrain::ImageHeights::Geometry(image, this->Exaggeration);
  rule.Mode = this->Mode;
  rule.Offset = this->Offset;
  rule.Tolerance = this->Tolerance > 0.0
    ? this->Tolerance
    : 0.01 * std::min(rule.Geometry.Spacing.x, rule.Geometry.Spacing.y);
  if (globe)
  {
    const double cell = std::min(1.0, 0.01 * globe->Step * globe->Body.Equatorial);
    rule.Tolerance = this->Tolerance > 0.0 ? this->Tolerance : cell;
    input = terrain::GlobePaths::ToFlat(input, *globe, image, rule.Tolerance);
  }
  terrain::PathBuilder paths(input, output);
  DrapeCells(image, rule, paths);
  if (globe)
  {
    terrain::GlobePaths::FromFlat(output, *globe, image);
  }
  return 1;
}

void vtkTerrainDrape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << static_cast<int>(this->Mode) << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
}
