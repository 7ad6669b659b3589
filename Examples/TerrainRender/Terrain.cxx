// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Statistics.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"

#include <array>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

/// Shares of the progress bar.
constexpr double kReadShare = 0.7;
constexpr double kMeshShare = 0.3;

/// What messages about the heights begin with.
std::string HeightsName(const Options& options)
{
  return options.Heights.empty() ? "built-in landscape" : options.Heights;
}

vtkSmartPointer<vtkImageAlgorithm> MakeSource(const Options& options)
{
  if (options.Heights.empty())
  {
    return vtkSmartPointer<vtkTerrainSource>::New();
  }
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(options.Heights);
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
    case Technique::Pyramid:
      return Techniques::Pyramid;
  }
  return Techniques::Pyramid;
}

/// One colour of a scale: position in [0, 1] from the lowest to the highest, and red, green, blue.
struct Tint
{
  double Position;
  std::array<double, 3> Color;
};

template <std::size_t N>
void AddTints(
  vtkColorTransferFunction* colors, const std::array<Tint, N>& tints, double lowest, double highest)
{
  for (const Tint& tint : tints)
  {
    colors->AddRGBPoint(
      lowest + tint.Position * (highest - lowest), tint.Color[0], tint.Color[1], tint.Color[2]);
  }
}

/// Colours of a relief map from the lowest to the highest point; blue below 0 where a good part of
/// the heights lies there.
vtkSmartPointer<vtkColorTransferFunction> ReliefColors(double lowest, double highest)
{
  constexpr std::array<Tint, 6> kLand = { { { 0.0, { 0.46, 0.58, 0.38 } },
    { 0.2, { 0.62, 0.67, 0.43 } }, { 0.45, { 0.80, 0.73, 0.52 } }, { 0.7, { 0.66, 0.53, 0.42 } },
    { 0.88, { 0.71, 0.68, 0.66 } }, { 1.0, { 0.97, 0.97, 0.98 } } } };
  constexpr std::array<Tint, 3> kSea = { { { 0.0, { 0.07, 0.19, 0.36 } },
    { 0.7, { 0.25, 0.48, 0.66 } }, { 0.999, { 0.60, 0.77, 0.83 } } } };
  constexpr double kLeastSea = 0.1;

  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  const bool sea = lowest < -kLeastSea * (highest - lowest) && highest > 0.0;
  if (sea)
  {
    AddTints(colors, kSea, lowest, 0.0);
  }
  if (highest > lowest)
  {
    AddTints(colors, kLand, sea ? 0.0 : lowest, highest);
  }
  else
  {
    const auto& color = kLand[1].Color;
    colors->AddRGBPoint(lowest, color[0], color[1], color[2]);
  }
  return colors;
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
  const int* dimensions = heights->GetDimensions();
  statistics.SetText("heights", HeightsName(options));
  statistics.SetCount("columns", dimensions[0]);
  statistics.SetCount("rows", dimensions[1]);
  statistics.SetCount("samples", heights->GetNumberOfPoints());
  statistics.SetCount("bytes_of_heights",
    static_cast<std::int64_t>(heights->GetScalarSize()) * heights->GetNumberOfPoints());
  return heights;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> PrepareTerrain(
  vtkImageData* heights, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  const vtkNew<vtkTerrainCoarseMesh> mesh;
  mesh->SetInputData(heights);
  mesh->SetSamplesPerQuad(options.MeshCells);
  if (options.Search == Technique::Mesh)
  {
    mesh->SetSamplesPerQuad(1);
    mesh->PushUpOff();
  }
  progress.Watch(mesh, kMeshShare, "preparing");
  mesh->Update();
  ThrowOnError(HeightsName(options));
  vtkPolyData* polygons = mesh->GetOutput();
  if (polygons->GetNumberOfCells() == 0)
  {
    throw Failure(HeightsName(options),
      "there is no surface to draw, for no four neighbouring samples all have heights");
  }

  const vtkNew<vtkOpenGLTerrainMapper> mapper;
  mapper->SetInputConnection(0, mesh->GetOutputPort());
  mapper->SetHeightsData(heights);
  mapper->SetTechnique(MapperTechnique(options.Search));
  mapper->SetVerticalExaggeration(options.Exaggeration);
  const double* range = mesh->GetHeightRange();
  mapper->SetLookupTable(ReliefColors(range[0], range[1]));
  mapper->SetScalarRange(range[0], range[1]);
  mapper->ScalarVisibilityOn();
  ThrowOnError(HeightsName(options));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);

  statistics.AddTime("prepare", watch.GetMilliseconds());
  statistics.SetText("technique", NameOf(options.Search));
  statistics.SetCount("samples_per_quad", mesh->GetEffectiveSamplesPerQuad());
  statistics.SetCount("mesh_vertices", polygons->GetNumberOfPoints());
  statistics.SetCount("mesh_triangles", polygons->GetNumberOfPolys());
  return actor;
}

//------------------------------------------------------------------------------
void DescribeTerrain(vtkActor* terrain, Statistics& statistics)
{
  auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(terrain->GetMapper());
  statistics.SetCount("texture_bytes", mapper->GetTextureMemorySize());
}
