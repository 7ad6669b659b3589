// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ComputeTexture.h"

#include "render/Driver.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <algorithm>

namespace terrain
{
namespace
{
GLuint Groups(int texels)
{
  return static_cast<GLuint>((texels + kGroupSize - 1) / kGroupSize);
}
}

//------------------------------------------------------------------------------
std::string ComputeTexture::Fill(vtkOpenGLRenderWindow* window, const Features& features,
  const std::function<std::string()>& makeSource, glm::ivec2 size, int components,
  const std::function<void(Uniforms&)>& setUniforms)
{
  this->Filled = false;
  this->Size = { 0, 0 };
  auto entry = std::find_if(this->Programs.begin(), this->Programs.end(),
    [&features](const auto& known) { return known.first == features; });
  const bool isNew = entry == this->Programs.end();
  if (isNew)
  {
    entry = this->Programs.insert(entry, { features, ComputeProgram() });
  }
  ComputeProgram& program = entry->second;
  if (isNew)
  {
    std::string words = program.Build(makeSource());
    if (!words.empty())
    {
      return words;
    }
  }
  if (!program.IsBuilt())
  {
    return {};
  }
  this->Allocate(window, size, components);
  window->GetShaderCache()->ReleaseCurrentShader();
  program.Use();
  setUniforms(program);
  this->Texture->Activate();
  glBindImageTexture(0, this->Texture->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
    components == 4 ? GL_RGBA32F : GL_R32F);
  glDispatchCompute(Groups(size.x), Groups(size.y), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT); // Read(), too
  glUseProgram(0);
  this->Size = size;
  this->Filled = true;
  return {};
}

//------------------------------------------------------------------------------
void ComputeTexture::Allocate(vtkOpenGLRenderWindow* window, glm::ivec2 size, int components)
{
  if (this->Texture->GetContext() == window &&
    static_cast<int>(this->Texture->GetWidth()) == size.x &&
    static_cast<int>(this->Texture->GetHeight()) == size.y &&
    this->Texture->GetComponents() == components)
  {
    return;
  }
  this->Texture->ReleaseGraphicsResources(this->Texture->GetContext());
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->Allocate2D(
    static_cast<unsigned int>(size.x), static_cast<unsigned int>(size.y), components, VTK_FLOAT);
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> ComputeTexture::Read()
{
  std::vector<glm::vec4> texels(static_cast<std::size_t>(this->Size.x) * this->Size.y);
  if (!texels.empty())
  {
    this->Texture->Activate();
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
    this->Texture->Deactivate();
  }
  return texels;
}

//------------------------------------------------------------------------------
void ComputeTexture::Finish()
{
  if (this->Filled)
  {
    this->Texture->Deactivate();
    this->Filled = false;
  }
}

//------------------------------------------------------------------------------
void ComputeTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Filled = false;
  this->Size = { 0, 0 };
  this->Texture->ReleaseGraphicsResources(window);
  for (auto& [features, program] : this->Programs)
  {
    if (program.IsBuilt())
    {
      window->MakeCurrent();
      program.Release();
    }
  }
  this->Programs.clear();
}
}
