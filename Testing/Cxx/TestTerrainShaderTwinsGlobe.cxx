// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainGlobeTrace.glsl and vtkTerrainGlobeLines.glsl against their twins,
// core/globe/GlobeTraversal.h in float and GlobePixels.h: the same rays at the same worlds, step
// for step, and the axes of the grid.
#include "vtkTerrainTestGlobeCard.h"
#include "vtkTerrainTestItems.h"
#include "vtkTerrainTestPoints.h"
#include "vtkTerrainTestTwins.h"

#include "core/globe/GlobePixels.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using terrain::GlobeRays;
using vtkTerrainTesting::CastOnCard;
using vtkTerrainTesting::FieldTextures;
using vtkTerrainTesting::GlobeDeclarations;
using vtkTerrainTesting::GlobeTexture;
using vtkTerrainTesting::MiddleOf;
using vtkTerrainTesting::NumberOfRays;
using Texel = vtkTerrainTesting::GlobeTexel;

/// Eight times what float rounds of a place, as a part of its distance from the anchor.
constexpr float kRoundedPlace = 1e-6f;

/// True if a hit, at distance t, is that of a ray whose origin is moved by what float rounds of it:
/// of rays that graze the ground or pass a silhouette the distances may lie anywhere between those
/// of rays nearby.
template <typename Traversal>
bool IsOfARayNearby(
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
void CompareRays(vtkRenderWindow* window, const terrain::TestGlobe& globe, int kind)
{
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  FieldTextures<Texel> field(window, world.Field, kind % 2 == 0);
  GlobeRays rays(globe, 17u + static_cast<unsigned>(kind));
  const terrain::GlobeReferenceRay first = rays.Make(kind);
  const terrain::WorldTracer<float, Texel> tracer(world, first.Origin);
  const GlobeTexture lines(window, tracer);
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
  }
  const std::vector<float> drawn = CastOnCard(window, field, lines, cast);
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
    wrong += same || IsOfARayNearby(found, drawn[4 * k + 1], cast[k], tracer.Traversal) ? 0 : 1;
    turned += same && found && front != hit.Front ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(turned, 0);
  EXPECT_GE(hits, NumberOfRays / 20); // a cone of rays may pass by a small raster
}

/// The rays of a camera above the anchor, in its axes.
terrain::PixelRays RaysAbove(const glm::dvec3& anchor, double altitude)
{
  const double length = glm::length(anchor);
  const glm::dvec3 up(glm::length(glm::dvec2(anchor)) / length, 0.0, anchor.z / length);
  const glm::dvec3 north(-up.z, 0.0, up.x);
  const glm::dmat4 view =
    glm::lookAt(altitude * (up - 0.7 * north), glm::dvec3(0.0), north + 0.1 * up);
  return terrain::MakePixelRays(
    view, glm::perspective(0.8, 2.0, 1.0, 1e8), glm::dvec4(0.0, 0.0, 200.0, 100.0));
}

/// Rays of pixels by both: they end at the same place, or where the ray of a pixel a tenth beside
/// does.
void ComparePixels(vtkRenderWindow* window, const terrain::TestGlobe& globe, double altitude)
{
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  FieldTextures<Texel> field(window, world.Field, true);
  const glm::dvec3 anchor = MiddleOf(globe.Grid, 0.0);
  const terrain::WorldTracer<float, Texel> tracer(world, anchor);
  const GlobeTexture lines(window, tracer);
  const terrain::PixelRays rays = RaysAbove(anchor, altitude);
  const glm::vec2 range(0.3 * altitude, 1e8f);
  vtkTerrainTesting::Numbers number;
  std::vector<std::vector<float>> inputs(1);
  for (int k = 0; k < NumberOfRays; ++k)
  {
    inputs[0].insert(inputs[0].end(), { number(0.0, 200.0), number(0.0, 100.0), range.x, range.y });
  }
  const std::vector<float> drawn =
    vtkTerrainTesting::RunShader(window, GlobeDeclarations(field.GetFeatures()),
      "bool front; vec4 codes;"
      "TerrainHit hit = terrainGlobeTraceRange(input0.xy, input0.zw, front, codes);"
      "result = vec4(hit.found, hit.s, front, hit.found && codes == terrainCellCodes(hit.cell));",
      inputs,
      [&](vtkShaderProgram* program)
      {
        vtkTerrainTesting::SetRays(program, rays);
        field.SetUniforms(program);
        lines.SetUniforms(program);
      });
  ASSERT_EQ(drawn.size(), 4u * NumberOfRays);
  int wrong = 0;
  int hits = 0;
  for (std::size_t k = 0; k < NumberOfRays; ++k)
  {
    const float* const result = &drawn[4 * k];
    bool agrees = false;
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = -nearest;
    for (int side = 0; side < 9; ++side)
    {
      const glm::dvec2 pixel = glm::dvec2(inputs[0][4 * k], inputs[0][4 * k + 1]) +
        0.1 * glm::dvec2(side % 3 - 1, side / 3 - 1);
      bool front = true;
      const terrain::TerrainHit hit =
        terrain::GlobeTraceRange(tracer.Traversal, rays, pixel, range, front);
      agrees = agrees || (hit.found == (result[0] != 0.0f) && front == (result[2] != 0.0f));
      nearest = hit.found ? std::min(nearest, hit.s) : nearest;
      farthest = hit.found ? std::max(farthest, hit.s) : farthest;
      hits += side == 4 && hit.found ? 1 : 0;
    }
    const float room = 1e-6f * result[1] + 0.1f;
    const bool there =
      result[3] != 0.0f && result[1] >= nearest - room && result[1] <= farthest + room;
    wrong += agrees && (result[0] == 0.0f || there) ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(hits, NumberOfRays / 10);
}

/// The axes of the grid at random places, about an anchor in the middle of it, to a part of each.
void CompareAxes(vtkRenderWindow* window, const terrain::TestGlobe& globe)
{
  const terrain::World<Texel> world(globe.Grid, globe.Field());
  FieldTextures<Texel> field(window, world.Field, true);
  const terrain::WorldTracer<float, Texel> tracer(world, MiddleOf(globe.Grid, 2000.0));
  const GlobeTexture lines(window, tracer);
  const auto& heights = world.Field.Coded.heights;
  vtkTerrainTesting::Numbers number;
  vtkTerrainTesting::Items items[3];
  while (items[0].Expected.size() < vtkTerrainTesting::NumberOfItems)
  {
    const glm::ivec2 cells = globe.Grid.Cells();
    const glm::ivec2 cell(number(0.0, cells.x - 0.001), number(0.0, cells.y - 0.001));
    const glm::vec2 fraction(number(0.0, 1.0), number(0.0, 1.0));
    const glm::vec4 codes = heights.CellCodes(cell);
    const auto row = static_cast<std::size_t>(cell.y);
    const glm::dvec2 at = glm::dvec2(cell) + glm::dvec2(fraction);
    const double latitude = glm::mix(
      globe.Grid.Latitudes[row], globe.Grid.Latitudes[row + 1], static_cast<double>(fraction.y));
    if (glm::any(glm::lessThan(codes, glm::vec4(0.0f))) || std::abs(latitude) > 1.5)
    {
      continue; // no surface, or where float does not tell the distance from the axis
    }
    const double height =
      world.Field.Codes.ToHeight(static_cast<double>(terrain::PatchCode(codes, fraction)));
    const glm::dvec3 place =
      globe.Grid.Body.ToPosition({ globe.Grid.West + at.x * globe.Grid.Step, latitude, height });
    const glm::vec3 positionGC(tracer.Anchor.ToAxes(place - tracer.Anchor.Position));
    const glm::dmat3 local = glm::transpose(terrain::GlobeSetLocal(
      globe.Grid, tracer.Anchor, cell, glm::dvec2(fraction), height, world.Field.Codes.Scale));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = glm::length(local[axis]);
      items[axis].Add({ glm::vec2(cell), fraction }, glm::vec4(positionGC, length),
        { glm::vec3(local[axis] / length), 1.0f });
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    EXPECT_EQ(items[axis].CountDifferent(window, GlobeDeclarations(field.GetFeatures()),
                "ivec2 cell = ivec2(input0.xy);"
                "terrainGlobeSetLocal(cell, input0.zw, terrainCellCodes(cell), input1.xyz);"
                "vec3 way = transpose(terrainGlobeLocal)[" +
                  std::to_string(axis) +
                  "]; result = vec4(way, length(way)); result.w /= input1.w;"
                  "result.xyz = normalize(way);",
                3e-5f,
                [&](vtkShaderProgram* program)
                {
                  field.SetUniforms(program);
                  lines.SetUniforms(program);
                }),
      0);
  }
}
}

TEST(TerrainShaderTwinsGlobe, SeesTheSameInPixels)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  for (const terrain::TestGlobe& globe : terrain::TestGlobes())
  {
    if (globe.Name == "0 to 360" || globe.Name == "northern" ||
      globe.Name == "across the date line")
    {
      for (const double altitude : { 2e4, 3e6 })
      {
        SCOPED_TRACE(::testing::Message() << globe.Name << " from " << altitude);
        ComparePixels(scene.Window, globe, altitude);
      }
    }
  }
}

TEST(TerrainShaderTwinsGlobe, HasTheSameAxes)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  for (const terrain::TestGlobe& globe : terrain::TestGlobes())
  {
    if (globe.Name == "oblate" || globe.Name == "holes" || globe.Name == "fine")
    {
      SCOPED_TRACE(globe.Name);
      CompareAxes(scene.Window, globe);
    }
  }
}

// The angles in a cell are small: to 1e-8. Larger ones are the driver's.
TEST(TerrainShaderTwinsGlobe, HasTheSameAngles)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  const terrain::World<Texel> world(
    terrain::TestGlobes().back().Grid, terrain::TestGlobes().back().Field());
  FieldTextures<Texel> field(scene.Window, world.Field, true);
  for (const bool small : { true, false })
  {
    SCOPED_TRACE(small);
    vtkTerrainTesting::Numbers number;
    vtkTerrainTesting::Items items;
    for (int k = 0; k < vtkTerrainTesting::NumberOfItems; ++k)
    {
      const float x = number(-1.0, 1.0) * (small ? 0.0447f : 1.0f);
      items.Add(
        glm::vec4(x), glm::vec4(0.0f), { 100.0f * terrain::GlobeAngle(x), 0.0f, 0.0f, 0.0f });
    }
    EXPECT_EQ(items.CountDifferent(scene.Window, GlobeDeclarations(field.GetFeatures()),
                "result.x = 100.0 * terrainGlobeAngle(input0.x);", small ? 1e-6f : 1e-4f,
                [&](vtkShaderProgram* program) { field.SetUniforms(program); }),
      0);
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
    CompareRays(scene.Window, globes[k], static_cast<int>(k) % GlobeRays::Count);
  }
}

TEST(TerrainShaderTwinsGlobe, AnglesAreThoseOfTheLibrary)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(8, 8);
  scene.Window->Render();
  constexpr int count = 4000;
  const double largest = std::tan(terrain::kGlobeCellAngle);
  std::vector<std::vector<float>> inputs(1);
  for (int k = -count; k <= count; ++k)
  {
    inputs[0].insert(
      inputs[0].end(), { static_cast<float>(largest * k / count), 0.0f, 0.0f, 0.0f });
  }
  const std::vector<float> drawn = vtkTerrainTesting::RunShader(scene.Window,
    GlobeDeclarations(terrain::Features()), "result = vec4(terrainGlobeAngle(input0.x));", inputs);
  ASSERT_EQ(drawn.size(), inputs[0].size());
  for (std::size_t k = 0; k < drawn.size(); k += 4)
  {
    const auto tangent = static_cast<double>(inputs[0][k]);
    ASSERT_NEAR(drawn[k], std::atan(tangent), terrain::kGlobeAngleError) << tangent;
  }
}
