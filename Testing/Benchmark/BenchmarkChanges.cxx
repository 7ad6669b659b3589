// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What changes cost while a terrain is shown:
 *
 *   BenchmarkChanges [SIZE [WIDTH HEIGHT [FRAMES [ONLY]]]]     default 4096 640 360 9
 *
 * Printed are the milliseconds, by the clock and by the processors' time, of an ordinary frame of
 * SIZE x SIZE samples, of the frame after each property was switched for the first time (shaders
 * are compiled) and later (median), and of the frames that follow; the ratios are to the slower of
 * the ordinary frames before and after. Then of frames at growing pixel tolerances, of picks, and
 * of frames of 1024 x 1024 samples whose heights change each time, with the ratio to an ordinary
 * frame of theirs. With ONLY, just the properties whose names begin so are switched. Mesa keeps
 * compiled shaders in files: MESA_SHADER_CACHE_DISABLE=true shows what the first time takes.
 */
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOPass.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainPicker.h"
#include "vtkTerrainSource.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
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
using Clock = std::chrono::steady_clock;
using Techniques = vtkTerrainActor::Techniques;

/// Milliseconds by the clock, and of all processors.
struct Times
{
  double Clock;
  double Work;
};

Times Median(const std::vector<Times>& times)
{
  const auto median = [&times](double Times::*which)
  {
    std::vector<double> values;
    values.reserve(times.size());
    for (const Times& time : times)
    {
      values.push_back(time.*which);
    }
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  return { median(&Times::Clock), median(&Times::Work) };
}

vtkSmartPointer<vtkImageData> MakeHeights(int size)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(size, size);
  source->SetOutputScalarTypeToFloat();
  source->Update();
  return source->GetOutput();
}

/// Adds the array "other" to the points.
void AddArray(vtkImageData* image)
{
  vtkNew<vtkFloatArray> array;
  array->SetName("other");
  array->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, static_cast<float>(i % 1000));
  }
  image->GetPointData()->AddArray(array);
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
    std::printf("ordinary frame %.1f ms (%.1f)\n", this->Ordinary.Clock, this->Ordinary.Work);
  }

  Times Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(0.05);
    const auto begin = Clock::now();
    const std::clock_t work = std::clock();
    this->Window->Render();
    this->Window->WaitForCompletion();
    return { std::chrono::duration<double, std::milli>(Clock::now() - begin).count(),
      1e3 * static_cast<double>(std::clock() - work) / CLOCKS_PER_SEC };
  }

  /// Median of frames that each follow change(k).
  Times Repeat(const std::function<void(int)>& change)
  {
    std::vector<Times> times;
    for (int k = 0; k < this->Frames; ++k)
    {
      change(k);
      times.push_back(this->Draw());
    }
    return Median(times);
  }

  /// Prints what frames after change(true) take, and those that follow; then it is undone.
  void Switch(const std::string& name, const std::function<void(bool)>& change)
  {
    if (name.compare(0, this->Only.size(), this->Only) != 0)
    {
      return;
    }
    std::vector<Times> on;
    std::vector<Times> steady;
    for (int k = 0; k < this->Frames; ++k)
    {
      change(true);
      on.push_back(this->Draw());
      steady.push_back(this->Draw());
      change(false);
      this->Draw();
    }
    const Times later = Median({ on.begin() + 1, on.end() });
    const Times still = Median(steady);
    const double slower = std::max(still.Clock, this->Ordinary.Clock);
    std::printf(
      "%-24s first %7.1f (%7.1f) %5.2fx   later %7.1f (%7.1f) %5.2fx   then %7.1f (%7.1f)\n",
      name.c_str(), on.front().Clock, on.front().Work, on.front().Clock / slower, later.Clock,
      later.Work, later.Clock / slower, still.Clock, still.Work);
  }

  vtkNew<vtkTerrainActor> Terrain;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  Times Ordinary{};
  int Frames;
  std::string Only;
};

/// RGB pixels that change smoothly.
vtkSmartPointer<vtkImageData> MakePicture()
{
  constexpr int Side = 1024;
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(Side, Side, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int i = 0; i < Side * Side; ++i)
  {
    *texel++ = static_cast<unsigned char>(i % Side / 4);
    *texel++ = static_cast<unsigned char>(i / Side / 4);
    *texel++ = 90;
  }
  return picture;
}

void SwitchColors(Show& show)
{
  using ColorSources = vtkOpenGLTerrainMapper::ColorSources;
  vtkTerrainActor* terrain = show.Terrain;
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  const auto source = [mapper](ColorSources kind)
  { return [mapper, kind](bool on) { mapper->SetColorSource(on ? kind : ColorSources::Array); }; };
  vtkNew<vtkTexture> texture;
  const auto picture = MakePicture();
  texture->SetInputData(picture);
  std::array<double, 6> bounds{};
  terrain->GetBounds(bounds.data());
  vtkNew<vtkLookupTable> table;
  table->SetRange(bounds[4], bounds[5]);
  show.Switch("colour by height off", [&](bool on) { terrain->SetColorByHeight(!on); });
  show.Switch("slope colours", source(ColorSources::Slope));
  show.Switch("aspect colours", source(ColorSources::Aspect));
  mapper->SelectColorArray("other");
  show.Switch("array",
    [&](bool on)
    { on ? mapper->SetScalarModeToUsePointFieldData() : mapper->SetScalarModeToDefault(); });
  show.Switch("table", [&](bool on) { terrain->SetLookupTable(on ? table.Get() : nullptr); });
  show.Switch(
    "drape", [&](bool on) { mapper->SetDrape(on ? picture.Get() : nullptr, bounds.data()); });
  show.Switch("texture", [&](bool on) { terrain->SetTexture(on ? texture.Get() : nullptr); });
  show.Switch("contours", [&](bool on) { mapper->SetContours(on); });
  show.Switch("contour interval", [&](bool on) { mapper->SetContourInterval(on ? 50.0 : 100.0); });
  show.Switch("hillshade", [&](bool on) { mapper->SetHillshade(on); });
  show.Switch("crossings", [&](bool on) { mapper->SetShowCrossings(on); });
}

void SwitchLights(Show& show)
{
  vtkTerrainActor* terrain = show.Terrain;
  vtkProperty* property = terrain->GetProperty();
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetPosition(terrain->GetCenter()[0], terrain->GetCenter()[1], 20000.0);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(500.0);
  occlusion->SetDelegatePass(steps);
  show.Switch("diffuse", [&](bool on) { property->SetDiffuse(on ? 0.9 : 1.0); });
  show.Switch("lighting", [&](bool on) { property->SetLighting(!on); });
  show.Switch("lamp",
    [&](bool on) { on ? show.Renderer->AddLight(lamp) : show.Renderer->RemoveLight(lamp); });
  show.Switch("flat",
    [&](bool on)
    { on ? property->SetInterpolationToFlat() : property->SetInterpolationToGouraud(); });
  show.Switch("physically based",
    [&](bool on)
    { on ? property->SetInterpolationToPBR() : property->SetInterpolationToGouraud(); });
  show.Switch(
    "ambient occlusion", [&](bool on) { show.Renderer->SetPass(on ? occlusion.Get() : nullptr); });
  show.Switch("opacity", [&](bool on) { property->SetOpacity(on ? 0.5 : 1.0); });
}

void SwitchShapes(Show& show)
{
  vtkTerrainActor* terrain = show.Terrain;
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(terrain->GetCenter());
  plane->SetNormal(1.0, 0.0, 0.0);
  vtkCamera* camera = show.Renderer->GetActiveCamera();
  show.Switch("exaggeration", [&](bool on) { terrain->SetVerticalExaggeration(on ? 1.2 : 1.0); });
  show.Switch("parallel projection", [&](bool on) { camera->SetParallelProjection(on); });
  show.Switch("clipping plane",
    [&](bool on) { on ? mapper->AddClippingPlane(plane) : mapper->RemoveAllClippingPlanes(); });
  show.Switch("extract",
    [&](bool on)
    {
      const int first[2] = { 100, 100 };
      const int last[2] = { 900, 900 };
      on ? mapper->SetExtract(first, last) : mapper->ExtractAll();
    });
  show.Switch(
    "back faces culled", [&](bool on) { terrain->GetProperty()->SetBackfaceCulling(on); });
  show.Switch("block", [&](bool on) { mapper->SetBlock(on); });
  show.Switch("columns",
    [&](bool on)
    {
      mapper->SetSurface(on ? vtkOpenGLTerrainMapper::Surfaces::Columns
                            : vtkOpenGLTerrainMapper::Surfaces::Bilinear);
    });
  show.Switch("tolerance", [&](bool on) { mapper->SetPixelTolerance(on ? 2.0 : 0.0); });
  show.Switch("linear search",
    [&](bool on) { terrain->SetTechnique(on ? Techniques::Linear : Techniques::Pyramid); });
  show.Switch("exponential search",
    [&](bool on) { terrain->SetTechnique(on ? Techniques::Exponential : Techniques::Pyramid); });
}

void TolerateErrors(Show& show)
{
  for (const double pixels : { 0.0, 1.0, 2.0, 4.0, 8.0, 16.0 })
  {
    show.Terrain->GetTerrainMapper()->SetPixelTolerance(pixels);
    std::printf("tolerance %4.0f pixels        %8.1f ms\n", pixels, show.Repeat([](int) {}).Clock);
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
  const double time = show.Repeat(change).Clock;
  std::printf(
    "heights of 1024^2 change     %8.1f ms (%.2fx ordinary)\n", time, time / show.Ordinary.Clock);
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
    AddArray(heights);
    Show show(heights, width, height, frames);
    show.Only = argc > 5 ? argv[5] : "";
    SwitchColors(show);
    SwitchLights(show);
    SwitchShapes(show);
    if (argc > 5)
    {
      return EXIT_SUCCESS;
    }
    TolerateErrors(show);
    Pick(show);
  }
  ChangeHeights(width, height, frames);
  return EXIT_SUCCESS;
}
