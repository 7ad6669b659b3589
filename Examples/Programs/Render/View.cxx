// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "Canvas.h"
#include "DefaultView.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Scenery.h"
#include "Terrain.h"
#include "TextSize.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace
{
/// Intensity of the light of the sun.
constexpr double kSunIntensity = 1.05;
/// Height of a title and what is around it, over that of a usual picture.
constexpr double kTitleRoom = 0.085;

/// Throws a Failure about an option if there is a reason.
void ThrowIf(const std::string& option, const std::string& why)
{
  if (!why.empty())
  {
    throw Failure(option, why);
  }
}

void AddLights(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options)
{
  renderer->AutomaticLightCreationOff();
  const vtkNew<vtkLight> sun;
  sun->SetColor(1.0, 0.98, 0.94);
  renderer->AddLight(sun);
  SetSun(renderer, heights, options, options.Light.GetSuns().front());
  if (options.Light.SkyLight == 0.0)
  {
    const vtkNew<vtkLight> sky;
    sky->SetLightTypeToHeadlight();
    sky->SetColor(0.86, 0.92, 1.0);
    sky->SetIntensity(0.35);
    renderer->AddLight(sky);
  }
}

/// VTK's own OSMesa window takes the library for granted, and would crash without it.
void RequireOSMesa()
{
  for (const char* name : { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" })
  {
    if (dlopen(name, RTLD_LAZY)) // stays open for the window
    {
      return;
    }
  }
  throw Failure("no OSMesa window can be had: libOSMesa is not installed");
}
}

//------------------------------------------------------------------------------
void SetSun(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  const std::string& sun)
{
  auto* light = static_cast<vtkLight*>(renderer->GetLights()->GetItemAsObject(0));
  ThrowIf("--sun", PlaceSun(sun, heights.Georeference, heights.Image, heights.Exaggeration, light));
  if (heights.IsGlobe() && sun.empty())
  {
    LightGlobe(renderer->GetActiveCamera(), light);
  }
  if (!light->GetSwitch() && options.Light.GetSuns().size() == 1)
  {
    Warn("--sun: it is night");
  }
  // VTK draws everything in full light where no light is on
  light->SetIntensity(light->GetSwitch() ? kSunIntensity : 0.0);
  light->SwitchOn();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(const Options& options)
{
  // VTK reads its choice of window from the environment
  constexpr const char* kVariable = "VTK_DEFAULT_OPENGL_WINDOW";
  switch (options.Target)
  {
    case Window::EGL:
      setenv(kVariable, "vtkEGLRenderWindow", 1);
      break;
    case Window::OSMesa:
      RequireOSMesa();
      setenv(kVariable, "vtkOSOpenGLRenderWindow", 1);
      break;
    case Window::X:
      setenv(kVariable, "vtkXOpenGLRenderWindow", 1);
      break;
    case Window::Automatic:
      break;
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(options.Scenery.IsTransparent() ? 1 : 0);
  window->SetSize(PieceSize(options).data());
  return window;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Terrain& terrain, const PlacedHeights& heights, const Options& options)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AddActor(terrain.Actor);
  if (terrain.Walls)
  {
    renderer->AddActor(terrain.Walls);
  }
  const vtkBoundingBox& box = terrain.Bounds;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(options.ViewAngle);
  if (options.View)
  {
    camera->SetPosition(options.View->Eye.data());
    camera->SetFocalPoint(options.View->FocalPoint.data());
    camera->SetViewUp(options.View->Up.data());
  }
  else if (!options.Place.LookFrom.empty())
  {
    const auto viewpoint = MakeViewpoint(heights);
    std::array<double, 3> place{};
    ThrowIf("--look-from", viewpoint->FindPlace(options.Place.LookFrom, place.data()));
    ThrowIf("--look-at", viewpoint->FindPlace(options.Place.LookAt, place.data()));
    ThrowIf("--look-from", viewpoint->Look(options.Place.LookFrom, options.Place.LookAt, camera));
  }
  else
  {
    LookAtAll(
      camera, terrain.Framed, heights, static_cast<double>(options.Size[0]) / options.Size[1]);
  }
  SetClippingRange(camera, box, heights);
  if (IsInsidePlanet(camera, heights))
  {
    Warn("the eye is inside the planet, whose underside is not drawn: raise it (--look-from "
         "LONGITUDE,LATITUDE,2agl)");
  }
  SetBackground(renderer, options);
  AddLights(renderer, heights, options);
  return renderer;
}

//------------------------------------------------------------------------------
void LeaveRoom(vtkRenderer* renderer, const Terrain& terrain, const PlacedHeights& heights,
  const Options& options, double right)
{
  const bool isPlaced = options.View || !options.Place.LookFrom.empty() || heights.IsGlobe();
  const double title = options.Marks.Title.empty() ? 0.0 : TextPixels(kTitleRoom, options);
  if (isPlaced || (right == 0.0 && title == 0.0))
  {
    return;
  }
  // at least a third of each half is the terrain's
  constexpr double kLeast = 1.0 / 3.0;
  const double width = options.Size[0];
  const double height = options.Size[1];
  const ViewRoom room = { std::max(kLeast, 1.0 - 2.0 * right / width),
    std::max(kLeast, 1.0 - 2.0 * title / height) };
  vtkCamera* camera = renderer->GetActiveCamera();
  LookAtAll(camera, terrain.Framed, heights, width / height, room);
  SetClippingRange(camera, terrain.Bounds, heights);
}
