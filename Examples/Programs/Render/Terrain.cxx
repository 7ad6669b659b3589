// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain.h"

#include "BlockWalls.h"
#include "ColorSource.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "ShownHeights.h"
#include "Statistics.h"
#include "TextSize.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainStrips.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using Techniques = vtkTerrainActor::Techniques;

const char* const kNoSurface =
  "there is no surface to draw, for no four neighbouring samples all have heights";

/// Twice the most bytes of tiles on the graphics card.
constexpr vtkIdType kMostMemoryOfCard = vtkIdType{ 1 } << 30;

/// Samples a side of the image beside tiles.
constexpr int kBesideTiles = 4096;

vtkSmartPointer<vtkImageAlgorithm> MakeSource(const Options& options, bool drawsTiles)
{
  if (options.Heights.empty())
  {
    return vtkSmartPointer<vtkTerrainSource>::New();
  }
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(options.Heights);
  reader->UseLevelsOn();
  reader->SetMaximumSize(options.LargestTexture);
  options.Input.Apply(reader);
  reader->WarnOfSitesOff(); // all are drawn
  reader->UpdateInformation();
  if (drawsTiles && reader->GetLevel() > 0)
  {
    reader->SetMaximumSize(std::min(kBesideTiles, options.LargestTexture));
    reader->WarnOfLevelsOff();
  }
  reader->SetMemoryBudget(vtkIdType{ options.Memory } << 20);
  reader->SetUseCache(!options.NoCache);
  return reader;
}

/// Walls of a block along the edge of the data, or of all of it in layers; a warning, or a Failure,
/// where they would not meet the surface. Where colours show something else than heights, the sides
/// are plain.
void AddWalls(Terrain& terrain, const ReadHeightsResult& read, const Options& options)
{
  constexpr RGB kPlainSide = { 0.55, 0.50, 0.45 };
  if (options.Surface.Block <= 0.0)
  {
    return;
  }
  std::vector<Stratum> strata = options.Surface.GetStrata();
  if (strata.empty() && options.ColorBy.IsGiven())
  {
    strata = { { kPlainSide, 0.0 } };
  }
  const bool isFiner = read.Tiles || !options.Detail.File.empty();
  const std::string remedy = read.Tiles
    ? "make the raster smaller (gdal_translate -outsize 50% 50% -r average)"
    : "leave out --detail";
  if (!strata.empty() && isFiner)
  {
    throw Failure(options.Surface.Strata.empty() ? "--color-by" : "--strata",
      "the sides of a block would not meet the surface: " + remedy);
  }
  terrain.Walls = strata.empty() ? MakeWallActor(terrain.Actor, read.Image)
                                 : MakeLayerActor(terrain.Actor, read.Image, strata);
  if (terrain.Walls && isFiner)
  {
    terrain.Walls = nullptr;
    Warn("--block: there are no walls along the edge of the data: " + remedy);
  }
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

/// What strips are refined from: the file itself if it is prepared, else the heights, prepared.
vtkSmartPointer<vtkTerrainHierarchy> PrepareHierarchy(
  vtkImageData* heights, const Options& options, ProgressBar& progress)
{
  auto hierarchy = vtkSmartPointer<vtkTerrainHierarchy>::New();
  const auto show = [&progress](double done)
  {
    progress.Show(kReadShare + kPlaceShare + kMeshShare * done, "preparing");
    return true;
  };
  const bool done = DrawsFileAlone(options) ? hierarchy->OpenFile(options.Heights)
                                            : hierarchy->SetHeights(heights, show);
  if (!done)
  {
    throw Failure(HeightsName(options), hierarchy->GetErrorMessage());
  }
  return hierarchy;
}

/// Sets up the technique Strips. Edges and depths are drawn from the strips alone.
void PrepareStrips(vtkTerrainActor* actor, vtkImageData* heights, const Options& options,
  ProgressBar& progress, const PreparedDetail& detail)
{
  const bool alone = options.Depths || options.Wireframe || DrawsFileAlone(options);
  actor->SetInputData(alone ? nullptr : heights);
  actor->SetHierarchy(PrepareHierarchy(heights, options, progress));
  vtkTerrainStrips* strips = actor->GetStrips();
  detail.AddTo(strips);
  strips->SetTolerance(options.PixelTolerance.value_or(1.0));
  strips->SetDepthColors(options.Depths);
  if (options.Wireframe)
  {
    actor->GetProperty()->SetRepresentationToWireframe();
  }
}

/// Makes the coarse mesh or the full one, if the technique needs one.
void PrepareMesh(
  vtkTerrainActor* actor, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  if (vtkTerrainCoarseMesh* mesh = actor->GetUsedMesh())
  {
    mesh->SetCellsPerQuad(std::max(options.MeshCells, 1));
    progress.Watch(mesh, kMeshShare, "preparing");
    mesh->Update();
    statistics.SetCount("cells_per_quad", mesh->GetEffectiveCellsPerQuad());
    statistics.SetCount("mesh_vertices", mesh->GetOutput()->GetNumberOfPoints());
    statistics.SetCount("mesh_triangles", mesh->GetOutput()->GetNumberOfPolys());
  }
}

/// A prepared file as far as the scene needs to know it: its size and place, without samples.
vtkSmartPointer<vtkImageData> DescribePreparedFile(const Options& options)
{
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(options.Heights);
  reader->UpdateInformation();
  if (*reader->GetErrorMessage())
  {
    throw Failure(reader->GetErrorMessage());
  }
  vtkInformation* info = reader->GetOutputInformation(0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  image->SetSpacing(info->Get(vtkDataObject::SPACING()));
  return image;
}

void SetSearch(vtkOpenGLTerrainMapper* mapper, const Options& options)
{
  mapper->SetPixelTolerance(options.PixelTolerance.value_or(0.0));
  mapper->SetShowCrossings(options.Crossings);
  mapper->SetSteps(options.Steps.Steps);
  mapper->SetLongSteps(options.Steps.LongSteps);
  mapper->SetSecantSteps(options.Steps.SecantSteps);
  mapper->SetStepLength(options.Steps.StepLength);
}
}

//------------------------------------------------------------------------------
bool DrawsFileAlone(const Options& options)
{
  const PlaceOptions& place = options.Place;
  return options.Search == Techniques::Strips && !options.Heights.empty() &&
    vtkTerrainHierarchy::IsPreparedFile(options.Heights) && !place.FirstThatNeedsPlaces() &&
    !place.Frame && !options.ColorBy.IsGiven() && options.Marks.Peaks == 0 && place.Cell == 0.0 &&
    place.Vertical == vtkTerrainGeoreference::HeightType::AsIs;
}

//------------------------------------------------------------------------------
bool CanDrawTiles(const Options& options)
{
  return options.Search == Techniques::Pyramid && options.Detail.File.empty() &&
    !options.ColorBy.IsFile();
}

//------------------------------------------------------------------------------
ReadHeightsResult ReadHeights(
  const Options& options, bool drawsTiles, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  if (DrawsFileAlone(options))
  {
    const vtkSmartPointer<vtkImageData> described = DescribePreparedFile(options);
    statistics.SetText("heights", HeightsName(options));
    CountSamples(described, statistics);
    return { described, nullptr };
  }
  const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(options, drawsTiles);
  progress.Watch(source, kReadShare, "reading");
  source->Update();
  auto* reader = vtkTerrainRasterReader::SafeDownCast(source);
  if (reader && *reader->GetErrorMessage())
  {
    throw Failure(reader->GetErrorMessage());
  }
  ThrowOnError(HeightsName(options));
  statistics.AddTime("read", watch.GetMilliseconds());

  vtkImageData* heights = source->GetOutput();
  statistics.SetText("heights", HeightsName(options));
  CountSamples(heights, statistics);
  if (reader)
  {
    statistics.SetCount("level", reader->GetLevel());
  }
  DescribeHeights(heights, statistics);
  return { heights, drawsTiles && reader ? reader->GetTileSource() : nullptr,
    reader ? reader->GetNumberOfSites() : 1, reader ? reader->GetSite() : 1 };
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
    heights->GetPointData()->GetScalars()
      ? static_cast<std::int64_t>(heights->GetScalarSize()) * heights->GetNumberOfPoints()
      : 0);
}

//------------------------------------------------------------------------------
Terrain PrepareTerrain(const ReadHeightsResult& read, double exaggeration,
  const ColorSource& colors, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  vtkImageData* heights = read.Image;
  const std::string name = HeightsName(options);
  auto actor = vtkSmartPointer<vtkTerrainActor>::New();
  const PreparedDetail detail = PrepareDetail(read.Image, options.Detail, statistics);
  actor->SetInputData(heights);
  actor->GetTerrainMapper()->SetTileSource(read.Tiles);
  // of --memory a quarter for tiles on the host; a software driver's card is the host, too
  const vtkIdType memory = vtkIdType{ options.Memory } << 20;
  actor->GetTerrainMapper()->SetHostMemoryBudget(memory / 4);
  actor->GetTerrainMapper()->SetCardMemoryBudget(std::min(memory, kMostMemoryOfCard) / 2);
  actor->SetTechnique(options.Search);
  actor->SetVerticalExaggeration(exaggeration);
  ColorByPlaceHeight(actor, heights);
  detail.AddTo(actor->GetTerrainMapper());
  if (options.Search == Techniques::Strips)
  {
    PrepareStrips(actor, heights, options, progress, detail);
  }
  else
  {
    SetSearch(actor->GetTerrainMapper(), options);
    PrepareMesh(actor, options, progress, statistics);
  }
  ThrowOnError(name);
  if (!actor->HasSurface())
  {
    throw Failure(name, kNoSurface);
  }
  Terrain terrain;
  terrain.Actor = actor;
  std::array<double, 2> range{}; // of z, which in a round scene is not the height
  actor->GetHeightRange(range.data());
  options.Surface.Apply(actor, range[0], LinePixels(1.0, options));
  terrain.Bounds.SetBounds(actor->GetBounds());
  terrain.Framed = terrain.Bounds;
  ThrowOnError(name);
  terrain.Key.Table = actor->GetLookupTable();
  if (!options.Depths)
  {
    terrain.Key = ColorTerrain(actor, heights, colors, options);
  }
  options.Light.Apply(actor);
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  property->SetLighting(!options.Crossings && !options.Surface.Hillshade);
  AddWalls(terrain, read, options);
  statistics.AddTime("prepare", watch.GetMilliseconds());
  statistics.SetText("technique", NameOf(options.Search));
  return terrain;
}

//------------------------------------------------------------------------------
void RefineTerrain(
  const Terrain& terrain, vtkRenderer* renderer, const Options& options, Statistics& statistics)
{
  if (options.Search != Techniques::Strips)
  {
    return;
  }
  const Stopwatch watch;
  terrain.Actor->RefineStrips(renderer);
  ThrowOnError(HeightsName(options));
  vtkTerrainStrips* strips = terrain.Actor->GetStrips();
  statistics.AddTime("refine", watch.GetMilliseconds());
  statistics.SetCount("mesh_vertices", strips->GetOutput()->GetNumberOfPoints());
  statistics.SetCount("mesh_triangles", strips->GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
void DescribeTerrain(
  const Terrain& terrain, vtkImageData* heights, bool isGlobe, Statistics& statistics)
{
  std::array<double, 6> bounds{};
  terrain.Bounds.GetBounds(bounds.data());
  statistics.SetNumbers("bounds", { bounds.begin(), bounds.end() });
  const double* spacing = heights->GetSpacing();
  statistics.SetNumbers("cell", { spacing[0], spacing[1] });
  statistics.SetText("cell_unit", isGlobe ? "degree" : "metre");
  const double base = heights->GetOrigin()[2];
  const std::array<double, 2> range = HeightRange(terrain.Actor, heights);
  statistics.SetNumbers("height_range",
    { std::min(base + range[0], terrain.OtherHeights[0]),
      std::max(base + range[1], terrain.OtherHeights[1]) });
  statistics.SetCount("texture_bytes", terrain.Actor->GetTerrainMapper()->GetTextureMemorySize());
  statistics.SetCount("tiles", terrain.Actor->GetTerrainMapper()->GetNumberOfTiles());
}

//------------------------------------------------------------------------------
void CountCrossings(const Terrain& terrain, vtkRenderWindow* window, Statistics& statistics)
{
  vtkOpenGLTerrainMapper* mapper = terrain.Actor->GetTerrainMapper();
  if (mapper->GetTechnique() == Techniques::Mesh || mapper->GetTechnique() == Techniques::Strips)
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
