// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainGlobeTrace.glsl against its twin, core/globe/GlobeTraversal.h in float: the
// same rays at the same worlds, step for step.
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestGlobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using terrain::GlobeRays;
using vtkTerrainTesting::FieldTextures;
using vtkTerrainTesting::NumberOfRays;
using vtkTerrainTesting::ReadShader;

using Texel = std::uint16_t;

std::string declarations(terrain::Features features)
{
  features.Globe = true;
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainColumns") + ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") +
    ReadShader("vtkTerrainGlobeLines") + ReadShader("vtkTerrainPyramid") +
    ReadShader("vtkTerrainGlobeTrace");
}

/// The lines of a globe on the GPU.
class GlobeTexture
{
public:
  GlobeTexture(vtkRenderWindow* window, const terrain::WorldTracer<float, Texel>& tracer)
    : Tracer(tracer)
  {
    std::vector<glm::vec4> texels;
    texels.reserve(tracer.Lines.Columns.size());
    for (const glm::vec2& column : tracer.Lines.Columns)
    {
      texels.emplace_back(column, 0.0f, 0.0f);
    }
    texels.insert(texels.end(), tracer.Lines.Rows.begin(), tracer.Lines.Rows.end());
    texels.insert(texels.end(), tracer.Lines.Curves.begin(), tracer.Lines.Curves.end());
    vtkTerrainTesting::PrepareTexture(window, this->Texture, GL_RGBA32F, GL_RGBA);
    this->Buffer->Upload(&texels[0].x, 4 * texels.size(), vtkOpenGLBufferObject::TextureBuffer);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer);
    this->Texture->Activate();
  }
  GlobeTexture(const GlobeTexture&) = delete;
  GlobeTexture& operator=(const GlobeTexture&) = delete;
  ~GlobeTexture()
  {
    this->Texture->Deactivate();
  }

  void SetUniforms(vtkShaderProgram* program) const
  {
    const terrain::GlobeLines<float>& lines = this->Tracer.Lines;
    const auto set = [program](const char* name, const glm::vec4& value)
    { program->SetUniform4f(name, &value[0]); };
    program->SetUniformi("terrainGlobeLines", this->Texture->GetTextureUnit());
    set("terrainGlobeScene", { lines.Radius, lines.Axis, lines.Height, lines.Curvature });
    set("terrainGlobeOuter", { lines.Outer, lines.Spread });
    set("terrainGlobeInner", { lines.Inner, 0.0f });
    set("terrainGlobeColumn", { lines.PerStep, lines.Turn, lines.AnchorFraction, 0.0f });
    const glm::ivec2 grid(lines.AnchorCell, lines.Top);
    program->SetUniform2i("terrainGlobeGrid", &grid[0]);
    program->SetUniformi("terrainGlobeJoined", lines.Joined ? 1 : 0);
    const auto& traversal = this->Tracer.Traversal;
    set("terrainGlobeHeights",
      { traversal.codeScale, traversal.codeBase, traversal.anchorCode, 0.0f });
  }

private:
  const terrain::WorldTracer<float, Texel>& Tracer;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};

/// Eight times what float rounds of a place, as a part of its distance from the anchor.
constexpr float kRoundedPlace = 1e-6f;

/// True if a hit, at distance t, is that of a ray whose origin is moved by what float rounds of it:
/// of rays that graze the ground or pass a silhouette the distances may lie anywhere between those
/// of rays nearby.
template <typename Traversal>
bool isOfARayNearby(
  bool found, float t, const terrain::GlobeRay<float>& ray, const Traversal& traversal)
{
  constexpr int directions = 27; // each coordinate less, the same, more
  const float move = kRoundedPlace * glm::length(ray.Origin);
  bool agrees = false;
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = -nearest;
  for (int k = 0; k < directions; ++k)
  {
    terrain::GlobeRay<float> moved = ray;
    moved.Origin += move * glm::vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    const terrain::GlobeHit<float> hit = traversal.Trace(moved);
    agrees = agrees || hit.Found == found;
    nearest = hit.Found ? std::min(nearest, hit.T) : nearest;
    farthest = hit.Found ? std::max(farthest, hit.T) : farthest;
  }
  const float room = 0.1f + 1e-5f * t + move;
  return agrees && (!found || (t >= nearest - room && t <= farthest + room));
}

/// Rays of a kind about one anchor, on the GPU and by the twin: they end at the same place, or
/// where one nearby ends.
void compareRays(vtkRenderWindow* window, const terrain::TestGlobe& globe, int kind)
{
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  FieldTextures<Texel> field(window, world.Field, kind % 2 == 0);
  GlobeRays rays(globe, 17u + static_cast<unsigned>(kind));
  const terrain::GlobeReferenceRay first = rays.Make(kind);
  const terrain::WorldTracer<float, Texel> tracer(world, first.Origin);
  const GlobeTexture lines(window, tracer);
  std::vector<std::vector<float>> inputs(2);
  std::vector<terrain::GlobeRay<float>> cast;
  for (int k = 0; k < NumberOfRays; ++k)
  {
    terrain::GlobeReferenceRay ray = rays.Make(kind);
    if (k % 2 == 0) // as those of a camera, which the anchor is
    {
      ray.Origin = first.Origin + 1e-6 * (ray.Origin - first.Origin);
      ray.Direction = glm::normalize(first.Direction + 0.1 * ray.Direction);
    }
    terrain::GlobeRay<float> about;
    about.Origin = tracer.Anchor.ToAxes(ray.Origin - tracer.Anchor.Position);
    about.Direction = tracer.Anchor.ToAxes(ray.Direction);
    about.End = static_cast<float>(ray.End);
    cast.push_back(about);
    for (int axis = 0; axis < 3; ++axis)
    {
      inputs[0].push_back(about.Origin[axis]);
      inputs[1].push_back(about.Direction[axis]);
    }
    inputs[0].push_back(0.0f);
    inputs[1].push_back(about.End);
  }
  const std::vector<float> drawn =
    vtkTerrainTesting::RunShader(window, declarations(field.GetFeatures()),
      "TerrainGlobeHit hit = terrainGlobeTrace(input0.xyz, input1.xyz, 0.0, input1.w);"
      "result = vec4(hit.found, hit.t, hit.cell.x + 4096 * hit.cell.y, hit.front);",
      inputs,
      [&](vtkShaderProgram* program)
      {
        field.SetUniforms(program);
        lines.SetUniforms(program);
      });
  ASSERT_EQ(drawn.size(), 4u * NumberOfRays);
  int wrong = 0;
  int turned = 0;
  int hits = 0;
  for (std::size_t k = 0; k < NumberOfRays; ++k)
  {
    const terrain::GlobeHit<float> hit = tracer.Traversal.Trace(cast[k]);
    const bool found = drawn[4 * k] != 0.0f;
    hits += hit.Found ? 1 : 0;
    const bool front = drawn[4 * k + 3] != 0.0f;
    const bool same =
      found == hit.Found && (!found || std::abs(drawn[4 * k + 1] - hit.T) <= 1e-5f * hit.T + 0.1f);
    wrong += same || isOfARayNearby(found, drawn[4 * k + 1], cast[k], tracer.Traversal) ? 0 : 1;
    turned += same && found && front != hit.Front ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(turned, 0);
  EXPECT_GE(hits, NumberOfRays / 20); // a cone of rays may pass by a small raster
}
}

TEST(TerrainShaderTwinsGlobe, TracesAsInCxx)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const std::vector<terrain::TestGlobe> globes = terrain::TestGlobes();
  for (std::size_t k = 0; k < globes.size(); ++k)
  {
    SCOPED_TRACE(globes[k].Name);
    compareRays(scene.Window, globes[k], static_cast<int>(k) % GlobeRays::Count);
  }
}
