// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which window vtkRenderWindow::New gives. The tests set the environment themselves.
#include "render/Compatibility.h"
#include "vtkTerrainTesting.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace vtkTerrainTesting;

namespace
{
constexpr const char* kWindow = "VTK_DEFAULT_OPENGL_WINDOW";
constexpr const char* kDevice = "VTK_DEFAULT_EGL_DEVICE_INDEX";

// Without a display, and with nothing asked for.
class TestTerrainWindows : public testing::Test
{
protected:
  void SetUp() override
  {
    for (const char* name : { kWindow, kDevice, "DISPLAY" })
    {
      unsetenv(name);
    }
  }
};

std::string ClassOfNewWindow(const char* wanted)
{
  setenv(kWindow, wanted, 1);
  return vtkSmartPointer<vtkRenderWindow>::New()->GetClassName();
}

#if VTKTERRAIN_OWN_WINDOWS
void AddSphere(const Scene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

// Counts a window's errors and keeps the text of the last.
struct Errors
{
  int Count = 0;
  std::string Text;

  void Observe(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        static_cast<Errors*>(self)->Count += 1;
        static_cast<Errors*>(self)->Text = static_cast<const char*>(text);
      });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }
};

// The window draws nothing, reads back zeros, and has reported one error that has all the parts.
void ExpectNoWindow(const std::vector<std::string>& parts)
{
  const Scene scene = MakeScene(40, 30);
  Errors errors;
  errors.Observe(scene.Window);
  scene.Renderer->SetBackground(1, 1, 1);
  AddSphere(scene);
  const auto picture = Render(scene.Window);
  scene.Window->Render();
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(static_cast<unsigned char*>(picture->GetScalarPointer())[3 * i], 0);
  }
  EXPECT_EQ(ReadDepth(scene.Window), std::vector<float>(1200, 0.0F));
  EXPECT_EQ(errors.Count, 1);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  ASSERT_NE(window, nullptr);
  EXPECT_EQ(window->SupportsOpenGL(), 0);
  for (const std::string& part : parts)
  {
    EXPECT_NE(errors.Text.find(part), std::string::npos) << part << " is not in: " << errors.Text;
    EXPECT_NE(window->GetOpenGLSupportMessage().find(part), std::string::npos);
  }
}
#endif
}

//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, EveryNameGivesItsClass)
{
  EXPECT_NE(ClassOfNewWindow("vtkEGLRenderWindow").find("EGL"), std::string::npos);
#if VTKTERRAIN_OWN_WINDOWS
  EXPECT_EQ(ClassOfNewWindow("vtkEGLRenderWindow"), "vtkTerrainEGLRenderWindow");
  EXPECT_EQ(ClassOfNewWindow(""), "vtkTerrainEGLRenderWindow");
#endif
}

#if VTKTERRAIN_OWN_WINDOWS
//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, UnknownNameIsOneError)
{
  setenv(kWindow, "vtkNoSuchRenderWindow", 1);
  ExpectNoWindow({ kWindow, "vtkNoSuchRenderWindow", "vtkXOpenGLRenderWindow", "vtkEGLRenderWindow",
    "vtkOSOpenGLRenderWindow" });
}

//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, XWithoutDisplayIsOneError)
{
  setenv(kWindow, "vtkXOpenGLRenderWindow", 1);
  ExpectNoWindow({ "X: DISPLAY is not set" });
  setenv("DISPLAY", ":4321", 1);
  ExpectNoWindow({ "X: the display :4321 does not open" });
}

//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, DisplayThatDoesNotOpenGivesEGL)
{
  setenv("DISPLAY", ":4321", 1);
  EXPECT_EQ(ClassOfNewWindow(""), "vtkTerrainEGLRenderWindow");
}

//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, DeviceThatDoesNotExistIsOneError)
{
  setenv(kWindow, "vtkEGLRenderWindow", 1);
  setenv(kDevice, "99", 1);
  ExpectNoWindow({ "EGL device 99", "EGL lists" });
  setenv(kDevice, "1x", 1);
  ExpectNoWindow({ kDevice });
}

//------------------------------------------------------------------------------
// VTK's own interactor ends the program here.
TEST_F(TestTerrainWindows, InteractorNeedsNoDisplay)
{
  const Scene scene = MakeScene(40, 30);
  scene.Renderer->SetBackground(1, 1, 1);
  AddSphere(scene);
  const auto before = Render(scene.Window);
  vtkNew<vtkRenderWindowInteractor> interactor;
  EXPECT_EQ(interactor->GetClassName(), std::string("vtkGenericRenderWindowInteractor"));
  interactor->SetRenderWindow(scene.Window);
  interactor->Initialize();
  interactor->Start();
  EXPECT_EQ(CountDifferentPixels(before, Render(scene.Window)), 0);
}

//------------------------------------------------------------------------------
TEST_F(TestTerrainWindows, WindowAfterFailure)
{
  setenv(kWindow, "vtkEGLRenderWindow", 1);
  const Scene scene = MakeScene(40, 30);
  scene.Window->SetDeviceIndex(99);
  Errors errors;
  errors.Observe(scene.Window);
  scene.Renderer->SetBackground(1, 1, 1);
  scene.Window->Render();
  EXPECT_EQ(errors.Count, 1);
  scene.Window->SetDeviceIndex(-1);
  const auto picture = Render(scene.Window);
  EXPECT_EQ(*static_cast<unsigned char*>(picture->GetScalarPointer()), 255);
  EXPECT_EQ(errors.Count, 1);
}
#endif
