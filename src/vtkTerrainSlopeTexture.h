// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The mean slopes of heights (core/HeightSlopes.h) as a texture with mip levels, for
 * shaders/vtkTerrainGradient.glsl. Private to the module.
 */
#ifndef vtkTerrainSlopeTexture_h
#define vtkTerrainSlopeTexture_h

#include "core/HeightSlopes.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkTerrainUniforms;
class vtkWindow;

class vtkTerrainSlopeTexture
{
public:
  /// The slopes to be uploaded; change them before Upload().
  terrain::HeightSlopes& GetSlopes()
  {
    return this->Slopes;
  }

  /// Uploads all levels; false if that failed. True also if there are none.
  bool Upload(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();
  void SetUniforms(vtkTerrainUniforms& uniforms);
  /// Bytes of the texture.
  vtkIdType GetMemorySize() const;

private:
  terrain::HeightSlopes Slopes;
  vtkNew<vtkTextureObject> Texture;
};

#endif
