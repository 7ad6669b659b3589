// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/TileTextures.h"

#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <limits>
#include <thread>
#include <vector>

namespace terrain
{
namespace
{
// Tiles that a frame sends where it does not wait: 25 MB of 16-bit heights.
constexpr std::size_t kUploads = 64;
constexpr int kMostThreads = 4;
// Level of the first node of a ray.
constexpr int kStartLevel = 5;

int ThreadCount()
{
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads);
}

/// Storage for layers of texels.
unsigned int MakeArray(GLenum format, int side, std::size_t layers)
{
  unsigned int name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D_ARRAY, name);
  const bool isInteger = format == GL_R16UI || format == GL_RG16UI;
  const bool isPair = format == GL_RG16UI || format == GL_RG32F;
  const GLenum order =
    isInteger ? (isPair ? GL_RG_INTEGER : GL_RED_INTEGER) : (isPair ? GL_RG : GL_RED);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), side, side,
    static_cast<GLsizei>(layers), 0, order, isInteger ? GL_UNSIGNED_SHORT : GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  return name;
}

void TakeOver(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, unsigned int name)
{
  texture->ReleaseGraphicsResources(texture->GetContext());
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->AssignToExistingTexture(name, GL_TEXTURE_2D_ARRAY);
}
}

//------------------------------------------------------------------------------
void TileTextures::SetSource(
  std::shared_ptr<const TileSource> source, std::size_t host, std::size_t card)
{
  if (source == this->Source && host == this->HostBudget && card == this->CardBudget)
  {
    return;
  }
  this->ReleaseGraphicsResources(this->HeightTexture->GetContext());
  this->Residency.reset();
  this->Pool.reset();
  this->Source = std::move(source);
  this->HostBudget = host;
  this->CardBudget = card;
  this->SaidThatItDoesNotFit = false;
  if (this->Source)
  {
    this->Pool = std::make_shared<TilePool>(this->Source, host, ThreadCount(), nullptr);
  }
}

//------------------------------------------------------------------------------
bool TileTextures::IsInteger() const
{
  return this->Source->GetCodes().Format == HeightCodes::TexelFormat::UInt16;
}

//------------------------------------------------------------------------------
std::size_t TileTextures::SlotBytes() const
{
  const auto side = static_cast<std::size_t>(this->Source->GetLayout().TileCells());
  return ((side + 1) * (side + 1) + 2 * side * side) * (this->IsInteger() ? 2 : 4);
}

//------------------------------------------------------------------------------
std::size_t TileTextures::TailBytes() const
{
  const auto side = static_cast<std::size_t>(this->Source->GetLayout().TileCells());
  return 2 * side * side * (this->IsInteger() ? 2 : 4);
}

//------------------------------------------------------------------------------
std::string TileTextures::Allocate(vtkOpenGLRenderWindow* window)
{
  const TileLayout layout = this->Source->GetLayout();
  GLint layers = 0;
  GLint texels = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  const TilePages pages(layout);
  if (static_cast<std::int64_t>(pages.Get().size()) > texels)
  {
    return "a heightfield of " + std::to_string(layout.Width) + " x " +
      std::to_string(layout.Height) + " samples has more tiles than this graphics driver's buffers";
  }
  const auto most = static_cast<std::size_t>(std::max(layers - 1, 1));
  this->Slots = std::clamp<std::size_t>(
    (std::max(this->CardBudget, this->TailBytes()) - this->TailBytes()) / this->SlotBytes(), 1,
    most);
  std::size_t all = 0;
  for (int level = 0; level < layout.LevelCount(); ++level)
  {
    all += static_cast<std::size_t>(layout.Tiles(level).x * layout.Tiles(level).y);
  }
  this->Slots = std::min(this->Slots, all);
  const int side = static_cast<int>(layout.TileCells());
  while (glGetError() != GL_NO_ERROR) // of others
  {
  }
  this->Heights = MakeArray(this->IsInteger() ? GL_R16UI : GL_R32F, side + 1, this->Slots);
  this->Bounds = MakeArray(this->IsInteger() ? GL_RG16UI : GL_RG32F, side,
    this->Slots + 1); // the tail is behind
  if (glGetError() != GL_NO_ERROR)
  {
    return "the graphics driver has no memory for tiles; lower the budget of the card";
  }
  TakeOver(this->HeightTexture, window, this->Heights);
  TakeOver(this->BoundTexture, window, this->Bounds);
  this->PageTexture->SetContext(window);
  this->Residency = std::make_unique<TileResidency>(this->Pool, this->Slots, kUploads);
  return {};
}

//------------------------------------------------------------------------------
// Texels of a tile and of its bounds; codes and their bias as in HeightCodes.h.
template <typename Texel>
void TileTextures::SendAs(const TileUpload& upload)
{
  const Tile& tile = *upload.Content;
  constexpr bool kInteger = std::is_integral_v<Texel>;
  const auto bias = static_cast<float>(this->Source->GetCodes().Bias);
  std::vector<Texel> texels(tile.Samples.size());
  std::transform(tile.Samples.begin(), tile.Samples.end(), texels.begin(),
    [bias](float code)
    { return static_cast<Texel>(kInteger ? std::max(code + bias, 0.0F) : code); });
  const auto slot = static_cast<GLint>(upload.Slot);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLenum type = kInteger ? GL_UNSIGNED_SHORT : GL_FLOAT;
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Heights);
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, slot, tile.Cells.x + 1, tile.Cells.y + 1, 1,
    kInteger ? GL_RED_INTEGER : GL_RED, type, texels.data());
  if (!tile.Nodes.empty())
  {
    this->SendNodes<Texel>(tile.Nodes, tile.Cells, slot);
  }
  if (upload.Key.Level == this->GetTop())
  {
    const int tileLevel = this->Source->GetLayout().TileLevel;
    this->SendNodes<Texel>(
      MakeTileTail(tile, tileLevel), glm::ivec2(1 << tileLevel), static_cast<int>(this->Slots));
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

//------------------------------------------------------------------------------
template <typename Texel>
void TileTextures::SendNodes(
  const std::vector<PyramidNode<float>>& nodes, const glm::ivec2& size, int slot)
{
  constexpr bool kInteger = std::is_integral_v<Texel>;
  const auto bias = static_cast<float>(this->Source->GetCodes().Bias);
  std::vector<Texel> texels;
  texels.reserve(2 * nodes.size());
  for (const PyramidNode<float>& node : nodes)
  {
    const auto empty = PyramidNode<Texel>::Empty();
    texels.push_back(node.IsEmpty() ? empty.Maximum : static_cast<Texel>(node.Maximum + bias));
    texels.push_back(node.IsEmpty() ? empty.Minimum : static_cast<Texel>(node.Minimum + bias));
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Bounds);
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, slot, size.x, size.y, 1,
    kInteger ? GL_RG_INTEGER : GL_RG, kInteger ? GL_UNSIGNED_SHORT : GL_FLOAT, texels.data());
}

//------------------------------------------------------------------------------
void TileTextures::Send(const TileUpload& upload)
{
  this->IsInteger() ? this->SendAs<unsigned short>(upload) : this->SendAs<float>(upload);
}

//------------------------------------------------------------------------------
bool TileTextures::SendPages()
{
  const std::vector<std::uint32_t>& pages = this->Residency->GetPages().Get();
  const bool isNew = this->PageTexture->GetHandle() == 0;
  bool done =
    this->PageBuffer->Upload(pages.data(), pages.size(), vtkOpenGLBufferObject::TextureBuffer);
  if (done && isNew)
  {
    this->PageTexture->ResetFormatAndType();
    this->PageTexture->SetInternalFormat(GL_R32UI);
    this->PageTexture->SetFormat(GL_RED_INTEGER);
    done = this->PageTexture->CreateTextureBuffer(
      static_cast<unsigned int>(pages.size()), 1, VTK_UNSIGNED_INT, this->PageBuffer);
  }
  return done;
}

//------------------------------------------------------------------------------
std::string TileTextures::Update(vtkOpenGLRenderWindow* window, const TileView& view, bool waits)
{
  if (this->HeightTexture->GetContext() != window || !this->Heights)
  {
    this->ReleaseGraphicsResources(this->HeightTexture->GetContext());
    std::string why = this->Allocate(window);
    if (!why.empty())
    {
      return why;
    }
  }
  const auto send = [this](const TileUpload& upload) { this->Send(upload); };
  const TileKey top{ this->GetTop(), 0, 0 };
  const auto update = [&]()
  {
    for (const TileUpload& upload : this->Residency->Update(view))
    {
      send(upload);
    }
  };
  update();
  if (waits)
  {
    this->Residency->Finish(view, send);
  }
  else if (!this->Residency->GetPages().IsShown(top))
  {
    this->Pool->Wait();
    update();
  }
  if (!this->Residency->GetPages().IsShown(top))
  {
    return "its coarsest tile cannot be read: " + this->Pool->TakeMessage();
  }
  if (!this->Residency->Fits() && !this->SaidThatItDoesNotFit)
  {
    this->SaidThatItDoesNotFit = true;
    this->Message = "the view needs more tiles than the " + std::to_string(this->Slots) +
      " that fit into the card's budget: it is drawn coarser than the tolerance";
  }
  return this->SendPages() ? "" : "tiles could not be uploaded to the graphics driver";
}

//------------------------------------------------------------------------------
std::string TileTextures::TakeMessage()
{
  std::string message = this->Pool ? this->Pool->TakeMessage() : std::string();
  if (!message.empty())
  {
    message = "a tile of the heights cannot be read, and is drawn coarser: " + message;
  }
  else
  {
    message = std::move(this->Message);
    this->Message.clear();
  }
  return message;
}

//------------------------------------------------------------------------------
void TileTextures::Activate()
{
  this->HeightTexture->Activate();
  this->BoundTexture->Activate();
  this->PageTexture->Activate();
}

//------------------------------------------------------------------------------
void TileTextures::Deactivate()
{
  this->HeightTexture->Deactivate();
  this->BoundTexture->Deactivate();
  this->PageTexture->Deactivate();
}

//------------------------------------------------------------------------------
void TileTextures::SetUniforms(Uniforms& uniforms)
{
  const HeightCodes codes = this->Source->GetCodes();
  const int top = this->GetTop();
  uniforms.Set("terrainTileHeights", this->HeightTexture->GetTextureUnit());
  uniforms.Set("terrainTileBounds", this->BoundTexture->GetTextureUnit());
  uniforms.Set("terrainTilePages", this->PageTexture->GetTextureUnit());
  uniforms.Set("terrainTileLevel", this->Source->GetLayout().TileLevel);
  uniforms.Set("terrainTileTop", top);
  uniforms.Set("terrainTileTail", static_cast<int>(this->Slots));
  uniforms.Set("terrainTileBias", static_cast<float>(codes.Bias));
  uniforms.Set("terrainHoles", codes.HasNoData ? 1 : 0);
  uniforms.Set("terrainPyramidTop", this->GetPyramidTop());
  // Rays start near the surface: from the top down, most levels would be visited in vain.
  uniforms.Set("terrainPyramidStart", std::min(this->GetPyramidTop(), kStartLevel));
}

//------------------------------------------------------------------------------
void TileTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  this->HeightTexture->ReleaseGraphicsResources(window);
  this->BoundTexture->ReleaseGraphicsResources(window);
  this->PageTexture->ReleaseGraphicsResources(window);
  this->PageBuffer->ReleaseGraphicsResources();
  for (unsigned int* name : { &this->Heights, &this->Bounds })
  {
    if (*name != 0 && window)
    {
      glDeleteTextures(1, name);
    }
    *name = 0;
  }
  this->Residency.reset();
}
}
