// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/PyramidTexture.h"

#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <type_traits>

namespace terrain
{
namespace
{
template <typename Texel>
constexpr bool kIsInteger = std::is_integral_v<Texel>;
template <typename Texel>
constexpr GLenum kInternalFormat = kIsInteger<Texel> ? GL_RG16UI : GL_RG32F;
template <typename Texel>
constexpr GLenum kFormat = kIsInteger<Texel> ? GL_RG_INTEGER : GL_RG;
template <typename Texel>
constexpr GLenum kType = kIsInteger<Texel> ? GL_UNSIGNED_SHORT : GL_FLOAT;
template <typename Texel>
constexpr int kVtkType = kIsInteger<Texel> ? VTK_UNSIGNED_SHORT : VTK_FLOAT;
}

//------------------------------------------------------------------------------
template <typename Texel>
bool PyramidTexture::Upload(vtkOpenGLRenderWindow* window, const MinMaxPyramid<Texel>& pyramid)
{
  this->ReleaseGraphicsResources(this->Texture->GetContext());
  this->Layout = pyramid.GetLayout();
  if (pyramid.LevelCount() == 0)
  {
    return true;
  }
  this->InBuffer = Driver::Current().BuffersPyramid;
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(kInternalFormat<Texel>);
  this->Texture->SetFormat(kFormat<Texel>);
  return this->InBuffer ? this->UploadBuffer(pyramid) : this->UploadLevels(pyramid);
}

//------------------------------------------------------------------------------
template <typename Texel>
bool PyramidTexture::UploadBuffer(const MinMaxPyramid<Texel>& pyramid)
{
  return this->Buffer->Upload(
           pyramid.AllNodes(), pyramid.NumberOfNodes(), vtkOpenGLBufferObject::TextureBuffer) &&
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(pyramid.NumberOfNodes()), 2, kVtkType<Texel>, this->Buffer);
}

//------------------------------------------------------------------------------
template <typename Texel>
bool PyramidTexture::UploadLevels(const MinMaxPyramid<Texel>& pyramid)
{
  this->Texture->SetMinificationFilter(vtkTextureObject::NearestMipmapNearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMaxLevel(pyramid.LevelCount() - 1);
  // Create2DFromRaw takes no const data, and changes none
  auto nodes = [&](int level)
  { return const_cast<PyramidNode<Texel>*>(pyramid.LevelNodes(level)); };
  const glm::uvec2 first(pyramid.LevelSize(1));
  bool done = this->Texture->Create2DFromRaw(first.x, first.y, 2, kVtkType<Texel>, nodes(1));
  this->Texture->Activate();
  for (int level = 2; done && level <= pyramid.LevelCount(); ++level)
  {
    const glm::ivec2 size = pyramid.LevelSize(level);
    glTexImage2D(GL_TEXTURE_2D, level - 1, static_cast<GLint>(kInternalFormat<Texel>), size.x,
      size.y, 0, kFormat<Texel>, kType<Texel>, nodes(level));
  }
  this->Texture->Deactivate();
  return done && glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
template <typename Texel>
void PyramidTexture::UploadPart(
  const MinMaxPyramid<Texel>& pyramid, int level, const GridRectangle& nodes)
{
  using Node = PyramidNode<Texel>;
  const glm::ivec2 size = nodes.End - nodes.First;
  const int width = pyramid.LevelSize(level).x;
  const std::int64_t first = pyramid.GetLayout().Begin(level) + nodes.First.x +
    static_cast<std::int64_t>(width) * nodes.First.y;
  const Node* texels = pyramid.AllNodes() + first;
  if (!this->InBuffer)
  {
    this->Texture->Activate();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, width);
    glTexSubImage2D(GL_TEXTURE_2D, level - 1, nodes.First.x, nodes.First.y, size.x, size.y,
      kFormat<Texel>, kType<Texel>, texels);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    this->Texture->Deactivate();
    return;
  }
  this->Buffer->Bind();
  for (int row = 0; row < size.y; ++row)
  {
    const std::int64_t offset = static_cast<std::int64_t>(width) * row;
    glBufferSubData(GL_TEXTURE_BUFFER,
      static_cast<GLintptr>((first + offset) * static_cast<std::int64_t>(sizeof(Node))),
      static_cast<GLsizeiptr>(static_cast<std::size_t>(size.x) * sizeof(Node)), texels + offset);
  }
  this->Buffer->Release();
}

//------------------------------------------------------------------------------
void PyramidTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}

//------------------------------------------------------------------------------
void PyramidTexture::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void PyramidTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void PyramidTexture::SetUniforms(
  Uniforms& uniforms, const char* texture, const char* parts, const char* levels)
{
  uniforms.Set(texture, this->Texture->GetTextureUnit());
  uniforms.Set(parts, glm::ivec2(this->Layout.Quarters, this->Layout.Halves));
  uniforms.Set(levels, this->Layout.Top);
}

#define TERRAIN_INSTANTIATE(Texel)                                                                 \
  template bool PyramidTexture::Upload(vtkOpenGLRenderWindow*, const MinMaxPyramid<Texel>&);       \
  template void PyramidTexture::UploadPart(const MinMaxPyramid<Texel>&, int, const GridRectangle&)
TERRAIN_INSTANTIATE(unsigned short);
TERRAIN_INSTANTIATE(float);
#undef TERRAIN_INSTANTIATE
}
