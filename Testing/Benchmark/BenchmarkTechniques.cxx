// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of the techniques on the procedural landscape, in four views, each as {median,
// minimum, maximum} of the GPU's timer and of the clock, and as a ratio to drawing the coarse mesh
// with lights and no search.
//
//   BenchmarkTechniques SAMPLES WIDTH HEIGHT [FRAMES [SAMPLES_PER_QUAD [TECHNIQUE...]]]
//
// Techniques: coarse, equidistant, pyramid (in the fragment shader), compute (pyramid in a compute
// shader), full (every cell two triangles).
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Eye and focal point as fractions of the terrain's side; z in metres, above ground if walking.
struct View
{
  const char* Name;
  std::array<double, 3> Eye;
  std::array<double, 3> Focus;
  bool AboveGround;
};

constexpr std::array<View, 4> Views{
  { { "oblique", { 0.5, -0.6, 20000.0 }, { 0.5, 0.45, 0.0 }, false },
    { "fly", { 0.3, 0.25, 4000.0 }, { 0.6, 0.6, 500.0 }, false },
    { "walk", { 0.42, 0.4, 2.0 }, { 0.7, 0.6, 200.0 }, true },
    { "down", { 0.5, 0.5, 30000.0 }, { 0.5, 0.501, 0.0 }, false } }
};

double heightAt(vtkImageData* image, double x, double y)
{
  const int* dims = image->GetDimensions();
  return image->GetScalarComponentAsDouble(
    static_cast<int>(x * (dims[0] - 1)), static_cast<int>(y * (dims[1] - 1)), 0, 0);
}

void look(vtkRenderer* renderer, vtkImageData* image, const View& view)
{
  const double side = image->GetSpacing()[0] * (image->GetDimensions()[0] - 1);
  const double eyeBase = view.AboveGround ? heightAt(image, view.Eye[0], view.Eye[1]) : 0.0;
  const double focusBase = view.AboveGround ? eyeBase : 0.0;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(side * view.Eye[0], side * view.Eye[1], eyeBase + view.Eye[2]);
  camera->SetFocalPoint(side * view.Focus[0], side * view.Focus[1], focusBase + view.Focus[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

struct Times
{
  std::vector<double> Gpu;
  std::vector<double> Clock;
};

Times measure(vtkRenderWindow* window, int frames)
{
  Times times;
  window->Render();
  window->WaitForCompletion();
  for (int frame = 0; frame < frames; ++frame)
  {
    vtkOpenGLRenderTimer timer;
    const Clock::time_point start = Clock::now();
    timer.Start();
    window->Render();
    timer.Stop();
    window->WaitForCompletion();
    times.Clock.push_back(millisecondsSince(start));
    while (!timer.Ready())
    {
    }
    times.Gpu.push_back(timer.GetElapsedMilliseconds());
    timer.ReleaseGraphicsResources();
  }
  std::sort(times.Gpu.begin(), times.Gpu.end());
  std::sort(times.Clock.begin(), times.Clock.end());
  return times;
}

void print(const char* label, const std::vector<double>& sorted)
{
  std::cout << "  " << label << " " << std::setw(9) << sorted[sorted.size() / 2] << " ("
            << sorted.front() << " .. " << sorted.back() << ")";
}
}

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: BenchmarkTechniques SAMPLES WIDTH HEIGHT [FRAMES [SAMPLES_PER_QUAD "
                 "[TECHNIQUE...]]]\n";
    return 2;
  }
  const int samples = std::atoi(argv[1]);
  const int frames = argc > 4 ? std::max(1, std::atoi(argv[4])) : 20;
  std::vector<std::string> techniques(argv + std::min(argc, 6), argv + argc);
  if (techniques.empty())
  {
    techniques = { "coarse", "equidistant", "pyramid" };
  }

  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(samples, samples);
  source->SetOutputScalarTypeToUnsignedShort();
  Clock::time_point start = Clock::now();
  source->Update();
  std::cout << std::fixed << std::setprecision(3) << "source " << millisecondsSince(start)
            << " ms\n";
  vtkImageData* image = source->GetOutput();

  vtkNew<vtkTerrainCoarseMesh> hull;
  hull->SetInputData(image);
  hull->SetSamplesPerQuad(argc > 5 ? std::atoi(argv[5]) : 0);
  start = Clock::now();
  hull->Update();
  std::cout << "coarse mesh " << millisecondsSince(start) << " ms, "
            << hull->GetOutput()->GetNumberOfCells() << " triangles, "
            << hull->GetEffectiveSamplesPerQuad() << " cells a quad\n";

  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(std::atoi(argv[2]), std::atoi(argv[3]));
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkOpenGLTerrainMapper> mapper;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);

  std::map<std::string, double> coarse;
  for (const std::string& technique : techniques)
  {
    using Techniques = vtkOpenGLTerrainMapper::Techniques;
    vtkNew<vtkTerrainCoarseMesh> full;
    if (technique == "full")
    {
      full->SetInputData(image);
      full->SetPushUp(false);
      full->SetSamplesPerQuad(1);
      mapper->SetInputConnection(full->GetOutputPort());
    }
    else
    {
      mapper->SetInputConnection(hull->GetOutputPort());
    }
    mapper->SetHeightsData(image);
    mapper->SetTechnique(technique == "pyramid" || technique == "compute" ? Techniques::Pyramid
        : technique == "equidistant"                                      ? Techniques::Equidistant
                                                                          : Techniques::Mesh);
    using Modes = vtkOpenGLTerrainMapper::ComputeModes;
    mapper->SetComputeMode(technique == "compute" ? Modes::On : Modes::Off);
    for (const View& view : Views)
    {
      look(renderer, image, view);
      start = Clock::now();
      window->Render();
      window->WaitForCompletion();
      const double first = millisecondsSince(start);
      const Times times = measure(window, frames);
      const double median = times.Gpu[times.Gpu.size() / 2];
      coarse.emplace(view.Name, median);
      std::cout << std::setw(12) << technique << std::setw(9) << view.Name;
      print("gpu ms", times.Gpu);
      print("clock ms", times.Clock);
      std::cout << "  x " << median / coarse[view.Name] << "  first " << first << "\n"
                << std::flush;
    }
  }
  std::cout << "textures " << mapper->GetTextureMemorySize() / 1048576.0 << " MiB, "
            << mapper->GetTextureMemorySize() / (2.0 * samples * samples) << " of the heights\n";
  std::istringstream capabilities(window->ReportCapabilities());
  for (std::string line; std::getline(capabilities, line);)
  {
    if (line.find("renderer string") != std::string::npos ||
      line.find("version string") != std::string::npos)
    {
      std::cout << line << "\n";
    }
  }
  return 0;
}
