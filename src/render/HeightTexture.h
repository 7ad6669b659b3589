// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights on the GPU: one texture of height codes (core/grid/HeightCodes.h), uploaded when the
 * image that holds them has changed; and, if there is any, the detail that is added to them.
 * Private to the module.
 */
#ifndef vtkTerrain_render_HeightTexture_h
#define vtkTerrain_render_HeightTexture_h

#include "render/DetailTexture.h"
#include "render/PyramidTexture.h"
#include "render/SlopeTexture.h"

#include "core/grid/Coordinates.h"
#include "core/grid/HeightCodes.h"
#include "core/surface/MinMaxPyramid.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <string>
#include <variant>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class HeightTexture
{
public:
  /// Takes over the image: size, place and range of the heights. Returns an empty string, or one
  /// sentence that says why the image cannot be used.
  std::string SetImage(vtkImageData* image);

  /// Takes over an image of detail, null for none; call it after SetImage(). There are 2^level
  /// cells of the detail along a cell of the heights, and scale times its heights is added. Returns
  /// an empty string, or one sentence that says why the image cannot be used.
  std::string SetDetail(vtkImageData* detail, int level, double scale);
  bool HasDetail() const
  {
    return this->Detail.HasDetail();
  }
  /// log2 of the detail's cells along a cell of the heights; 0 without detail.
  int GetDetailLevel() const
  {
    return this->HasDetail() ? this->DetailLevel : 0;
  }

  /// Lowest and highest height that the detail adds, in height units; 0, 0 without detail.
  glm::dvec2 GetDetailRange() const;
  /// A height below all heights without detail, and above the floor of their coarse mesh.
  double GetFloorThreshold() const;

  /// Takes over a part of the image that was taken over before, and of which nothing else has
  /// changed since. Where the part's heights do not fit the codes in use, or the image is another
  /// one, it is left to SetImage() to take it over whole.
  void SetImagePart(vtkImageData* image, GridRectangle samples);

  /// Uploads the heights, and their pyramid if it is wanted, or the parts of both that have changed
  /// since the last upload; all of them if the window is another one. Returns an empty string, or
  /// one sentence that says why that failed.
  std::string Upload(vtkOpenGLRenderWindow* window, bool withPyramid);

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Makes the textures current for drawing and sets their uniforms
  /// (shaders/vtkTerrainHeights.glsl, shaders/vtkTerrainPyramid.glsl).
  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);

  ///@{
  /// Codes, place and samples of the surface: of the sum, if there is detail.
  const HeightCodes& GetCodes() const
  {
    return this->Sum.Codes;
  }
  const GridGeometry& GetGeometry() const
  {
    return this->Sum.Geometry;
  }
  glm::ivec2 GetSize() const
  {
    return this->Sum.Size;
  }
  ///@}
  /// True if there is at least one cell and one height.
  bool HasSurface() const;

  /// True if the pyramid is a buffer, TERRAIN_PYRAMID_BUFFER in shaders.
  bool HasPyramidBuffer() const
  {
    return this->Extremes.IsBuffer();
  }
  /// Top level of the pyramid on the graphics card.
  int GetPyramidTop() const
  {
    return this->PyramidTop;
  }

  /// Number of uploads of all heights so far, and of the texels sent in all, those of the pyramid
  /// included, for tests that count them.
  int GetNumberOfUploads() const
  {
    return this->NumberOfUploads;
  }
  vtkIdType GetNumberOfUploadedTexels() const
  {
    return this->NumberOfUploadedTexels;
  }
  /// Bytes of the textures.
  vtkIdType GetMemorySize() const;

private:
  /// The texels and their pyramid, kept so that a window of them can be brought up to date.
  template <typename Texel>
  struct Store
  {
    std::vector<Texel> Texels;
    MinMaxPyramid<Texel> Pyramid;
  };

  template <typename Texel>
  HeightfieldView<Texel> TexelView(const Store<Texel>& store) const;
  template <typename Texel>
  bool UploadHeights(Store<Texel>& store);
  template <typename Texel>
  bool UploadPyramid(vtkOpenGLRenderWindow* window, Store<Texel>& store);
  template <typename Texel>
  void UploadPart(Store<Texel>& store, const GridRectangle& samples);
  template <typename Texel>
  void SendTexels(const Store<Texel>& store, const GridRectangle& part);
  std::string Prepare(vtkOpenGLRenderWindow* window);

  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  vtkMTimeType WholeTime = 0;
  int ScalarType = 0;
  /// What has changed since the last upload.
  std::vector<GridRectangle> Parts;
  vtkMTimeType UploadTime = 0;
  vtkMTimeType PyramidTime = 0;
  HeightCodes Codes;
  GridGeometry Geometry;
  glm::ivec2 Size{ 0, 0 };
  std::variant<Store<unsigned short>, Store<float>> Data;
  glm::ivec2 PyramidSize{ 0, 0 };
  int PyramidTop = 0;
  struct Surface
  {
    HeightCodes Codes;
    GridGeometry Geometry;
    glm::ivec2 Size{ 0, 0 };
  };
  Surface Sum;
  DetailTexture Detail;
  SlopeTexture Slopes;
  int DetailLevel = 0;
  double DetailScale = 1.0;
  vtkNew<vtkTextureObject> Texture;
  PyramidTexture Extremes;
  int NumberOfUploads = 0;
  vtkIdType NumberOfUploadedTexels = 0;
};
}
#endif
