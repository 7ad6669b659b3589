// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the rays of pixels see: shaders/vtkTerrainCast.glsl against its twin
// src/core/rays/PixelCast.h, and what stands between fragments and rays or meshes, in
// shaders/vtkTerrainSurface.glsl, against src/core/rays/SurfaceShading.h and ShadedSurface.h.
#include "vtkTerrainTestItems.h"
#include "vtkTerrainTestPoints.h"
#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTesting.h"

#include "core/rays/PixelCast.h"
#include "core/rays/ShadedSurface.h"
#include "core/surface/HeightSlopes.h"

#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{
using terrain::PixelCast;
using terrain::PixelRays;
using terrain::Sighting;
using vtkTerrainTesting::Items;
using vtkTerrainTesting::Numbers;
using vtkTerrainTesting::ReadShader;

constexpr int Count = vtkTerrainTesting::NumberOfItems;

/// Hills with a hole, below the eye of ViewOf().
terrain::TestField Hills()
{
  return { "hills", 200, 150,
    [](int i, int j)
    {
      const bool hole = i / 9 == 3 && j / 9 == 2;
      return hole ? std::nan("") : 6.0 + 4.0 * std::sin(0.31 * i) * std::cos(0.23 * j) + 0.06 * j;
    } };
}

/// Planes that keep a part of the hills as a block, in view coordinates.
std::vector<glm::vec4> BlockPlanes(const glm::dmat4& view)
{
  std::vector<glm::vec4> planes;
  for (const glm::dvec4& plane : { glm::dvec4(1.0, 0.0, 0.0, -4.0),
         glm::dvec4(-1.0, 0.0, 0.0, 60.0), glm::dvec4(0.0, 1.0, 0.0, -3.0),
         glm::dvec4(0.0, -1.0, 0.0, 50.0), glm::dvec4(0.0, 0.0, 1.0, 2.0) })
  {
    planes.emplace_back(glm::transpose(glm::inverse(view)) * plane);
  }
  return planes;
}

std::string Declarations(const terrain::Features& features)
{
  std::string text = features.Defines() + terrain::Features::Constants();
  for (const char* name :
    { "Heights", "Columns", "Ray", "View", "Pyramid", "Trace", "Sighting", "Cast" })
  {
    text += ReadShader(std::string("vtkTerrain") + name);
  }
  return text;
}

void SetUniforms(vtkShaderProgram* program, const PixelCast<float>& cast)
{
  vtkTerrainTesting::SetRays(program, cast.Rays);
  program->SetUniform3f("terrainBoxMinimum", &cast.BoxMinimum[0]);
  program->SetUniform3f("terrainBoxMaximum", &cast.BoxMaximum[0]);
  program->SetUniformf("terrainBegin", static_cast<float>(cast.Begin));
  program->SetUniformf("terrainFar", static_cast<float>(cast.Far));
  program->SetUniformi("terrainLayer", cast.Layer);
  program->SetUniform2i("terrainCulled", &cast.Culled[0]);
  const int planes = static_cast<int>(cast.PlanesVC.size());
  program->SetUniformi("terrainClipPlaneCount", planes);
  if (planes > 0)
  {
    program->SetUniform4fv("terrainClipPlanesVC", planes, &cast.PlanesVC[0][0]);
  }
}

/// What a sighting is of: none, a side of the surface, or a wall.
float KindOf(const Sighting& sighting)
{
  return sighting.found
    ? 1.0f + (sighting.front ? 1.0f : 0.0f) + 3.0f * static_cast<float>(sighting.wall + 1)
    : 0.0f;
}

/// How many sightings a shader and its twin share; those that differ are of a ray nearby, or wrong.
struct Comparison
{
  int Wrong = 0;
  int Found = 0;
  int Backs = 0;
  int Walls = 0;

  /// Kind, distance and position as drawn. Rays that graze the surface may see what lies anywhere
  /// between what those of pixels a thousandth beside see.
  void Add(const PixelCast<float>& cast, const glm::vec2& pixel, const glm::vec4& drawn)
  {
    bool agrees = false;
    float nearest = 1e30f;
    float farthest = -1e30f;
    for (int k = 0; k < 9; ++k)
    {
      const glm::dvec2 beside = 1e-3 * glm::dvec2(k % 3 - 1, k / 3 - 1);
      const Sighting seen = cast.Cast(glm::dvec2(pixel) + beside, 0.0f);
      agrees = agrees || KindOf(seen) == drawn.x;
      nearest = seen.found ? std::min(nearest, seen.distanceVC) : nearest;
      farthest = seen.found ? std::max(farthest, seen.distanceVC) : farthest;
      if (k == 4)
      {
        this->Found += seen.found ? 1 : 0;
        this->Backs += seen.found && !seen.front ? 1 : 0;
        this->Walls += seen.found && seen.wall >= 0 ? 1 : 0;
      }
    }
    const float room = 1e-5f * drawn.y;
    const glm::vec3 there(terrain::AtPixel(cast.Rays.OriginGC, pixel) +
      static_cast<double>(drawn.y) * terrain::AtPixel(cast.Rays.DirectionGC, pixel));
    const bool right = agrees &&
      (drawn.x == 0.0f ||
        (drawn.y >= nearest - room && drawn.y <= farthest + room &&
          glm::distance(glm::vec2(there), glm::vec2(drawn.z, drawn.w)) < 1e-3f));
    this->Wrong += right ? 0 : 1;
  }
};

/// Points of a mesh above, on and below a surface, as by PointBelow().
struct MeshPoints
{
  Items Places;
  Items Normals;
  int Clipped = 0;

  MeshPoints(const terrain::CodedField<float>& field, const PixelRays& rays,
    const glm::dmat4& toGrid, const std::vector<glm::vec4>& planes, const glm::vec3& face)
  {
    Numbers number;
    while (this->Places.Expected.size() < Count)
    {
      const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
      const glm::vec4 position = terrain::PositionVC(rays, pixel, number(60.0, 140.0));
      const bool front = number(0.0, 1.0) > 0.3f;
      const terrain::ShadedSurface surface = terrain::PointBelow(
        rays, field.Coded.heights, {}, toGrid, position, face, pixel, front, true);
      const glm::vec2 inside = glm::min(surface.Fraction, 1.0f - surface.Fraction);
      float nearest = 1.0f;
      for (const glm::vec4& plane : planes)
      {
        nearest = std::min(nearest, std::abs(glm::dot(plane, position)));
      }
      const glm::vec4 codes = field.Coded.heights.CellCodes(surface.Cell);
      if (nearest < 1e-3f || glm::any(glm::lessThan(inside, glm::vec2(1e-3f))) ||
        glm::any(glm::lessThan(codes, glm::vec4(0.0f))))
      {
        continue; // rounding decides, or there is no surface
      }
      const bool isClipped = terrain::IsClipped(planes, position);
      this->Clipped += isClipped ? 1 : 0;
      this->Places.Add({ pixel, front, 0.0f }, position,
        { glm::vec2(surface.Cell) + surface.Fraction, surface.Code, surface.Front });
      this->Normals.Add({ pixel, front, 0.0f }, position, { surface.NormalVC, isClipped });
    }
  }
};

class TerrainShaderTwinsCast : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Canvas.Window->Render();
  }

  /// Casts the rays of random pixels by both.
  Comparison Compare(const terrain::CodedField<float>& field, const PixelCast<float>& cast)
  {
    vtkTerrainTesting::FieldTextures<float> textures(this->Canvas.Window, field, true);
    terrain::Features features = textures.GetFeatures();
    features.ClipPlanes = static_cast<int>(cast.PlanesVC.size());
    features.Block = cast.Block;
    Numbers number;
    std::vector<std::vector<float>> inputs(1);
    std::vector<glm::vec2> pixels;
    for (int k = 0; k < Count; ++k)
    {
      pixels.emplace_back(number(0.0, 200.0), number(0.0, 100.0));
      inputs[0].insert(inputs[0].end(), { pixels.back().x, pixels.back().y, 0.0f, 0.0f });
    }
    const std::vector<float> drawn =
      vtkTerrainTesting::RunShader(this->Canvas.Window, Declarations(features),
        "TerrainSighting seen = terrainCast(input0.xy, 0.0);"
        "float kind = seen.found ? 1.0 + (seen.front ? 1.0 : 0.0) + 3.0 * float(seen.wall + 1)"
        ": 0.0; result = vec4(kind, seen.distanceVC, vec2(seen.cell) + seen.fraction);",
        inputs,
        [&](vtkShaderProgram* program)
        {
          textures.SetUniforms(program);
          SetUniforms(program, cast);
        });
    EXPECT_EQ(drawn.size(), 4u * Count);
    Comparison comparison;
    for (std::size_t k = 0; k < drawn.size() / 4; ++k)
    {
      comparison.Add(
        cast, pixels[k], { drawn[4 * k], drawn[4 * k + 1], drawn[4 * k + 2], drawn[4 * k + 3] });
    }
    return comparison;
  }

  vtkTerrainTesting::Scene Canvas = vtkTerrainTesting::MakeScene(16, 16);
};
}

// Surfaces that are passed by, from above and below, of patches and of columns.
TEST_F(TerrainShaderTwinsCast, SeeTheSameSurfaces)
{
  terrain::CodedField<float> field(Hills());
  const PixelRays rays = vtkTerrainTesting::RaysOf(false);
  int found = 0;
  int backs = 0;
  for (const bool columns : { false, true })
  {
    field.Coded.columns = columns;
    for (const int layer : { 0, 1, 2 })
    {
      for (const glm::ivec2 culled : { glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1) })
      {
        SCOPED_TRACE(::testing::Message() << columns << layer << culled.x << culled.y);
        PixelCast<float> cast{ rays, field.Coded };
        cast.BoxMaximum = glm::vec3(199.0f, 149.0f, field.Coded.heights.maximumCode);
        cast.Far = 300.0;
        cast.Layer = layer;
        cast.Culled = culled;
        const Comparison comparison = this->Compare(field, cast);
        EXPECT_EQ(comparison.Wrong, 0);
        EXPECT_TRUE(culled.y == 0 || comparison.Backs == 0);
        found += comparison.Found;
        backs += comparison.Backs;
      }
    }
  }
  EXPECT_GT(found, 2 * Count);
  EXPECT_GT(backs, Count / 10);
}

// A block's walls, and what is seen where they are passed by.
TEST_F(TerrainShaderTwinsCast, SeeTheSameBlocks)
{
  terrain::CodedField<float> field(Hills());
  const PixelRays rays = vtkTerrainTesting::RaysOf(false);
  for (const bool columns : { false, true })
  {
    field.Coded.columns = columns;
    for (const int layer : { 0, 1 })
    {
      SCOPED_TRACE(::testing::Message() << columns << layer);
      PixelCast<float> cast{ rays, field.Coded };
      cast.BoxMinimum = glm::vec3(0.0f, 0.0f, -2.0f);
      cast.BoxMaximum = glm::vec3(199.0f, 149.0f, field.Coded.heights.maximumCode);
      cast.Far = 300.0;
      cast.Layer = layer;
      cast.PlanesVC = BlockPlanes(vtkTerrainTesting::ViewOf());
      cast.Block = true;
      const Comparison comparison = this->Compare(field, cast);
      EXPECT_EQ(comparison.Wrong, 0);
      EXPECT_EQ(comparison.Walls > 50, layer == 0);
      EXPECT_TRUE(layer > 0 || comparison.Found > Count / 5);
    }
  }
}

// Rays of ninety thousand cells, of which the second trace finds the place, to a thousandth of a
// cell. One trace alone is off by more where rays graze the surface.
TEST_F(TerrainShaderTwinsCast, TraceFarRaysAgain)
{
  const terrain::CodedField<float> field(Hills());
  vtkTerrainTesting::FieldTextures<float> textures(this->Canvas.Window, field, true);
  const glm::dmat4 view = glm::lookAt(
    glm::dvec3(80.0, -90000.0, 9000.0), glm::dvec3(100.0, 75.0, 7.0), glm::dvec3(0.0, 0.0, 1.0));
  const PixelRays rays = terrain::MakePixelRays(
    view, glm::perspective(0.002, 2.0, 1.0, 2e5), glm::dvec4(0.0, 0.0, 200.0, 100.0));
  PixelCast<float> cast{ rays, field.Coded };
  Numbers number;
  Items items;
  int farther = 0;
  while (items.Expected.size() < Count)
  {
    const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
    const glm::vec2 range(1.0f, 2e5f);
    bool front = false;
    glm::vec4 codes;
    const terrain::TerrainHit hit = cast.TraceRange(pixel, range, front, codes);
    const terrain::TerrainHit once = cast.TraceRange(pixel, range, front, codes, false);
    const glm::dvec2 place = glm::dvec2(hit.cell) + glm::dvec2(hit.fraction);
    const glm::dvec2 other = glm::dvec2(once.cell) + glm::dvec2(once.fraction);
    farther += hit.found && glm::distance(place, other) > 1e-3 ? 1 : 0;
    items.Add({ pixel, range }, glm::vec4(0.0f),
      hit.found ? glm::vec4(1.0f, hit.s, glm::vec2(place)) : glm::vec4(0.0f));
  }
  EXPECT_GT(farther, 20);
  EXPECT_LE(items.CountDifferent(this->Canvas.Window, Declarations(textures.GetFeatures()),
              "bool front; vec4 codes;"
              "TerrainHit hit = terrainTraceRange(input0.xy, input0.zw, front, codes);"
              "result = hit.found ? vec4(1.0, hit.s, vec2(hit.cell) + hit.fraction) : vec4(0.0);",
              1e-5f,
              [&](vtkShaderProgram* program)
              {
                textures.SetUniforms(program);
                SetUniforms(program, cast);
              }),
    0);
}

// Where rays begin on the box, and the depths of their hits, which lie behind the box's.
TEST_F(TerrainShaderTwinsCast, BeginAndEndAlike)
{
  const PixelRays rays = vtkTerrainTesting::RaysOf(false);
  terrain::Features features;
  features.Way = terrain::Features::Ways::Pyramid;
  features.BelowBox = true;
  features.ShiftsDepth = true; // no depth is drawn here
  Numbers number;
  Items items;
  for (int k = 0; k < Count; ++k)
  {
    const glm::vec4 position(
      number(-50.0, 50.0), number(-30.0, 30.0), number(-290.0, k % 5 == 0 ? 0.0 : -2.0), 1.0f);
    const float depth = number(0.0, 1.0);
    items.Add(position, glm::vec4(depth),
      { terrain::Entry(position), terrain::FragmentDepth(rays, position, depth), 0.0f, 0.0f });
  }
  EXPECT_EQ(
    items.CountDifferent(this->Canvas.Window,
      Declarations(features) + ReadShader("vtkTerrainGradient") + ReadShader("vtkTerrainSurface"),
      "result.xy = vec2(terrainEntry(input0), terrainFragmentDepth(input0, input1.x));", 2e-6f,
      [&](vtkShaderProgram* program) { vtkTerrainTesting::SetRays(program, rays); }),
    0);
}

// What is cut off of a mesh, and normals that turn to the viewer.
TEST_F(TerrainShaderTwinsCast, AreBelowTheSameMeshes)
{
  const terrain::CodedField<float> field(Hills());
  vtkTerrainTesting::FieldTextures<float> textures(this->Canvas.Window, field, true);
  terrain::Features features = textures.GetFeatures();
  features.Way = terrain::Features::Ways::Mesh;
  features.ClipPlanes = 5;
  std::string text = features.Defines() + terrain::Features::Constants();
  for (const char* name : { "Heights", "Ray", "View", "Gradient", "Surface" })
  {
    text += ReadShader(std::string("vtkTerrain") + name);
  }
  const PixelRays rays = vtkTerrainTesting::RaysOf(false);
  const glm::dmat4 view = vtkTerrainTesting::ViewOf();
  const std::vector<glm::vec4> planes = BlockPlanes(view);
  const glm::vec3 face = glm::normalize(glm::vec3(0.2f, 0.3f, 0.9f));
  const MeshPoints points(field, rays, glm::inverse(view), planes, face);
  EXPECT_GT(points.Clipped, Count / 10);
  EXPECT_LT(points.Clipped, Count * 9 / 10);
  const auto set = [&](vtkShaderProgram* program)
  {
    vtkTerrainTesting::SetRays(program, rays);
    textures.SetUniforms(program);
    program->SetUniformi("terrainFlat", 1);
    program->SetUniformi("terrainMirrored", 0);
    glm::mat4 matrix(glm::inverse(view));
    program->SetUniformMatrix4x4("terrainViewToGrid", &matrix[0][0]);
    program->SetUniformi("terrainClipPlaneCount", static_cast<int>(planes.size()));
    program->SetUniform4fv("terrainClipPlanesVC", static_cast<int>(planes.size()), &planes[0][0]);
  };
  const std::string below =
    "TerrainSurface surface = terrainPointBelow(input1, normalize(vec3(0.2, 0.3, 0.9)), input0.xy,"
    "input0.z > 0.5);";
  EXPECT_EQ(points.Places.CountDifferent(this->Canvas.Window, text,
              below +
                "result = vec4(vec2(surface.cell) + surface.fraction, surface.code,"
                "surface.front ? 1.0 : 0.0);",
              1e-4f, set),
    0);
  EXPECT_EQ(
    points.Normals.CountDifferent(this->Canvas.Window, text,
      below + "result = vec4(surface.normalVC, terrainIsClipped(input1) ? 1.0 : 0.0);", 2e-3f, set),
    0);
}
