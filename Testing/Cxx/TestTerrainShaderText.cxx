// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What makes the text of shaders: the features that they are built for, how VTK's text is edited,
// and the ways of the driver.
#include "vtkTerrainTesting.h"

#include "render/Driver.h"
#include "render/Features.h"
#include "render/ShaderText.h"
#include "render/UniformPasser.h"

#include "vtkNew.h"
#include "vtkShader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{
using terrain::Driver;
using terrain::Features;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Features that have one member at other values than those of no way.
template <std::size_t Member>
void AddOthers(std::vector<Features>& all)
{
  Features features;
  auto& member = std::get<Member>(terrain::MembersOf(features));
  using Type = std::decay_t<decltype(member)>;
  if constexpr (std::is_same_v<Type, Features::Ways>)
  {
    for (int way = 1; way <= static_cast<int>(Features::Ways::Pyramid); ++way)
    {
      member = static_cast<Type>(way);
      all.push_back(features);
    }
  }
  else
  {
    member = std::is_same_v<Type, bool> ? Type(true) : Type(3);
    all.push_back(features);
  }
}

template <std::size_t... Members>
std::vector<Features> OthersOf(std::index_sequence<Members...> /*all*/)
{
  std::vector<Features> all;
  (AddOthers<Members>(all), ...);
  return all;
}

/// Features that differ from those of no way in one member each, whichever there are.
std::vector<Features> SingleFeatures()
{
  using Key = decltype(terrain::MembersOf(std::declval<Features&>()));
  return OthersOf(std::make_index_sequence<std::tuple_size_v<Key>>());
}

/// The texts of all files of shaders/.
std::vector<std::string> ReadShaders()
{
  std::vector<std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(VTKTERRAIN_SHADER_DIR))
  {
    texts.push_back(vtkTerrainTesting::ReadShader(file.path().stem().string()));
  }
  return texts;
}

// A program built for one of them is another one than that for any other, by its key and by its
// text; the uniforms that are passed change the text elsewhere (SurfaceProgram).
TEST(TerrainFeatures, AreDefinesAndKey)
{
  const std::vector<Features> all = SingleFeatures();
  std::set<std::string> texts{ Features().Defines() };
  for (const Features& features : all)
  {
    EXPECT_EQ(features, Features(features));
    EXPECT_NE(features, Features()) << features.Defines();
    const bool isNew = texts.insert(features.Defines()).second;
    EXPECT_NE(isNew, features.PassesUniforms) << features.Defines();
  }
}

// Names of conditions in our GLSL are those that features define, or it is a typing error.
TEST(TerrainFeatures, DefineEveryNameThatShadersAskFor)
{
  std::string defined = Features::Constants();
  for (const Features& features : SingleFeatures())
  {
    defined += features.Defines();
  }
  const std::string name = "TERRAIN_";
  const std::vector<std::string> shaders = ReadShaders();
  ASSERT_GT(shaders.size(), 20U);
  for (const std::string& text : shaders)
  {
    ASSERT_FALSE(text.empty());
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    {
      const std::string found =
        text.substr(at, text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_", at) - at);
      EXPECT_TRUE(found == "TERRAIN_VISIT" || Has(defined, "#define " + found)) << found;
    }
  }
}

// The hit lies behind the proxy only where nothing shifts its depth.
TEST(TerrainFeatures, ShiftedDepthIsNotDeclaredGreater)
{
  Features features;
  features.Way = Features::Ways::Linear;
  features.BelowBox = true;
  EXPECT_FALSE(Has(features.Defines(), "TERRAIN_DEPTH_OFFSET"));
  features.ShiftsDepth = true;
  EXPECT_TRUE(Has(features.Defines(), "#define TERRAIN_DEPTH_OFFSET\n"));
}

TEST(TerrainShaderText, EditsOutsideItsMarks)
{
  vtkNew<vtkShader> shader;
  shader->SetSource("//VTK::Depth::Impl\nx = gl_FragCoord.z + gl_FragCoord.z;\n");
  std::string problem;
  terrain::ShaderText text(shader, problem);
  text.Before("//VTK::Depth::Impl", "y = gl_FragCoord.z;");
  text.Behind("//VTK::Depth::Impl", "z = gl_FragCoord.z;\n");
  EXPECT_TRUE(text.Follow("gl_FragCoord.z", "gl_FragDepth"));
  const std::string source = shader->GetSource();
  EXPECT_TRUE(Has(source, "x = gl_FragDepth + gl_FragDepth;")) << source;
  EXPECT_TRUE(Has(source, "\ny = gl_FragCoord.z;\n")) << source;
  EXPECT_TRUE(Has(source, "\nz = gl_FragCoord.z;\n")) << source;
  EXPECT_LT(source.find("y ="), source.find("//VTK::Depth::Impl"));
  EXPECT_LT(source.find("//VTK::Depth::Impl"), source.find("z ="));
  EXPECT_EQ(problem, "");
  text.Replace("//VTK::Depth::Impl", "w = 0.0;");
  EXPECT_FALSE(Has(shader->GetSource(), "//VTK::Depth::Impl"));
  EXPECT_FALSE(text.Follow("gl_FragCoord.z", "gl_FragDepth"));
  EXPECT_EQ(problem, "");
}

/// The problem of a text whose pixels must be asked for x and y alone.
std::string ProblemOfPixels(const std::string& source)
{
  vtkNew<vtkShader> shader;
  shader->SetSource(source);
  std::string problem;
  terrain::ShaderText(shader, problem).RequireSwizzles("gl_FragCoord", "xy", "it would be wrong");
  return problem;
}

TEST(TerrainShaderText, RequiresNamedComponents)
{
  for (const std::string good :
    { "", "void main() {}", "a = gl_FragCoord.xy / b;", "f(gl_FragCoord.x, gl_FragCoord.y)\n",
      "\n// terrain begins\ngl_FragCoord.z; gl_FragCoord\n// terrain ends\ngl_FragCoord.yx;" })
  {
    EXPECT_EQ(ProblemOfPixels(good), "") << good;
  }
  for (const std::string bad :
    { "gl_FragCoord;", "gl_FragCoord", "gl_FragCoord.", "gl_FragCoord.z;", "gl_FragCoord.xyz;",
      "gl_FragCoord.xw;", "gl_FragCoord .xy;", "gl_FragCoord[2];", "gl_FragCoord.st;" })
  {
    const std::string expected =
      std::string("there is \"").append(bad).append("\": it would be wrong");
    EXPECT_EQ(ProblemOfPixels("a = gl_FragCoord.xy;\n" + bad + "\nb;\n"), expected);
    EXPECT_NE(ProblemOfPixels("// terrain begins\n// terrain ends\n" + bad), "") << bad;
  }
}

TEST(TerrainShaderText, KeepsTheFirstProblem)
{
  vtkNew<vtkShader> shader;
  shader->SetSource("void main() { gl_FrontFacing; }\n");
  std::string problem;
  terrain::ShaderText text(shader, problem);
  text.Require("texture(a)", "b", "there would be none");
  EXPECT_EQ(problem, "there is no \"texture(a)\": there would be none");
  text.Replace("//VTK::Depth::Impl", "w = 0.0;");
  EXPECT_EQ(problem, "there is no \"texture(a)\": there would be none");
  EXPECT_EQ(shader->GetSource(), "void main() { gl_FrontFacing; }\n");
  std::string other;
  terrain::ShaderText(shader, other).Behind("//VTK::Gone::Dec", "a");
  EXPECT_EQ(other, "there is no tag //VTK::Gone::Dec");
}

TEST(TerrainUniformPasser, PassesWhatIsRead)
{
  std::string vertex = "uniform float shared;\nvoid main()\n{\n}\n";
  std::string fragment =
    "#define TERRAIN_A\nuniform float shared;\nuniform vec3 first;\n"
    "#ifdef TERRAIN_A\nuniform int second; // of A\n#else\nuniform int third;\n"
    "#endif\n#ifndef TERRAIN_AB\nuniform mat3 fourth;\n#endif\n"
    "#ifdef OTHER\nuniform vec2 fifth;\n#endif\nuniform vec4 array[2];\n"
    "uniform sampler2D texture;\nvoid main() { }\n";
  terrain::PassUniforms(vertex, fragment);
  for (const std::string passed : { "vec3 first", "int second", "mat3 fourth", "vec2 fifth" })
  {
    EXPECT_TRUE(Has(fragment, "flat in " + passed + "VSOutput;")) << passed;
    const std::string declared = std::string("uniform ").append(passed).append(";\nflat out ");
    EXPECT_TRUE(Has(vertex, declared + passed + "VSOutput;")) << passed;
  }
  for (const std::string kept :
    { "float shared", "int third", "vec4 array[2]", "sampler2D texture" })
  {
    EXPECT_TRUE(Has(fragment, "uniform " + kept + ";")) << kept;
  }
  EXPECT_TRUE(Has(vertex, "{\n  firstVSOutput = first;\n"));
}

TEST(TerrainUniformPasser, LeavesStrangeShadersAlone)
{
  for (const std::string source : { "", "void main();", "int main(void) { }", "#endif\n#else\n" })
  {
    std::string vertex = source;
    std::string fragment = "#endif\n#else\n#elif\nuniform float a;\n#ifdef\n";
    terrain::PassUniforms(vertex, fragment);
    EXPECT_EQ(vertex, source);
    EXPECT_TRUE(Has(fragment, "uniform float a;"));
  }
  // more than there is room for
  std::string vertex = "void main() {}";
  std::string fragment;
  for (int i = 0; i < 40; ++i)
  {
    fragment += "uniform vec4 u" + std::to_string(i) + "x;\n";
  }
  terrain::PassUniforms(vertex, fragment);
  EXPECT_TRUE(Has(fragment, "flat in vec4 u29x"));
  EXPECT_TRUE(Has(fragment, "uniform vec4 u30x;"));
}

TEST(TerrainDriver, TakesWordsFromLeftToRight)
{
  Driver driver = Driver::Software();
  EXPECT_EQ(driver.Apply("levels,plain,compute,fetch,anisotropic"), "");
  EXPECT_FALSE(driver.BuffersPyramid || driver.PassesUniforms || driver.Gathers);
  EXPECT_TRUE(driver.ComputesSightings);
  EXPECT_EQ(driver.Anisotropy, 16.0f);
  EXPECT_EQ(driver.Apply("graphics,buffer,passed,fragment,isotropic"), "");
  EXPECT_TRUE(driver.BuffersPyramid && driver.PassesUniforms && driver.Gathers);
  EXPECT_FALSE(driver.ComputesSightings);
  EXPECT_EQ(driver.Anisotropy, 1.0f);
  EXPECT_EQ(driver.Apply("software"), "");
  EXPECT_TRUE(driver.BuffersPyramid);
  EXPECT_EQ(driver.Apply(""), "");
  EXPECT_EQ(driver.Apply("gather,llvmpipe,fetch"), "llvmpipe");
}
}
