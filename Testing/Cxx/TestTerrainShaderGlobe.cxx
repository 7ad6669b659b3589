// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainGlobeTrace.glsl against rays in double precision, and against itself: no gaps.
#include "vtkTerrainTestGlobeCard.h"
#include "vtkTerrainTestItems.h"
#include "vtkTerrainTestPoints.h"

#include "core/globe/GlobePixels.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using vtkTerrainTesting::CastOnCard;
using vtkTerrainTesting::FieldTextures;
using vtkTerrainTesting::GlobeDeclarations;
using vtkTerrainTesting::GlobeTexture;
using vtkTerrainTesting::MiddleOf;
using Texel = vtkTerrainTesting::GlobeTexel;

/// Metres along rays that are compared with the reference, and the part of it they may be off by.
constexpr double kFarthest = 1e5;
constexpr double kPart = 1e-6;
}

// In cells of a degree, from just above the summits: what is left is what float rounds.
TEST(TerrainShaderGlobe, HasTheDistancesOfTheReference)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const std::vector<terrain::TestGlobe> globes = terrain::TestGlobes();
  for (const std::size_t which : { 0, 2, 4 })
  {
    SCOPED_TRACE(globes[which].Name);
    const terrain::World<Texel> world(globes[which].Grid, globes[which].Field());
    FieldTextures<Texel> field(scene.Window, world.Field, true);
    const terrain::GlobeReference reference = world.Reference();
    const glm::dvec3 anchor = MiddleOf(globes[which].Grid, 9500.0);
    const terrain::WorldTracer<float, Texel> tracer(world, anchor);
    const GlobeTexture lines(scene.Window, tracer);
    vtkTerrainTesting::Numbers number;
    std::vector<terrain::GlobeRay<float>> rays;
    std::vector<double> expected;
    while (rays.size() < 300)
    {
      terrain::GlobeReferenceRay ray;
      ray.Origin = anchor;
      ray.Direction =
        glm::normalize(glm::dvec3(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0))) -
        0.9 * glm::normalize(anchor);
      ray.Direction = glm::normalize(ray.Direction);
      ray.End = 2.0 * kFarthest;
      const auto hit = reference.Cast(ray);
      if (hit.Found && hit.T < kFarthest && glm::dot(ray.Direction, glm::normalize(anchor)) < -0.2)
      {
        terrain::GlobeRay<float> about;
        about.Direction = glm::vec3(tracer.Anchor.ToAxes(ray.Direction));
        about.End = static_cast<float>(ray.End);
        rays.push_back(about);
        expected.push_back(hit.T);
      }
    }
    const std::vector<float> drawn = CastOnCard(scene.Window, field, lines, rays);
    for (std::size_t k = 0; k < rays.size(); ++k)
    {
      ASSERT_NE(drawn[4 * k], 0.0f);
      ASSERT_NEAR(drawn[4 * k + 1], expected[k], kPart * expected[k] + terrain::kGlobeFloatError);
    }
  }
}

// Rays at points on the lines between cells, and at flat ground along the parallel of an anchor:
// all of them end there, and see the surface from above.
TEST(TerrainShaderGlobe, IsWatertight)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const double step = 1.0 / 120.0;
  for (const bool flat : { false, true })
  {
    SCOPED_TRACE(flat);
    const terrain::TestGlobe globe{ "part",
      terrain::MakeGrid({}, 24.0, step, 1025, terrain::Parallels(24.0, step, 1025)),
      [flat](int i, int j)
      {
        return flat ? ((i / 97 + j / 61) % 5 == 0 ? 8000.0 : 0.0)
                    : std::floor(3000.0 + 2000.0 * std::sin(0.21 * i) * std::cos(0.17 * j));
      } };
    const terrain::World<Texel> world(globe.Grid, globe.Field());
    FieldTextures<Texel> field(scene.Window, world.Field, true);
    vtkTerrainTesting::Numbers number;
    const terrain::Ellipsoid& body = globe.Grid.Body;
    int leaks = 0;
    for (int view = 0; view < 10; ++view)
    {
      const glm::dvec2 below(number(400.0, 600.0), number(400.0, 600.0)); // columns and rows
      const auto position = [&](const glm::dvec2& at, double height)
      {
        return body.ToPosition(
          { globe.Grid.West + at.x * globe.Grid.Step, globe.Grid.LatitudeOf(at.y), height });
      };
      const glm::dvec3 anchor = position(below, 0.0);
      const glm::dvec3 eye = 3.2 * anchor;
      const terrain::WorldTracer<float, Texel> tracer(world, anchor);
      const GlobeTexture lines(scene.Window, tracer);
      std::vector<terrain::GlobeRay<float>> rays;
      for (int k = 0; k < 4000; ++k)
      {
        glm::dvec2 at = below + glm::dvec2(number(-200.0, 200.0), number(-2.0, 2.0));
        double height = 0.0;
        if (!flat)
        {
          at.y = std::floor(below.y + number(-200.0, 200.0)); // on a line
          const int i = static_cast<int>(at.x);
          const int j = static_cast<int>(at.y);
          height = glm::mix(world.Height(i, j), world.Height(i + 1, j), at.x - i);
        }
        const glm::dvec3 target = position(at, height);
        const glm::dvec3 way = glm::normalize(target - eye);
        terrain::GlobeRay<float> ray;
        ray.Origin = glm::vec3(tracer.Anchor.ToAxes(target - 1.8e5 * way - tracer.Anchor.Position));
        ray.Direction = glm::vec3(tracer.Anchor.ToAxes(way));
        ray.End = 1e8f;
        rays.push_back(ray);
      }
      const std::vector<float> drawn = CastOnCard(scene.Window, field, lines, rays);
      for (std::size_t k = 0; k < rays.size(); ++k)
      {
        const bool ends =
          drawn[4 * k] != 0.0f && drawn[4 * k + 3] != 0.0f && drawn[4 * k + 1] < 1.81e5f;
        leaks += ends ? 0 : 1;
      }
    }
    EXPECT_EQ(leaks, 0);
  }
}

// From space a pixel shows the place that its ray in double precision meets, to a part of a metre:
// floats that count from the eye would be off by metres.
TEST(TerrainShaderGlobe, ShowsThePlaceOfAPixelFromSpace)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const terrain::TestGlobe globe = terrain::TestGlobes()[7]; // fine cells
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  FieldTextures<Texel> field(scene.Window, world.Field, true);
  const glm::dvec3 anchor = MiddleOf(globe.Grid, 0.0);
  const terrain::WorldTracer<float, Texel> tracer(world, anchor);
  const GlobeTexture lines(scene.Window, tracer);
  constexpr double altitude = 1.9e7;
  const glm::dvec3 up(
    glm::length(glm::dvec2(anchor)) / glm::length(anchor), 0.0, anchor.z / glm::length(anchor));
  const glm::dmat4 view = glm::lookAt(
    altitude * up, glm::dvec3(0.0), glm::dvec3(-up.z, 0.0, up.x) + glm::dvec3(0.0, 0.1, 0.0));
  const terrain::PixelRays rays = terrain::MakePixelRays(
    view, glm::perspective(4000.0 / altitude, 2.0, 1e6, 1e8), glm::dvec4(0.0, 0.0, 200.0, 100.0));
  const terrain::GlobeReference reference = world.Reference();
  vtkTerrainTesting::Numbers number;
  std::vector<std::vector<float>> inputs(1);
  for (int k = 0; k < 500; ++k)
  {
    inputs[0].insert(inputs[0].end(), { number(10.0, 190.0), number(10.0, 90.0), 1e6f, 1e8f });
  }
  const std::vector<float> drawn =
    vtkTerrainTesting::RunShader(scene.Window, GlobeDeclarations(field.GetFeatures()),
      "bool front; vec4 codes;"
      "TerrainHit hit = terrainGlobeTraceRange(input0.xy, input0.zw, front, codes);"
      "result = vec4(hit.found, hit.cell.x + 4096 * hit.cell.y, hit.fraction);",
      inputs,
      [&](vtkShaderProgram* program)
      {
        vtkTerrainTesting::SetRays(program, rays);
        field.SetUniforms(program);
        lines.SetUniforms(program);
      });
  const double metres = globe.Grid.Step * globe.Grid.Body.Equatorial;
  const terrain::GlobeAnchor& a = tracer.Anchor;
  const glm::dmat3 toAxes{ { a.Cosine, a.Sine, 0.0 }, { -a.Sine, a.Cosine, 0.0 },
    { 0.0, 0.0, 1.0 } };
  int hits = 0;
  int far = 0;
  for (std::size_t k = 0; k < inputs[0].size() / 4; ++k)
  {
    const glm::dvec2 pixel(inputs[0][4 * k], inputs[0][4 * k + 1]);
    terrain::GlobeReferenceRay ray;
    ray.Origin = anchor + toAxes * terrain::AtPixel(rays.OriginGC, pixel);
    ray.Direction = toAxes * terrain::AtPixel(rays.DirectionGC, pixel);
    ray.Begin = 1e6;
    ray.End = 1e8;
    const auto hit = reference.Cast(ray);
    if (!hit.Found)
    {
      continue;
    }
    ++hits;
    const int cell = static_cast<int>(drawn[4 * k + 1]);
    const glm::dvec2 found(cell % 4096 + drawn[4 * k + 2], cell / 4096 + drawn[4 * k + 3]);
    const glm::dvec2 expected = glm::dvec2(hit.Cell) + hit.Fraction;
    far += drawn[4 * k] != 0.0f && glm::length(found - expected) * metres < 0.5 ? 0 : 1;
  }
  EXPECT_GE(hits, 300);
  // steep cells hide one another: a few rays end beside a silhouette
  EXPECT_LE(far, hits / 100);
}
