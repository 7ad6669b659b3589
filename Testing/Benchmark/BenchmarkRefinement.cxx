// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures view-dependent refinement: BenchmarkRefinement [SIZE | FILE]...
//
// SIZE is the side of a procedural landscape, which is prepared in memory; FILE a prepared file,
// over which 200 frames are flown and the resident memory is watched. Without arguments: 1025,
// 4097. Times are processor time of one thread, median (least to most) of kRepeats runs.
#include "core/HierarchyFile.h"
#include "core/ProceduralTerrain.h"
#include "core/Refinement.h"
#include "vtkTerrainParallelFor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <time.h>
#include <unistd.h>

namespace
{
constexpr int kRepeats = 9;
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

/// Runs `refine`, which returns its triangles and indices, and prints the rates.
void Measure(const char* name, const std::function<std::pair<std::int64_t, std::size_t>()>& refine)
{
  std::vector<double> rates;
  std::pair<std::int64_t, std::size_t> counts = refine();
  for (int i = 0; i < kRepeats; ++i)
  {
    const double begin = ThreadSeconds();
    counts = refine();
    rates.push_back(1.0e-6 * static_cast<double>(counts.first) / (ThreadSeconds() - begin));
  }
  std::sort(rates.begin(), rates.end());
  std::printf("  %-34s %9lld triangles  %.3f indices each  %6.1f Mtri/s (%.1f to %.1f)\n", name,
    static_cast<long long>(counts.first),
    static_cast<double>(counts.second) /
      static_cast<double>(std::max<std::int64_t>(1, counts.first)),
    rates[rates.size() / 2], rates.front(), rates.back());
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

void MeasureRefinement(const terrain::HierarchyView& hierarchy)
{
  terrain::Refiner refiner(hierarchy);
  const terrain::RefinementView view = MakeView(hierarchy, 0.0);
  for (const bool plain : { false, true })
  {
    terrain::RefinementOptions options;
    options.Method = plain ? terrain::RefinementMethod::Plain : terrain::RefinementMethod::Improved;
    std::vector<std::uint32_t> strip;
    Measure(plain ? "plain, distance" : "improved, distance",
      [&]
      {
        const std::int64_t triangles = refiner.RefineByDistance(view, 40.0, options.Method, strip);
        return std::make_pair(triangles, strip.size());
      });
    terrain::StripMesh mesh;
    const auto refine = [&]
    {
      refiner.Refine(view, options, mesh);
      return std::make_pair(mesh.Triangles, mesh.Strip.size());
    };
    options.Culling = terrain::CullingMethod::None;
    Measure(plain ? "plain, error" : "improved, error", refine);
    options.Culling = terrain::CullingMethod::Nested;
    options.Morphing = true;
    Measure(plain ? "plain, error, culling, morph" : "improved, error, culling, morph", refine);
    options.Culling = terrain::CullingMethod::Lazy;
    Measure(plain ? "plain, error, lazy, morph" : "improved, error, lazy, morph", refine);
  }
}

void MeasureProcedural(std::int64_t size)
{
  terrain::ProceduralTerrainParameters parameters;
  parameters.Width = size;
  parameters.Height = size;
  const terrain::ProceduralTerrain landscape(parameters);
  terrain::MemoryHierarchy hierarchy;
  terrain::GridGeometry geometry;
  geometry.Spacing = { 160.0, 160.0 };
  const auto rows = [&](std::int64_t first, std::int64_t count, float* heights)
  {
    landscape.Sample(0, first, size, count, heights, vtkTerrainParallelFor);
    return std::string();
  };
  const auto begin = std::chrono::steady_clock::now();
  const std::string error =
    terrain::BuildHierarchy(hierarchy, size, size, geometry, rows, vtkTerrainParallelFor, {});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::printf("procedural %lld x %lld, made and prepared in %.2f s, %.0f MiB %s\n",
    static_cast<long long>(size), static_cast<long long>(size), seconds.count(),
    static_cast<double>(hierarchy.Layout.RecordCount()) * 12.0 / 1048576.0, error.c_str());
  MeasureRefinement(hierarchy.View());
}

int MeasureFile(const char* path)
{
  terrain::HierarchyFile file;
  const double before = ResidentMemory();
  const std::string error = file.Open(path, false);
  if (!error.empty())
  {
    std::fprintf(stderr, "%s: %s\n", path, error.c_str());
    return 1;
  }
  terrain::Refiner refiner(file.View());
  terrain::RefinementOptions options;
  options.Morphing = true;
  options.TriangleBudget = 500000;
  terrain::StripMesh mesh;
  double largest = before;
  std::int64_t triangles = 0;
  for (int frame = 0; frame < kFrames; ++frame)
  {
    refiner.Refine(MakeView(file.View(), frame / static_cast<double>(kFrames)), options, mesh);
    largest = std::max(largest, ResidentMemory());
    triangles += mesh.Triangles;
  }
  std::printf("%s: %.0f MiB, resident %.0f MiB more in %d frames (%.1f %%), %.0f triangles each\n",
    path, static_cast<double>(file.Size()) / 1048576.0, largest - before, kFrames,
    100.0 * 1048576.0 * (largest - before) / static_cast<double>(file.Size()),
    static_cast<double>(triangles) / kFrames);
  MeasureRefinement(file.View());
  return file.IsDamaged() ? 1 : 0;
}
}

int main(int argc, char** argv)
{
  const std::vector<std::string> standard{ "1025", "4097" };
  const std::vector<std::string> arguments =
    argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : standard;
  int status = 0;
  for (const std::string& argument : arguments)
  {
    if (argument.find_first_not_of("0123456789") == std::string::npos)
    {
      MeasureProcedural(std::atoll(argument.c_str()));
    }
    else
    {
      status = std::max(status, MeasureFile(argument.c_str()));
    }
  }
  return status;
}
