// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainPyramid.glsl and vtkTerrainBeam.glsl against their twins in src/core/: the same
// rays through the same fields, node for node.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestRays.h"
#include "core/rays/PyramidBeam.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
constexpr int NumberOfRays = 1000;
using terrain::TerrainBeam;
using terrain::TerrainHit;
using terrain::TerrainRay;
using vtkTerrainTesting::FieldTextures;
using vtkTerrainTesting::ReadShader;
using vtkTerrainTesting::SumTextures;

/// What is drawn with, with tolerances, and counts visits.
std::string declarations(terrain::Features features)
{
  features.Within = true;
  return features.Defines() + terrain::Features::Constants() +
    "uint terrainVisits = 0u;\n"
    "#define TERRAIN_VISIT(node, level) terrainVisits = terrainVisits * 31u + "
    "uint((node).x * 7 + (node).y * 13 + level);\n" +
    ReadShader("vtkTerrainHeights") + ReadShader("vtkTerrainColumns") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid") + ReadShader("vtkTerrainBeam") +
    "TerrainRay inputRay(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainRay(ivec2(a.xy), b.xyz, c.xyz, a.z, a.w, b.w); }\n";
}

/// Random beams as the inputs of a shader.
struct Beams
{
  std::vector<TerrainBeam> Items;
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(5);

  Beams(glm::ivec2 size, double maximumCode, unsigned seed)
  {
    terrain::RayMaker maker(size, maximumCode, seed);
    for (int k = 0; k < NumberOfRays; ++k)
    {
      TerrainBeam beam;
      beam.ray = maker.Make();
      const double width = std::pow(10.0, maker.Uniform(-3.0, 0.0));
      beam.radius = glm::vec3(maker.Uniform(0.0, width), maker.Uniform(0.0, width), 0.0);
      beam.growth = glm::vec3(maker.Uniform(0.0, width), maker.Uniform(0.0, width), width);
      this->Items.push_back(beam);
      const TerrainRay& ray = beam.ray;
      this->Add(0, glm::vec4(ray.anchorCell, ray.sBegin, ray.sEnd));
      this->Add(1, glm::vec4(ray.originGC, ray.originLow));
      this->Add(2, glm::vec4(ray.directionGC, 0.0f));
      this->Add(3, glm::vec4(beam.radius, 0.0f));
      this->Add(4, glm::vec4(beam.growth, 0.0f));
    }
  }

private:
  void Add(std::size_t input, const glm::vec4& value)
  {
    this->Inputs[input].insert(this->Inputs[input].end(), { value.x, value.y, value.z, value.w });
  }
};

std::vector<glm::vec4> run(vtkRenderWindow* window, const std::string& head,
  const std::string& body, const Beams& beams,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const std::vector<float> values =
    vtkTerrainTesting::RunShader(window, head, body, beams.Inputs, setUniforms);
  std::vector<glm::vec4> result;
  for (std::size_t k = 0; k + 3 < values.size(); k += 4)
  {
    result.emplace_back(values[k], values[k + 1], values[k + 2], values[k + 3]);
  }
  return result;
}

/// Mesa's software rasterizer up to LLVM 15 calculates as C++ does, bit for bit; later ones and
/// other drivers fuse and reorder.
bool calculatesAsTwin(vtkRenderWindow* window)
{
  const std::string words = window->ReportCapabilities();
  const std::string name = "llvmpipe (LLVM ";
  const std::size_t at = words.find(name);
  return at != std::string::npos && std::atoi(words.c_str() + at + name.size()) <= 15;
}

int allowedDifferences(vtkRenderWindow* window)
{
  return calculatesAsTwin(window) ? 0 : NumberOfRays / 25;
}

/// True if distances are the same; or nearly, where calculations differ.
bool isSameDistance(float a, float b, bool exact)
{
  return exact ? a == b : std::abs(a - b) <= 1e-4f * std::max(1.0f, std::abs(b));
}

/// Traces the rays of beams on the GPU and compares them with the twin. Tolerance: see
/// terrainTracePyramidWithin().
template <typename Textures>
void comparePaths(
  vtkRenderWindow* window, Textures& textures, const Beams& beams, const glm::vec4& tolerance)
{
  const auto uniforms = [&](vtkShaderProgram* program)
  {
    textures.SetUniforms(program);
    program->SetUniform4f("tolerance", &tolerance[0]);
  };
  const std::string head = declarations(textures.GetFeatures()) + "uniform vec4 tolerance;\n";
  const std::string trace =
    "TerrainHit hit = terrainTracePyramidWithin(inputRay(input0, input1, input2), tolerance);";
  const auto paths = run(window, head,
    trace + "result = vec4(hit.found, hit.s, hit.crossings, terrainVisits & 0xffffffu);", beams,
    uniforms);
  const auto places =
    run(window, head, trace + "result = vec4(hit.cell, hit.fraction);", beams, uniforms);
  ASSERT_EQ(paths.size(), beams.Items.size());
  ASSERT_EQ(places.size(), beams.Items.size());
  const bool exact = calculatesAsTwin(window);
  const auto position = [](const glm::vec4& at) { return glm::vec2(at) + glm::vec2(at.z, at.w); };
  int hits = 0;
  int differentPaths = 0;
  int differentPlaces = 0;
  for (std::size_t k = 0; k < paths.size(); ++k)
  {
    std::uint32_t visits = 0;
    const TerrainHit hit = textures.Coded.TracePyramidWithin(beams.Items[k].ray, tolerance,
      [&](glm::ivec2 node, int level)
      { visits = visits * 31u + static_cast<std::uint32_t>(node.x * 7 + node.y * 13 + level); });
    hits += hit.found;
    const bool same =
      paths[k] == glm::vec4(hit.found, paths[k].y, hit.crossings, visits & 0xffffffu) &&
      (!hit.found || isSameDistance(paths[k].y, hit.s, exact));
    differentPaths += !same;
    const glm::vec4 place(hit.cell, hit.fraction);
    differentPlaces += hit.found &&
      (exact ? places[k] != place : glm::distance(position(places[k]), position(place)) > 1e-3f);
  }
  EXPECT_GT(hits, 0);
  EXPECT_LE(differentPaths, allowedDifferences(window));
  EXPECT_LE(differentPlaces, allowedDifferences(window));
}

/// Finds the starts of beams on the GPU and compares them with the twin.
template <typename Texel, typename Textures>
void compareBeams(vtkRenderWindow* window, Textures& textures, const Beams& beams)
{
  const auto starts = run(window, declarations(textures.GetFeatures()),
    "result = vec4(terrainBeamStart(TerrainBeam(inputRay(input0, input1, input2), input3.xyz,"
    "input4.xyz)));",
    beams, [&](vtkShaderProgram* program) { textures.SetUniforms(program); });
  ASSERT_EQ(starts.size(), beams.Items.size());
  int different = 0;
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    int steps = 0;
    const float start =
      terrain::PyramidBeam<Texel>(textures.Coded).BeamStart(beams.Items[k], steps);
    different += !isSameDistance(starts[k].x, start, calculatesAsTwin(window));
  }
  EXPECT_LE(different, allowedDifferences(window));
}

template <typename Texel>
void compareField(vtkRenderWindow* window, const terrain::TestField& test, unsigned seed)
{
  terrain::CodedField<Texel> field(test);
  field.Coded.start = 1 + static_cast<int>(seed % 6);
  const Beams beams({ test.Width, test.Height }, field.Codes.MaximumCode, seed);
  FieldTextures<Texel> textures(window, field, seed % 4 < 2);
  const float size = static_cast<float>(field.Codes.MaximumCode);
  comparePaths(window, textures, beams, glm::vec4(0.0f));
  compareBeams<Texel>(window, textures, beams);
  if (seed % 3 == 0)
  {
    comparePaths(window, textures, beams, glm::vec4(2.0f, 0.3f * size, 3.0f, 0.3f * size));
    field.Coded.columns = true;
    comparePaths(window, textures, beams, glm::vec4(0.0f));
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
      compareField<std::uint16_t>(scene.Window, field, seed);
    }
    else
    {
      compareField<float>(scene.Window, field, seed);
    }
  }
}
template <typename Texel>
void compareSum(vtkRenderWindow* window, const terrain::TestField& base,
  const terrain::TestField& detail, int level, unsigned seed)
{
  terrain::CodedSum<Texel> sum(base, detail, level, 0.7);
  sum.Coded.start = 1 + static_cast<int>(seed % 6);
  const Beams beams(sum.Coded.heights.size, sum.Codes.MaximumCode, seed);
  SumTextures<Texel> textures(window, sum);
  comparePaths(window, textures, beams, glm::vec4(0.0f));
  if (textures.Integer)
  {
    compareBeams<terrain::WithDetail<Texel>>(window, textures, beams);
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
      compareSum<float>(scene.Window, base, terrain::RandomDetail({ 16, 16 }, 40.0, 1), 3, 5);
    }
    if (base.Name == "holes")
    {
      compareSum<std::uint16_t>(
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
