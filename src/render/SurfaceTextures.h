// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One surface on the GPU: the texture of its height codes (core/grid/HeightCodes.h), uploaded when
 * the image that holds them has changed, with their pyramid and their mean slopes; the detail that
 * is added to them, if there is any; and the textures of its colours. Private to the module.
 *
 * Host memory beside the image: the pyramid, 2/3 of the texels' bytes, and the sums of the slopes,
 * by which parts are brought up to date. The texels are encoded anew where they are needed.
 */
#ifndef vtkTerrain_render_SurfaceTextures_h
#define vtkTerrain_render_SurfaceTextures_h

#include "render/DetailTexture.h"
#include "render/Paint.h"
#include "render/PyramidTexture.h"
#include "render/SlopeTexture.h"
#include "render/TileTextures.h"

#include "core/grid/Coordinates.h"
#include "core/grid/HeightCodes.h"
#include "core/rays/ShadowBounds.h"
#include "core/surface/MinMaxPyramid.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <variant>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

/// Most nodes a side of bounds of shadows.
constexpr int kMostBoundNodes = 1024;

class SurfaceTextures
{
public:
  /// Takes over the image: size, place and range of the heights. Returns an empty string, or one
  /// sentence that says why the image cannot be used.
  std::string SetImage(vtkImageData* image);

  /// Null if there is none, or it cannot be used.
  vtkImageData* GetImage()
  {
    return this->Image;
  }

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

  /// Takes over a part of the image that was taken over before, and of which nothing else has
  /// changed since. Where the part's heights do not fit the codes in use, or the image is another
  /// one, it is left to SetImage() to take it over whole.
  void SetImagePart(vtkImageData* image, GridRectangle samples);

  /// Uploads the heights, and their pyramid if it is wanted, or the parts of both that have changed
  /// since the last upload; all of them if the window is another one. Returns an empty string, or
  /// one sentence that says why that failed.
  std::string Upload(vtkOpenGLRenderWindow* window, bool withPyramid);

  void ReleaseGraphicsResources(vtkWindow* window);

  /// The tiles that are drawn in place of the image, which is a level of theirs: where they have a
  /// source and are in use.
  TileTextures Tiles;
  /// Whether tiles are used if they have a source; call it before SetDetail().
  void SetUseTiles(bool use)
  {
    this->UseTiles = use;
  }
  bool HasTiles() const
  {
    return this->UseTiles && this->Tiles.HasSource();
  }

  /// The colours; call its Update() after Upload() and before Activate().
  Paint Colors;

  /// Makes the textures current for drawing and sets their uniforms
  /// (shaders/vtkTerrainHeights.glsl, vtkTerrainPyramid.glsl, vtkTerrainGradient.glsl,
  /// vtkTerrainColor.glsl).
  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms, const GridGeometry& geometry, const vtkTerrainLook* look);
  /// Adds what shaders have to know of these textures.
  void AddFeatures(Features& features) const;

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

  /// Bounds of what stands before rays (core/rays/ShadowBounds.h), of nodes of which there are at
  /// most kMostBoundNodes a side; complete: nothing is cut away. There must be a pyramid.
  ShadowBounds MakeShadowBounds(const ShadowRays& rays, bool complete) const;
  /// Changes with the pyramid; 0 if there is none.
  vtkMTimeType GetPyramidTime() const
  {
    return this->PyramidTime + static_cast<vtkMTimeType>(this->NumberOfUploadedTexels);
  }

  /// Top level of the pyramid on the graphics card.
  int GetPyramidTop() const
  {
    return this->HasTiles() ? this->Tiles.GetPyramidTop() : this->PyramidTop;
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
  /// Texels of all samples, of which a rectangle has been encoded: memory that is never written is
  /// never taken.
  template <typename Texel>
  using Texels = std::unique_ptr<Texel[]>;

  template <typename Texel>
  Texels<Texel> Encode(const GridRectangle& samples) const;
  template <typename Texel>
  HeightfieldView<Texel> TexelView(const Texels<Texel>& texels) const;
  template <typename Texel>
  bool UploadWhole(
    vtkOpenGLRenderWindow* window, MinMaxPyramid<Texel>& pyramid, bool heights, bool withPyramid);
  template <typename Texel>
  void UploadPart(MinMaxPyramid<Texel>& pyramid, const GridRectangle& samples);
  template <typename Texel>
  void SendTexels(const Texels<Texel>& texels, const GridRectangle& part);
  std::string Prepare(vtkOpenGLRenderWindow* window);
  std::string SetTiledSum();

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
  /// Kept so that parts can be brought up to date.
  std::variant<MinMaxPyramid<unsigned short>, MinMaxPyramid<float>> Pyramid;
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
  bool UseTiles = false;
  /// The tiles' level that the image is.
  int ImageLevel = 0;
  double DetailScale = 1.0;
  vtkNew<vtkTextureObject> Texture;
  PyramidTexture Extremes;
  int NumberOfUploads = 0;
  vtkIdType NumberOfUploadedTexels = 0;
};
}
#endif
