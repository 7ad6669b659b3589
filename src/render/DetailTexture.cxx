// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/DetailTexture.h"

#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace terrain
{
//------------------------------------------------------------------------------
std::string DetailTexture::SetImage(vtkImageData* image)
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
  std::string why = ImageHeights::WhyNotHeights(image);
  if (!why.empty())
  {
    return "detail: " + why;
  }
  this->Period = { image->GetDimensions()[0], image->GetDimensions()[1] };
  ImageHeights::Dispatch(image,
    [this](const auto& view)
    {
      this->Codes = ChooseHeightCodes(FindHeightRange(view, SMPParallelFor));
      this->Codes.Format = HeightCodes::TexelFormat::Float32;
      this->Codes.Bias = 0;
      this->Texels.resize(static_cast<std::size_t>(view.Width * view.Height));
      EncodeHeights(
        view, this->Codes, 0, view.Width, 0, view.Height, this->Texels.data(), SMPParallelFor);
    });
  if (this->Codes.HasNoData || !this->Codes.HasData)
  {
    return "detail: every sample needs a height";
  }
  this->Nodes.Build(
    this->Texels.data(), this->Period, static_cast<float>(this->Codes.MaximumCode), SMPParallelFor);
  this->Image = image;
  this->ImageTime = image->GetMTime();
  return {};
}

//------------------------------------------------------------------------------
bool DetailTexture::UploadHeights()
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
bool DetailTexture::Upload(vtkOpenGLRenderWindow* window)
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
  texture->SetMaxLevel(LevelOfCells(std::max(this->Period.x, this->Period.y)));
  const bool done = this->UploadHeights() && this->Extremes.Upload(window, this->Nodes.Pyramid);
  this->UploadTime = done ? this->ImageTime : 0;
  return done;
}

//------------------------------------------------------------------------------
void DetailTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Extremes.ReleaseGraphicsResources(window);
  this->UploadTime = 0;
}

//------------------------------------------------------------------------------
void DetailTexture::Activate()
{
  if (this->Image)
  {
    this->Texture->Activate();
    this->Extremes.Activate();
  }
}

//------------------------------------------------------------------------------
void DetailTexture::Deactivate()
{
  if (this->Image)
  {
    this->Texture->Deactivate();
    this->Extremes.Deactivate();
  }
}

//------------------------------------------------------------------------------
void DetailTexture::SetUniforms(Uniforms& uniforms, int level, double scale)
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
    this->Extremes.SetUniforms(
      uniforms, "terrainDetailPyramid", "terrainDetailLayout", "terrainDetailLevels");
    uniforms.Set("terrainDetailUnit", static_cast<float>(scale) * this->Nodes.Unit);
    uniforms.Set("terrainDetailTop", WholeLevels(this->Period));
    uniforms.Set("terrainDetailMaximum",
      static_cast<float>(scale) * static_cast<float>(this->Codes.MaximumCode));
  }
}

//------------------------------------------------------------------------------
vtkIdType DetailTexture::GetMemorySize() const
{
  // with the mip levels, a third more
  const std::size_t bytes =
    this->Texels.size() * sizeof(float) * 4 / 3 + this->Nodes.Pyramid.MemorySize();
  return this->UploadTime ? static_cast<vtkIdType>(bytes) : 0;
}
}
