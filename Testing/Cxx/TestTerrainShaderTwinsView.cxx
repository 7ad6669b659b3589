// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where rays begin and end, what they bring home, and slopes: functions of
// shaders/vtkTerrainView.glsl, vtkTerrainCast.glsl, vtkTerrainSighting.glsl and
// vtkTerrainGradient.glsl against their twins in src/core/.
#include "vtkTerrainTestItems.h"
#include "vtkTerrainTestPoints.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestFields.h"
#include "core/rays/PixelRays.h"
#include "core/rays/PyramidBeam.h"
#include "core/rays/Sighting.h"
#include "core/rays/SurfaceShading.h"
#include "core/surface/Cutting.h"
#include "core/surface/HeightGradient.h"
#include "render/Driver.h"
#include "render/Features.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr int Count = vtkTerrainTesting::NumberOfItems;
using vtkTerrainTesting::Items;
using vtkTerrainTesting::Numbers;
using vtkTerrainTesting::RaysOf;
using vtkTerrainTesting::ReadShader;
using vtkTerrainTesting::SetRays;

/// Rays of pixels, with what else all programs begin with.
std::string ReadView()
{
  terrain::Features features;
  features.Way = terrain::Features::Ways::Pyramid;
  features.Gathers = terrain::Driver().Gathers;
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView");
}

/// What casts rays begins with.
std::string ReadCast(const terrain::Features& features)
{
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") + ReadShader("vtkTerrainPyramid") +
    ReadShader("vtkTerrainTrace") + ReadShader("vtkTerrainSighting") + ReadShader("vtkTerrainCast");
}

/// One window for all tests.
class TerrainShaderTwinsView : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    Scene = std::make_unique<vtkTerrainTesting::Scene>(vtkTerrainTesting::MakeScene(16, 16));
    Scene->Window->Render();
  }
  static void TearDownTestSuite()
  {
    Scene = nullptr;
  }

  static std::unique_ptr<vtkTerrainTesting::Scene> Scene;
};

std::unique_ptr<vtkTerrainTesting::Scene> TerrainShaderTwinsView::Scene;
}

TEST_F(TerrainShaderTwinsView, EnterTheSameBoxes)
{
  for (const bool parallel : { false, true })
  {
    const terrain::PixelRays rays = RaysOf(parallel);
    const glm::vec3 minimum(0.0f, 0.0f, -2.0f);
    const glm::vec3 maximum(40.0f, 32.0f, 9.0f);
    Numbers number;
    Items items;
    int entered = 0;
    for (int k = 0; k < Count; ++k)
    {
      const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
      const glm::vec2 range(number(0.0, 120.0), number(80.0, 300.0));
      const glm::vec2 part = terrain::EnterBox(rays, pixel, range, minimum, maximum);
      entered += part.x < part.y ? 1 : 0;
      items.Add({ pixel, range }, glm::vec4(0.0f), { part, 0.0f, 0.0f });
    }
    EXPECT_GT(entered, Count / 10);
    EXPECT_LT(entered, Count * 9 / 10);
    const int different = items.CountDifferent(Scene->Window, ReadView(),
      "result.xy = terrainEnterBox(input0.xy, input0.zw);", 2e-5f,
      [&](vtkShaderProgram* program)
      {
        SetRays(program, rays);
        program->SetUniform3f("terrainBoxMinimum", &minimum[0]);
        program->SetUniform3f("terrainBoxMaximum", &maximum[0]);
      });
    EXPECT_EQ(different, 0) << (parallel ? "parallel" : "perspective");
  }
}

TEST_F(TerrainShaderTwinsView, AreClippedAlike)
{
  const terrain::PixelRays rays = RaysOf(false);
  const std::vector<glm::vec4> planes{ { 1.0f, 0.0f, 0.0f, 5.0f }, { 0.0f, -0.6f, -0.8f, -50.0f },
    { 0.3f, 0.0f, -1.0f, -70.0f } };
  Numbers number;
  Items items;
  int starts[4] = { 0, 0, 0, 0 };
  for (int k = 0; k < Count; ++k)
  {
    const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
    const glm::vec2 range(number(0.0, 120.0), number(80.0, 300.0));
    int begin = 0;
    const glm::vec2 part =
      terrain::ClipRange(planes, glm::vec3(terrain::AtPixel(rays.OriginVC, pixel)),
        glm::vec3(terrain::AtPixel(rays.DirectionVC, pixel)), range, begin);
    ++starts[begin + 1];
    items.Add({ pixel, range }, glm::vec4(0.0f), { part, static_cast<float>(begin), 0.0f });
  }
  for (const int count : starts)
  {
    EXPECT_GT(count, 20); // nowhere, and at each of the planes
  }
  terrain::Features features;
  features.Way = terrain::Features::Ways::Pyramid;
  features.Gathers = terrain::Driver().Gathers;
  features.ClipPlanes = 3;
  const std::string needed = ReadCast(features);
  const int different = items.CountDifferent(Scene->Window, needed,
    "int begin; result.xy = terrainClipRange(input0.xy, input0.zw, begin); result.z = begin;",
    1e-4f,
    [&](vtkShaderProgram* program)
    {
      SetRays(program, rays);
      program->SetUniformi("terrainClipPlaneCount", static_cast<int>(planes.size()));
      program->SetUniform4fv("terrainClipPlanesVC", static_cast<int>(planes.size()), &planes[0][0]);
    });
  EXPECT_EQ(different, 0);
}

// Of all pixels within four of a position.
TEST_F(TerrainShaderTwinsView, HaveTheSameBeamsOfTiles)
{
  for (const bool parallel : { false, true })
  {
    SCOPED_TRACE(parallel);
    const terrain::PixelRays rays = RaysOf(parallel);
    Numbers number;
    Items radii;
    Items growths;
    for (int k = 0; k < Count; ++k)
    {
      const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
      const float start = number(0.0, 100.0);
      const terrain::TerrainBeam beam = terrain::TileBeam(rays, pixel, 4.0, start, 300.0);
      radii.Add({ pixel, start, 4.0f }, glm::vec4(0.0f), { beam.radius, beam.ray.sEnd });
      growths.Add({ pixel, start, 4.0f }, glm::vec4(0.0f),
        { beam.growth, beam.ray.originGC.z + beam.ray.originLow });
    }
    const auto set = [&](vtkShaderProgram* program) { SetRays(program, rays); };
    terrain::Features features;
    features.Way = terrain::Features::Ways::Pyramid;
    const std::string needed = ReadCast(features) + ReadShader("vtkTerrainBeam");
    const std::string beam =
      "TerrainBeam beam = terrainTileBeam(input0.xy, input0.w, input0.z, 300.0);";
    EXPECT_EQ(radii.CountDifferent(Scene->Window, needed,
                beam + "result = vec4(beam.radius, beam.ray.sEnd);", 2e-6f, set),
      0);
    EXPECT_EQ(
      growths.CountDifferent(Scene->Window, needed,
        beam + "result = vec4(beam.growth, beam.ray.originGC.z + beam.ray.originLow);", 2e-6f, set),
      0);
  }
}

// From above and from below; with a tolerance, hits lie before the surface.
TEST_F(TerrainShaderTwinsView, SeeTheSameSide)
{
  for (const bool tolerance : { false, true })
  {
    SCOPED_TRACE(tolerance);
    constexpr float maximum = 30.0f;
    Numbers number;
    Items items;
    int fronts = 0;
    while (items.Expected.size() < Count)
    {
      const glm::vec4 codes(
        number(0.0, 30.0), number(0.0, 30.0), number(0.0, 30.0), number(0.0, 30.0));
      terrain::TerrainRay ray;
      terrain::TerrainHit hit;
      hit.fraction = { 0.25f, 0.75f };
      ray.directionGC = { number(-1.0, 1.0), number(-1.0, 1.0), number(-40.0, 40.0) };
      ray.originGC = { 0.0f, 0.0f, number(-10.0, 40.0) };
      hit.s = 0.5f;
      const float closing = ray.directionGC.z -
        glm::dot(terrain::PatchGradient(codes, hit.fraction), glm::vec2(ray.directionGC));
      const float above =
        ray.originGC.z + hit.s * ray.directionGC.z - terrain::PatchCode(codes, hit.fraction);
      if (std::abs(closing) > 1e-3f && std::abs(above) > 1e-2f) // else rounding decides
      {
        const bool front = terrain::SeesFront(ray, hit, codes, maximum, tolerance);
        fronts += front ? 1 : 0;
        items.Add(codes, { ray.directionGC, ray.originGC.z }, { front, 0.0f, 0.0f, 0.0f });
      }
    }
    EXPECT_GT(fronts, Count / 4);
    EXPECT_LT(fronts, Count * 9 / 10);
    terrain::Features features;
    features.Way = terrain::Features::Ways::Pyramid;
    features.Within = tolerance;
    EXPECT_EQ(
      items.CountDifferent(Scene->Window, ReadCast(features),
        "TerrainHit hit = terrainNoHit(); hit.fraction = vec2(0.25, 0.75); hit.s = 0.5;"
        "result.x = terrainSeesFront(TerrainRay(ivec2(0), vec3(0.0, 0.0, input1.w),"
        "input1.xyz, 0.0, 1.0, 0.0), hit, input0) ? 1.0 : 0.0;",
        0.0f,
        [](vtkShaderProgram* program) { program->SetUniformf("terrainMaximumCode", maximum); }),
      0);
  }
}

// Over a field with holes, which no block fills.
TEST_F(TerrainShaderTwinsView, AreWithinTheSameBlocks)
{
  const auto fields = terrain::AdversarialFields();
  const auto test = std::find_if(fields.begin(), fields.end(),
    [](const terrain::TestField& field) { return field.Name == "half"; });
  const terrain::CodedField<float> field(*test);
  const terrain::PixelRays rays = RaysOf(false);
  Numbers number;
  Items items;
  int within = 0;
  while (items.Expected.size() < Count)
  {
    const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
    const float distance = number(40.0, 140.0);
    const terrain::TerrainRay ray = terrain::PixelRay(rays, pixel, distance, distance);
    glm::vec2 fraction;
    const glm::ivec2 cell = terrain::CellAt(ray, field.Coded.heights.size, fraction);
    const glm::vec4 codes = field.Coded.heights.CellCodes(cell);
    const bool isWithin = terrain::IsWithinBlock(ray, fraction, codes);
    const glm::vec2 inside = glm::min(fraction, 1.0f - fraction);
    const bool outside = glm::any(glm::lessThan(inside, glm::vec2(1e-4f)));
    if (std::abs(ray.originGC.z - terrain::PatchCode(codes, fraction)) > 1e-2f &&
      (!outside || fraction == glm::vec2(0.0f) || fraction == glm::vec2(1.0f)))
    {
      within += isWithin ? 1 : 0;
      items.Add(
        { pixel, distance, 0.0f }, glm::vec4(0.0f), { glm::vec2(cell) + fraction, isWithin, 0.0f });
    }
  }
  EXPECT_GT(within, 50);
  vtkNew<vtkTextureObject> texture;
  vtkTerrainTesting::UploadTexels(
    Scene->Window, texture, glm::uvec2(field.Coded.heights.size), field.Texels.data());
  terrain::Features features;
  features.Way = terrain::Features::Ways::Pyramid;
  features.Block = true;
  EXPECT_EQ(items.CountDifferent(Scene->Window, ReadCast(features),
              "ivec2 cell; vec2 fraction; vec4 codes;"
              "bool within = terrainIsWithinBlock(input0.xy, input0.z, cell, fraction, codes);"
              "result.xyz = vec3(vec2(cell) + fraction, within ? 1.0 : 0.0);",
              1e-5f,
              [&](vtkShaderProgram* program)
              {
                SetRays(program, rays);
                program->SetUniform2i("terrainSize", &field.Coded.heights.size[0]);
                program->SetUniformi("terrainHeights", texture->GetTextureUnit());
                program->SetUniformf("terrainBias", 0.0f);
              }),
    0);
  texture->Deactivate();
}

TEST_F(TerrainShaderTwinsView, PackTheSameSightings)
{
  const glm::ivec2 size(4096, 3000);
  Numbers number;
  Items packed;
  Items unpacked;
  int walls = 0;
  for (int k = 0; k < Count; ++k)
  {
    terrain::Sighting sighting;
    sighting.found = number(0.0, 1.0) > 0.1f;
    sighting.distanceVC = number(0.0, 1e5);
    sighting.cell = { number(0.0, size.x - 1.0), number(0.0, size.y - 1.0) };
    sighting.fraction = { number(0.0, 0.99), number(0.0, 0.99) };
    sighting.front = number(0.0, 1.0) > 0.3f;
    sighting.crossings = static_cast<int>(number(0.0, 3000.0));
    sighting.wall = number(0.0, 1.0) > 0.5f ? static_cast<int>(number(0.0, 12.0)) : -1;
    walls += sighting.wall >= 0 ? 1 : 0;
    const glm::vec4 texel = terrain::PackSighting(sighting);
    packed.Add(
      { sighting.distanceVC, glm::vec2(sighting.cell) + sighting.fraction, sighting.found },
      { sighting.front, sighting.crossings, sighting.wall, 0.0f }, texel);
    const terrain::Sighting back = terrain::UnpackSighting(texel, size);
    ASSERT_EQ(back.found, sighting.found);
    ASSERT_EQ(back.crossings, sighting.crossings);
    if (sighting.found)
    {
      ASSERT_EQ(back.cell, sighting.cell);
      ASSERT_EQ(back.front, sighting.front);
      ASSERT_EQ(back.wall, sighting.wall);
    }
    unpacked.Add(texel, glm::vec4(0.0f),
      { back.cell, back.crossings + (back.front ? 0.5f : 0.0f), back.found ? back.wall : -2 });
  }
  EXPECT_GT(walls, Count / 4);
  const std::string needed = ReadView() + ReadShader("vtkTerrainSighting");
  const auto setSize = [&size](vtkShaderProgram* program)
  { program->SetUniform2i("terrainSize", &size[0]); };
  EXPECT_EQ(packed.CountDifferent(Scene->Window, needed,
              "result = terrainPackSighting(TerrainSighting(input0.w > 0.5, input0.x,"
              "ivec2(input0.yz), fract(input0.yz), input1.x > 0.5, int(input1.y), int(input1.z),"
              "vec4(0.0)));",
              1e-6f, setSize),
    0);
  EXPECT_EQ(unpacked.CountDifferent(Scene->Window, needed,
              "TerrainSighting back = terrainUnpackSighting(input0);"
              "result = vec4(back.cell, float(back.crossings) + (back.front ? 0.5 : 0.0),"
              "back.found ? float(back.wall) : -2.0);",
              0.0f, setSize),
    0);
}

// At borders, beside holes, and over widths of part of a cell to all of the field.
TEST_F(TerrainShaderTwinsView, SeeTheSameSlopes)
{
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    if (test.Name != "holes" && test.Name != "one cell")
    {
      continue;
    }
    SCOPED_TRACE(test.Name);
    const terrain::CodedField<float> field(test);
    const terrain::CodedHeights<float>& heights = field.Coded.heights;
    Numbers number;
    Items items;
    while (items.Expected.size() < Count)
    {
      const glm::vec2 position(
        number(0.0, heights.size.x - 1.001), number(0.0, heights.size.y - 1.001));
      const glm::ivec2 cell(position);
      const glm::vec2 fraction = position - glm::vec2(cell);
      const float width = number(0.0, 1.0) < 0.3f ? 1.0f : number(0.1, 20.0);
      const glm::vec4 codes = heights.CellCodes(cell);
      if (glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0f))))
      {
        items.Add({ cell, fraction }, glm::vec4(width),
          { terrain::WideGradient(heights, cell, fraction, codes, width), 0.0f, 0.0f });
      }
    }
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(Scene->Window));
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetInternalFormat(GL_R32F);
    texture->SetFormat(GL_RED);
    const glm::uvec2 size(heights.size);
    std::vector<float> texels = field.Texels;
    texture->Create2DFromRaw(size.x, size.y, 1, VTK_FLOAT, texels.data());
    texture->Activate();
    const int different =
      items.CountDifferent(Scene->Window, ReadView() + ReadShader("vtkTerrainGradient"),
        "ivec2 cell = ivec2(input0.xy); result.xy = terrainWideGradient(cell, input0.zw,"
        "terrainTexelCodes(cell), input1.x);",
        1e-3f,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("terrainHeights", texture->GetTextureUnit());
          program->SetUniformf("terrainBias", 0.0f);
        });
    EXPECT_EQ(different, 0);
    texture->Deactivate();
  }
}
