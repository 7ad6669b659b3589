// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fields of unit tests, with their pyramids, as the textures and uniforms of shaders.
 */
#ifndef vtkTerrainTestTextures_h
#define vtkTerrainTestTextures_h

#include "../Unit/UnitTestDetail.h"
#include "render/Driver.h"
#include "render/Features.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>

namespace vtkTerrainTesting
{
inline void PrepareTexture(
  vtkRenderWindow* window, vtkTextureObject* texture, unsigned int internal, unsigned int format)
{
  texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetInternalFormat(internal);
  texture->SetFormat(format);
}

/// Uploads the texels of a field and activates the texture.
template <typename Texel>
void UploadTexels(
  vtkRenderWindow* window, vtkTextureObject* texture, glm::uvec2 size, const Texel* texels)
{
  constexpr bool integer = std::is_integral_v<Texel>;
  PrepareTexture(window, texture, integer ? GL_R16UI : GL_R32F, integer ? GL_RED_INTEGER : GL_RED);
  texture->Create2DFromRaw(size.x, size.y, 1, integer ? VTK_UNSIGNED_SHORT : VTK_FLOAT,
    const_cast<Texel*>(texels)); // which VTK does not change
  texture->Activate();
}

/// Uploads a pyramid and activates the texture.
template <typename Texel>
void UploadPyramid(
  vtkRenderWindow* window, vtkTextureObject* texture, const terrain::MinMaxPyramid<Texel>& pyramid)
{
  constexpr bool integer = std::is_integral_v<Texel>;
  PrepareTexture(window, texture, integer ? GL_RG16UI : GL_RG32F, integer ? GL_RG_INTEGER : GL_RG);
  texture->SetMinificationFilter(vtkTextureObject::NearestMipmapNearest);
  texture->SetMaxLevel(pyramid.LevelCount() - 1);
  for (int level = 1; level <= pyramid.LevelCount(); ++level)
  {
    const glm::uvec2 nodes(pyramid.LevelSize(level));
    auto* data = const_cast<terrain::PyramidNode<Texel>*>(pyramid.LevelNodes(level));
    if (level == 1)
    {
      texture->Create2DFromRaw(nodes.x, nodes.y, 2, integer ? VTK_UNSIGNED_SHORT : VTK_FLOAT, data);
      texture->Activate();
      glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    }
    else
    {
      glTexImage2D(GL_TEXTURE_2D, level - 1, integer ? GL_RG16UI : GL_RG32F,
        static_cast<int>(nodes.x), static_cast<int>(nodes.y), 0, integer ? GL_RG_INTEGER : GL_RG,
        integer ? GL_UNSIGNED_SHORT : GL_FLOAT, data);
    }
  }
}

/// The same as a buffer.
template <typename Texel>
void UploadPyramidBuffer(vtkRenderWindow* window, vtkTextureObject* texture,
  vtkOpenGLBufferObject* buffer, const terrain::MinMaxPyramid<Texel>& pyramid)
{
  constexpr bool integer = std::is_integral_v<Texel>;
  PrepareTexture(window, texture, integer ? GL_RG16UI : GL_RG32F, integer ? GL_RG_INTEGER : GL_RG);
  buffer->Upload(pyramid.AllNodes(), pyramid.NumberOfNodes(), vtkOpenGLBufferObject::TextureBuffer);
  texture->CreateTextureBuffer(static_cast<unsigned int>(pyramid.NumberOfNodes()), 2,
    integer ? VTK_UNSIGNED_SHORT : VTK_FLOAT, buffer);
  texture->Activate();
}

/// Sets the uniforms that a heightfield and a sum have in common.
template <typename Coded>
void SetCodedUniforms(vtkShaderProgram* program, const Coded& coded)
{
  program->SetUniform2i("terrainSize", &coded.heights.size[0]);
  program->SetUniformf("terrainMaximumCode", coded.heights.maximumCode);
  program->SetUniformi("terrainPyramidTop", coded.pyramid->LevelCount());
  program->SetUniformi("terrainPyramidStart", coded.start);
}

/// Sets where the levels of a pyramid begin in a buffer.
template <typename Texel>
void SetPyramidLayout(vtkShaderProgram* program, const char* parts, const char* levels,
  const terrain::MinMaxPyramid<Texel>& pyramid)
{
  const terrain::PyramidLayout& layout = pyramid.GetLayout();
  const glm::ivec2 nodes(layout.Quarters, layout.Halves);
  program->SetUniform2i(parts, &nodes[0]);
  program->SetUniformi(levels, layout.Top);
}

/// A field on the GPU.
template <typename Texel>
class FieldTextures
{
public:
  static constexpr bool Integer = std::is_integral_v<Texel>;

  /// The pyramid as a buffer, or as a texture with mip levels.
  FieldTextures(vtkRenderWindow* window, const terrain::CodedField<Texel>& field, bool inBuffer)
    : Coded(field.Coded)
    , Field(field)
    , InBuffer(inBuffer)
  {
    UploadTexels(window, this->Heights, glm::uvec2(field.Coded.heights.size), field.Texels.data());
    if (inBuffer)
    {
      UploadPyramidBuffer(window, this->Pyramid, this->Buffer, field.Pyramid);
    }
    else
    {
      UploadPyramid(window, this->Pyramid, field.Pyramid);
    }
  }
  FieldTextures(const FieldTextures&) = delete;
  FieldTextures& operator=(const FieldTextures&) = delete;
  ~FieldTextures()
  {
    this->Heights->Deactivate();
    this->Pyramid->Deactivate();
  }

  /// What programs that read them are built for.
  terrain::Features GetFeatures() const
  {
    terrain::Features features;
    features.Way = terrain::Features::Ways::Pyramid;
    features.IntegerHeights = Integer;
    features.Gathers = terrain::Driver().Gathers;
    features.Columns = this->Coded.columns;
    features.BuffersPyramid = this->InBuffer;
    return features;
  }

  void SetUniforms(vtkShaderProgram* program)
  {
    const glm::ivec2 nodes = this->Field.Pyramid.LevelSize(1);
    program->SetUniformi("terrainHeights", this->Heights->GetTextureUnit());
    program->SetUniformi("terrainPyramid", this->Pyramid->GetTextureUnit());
    program->SetUniformf("terrainBias", static_cast<float>(this->Coded.heights.bias));
    program->SetUniform2i("terrainPyramidSize", &nodes[0]);
    SetPyramidLayout(program, "terrainPyramidLayout", "terrainPyramidLevels", this->Field.Pyramid);
    SetCodedUniforms(program, this->Coded);
  }

  const terrain::CodedPyramid<Texel>& Coded;

private:
  const terrain::CodedField<Texel>& Field;
  bool InBuffer;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Heights;
  vtkNew<vtkTextureObject> Pyramid;
};

/// A field with detail on the GPU.
template <typename Texel>
class SumTextures
{
public:
  static constexpr bool Integer = std::is_integral_v<Texel>;

  SumTextures(vtkRenderWindow* window, const terrain::CodedSum<Texel>& sum)
    : Coded(sum.Coded)
    , Sum(sum)
    , Base(window, sum.Base, Integer)
  {
    UploadTexels(
      window, this->Detail, glm::uvec2(sum.Coded.heights.period), sum.Detail.Texels.data());
    if (Integer)
    {
      UploadPyramidBuffer(window, this->DetailPyramid, this->DetailBuffer, sum.Nodes.Pyramid);
    }
    else
    {
      UploadPyramid(window, this->DetailPyramid, sum.Nodes.Pyramid);
    }
  }
  SumTextures(const SumTextures&) = delete;
  SumTextures& operator=(const SumTextures&) = delete;
  ~SumTextures()
  {
    this->Detail->Deactivate();
    this->DetailPyramid->Deactivate();
  }

  /// Filters the detail between its samples and levels, as where it is drawn.
  void FilterDetail()
  {
    this->Detail->SetWrapS(vtkTextureObject::Repeat);
    this->Detail->SetWrapT(vtkTextureObject::Repeat);
    this->Detail->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    this->Detail->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Detail->SetMaxLevel(1000);
    this->Detail->Activate();
    this->Detail->SendParameters();
    glGenerateMipmap(GL_TEXTURE_2D);
  }

  terrain::Features GetFeatures() const
  {
    terrain::Features features = this->Base.GetFeatures();
    features.Detail = true;
    return features;
  }

  void SetUniforms(vtkShaderProgram* program)
  {
    const auto& heights = this->Coded.heights;
    this->Base.SetUniforms(program);
    program->SetUniformi("terrainDetail", this->Detail->GetTextureUnit());
    program->SetUniformi("terrainDetailPyramid", this->DetailPyramid->GetTextureUnit());
    program->SetUniform2i("terrainDetailPeriod", &heights.period[0]);
    program->SetUniformi("terrainDetailLevel", heights.level);
    program->SetUniformf("terrainDetailScale", heights.scale);
    program->SetUniformi("terrainDetailTop", terrain::WholeLevels(heights.period));
    program->SetUniformf("terrainDetailMaximum", heights.scale * this->Sum.Nodes.Maximum);
    program->SetUniformf("terrainDetailUnit", heights.scale * this->Sum.Nodes.Unit);
    SetPyramidLayout(
      program, "terrainDetailLayout", "terrainDetailLevels", this->Sum.Nodes.Pyramid);
    SetCodedUniforms(program, this->Coded);
  }

  const terrain::CodedPyramid<terrain::WithDetail<Texel>>& Coded;

private:
  const terrain::CodedSum<Texel>& Sum;
  FieldTextures<Texel> Base;
  vtkNew<vtkTextureObject> Detail;
  vtkNew<vtkOpenGLBufferObject> DetailBuffer;
  vtkNew<vtkTextureObject> DetailPyramid;
};

}

#endif
