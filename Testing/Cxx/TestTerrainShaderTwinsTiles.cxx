// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainTiles.glsl and vtkTerrainTileTrace.glsl against their twins in src/core/:
// fields in tiles of which some are missing, with holes and without, as floats and as integers.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestTiles.h"
#include "core/surface/TileReduction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::TerrainRay;
using terrain::TestField;
using terrain::Tile;
using terrain::TiledField;
using terrain::TileKey;
using vtkTerrainTesting::Beams;
using vtkTerrainTesting::ReadShader;

constexpr int kCells = 2000;

/// Tiles on the GPU: a layer a slot, laid out as render/TileTextures does.
class TileArrays
{
public:
  TileArrays(vtkRenderWindow* window, const TiledField& field)
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

  /// What programs begin with.
  std::string Declarations() const
  {
    terrain::Features features;
    features.Way = terrain::Features::Ways::Pyramid;
    features.IntegerHeights = this->Integer;
    features.Gathers = terrain::Driver().Gathers;
    features.Tiles = true;
    features.Within = true;
    return features.Defines() + terrain::Features::Constants() + vtkTerrainTesting::CountVisits() +
      ReadShader("vtkTerrainTiles") + ReadShader("vtkTerrainHeights") +
      ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid") +
      ReadShader("vtkTerrainTileTrace") + vtkTerrainTesting::InputRay();
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
  void Lay(const Tile* tile, std::size_t slot, std::vector<float>& heights) const
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
    vtkTerrainTesting::PrepareTexture(window, texture, internal, format);
    texture->AssignToExistingTexture(name, GL_TEXTURE_2D_ARRAY);
  }

  const TiledField& Field;
  const terrain::HeightCodes Codes;
  bool Integer = false;
  unsigned int Names[2] = { 0, 0 };
  vtkNew<vtkTextureObject> Heights;
  vtkNew<vtkTextureObject> Bounds;
  vtkNew<vtkTextureObject> Pages;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};

/// A field in tiles of 16-bit integers; heights beyond them are cut.
std::unique_ptr<terrain::TileSource> integerTiles(const TestField& field)
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

/// All tiles, two thirds of them, and the coarsest alone.
void showSome(TiledField& field, unsigned seed)
{
  std::minstd_rand generator(seed);
  field.ShowIf(
    [&](const TileKey&) { return seed % 3 == 0 || (seed % 3 == 1 && generator() % 3u != 0); });
}

/// Traces rays by both, exactly or within a tolerance; returns the number of hits.
int compareTraces(vtkRenderWindow* window, const TiledField& field, const TileArrays& arrays,
  unsigned seed, bool within)
{
  const float maximum = field.Rays.heights.maximumCode;
  const Beams beams(field.Rays.heights.size, maximum, seed);
  const glm::vec4 tolerance =
    within ? glm::vec4(2.0f, 0.3f * maximum, 3.0f, 0.3f * maximum) : glm::vec4(0.0f);
  vtkTerrainTesting::Paths paths;
  paths.Declarations = arrays.Declarations() + "uniform vec4 tolerance;\n";
  paths.Trace = "terrainTraceTiles(inputRay(input0, input1, input2), tolerance)";
  paths.MaximumCode = maximum;
  paths.SetUniforms = [&](vtkShaderProgram* program)
  {
    arrays.SetUniforms(program);
    program->SetUniform4f("tolerance", &tolerance[0]);
  };
  paths.Twin = [&](const TerrainRay& ray, std::uint32_t& visits)
  {
    return field.Rays.TraceTiles(ray, tolerance,
      [&](glm::ivec2 node, int level, bool) { vtkTerrainTesting::AddVisit(visits, node, level); });
  };
  return vtkTerrainTesting::ExpectSamePaths(window, paths, beams);
}

/// Reads slots, codes, bounds and heights of random cells by both.
void compareReads(
  vtkRenderWindow* window, const TiledField& field, const TileArrays& arrays, unsigned seed)
{
  const terrain::TileSlots& slots = field.Slots;
  const glm::ivec2 size = field.Rays.heights.size;
  std::minstd_rand random(seed);
  std::vector<std::vector<float>> inputs(1);
  std::vector<glm::vec4> expected[3];
  for (int k = 0; k < kCells; ++k)
  {
    const glm::ivec2 cell(
      random() % static_cast<unsigned>(size.x - 1), random() % static_cast<unsigned>(size.y - 1));
    const auto level = static_cast<int>(random() % static_cast<unsigned>(slots.PyramidTop() + 1));
    const float part = static_cast<float>(random() % 4096u) / 1024.0f - 2.0f;
    inputs[0].insert(inputs[0].end(),
      { static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(level), part });
    int finest = level;
    const int slot = slots.FinestSlot(cell, finest);
    const glm::vec2 bounds =
      finest > 0 ? slots.SlotBounds(cell >> finest, finest, slot) : glm::vec2(0.0f);
    const bool empty = bounds.x < bounds.y;
    expected[0].emplace_back(slots.TileSlot(cell >> level, level), finest, empty ? 0.0f : bounds.x,
      empty ? 0.0f : bounds.y);
    expected[1].push_back(slots.TileCellCodes(cell));
    expected[2].emplace_back(
      slots.TileHeight(cell, { part, 0.5f * part }, std::min(level, slots.Top()), size),
      glm::vec3(0.0f));
  }
  const std::string bodies[3] = {
    "ivec2 cell = ivec2(input0.xy); int level = int(input0.z); int finest = level;"
    "int slot = terrainFinestSlot(cell, finest);"
    "vec2 bounds = finest > 0 ? terrainSlotBounds(cell >> finest, finest, slot) : vec2(0.0);"
    "result = vec4(terrainTileSlot(cell >> level, level), finest,"
    "bounds.x < bounds.y ? vec2(0.0) : bounds);",
    "result = terrainTileCellCodes(ivec2(input0.xy));",
    "result.x = terrainTileHeight(ivec2(input0.xy), vec2(input0.w, 0.5 * input0.w),"
    "min(int(input0.z), terrainTileTop), terrainSize);"
  };
  for (int part = 0; part < 3; ++part)
  {
    SCOPED_TRACE(part);
    const std::vector<float> values = vtkTerrainTesting::RunShader(window, arrays.Declarations(),
      bodies[part], inputs, [&](vtkShaderProgram* program) { arrays.SetUniforms(program); });
    ASSERT_EQ(values.size(), 4 * expected[part].size());
    int different = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      const float number = expected[part][k / 4][static_cast<int>(k % 4)];
      different += std::abs(values[k] - number) <= 1e-6f * std::max(1.0f, std::abs(number)) ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
  }
}
}

//------------------------------------------------------------------------------
TEST(TerrainShaderTwinsTiles, TakeTheSamePath)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  int hits = 0;
  for (const TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    ++seed;
    const bool integer = seed / 3 % 2 == 1;
    TiledField field(integer
        ? integerTiles(test)
        : terrain::MakeMemoryTiles(test.View(), terrain::kRayTileLevel, terrain::SerialFor));
    if (field.Slots.Top() < 1)
    {
      continue;
    }
    showSome(field, seed);
    const TileArrays arrays(scene.Window, field);
    hits += compareTraces(scene.Window, field, arrays, seed, false);
    hits += compareTraces(scene.Window, field, arrays, seed, true);
    compareReads(scene.Window, field, arrays, seed);
  }
  EXPECT_GT(hits, 1000);
}
