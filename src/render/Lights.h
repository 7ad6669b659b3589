// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The lights of a renderer that cast shadows over a surface; uniforms of
 * shaders/vtkTerrainLight.glsl. Private to the module.
 */
#ifndef vtkTerrain_render_Lights_h
#define vtkTerrain_render_Lights_h

#include "core/rays/ShadowBounds.h"
#include "render/Features.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

class vtkLight;
class vtkRenderer;

namespace terrain
{
class Uniforms;
class View;

class Lights
{
public:
  /// Looks at a renderer's lights. sunAngle: angular diameter, in degrees, of the lights that are
  /// infinitely far away; lamps, which have a place, are points. Lights that are off, headlights
  /// (whose shadows nobody sees), lights without attenuation of shadows or without a finite
  /// direction cast none. On a globe, where each place has a horizon of its own, a sun is the point
  /// in its middle. Returns an empty string, or what is not drawn.
  std::string Update(vtkRenderer* renderer, const View& view, double sunAngle, bool isGlobe);
  /// None casts shadows.
  void Clear()
  {
    this->Mask = 0;
    this->Steady = -1;
  }
  /// Features::ShadowMask.
  int GetMask() const
  {
    return this->Mask;
  }
  void SetUniforms(Uniforms& uniforms) const;

  ///@{
  /// A sun above the horizon that does not move with the camera, of which bounds are worth while:
  /// its rays, if there is one.
  bool HasSteadySun() const
  {
    return this->Steady >= 0;
  }
  const ShadowRays& GetSteadyRays() const
  {
    return this->SteadyRays;
  }
  ///@}

private:
  bool Add(vtkLight* light, const glm::dmat4& viewFromWorld, const View& view, double sunAngle,
    bool isGlobe);
  bool AddSun(const glm::dvec3& wayVC, const View& view, double sunAngle, bool isSteady);

  int Mask = 0;
  int Count = 0;
  int Steady = -1; ///< of those that cast
  ShadowRays SteadyRays;
  std::array<glm::vec4, kMostShadows> WaysGC{};
  std::array<glm::vec4, kMostShadows> WaysVC{};
  std::array<glm::vec4, kMostShadows> Discs{};
};
}
#endif
