// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles of a heightfield on the GPU, for shaders/vtkTerrainTiles.glsl: two texture arrays of slots
 * and a page table. Private to the module.
 */
#ifndef vtkTerrain_render_TileTextures_h
#define vtkTerrain_render_TileTextures_h

#include "core/surface/TileResidency.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class Uniforms;

class TileTextures
{
public:
  /// Takes over a source, null for none, and the most bytes of tiles on the host and on the card.
  void SetSource(std::shared_ptr<const TileSource> source, std::size_t host, std::size_t card);
  bool HasSource() const
  {
    return this->Source != nullptr;
  }
  const TileSource& GetSource() const
  {
    return *this->Source;
  }

  /// Sends what a view needs; all of it if it waits, else what is there, but always the coarsest
  /// tile. Returns an empty string, or why nothing can be drawn.
  std::string Update(vtkOpenGLRenderWindow* window, const TileView& view, bool waits);
  /// What is to be said once: that tiles cannot be read, or do not fit; else empty.
  std::string TakeMessage();

  /// True if the last view had all the tiles that it needs.
  bool IsComplete() const
  {
    return this->Residency && this->Residency->IsComplete();
  }
  /// Bytes of the textures.
  std::size_t GetMemorySize() const
  {
    return this->Heights ? this->Slots * this->SlotBytes() + this->TailBytes() : 0;
  }
  std::size_t GetNumberOfTiles() const
  {
    return this->Residency ? this->Residency->GetNumberOfTiles() : 0;
  }

  /// The coarsest level, which has one tile.
  int GetTop() const
  {
    return this->Residency ? this->Residency->GetPages().Top() : 0;
  }
  /// The coarsest level of their mip tail (TileTail.h), which has one node.
  int GetPyramidTop() const
  {
    return this->GetTop() + this->Source->GetLayout().TileLevel;
  }

  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::size_t SlotBytes() const;
  std::size_t TailBytes() const;
  bool IsInteger() const;
  std::string Allocate(vtkOpenGLRenderWindow* window);
  void Send(const TileUpload& upload);
  template <typename Texel>
  void SendAs(const TileUpload& upload);
  template <typename Texel>
  void SendNodes(const std::vector<PyramidNode<float>>& nodes, const glm::ivec2& size, int slot);
  bool SendPages();

  std::shared_ptr<const TileSource> Source;
  std::shared_ptr<TilePool> Pool;
  std::unique_ptr<TileResidency> Residency;
  std::size_t HostBudget = 0;
  std::size_t CardBudget = 0;
  std::size_t Slots = 0;
  unsigned int Heights = 0; // OpenGL's names
  unsigned int Bounds = 0;
  vtkNew<vtkTextureObject> HeightTexture;
  vtkNew<vtkTextureObject> BoundTexture;
  vtkNew<vtkTextureObject> PageTexture;
  vtkNew<vtkOpenGLBufferObject> PageBuffer;
  bool SaidThatItDoesNotFit = false;
  std::string Message;
};
}
#endif
