// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The means of heights (core/HeightMeans.h) as a texture with mip levels, for
 * shaders/vtkTerrainGradient.glsl. Private to the module.
 */
#ifndef vtkTerrainMeanTexture_h
#define vtkTerrainMeanTexture_h

#include "core/HeightMeans.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkTerrainUniforms;
class vtkWindow;

class vtkTerrainMeanTexture
{
public:
  /// The means to be uploaded; change them before Upload().
  terrain::HeightMeans& GetMeans()
  {
    return this->Means;
  }

  /// Uploads all levels; false if that failed. True also if there are none.
  bool Upload(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();
  /// maximumCode: the largest code of the heights.
  void SetUniforms(vtkTerrainUniforms& uniforms, double maximumCode);
  /// Bytes of the texture.
  vtkIdType GetMemorySize() const;

private:
  terrain::HeightMeans Means;
  vtkNew<vtkTextureObject> Texture;
};

#endif
