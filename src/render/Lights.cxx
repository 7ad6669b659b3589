// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Lights.h"

#include "core/grid/Constants.h"
#include "render/Uniforms.h"
#include "render/View.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Steepest edge of a sun's disc, in degrees: tangents stay finite.
constexpr double kSteepest = 89.99;

/// Tangent of an altitude in degrees.
double TangentOf(double altitude)
{
  return std::tan(std::clamp(altitude, -kSteepest, kSteepest) * kDegree);
}
}

//------------------------------------------------------------------------------
// VTK numbers the lights that are on, in their order.
std::string Lights::Update(vtkRenderer* renderer, const View& view, double sunAngle, bool isGlobe)
{
  const CameraMatrices camera(renderer);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie = nullptr;
  lights->InitTraversal(cookie);
  this->Clear();
  this->Count = 0;
  std::string words;
  int number = 0;
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const bool casts = !light->LightTypeIsHeadlight() && light->GetShadowAttenuation() > 0.0f;
    if (casts && number >= kMostShadows)
    {
      words = "Only the first " + std::to_string(kMostShadows) + " lights cast shadows";
    }
    else if (casts && this->Add(light, camera.ViewFromWorld, view, sunAngle, isGlobe))
    {
      this->Mask |= 1 << number;
    }
    ++number;
  }
  return words;
}

//------------------------------------------------------------------------------
bool Lights::Add(
  vtkLight* light, const glm::dmat4& viewFromWorld, const View& view, double sunAngle, bool isGlobe)
{
  glm::dvec3 position;
  glm::dvec3 focus;
  light->GetTransformedPosition(&position[0]);
  light->GetTransformedFocalPoint(&focus[0]);
  const auto index = static_cast<std::size_t>(this->Count);
  const double taken = std::min(static_cast<double>(light->GetShadowAttenuation()), 1.0);
  this->Discs[index] = glm::vec4(glm::dvec4(0.0, 0.0, 1.0, taken));
  this->WaysGC[index] = glm::vec4(0.0f);
  if (light->GetPositional())
  {
    const glm::dvec4 placeVC = viewFromWorld * glm::dvec4(position, 1.0);
    this->WaysVC[index] = glm::vec4(glm::dvec4(glm::dvec3(placeVC) / placeVC.w, 1.0));
  }
  else
  {
    const glm::dvec3 wayVC = glm::dmat3(viewFromWorld) * (position - focus);
    const double length = glm::length(wayVC);
    if (!(length > 0.0) || !std::isfinite(length))
    {
      return false;
    }
    this->WaysVC[index] = glm::vec4(glm::dvec4(wayVC / length, 0.0));
    if (!isGlobe && !this->AddSun(wayVC, view, sunAngle, light->LightTypeIsSceneLight()))
    {
      return false;
    }
  }
  ++this->Count;
  return true;
}

//------------------------------------------------------------------------------
bool Lights::AddSun(const glm::dvec3& wayVC, const View& view, double sunAngle, bool isSteady)
{
  const auto index = static_cast<std::size_t>(this->Count);
  const glm::dvec3 way = glm::dmat3(view.GetModelFromView()) * wayVC;
  const glm::dvec3 wayGC = glm::dmat3(view.GetGridFromView()) * wayVC;
  const double across = glm::length(glm::dvec2(way));
  const double cells = glm::length(glm::dvec2(wayGC));
  const double altitude = std::atan2(way.z, across) / kDegree;
  if (!(glm::length(way) > 0.0) || !std::isfinite(glm::length(way) + cells))
  {
    return false;
  }
  if (std::abs(altitude) > kSteepest)
  {
    this->WaysGC[index] = glm::vec4(0.0, 0.0, way.z, way.z);
    this->WaysVC[index] = glm::vec4(0.0f);
    return true;
  }
  const double codes =
    view.GetHeightOfCode() * cells / across; // tangent in the model over that in codes
  const double radius = std::clamp(0.5 * sunAngle, 0.0, 90.0);
  this->WaysGC[index] = glm::vec4(glm::dvec2(wayGC) / cells, TangentOf(altitude - radius) / codes,
    TangentOf(altitude + radius) / codes);
  this->WaysVC[index] = glm::vec4(glm::dvec4(wayVC / cells, 0.0));
  if (this->Steady < 0 && isSteady && this->WaysGC[index].z > 0.0f)
  {
    this->Steady = this->Count;
    this->SteadyRays = { glm::dvec2(wayGC) / cells, TangentOf(altitude - radius) / codes,
      TangentOf(altitude + radius) / codes };
  }
  this->Discs[index] =
    glm::vec4(glm::dvec4(altitude * kDegree, radius * kDegree, codes, this->Discs[index].w));
  return true;
}

//------------------------------------------------------------------------------
void Lights::SetUniforms(Uniforms& uniforms) const
{
  if (this->Count > 0 && uniforms.Uses("terrainLightDiscs"))
  {
    uniforms.SetArray("terrainLightsGC", this->Count, this->WaysGC.data());
    uniforms.SetArray("terrainLightsVC", this->Count, this->WaysVC.data());
    uniforms.SetArray("terrainLightDiscs", this->Count, this->Discs.data());
    uniforms.Set("terrainBoundedLight", this->Steady);
  }
}
}
