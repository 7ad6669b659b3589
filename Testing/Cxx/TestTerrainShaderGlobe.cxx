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

/// Geocentric position of a place in columns and rows of a grid.
glm::dvec3 PositionOn(const terrain::GlobeGrid& grid, const glm::dvec2& at, double height)
{
  return grid.Body.ToPosition({ grid.West + at.x * grid.Step, grid.LatitudeOf(at.y), height });
}

/// Rays of 200 x 100 pixels, of an eye so far from a planet's middle that looks down at an anchor,
/// turned a little; in the anchor's axes.
terrain::PixelRays MakeRaysFromSpace(const glm::dvec3& anchor, double distance)
{
  const double length = glm::length(anchor);
  const glm::dvec3 up(glm::length(glm::dvec2(anchor)) / length, 0.0, anchor.z / length);
  const glm::dvec3 north = glm::dvec3(-up.z, 0.0, up.x) + glm::dvec3(0.0, 0.1, 0.0);
  return terrain::MakePixelRays(glm::lookAt(distance * up, glm::dvec3(0.0), north),
    glm::perspective(4000.0 / distance, 2.0, 1e6, 1e8), glm::dvec4(0.0, 0.0, 200.0, 100.0));
}

/// Rays about an anchor, and where the reference says that they meet the surface, in metres.
struct Hits
{
  std::vector<terrain::GlobeRay<float>> Rays;
  std::vector<double> Distances;
};

/// Rays that go down from an anchor and meet the surface within kFarthest.
template <typename Anchor>
Hits MakeHits(const terrain::GlobeReference& reference, const Anchor& anchor)
{
  Hits hits;
  vtkTerrainTesting::Numbers number;
  const glm::dvec3 up = glm::normalize(anchor.Position);
  while (hits.Rays.size() < 300)
  {
    terrain::GlobeReferenceRay ray;
    ray.Origin = anchor.Position;
    const glm::dvec3 any(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
    ray.Direction = glm::normalize(glm::normalize(any) - 0.9 * up);
    ray.End = 2.0 * kFarthest;
    const auto hit = reference.Cast(ray);
    if (hit.Found && hit.T < kFarthest && glm::dot(ray.Direction, up) < -0.2)
    {
      terrain::GlobeRay<float> about;
      about.Direction = glm::vec3(anchor.ToAxes(ray.Direction));
      about.End = static_cast<float>(ray.End);
      hits.Rays.push_back(about);
      hits.Distances.push_back(hit.T);
    }
  }
  return hits;
}

/// A part of a planet in steps of 30 seconds, with plateaus or with waves of whole metres.
terrain::TestGlobe MakePart(bool flat)
{
  const double step = 1.0 / 120.0;
  return { "part", terrain::MakeGrid({}, 24.0, step, 1025, terrain::Parallels(24.0, step, 1025)),
    [flat](int i, int j)
    {
      return flat ? ((i / 97 + j / 61) % 5 == 0 ? 8000.0 : 0.0)
                  : std::floor(3000.0 + 2000.0 * std::sin(0.21 * i) * std::cos(0.17 * j));
    } };
}

/// Rays from space at ground about columns and rows of a grid, from 180 km before it: along a
/// parallel of flat ground, or at points on the lines between cells.
template <typename Tracer>
std::vector<terrain::GlobeRay<float>> MakeRaysAtGround(const terrain::World<Texel>& world,
  const terrain::GlobeGrid& grid, const Tracer& tracer, const glm::dvec2& below, bool flat,
  vtkTerrainTesting::Numbers& number)
{
  const glm::dvec3 eye = 3.2 * tracer.Anchor.Position;
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
    const glm::dvec3 target = PositionOn(grid, at, height);
    const glm::dvec3 way = glm::normalize(target - eye);
    terrain::GlobeRay<float> ray;
    ray.Origin = glm::vec3(tracer.Anchor.ToAxes(target - 1.8e5 * way - tracer.Anchor.Position));
    ray.Direction = glm::vec3(tracer.Anchor.ToAxes(way));
    ray.End = 1e8f;
    rays.push_back(ray);
  }
  return rays;
}
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
    const terrain::WorldTracer<float, Texel> tracer(world, MiddleOf(globes[which].Grid, 9500.0));
    const GlobeTexture lines(scene.Window, tracer);
    const Hits hits = MakeHits(world.Reference(), tracer.Anchor);
    const std::vector<float> drawn = CastOnCard(scene.Window, field, lines, hits.Rays);
    for (std::size_t k = 0; k < hits.Rays.size(); ++k)
    {
      const double expected = hits.Distances[k];
      ASSERT_NE(drawn[4 * k], 0.0f);
      ASSERT_NEAR(drawn[4 * k + 1], expected, kPart * expected + terrain::kGlobeFloatError);
    }
  }
}

// Where meridians meet, hits still lie on the surface, but for what float rounds of a place.
TEST(TerrainShaderGlobe, HitsLieOnTheSurfaceAtThePole)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const terrain::TestGlobe globe = terrain::RoughPole(1.0);
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  const terrain::GlobeReference reference = world.Reference();
  FieldTextures<Texel> field(scene.Window, world.Field, true);
  const terrain::WorldTracer<float, Texel> tracer(world, MiddleOf(globe.Grid, 6000.0));
  const GlobeTexture lines(scene.Window, tracer);
  vtkTerrainTesting::Numbers number;
  std::vector<terrain::GlobeRay<float>> rays;
  std::vector<glm::dvec3> ways;
  for (int k = 0; k < 40000; ++k)
  {
    const glm::dvec2 cells(number(0.0, 23.0), number(0.0, 5.0));
    const glm::dvec3 target = PositionOn(globe.Grid, cells, number(0.0, 4000.0));
    ways.push_back(glm::normalize(target - tracer.Anchor.Position));
    terrain::GlobeRay<float> ray;
    ray.Direction = glm::vec3(tracer.Anchor.ToAxes(ways.back()));
    ray.End = 1e7f;
    rays.push_back(ray);
  }
  const std::vector<float> drawn = CastOnCard(scene.Window, field, lines, rays);
  int hits = 0;
  for (std::size_t k = 0; k < rays.size(); ++k)
  {
    if (drawn[4 * k] == 0.0f)
    {
      continue;
    }
    ++hits;
    const double t = drawn[4 * k + 1];
    const int code = static_cast<int>(drawn[4 * k + 2]);
    glm::ivec2 cell(code % 4096, code / 4096);
    const glm::dvec3 position = tracer.Anchor.Position + t * ways[k];
    glm::dvec2 fraction;
    const double steepness =
      terrain::HeightErrorAt(world, cell, globe.Grid.Body.ToPlace(position).y) /
      terrain::kGlobeError;
    EXPECT_NEAR(reference.Above(position, cell, fraction, true), 0.0,
      (terrain::kGlobeFloatError + terrain::kGlobeFloatPartError * t) * steepness)
      << k << " " << t << " " << cell.x << " " << cell.y;
  }
  EXPECT_GT(hits, 10000);
}

// Rays at points on the lines between cells, and at flat ground along the parallel of an anchor:
// all of them end there, and see the surface from above.
TEST(TerrainShaderGlobe, IsWatertight)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  for (const bool flat : { false, true })
  {
    SCOPED_TRACE(flat);
    const terrain::TestGlobe globe = MakePart(flat);
    const terrain::World<Texel> world(globe.Grid, globe.Field());
    FieldTextures<Texel> field(scene.Window, world.Field, true);
    vtkTerrainTesting::Numbers number;
    int leaks = 0;
    for (int view = 0; view < 10; ++view)
    {
      const glm::dvec2 below(number(400.0, 600.0), number(400.0, 600.0)); // columns and rows
      const terrain::WorldTracer<float, Texel> tracer(world, PositionOn(globe.Grid, below, 0.0));
      const GlobeTexture lines(scene.Window, tracer);
      const auto rays = MakeRaysAtGround(world, globe.Grid, tracer, below, flat, number);
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
  const terrain::PixelRays rays = MakeRaysFromSpace(anchor, 1.9e7);
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
