// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ShadowBoundsTexture.h"

#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <cmath>

namespace terrain
{
namespace
{
bool AreSame(const ShadowBoundsTexture::Key& a, const ShadowBoundsTexture::Key& b)
{
  return AreSameRays(a.Rays, b.Rays) && a.Complete == b.Complete &&
    a.PyramidTime == b.PyramidTime && a.HeightOfCode == b.HeightOfCode;
}
}

//------------------------------------------------------------------------------
bool ShadowBoundsTexture::Upload(
  vtkOpenGLRenderWindow* window, const Key& key, const std::function<ShadowBounds()>& make)
{
  if (this->Texture->GetContext() == window && this->Texture->GetHandle() &&
    AreSame(this->MadeFrom, key))
  {
    return true;
  }
  this->ReleaseGraphicsResources(this->Texture->GetContext());
  this->Bounds = make();
  ++this->NumberOfBuilds;
  this->MadeFrom = key;
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const bool done = this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Bounds.Size.x),
    static_cast<unsigned int>(this->Bounds.Size.y), 2, VTK_FLOAT, this->Bounds.Texels.data());
  this->Bounds.Texels = {};
  return done;
}

//------------------------------------------------------------------------------
void ShadowBoundsTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void ShadowBoundsTexture::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void ShadowBoundsTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void ShadowBoundsTexture::SetUniforms(Uniforms& uniforms)
{
  if (!uniforms.Uses("terrainShadowBounds") || !this->Texture->GetHandle())
  {
    return;
  }
  const ShadowBounds& bounds = this->Bounds;
  uniforms.Set("terrainShadowBounds", this->Texture->GetTextureUnit());
  uniforms.Set("terrainBoundsAxes", glm::vec4(bounds.Major, bounds.Minor));
  uniforms.Set("terrainBoundsPlace",
    glm::vec4(bounds.MajorStart, bounds.Slope, bounds.FirstStrip, std::exp2(-bounds.Level)));
  uniforms.Set("terrainBoundsRises", glm::vec2(bounds.LowRise, bounds.HighRise));
  uniforms.Set("terrainBoundsLevel", bounds.Level);
}
}
