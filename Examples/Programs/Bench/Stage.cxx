// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace
{
constexpr double kSide = 122880.0;
constexpr double kPi = 3.14159265358979323846;

double HeightAt(vtkImageData* heights, double x, double y)
{
  const int* dimensions = heights->GetDimensions();
  return heights->GetScalarComponentAsDouble(
    static_cast<int>(x * (dimensions[0] - 1)), static_cast<int>(y * (dimensions[1] - 1)), 0, 0);
}

/// Fractions of the side, and metres of z.
View MakeView(
  const char* name, const std::array<double, 3>& eye, const std::array<double, 3>& focus)
{
  return { name, { kSide * eye[0], kSide * eye[1], eye[2] },
    { kSide * focus[0], kSide * focus[1], focus[2] } };
}

double Now()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

std::string ReportedValue(const std::string& report, const std::string& key)
{
  std::size_t begin = report.find(key);
  if (begin == std::string::npos)
  {
    return {};
  }
  begin = report.find_first_not_of(' ', begin + key.size());
  return report.substr(begin, report.find('\n', begin) - begin);
}

bool BeginsWith(const std::string& text, const std::string& word)
{
  return text.rfind(word, 0) == 0;
}

/// The number at the end of a technique's name.
int NumberIn(const std::string& technique)
{
  return std::stoi(technique.substr(technique.find_last_of(' ') + 1));
}

vtkOpenGLTerrainMapper::Techniques TechniqueOf(const std::string& name)
{
  using Techniques = vtkOpenGLTerrainMapper::Techniques;
  return name == "linear"             ? Techniques::Linear
    : name == "exponential"           ? Techniques::Exponential
    : BeginsWith(name, "equidistant") ? Techniques::Equidistant
    : name == "pyramid"               ? Techniques::Pyramid
    : name == "columns"               ? Techniques::Pyramid
                                      : Techniques::Mesh;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeLandscape(int samples)
{
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(samples, samples);
  source->SetSpacing(kSide / (samples - 1));
  source->SetOutputScalarTypeToUnsignedShort();
  source->Update();
  return source->GetOutput();
}

//------------------------------------------------------------------------------
std::vector<View> FixedViews(vtkImageData* heights)
{
  const double ground = HeightAt(heights, 0.42, 0.4);
  return { MakeView("oblique", { 0.5, -0.6, 20000.0 }, { 0.5, 0.45, 0.0 }),
    MakeView("fly", { 0.3, 0.25, 4000.0 }, { 0.6, 0.6, 500.0 }),
    MakeView("walk", { 0.42, 0.4, ground + 2.0 }, { 0.7, 0.6, ground + 200.0 }),
    MakeView("down", { 0.5, 0.5, 30000.0 }, { 0.5, 0.501, 0.0 }) };
}

//------------------------------------------------------------------------------
View OnFlight(vtkImageData*, double part)
{
  const double angle = 2.0 * kPi * part;
  const double x = 0.5 + 0.35 * std::cos(angle);
  const double y = 0.5 + 0.3 * std::sin(angle);
  return MakeView("flight", { x, y, 3500.0 },
    { x - 0.2 * std::sin(angle) - 0.05 * std::cos(angle), y + 0.2 * std::cos(angle), 300.0 });
}

//------------------------------------------------------------------------------
View OnWalk(vtkImageData* heights, double part)
{
  const double x = 0.3 + 0.3 * part;
  const double y = 0.45 + 0.05 * std::sin(2.0 * kPi * part);
  const double ground = HeightAt(heights, x, y) + 2.0;
  const double turn = 0.6 * std::sin(4.0 * kPi * part);
  return MakeView("walk", { x, y, ground },
    { x + 0.3 * std::cos(turn), y + 0.3 * std::sin(turn), ground + 150.0 });
}

//------------------------------------------------------------------------------
void Look(vtkCamera* camera, const View& view)
{
  camera->SetPosition(view.Eye.data());
  camera->SetFocalPoint(view.Focus.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
}

//------------------------------------------------------------------------------
Times Summarize(std::vector<double> milliseconds)
{
  if (milliseconds.empty())
  {
    return {};
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  return { milliseconds[milliseconds.size() / 2], milliseconds.front(), milliseconds.back() };
}

//------------------------------------------------------------------------------
Stopwatch::Stopwatch()
  : Begin(Now())
{
}

//------------------------------------------------------------------------------
double Stopwatch::Milliseconds() const
{
  return Now() - this->Begin;
}

//------------------------------------------------------------------------------
Stage::Stage(int width, int height)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  const std::string name = this->RendererName();
  this->Software =
    name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
}

//------------------------------------------------------------------------------
Stage::~Stage()
{
  this->Show(nullptr);
}

//------------------------------------------------------------------------------
void Stage::Show(vtkProp* prop)
{
  if (this->Shown)
  {
    this->Renderer->RemoveViewProp(this->Shown);
    this->Shown->ReleaseGraphicsResources(this->Window);
  }
  this->Shown = prop;
  this->IsCold = true;
  if (prop)
  {
    this->Renderer->AddViewProp(prop);
  }
}

//------------------------------------------------------------------------------
void Stage::Look(const View& view)
{
  ::Look(this->Renderer->GetActiveCamera(), view);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
// Makes buffers and programs; and has a graphics card that was idle take up its speed, for which it
// needs up to a few seconds: until frames get no faster.
void Stage::WarmUp()
{
  constexpr double part = 300.0;
  constexpr int most = 12;
  const auto frames = [this]
  {
    int count = 0;
    for (const Stopwatch watch; watch.Milliseconds() < part; ++count)
    {
      this->Window->Render();
      this->Window->WaitForCompletion();
    }
    return count;
  };
  this->Window->Render();
  this->Window->WaitForCompletion();
  int last = 0;
  for (int i = 0; i < most && !this->Software; ++i)
  {
    const int now = frames();
    if (now < 1.03 * last)
    {
      break;
    }
    last = now;
  }
  this->IsCold = false;
}

//------------------------------------------------------------------------------
double Stage::Draw()
{
  if (this->IsCold)
  {
    this->WarmUp();
  }
  vtkOpenGLRenderTimer timer;
  const std::clock_t begin = std::clock();
  timer.Start();
  this->Window->Render();
  timer.Stop();
  this->Window->WaitForCompletion();
  const double processor = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  while (!timer.Ready())
  {
  }
  const double card = static_cast<double>(timer.GetElapsedMilliseconds());
  timer.ReleaseGraphicsResources();
  return this->Software ? processor : card;
}

//------------------------------------------------------------------------------
Times Stage::Draw(int frames)
{
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(std::max(frames, 0)));
  for (int frame = 0; frame < frames; ++frame)
  {
    times.push_back(this->Draw());
  }
  return Summarize(times);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Stage::Depths()
{
  const vtkNew<vtkTerrainDepthPass> pass;
  this->Renderer->SetPass(pass);
  this->Window->Render();
  auto depths = vtkSmartPointer<vtkImageData>::New();
  depths->DeepCopy(pass->GetDistances());
  pass->ReleaseGraphicsResources(this->Window);
  this->Renderer->SetPass(nullptr);
  return depths;
}

//------------------------------------------------------------------------------
std::string Stage::RendererName() const
{
  const std::string words = this->Window->ReportCapabilities();
  return ReportedValue(words, "OpenGL renderer string:") + ", OpenGL " +
    ReportedValue(words, "OpenGL version string:");
}

//------------------------------------------------------------------------------
bool Stage::IsSoftware() const
{
  return this->Software;
}

//------------------------------------------------------------------------------
vtkRenderer* Stage::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
int Stage::GetPixels() const
{
  const int* size = this->Window->GetSize();
  return size[0] * size[1];
}

//------------------------------------------------------------------------------
Agreement Compare(vtkImageData* found, vtkImageData* exact)
{
  const auto* a = static_cast<const float*>(found->GetScalarPointer());
  const auto* b = static_cast<const float*>(exact->GetScalarPointer());
  double surface = 0.0;
  double missed = 0.0;
  double wrong = 0.0;
  for (vtkIdType i = 0; i < exact->GetNumberOfPoints(); ++i)
  {
    surface += std::isnan(b[i]) ? 0.0 : 1.0;
    const bool same = std::isnan(a[i]) == std::isnan(b[i]);
    missed += same ? 0.0 : 1.0;
    wrong += same && std::abs(a[i] - b[i]) > 1e-3f * b[i] ? 1.0 : 0.0;
  }
  const double percent = 100.0 / std::max(surface, 1.0);
  return { percent * missed, percent * wrong };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(const std::string& technique, vtkImageData* heights)
{
  const vtkNew<vtkOpenGLTerrainMapper> mapper;
  const int cells = heights->GetDimensions()[0] - 1;
  const vtkNew<vtkTerrainCoarseMesh> mesh;
  const bool full = technique == "full mesh";
  if (full || BeginsWith(technique, "coarse"))
  {
    mesh->SetInputData(heights);
    mesh->SetPushUp(!full);
    mesh->SetCellsPerQuad(full ? 1 : std::max(1, cells / NumberIn(technique)));
    mapper->SetInputConnection(mesh->GetOutputPort());
  }
  mapper->SetHeightsData(heights);
  mapper->SetTechnique(TechniqueOf(technique));
  if (technique == "columns")
  {
    mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  }
  if (BeginsWith(technique, "equidistant, "))
  {
    // Fehér: 5 steps of 0.025 of the side, 10 long ones, 2 secant steps; with 256 x 256 quads a
    // quarter of the length and twice the number
    const bool fine = NumberIn(technique) > 32;
    mapper->SetStepLength((fine ? 0.00625 : 0.025) * cells);
    mapper->SetSteps(fine ? 10 : 5);
    mapper->SetLongSteps(fine ? 20 : 10);
    mapper->SetSecantSteps(2);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
