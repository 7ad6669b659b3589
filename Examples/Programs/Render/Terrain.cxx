// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Progress.h"
#include "Statistics.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkElevationFilter.h"
#include "vtkFieldData.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

/// Samples a side that every graphics driver takes; larger rasters are drawn at a level.
constexpr int kLargestTexture = 16384;

/// Shares of the progress bar.
constexpr double kReadShare = 0.5;
constexpr double kMeshShare = 0.3;

const char* const kNoSurface =
  "there is no surface to draw, for no four neighbouring samples all have heights";

vtkSmartPointer<vtkImageAlgorithm> MakeSource(const Options& options)
{
  if (options.Heights.empty())
  {
    return vtkSmartPointer<vtkTerrainSource>::New();
  }
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(options.Heights);
  reader->UseLevelsOn();
  reader->SetMaximumSize(kLargestTexture);
  reader->SetMemoryBudget(vtkIdType{ options.Memory } << 20);
  reader->SetUseCache(!options.NoCache);
  options.Input.Apply(reader);
  return reader;
}

Techniques MapperTechnique(Technique technique)
{
  switch (technique)
  {
    case Technique::Mesh:
      return Techniques::Mesh;
    case Technique::Linear:
      return Techniques::Linear;
    case Technique::Exponential:
      return Techniques::Exponential;
    case Technique::Equidistant:
      return Techniques::Equidistant;
    default:
      return Techniques::Pyramid;
  }
}

void ColorByHeight(vtkMapper* mapper, double lowest, double highest)
{
  mapper->SetLookupTable(vtkTerrainActor::MakeReliefColors(lowest, highest));
  mapper->SetScalarRange(lowest, highest);
  mapper->ScalarVisibilityOn();
}

/// In a round scene z is not the height: colours come from the array of heights that
/// vtkTerrainReproject adds there.
void ColorByPlaceHeight(vtkTerrainActor* actor, vtkImageData* heights)
{
  static const char* const kArray = "PlaceHeight";
  vtkDataArray* array = heights->GetPointData()->GetArray(kArray);
  if (!array)
  {
    return;
  }
  std::array<double, 2> range{};
  array->GetFiniteRange(range.data());
  actor->SetLookupTable(vtkTerrainActor::MakeReliefColors(range[0], range[1]));
  actor->GetTerrainMapper()->SetScalarModeToUsePointFieldData();
  actor->GetTerrainMapper()->SelectColorArray(kArray);
}

std::vector<std::string> TextsOf(vtkImageData* heights, const char* name)
{
  std::vector<std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(heights->GetFieldData()->GetAbstractArray(name));
  for (vtkIdType k = 0; array && k < array->GetNumberOfValues(); ++k)
  {
    texts.push_back(array->GetValue(k));
  }
  return texts;
}

/// What was read: unit, holes, what was taken from where.
void DescribeHeights(vtkImageData* heights, Statistics& statistics)
{
  const std::vector<std::string> unit = TextsOf(heights, "VerticalUnit");
  statistics.SetText("height_unit", unit.empty() ? "" : unit.front());
  statistics.SetTexts("record", TextsOf(heights, "Record"));
  statistics.SetTexts("warnings", TextsOf(heights, "Warnings"));
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  std::int64_t without = 0;
  for (vtkIdType k = 0; k < heights->GetNumberOfPoints(); ++k)
  {
    const bool hidden = ghosts && (ghosts->GetValue(k) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    without += hidden || !std::isfinite(scalars->GetComponent(k, 0)) ? 1 : 0;
  }
  statistics.SetCount("samples_without_data", without);
}

/// For the techniques of vtkOpenGLTerrainMapper: rays, or the full mesh.
Terrain PrepareRays(
  vtkImageData* heights, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  auto actor = vtkSmartPointer<vtkTerrainActor>::New();
  actor->SetInputData(heights);
  actor->SetTechnique(MapperTechnique(options.Search));
  actor->SetVerticalExaggeration(options.Exaggeration);
  actor->GetTerrainMapper()->SetPixelTolerance(options.PixelTolerance.value_or(0.0));
  actor->GetTerrainMapper()->SetShowCrossings(options.Crossings);
  actor->GetTerrainMapper()->SetSteps(options.Steps.Steps);
  actor->GetTerrainMapper()->SetLongSteps(options.Steps.LongSteps);
  actor->GetTerrainMapper()->SetSecantSteps(options.Steps.SecantSteps);
  actor->GetTerrainMapper()->SetStepLength(options.Steps.StepLength);
  ColorByPlaceHeight(actor, heights);
  PrepareDetail(heights, options.Detail, statistics).AddTo(actor->GetTerrainMapper());
  Terrain terrain;
  terrain.Actor = actor;
  if (vtkTerrainCoarseMesh* mesh = actor->GetUsedMesh())
  {
    mesh->SetSamplesPerQuad(std::max(options.MeshCells, 1));
    progress.Watch(mesh, kMeshShare, "preparing");
    mesh->Update();
    statistics.SetCount("samples_per_quad", mesh->GetEffectiveSamplesPerQuad());
    statistics.SetCount("mesh_vertices", mesh->GetOutput()->GetNumberOfPoints());
    statistics.SetCount("mesh_triangles", mesh->GetOutput()->GetNumberOfPolys());
  }
  ThrowOnError(HeightsName(options));
  if (!actor->HasSurface())
  {
    throw Failure(HeightsName(options), kNoSurface);
  }
  terrain.Bounds.SetBounds(actor->GetBounds());
  ThrowOnError(HeightsName(options));
  return terrain;
}

/// Draws strips between two heights, `low` as drawn: coloured by height, or by depth.
vtkSmartPointer<vtkActor> MakeStripsActor(
  vtkTerrainStrips* strips, double lowest, double highest, double low, const Options& options)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  const vtkNew<vtkPolyDataMapper> mapper;
  actor->SetMapper(mapper);
  if (options.Wireframe)
  {
    actor->GetProperty()->SetRepresentationToWireframe();
  }
  if (options.Levels)
  {
    mapper->SetInputConnection(strips->GetOutputPort());
    return actor;
  }
  const vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(strips->GetOutputPort());
  const double thickness = highest > lowest ? highest - lowest : 1.0;
  elevation->SetLowPoint(0.0, 0.0, low);
  elevation->SetHighPoint(0.0, 0.0, low + options.Exaggeration * thickness);
  elevation->SetScalarRange(lowest, lowest + thickness);
  mapper->SetInputConnection(elevation->GetOutputPort());
  mapper->InterpolateScalarsBeforeMappingOn();
  ColorByHeight(mapper, lowest, highest);
  return actor;
}

/// For the technique Strips: a hierarchy that is refined for the camera later.
Terrain PrepareStrips(
  vtkImageData* heights, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const vtkNew<vtkTerrainHierarchy> hierarchy;
  const auto show = [&progress](double done)
  {
    progress.Show(kReadShare + kPlaceShare + kMeshShare * done, "preparing");
    return true;
  };
  if (!hierarchy->SetHeights(heights, show))
  {
    throw Failure(HeightsName(options), hierarchy->GetErrorMessage());
  }
  std::array<double, 6> bounds{};
  hierarchy->GetBounds(bounds.data());
  if (bounds[0] > bounds[1])
  {
    throw Failure(HeightsName(options), kNoSurface);
  }
  const double base = heights->GetOrigin()[2];
  const PreparedDetail detail = PrepareDetail(heights, options.Detail, statistics);
  const std::array<double, 2> range = detail.Range();
  const double lowest = bounds[4] - base + range[0];
  const double highest = bounds[5] - base + range[1];
  bounds[4] = base + options.Exaggeration * lowest;
  bounds[5] = base + options.Exaggeration * highest;

  Terrain terrain;
  terrain.Bounds.SetBounds(bounds.data());
  terrain.Strips = vtkSmartPointer<vtkTerrainStrips>::New();
  terrain.Strips->SetHierarchy(hierarchy);
  detail.AddTo(terrain.Strips.Get());
  terrain.Strips->SetExaggeration(options.Exaggeration);
  terrain.Strips->SetTolerance(options.PixelTolerance.value_or(1.0));
  terrain.Strips->NormalsOn();
  terrain.Strips->SetLevelColors(options.Levels);
  terrain.Actor = MakeStripsActor(terrain.Strips, lowest, highest, bounds[4], options);
  return terrain;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadHeights(
  const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(options);
  progress.Watch(source, kReadShare, "reading");
  source->Update();
  auto* reader = vtkTerrainRasterReader::SafeDownCast(source);
  if (reader && *reader->GetErrorMessage())
  {
    throw Failure(reader->GetErrorMessage());
  }
  ThrowOnError(HeightsName(options));
  statistics.AddTime("read", watch.GetMilliseconds());

  vtkSmartPointer<vtkImageData> heights = source->GetOutput();
  statistics.SetText("heights", HeightsName(options));
  CountSamples(heights, statistics);
  if (reader)
  {
    statistics.SetCount("level", reader->GetLevel());
  }
  DescribeHeights(heights, statistics);
  return heights;
}

//------------------------------------------------------------------------------
void DescribeFile(const Options& options)
{
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(options.Heights);
  options.Input.Apply(reader);
  const std::string text = reader->Describe();
  const std::string error = "error: ";
  if (text.compare(0, error.size(), error) == 0)
  {
    throw Failure(options.Heights, text.substr(error.size(), text.find('\n') - error.size()));
  }
  std::cout << "file: " << options.Heights << '\n' << text;
}

//------------------------------------------------------------------------------
void CountSamples(vtkImageData* heights, Statistics& statistics)
{
  const int* dimensions = heights->GetDimensions();
  statistics.SetCount("columns", dimensions[0]);
  statistics.SetCount("rows", dimensions[1]);
  statistics.SetCount("samples", heights->GetNumberOfPoints());
  statistics.SetCount("bytes_of_heights",
    static_cast<std::int64_t>(heights->GetScalarSize()) * heights->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
Terrain PrepareTerrain(
  vtkImageData* heights, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  Terrain terrain = options.Search == Technique::Strips
    ? PrepareStrips(heights, options, progress, statistics)
    : PrepareRays(heights, options, progress, statistics);
  vtkProperty* property = terrain.Actor->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  property->SetLighting(!options.Crossings);
  statistics.AddTime("prepare", watch.GetMilliseconds());
  statistics.SetText("technique", NameOf(options.Search));
  return terrain;
}

//------------------------------------------------------------------------------
void RefineTerrain(
  const Terrain& terrain, vtkRenderer* renderer, const Options& options, Statistics& statistics)
{
  if (!terrain.Strips)
  {
    return;
  }
  const Stopwatch watch;
  terrain.Strips->SetCamera(renderer->GetActiveCamera());
  terrain.Strips->SetViewportSize(options.Size[0], options.Size[1]);
  terrain.Strips->Update();
  ThrowOnError(HeightsName(options));
  statistics.AddTime("refine", watch.GetMilliseconds());
  statistics.SetCount("mesh_vertices", terrain.Strips->GetOutput()->GetNumberOfPoints());
  statistics.SetCount("mesh_triangles", terrain.Strips->GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
void DescribeTerrain(
  const Terrain& terrain, vtkImageData* heights, const Options& options, Statistics& statistics)
{
  std::array<double, 6> bounds{};
  terrain.Bounds.GetBounds(bounds.data());
  statistics.SetNumbers("bounds", { bounds.begin(), bounds.end() });
  const double* spacing = heights->GetSpacing();
  statistics.SetNumbers("cell", { spacing[0], spacing[1] });
  // In a round scene z is not the height.
  vtkDataArray* array = heights->GetPointData()->GetArray("PlaceHeight");
  const double base = heights->GetOrigin()[2];
  std::array<double, 2> range{ { base + (bounds[4] - base) / options.Exaggeration,
    base + (bounds[5] - base) / options.Exaggeration } };
  if (array)
  {
    array->GetFiniteRange(range.data());
  }
  statistics.SetNumbers("height_range", { range.begin(), range.end() });
  if (auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(terrain.Actor->GetMapper()))
  {
    statistics.SetCount("texture_bytes", mapper->GetTextureMemorySize());
  }
}

//------------------------------------------------------------------------------
void CountCrossings(const Terrain& terrain, vtkRenderWindow* window, Statistics& statistics)
{
  auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(terrain.Actor->GetMapper());
  if (!mapper || mapper->GetTechnique() == Techniques::Mesh)
  {
    return;
  }
  mapper->SetComputeMode(vtkOpenGLTerrainMapper::ComputeModes::On);
  window->Render();
  const vtkSmartPointer<vtkImageData> crossings = mapper->ReadCrossings();
  if (!crossings)
  {
    return;
  }
  std::vector<std::int64_t> histogram;
  const auto* values = static_cast<int*>(crossings->GetScalarPointer());
  for (vtkIdType i = 0; i < crossings->GetNumberOfPoints(); ++i)
  {
    const auto value = static_cast<std::size_t>(values[i]);
    histogram.resize(std::max(histogram.size(), value + 1));
    ++histogram[value];
  }
  statistics.SetList("crossings", histogram);
}
