// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fields in tiles, of which some are missing, as the textures and uniforms of shaders.
 */
#ifndef vtkTerrainTestTiles_h
#define vtkTerrainTestTiles_h

#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestTiles.h"
#include "core/surface/TileReduction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
/// Tiles on the GPU: a layer a slot, laid out as render/TileTextures does.
class TileArrays
{
public:
  TileArrays(vtkRenderWindow* window, const terrain::TiledField& field)
    : Field(field)
    , Codes(field.Source->GetCodes())
  {
    this->Integer = this->Codes.Format == terrain::HeightCodes::TexelFormat::UInt16;
    const auto side = static_cast<std::size_t>(field.Layout.TileCells());
    std::vector<float> heights(field.Shown * (side + 1) * (side + 1));
    std::vector<float> bounds((field.Shown + 1) * side * side * 2);
    for (std::size_t slot = 0; slot < field.Shown; ++slot)
    {
      this->Lay(field.Slots.GetTile(slot), slot, heights);
      this->LayNodes(field.Slots.GetTile(slot)->Nodes, field.Slots.GetTile(slot)->Cells.x,
        &bounds[2 * side * side * slot]);
    }
    this->LayNodes(field.Slots.GetTail(), static_cast<int>(side),
      &bounds[2 * side * side * static_cast<std::size_t>(field.Slots.TailSlot())]);
    this->Create(window, this->Heights, 1, side + 1, heights);
    this->Create(window, this->Bounds, 2, side, bounds);
    const std::vector<std::uint32_t>& pages = field.Slots.GetPages().Get();
    this->Pages->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
    this->Pages->SetInternalFormat(GL_R32UI);
    this->Pages->SetFormat(GL_RED_INTEGER);
    this->Buffer->Upload(pages.data(), pages.size(), vtkOpenGLBufferObject::TextureBuffer);
    this->Pages->CreateTextureBuffer(
      static_cast<unsigned int>(pages.size()), 1, VTK_UNSIGNED_INT, this->Buffer);
    this->Heights->Activate();
    this->Bounds->Activate();
    this->Pages->Activate();
  }
  TileArrays(const TileArrays&) = delete;
  TileArrays& operator=(const TileArrays&) = delete;
  ~TileArrays()
  {
    this->Heights->Deactivate();
    this->Bounds->Deactivate();
    this->Pages->Deactivate();
    glDeleteTextures(2, this->Names);
  }

  /// What programs that read them are built for.
  terrain::Features GetFeatures() const
  {
    terrain::Features features;
    features.Way = terrain::Features::Ways::Pyramid;
    features.IntegerHeights = this->Integer;
    features.Gathers = terrain::Driver().Gathers;
    features.Tiles = true;
    return features;
  }

  /// What programs that trace through them begin with, with tolerances.
  std::string Declarations() const
  {
    terrain::Features features = this->GetFeatures();
    features.Within = true;
    return features.Defines() + terrain::Features::Constants() + CountVisits() +
      ReadShader("vtkTerrainTiles") + ReadShader("vtkTerrainHeights") +
      ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid") +
      ReadShader("vtkTerrainTileTrace") + InputRay();
  }

  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniformi("terrainTileHeights", this->Heights->GetTextureUnit());
    program->SetUniformi("terrainTileBounds", this->Bounds->GetTextureUnit());
    program->SetUniformi("terrainTilePages", this->Pages->GetTextureUnit());
    program->SetUniformi("terrainTileLevel", this->Field.Layout.TileLevel);
    program->SetUniformi("terrainTileTop", this->Field.Slots.Top());
    program->SetUniformi("terrainTileTail", this->Field.Slots.TailSlot());
    program->SetUniformf("terrainTileBias", static_cast<float>(this->Codes.Bias));
    program->SetUniformi("terrainHoles", this->Codes.HasNoData ? 1 : 0);
    program->SetUniformi("terrainPyramidTop", this->Field.Slots.PyramidTop());
    program->SetUniformi("terrainPyramidStart", this->Field.Rays.start);
    program->SetUniform2i("terrainSize", &this->Field.Rays.heights.size[0]);
    program->SetUniformf("terrainMaximumCode", this->Field.Rays.heights.maximumCode);
  }

private:
  /// Texels of a tile, as numbers.
  void Lay(const terrain::Tile* tile, std::size_t slot, std::vector<float>& heights) const
  {
    const auto side = static_cast<std::size_t>(this->Field.Layout.TileCells());
    const auto bias = static_cast<float>(this->Codes.Bias);
    for (std::size_t k = 0; k < tile->Samples.size(); ++k)
    {
      const auto width = static_cast<std::size_t>(tile->Cells.x) + 1;
      const float texel = tile->Samples[k] + bias;
      heights[k % width + (side + 1) * (k / width + (side + 1) * slot)] =
        this->Integer ? std::max(texel, 0.0f) : tile->Samples[k];
    }
  }

  /// Texels of bounds, rows of so many, as numbers.
  void LayNodes(
    const std::vector<terrain::PyramidNode<float>>& nodes, int cells, float* layer) const
  {
    const auto side = static_cast<std::size_t>(this->Field.Layout.TileCells());
    const auto bias = static_cast<float>(this->Codes.Bias);
    const auto width = static_cast<std::size_t>(cells);
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const terrain::PyramidNode<float>& node = nodes[k];
      float* to = &layer[2 * (k % width + side * (k / width))];
      to[0] = node.IsEmpty() && this->Integer ? 0.0f : node.Maximum + bias;
      to[1] = node.IsEmpty() && this->Integer ? 65535.0f : node.Minimum + bias;
    }
  }

  /// An array of textures with a layer a slot. It is still to be activated: it is bound here to the
  /// unit that was activated last, in the place of what is there.
  void Create(vtkRenderWindow* window, vtkTextureObject* texture, int components, std::size_t side,
    const std::vector<float>& numbers)
  {
    const std::vector<std::uint16_t> integers = this->Integer
      ? std::vector<std::uint16_t>(numbers.begin(), numbers.end())
      : std::vector<std::uint16_t>();
    unsigned int& name = this->Names[components - 1];
    const GLenum internal = this->Integer ? (components == 1 ? GL_R16UI : GL_RG16UI)
                                          : (components == 1 ? GL_R32F : GL_RG32F);
    const GLenum format = this->Integer ? (components == 1 ? GL_RED_INTEGER : GL_RG_INTEGER)
                                        : (components == 1 ? GL_RED : GL_RG);
    const std::size_t layers =
      numbers.size() / (static_cast<std::size_t>(components) * side * side);
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D_ARRAY, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internal), static_cast<GLsizei>(side),
      static_cast<GLsizei>(side), static_cast<GLsizei>(layers), 0, format,
      this->Integer ? GL_UNSIGNED_SHORT : GL_FLOAT,
      this->Integer ? static_cast<const void*>(integers.data()) : numbers.data());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    PrepareTexture(window, texture, internal, format);
    texture->AssignToExistingTexture(name, GL_TEXTURE_2D_ARRAY);
  }

  const terrain::TiledField& Field;
  const terrain::HeightCodes Codes;
  bool Integer = false;
  unsigned int Names[2] = { 0, 0 };
  vtkNew<vtkTextureObject> Heights;
  vtkNew<vtkTextureObject> Bounds;
  vtkNew<vtkTextureObject> Pages;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};

/// A field in tiles of 16-bit integers; heights beyond them are cut.
inline std::unique_ptr<terrain::TileSource> IntegerTiles(const terrain::TestField& field)
{
  std::vector<short> samples;
  samples.reserve(field.Samples.size());
  for (const double height : field.Samples)
  {
    samples.push_back(std::isnan(height)
        ? terrain::NoStoredHeight<short>()
        : static_cast<short>(std::lround(std::clamp(height, -30000.0, 30000.0))));
  }
  return std::make_unique<terrain::MemoryTiles<short>>(samples.data(),
    terrain::TileLayout{ field.Width, field.Height, terrain::kRayTileLevel }, terrain::SerialFor);
}

/// A field in tiles, as integers or floats.
inline std::unique_ptr<terrain::TileSource> MakeTiles(const terrain::TestField& field, bool integer)
{
  return integer
    ? IntegerTiles(field)
    : terrain::MakeMemoryTiles(field.View(), terrain::kRayTileLevel, terrain::SerialFor);
}

/// All tiles, two thirds of them, and the coarsest alone.
inline void ShowSome(terrain::TiledField& field, unsigned seed)
{
  std::minstd_rand generator(seed);
  field.ShowIf([&](const terrain::TileKey&)
    { return seed % 3 == 0 || (seed % 3 == 1 && generator() % 3u != 0); });
}
}

#endif
