// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Bounds of what stands before the rays of one sun, on the GPU: texture and uniforms of
 * shaders/vtkTerrainOutlook.glsl. Private to the module.
 */
#ifndef vtkTerrain_render_ShadowBoundsTexture_h
#define vtkTerrain_render_ShadowBoundsTexture_h

#include "core/rays/ShadowBounds.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <functional>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class ShadowBoundsTexture
{
public:
  /// What the bounds are made from: another key, other bounds.
  struct Key
  {
    ShadowRays Rays;
    bool Complete = false;        ///< nothing is cut away
    vtkMTimeType PyramidTime = 0; ///< SurfaceTextures::GetPyramidTime()
    double HeightOfCode = 0.0;
  };

  /// Uploads bounds, which are made if the key or the window is another one; false if that failed.
  bool Upload(
    vtkOpenGLRenderWindow* window, const Key& key, const std::function<ShadowBounds()>& make);
  /// Number of times that bounds were made.
  int GetNumberOfBuilds() const
  {
    return this->NumberOfBuilds;
  }
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);

private:
  Key MadeFrom;
  int NumberOfBuilds = 0;
  /// Without its texels.
  ShadowBounds Bounds;
  vtkNew<vtkTextureObject> Texture;
};
}
#endif
