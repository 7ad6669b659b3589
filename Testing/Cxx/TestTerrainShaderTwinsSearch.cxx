// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainSearch.glsl against its twin src/core/rays/HeightSearch.h: the same rays
// through the same fields, node for node and sample for sample.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestRays.h"
#include "core/rays/HeightSearch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace
{
using terrain::SearchKind;
using terrain::SearchParameters;
using terrain::TerrainHit;
using terrain::TerrainRay;
using vtkTerrainTesting::NumberOfRays;
using vtkTerrainTesting::ReadShader;

// Differing rays of a comparison that are told one by one.
constexpr int kTold = 5;

terrain::Features::Ways WayOf(SearchKind kind)
{
  return kind == SearchKind::Linear   ? terrain::Features::Ways::Linear
    : kind == SearchKind::Exponential ? terrain::Features::Ways::Exponential
                                      : terrain::Features::Ways::Equidistant;
}

/// What is drawn with.
std::string Declarations(terrain::Features features, SearchKind kind)
{
  features.Way = WayOf(kind);
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainPyramid") + ReadShader("vtkTerrainSearch") +
    "TerrainRay inputRay(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainRay(ivec2(a.xy), b.xyz, c.xyz, a.z, a.w, b.w); }\n";
}

void SetParameters(vtkShaderProgram* program, const SearchParameters& parameters)
{
  program->SetUniformi("terrainSteps", parameters.Steps);
  program->SetUniformi("terrainLongSteps", parameters.LongSteps);
  program->SetUniformi("terrainSecantSteps", parameters.SecantSteps);
  program->SetUniformf("terrainStepLength", parameters.StepLength);
  program->SetUniformf("terrainStepRelief", parameters.StepRelief);
  program->SetUniformi("terrainStepLevel", parameters.StepLevel());
}

/// Random rays as the inputs of a shader.
struct Rays
{
  std::vector<TerrainRay> Items;
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(3);

  Rays(const terrain::TestField& field, double maximumCode, unsigned seed)
  {
    terrain::RayMaker maker({ field.Width, field.Height }, maximumCode, seed);
    for (int k = 0; k < NumberOfRays; ++k)
    {
      const TerrainRay ray = maker.Make();
      this->Items.push_back(ray);
      this->Add(0, glm::vec4(ray.anchorCell, ray.sBegin, ray.sEnd));
      this->Add(1, glm::vec4(ray.originGC, ray.originLow));
      this->Add(2, glm::vec4(ray.directionGC, 0.0f));
    }
  }

private:
  void Add(std::size_t input, const glm::vec4& value)
  {
    this->Inputs[input].insert(this->Inputs[input].end(), { value.x, value.y, value.z, value.w });
  }
};

/// True if a shader's result (distance or -1, number of samples, position) is that of its twin:
/// found or not, after as many samples, in the same place but for the rounding of a few sums.
bool IsSame(const TerrainHit& twin, const float* result)
{
  if ((result[0] >= 0.0f) != twin.found || static_cast<int>(result[1]) != twin.crossings)
  {
    return false;
  }
  const glm::vec2 position = glm::vec2(twin.cell) + twin.fraction;
  return !twin.found ||
    (std::abs(result[0] - twin.s) <= 1e-5f &&
      glm::length(position - glm::vec2(result[2], result[3])) <= 1e-3f);
}

template <typename Texel>
void CompareField(vtkRenderWindow* window, const terrain::TestField& test, SearchKind kind,
  const SearchParameters& parameters, unsigned seed)
{
  const terrain::CodedField<Texel> field(test);
  vtkTerrainTesting::FieldTextures<Texel> textures(window, field, false);
  const terrain::HeightSearch<Texel> search{ field.Coded, parameters, kind };
  const Rays rays(test, field.Codes.MaximumCode, seed);
  const std::string body =
    "TerrainHit hit = terrainSearch(inputRay(input0, input1, input2));"
    "result = vec4(hit.found ? hit.s : -1.0, hit.crossings, vec2(hit.cell) + hit.fraction);";
  const std::vector<float> results = vtkTerrainTesting::RunShader(window,
    Declarations(textures.GetFeatures(), kind), body, rays.Inputs,
    [&](vtkShaderProgram* program)
    {
      textures.SetUniforms(program);
      SetParameters(program, parameters);
    });
  ASSERT_EQ(results.size(), 4 * rays.Items.size());
  // Where a sample falls on the surface or on the rim of a hole, rounding decides.
  const bool exact = vtkTerrainTesting::CalculatesAsTwin(window);
  int hits = 0;
  int different = 0;
  std::ostringstream told;
  for (std::size_t k = 0; k < rays.Items.size(); ++k)
  {
    const TerrainHit twin = search.Search(rays.Items[k]);
    hits += twin.found ? 1 : 0;
    TerrainHit drawn;
    drawn.found = results[4 * k] >= 0.0f;
    drawn.s = results[4 * k];
    const bool agrees = IsSame(twin, &results[4 * k]) ||
      (!exact &&
        vtkTerrainTesting::IsOfARayNearby(drawn, rays.Items[k], field.Coded.heights.maximumCode,
          [&](const TerrainRay& moved) { return search.Search(moved); }));
    different += agrees ? 0 : 1;
    told << (agrees || different > kTold
        ? std::string()
        : "ray " + std::to_string(k) + ": " + std::to_string(drawn.s) + " for " +
          std::to_string(twin.found ? twin.s : -1.0f) + ", brute force " +
          std::to_string(
            terrain::FirstMeeting(terrain::RayPieces(field.Coded.heights, rays.Items[k]))) +
          "\n");
  }
  EXPECT_GT(hits, 0);
  // Steps that grow, begun a rounding later, may all end in a hole; an equidistant search goes on.
  EXPECT_LE(different, exact || kind == SearchKind::Equidistant ? 0 : 1) << told.str();
}

/// Default parameters, and such with steps of several cells, which end before the terrain does.
std::vector<SearchParameters> SomeParameters(const terrain::TestField& field, SearchKind kind)
{
  const terrain::SearchScene scene{ field.Width, field.Height, 100.0, 1.0 };
  SearchParameters coarse = terrain::ChooseSearchParameters(scene, kind);
  coarse.StepLength = 3.5f;
  coarse.Steps = 7;
  coarse.LongSteps = 2;
  SearchParameters fine = coarse;
  fine.StepLength = 0.3f;
  return { terrain::ChooseSearchParameters(scene, kind), coarse, fine };
}

TEST(TerrainShaderTwinsSearch, FindTheSameHits)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    for (const SearchKind kind :
      { SearchKind::Linear, SearchKind::Exponential, SearchKind::Equidistant })
    {
      for (const SearchParameters& parameters : SomeParameters(field, kind))
      {
        SCOPED_TRACE(field.Name + ", " + std::to_string(static_cast<int>(kind)) + ", step length " +
          std::to_string(parameters.StepLength));
        if (++seed % 2 == 0)
        {
          CompareField<std::uint16_t>(scene.Window, field, kind, parameters, seed);
        }
        else
        {
          CompareField<float>(scene.Window, field, kind, parameters, seed);
        }
      }
    }
  }
}
}
