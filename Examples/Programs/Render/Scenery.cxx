// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenery.h"

#include "Options.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace
{
constexpr RGB kHorizon = { 0.87, 0.91, 0.95 };
constexpr RGB kZenith = { 0.20, 0.42, 0.75 };
const char* const kLightCode = "//VTK::Light::Impl";

/// The sky at an angle above the horizon, in degrees.
RGB SkyAt(double angle)
{
  constexpr double kDeep = 50.0; // from here on as at the zenith
  const double share = std::sqrt(std::clamp(angle / kDeep, 0.0, 1.0));
  RGB color{};
  for (std::size_t k = 0; k < color.size(); ++k)
  {
    color[k] = kHorizon[k] + share * (kZenith[k] - kHorizon[k]);
  }
  return color;
}

std::array<RGB, 2> SkyOf(vtkCamera* camera)
{
  const double middle =
    vtkMath::DegreesFromRadians(std::asin(camera->GetDirectionOfProjection()[2]));
  const double half = 0.5 * camera->GetViewAngle();
  return { SkyAt(middle - half), SkyAt(middle + half) };
}
}

//------------------------------------------------------------------------------
void SetBackground(vtkRenderer* renderer, const Options& options)
{
  const SceneryOptions& scenery = options.Scenery;
  const std::array<RGB, 2> colors =
    scenery.IsSky() ? SkyOf(renderer->GetActiveCamera()) : scenery.GetColors();
  renderer->SetGradientBackground(!scenery.IsTransparent());
  renderer->SetBackground(colors[0][0], colors[0][1], colors[0][2]);
  renderer->SetBackground2(colors[1][0], colors[1][1], colors[1][2]);
  renderer->SetBackgroundAlpha(scenery.IsTransparent() ? 0.0 : 1.0);
}

//------------------------------------------------------------------------------
void AddFog(vtkRenderer* renderer, const Options& options)
{
  if (!(options.Scenery.Fog > 0.0))
  {
    return;
  }
  const double* color = renderer->GetBackground();
  std::ostringstream code;
  code << std::scientific << kLightCode << "\n  gl_FragData[0].rgb = mix(vec3(" << color[0] << ", "
       << color[1] << ", " << color[2]
       << "),\n    gl_FragData[0].rgb, exp2(-1.0 / (gl_FragCoord.w * " << options.Scenery.Fog
       << ")));\n";
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = static_cast<vtkActor*>(actors->GetItemAsObject(i));
    actor->GetShaderProperty()->AddFragmentShaderReplacement(kLightCode, true, code.str(), false);
  }
}
