// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A min-max pyramid (core/surface/MinMaxPyramid.h) for shaders/vtkTerrainPyramid.glsl: a texture
 * whose mip levels are its levels or, where the driver is faster so (Driver.h), a buffer of all
 * nodes. Private to the module.
 */
#ifndef vtkTerrain_render_PyramidTexture_h
#define vtkTerrain_render_PyramidTexture_h

#include "core/surface/MinMaxPyramid.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class PyramidTexture
{
public:
  /// Uploads all levels; false if that failed. True also if there are none. Texel: unsigned short
  /// or float.
  template <typename Texel>
  bool Upload(vtkOpenGLRenderWindow* window, const MinMaxPyramid<Texel>& pyramid);
  /// Uploads the nodes of a rectangle of a level, which have changed.
  template <typename Texel>
  void UploadPart(const MinMaxPyramid<Texel>& pyramid, int level, const GridRectangle& nodes);
  void ReleaseGraphicsResources(vtkWindow* window);
  void Activate();
  void Deactivate();

  /// True if it is a buffer, TERRAIN_PYRAMID_BUFFER in shaders.
  bool IsBuffer() const
  {
    return this->InBuffer;
  }
  /// The uniforms with these names: the texture, and Quarters and Halves and Top of its layout.
  void SetUniforms(Uniforms& uniforms, const char* texture, const char* parts, const char* levels);

private:
  template <typename Texel>
  bool UploadBuffer(const MinMaxPyramid<Texel>& pyramid);
  template <typename Texel>
  bool UploadLevels(const MinMaxPyramid<Texel>& pyramid);

  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  bool InBuffer = false;
  PyramidLayout Layout;
};
}
#endif
