// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"

#include "Messages.h"
#include "Statistics.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainDepthPass.h"

#include <optional>
#include <string>

namespace
{
/// Starts and stops a timer of the graphics card with the renderer, whose context is current then.
class FrameTimer
{
public:
  explicit FrameTimer(vtkRenderer* renderer)
    : Renderer(renderer)
  {
    this->Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &FrameTimer::OnStart);
    this->Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, this, &FrameTimer::OnEnd);
  }
  ~FrameTimer()
  {
    for (const unsigned long observer : this->Observers)
    {
      this->Renderer->RemoveObserver(observer);
    }
    this->Timer.Reset();
  }
  FrameTimer(const FrameTimer&) = delete;
  FrameTimer& operator=(const FrameTimer&) = delete;

  /// True once the last frame was timed; the window has to be complete.
  bool IsReady()
  {
    return this->Timer.Stopped() && this->Timer.Ready();
  }
  double GetMilliseconds()
  {
    return this->Timer.GetElapsedMilliseconds();
  }

private:
  void OnStart()
  {
    // VTK asks nobody whether the driver has timers, which OpenGL 3.2 does not promise.
    if (!this->IsSupported)
    {
      const std::string report = this->Renderer->GetRenderWindow()->ReportCapabilities();
      this->IsSupported = vtkOpenGLRenderTimer::IsSupported() &&
        report.find("GL_ARB_timer_query") != std::string::npos;
    }
    if (*this->IsSupported)
    {
      this->Timer.Reset();
      this->Timer.Start();
    }
  }
  void OnEnd()
  {
    if (this->Timer.Started())
    {
      this->Timer.Stop();
    }
  }

  vtkRenderer* Renderer;
  unsigned long Observers[2] = { 0, 0 };
  vtkOpenGLRenderTimer Timer;
  /// Known with the first frame.
  std::optional<bool> IsSupported;
};

/// The value of one line of the window's report, such as "OpenGL renderer string:".
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
}

//------------------------------------------------------------------------------
void DrawFrames(vtkRenderWindow* window, vtkRenderer* renderer, int frames, Statistics& statistics)
{
  FrameTimer timer(renderer);
  for (int frame = 0; frame < frames; ++frame)
  {
    const Stopwatch watch;
    window->Render();
    window->WaitForCompletion();
    const double milliseconds = watch.GetMilliseconds();
    ThrowOnError("cannot draw");
    if (frame == 0)
    {
      statistics.AddTime("first_frame", milliseconds);
    }
    if (frame > 0 || frames == 1)
    {
      statistics.AddTime("frame_cpu", milliseconds);
      if (timer.IsReady())
      {
        statistics.AddTime("frame_gpu", timer.GetMilliseconds());
      }
    }
  }
}

//------------------------------------------------------------------------------
void TellWindow(vtkRenderWindow* window, Statistics& statistics)
{
  statistics.SetText("window", window->GetClassName());
  statistics.SetText(
    "renderer", ReportedValue(window->ReportCapabilities(), "OpenGL renderer string:"));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DrawDepths(
  vtkRenderWindow* window, vtkRenderer* renderer, vtkProp* terrain, vtkProp* walls)
{
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = static_cast<vtkProp*>(props->GetItemAsObject(i));
    // a folder of far sites has several terrains
    prop->SetVisibility(
      prop == terrain || prop == walls || vtkTerrainActor::SafeDownCast(prop) != nullptr);
  }
  const vtkNew<vtkTerrainDepthPass> pass;
  renderer->SetPass(pass);
  window->Render();
  auto depths = vtkSmartPointer<vtkImageData>::New();
  depths->DeepCopy(pass->GetDistances());
  pass->ReleaseGraphicsResources(window);
  renderer->SetPass(nullptr);
  ThrowOnError("cannot draw");
  return depths;
}
