// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "Canvas.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Scenery.h"
#include "Terrain.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainViewpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace
{
/// Angle of the default view below the horizon, in degrees.
constexpr double kDefaultTilt = 38.0;
/// Part of the picture's width and height that the terrain fills at most in the default view.
constexpr double kFill = 0.94;
/// Intensity of the light of the sun.
constexpr double kSunIntensity = 1.05;
/// Distance of the near plane where the eye is close to the terrain, over the terrain's diagonal.
constexpr double kNearPlane = 0.9e-4;

using Vector = std::array<double, 3>;

/// Bounds along one direction of the picture, seen from a distance: what is at `Low` or `High`
/// along it, plus its place towards the eye, over the slope of the border of the view.
struct Reach
{
  double Low = -VTK_DOUBLE_MAX;
  double High = -VTK_DOUBLE_MAX;

  void Add(double along, double towardsEye, double slope)
  {
    this->Low = std::max(this->Low, towardsEye - along / slope);
    this->High = std::max(this->High, towardsEye + along / slope);
  }
  /// The least distance of the eye that has everything in view, once the view is centred.
  double Distance() const
  {
    return (this->Low + this->High) / 2.0;
  }
  /// Where the centre of the view lies along the direction.
  double Centre(double slope) const
  {
    return slope * (this->High - this->Low) / 2.0;
  }
};

/// From the south, as near as shows the whole box.
void LookFromSouth(vtkCamera* camera, const vtkBoundingBox& box, double aspect)
{
  const double tilt = vtkMath::RadiansFromDegrees(kDefaultTilt);
  const Vector right = { 1.0, 0.0, 0.0 };
  const Vector up = { 0.0, std::sin(tilt), std::cos(tilt) };
  const Vector towardsEye = { 0.0, -std::cos(tilt), std::sin(tilt) };
  const double slopeY = kFill * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
  const double slopeX = slopeY * aspect;
  Vector centre{};
  box.GetCenter(centre.data());
  Reach horizontal;
  Reach vertical;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector point{};
    box.GetCorner(corner, point.data());
    vtkMath::Subtract(point.data(), centre.data(), point.data());
    const double depth = vtkMath::Dot(point.data(), towardsEye.data());
    horizontal.Add(vtkMath::Dot(point.data(), right.data()), depth, slopeX);
    vertical.Add(vtkMath::Dot(point.data(), up.data()), depth, slopeY);
  }
  const double distance = std::max(horizontal.Distance(), vertical.Distance());
  Vector eye{};
  Vector focalPoint{};
  for (int k = 0; k < 3; ++k)
  {
    focalPoint[k] =
      centre[k] + horizontal.Centre(slopeX) * right[k] + vertical.Centre(slopeY) * up[k];
    eye[k] = focalPoint[k] + distance * towardsEye[k];
  }
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
}

/// A part of a globe, from above and the south of its middle; degrees are those of its borders:
/// west, east, south, north. False for what reaches over more than 30 of them.
bool LookAtPartOfGlobe(
  vtkCamera* camera, const std::array<double, 6>& degrees, double radius, double half)
{
  constexpr double kLargest = 30.0;
  constexpr double kRise = 0.78; // as LookFromSouth: so much up for one south
  const double longitude = vtkMath::RadiansFromDegrees(0.5 * (degrees[0] + degrees[1]));
  const double latitude = vtkMath::RadiansFromDegrees(0.5 * (degrees[2] + degrees[3]));
  const double reach =
    std::hypot((degrees[1] - degrees[0]) * std::cos(latitude), degrees[3] - degrees[2]);
  if (reach > kLargest)
  {
    return false;
  }
  const Vector up = { std::cos(latitude) * std::cos(longitude),
    std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
  const Vector south = { std::sin(latitude) * std::cos(longitude),
    std::sin(latitude) * std::sin(longitude), -std::cos(latitude) };
  const double distance =
    0.5 * radius * vtkMath::RadiansFromDegrees(reach) / std::sin(half) / std::hypot(1.0, kRise);
  Vector middle{};
  Vector eye{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = radius * up[axis];
    eye[axis] = middle[axis] + distance * (kRise * up[axis] + south[axis]);
  }
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  return true;
}

/// The whole planet, over the middle of the heights; a little from the north.
void LookAtGlobe(vtkCamera* camera, const vtkBoundingBox& box, vtkImageData* heights, double aspect)
{
  constexpr double kTilt = 20.0;
  constexpr double kSlope = 0.9;
  std::array<double, 6> degrees{};
  heights->GetBounds(degrees.data());
  const double longitude = vtkMath::RadiansFromDegrees(0.5 * (degrees[0] + degrees[1]));
  const double latitude =
    vtkMath::RadiansFromDegrees(kTilt + (1.0 - kTilt / 90.0) * 0.5 * (degrees[2] + degrees[3]));
  const double half = std::atan(kSlope * std::min(aspect, 1.0) *
    std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
  if (LookAtPartOfGlobe(camera, degrees, 0.5 * box.GetMaxLength(), half))
  {
    return;
  }
  const double distance = 0.5 * box.GetMaxLength() / std::sin(half);
  camera->SetPosition(distance * std::cos(latitude) * std::cos(longitude),
    distance * std::cos(latitude) * std::sin(longitude), distance * std::sin(latitude));
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
}

/// From over the left shoulder of who looks at a globe.
void LightGlobe(vtkCamera* camera, vtkLight* sun)
{
  constexpr Vector kFrom = { -0.55, 0.45, 0.7 };
  Vector back{};
  Vector right{};
  Vector up{};
  camera->GetDirectionOfProjection(back.data());
  vtkMath::MultiplyScalar(back.data(), -1.0);
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up.data());
  vtkMath::Cross(up.data(), back.data(), right.data());
  sun->SetPosition(kFrom[0] * right[0] + kFrom[1] * up[0] + kFrom[2] * back[0],
    kFrom[0] * right[1] + kFrom[1] * up[1] + kFrom[2] * back[1],
    kFrom[0] * right[2] + kFrom[1] * up[2] + kFrom[2] * back[2]);
}

}

//------------------------------------------------------------------------------
void SetClippingRange(vtkCamera* camera, const vtkBoundingBox& box)
{
  double nearest = VTK_DOUBLE_MAX;
  double farthest = 0.0;
  Vector eye{};
  Vector direction{};
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(direction.data());
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector point{};
    box.GetCorner(corner, point.data());
    vtkMath::Subtract(point.data(), eye.data(), point.data());
    const double depth = vtkMath::Dot(point.data(), direction.data());
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  constexpr double kSlack = 0.01;
  const double nearPlane = std::max((1.0 - kSlack) * nearest, kNearPlane * box.GetDiagonalLength());
  camera->SetClippingRange(nearPlane, std::max((1.0 + kSlack) * farthest, 2.0 * nearPlane));
}

namespace
{

/// Throws a Failure about an option if there is a reason.
void ThrowIf(const std::string& option, const std::string& why)
{
  if (!why.empty())
  {
    throw Failure(option, why);
  }
}

/// What brings the places and times of the options into the scene.
vtkSmartPointer<vtkTerrainViewpoint> MakeViewpoint(const PlacedHeights& heights)
{
  auto viewpoint = vtkSmartPointer<vtkTerrainViewpoint>::New();
  viewpoint->SetGeoreference(heights.Georeference);
  viewpoint->SetHeights(heights.Image);
  viewpoint->SetExaggeration(heights.Exaggeration);
  return viewpoint;
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
  else if (heights.IsGlobe())
  {
    LookAtGlobe(camera, box, heights.Image, static_cast<double>(options.Size[0]) / options.Size[1]);
  }
  else
  {
    LookFromSouth(camera, terrain.Framed, static_cast<double>(options.Size[0]) / options.Size[1]);
  }
  SetClippingRange(camera, box);
  SetBackground(renderer, options);
  AddLights(renderer, heights, options);
  return renderer;
}
