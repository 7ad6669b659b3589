// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures view-dependent refinement: BenchmarkRefinement [SIZE | SIZE:FILE | FOLDER | FILE]...
//
// SIZE is the side of a procedural landscape, which is prepared in memory, or into FILE; of a
// FOLDER every raster that vtkTerrainRasterReader reads is; FILE is a prepared file, over which 200
// frames are flown and the resident memory is watched. Without arguments: 1025, 4097. Prints rows
// of a table. Rates are millions of triangles in a second of processor time of one thread, median
// and best of kRepeats; both procedures take turns, and their ratio is the median of those of each
// turn.
#include "core/landscape/ProceduralTerrain.h"
#include "core/strips/HierarchyFile.h"
#include "core/strips/Refinement.h"
#include "data/HierarchyData.h"
#include "data/SMPParallelFor.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{
using terrain::RefinementMethod;

constexpr int kRepeats = 15;
constexpr int kFrames = 200;
constexpr double kPixelsPerUnit = 720.0 / (2.0 * 0.2679491924311227);

double ThreadSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1.0e-9 * static_cast<double>(time.tv_nsec);
}

/// Resident memory of this process, in MiB.
double ResidentMemory()
{
  std::ifstream file("/proc/self/statm");
  long total = 0;
  long resident = 0;
  file >> total >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Counts
{
  std::int64_t Triangles = 0;
  std::size_t Indices = 0;

  double IndicesEach() const
  {
    return static_cast<double>(this->Indices) /
      static_cast<double>(std::max<std::int64_t>(1, this->Triangles));
  }
};

using RefineFunction = std::function<Counts(RefinementMethod)>;

/// Prints one row: how fast `refine` is by both procedures.
void Measure(const std::string& terrain, const char* setting, const RefineFunction& refine)
{
  constexpr std::array<RefinementMethod, 2> methods{ { RefinementMethod::Improved,
    RefinementMethod::Plain } };
  std::array<std::vector<double>, 2> rates;
  std::array<Counts, 2> counts;
  std::vector<double> ratios;
  for (int turn = -1; turn < kRepeats; ++turn)
  {
    std::array<double, 2> rate{};
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      const double begin = ThreadSeconds();
      counts[i] = refine(methods[i]);
      rate[i] = 1.0e-6 * static_cast<double>(counts[i].Triangles) / (ThreadSeconds() - begin);
    }
    // The first turn makes memory.
    if (turn >= 0)
    {
      rates[0].push_back(rate[0]);
      rates[1].push_back(rate[1]);
      ratios.push_back(rate[0] / rate[1]);
    }
  }
  const auto best = [&](int i) { return *std::max_element(rates[i].begin(), rates[i].end()); };
  std::printf("| %s | %s | %lld | %.3f | %.3f | %.1f (%.1f) | %.1f (%.1f) | %.2f |\n",
    terrain.c_str(), setting, static_cast<long long>(counts[0].Triangles), counts[0].IndicesEach(),
    counts[1].IndicesEach(), Median(rates[0]), best(0), Median(rates[1]), best(1), Median(ratios));
  std::fflush(stdout);
}

void PrintHeader()
{
  std::printf("| terrain | setting | triangles | indices each | plain | Mtri/s (best) "
              "| plain | improved / plain |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
}

/// A view over the terrain's south-western quarter to the north-east; 60 degrees wide.
terrain::RefinementView MakeView(const terrain::HierarchyView& hierarchy, double part)
{
  const terrain::HierarchyLayout& layout = *hierarchy.Layout;
  const glm::dvec2 size =
    glm::dvec2(layout.Width() - 1, layout.Height() - 1) * hierarchy.Geometry.Spacing;
  const double relief = hierarchy.Summary.MaximumHeight - hierarchy.Summary.MinimumHeight;
  terrain::RefinementView view;
  view.Eye = hierarchy.Geometry.Origin +
    glm::dvec3((0.25 + 0.5 * part) * size.x, (0.25 + 0.5 * part) * size.y,
      hierarchy.Summary.MinimumHeight + 0.8 * relief);
  view.PixelsPerUnit = kPixelsPerUnit;
  for (const double angle : { 0.2617993877991494, 1.3089969389957472 })
  {
    const double sign = angle < 0.7 ? 1.0 : -1.0;
    const glm::dvec3 normal(-sign * std::sin(angle), sign * std::cos(angle), 0.0);
    view.Planes.emplace_back(normal, -glm::dot(normal, view.Eye));
  }
  return view;
}

void MeasureRefinement(const std::string& name, const terrain::HierarchyView& hierarchy)
{
  terrain::Refiner refiner(hierarchy);
  const terrain::RefinementView view = MakeView(hierarchy, 0.0);
  std::vector<std::uint32_t> strip;
  Measure(name, "distance",
    [&](RefinementMethod method)
    {
      const std::int64_t triangles = refiner.RefineByDistance(view, 40.0, method, strip);
      return Counts{ triangles, strip.size() };
    });
  terrain::RefinementOptions options;
  terrain::StripMesh mesh;
  const auto refine = [&](RefinementMethod method)
  {
    options.Method = method;
    refiner.Refine(view, options, mesh);
    return Counts{ mesh.Triangles, mesh.Strip.size() };
  };
  options.Culling = terrain::CullingMethod::None;
  Measure(name, "error", refine);
  options.Culling = terrain::CullingMethod::Nested;
  options.Morphing = true;
  Measure(name, "error, nested culling, morph", refine);
  options.Culling = terrain::CullingMethod::Lazy;
  Measure(name, "error, lazy culling, morph", refine);
}

/// The same base with detail: 1024 x 1024 samples, 64 cells along a base cell, as high as a
/// sixteenth of a base cell is wide.
void MeasureDetail(const std::string& name, const terrain::HierarchyView& hierarchy)
{
  vtkNew<vtkTerrainDetailSource> source;
  source->SetSize(1024);
  source->SetRelief(hierarchy.Geometry.Spacing.x / 16.0);
  source->Update();
  const auto* heights = static_cast<float*>(source->GetOutput()->GetScalarPointer());
  terrain::DetailHierarchy detail;
  const std::string error = detail.Build(heights, { 1024, 1024 }, 6, terrain::SMPParallelFor);
  if (!error.empty())
  {
    std::fprintf(stderr, "detail: %s\n", error.c_str());
    return;
  }
  terrain::Refiner refiner(hierarchy, &detail);
  terrain::RefinementOptions options;
  terrain::StripMesh mesh;
  for (const double above : { 5.0, 500.0 })
  {
    terrain::RefinementView view = MakeView(hierarchy, 0.0);
    const glm::dvec2 position =
      (glm::dvec2(view.Eye) - glm::dvec2(hierarchy.Geometry.Origin)) / hierarchy.Geometry.Spacing;
    view.Eye.z = hierarchy.Geometry.Origin.z + above +
      hierarchy.HeightAt(std::lround(position.x), std::lround(position.y));
    const auto refine = [&](RefinementMethod method)
    {
      options.Method = method;
      refiner.Refine(view, options, mesh);
      return Counts{ mesh.Triangles, mesh.Strip.size() };
    };
    const std::string row = name + ", eye at " + std::to_string(std::lround(above));
    options.Morphing = false;
    options.Culling = terrain::CullingMethod::Nested;
    Measure(row, "detail, nested culling", refine);
    options.Culling = terrain::CullingMethod::Lazy;
    Measure(row, "detail, lazy culling", refine);
    options.Morphing = true;
    Measure(row, "detail, lazy culling, morph", refine);
  }
}

/// Heights of a procedural landscape of size x size samples.
terrain::HeightRows ProceduralRows(std::int64_t size)
{
  terrain::ProceduralTerrainParameters parameters;
  parameters.Width = size;
  parameters.Height = size;
  const auto landscape = std::make_shared<terrain::ProceduralTerrain>(parameters);
  return [landscape, size](std::int64_t first, std::int64_t count, float* heights)
  {
    landscape->Sample(0, first, size, count, heights, terrain::SMPParallelFor);
    return std::string();
  };
}

terrain::GridGeometry ProceduralGeometry()
{
  terrain::GridGeometry geometry;
  geometry.Spacing = { 160.0, 160.0 };
  return geometry;
}

int Failed(const std::string& name, const std::string& error)
{
  std::fprintf(stderr, "%s: %s\n", name.c_str(), error.c_str());
  return 1;
}

int MeasureProcedural(std::int64_t size)
{
  terrain::MemoryHierarchy hierarchy;
  const std::string error = terrain::BuildHierarchy(
    hierarchy, size, size, ProceduralGeometry(), ProceduralRows(size), terrain::SMPParallelFor, {});
  if (!error.empty())
  {
    return Failed(std::to_string(size), error);
  }
  MeasureRefinement("procedural " + std::to_string(size), hierarchy.View());
  MeasureDetail("procedural " + std::to_string(size), hierarchy.View());
  return 0;
}

/// Every raster in a folder; what cannot be read is left out.
int MeasureFolder(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const std::filesystem::path& path : paths)
  {
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path.string());
    if (reader->CanReadFile(path.c_str()) == 0)
    {
      continue;
    }
    reader->Update();
    vtkNew<vtkTerrainHierarchy> hierarchy;
    if (reader->GetErrorMessage()[0] == '\0' && hierarchy->SetHeights(reader->GetOutput()))
    {
      MeasureRefinement(path.filename().string(), hierarchy->GetData()->View());
    }
  }
  return 0;
}

/// Flies over a prepared file, then measures it.
int MeasureFile(const std::string& path)
{
  terrain::HierarchyFile file;
  const double before = ResidentMemory();
  const std::string error = file.Open(path, false);
  if (!error.empty())
  {
    return Failed(path, error);
  }
  terrain::Refiner refiner(file.View());
  terrain::RefinementOptions options;
  options.Morphing = true;
  options.TriangleBudget = 500000;
  terrain::StripMesh mesh;
  double largest = before;
  std::int64_t triangles = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 0; frame < kFrames; ++frame)
  {
    refiner.Refine(MakeView(file.View(), frame / static_cast<double>(kFrames)), options, mesh);
    largest = std::max(largest, ResidentMemory());
    triangles += mesh.Triangles;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::printf("\n%s: %.0f MiB; %d frames of %.0f triangles in %.1f s, resident %.0f MiB more "
              "(%.1f %%)\n\n",
    path.c_str(), static_cast<double>(file.Size()) / 1048576.0, kFrames,
    static_cast<double>(triangles) / kFrames, seconds.count(), largest - before,
    100.0 * 1048576.0 * (largest - before) / static_cast<double>(file.Size()));
  PrintHeader();
  MeasureRefinement(std::filesystem::path(path).filename().string(), file.View());
  return file.IsDamaged() ? 1 : 0;
}

/// Prepares a procedural landscape into a file, and measures that.
int MeasurePrepared(const std::string& argument)
{
  const std::size_t colon = argument.find(':');
  const std::int64_t size = std::atoll(argument.c_str());
  const std::string path = argument.substr(colon + 1);
  const std::string error = terrain::WriteHierarchyFile(
    path, size, size, ProceduralGeometry(), {}, ProceduralRows(size), terrain::SMPParallelFor, {});
  return error.empty() ? MeasureFile(path) : Failed(path, error);
}

int MeasureArgument(const std::string& argument)
{
  const std::size_t end = argument.find_first_not_of("0123456789");
  if (end == std::string::npos)
  {
    return MeasureProcedural(std::atoll(argument.c_str()));
  }
  if (end > 0 && argument[end] == ':')
  {
    return MeasurePrepared(argument);
  }
  return std::filesystem::is_directory(argument) ? MeasureFolder(argument) : MeasureFile(argument);
}
}

int main(int argc, char** argv)
{
  vtkObject::GlobalWarningDisplayOff();
  const std::vector<std::string> standard{ "1025", "4097" };
  const std::vector<std::string> arguments =
    argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : standard;
  int status = 0;
  PrintHeader();
  for (const std::string& argument : arguments)
  {
    status = std::max(status, MeasureArgument(argument));
  }
  return status;
}
