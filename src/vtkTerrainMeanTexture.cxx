// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMeanTexture.h"

#include "vtkTerrainGL.h"
#include "vtkTerrainUniforms.h"

#include "vtkOpenGLRenderWindow.h"

//------------------------------------------------------------------------------
bool vtkTerrainMeanTexture::Upload(vtkOpenGLRenderWindow* window)
{
  const std::vector<terrain::MeanLevel>& levels = this->Means.GetLevels();
  vtkTextureObject* texture = this->Texture;
  texture->ReleaseGraphicsResources(texture->GetContext());
  if (levels.empty())
  {
    return true;
  }
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetInternalFormat(GL_R16);
  texture->SetFormat(GL_RED);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
  // Create2DFromRaw takes no const data, and changes none
  auto* first = const_cast<std::uint16_t*>(levels[0].Texels.data());
  const bool done = texture->Create2DFromRaw(static_cast<unsigned int>(levels[0].Size.x),
    static_cast<unsigned int>(levels[0].Size.y), 1, VTK_UNSIGNED_SHORT, first);
  texture->Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t k = 0; done && k < levels.size(); ++k)
  {
    // the first one, too: VTK fills the levels above it by itself
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(k), GL_R16, levels[k].Size.x, levels[k].Size.y,
      0, GL_RED, GL_UNSIGNED_SHORT, levels[k].Texels.data());
  }
  texture->Deactivate();
  return done && glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void vtkTerrainMeanTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTerrainMeanTexture::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainMeanTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainMeanTexture::SetUniforms(vtkTerrainUniforms& uniforms, double maximumCode)
{
  if (uniforms.Uses("terrainMeans") && this->Texture->GetHandle())
  {
    uniforms.Set("terrainMeans", this->Texture->GetTextureUnit());
    uniforms.Set("terrainMeansScale", static_cast<float>(maximumCode));
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkTerrainMeanTexture::GetMemorySize() const
{
  std::size_t texels = 0;
  for (const terrain::MeanLevel& level : this->Means.GetLevels())
  {
    texels += level.Texels.size();
  }
  return this->Texture->GetHandle() ? static_cast<vtkIdType>(texels * sizeof(std::uint16_t)) : 0;
}
