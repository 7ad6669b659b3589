// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What programs do with windows, on a scene of VTK's own: a lit sphere, a translucent cone, text;
// and that terrains are the same in windows of both kinds.
#include "render/Compatibility.h"
#include "vtkTerrainTesting.h"
#include "vtkTerrainTestingScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <dirent.h>
#include <malloc.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <unistd.h>

using namespace vtkTerrainTesting;

namespace
{
#if VTKTERRAIN_OWN_WINDOWS
constexpr const char* kWindow = "VTK_DEFAULT_OPENGL_WINDOW";
#endif

void AddActor(vtkRenderer* renderer, vtkPolyDataAlgorithm* source, double opacity)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  actor->GetProperty()->SetSpecular(0.5);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}

void AddLight(vtkRenderer* renderer, double x, double y, double z, double blue)
{
  vtkNew<vtkLight> light;
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(1.0, 1.0, blue);
  light->SetIntensity(0.7);
  renderer->AddLight(light);
}

Scene MakeStockScene(int width, int height)
{
  Scene scene = MakeScene(width, height);
  scene.Renderer->SetBackground(0.1, 0.2, 0.3);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  AddActor(scene.Renderer, sphere, 1.0);
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.4, 0.0, 0.4);
  cone->SetResolution(24);
  AddActor(scene.Renderer, cone, 0.5);
  AddLight(scene.Renderer, 2, 3, 4, 0.6);
  AddLight(scene.Renderer, -4, 1, 2, 1.0);
  vtkNew<vtkTextActor> text;
  text->SetInput("vtkTerrain 0123");
  text->SetPosition(8, 8);
  text->GetTextProperty()->SetFontSize(20);
  scene.Renderer->AddViewProp(text);
  scene.Renderer->ResetCamera();
  return scene;
}

#if VTKTERRAIN_OWN_WINDOWS
/// A block of terrain with a hole, a sphere through it, and what shaders are built for: lights of
/// two kinds, colours of heights, contours, a clipping plane.
TerrainScene MakeTerrainScene()
{
  TerrainScene scene(vtkOpenGLTerrainMapper::Techniques::Pyramid);
  const TerrainProp terrain = scene.AddTerrain(MakeHills(true));
  scene.AddSphere(150.0, 200.0, 100.0, 50.0);
  AddLight(scene.Renderer, 400.0, 300.0, 500.0, 0.6);
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetConeAngle(50.0);
  lamp->SetPosition(100.0, 100.0, 300.0);
  lamp->SetFocalPoint(200.0, 200.0, 80.0);
  scene.Renderer->AddLight(lamp);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(300.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  terrain.Mapper->AddClippingPlane(plane);
  terrain.Mapper->ScalarVisibilityOn();
  terrain.Mapper->SetContours(true);
  terrain.Mapper->SetContourInterval(10.0);
  terrain.Mapper->SetBlock(true);
  scene.Renderer->ResetCameraClippingRange();
  return scene;
}
#endif

// Open file descriptors of this process.
int CountFiles()
{
  DIR* directory = opendir("/proc/self/fd");
  int count = 0;
  while (readdir(directory))
  {
    ++count;
  }
  closedir(directory);
  return count;
}

// Threads of this process: Mesa starts several for a context.
int CountThreads()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == "Threads:")
    {
      int count = 0;
      status >> count;
      return count;
    }
  }
  return 0;
}

// Resident memory in bytes, without what the allocator merely keeps.
long ResidentBytes()
{
  malloc_trim(0);
  long total = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, StockScene)
{
  const Scene scene = MakeStockScene(320, 240);
  const auto picture = Render(scene.Window);
  EXPECT_TRUE(MatchesBaseline(picture, "TestTerrainWindowsDrawing"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.131, 0.005);
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, SameSceneSamePixels)
{
  const auto first = Render(MakeStockScene(320, 240).Window);
  const auto second = Render(MakeStockScene(320, 240).Window);
  EXPECT_EQ(CountDifferentPixels(first, second), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, ResizedWindowDrawsAsANewOne)
{
  const Scene scene = MakeStockScene(320, 240);
  const auto before = Render(scene.Window);
  for (const auto& size : { std::array<int, 2>{ 200, 350 }, std::array<int, 2>{ 40, 30 },
         std::array<int, 2>{ 641, 123 } })
  {
    scene.Window->SetSize(size[0], size[1]);
    const auto resized = Render(scene.Window);
    EXPECT_EQ(resized->GetNumberOfPoints(), size[0] * size[1]);
    const Scene fresh = MakeStockScene(size[0], size[1]);
    fresh.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    EXPECT_EQ(CountDifferentPixels(resized, Render(fresh.Window)), 0) << size[0] << " " << size[1];
  }
  scene.Window->SetSize(320, 240);
  EXPECT_EQ(CountDifferentPixels(before, Render(scene.Window)), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, SeveralWindowsAlternate)
{
  const Scene a = MakeStockScene(320, 240);
  const Scene b = MakeStockScene(200, 200);
  b.Renderer->SetBackground(0.5, 0.0, 0.0);
  const auto firstA = Render(a.Window);
  const auto firstB = Render(b.Window);
  for (int i = 0; i < 3; ++i)
  {
    const Scene brief = MakeStockScene(50, 50);
    brief.Window->Render();
    EXPECT_EQ(CountDifferentPixels(firstA, ReadColor(a.Window)), 0);
    EXPECT_EQ(CountDifferentPixels(firstB, Render(b.Window)), 0);
    EXPECT_EQ(CountDifferentPixels(firstA, Render(a.Window)), 0);
    EXPECT_EQ(CountDifferentPixels(firstB, ReadColor(b.Window)), 0);
  }
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, WindowToImageFilterReadsTheSamePixels)
{
  const Scene scene = MakeStockScene(320, 240);
  const auto picture = Render(scene.Window);
  for (const bool front : { false, true })
  {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(scene.Window);
    filter->SetReadFrontBuffer(front);
    filter->SetInputBufferTypeToRGB();
    filter->ShouldRerenderOff();
    filter->Update();
    EXPECT_EQ(CountDifferentPixels(picture, filter->GetOutput()), 0);
  }
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, FinalizedWindowDrawsAgain)
{
  const Scene scene = MakeStockScene(320, 240);
  const auto before = Render(scene.Window);
  scene.Window->Finalize();
  // VTK rounds some colours differently by one when it draws a scene in a second context.
  EXPECT_EQ(CountDifferentPixels(before, Render(scene.Window), 1), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, SupportsOpenGLAndReports)
{
  const Scene scene = MakeStockScene(32, 24);
  scene.Window->Render();
  EXPECT_EQ(scene.Window->SupportsOpenGL(), 1);
  EXPECT_NE(
    std::string(scene.Window->ReportCapabilities()).find("OpenGL version"), std::string::npos);
}

#if VTKTERRAIN_OWN_WINDOWS
/// Draws a scene in a window of each kind, which live in one process and draw in turn; skips where
/// there are not both on the same driver.
template <typename Make>
void ExpectIdenticalWindows(const Make& make)
{
  const std::string asked = std::getenv(kWindow) ? std::getenv(kWindow) : "";
  setenv(kWindow, "vtkEGLRenderWindow", 1);
  const auto egl = make();
  setenv(kWindow, "vtkOSOpenGLRenderWindow", 1);
  const auto osmesa = make();
  setenv(kWindow, asked.c_str(), 1);
  if (!osmesa.Window->SupportsOpenGL())
  {
    GTEST_SKIP() << "there is no OSMesa";
  }
  const auto first = Render(egl.Window);
  if (std::string(egl.Window->ReportCapabilities()).find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "EGL draws on a GPU";
  }
  EXPECT_EQ(egl.Window->GetClassName(), std::string("vtkTerrainEGLRenderWindow"));
  EXPECT_EQ(osmesa.Window->GetClassName(), std::string("vtkTerrainOSMesaRenderWindow"));
  EXPECT_EQ(CountDifferentPixels(first, Render(osmesa.Window)), 0);
  EXPECT_EQ(ReadDepth(egl.Window), ReadDepth(osmesa.Window));
  EXPECT_EQ(CountDifferentPixels(Render(egl.Window), Render(osmesa.Window)), 0);
  EXPECT_EQ(CountDifferentPixels(first, ReadColor(egl.Window)), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, EGLAndOSMesaDrawIdenticalPixels)
{
  ExpectIdenticalWindows([] { return MakeStockScene(320, 240); });
}

//------------------------------------------------------------------------------
// Most tests of scenes draw in windows of one kind for it.
TEST(TestTerrainWindowsDrawing, TerrainsAreIdenticalWithEGLAndOSMesa)
{
  ExpectIdenticalWindows(MakeTerrainScene);
}
#endif

//------------------------------------------------------------------------------
TEST(TestTerrainWindowsDrawing, HundredWindowsLeaveNothing)
{
  // The first windows load drivers and fill caches that live as long as the process.
  for (int i = 0; i < 10; ++i)
  {
    MakeStockScene(320, 240).Window->Render();
  }
  const int files = CountFiles();
  const int threads = CountThreads();
  const long bytes = ResidentBytes();
  for (int i = 0; i < 100; ++i)
  {
    MakeStockScene(320, 240).Window->Render();
  }
  EXPECT_LE(CountFiles(), files);
  EXPECT_LE(CountThreads(), threads);
  // The three framebuffers of one window alone take 320 * 240 * (4 colours + 3 depths) * 4 bytes, 2
  // MB; a context of llvmpipe takes more. A leak of either would show as 200 MB.
  EXPECT_LE(ResidentBytes() - bytes, 20L << 20);
  std::cout << "growth over 100 windows: " << (ResidentBytes() - bytes) / 1024 << " kB\n";
}
