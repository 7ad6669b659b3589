// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The share of the sky that is seen from all over a surface, on the GPU: texture and uniforms of
 * shaders/vtkTerrainSky.glsl. Private to the module.
 *
 * It is the sky view factor of core/rays/SkyView.h, from horizons in kSkyDirections directions on
 * the processor, once for each image of heights and exaggeration. Of grids with more than
 * kMostSkySamples samples the means over squares of 2^level samples are looked at.
 */
#ifndef vtkTerrain_render_SkyTexture_h
#define vtkTerrain_render_SkyTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

/// Directions of the horizons of a sample.
constexpr int kSkyDirections = 16;
/// Most samples whose horizons are looked for.
constexpr int kMostSkySamples = 1 << 20;

class SkyTexture
{
public:
  /// Brings the texture up to date with heights drawn at an exaggeration; false if that failed.
  bool Upload(vtkOpenGLRenderWindow* window, vtkImageData* heights, double exaggeration);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);

private:
  vtkWeakPointer<vtkImageData> Heights;
  vtkMTimeType HeightsTime = 0;
  double Exaggeration = 0.0;
  /// Texture coordinates a sample.
  glm::dvec2 Scale{ 1.0 };
  vtkNew<vtkTextureObject> Texture;
};
}
#endif
