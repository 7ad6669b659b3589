// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainOutlook.glsl against its twin src/core/rays/Outlook.h: horizons of points of
// the surface, of columns, of detail, in tiles of which some are missing, and with bounds of the
// rays of one light, node for node.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTiles.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestOutlooks.h"
#include "core/rays/Outlook.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace
{
using terrain::Outlook;
using terrain::OutlookSearch;
using vtkTerrainTesting::ReadShader;

/// What lights that cast shadows are drawn with; counts visits.
std::string Declarations(terrain::Features features, bool bounded)
{
  features.BoundsShadows = bounded;
  std::string text =
    features.Defines() + terrain::Features::Constants() + vtkTerrainTesting::CountVisits();
  text += features.Tiles ? ReadShader("vtkTerrainTiles") : "";
  text += ReadShader("vtkTerrainHeights");
  text += features.Columns ? ReadShader("vtkTerrainColumns") : "";
  text += ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid");
  text += features.Tiles ? ReadShader("vtkTerrainTileTrace") : "";
  return text + ReadShader("vtkTerrainOutlook") +
    "TerrainOutlook inputOutlook(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainOutlook(ivec2(a.xy), a.zw, terrainCellCodes(ivec2(a.xy)), c.x, b.xy, b.z, "
    "b.w, c.y, c.z > 0.0); }\n";
}

/// What the slopes of cells, of which tangents are made, may be off by: as a part of the largest
/// code. Compilers interpolate in another order.
constexpr float kRoundedCodes = 1e-7f;

/// Bounds of shadows on the GPU.
class BoundsTexture
{
public:
  BoundsTexture(vtkRenderWindow* window, const terrain::ShadowBounds& bounds)
    : Bounds(bounds)
  {
    vtkTerrainTesting::PrepareTexture(window, this->Texture, GL_RG32F, GL_RG);
    std::vector<glm::vec2> texels = bounds.Texels;
    this->Texture->Create2DFromRaw(static_cast<unsigned int>(bounds.Size.x),
      static_cast<unsigned int>(bounds.Size.y), 2, VTK_FLOAT, texels.data());
    this->Texture->Activate();
  }
  BoundsTexture(const BoundsTexture&) = delete;
  BoundsTexture& operator=(const BoundsTexture&) = delete;
  ~BoundsTexture()
  {
    this->Texture->Deactivate();
  }

  void SetUniforms(vtkShaderProgram* program) const
  {
    const terrain::ShadowBounds& bounds = this->Bounds;
    const glm::vec4 axes(bounds.Major, bounds.Minor);
    const glm::vec4 place(
      bounds.MajorStart, bounds.Slope, bounds.FirstStrip, std::exp2(-bounds.Level));
    const glm::vec2 rises(bounds.LowRise, bounds.HighRise);
    program->SetUniformi("terrainShadowBounds", this->Texture->GetTextureUnit());
    program->SetUniform4f("terrainBoundsAxes", &axes[0]);
    program->SetUniform4f("terrainBoundsPlace", &place[0]);
    program->SetUniform2f("terrainBoundsRises", &rises[0]);
    program->SetUniformi("terrainBoundsLevel", bounds.Level);
  }

private:
  const terrain::ShadowBounds& Bounds;
  vtkNew<vtkTextureObject> Texture;
};

/// Outlooks as the inputs of a shader.
std::vector<std::vector<float>> InputsOf(const std::vector<Outlook>& outlooks, bool bounded)
{
  std::vector<std::vector<float>> inputs(3);
  for (const Outlook& outlook : outlooks)
  {
    const glm::vec4 values[3] = { { glm::vec2(outlook.cell), outlook.fraction },
      { outlook.direction, outlook.low, outlook.high },
      { outlook.code, outlook.end, bounded ? 1.0f : 0.0f, 0.0f } };
    for (int k = 0; k < 3; ++k)
    {
      inputs[static_cast<std::size_t>(k)].insert(
        inputs[static_cast<std::size_t>(k)].end(), &values[k][0], &values[k][0] + 4);
    }
  }
  return inputs;
}

/// How many horizons are no higher than the lowest that matters, between, and above the highest.
using Kinds = std::array<int, 3>;

/// Horizons of random points by both: the same nodes in the same order and the same tangent where
/// the driver calculates as the twin, else a tangent of the point or of one nearby. Any tangent
/// above the highest that matters stands for all such.
template <typename Rays>
void CompareOutlooks(vtkRenderWindow* window, const OutlookSearch<Rays>& search,
  const std::string& text, const std::function<void(vtkShaderProgram*)>& setUniforms,
  const std::vector<Outlook>& outlooks, Kinds& kinds)
{
  const bool bounded = search.bounds != nullptr;
  const std::vector<float> drawn = vtkTerrainTesting::RunShader(window, text,
    "float tangent = terrainHorizonTangent(inputOutlook(input0, input1, input2));"
    "result = vec4(tangent, terrainVisits & 0xffffffu, 0.0, 0.0);",
    InputsOf(outlooks, bounded), setUniforms);
  ASSERT_EQ(drawn.size(), 4 * outlooks.size());
  const float room = kRoundedCodes * search.rays.heights.maximumCode;
  int otherPaths = 0;
  int wrong = 0;
  for (std::size_t k = 0; k < outlooks.size(); ++k)
  {
    const Outlook& outlook = outlooks[k];
    std::uint32_t visits = 0;
    const float tangent = search.HorizonTangent(outlook,
      [&](glm::ivec2 node, int level) { vtkTerrainTesting::AddVisit(visits, node, level); });
    ++kinds[tangent <= outlook.low ? 0U : tangent <= outlook.high ? 1U : 2U];
    if (std::abs(drawn[4 * k] - tangent) <= 1e-6f * std::abs(tangent) + room &&
      static_cast<std::uint32_t>(drawn[4 * k + 1]) == (visits & 0xffffffu))
    {
      continue;
    }
    ++otherPaths;
    const auto countAs = [&](float s) { return s > outlook.high ? 2.0f * outlook.high + 1.0f : s; };
    terrain::TerrainRay place;
    place.anchorCell = outlook.cell;
    place.originGC = glm::vec3(outlook.fraction, 0.0f);
    terrain::TerrainHit seen;
    seen.found = true;
    seen.s = countAs(drawn[4 * k]);
    wrong += !vtkTerrainTesting::IsOfARayNearby(seen, place, search.rays.heights.maximumCode,
      [&](const terrain::TerrainRay& moved)
      {
        Outlook there = outlook;
        there.fraction = glm::clamp(glm::vec2(moved.originGC), 0.0f, 1.0f);
        terrain::SetCode(search, there);
        terrain::TerrainHit hit;
        hit.found = true;
        hit.s = countAs(search.HorizonTangent(there, [](glm::ivec2, int) {}));
        return hit;
      });
  }
  EXPECT_LE(otherPaths,
    vtkTerrainTesting::CalculatesAsTwin(window) ? 0 : static_cast<int>(outlooks.size()));
  EXPECT_EQ(wrong, 0);
}

template <typename Textures>
void CompareField(vtkRenderWindow* window, Textures& textures, unsigned seed, Kinds& kinds)
{
  using Rays = std::decay_t<decltype(textures.Coded)>;
  const OutlookSearch<Rays> search{ textures.Coded };
  CompareOutlooks(
    window, search, Declarations(textures.GetFeatures(), false),
    [&](vtkShaderProgram* program) { textures.SetUniforms(program); },
    terrain::RandomOutlooks(search, seed), kinds);
}

/// With bounds of the rays of one light.
template <typename Texel>
void CompareBounded(vtkRenderWindow* window, const terrain::CodedField<Texel>& field,
  vtkTerrainTesting::FieldTextures<Texel>& textures, unsigned seed, Kinds& kinds)
{
  const double azimuth = 0.7 * seed;
  terrain::ShadowRays rays;
  rays.Direction = { std::sin(azimuth), std::cos(azimuth) };
  rays.Low = 0.01 * (1.0 + field.Codes.MaximumCode);
  rays.High = 1.2 * rays.Low;
  const terrain::ShadowBounds bounds = terrain::MakeShadowBounds(field.Pyramid, 1,
    static_cast<double>(field.Codes.Bias), rays, field.Codes.MaximumCode, true, terrain::SerialFor);
  const BoundsTexture texture(window, bounds);
  const OutlookSearch<terrain::CodedPyramid<Texel>> search{ field.Coded, &bounds };
  std::vector<Outlook> outlooks = terrain::RandomOutlooks(search, seed);
  for (Outlook& outlook : outlooks)
  {
    outlook.direction = glm::vec2(rays.Direction);
    outlook.low = static_cast<float>(rays.Low);
    outlook.high = static_cast<float>(rays.High);
    outlook.end = 1e30f;
  }
  CompareOutlooks(
    window, search, Declarations(textures.GetFeatures(), true),
    [&](vtkShaderProgram* program)
    {
      textures.SetUniforms(program);
      texture.SetUniforms(program);
    },
    outlooks, kinds);
}

template <typename Texel>
void CompareAll(
  vtkRenderWindow* window, const terrain::TestField& test, unsigned seed, Kinds& kinds)
{
  terrain::CodedField<Texel> field(test);
  vtkTerrainTesting::FieldTextures<Texel> textures(window, field, seed % 4 < 2);
  CompareField(window, textures, seed, kinds);
  if (seed % 3 == 0)
  {
    field.Coded.columns = true;
    CompareField(window, textures, seed, kinds);
  }
  else if (field.Pyramid.LevelCount() > 0)
  {
    CompareBounded(window, field, textures, seed, kinds);
  }
}

/// Expects that points see all, some, and none of their lights.
void ExpectAll(const Kinds& kinds)
{
  for (const int count : kinds)
  {
    EXPECT_GT(count, 30);
  }
}
}

TEST(TerrainShaderTwinsOutlook, FindTheSameHorizons)
{
  Kinds kinds{};
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    if (++seed % 2 == 0)
    {
      CompareAll<std::uint16_t>(scene.Window, field, seed, kinds);
    }
    else
    {
      CompareAll<float>(scene.Window, field, seed, kinds);
    }
  }
  ExpectAll(kinds);
}

TEST(TerrainShaderTwinsOutlook, FindTheSameHorizonsOverDetail)
{
  Kinds kinds{};
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  for (const terrain::TestField& base : terrain::AdversarialFields())
  {
    if (base.Name == "hills" || base.Name == "holes")
    {
      SCOPED_TRACE(base.Name);
      const terrain::CodedSum<float> sum(base, terrain::RandomDetail({ 16, 16 }, 40.0, 1), 2, 0.7);
      vtkTerrainTesting::SumTextures<float> textures(scene.Window, sum);
      CompareField(scene.Window, textures, 7, kinds);
    }
  }
  ExpectAll(kinds);
}

TEST(TerrainShaderTwinsOutlook, FindTheSameHorizonsInTiles)
{
  Kinds kinds{};
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    ++seed;
    terrain::TiledField field(vtkTerrainTesting::MakeTiles(test, seed / 3 % 2 == 1));
    if (field.Slots.Top() < 1)
    {
      continue;
    }
    vtkTerrainTesting::ShowSome(field, seed);
    const vtkTerrainTesting::TileArrays arrays(scene.Window, field);
    const OutlookSearch<terrain::TiledPyramid> search{ field.Rays };
    CompareOutlooks(
      scene.Window, search, Declarations(arrays.GetFeatures(), false),
      [&](vtkShaderProgram* program) { arrays.SetUniforms(program); },
      terrain::RandomOutlooks(search, seed), kinds);
  }
  ExpectAll(kinds);
}
