// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDrape.h"

#include "core/rays/SurfacePath.h"
#include "data/GlobeData.h"
#include "data/GlobePaths.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "place/GroundPlaces.h"
#include "vtkTerrainGeoreference.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
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

/// The output while it grows.
struct Draped
{
  vtkPolyData* Input = nullptr;
  vtkPolyData* Output = nullptr;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;
  /// Cells of the input that the output's vertices and lines come from.
  std::vector<vtkIdType> VertexSources;
  std::vector<vtkIdType> LineSources;
  /// Points of the line that is being drawn.
  std::vector<vtkIdType> Line;

  vtkIdType AddPoint(const glm::dvec3& position, vtkIdType from, vtkIdType to, double t)
  {
    const vtkIdType id = this->Points->InsertNextPoint(position.x, position.y, position.z);
    this->Output->GetPointData()->InterpolateEdge(this->Input->GetPointData(), id, from, to, t);
    return id;
  }

  void EndLine(vtkIdType source)
  {
    if (this->Line.size() > 1)
    {
      this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Line.size()), this->Line.data());
      this->LineSources.push_back(source);
    }
    this->Line.clear();
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetVerts(this->Vertices);
    this->Output->SetLines(this->Lines);
    vtkCellData* to = this->Output->GetCellData();
    vtkCellData* from = this->Input->GetCellData();
    to->CopyAllocate(from);
    std::vector<vtkIdType> sources = this->VertexSources;
    sources.insert(sources.end(), this->LineSources.begin(), this->LineSources.end());
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      to->CopyData(from, sources[i], static_cast<vtkIdType>(i));
    }
  }
};

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
void DrapeSegment(const terrain::HeightfieldView<T>& heights, const Rule& rule, Draped& draped,
  const vtkIdType ids[2], vtkIdType source)
{
  glm::dvec3 ends[2];
  glm::dvec2 grid[2];
  for (int i = 0; i < 2; ++i)
  {
    double* end = &ends[i].x;
    draped.Input->GetPoint(ids[i], end);
    grid[i] = glm::dvec2(rule.Geometry.ToGrid(ends[i]));
  }
  if (!std::isfinite(grid[0].x + grid[0].y + grid[1].x + grid[1].y))
  {
    draped.EndLine(source);
    return;
  }
  const auto add = [&](double t, double ground)
  {
    const glm::dvec3 along = (1.0 - t) * ends[0] + t * ends[1];
    draped.Line.push_back(draped.AddPoint(rule.Place(along, ground), ids[0], ids[1], t));
  };
  terrain::WalkSurface(heights, grid[0], grid[1],
    [&](const terrain::SurfacePiece& piece)
    {
      if (!piece.HasSurface)
      {
        draped.EndLine(source);
        return;
      }
      if (draped.Line.empty())
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
void DrapeLine(const terrain::HeightfieldView<T>& heights, const Rule& rule, Draped& draped,
  const std::vector<vtkIdType>& ids, vtkIdType source)
{
  for (std::size_t k = 0; k + 1 < ids.size(); ++k)
  {
    if (rule.Mode == vtkTerrainDrape::ModeType::Absolute)
    {
      for (std::size_t end = draped.Line.empty() ? 0 : 1; end < 2; ++end)
      {
        const vtkIdType id = ids[k + end];
        glm::dvec3 point;
        draped.Input->GetPoint(id, &point.x);
        draped.Line.push_back(draped.AddPoint(rule.Place(point, 0.0), id, id, 0.0));
      }
      continue;
    }
    DrapeSegment(heights, rule, draped, &ids[k], source);
  }
  draped.EndLine(source);
}

template <typename T>
void DrapeVertex(const terrain::HeightfieldView<T>& heights, const Rule& rule, Draped& draped,
  vtkIdType id, vtkIdType source)
{
  glm::dvec3 point;
  draped.Input->GetPoint(id, &point.x);
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
    const vtkIdType made = draped.AddPoint(rule.Place(point, piece.HeightAt(0.0)), id, id, 0.0);
    draped.Vertices->InsertNextCell(1, &made);
    draped.VertexSources.push_back(source);
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

/// Point ids of a cell; polygons close.
std::vector<vtkIdType> IdsOf(vtkCellArray* cells, vtkIdType cell, bool closed)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  cells->GetCellAtId(cell, count, ids);
  std::vector<vtkIdType> result(ids, ids + count);
  if (closed && !result.empty())
  {
    result.push_back(result.front());
  }
  return result;
}

/// Drapes all vertices, lines and polygons of the input.
void DrapeCells(vtkImageData* image, const Rule& rule, Draped& draped)
{
  vtkPolyData* input = draped.Input;
  vtkCellArray* const kinds[3] = { input->GetVerts(), input->GetLines(), input->GetPolys() };
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& heights)
    {
      vtkIdType source = 0;
      for (int kind = 0; kind < 3; ++kind)
      {
        for (vtkIdType cell = 0; cell < kinds[kind]->GetNumberOfCells(); ++cell, ++source)
        {
          const std::vector<vtkIdType> ids = IdsOf(kinds[kind], cell, kind == 2);
          if (kind > 0)
          {
            DrapeLine(heights, rule, draped, ids, source);
            continue;
          }
          for (vtkIdType id : ids)
          {
            DrapeVertex(heights, rule, draped, id, source);
          }
        }
      }
    });
  draped.Finish();
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
  Draped draped;
  draped.Input = input;
  draped.Output = output;
  draped.Points->SetDataTypeToDouble();
  output->GetPointData()->InterpolateAllocate(input->GetPointData());
  DrapeCells(image, rule, draped);
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
