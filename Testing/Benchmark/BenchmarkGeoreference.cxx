// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Points a second between places, scene and file: BenchmarkGeoreference [POINTS [REPEATS]]
//
// Points lie at random within a degree of the middle of a raster. Prints the best of the repeats on
// all threads of vtkSMPTools: million points a second, and in brackets nanoseconds of processor
// time a point, which other programs on the machine change less.
#include "vtkTerrainGeoreference.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

struct Case
{
  const char* Name;
  const char* System;
  double Extent[4];
  Frame TheFrame;
};

const Case kCases[] = {
  { "degrees to Plane", "EPSG:4326", { 86.0, 87.0, 27.0, 28.0 }, Frame::Plane },
  { "degrees to Local", "EPSG:4326", { 86.0, 87.0, 27.0, 28.0 }, Frame::Local },
  { "degrees to Geocentric", "EPSG:4326", { 86.0, 87.0, 27.0, 28.0 }, Frame::Geocentric },
  { "degrees to Zone", "EPSG:4326", { 86.0, 87.0, 27.0, 28.0 }, Frame::Zone },
  { "UTM to Plane", "EPSG:32645", { 450e3, 550e3, 3000e3, 3100e3 }, Frame::Plane },
  { "UTM to its Grid", "EPSG:32645", { 450e3, 550e3, 3000e3, 3100e3 }, Frame::Grid },
};

/// The best of several runs.
struct Speed
{
  double MillionPoints = 0.0;
  double ProcessorNanoseconds = 1e30;
};

Speed Measure(int repeats, vtkIdType count, const std::function<void()>& run)
{
  const auto points = static_cast<double>(count);
  Speed best;
  for (int i = 0; i < repeats; ++i)
  {
    const std::clock_t processorBegin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const double processor = static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC;
    best.MillionPoints = std::max(best.MillionPoints, 1e-6 * points / seconds.count());
    best.ProcessorNanoseconds = std::min(best.ProcessorNanoseconds, 1e9 * processor / points);
  }
  return best;
}

void Report(const Case& one, vtkIdType count, int repeats)
{
  const vtkNew<vtkTerrainGeoreference> reference;
  reference->SetCoordinateSystem(one.System);
  reference->SetExtent(one.Extent[0], one.Extent[1], one.Extent[2], one.Extent[3]);
  reference->SetFrame(one.TheFrame);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> file(static_cast<std::size_t>(3 * count));
  for (std::size_t i = 0; i < file.size(); i += 3)
  {
    file[i] = one.Extent[0] + share(random) * (one.Extent[1] - one.Extent[0]);
    file[i + 1] = one.Extent[2] + share(random) * (one.Extent[3] - one.Extent[2]);
    file[i + 2] = 9000.0 * share(random);
  }
  std::vector<double> places(file.size());
  std::vector<double> scene(file.size());
  std::vector<double> back(file.size());
  reference->FileToPlaces(file.data(), places.data(), count);
  const Speed toScene = Measure(
    repeats, count, [&]() { reference->PlacesToScene(places.data(), scene.data(), count); });
  const Speed toPlaces =
    Measure(repeats, count, [&]() { reference->SceneToPlaces(scene.data(), back.data(), count); });
  const Speed fileToScene =
    Measure(repeats, count, [&]() { reference->FileToScene(file.data(), back.data(), count); });
  std::printf("%-22s", one.Name);
  for (const Speed& speed : { toScene, toPlaces, fileToScene })
  {
    std::printf("  %8.2f (%5.0f ns)", speed.MillionPoints, speed.ProcessorNanoseconds);
  }
  std::printf("\n");
}
}

int main(int argc, char* argv[])
{
  const auto count = static_cast<vtkIdType>(argc > 1 ? std::atoll(argv[1]) : 1000000);
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  if (count < 1 || repeats < 1)
  {
    std::fprintf(stderr, "BenchmarkGeoreference [POINTS [REPEATS]]\n");
    return EXIT_FAILURE;
  }
  std::printf("%lld points, %d threads\n", static_cast<long long>(count),
    vtkSMPTools::GetEstimatedNumberOfThreads());
  std::printf("%-22s  %s\n", "", "places to scene      scene to places      file to scene");
  for (const Case& one : kCases)
  {
    Report(one, count, repeats);
  }
  return EXIT_SUCCESS;
}
