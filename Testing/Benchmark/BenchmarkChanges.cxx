// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What changes cost while a terrain is shown:
 *
 *   BenchmarkChanges [SIZE [WIDTH HEIGHT [FRAMES]]]     default 4096 640 360 9
 *
 * Printed are the milliseconds of an ordinary frame of SIZE x SIZE samples, of the frame after each
 * property was switched for the first time (shaders are compiled) and later (median), and of the
 * frames that follow; the ratio is to the slower of the ordinary frames before and after. Then of
 * frames at growing pixel tolerances, of picks, and of frames of 1024 x 1024 samples whose heights
 * change each time, with the ratio to an ordinary frame of theirs.
 */
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainPicker.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;
using Techniques = vtkTerrainActor::Techniques;

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

vtkSmartPointer<vtkImageData> MakeHeights(int size)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(size, size);
  source->SetOutputScalarTypeToFloat();
  source->Update();
  return source->GetOutput();
}

/// A terrain in a window.
class Show
{
public:
  Show(vtkImageData* heights, int width, int height, int frames)
    : Frames(frames)
  {
    this->Terrain->SetInputData(heights);
    this->Renderer->AddActor(this->Terrain);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -1.0, 0.5);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    camera->Dolly(1.8);
    this->Renderer->ResetCameraClippingRange();
    this->Draw();
    this->Draw();
    this->Ordinary = this->Repeat([](int) {});
    std::printf("%-28s %8.1f ms\n", "ordinary frame", this->Ordinary);
  }

  /// Milliseconds of a frame.
  double Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(0.05);
    const auto begin = Clock::now();
    this->Window->Render();
    this->Window->WaitForCompletion();
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  }

  /// Median of frames that each follow change(k).
  double Repeat(const std::function<void(int)>& change)
  {
    std::vector<double> times;
    for (int k = 0; k < this->Frames; ++k)
    {
      change(k);
      times.push_back(this->Draw());
    }
    return Median(times);
  }

  /// Prints what frames after change(true) take, and those that follow; then it is undone.
  void Switch(const char* name, const std::function<void(bool)>& change)
  {
    std::vector<double> on;
    std::vector<double> steady;
    for (int k = 0; k < this->Frames; ++k)
    {
      change(true);
      on.push_back(this->Draw());
      steady.push_back(this->Draw());
      change(false);
      this->Draw();
    }
    const double later = Median({ on.begin() + 1, on.end() });
    const double still = Median(steady);
    std::printf("%-28s %8.1f ms first, %8.1f ms later, then %8.1f ms: %.2fx the slower\n", name,
      on.front(), later, still, later / std::max(still, this->Ordinary));
  }

  vtkNew<vtkTerrainActor> Terrain;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  double Ordinary = 0.0;
  int Frames;
};

void SwitchProperties(Show& show)
{
  vtkTerrainActor* terrain = show.Terrain;
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  vtkProperty* property = terrain->GetProperty();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(terrain->GetCenter());
  plane->SetNormal(1.0, 0.0, 0.0);
  show.Switch("exaggeration", [&](bool on) { terrain->SetVerticalExaggeration(on ? 1.2 : 1.0); });
  show.Switch("colour by height off", [&](bool on) { terrain->SetColorByHeight(!on); });
  show.Switch("crossings", [&](bool on) { mapper->SetShowCrossings(on); });
  show.Switch("contours", [&](bool on) { mapper->SetContours(on); });
  show.Switch("contour interval", [&](bool on) { mapper->SetContourInterval(on ? 50.0 : 100.0); });
  show.Switch("hillshade", [&](bool on) { mapper->SetHillshade(on); });
  show.Switch("slope colours",
    [&](bool on)
    {
      mapper->SetColorSource(on ? vtkOpenGLTerrainMapper::ColorSources::Slope
                                : vtkOpenGLTerrainMapper::ColorSources::Array);
    });
  show.Switch("diffuse", [&](bool on) { property->SetDiffuse(on ? 0.9 : 1.0); });
  show.Switch("lighting", [&](bool on) { property->SetLighting(!on); });
  show.Switch("clipping plane",
    [&](bool on) { on ? mapper->AddClippingPlane(plane) : mapper->RemoveAllClippingPlanes(); });
  show.Switch("extract",
    [&](bool on)
    {
      const int first[2] = { 100, 100 };
      const int last[2] = { 900, 900 };
      on ? mapper->SetExtract(first, last) : mapper->ExtractAll();
    });
  show.Switch("block", [&](bool on) { mapper->SetBlock(on); });
  show.Switch("opacity", [&](bool on) { property->SetOpacity(on ? 0.5 : 1.0); });
  show.Switch("technique equidistant",
    [&](bool on) { terrain->SetTechnique(on ? Techniques::Equidistant : Techniques::Pyramid); });
}

void TolerateErrors(Show& show)
{
  for (const double pixels : { 0.0, 1.0, 2.0, 4.0, 8.0, 16.0 })
  {
    show.Terrain->GetTerrainMapper()->SetPixelTolerance(pixels);
    std::printf("tolerance %4.0f pixels        %8.1f ms\n", pixels, show.Repeat([](int) {}));
  }
}

/// What the first pick takes, which scans the heights, and what picks and lines of sight take then.
void Pick(Show& show)
{
  constexpr int Count = 1000;
  vtkNew<vtkTerrainPicker> picker;
  std::mt19937 random(7);
  const int* size = show.Window->GetSize();
  std::uniform_real_distribution<double> x(0.0, size[0]);
  std::uniform_real_distribution<double> y(0.0, size[1]);
  std::vector<std::array<double, 3>> points;
  const auto pick = [&]
  {
    if (picker->Pick(x(random), y(random), 0.0, show.Renderer))
    {
      const double* point = picker->GetPickPosition();
      points.push_back({ point[0], point[1], point[2] + 2.0 });
    }
  };
  const auto milliseconds = [](const auto& work)
  {
    const auto begin = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  };
  std::printf("first pick                   %8.1f ms\n", milliseconds(pick));
  const double picks = milliseconds(
    [&]
    {
      for (int k = 0; k < Count; ++k)
      {
        pick();
      }
    });
  int seen = 0;
  const double sights = milliseconds(
    [&]
    {
      for (std::size_t k = 1; k < points.size(); ++k)
      {
        seen += picker->HasLineOfSight(show.Terrain, points[k - 1].data(), points[k].data());
      }
    });
  std::printf("a pick                       %8.1f us\n", 1000.0 * picks / Count);
  std::printf("a line of sight              %8.1f us, %d of %d are clear\n",
    1000.0 * sights / std::max<double>(1.0, static_cast<double>(points.size()) - 1.0), seen,
    static_cast<int>(points.size()) - 1);
}

/// All heights change before each frame.
void ChangeHeights(int width, int height, int frames)
{
  constexpr int Size = 1024;
  const auto heights = MakeHeights(Size);
  Show show(heights, width, height, frames);
  auto* values = vtkFloatArray::SafeDownCast(heights->GetPointData()->GetScalars());
  vtkNew<vtkFloatArray> first;
  first->DeepCopy(values);
  const auto change = [&](int k)
  {
    const auto factor = static_cast<float>(1.0 + 0.02 * ((k + 1) % 5));
    float* out = values->GetPointer(0);
    std::transform(first->GetPointer(0), first->GetPointer(0) + first->GetNumberOfValues(), out,
      [factor](float value) { return factor * value; });
    values->Modified();
  };
  const double time = show.Repeat(change);
  std::printf(
    "heights of 1024^2 change     %8.1f ms (%.2fx ordinary)\n", time, time / show.Ordinary);
}
}

int main(int argc, char* argv[])
{
  const auto argument = [argc, argv](int index, int fallback)
  { return argc > index ? std::atoi(argv[index]) : fallback; };
  const int size = argument(1, 4096);
  const int width = argument(2, 640);
  const int height = argument(3, 360);
  const int frames = std::max(2, argument(4, 9));
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf("%d x %d samples, %d x %d pixels\n", size, size, width, height);
  {
    const auto heights = MakeHeights(size);
    Show show(heights, width, height, frames);
    SwitchProperties(show);
    TolerateErrors(show);
    Pick(show);
  }
  ChangeHeights(width, height, frames);
  return EXIT_SUCCESS;
}
