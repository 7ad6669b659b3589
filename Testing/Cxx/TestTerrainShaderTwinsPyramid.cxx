// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainPyramid.glsl and vtkTerrainBeam.glsl against their twins in src/core/: the same
// rays through the same fields, node for node.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestRays.h"
#include "core/rays/PyramidBeam.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::TerrainHit;
using terrain::TerrainRay;
using vtkTerrainTesting::Beams;
using vtkTerrainTesting::FieldTextures;
using vtkTerrainTesting::ReadShader;
using vtkTerrainTesting::SumTextures;

/// What is drawn with, with tolerances, and counts visits.
std::string Declarations(terrain::Features features)
{
  features.Within = true;
  return features.Defines() + terrain::Features::Constants() + vtkTerrainTesting::CountVisits() +
    ReadShader("vtkTerrainHeights") + ReadShader("vtkTerrainColumns") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") + ReadShader("vtkTerrainPyramid") +
    ReadShader("vtkTerrainBeam") + vtkTerrainTesting::InputRay();
}

/// Traces the rays of beams on the GPU and compares them with the twin. Tolerance: see
/// terrainTracePyramidWithin().
template <typename Textures>
void ComparePaths(
  vtkRenderWindow* window, Textures& textures, const Beams& beams, const glm::vec4& tolerance)
{
  vtkTerrainTesting::Paths paths;
  paths.Declarations = Declarations(textures.GetFeatures()) + "uniform vec4 tolerance;\n";
  paths.Trace = "terrainTracePyramidWithin(inputRay(input0, input1, input2), tolerance)";
  paths.MaximumCode = textures.Coded.heights.maximumCode;
  paths.SetUniforms = [&](vtkShaderProgram* program)
  {
    textures.SetUniforms(program);
    program->SetUniform4f("tolerance", &tolerance[0]);
  };
  paths.Twin = [&](const TerrainRay& ray, std::uint32_t& visits)
  {
    return textures.Coded.TracePyramidWithin(ray, tolerance,
      [&](glm::ivec2 node, int level) { vtkTerrainTesting::AddVisit(visits, node, level); });
  };
  EXPECT_GT(vtkTerrainTesting::ExpectSamePaths(window, paths, beams), 0);
}

/// Finds the starts of beams on the GPU and compares them with the twin.
template <typename Texel, typename Textures>
void CompareBeams(vtkRenderWindow* window, Textures& textures, const Beams& beams)
{
  const terrain::PyramidBeam<Texel> finder(textures.Coded);
  vtkTerrainTesting::ExpectSameStarts(
    window, Declarations(textures.GetFeatures()), beams, finder,
    [&](const TerrainRay& ray)
    { return terrain::FirstMeeting(terrain::RayPieces(textures.Coded.heights, ray)); },
    [&](vtkShaderProgram* program) { textures.SetUniforms(program); });
}

template <typename Texel>
void CompareField(vtkRenderWindow* window, const terrain::TestField& test, unsigned seed)
{
  terrain::CodedField<Texel> field(test);
  field.Coded.start = 1 + static_cast<int>(seed % 6);
  const Beams beams({ test.Width, test.Height }, field.Codes.MaximumCode, seed);
  FieldTextures<Texel> textures(window, field, seed % 4 < 2);
  const float size = static_cast<float>(field.Codes.MaximumCode);
  ComparePaths(window, textures, beams, glm::vec4(0.0f));
  CompareBeams<Texel>(window, textures, beams);
  if (seed % 3 == 0)
  {
    ComparePaths(window, textures, beams, glm::vec4(2.0f, 0.3f * size, 3.0f, 0.3f * size));
    field.Coded.columns = true;
    ComparePaths(window, textures, beams, glm::vec4(0.0f));
  }
}

TEST(TerrainShaderTwinsPyramid, TakeTheSamePath)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    // Every other one as integers: each takes its shaders a while to compile.
    if (++seed % 2 == 0)
    {
      CompareField<std::uint16_t>(scene.Window, field, seed);
    }
    else
    {
      CompareField<float>(scene.Window, field, seed);
    }
  }
}
template <typename Texel>
void CompareSum(vtkRenderWindow* window, const terrain::TestField& base,
  const terrain::TestField& detail, int level, unsigned seed)
{
  terrain::CodedSum<Texel> sum(base, detail, level, 0.7);
  sum.Coded.start = 1 + static_cast<int>(seed % 6);
  const Beams beams(sum.Coded.heights.size, sum.Codes.MaximumCode, seed);
  SumTextures<Texel> textures(window, sum);
  ComparePaths(window, textures, beams, glm::vec4(0.0f));
  if (textures.Integer)
  {
    CompareBeams<terrain::WithDetail<Texel>>(window, textures, beams);
  }
}

// Levels of the nodes below, at and above that of the base's cells; periods that many and few
// powers of two divide.
TEST(TerrainShaderTwinsPyramid, TakeTheSamePathOverDetail)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  for (const terrain::TestField& base : terrain::AdversarialFields())
  {
    SCOPED_TRACE(base.Name);
    if (base.Name == "hills")
    {
      CompareSum<float>(scene.Window, base, terrain::RandomDetail({ 16, 16 }, 40.0, 1), 3, 5);
    }
    if (base.Name == "holes")
    {
      CompareSum<std::uint16_t>(
        scene.Window, base, terrain::RandomDetail({ 6, 10 }, 40.0, 2), 1, 2);
    }
  }
}

// Also for the largest indices, and just before and at whole periods.
TEST(TerrainShaderTwinsPyramid, WrapTheSame)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  std::minstd_rand random(3);
  std::vector<float> values;
  std::vector<glm::ivec2> expected;
  for (int k = 0; k < 4000; ++k)
  {
    const glm::ivec2 period(1 + random() % (k % 2 ? 16u : 4096u), 1 + random() % 1000u);
    const glm::ivec2 most = (1 << 22) / period;
    const glm::ivec2 whole(random() % static_cast<unsigned>(most.x), most.y - 1);
    const glm::ivec2 index = whole * period + glm::ivec2(k % 3) * (period - 1);
    values.insert(values.end(),
      { static_cast<float>(index.x), static_cast<float>(index.y), static_cast<float>(period.x),
        static_cast<float>(period.y) });
    expected.push_back(terrain::Wrap(index, period));
  }
  const std::vector<float> results = vtkTerrainTesting::RunShader(scene.Window,
    "#define TERRAIN_DETAIL\n" + ReadShader("vtkTerrainHeights"),
    "result.xy = vec2(terrainWrap(ivec2(input0.xy), ivec2(input0.zw)));", { values }, nullptr);
  ASSERT_EQ(results.size(), values.size());
  int different = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    different += glm::vec2(expected[k]) != glm::vec2(results[4 * k], results[4 * k + 1]);
  }
  EXPECT_EQ(different, 0);
}
}
