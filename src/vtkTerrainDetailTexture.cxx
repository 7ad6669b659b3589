// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDetailTexture.h"

#include "vtkTerrainGL.h"
#include "vtkTerrainHeightfield.h"
#include "vtkTerrainParallelFor.h"
#include "vtkTerrainUniforms.h"

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
  this->Nodes.Build(this->Texels.data(), this->Period, static_cast<float>(this->Codes.MaximumCode),
    vtkTerrainParallelFor);
  this->Image = image;
  this->ImageTime = image->GetMTime();
  return {};
}

//------------------------------------------------------------------------------
bool vtkTerrainDetailTexture::UploadHeights()
{
  const glm::uvec2 size(this->Period);
  const bool done =
    this->Texture->Create2DFromRaw(size.x, size.y, 1, VTK_FLOAT, this->Texels.data());
  this->Texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  this->Texture->Deactivate();
  return done;
}

//------------------------------------------------------------------------------
bool vtkTerrainDetailTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Image ||
    (this->Texture->GetContext() == window && this->UploadTime == this->ImageTime))
  {
    return true;
  }
  vtkTextureObject* texture = this->Texture;
  texture->ReleaseGraphicsResources(texture->GetContext());
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetInternalFormat(GL_R32F);
  texture->SetFormat(GL_RED);
  // for the slopes of what is far away; else shaders fetch single texels
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMaxLevel(terrain::LevelOfCells(std::max(this->Period.x, this->Period.y)));
  const bool done =
    this->UploadHeights() && this->PyramidTexture.Upload(window, this->Nodes.Pyramid);
  this->UploadTime = done ? this->ImageTime : 0;
  return done;
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->PyramidTexture.ReleaseGraphicsResources(window);
  this->UploadTime = 0;
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::Activate()
{
  if (this->Image)
  {
    this->Texture->Activate();
    this->PyramidTexture.Activate();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainDetailTexture::Deactivate()
{
  if (this->Image)
  {
    this->Texture->Deactivate();
    this->PyramidTexture.Deactivate();
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
    this->PyramidTexture.SetUniforms(
      uniforms, "terrainDetailPyramid", "terrainDetailLayout", "terrainDetailLevels");
    uniforms.Set("terrainDetailUnit", static_cast<float>(scale) * this->Nodes.Unit);
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
    this->Texels.size() * sizeof(float) * 4 / 3 + this->Nodes.Pyramid.MemorySize();
  return this->UploadTime ? static_cast<vtkIdType>(bytes) : 0;
}
