// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mean slopes of heights (core/surface/HeightSlopes.h) as a texture with mip levels, for
 * shaders/vtkTerrainGradient.glsl. Private to the module.
 */
#ifndef vtkTerrain_render_SlopeTexture_h
#define vtkTerrain_render_SlopeTexture_h

#include "core/surface/HeightSlopes.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class SlopeTexture
{
public:
  /// The slopes to be uploaded; change them before Upload().
  HeightSlopes& GetSlopes()
  {
    return this->Slopes;
  }

  /// Uploads all levels, and forgets them; false if that failed. True also if there are none.
  bool Upload(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);
  /// Bytes of the texture.
  vtkIdType GetMemorySize() const
  {
    return this->MemorySize;
  }

private:
  HeightSlopes Slopes;
  vtkIdType MemorySize = 0;
  vtkNew<vtkTextureObject> Texture;
};
}
#endif
