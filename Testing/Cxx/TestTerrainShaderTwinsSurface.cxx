// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points that pixels show, with their normals at every distance, and the light that they get:
// shaders/vtkTerrainSurface.glsl, vtkTerrainGradient.glsl, vtkTerrainLight.glsl and
// vtkTerrainSky.glsl against their twins in src/core/rays/ShadedSurface.h and
// src/core/surface/HeightGradient.h.
#include "vtkTerrainTestPoints.h"
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTiles.h"
#include "vtkTerrainTesting.h"

#include "core/rays/ShadedSurface.h"
#include "core/surface/HeightSlopes.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::ShadedSurface;
using vtkTerrainTesting::RaysOf;
using vtkTerrainTesting::ReadShader;

constexpr int kPoints = 2000;
// Differing numbers of a comparison that are told one by one.
constexpr int kTold = 5;

/// Hills with a hole, as steep as real ones, and wide enough for three levels of mean slopes.
terrain::TestField WideField()
{
  return { "wide", 200, 150,
    [](int i, int j)
    {
      const bool hole = i / 9 == 7 && j / 9 == 5;
      return hole ? std::nan("") : 6.0 + 4.0 * std::sin(0.11 * i) * std::cos(0.23 * j) + 0.06 * j;
    } };
}

/// A surface and where it is looked at.
struct Shown
{
  std::vector<glm::vec2> Pixels;
  std::vector<float> Distances;
  std::vector<ShadedSurface> Points; ///< cells and fractions alone are set
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(2);

  /// Points of valid cells, at distances of which pixels are a part of a cell to all of the field.
  template <typename CodesOf>
  Shown(const glm::ivec2& size, const CodesOf& codesOf, double farthest)
  {
    std::mt19937 generator(5);
    const auto number = [&](double low, double high)
    { return static_cast<float>(std::uniform_real_distribution<double>(low, high)(generator)); };
    while (this->Points.size() < kPoints)
    {
      ShadedSurface point;
      point.Cell = { static_cast<int>(number(0.0, size.x - 1.001)),
        static_cast<int>(number(0.0, size.y - 1.001)) };
      point.Fraction = { number(0.01, 0.99), number(0.01, 0.99) };
      point.Front = this->Points.size() % 5 != 0;
      point.Cut = this->Points.size() % 7 == 0;
      const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
      const auto distance = static_cast<float>(std::pow(10.0, number(1.0, farthest)));
      if (glm::all(glm::greaterThanEqual(codesOf(point.Cell), glm::vec4(0.0f))))
      {
        this->Pixels.push_back(pixel);
        this->Distances.push_back(distance);
        this->Points.push_back(point);
        this->Add(0, { glm::vec2(point.Cell), point.Fraction });
        this->Add(1, { pixel, distance, (point.Front ? 1.0f : 0.0f) + (point.Cut ? 2.0f : 0.0f) });
      }
    }
  }

  /// Moves the pixels and distances to where a perspective view has the points, codeOf() high.
  template <typename CodeOf>
  void Project(const CodeOf& codeOf)
  {
    const glm::dmat4 view = vtkTerrainTesting::ViewOf();
    for (std::size_t k = 0; k < this->Points.size(); ++k)
    {
      const ShadedSurface& point = this->Points[k];
      const double code = codeOf(point);
      const glm::dvec2 at = glm::dvec2(point.Cell) + glm::dvec2(point.Fraction);
      const glm::dvec4 positionVC = view * glm::dvec4(at, code, 1.0);
      const glm::dvec4 display = glm::perspective(0.6, 2.0, 1.0, 300.0) * positionVC;
      this->Distances[k] = static_cast<float>(-positionVC.z);
      this->Pixels[k] = glm::dvec2(200.0, 100.0) * (0.5 * glm::dvec2(display) / display.w + 0.5);
      float* input = &this->Inputs[1][4 * k];
      input[0] = this->Pixels[k].x;
      input[1] = this->Pixels[k].y;
      input[2] = this->Distances[k];
    }
  }

private:
  void Add(std::size_t input, const glm::vec4& value)
  {
    this->Inputs[input].insert(this->Inputs[input].end(), &value[0], &value[0] + 4);
  }
};

/// GLSL: the surface at the point of the inputs.
const std::string kSurfaceAt =
  "bool front = mod(input1.w, 2.0) > 0.5; ivec2 cell = ivec2(input0.xy);"
  "TerrainSurface surface = terrainSurfaceAt(cell, input0.zw, terrainCellCodes(cell),"
  "terrainPositionVC(input1.xy, input1.z), front); surface.cut = input1.w > 1.5;";

/// What a program of meshes and, with lights that cast shadows, their rays is built from.
std::string Declarations(terrain::Features features)
{
  features.Way = terrain::Features::Ways::Mesh;
  std::string text = features.Defines() + terrain::Features::Constants();
  text += features.Tiles ? ReadShader("vtkTerrainTiles") : "";
  for (const char* name : { "Heights", "Columns", "Ray", "View", "Gradient", "Surface", "Sky" })
  {
    text += ReadShader(std::string("vtkTerrain") + name);
  }
  if (features.ShadowMask != 0)
  {
    text += ReadShader("vtkTerrainPyramid") + ReadShader("vtkTerrainOutlook") +
      ReadShader("vtkTerrainLight");
  }
  return text;
}

class Slopes
{
public:
  Slopes(vtkRenderWindow* window, const terrain::HeightSlopes& slopes)
    : Scale(static_cast<float>(slopes.GetScale()))
  {
    vtkTerrainTesting::PrepareTexture(window, this->Texture, GL_RG16_SNORM, GL_RG);
    this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    const auto& levels = slopes.GetLevels();
    this->Texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
    auto* first = const_cast<terrain::SlopeTexel*>(levels[0].Texels.data());
    this->Texture->Create2DFromRaw(static_cast<unsigned int>(levels[0].Size.x),
      static_cast<unsigned int>(levels[0].Size.y), 2, VTK_SHORT, first);
    this->Texture->Activate();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t k = 0; k < levels.size(); ++k)
    {
      glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(k), GL_RG16_SNORM, levels[k].Size.x,
        levels[k].Size.y, 0, GL_RG, GL_SHORT, levels[k].Texels.data());
    }
  }
  Slopes(const Slopes&) = delete;
  Slopes& operator=(const Slopes&) = delete;
  ~Slopes()
  {
    this->Texture->Deactivate();
  }
  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniformi("terrainSlopes", this->Texture->GetTextureUnit());
    program->SetUniformf("terrainSlopesScale", this->Scale);
  }

private:
  float Scale;
  vtkNew<vtkTextureObject> Texture;
};

/// Runs a shader over the points, and counts results that are off by more than is allowed.
int CountDifferent(vtkRenderWindow* window, const std::string& text, const std::string& body,
  const Shown& shown, const std::function<void(vtkShaderProgram*)>& setUniforms,
  const std::function<glm::vec4(std::size_t)>& twin, float allowed)
{
  const std::vector<float> drawn =
    vtkTerrainTesting::RunShader(window, text, kSurfaceAt + body, shown.Inputs, setUniforms);
  EXPECT_EQ(drawn.size(), 4 * shown.Points.size());
  int different = drawn.empty() ? kPoints : 0;
  for (std::size_t k = 0; k < drawn.size(); ++k)
  {
    const float expected = twin(k / 4)[static_cast<int>(k % 4)];
    const bool isSame =
      std::abs(drawn[k] - expected) <= allowed * std::max(1.0f, std::abs(expected));
    different += isSame ? 0 : 1;
    EXPECT_TRUE(isSame || different > kTold)
      << "point " << k / 4 << ", number " << k % 4 << ": " << drawn[k] << " for " << expected;
  }
  return different;
}

/// Normals are compared to a part of 1, as long as slopes count as much as the vertical does: a
/// texture's filter has 8 bits between texels both ways and between levels, each of which rounds
/// slopes of -1 to 1 by up to 1/256. Gradients are differences of codes, each rounded.
template <typename Heights>
void CompareSurfaces(vtkRenderWindow* window, const std::string& text, const Heights& heights,
  float maximumCode, const terrain::HeightSlopes& slopes,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const bool exact = vtkTerrainTesting::CalculatesAsTwin(window);
  const float normalError = exact ? 4e-3f : 3.0f / 256.0f;
  const float gradientError = exact ? 1e-5f : std::max(1e-5f, 4e-7f * maximumCode);
  for (const bool flat : { false, true })
  {
    SCOPED_TRACE(flat);
    const terrain::PixelRays rays = RaysOf(flat);
    const Shown shown(
      heights.size, [&](const glm::ivec2& cell) { return heights.CellCodes(cell); }, 4.5);
    const auto surface = [&](std::size_t k)
    {
      const ShadedSurface& point = shown.Points[k];
      return terrain::SurfaceAt(rays, heights, slopes, point.Cell, point.Fraction,
        heights.CellCodes(point.Cell),
        terrain::PositionVC(rays, shown.Pixels[k], shown.Distances[k]), point.Front, flat);
    };
    const auto set = [&](vtkShaderProgram* program)
    {
      vtkTerrainTesting::SetRays(program, rays);
      program->SetUniformi("terrainFlat", flat ? 1 : 0);
      setUniforms(program);
    };
    EXPECT_EQ(CountDifferent(
                window, text, "result = vec4(surface.normalVC, surface.code);", shown, set,
                [&](std::size_t k) { return glm::vec4(surface(k).NormalVC, surface(k).Code); },
                flat ? gradientError : normalError),
      0);
    EXPECT_EQ(
      CountDifferent(
        window, text, "result = vec4(surface.gradient, vec2(surface.cell) + surface.fraction);",
        shown, set,
        [&](std::size_t k)
        {
          const ShadedSurface there = surface(k);
          return glm::vec4(there.Gradient, glm::vec2(there.Cell) + there.Fraction);
        },
        gradientError),
      0);
  }
}

/// A sun, a wide one, and a lamp.
std::vector<terrain::ShadowLight> MakeLights(const glm::dmat4& view)
{
  const auto sun = [&](double azimuth, double low, double high)
  {
    const glm::dvec4 way(std::sin(azimuth), std::cos(azimuth), 0.5 * (low + high), 0.0);
    terrain::ShadowLight light;
    light.WayGC = { glm::vec2(way), low, high };
    light.WayVC = glm::vec4(view * way);
    const double middle = 0.5 * (std::atan(low) + std::atan(high));
    light.Disc = { middle, std::atan(high) - middle, 1.0, 0.9 };
    return light;
  };
  terrain::ShadowLight lamp;
  lamp.WayVC = glm::vec4(view * glm::dvec4(60.0, 40.0, 14.0, 1.0));
  lamp.Disc = { 0.0f, 0.0f, 1.0f, 1.0f };
  return { sun(0.8, 0.06, 0.12), sun(2.5, -0.02, 0.4), lamp };
}

void SetLights(vtkShaderProgram* program, const std::vector<terrain::ShadowLight>& lights)
{
  std::vector<glm::vec4> ways;
  std::vector<glm::vec4> views;
  std::vector<glm::vec4> discs;
  for (const terrain::ShadowLight& light : lights)
  {
    ways.push_back(light.WayGC);
    views.push_back(light.WayVC);
    discs.push_back(light.Disc);
  }
  const int count = static_cast<int>(lights.size());
  program->SetUniform4fv("terrainLightsGC", count, &ways[0][0]);
  program->SetUniform4fv("terrainLightsVC", count, &views[0][0]);
  program->SetUniform4fv("terrainLightDiscs", count, &discs[0][0]);
}

/// The least and the greatest share of a light at a point and a little beside it: what a lamp gives
/// may turn with what float rounds of the point's place.
template <typename Shares>
glm::vec2 SharesAround(const Shares& shares, const std::vector<terrain::ShadowLight>& lights,
  std::size_t light, const ShadedSurface& surface, const terrain::PixelRays& rays,
  const glm::vec2& pixel)
{
  glm::vec2 range(2.0f, -1.0f);
  for (int side = 0; side < 7; ++side)
  {
    ShadedSurface moved = surface;
    const float step = -2e-5f * surface.PositionVC.z;
    moved.PositionVC[side % 3] += side == 6 ? 0.0f : (side < 3 ? step : -step);
    const float share = shares.FindShares(lights, moved, rays, glm::dvec2(pixel))[light];
    range = { std::min(range.x, share), std::max(range.y, share) };
  }
  return range;
}

struct ShareCounts
{
  int Different = 0;
  int Between = 0;
  int Lit[3] = { 0, 0, 0 };
  int Dark[3] = { 0, 0, 0 };
};

/// How the shares that a shader has drawn, and packed, are those of the twin, and of which kind.
template <typename Heights, typename Shares>
ShareCounts CountShares(const Shown& shown, const terrain::PixelRays& rays, const Heights& heights,
  const Shares& shares, const std::vector<terrain::ShadowLight>& lights,
  const std::vector<float>& drawn)
{
  ShareCounts counts;
  for (std::size_t k = 0; k < shown.Points.size(); ++k)
  {
    const ShadedSurface& point = shown.Points[k];
    ShadedSurface surface = terrain::SurfaceAt(rays, heights, {}, point.Cell, point.Fraction,
      heights.CellCodes(point.Cell), terrain::PositionVC(rays, shown.Pixels[k], shown.Distances[k]),
      point.Front, true);
    surface.Cut = point.Cut;
    std::vector<float> found(&drawn[4 * k], &drawn[4 * k] + 3);
    counts.Different +=
      drawn[4 * k + 3] == terrain::PackShares(found, terrain::kShareSteps).x ? 0 : 1;
    for (std::size_t light = 0; light < lights.size(); ++light)
    {
      const glm::vec2 range = SharesAround(shares, lights, light, surface, rays, shown.Pixels[k]);
      counts.Different +=
        found[light] >= range.x - 1e-3f && found[light] <= range.y + 1e-3f ? 0 : 1;
      counts.Between += found[light] > 0.15f && found[light] < 0.95f ? 1 : 0;
      counts.Lit[light] += found[light] == 1.0f ? 1 : 0;
      counts.Dark[light] += found[light] < 0.11f ? 1 : 0;
    }
  }
  return counts;
}

class TerrainShaderTwinsSurface : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->Render();
  }
  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(16, 16);
};
}

TEST_F(TerrainShaderTwinsSurface, AtEveryDistance)
{
  const terrain::CodedField<float> field(WideField());
  terrain::HeightSlopes slopes;
  slopes.Build(field.TexelView, field.Codes, terrain::SerialFor);
  ASSERT_GE(slopes.GetLevels().size(), 3U);
  const Slopes texture(this->Scene.Window, slopes);
  vtkTerrainTesting::FieldTextures<float> textures(this->Scene.Window, field, false);
  CompareSurfaces(this->Scene.Window, Declarations(textures.GetFeatures()), field.Coded.heights,
    field.Coded.heights.maximumCode, slopes,
    [&](vtkShaderProgram* program)
    {
      textures.SetUniforms(program);
      texture.SetUniforms(program);
    });
}

TEST_F(TerrainShaderTwinsSurface, WithDetail)
{
  const terrain::CodedSum<float> sum(
    WideField(), terrain::RandomDetail({ 16, 16 }, 4.0, 1), 2, 0.7);
  terrain::HeightSlopes slopes;
  slopes.Build(sum.Base.TexelView, sum.Base.Codes, terrain::SerialFor);
  const Slopes texture(this->Scene.Window, slopes);
  vtkTerrainTesting::SumTextures<float> textures(this->Scene.Window, sum);
  textures.FilterDetail();
  CompareSurfaces(this->Scene.Window, Declarations(textures.GetFeatures()), sum.Coded.heights,
    sum.Coded.heights.maximumCode, slopes,
    [&](vtkShaderProgram* program)
    {
      textures.SetUniforms(program);
      texture.SetUniforms(program);
    });
}

TEST_F(TerrainShaderTwinsSurface, InTiles)
{
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    if (test.Name != "hills" && test.Name != "holes")
    {
      continue;
    }
    SCOPED_TRACE(test.Name);
    const bool integer = test.Name == "holes";
    const unsigned seed = integer ? 3 : 4; // all of them, and two thirds
    terrain::TiledField field(vtkTerrainTesting::MakeTiles(test, integer));
    vtkTerrainTesting::ShowSome(field, seed);
    const vtkTerrainTesting::TileArrays arrays(this->Scene.Window, field);
    const terrain::FinestHeights heights{ &field.Slots, field.Rays.heights.size };
    CompareSurfaces(this->Scene.Window, Declarations(arrays.GetFeatures()), heights,
      field.Rays.heights.maximumCode, {},
      [&](vtkShaderProgram* program) { arrays.SetUniforms(program); });
  }
}

TEST_F(TerrainShaderTwinsSurface, HaveTheSameLightOfTheSky)
{
  const terrain::CodedField<float> field(WideField());
  vtkTerrainTesting::FieldTextures<float> textures(this->Scene.Window, field, false);
  terrain::SkyShares sky;
  sky.Size = { 50, 38 };
  std::minstd_rand random(7);
  for (int k = 0; k < sky.Size.x * sky.Size.y; ++k)
  {
    sky.Texels.push_back(static_cast<float>(random() % 1000u) / 999.0f);
  }
  sky.Scale = 1.0f / (4.0f * glm::vec2(sky.Size));
  sky.Light = 0.8f;
  vtkNew<vtkTextureObject> texture;
  vtkTerrainTesting::PrepareTexture(this->Scene.Window, texture, GL_R32F, GL_RED);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->Create2DFromRaw(50, 38, 1, VTK_FLOAT, sky.Texels.data());
  texture->Activate();
  const terrain::PixelRays rays = RaysOf(false);
  const Shown shown(
    field.Coded.heights.size,
    [&](const glm::ivec2& cell) { return field.Coded.heights.CellCodes(cell); }, 2.0);
  terrain::Features features = textures.GetFeatures();
  features.Sky = true;
  EXPECT_EQ(
    CountDifferent(
      this->Scene.Window, Declarations(features), "result.x = terrainSkyShare(surface);", shown,
      [&](vtkShaderProgram* program)
      {
        vtkTerrainTesting::SetRays(program, rays);
        textures.SetUniforms(program);
        program->SetUniformi("terrainSky", texture->GetTextureUnit());
        program->SetUniform2f("terrainSkyScale", &sky.Scale[0]);
        program->SetUniformf("terrainSkyLight", sky.Light);
      },
      [&](std::size_t k) { return glm::vec4(sky.SkyShare(shown.Points[k], 0), 0.0f, 0.0f, 0.0f); },
      2.0f / 256.0f),
    0);
  texture->Deactivate();
}

// Lights before planes that cut the land; of patches, and of columns on their tops.
TEST_F(TerrainShaderTwinsSurface, SeeTheSameSharesOfLights)
{
  for (const bool columns : { false, true })
  {
    SCOPED_TRACE(columns);
    terrain::CodedField<float> field(WideField());
    field.Coded.columns = columns;
    const auto& heights = field.Coded.heights;
    vtkTerrainTesting::FieldTextures<float> textures(this->Scene.Window, field, true);
    const terrain::PixelRays rays = RaysOf(false);
    const glm::dmat4 view = vtkTerrainTesting::ViewOf();
    const std::vector<terrain::ShadowLight> lights = MakeLights(view);
    const terrain::OutlookSearch<terrain::CodedPyramid<float>> search{ field.Coded };
    terrain::LightShares<terrain::CodedPyramid<float>> shares{ search,
      glm::mat3(glm::inverse(glm::dmat3(view))),
      { glm::vec4(1.0f, 0.0f, 0.0f, 90.0f), glm::vec4(0.0f, 0.0f, 1.0f, 400.0f) } };
    Shown shown(
      heights.size, [&](const glm::ivec2& cell) { return heights.CellCodes(cell); }, 2.0);
    shown.Project(
      [&](const ShadedSurface& point)
      {
        const glm::vec4 codes = heights.CellCodes(point.Cell);
        return columns
          ? terrain::ColumnCode(codes, glm::greaterThanEqual(point.Fraction, glm::vec2(0.5f)))
          : terrain::PatchCode(codes, point.Fraction);
      });
    terrain::Features features = textures.GetFeatures();
    features.ShadowMask = 7;
    features.ClipPlanes = 2;
    const std::vector<float> drawn =
      vtkTerrainTesting::RunShader(this->Scene.Window, Declarations(features),
        kSurfaceAt +
          "float found[TERRAIN_SHADOWS]; terrainFindShares(input1.xy, surface, found);"
          "result = vec4(found[0], found[1], found[2], terrainPackShares(found).x);",
        shown.Inputs,
        [&](vtkShaderProgram* program)
        {
          vtkTerrainTesting::SetRays(program, rays);
          textures.SetUniforms(program);
          program->SetUniformi("terrainFlat", 1);
          glm::mat4 toGrid(glm::inverse(view));
          program->SetUniformMatrix4x4("terrainViewToGrid", &toGrid[0][0]);
          program->SetUniformi("terrainClipPlaneCount", 2);
          program->SetUniform4fv("terrainClipPlanesVC", 2, &shares.PlanesVC[0][0]);
          SetLights(program, lights);
        });
    ASSERT_EQ(drawn.size(), 4 * shown.Points.size());
    const ShareCounts counts = CountShares(shown, rays, heights, shares, lights, drawn);
    EXPECT_EQ(counts.Different, 0);
    EXPECT_GT(counts.Between, 50);
    for (std::size_t light = 0; light < lights.size(); ++light)
    {
      EXPECT_GT(counts.Lit[light], 200) << light;
      EXPECT_GT(counts.Dark[light], 50) << light;
    }
  }
}

// What a compute shader has packed is read back to half a step, and as the twin reads it.
TEST_F(TerrainShaderTwinsSurface, UnpackTheSameShares)
{
  constexpr std::size_t lights = 8; // two in each channel
  std::minstd_rand random(3);
  std::vector<std::vector<float>> inputs(2);
  for (int k = 0; k < kPoints; ++k)
  {
    for (std::size_t light = 0; light < lights; ++light)
    {
      const float share = k % 3 == 0 ? static_cast<float>(random() % 2u)
                                     : static_cast<float>(random() % 10001u) / 10000.0f;
      inputs[light / 4].push_back(share);
    }
  }
  terrain::Features features;
  features.Gathers = terrain::Driver().Gathers;
  features.ShadowMask = 255;
  features.ReadsLights = true;
  const std::string text = Declarations(features);
  const std::string read =
    "float given[TERRAIN_SHADOWS]; float found[TERRAIN_SHADOWS]; for (int i = 0; i < 4; ++i)"
    "{ given[i] = input0[i]; given[4 + i] = input1[i]; }"
    "terrainUnpackShares(terrainPackShares(given), found);";
  for (std::size_t half = 0; half < 2; ++half)
  {
    const std::string first = half == 0 ? "0" : "4";
    const std::vector<float> drawn = vtkTerrainTesting::RunShader(this->Scene.Window, text,
      read + "for (int i = 0; i < 4; ++i) { result[i] = found[" + first + " + i]; }", inputs,
      nullptr);
    ASSERT_EQ(drawn.size(), inputs[half].size());
    int different = 0;
    for (std::size_t k = 0; k < kPoints; ++k)
    {
      std::vector<float> given(&inputs[0][4 * k], &inputs[0][4 * k] + 4);
      given.insert(given.end(), &inputs[1][4 * k], &inputs[1][4 * k] + 4);
      const std::vector<float> back = terrain::UnpackShares(
        terrain::PackShares(given, terrain::kShareSteps), lights, terrain::kShareSteps);
      for (std::size_t i = 0; i < 4; ++i)
      {
        const float share = drawn[4 * k + i];
        different += std::abs(share - given[4 * half + i]) <= 0.51f / (terrain::kShareSteps - 1) &&
            std::abs(share - back[4 * half + i]) <= 1e-6f
          ? 0
          : 1;
      }
    }
    EXPECT_EQ(different, 0);
  }
}
