// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainPyramid.glsl and vtkTerrainBeam.glsl against their twins in src/core/: the same
// rays through the same fields, node for node.
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestRays.h"
#include "core/PyramidBeam.h"
#include "vtkTerrainGL.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

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
using vtkTerrainTesting::ReadShader;

std::string declarations(bool integer, bool columns)
{
  return std::string(integer ? "#define TERRAIN_HEIGHTS_INTEGER\n" : "") +
    std::string(columns ? "#define TERRAIN_COLUMNS\n" : "") +
    "#define TERRAIN_WITHIN\nuint terrainVisits = 0u;\n"
    "#define TERRAIN_VISIT(node, level) terrainVisits = terrainVisits * 31u + "
    "uint((node).x * 7 + (node).y * 13 + level);\n" +
    ReadShader("vtkTerrainHeights") + ReadShader("vtkTerrainColumns") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid") + ReadShader("vtkTerrainBeam") +
    "TerrainRay inputRay(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainRay(ivec2(a.xy), b.xyz, c.xyz, a.z, a.w, b.w); }\n";
}

/// A field on the GPU.
template <typename Texel>
class FieldTextures
{
public:
  FieldTextures(vtkRenderWindow* window, const terrain::CodedField<Texel>& field)
    : Field(field)
  {
    constexpr bool integer = std::is_integral_v<Texel>;
    const int type = integer ? VTK_UNSIGNED_SHORT : VTK_FLOAT;
    this->Prepare(
      window, this->Heights, integer ? GL_R16UI : GL_R32F, integer ? GL_RED_INTEGER : GL_RED);
    this->Prepare(
      window, this->Pyramid, integer ? GL_RG16UI : GL_RG32F, integer ? GL_RG_INTEGER : GL_RG);
    const glm::uvec2 size(field.Coded.heights.size);
    auto* texels = const_cast<Texel*>(field.Texels.data()); // which VTK does not change
    this->Heights->Create2DFromRaw(size.x, size.y, 1, type, texels);
    const int top = field.Pyramid.LevelCount();
    this->Pyramid->SetMinificationFilter(vtkTextureObject::NearestMipmapNearest);
    this->Pyramid->SetMaxLevel(top - 1);
    for (int level = 1; level <= top; ++level)
    {
      const glm::uvec2 nodes(field.Pyramid.LevelSize(level));
      auto* data = const_cast<terrain::PyramidNode<Texel>*>(field.Pyramid.LevelNodes(level));
      if (level == 1)
      {
        this->Pyramid->Create2DFromRaw(nodes.x, nodes.y, 2, type, data);
        this->Pyramid->Activate();
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
      }
      else
      {
        glTexImage2D(GL_TEXTURE_2D, level - 1, integer ? GL_RG16UI : GL_RG32F,
          static_cast<int>(nodes.x), static_cast<int>(nodes.y), 0, integer ? GL_RG_INTEGER : GL_RG,
          integer ? GL_UNSIGNED_SHORT : GL_FLOAT, data);
      }
    }
    this->Heights->Activate();
  }
  FieldTextures(const FieldTextures&) = delete;
  FieldTextures& operator=(const FieldTextures&) = delete;
  ~FieldTextures()
  {
    this->Heights->Deactivate();
    this->Pyramid->Deactivate();
  }

  void SetUniforms(vtkShaderProgram* program)
  {
    const terrain::CodedHeights<Texel>& heights = this->Field.Coded.heights;
    const glm::ivec2 nodes = this->Field.Pyramid.LevelSize(1);
    program->SetUniformi("terrainHeights", this->Heights->GetTextureUnit());
    program->SetUniformi("terrainPyramid", this->Pyramid->GetTextureUnit());
    program->SetUniform2i("terrainSize", &heights.size[0]);
    program->SetUniformf("terrainBias", static_cast<float>(heights.bias));
    program->SetUniformf("terrainMaximumCode", heights.maximumCode);
    program->SetUniform2i("terrainPyramidSize", &nodes[0]);
    program->SetUniformi("terrainPyramidTop", this->Field.Pyramid.LevelCount());
    program->SetUniformi("terrainPyramidStart", this->Field.Coded.start);
  }

private:
  static void Prepare(
    vtkRenderWindow* window, vtkTextureObject* texture, unsigned int internal, unsigned int format)
  {
    texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetInternalFormat(internal);
    texture->SetFormat(format);
  }

  const terrain::CodedField<Texel>& Field;
  vtkNew<vtkTextureObject> Heights;
  vtkNew<vtkTextureObject> Pyramid;
};

/// Random beams as the inputs of a shader.
struct Beams
{
  std::vector<TerrainBeam> Items;
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(5);

  Beams(const terrain::TestField& field, double maximumCode, unsigned seed)
  {
    terrain::RayMaker maker({ field.Width, field.Height }, maximumCode, seed);
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

/// Traces the rays of beams on the GPU and compares them with the twin. Tolerance: see
/// terrainTracePyramidWithin().
template <typename Texel>
void comparePaths(vtkRenderWindow* window, const terrain::CodedField<Texel>& field,
  const Beams& beams, const glm::vec4& tolerance)
{
  FieldTextures<Texel> textures(window, field);
  const auto uniforms = [&](vtkShaderProgram* program)
  {
    textures.SetUniforms(program);
    program->SetUniform4f("tolerance", &tolerance[0]);
  };
  const std::string head =
    declarations(std::is_integral_v<Texel>, field.Coded.columns) + "uniform vec4 tolerance;\n";
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
    const TerrainHit hit = field.Coded.TracePyramidWithin(beams.Items[k].ray, tolerance,
      [&](glm::ivec2 node, int level)
      { visits = visits * 31u + static_cast<std::uint32_t>(node.x * 7 + node.y * 13 + level); });
    hits += hit.found;
    differentPaths += paths[k] !=
      glm::vec4(hit.found, hit.found ? hit.s : paths[k].y, hit.crossings, visits & 0xffffffu);
    const glm::vec4 place(hit.cell, hit.fraction);
    differentPlaces += hit.found &&
      (exact ? places[k] != place : glm::distance(position(places[k]), position(place)) > 1e-3f);
  }
  EXPECT_GT(hits, 0);
  EXPECT_LE(differentPaths, allowedDifferences(window));
  EXPECT_LE(differentPlaces, allowedDifferences(window));
}

/// Finds the starts of beams on the GPU and compares them with the twin.
template <typename Texel>
void compareBeams(
  vtkRenderWindow* window, const terrain::CodedField<Texel>& field, const Beams& beams)
{
  FieldTextures<Texel> textures(window, field);
  const auto starts = run(window, declarations(std::is_integral_v<Texel>, false),
    "result = vec4(terrainBeamStart(TerrainBeam(inputRay(input0, input1, input2), input3.xyz,"
    "input4.xyz)));",
    beams, [&](vtkShaderProgram* program) { textures.SetUniforms(program); });
  ASSERT_EQ(starts.size(), beams.Items.size());
  int different = 0;
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    int steps = 0;
    different +=
      starts[k].x != terrain::PyramidBeam<Texel>(field.Coded).BeamStart(beams.Items[k], steps);
  }
  EXPECT_LE(different, allowedDifferences(window));
}

template <typename Texel>
void compareField(vtkRenderWindow* window, const terrain::TestField& test, unsigned seed)
{
  terrain::CodedField<Texel> field(test);
  field.Coded.start = 1 + static_cast<int>(seed % 6);
  const Beams beams(test, field.Codes.MaximumCode, seed);
  const float size = static_cast<float>(field.Codes.MaximumCode);
  comparePaths(window, field, beams, glm::vec4(0.0f));
  compareBeams(window, field, beams);
  if (seed % 3 == 0)
  {
    comparePaths(window, field, beams, glm::vec4(2.0f, 0.3f * size, 3.0f, 0.3f * size));
    field.Coded.columns = true;
    comparePaths(window, field, beams, glm::vec4(0.0f));
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
}
