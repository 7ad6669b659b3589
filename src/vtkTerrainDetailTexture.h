// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detail heights on the GPU: one period of codes and its pyramid (core/DetailHeights.h). Private to
 * the module.
 */
#ifndef vtkTerrainDetailTexture_h
#define vtkTerrainDetailTexture_h

#include "vtkTerrainPyramidTexture.h"

#include "core/DetailHeights.h"
#include "core/HeightCodes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTerrainUniforms;
class vtkWindow;

class vtkTerrainDetailTexture
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
  const terrain::HeightCodes& GetCodes() const
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
  void SetUniforms(vtkTerrainUniforms& uniforms, int level, double scale);

  /// Bytes of the textures.
  vtkIdType GetMemorySize() const;

private:
  bool UploadHeights();

  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  vtkMTimeType UploadTime = 0;
  terrain::HeightCodes Codes;
  glm::ivec2 Period{ 1, 1 };
  std::vector<float> Texels;
  terrain::DetailNodes Nodes;
  vtkNew<vtkTextureObject> Texture;
  vtkTerrainPyramidTexture PyramidTexture;
};

#endif
