// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A file of heights drawn by VTK's own means, as a mesh of all its samples, and by this module:
 *
 *   BenchmarkRender HEIGHTS [WIDTH HEIGHT [FRAMES]]     default 1280 720 5
 *
 * Each is measured in a process of its own, one after the other. Printed are, for both and as
 * ratios: the time from the start of the reading to the first complete picture, the median of later
 * frames, and the peak of the memory held.
 */
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainRasterReader.h"
#include "vtkWarpScalar.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
using Clock = std::chrono::steady_clock;

/// What is drawn, and how often.
struct Task
{
  std::string Heights;
  int Width = 1280;
  int Height = 720;
  int Frames = 5;
};

struct Measures
{
  bool Complete = false;
  double FirstPictureMilliseconds = 0.0;
  double LaterFrameMilliseconds = 0.0;
  double PeakMebibytes = 0.0;
};

double MillisecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Largest resident size of this process so far, in MiB.
double PeakMebibytes()
{
  constexpr double kKilobytesPerMebibyte = 1024.0;
  double kilobytes = 0.0;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == "VmHWM:")
    {
      status >> kilobytes;
    }
  }
  return kilobytes / kKilobytesPerMebibyte;
}

/// VTK's own way: a quad for every cell, its points raised to the heights.
vtkSmartPointer<vtkMapper> MakeStockMapper(vtkAlgorithmOutput* heights)
{
  const vtkNew<vtkImageDataGeometryFilter> surface;
  surface->SetInputConnection(heights);
  const vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(surface->GetOutputPort());
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(warp->GetOutputPort());
  mapper->ScalarVisibilityOff();
  return mapper;
}

vtkSmartPointer<vtkMapper> MakeTerrainMapper(vtkAlgorithmOutput* heights)
{
  const vtkNew<vtkTerrainCoarseMesh> mesh;
  mesh->SetInputConnection(heights);
  auto mapper = vtkSmartPointer<vtkOpenGLTerrainMapper>::New();
  mapper->SetInputConnection(mesh->GetOutputPort());
  mapper->SetHeightsConnection(heights);
  mapper->SetTechnique(vtkOpenGLTerrainMapper::Techniques::Pyramid);
  mapper->ScalarVisibilityOff();
  return mapper;
}

using MapperMaker = vtkSmartPointer<vtkMapper> (*)(vtkAlgorithmOutput*);

Measures Measure(const Task& task, MapperMaker makeMapper)
{
  const Clock::time_point begin = Clock::now();
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(task.Heights);
  reader->Update();
  Measures measures;
  if (reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    return measures;
  }
  const vtkNew<vtkActor> actor;
  actor->SetMapper(makeMapper(reader->GetOutputPort()));
  const vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  const vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(task.Width, task.Height);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.0, 0.8);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  window->Render();
  window->WaitForCompletion();
  measures.FirstPictureMilliseconds = MillisecondsSince(begin);

  std::vector<double> frames;
  for (int frame = 0; frame < task.Frames; ++frame)
  {
    const Clock::time_point frameBegin = Clock::now();
    camera->Azimuth(1.0);
    window->Render();
    window->WaitForCompletion();
    frames.push_back(MillisecondsSince(frameBegin));
  }
  std::sort(frames.begin(), frames.end());
  measures.LaterFrameMilliseconds = frames[frames.size() / 2];
  measures.PeakMebibytes = PeakMebibytes();
  measures.Complete = true;
  return measures;
}

/// Measures in a child, so that the peak of its memory is its own.
Measures MeasureApart(const Task& task, MapperMaker makeMapper)
{
  Measures measures;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
  {
    return measures;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    const Measures own = Measure(task, makeMapper);
    const bool sent = write(ends[1], &own, sizeof(own)) == sizeof(own);
    _exit(sent ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  if (read(ends[0], &measures, sizeof(measures)) != sizeof(measures))
  {
    measures.Complete = false;
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return measures;
}

void Print(const char* name, double stock, double terrain, const char* unit)
{
  std::printf("%-16s %12.1f %12.1f %-4s %8.2f\n", name, stock, terrain, unit, stock / terrain);
}
}

int main(int argc, char* argv[])
{
  if (argc != 2 && argc != 4 && argc != 5)
  {
    std::fprintf(stderr, "usage: BenchmarkRender HEIGHTS [WIDTH HEIGHT [FRAMES]]\n");
    return 2;
  }
  Task task;
  task.Heights = argv[1];
  if (argc > 2)
  {
    task.Width = std::max(1, std::atoi(argv[2]));
    task.Height = std::max(1, std::atoi(argv[3]));
  }
  if (argc > 4)
  {
    task.Frames = std::max(1, std::atoi(argv[4]));
  }
  const Measures terrain = MeasureApart(task, MakeTerrainMapper);
  const Measures stock = MeasureApart(task, MakeStockMapper);
  if (!terrain.Complete || !stock.Complete)
  {
    std::fprintf(stderr, "%s: %s could not be drawn\n", argv[1],
      terrain.Complete ? "the full mesh" : "the terrain");
    return EXIT_FAILURE;
  }
  std::printf("%-16s %12s %12s %-4s %8s\n", "", "full mesh", "terrain", "", "ratio");
  Print("first picture", stock.FirstPictureMilliseconds, terrain.FirstPictureMilliseconds, "ms");
  Print("later frame", stock.LaterFrameMilliseconds, terrain.LaterFrameMilliseconds, "ms");
  Print("peak memory", stock.PeakMebibytes, terrain.PeakMebibytes, "MiB");
  return EXIT_SUCCESS;
}
