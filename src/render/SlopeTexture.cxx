// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/SlopeTexture.h"

#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

namespace terrain
{
//------------------------------------------------------------------------------
bool SlopeTexture::Upload(vtkOpenGLRenderWindow* window)
{
  const std::vector<SlopeLevel>& levels = this->Slopes.GetLevels();
  vtkTextureObject* texture = this->Texture;
  this->ReleaseGraphicsResources(texture->GetContext());
  if (levels.empty())
  {
    return true;
  }
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetInternalFormat(GL_RG16_SNORM);
  texture->SetFormat(GL_RG);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
  // Create2DFromRaw takes no const data, and changes none
  auto* first = const_cast<SlopeTexel*>(levels[0].Texels.data());
  const bool done = texture->Create2DFromRaw(static_cast<unsigned int>(levels[0].Size.x),
    static_cast<unsigned int>(levels[0].Size.y), 2, VTK_SHORT, first);
  texture->Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t k = 0; done && k < levels.size(); ++k)
  {
    // the first one, too: VTK fills the levels above it by itself
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(k), GL_RG16_SNORM, levels[k].Size.x,
      levels[k].Size.y, 0, GL_RG, GL_SHORT, levels[k].Texels.data());
    this->MemorySize += static_cast<vtkIdType>(levels[k].Texels.size() * sizeof(SlopeTexel));
  }
  texture->Deactivate();
  this->Slopes.ForgetLevels();
  return done && glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void SlopeTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->MemorySize = 0;
}

//------------------------------------------------------------------------------
void SlopeTexture::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void SlopeTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void SlopeTexture::SetUniforms(Uniforms& uniforms)
{
  if (uniforms.Uses("terrainSlopes") && this->Texture->GetHandle())
  {
    uniforms.Set("terrainSlopes", this->Texture->GetTextureUnit());
    uniforms.Set("terrainSlopesScale", static_cast<float>(this->Slopes.GetScale()));
  }
}
}
