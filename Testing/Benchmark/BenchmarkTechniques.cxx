// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of the techniques on the procedural landscape, in four views, each as {median,
// minimum, maximum} of the GPU's timer, of the clock, and of the processor time of all threads, and
// as ratios of the three to the first technique named. Frames take turns, so that what else the
// machine does falls on all alike.
//
//   BenchmarkTechniques SAMPLES WIDTH HEIGHT [FRAMES [CELLS_PER_QUAD [TECHNIQUE...]]]
//
// Techniques: coarse, linear, exponential, equidistant, pyramid (in the fragment shader),
// compute-linear, compute-exponential, compute-equidistant (in a compute shader), pyramid-alone
// (pyramid without beams), pyramid-within (with a tolerance of a pixel), pyramid-detail (with 64
// cells of detail along a cell), compute and compute-detail (the same in a compute shader), full
// (every cell two triangles), globe and compute-globe (pyramid-alone and compute, the same samples
// in degrees on a globe, turned so that the views are the same), tiles and compute-tiles (pyramid
// and compute, the same samples by tiles, with a tolerance of half a pixel), tiles-alone (without
// beams). Names that end in -shadows are drawn with hard shadows, in -soft with those of the sun's
// disc, in -sky with the light of the sky: pyramid-shadows, compute-soft. If there are such, all
// are lit by a sun 20 degrees high in the south-east, not by a headlight.
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainGlobe.h"
#include "vtkTerrainSource.h"

#include "core/grid/ParallelFor.h"
#include "core/surface/MemoryTiles.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
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
#include <ctime>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

/// Metres.
constexpr double kGlobeRadius = 6378137.0;

double MillisecondsSince(Clock::time_point start)
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

double HeightAt(vtkImageData* image, double x, double y)
{
  const int* dims = image->GetDimensions();
  return image->GetScalarComponentAsDouble(
    static_cast<int>(x * (dims[0] - 1)), static_cast<int>(y * (dims[1] - 1)), 0, 0);
}

void Look(vtkRenderer* renderer, vtkImageData* image, const View& view)
{
  const double side = image->GetSpacing()[0] * (image->GetDimensions()[0] - 1);
  const double eyeBase = view.AboveGround ? HeightAt(image, view.Eye[0], view.Eye[1]) : 0.0;
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
  std::vector<double> Cpu;
};

/// A technique with a mapper of its own, so that turns rebuild nothing.
struct Entry
{
  std::string Name;
  vtkSmartPointer<vtkActor> Actor;
  double First = 0.0;
  Times Taken;
};

vtkOpenGLTerrainMapper::Techniques TechniqueOf(const std::string& name)
{
  using Techniques = vtkOpenGLTerrainMapper::Techniques;
  const auto has = [&name](const char* word) { return name.find(word) != std::string::npos; };
  return has("linear")   ? Techniques::Linear
    : has("exponential") ? Techniques::Exponential
    : has("equidistant") ? Techniques::Equidistant
    : name == "coarse"   ? Techniques::Mesh
    : name == "full"     ? Techniques::Mesh
                         : Techniques::Pyramid;
}

bool EndsIn(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

bool IsInSun(const std::string& name)
{
  return EndsIn(name, "-shadows") || EndsIn(name, "-soft") || EndsIn(name, "-sky");
}

void Shine(vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetPosition(0.664, -0.664, 0.342);
  renderer->AddLight(sun);
}

/// The samples on the globe, in degrees about (0, 0).
vtkSmartPointer<vtkImageData> LayOnGlobe(vtkImageData* image)
{
  const double degrees = vtkMath::DegreesFromRadians(image->GetSpacing()[0] / kGlobeRadius);
  vtkNew<vtkImageData> heights;
  heights->ShallowCopy(image);
  heights->SetOrigin(0.0, 0.0, 0.0);
  heights->SetSpacing(degrees, degrees, 1.0);
  vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(heights);
  globe->SetRadii(kGlobeRadius, kGlobeRadius);
  globe->Update();
  return globe->GetOutput();
}

/// East, north and up at (0, 0) along x, y and z.
void TurnToMap(vtkActor* actor)
{
  constexpr double axes[16] = { 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0,
    -kGlobeRadius, 0.0, 0.0, 0.0, 1.0 };
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(axes);
  actor->SetUserMatrix(matrix);
}

/// The samples as tiles of 256 x 256 cells.
std::shared_ptr<terrain::TileSource> MakeTiles(vtkImageData* image)
{
  terrain::HeightfieldView<unsigned short> view;
  view.Samples = static_cast<const unsigned short*>(image->GetScalarPointer());
  view.Width = image->GetDimensions()[0];
  view.Height = image->GetDimensions()[1];
  return terrain::MakeMemoryTiles(view, 8, terrain::SerialFor);
}

Entry MakeEntry(const std::string& name, vtkImageData* image, vtkTerrainCoarseMesh* hull)
{
  using Modes = vtkOpenGLTerrainMapper::ComputeModes;
  vtkNew<vtkOpenGLTerrainMapper> mapper;
  mapper->SetInputConnection(hull->GetOutputPort());
  if (name == "full")
  {
    vtkNew<vtkTerrainCoarseMesh> full;
    full->SetInputData(image);
    full->SetPushUp(false);
    full->SetCellsPerQuad(1);
    mapper->SetInputConnection(full->GetOutputPort());
  }
  mapper->SetHeightsData(image);
  const bool compute = name.rfind("compute", 0) == 0;
  mapper->SetSunShadows(EndsIn(name, "-shadows") || EndsIn(name, "-soft"));
  mapper->SetSunAngle(EndsIn(name, "-soft") ? 0.53 : 0.0);
  mapper->SetSkyLight(EndsIn(name, "-sky") ? 0.35 : 0.0);
  mapper->SetTechnique(TechniqueOf(name));
  mapper->SetComputeMode(compute ? Modes::On : Modes::Off);
  mapper->SetUseBeams(!EndsIn(name, "-alone") && !EndsIn(name, "globe"));
  mapper->SetPixelTolerance(name == "pyramid-within" ? 1.0 : 0.0);
  if (name == "pyramid-detail" || name == "compute-detail")
  {
    vtkNew<vtkTerrainDetailSource> detail;
    detail->Update();
    mapper->SetDetailData(detail->GetOutput());
    mapper->SetDetailCells(64);
  }
  if (name.find("tiles") != std::string::npos)
  {
    mapper->SetTileSource(MakeTiles(image));
  }
  Entry entry;
  entry.Name = name;
  entry.Actor = vtkSmartPointer<vtkActor>::New();
  entry.Actor->SetMapper(mapper);
  if (EndsIn(name, "globe"))
  {
    mapper->SetHeightsData(LayOnGlobe(image));
    TurnToMap(entry.Actor);
  }
  entry.Actor->VisibilityOff();
  return entry;
}

void DrawOnce(vtkRenderWindow* window, Entry& entry)
{
  vtkOpenGLRenderTimer timer;
  entry.Actor->VisibilityOn();
  const std::clock_t cpu = std::clock();
  const Clock::time_point start = Clock::now();
  timer.Start();
  window->Render();
  timer.Stop();
  window->WaitForCompletion();
  entry.Taken.Clock.push_back(MillisecondsSince(start));
  entry.Taken.Cpu.push_back(1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
  while (!timer.Ready())
  {
  }
  entry.Taken.Gpu.push_back(timer.GetElapsedMilliseconds());
  timer.ReleaseGraphicsResources();
  entry.Actor->VisibilityOff();
}

/// The frames of all techniques, in turns, the first of each apart.
void Measure(vtkRenderWindow* window, std::vector<Entry>& entries, int frames)
{
  for (int frame = -1; frame < frames; ++frame)
  {
    for (Entry& entry : entries)
    {
      DrawOnce(window, entry);
      if (frame < 0)
      {
        entry.First = entry.Taken.Clock.front();
        entry.Taken = Times();
      }
    }
  }
  for (Entry& entry : entries)
  {
    std::sort(entry.Taken.Gpu.begin(), entry.Taken.Gpu.end());
    std::sort(entry.Taken.Clock.begin(), entry.Taken.Clock.end());
    std::sort(entry.Taken.Cpu.begin(), entry.Taken.Cpu.end());
  }
}

double Median(const std::vector<double>& sorted)
{
  return sorted[sorted.size() / 2];
}

void Print(const char* label, const std::vector<double>& sorted)
{
  std::cout << "  " << label << " " << std::setw(9) << Median(sorted) << " (" << sorted.front()
            << " .. " << sorted.back() << ")";
}

/// Draws a view with all entries in turn, and prints what they took over the first one.
void Compare(vtkRenderWindow* window, vtkRenderer* renderer, vtkImageData* image, const View& view,
  std::vector<Entry>& entries, int frames)
{
  for (Entry& entry : entries)
  {
    entry.Actor->VisibilityOn(); // for the clipping range
  }
  Look(renderer, image, view);
  for (Entry& entry : entries)
  {
    entry.Actor->VisibilityOff();
  }
  Measure(window, entries, frames);
  const double gpu = Median(entries.front().Taken.Gpu);
  const double clock = Median(entries.front().Taken.Clock);
  const double cpu = Median(entries.front().Taken.Cpu);
  for (Entry& entry : entries)
  {
    std::cout << std::setw(16) << entry.Name << std::setw(9) << view.Name;
    Print("gpu ms", entry.Taken.Gpu);
    Print("clock ms", entry.Taken.Clock);
    Print("cpu ms", entry.Taken.Cpu);
    std::cout << "  x " << Median(entry.Taken.Gpu) / gpu << ", "
              << Median(entry.Taken.Clock) / clock << ", " << Median(entry.Taken.Cpu) / cpu
              << "  first " << entry.First << "\n"
              << std::flush;
  }
  for (Entry& entry : entries)
  {
    entry.Taken = Times();
  }
}

void PrintMemory(const std::vector<Entry>& entries, int samples)
{
  for (const Entry& entry : entries)
  {
    const double bytes = static_cast<double>(
      static_cast<vtkOpenGLTerrainMapper*>(entry.Actor->GetMapper())->GetTextureMemorySize());
    std::cout << entry.Name << ": textures " << bytes / 1048576.0 << " MiB, "
              << bytes / (2.0 * samples * samples) << " of the heights\n";
  }
}

void PrintDriver(vtkRenderWindow* window)
{
  std::istringstream capabilities(window->ReportCapabilities());
  for (std::string line; std::getline(capabilities, line);)
  {
    if (line.find("renderer string") != std::string::npos ||
      line.find("version string") != std::string::npos)
    {
      std::cout << line << "\n";
    }
  }
}
}

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: BenchmarkTechniques SAMPLES WIDTH HEIGHT [FRAMES [CELLS_PER_QUAD "
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
  std::cout << std::fixed << std::setprecision(3) << "source " << MillisecondsSince(start)
            << " ms\n";
  vtkImageData* image = source->GetOutput();

  vtkNew<vtkTerrainCoarseMesh> hull;
  hull->SetInputData(image);
  hull->SetCellsPerQuad(argc > 5 ? std::atoi(argv[5]) : 0);
  start = Clock::now();
  hull->Update();
  std::cout << "coarse mesh " << MillisecondsSince(start) << " ms, "
            << hull->GetOutput()->GetNumberOfCells() << " triangles, "
            << hull->GetEffectiveCellsPerQuad() << " cells a quad\n";

  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(std::atoi(argv[2]), std::atoi(argv[3]));
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  if (std::any_of(techniques.begin(), techniques.end(), IsInSun))
  {
    Shine(renderer);
  }
  std::vector<Entry> entries;
  for (const std::string& technique : techniques)
  {
    entries.push_back(MakeEntry(technique, image, hull));
    renderer->AddActor(entries.back().Actor);
  }
  window->Render(); // timers need a context
  for (const View& view : Views)
  {
    Compare(window, renderer, image, view, entries, frames);
  }
  PrintMemory(entries, samples);
  PrintDriver(window);
  return 0;
}
