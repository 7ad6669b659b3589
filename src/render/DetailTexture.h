// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detail heights on the GPU: one period of codes and its pyramid (core/surface/DetailHeights.h).
 * Private to the module.
 */
#ifndef vtkTerrain_render_DetailTexture_h
#define vtkTerrain_render_DetailTexture_h

#include "render/PyramidTexture.h"

#include "core/grid/HeightCodes.h"
#include "core/surface/DetailHeights.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class DetailTexture
{
public:
  /// Takes over the image of one period, null for no detail: its codes and their pyramid. Returns
  /// an empty string, or one sentence that says why the image cannot be used.
  std::string SetImage(vtkImageData* image);

  bool HasDetail() const
  {
    return this->Image != nullptr;
  }
  /// How heights of the detail, not scaled, are coded.
  const HeightCodes& GetCodes() const
  {
    return this->Codes;
  }

  /// Uploads what has changed since the last upload; false if that failed.
  bool Upload(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();

  /// The uniforms of shaders/vtkTerrainHeights.glsl and shaders/vtkTerrainPyramid.glsl under
  /// TERRAIN_DETAIL; scale: height codes of the base per code of the detail.
  void SetUniforms(Uniforms& uniforms, int level, double scale);

  /// Bytes of the textures.
  vtkIdType GetMemorySize() const;

private:
  bool UploadHeights();

  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  vtkMTimeType UploadTime = 0;
  HeightCodes Codes;
  glm::ivec2 Period{ 1, 1 };
  std::vector<float> Texels;
  DetailNodes Nodes;
  vtkNew<vtkTextureObject> Texture;
  PyramidTexture Extremes;
};
}
#endif
