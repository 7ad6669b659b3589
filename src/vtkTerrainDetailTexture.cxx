// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDetailTexture.h"

#include "vtkTerrainGL.h"
#include "vtkTerrainHeightfield.h"
#include "vtkTerrainParallelFor.h"
#include "vtkTerrainUniforms.h"

#include "core/DetailHeights.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::string vtkTerrainDetailTexture::SetImage(vtkImageData* image)
{
  if (image == this->Image && (!image || image->GetMTime() == this->ImageTime))
  {
    return {};
  }
  this->Image = nullptr;
  if (!image)
  {
    return {};
  }
  std::string why = vtkTerrainHeightfield::WhyNotHeights(image);
  if (!why.empty())
  {
    return "detail: " + why;
  }
  this->Period = { image->GetDimensions()[0], image->GetDimensions()[1] };
  vtkTerrainHeightfield::Dispatch(image,
    [this](const auto& view)
    {
      this->Codes =
        terrain::ChooseHeightCodes(terrain::FindHeightRange(view, vtkTerrainParallelFor));
      this->Codes.Format = terrain::HeightCodes::TexelFormat::Float32;
      this->Codes.Bias = 0;
      this->Texels.resize(static_cast<std::size_t>(view.Width * view.Height));
      terrain::EncodeHeights(view, this->Codes, 0, view.Width, 0, view.Height, this->Texels.data(),
        vtkTerrainParallelFor);
    });
  if (this->Codes.HasNoData || !this->Codes.HasData)
  {
    return "detail: every sample needs a height";
  }
  const std::vector<float> wrapped = terrain::WrapPeriod(this->Texels.data(), this->Period);
  terrain::HeightfieldView<float> view;
  view.Samples = wrapped.data();
  view.Width = this->Period.x + 1;
  view.Height = this->Period.y + 1;
  this->Pyramid.Build(view, vtkTerrainParallelFor);
  this->Image = image;
  this->ImageTime = image->GetMTime();
  return {};
}

//------------------------------------------------------------------------------
bool vtkTerrainDetailTexture::UploadLevels()
{
  const glm::uvec2 size(this->Period);
  const glm::uvec2 nodes(this->Pyramid.LevelSize(1));
  // Create2DFromRaw takes no const data, and changes none
  auto data = [this](int level)
  { return const_cast<terrain::PyramidNode<float>*>(this->Pyramid.LevelNodes(level)); };
  bool done = this->Texture->Create2DFromRaw(size.x, size.y, 1, VTK_FLOAT, this->Texels.data());
  this->Texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  this->Texture->Deactivate();
  const int top = this->Pyramid.LevelCount();
  this->PyramidTexture->SetMaxLevel(top - 1);
  done = done && this->PyramidTexture->Create2DFromRaw(nodes.x, nodes.y, 2, VTK_FLOAT, data(1));
  this->PyramidTexture->Activate();
  for (int level = 2; done && level <= top; ++level)
  {
    const glm::ivec2 levelSize = this->Pyramid.LevelSize(level);
    glTexImage2D(GL_TEXTURE_2D, level - 1, GL_RG32F, levelSize.x, levelSize.y, 0, GL_RG, GL_FLOAT,
      data(level));
  }
  this->PyramidTexture->Deactivate();
  return done && glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
bool vtkTerrainDetailTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Image ||
    (this->Texture->GetContext() == window && this->UploadTime == this->ImageTime))
  {
    return true;
  }
  for (vtkTextureObject* texture : { this->Texture.Get(), this->PyramidTexture.Get() })
  {
    texture->ReleaseGraphicsResources(texture->GetContext());
    texture->SetContext(window);
    texture->ResetFormatAndType();
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetWrapS(vtkTextureObject::Repeat);
    texture->SetWrapT(vtkTextureObject::Repeat);
  }
  this->Texture->SetInternalFormat(GL_R32F);
  this->Texture->SetFormat(GL_RED);
  this->PyramidTexture->SetInternalFormat(GL_RG32F);
  this->PyramidTexture->SetFormat(GL_RG);
  this->PyramidTexture->SetMinificationFilter(vtkTextureObject::NearestMipmapNearest);
  // for the slopes of what is far away; else shaders fetch single texels
  this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMaxLevel(terrain::LevelOfCells(std::max(this->Period.x, this->Period.y)));
  const bool done = this->UploadLevels();
  this->UploadTime = done ? this->ImageTime : 0;
  return done;
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->PyramidTexture->ReleaseGraphicsResources(window);
  this->UploadTime = 0;
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::Activate()
{
  if (this->Image)
  {
    this->Texture->Activate();
    this->PyramidTexture->Activate();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::Deactivate()
{
  if (this->Image)
  {
    this->Texture->Deactivate();
    this->PyramidTexture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::SetUniforms(vtkTerrainUniforms& uniforms, int level, double scale)
{
  if (!this->Image || !uniforms.Uses("terrainDetail"))
  {
    return;
  }
  uniforms.Set("terrainDetail", this->Texture->GetTextureUnit());
  uniforms.Set("terrainDetailPeriod", this->Period);
  uniforms.Set("terrainDetailLevel", level);
  uniforms.Set("terrainDetailScale", static_cast<float>(scale));
  if (uniforms.Uses("terrainDetailPyramid"))
  {
    uniforms.Set("terrainDetailPyramid", this->PyramidTexture->GetTextureUnit());
    uniforms.Set("terrainDetailTop", terrain::WholeLevels(this->Period));
    uniforms.Set("terrainDetailMaximum",
      static_cast<float>(scale) * static_cast<float>(this->Codes.MaximumCode));
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkTerrainDetailTexture::GetMemorySize() const
{
  // with the mip levels, a third more
  const std::size_t bytes =
    this->Texels.size() * sizeof(float) * 4 / 3 + this->Pyramid.MemorySize();
  return this->UploadTime ? static_cast<vtkIdType>(bytes) : 0;
}
