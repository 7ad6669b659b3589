// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shaders/vtkTerrainTiles.glsl, vtkTerrainTileTrace.glsl and, over tiles, vtkTerrainBeam.glsl
// against their twins in src/core/: fields in tiles of which some are missing, with holes and
// without, as floats and as integers.
#include "vtkTerrainTestTiles.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::TerrainRay;
using terrain::TestField;
using terrain::TiledField;
using vtkTerrainTesting::Beams;
using vtkTerrainTesting::ReadShader;
using vtkTerrainTesting::TileArrays;

constexpr int kCells = 2000;

/// Traces rays by both, exactly or within a tolerance; returns the number of hits.
int CompareTraces(vtkRenderWindow* window, const TiledField& field, const TileArrays& arrays,
  unsigned seed, bool within)
{
  const float maximum = field.Rays.heights.maximumCode;
  const Beams beams(field.Rays.heights.size, maximum, seed);
  const glm::vec4 tolerance =
    within ? glm::vec4(2.0f, 0.3f * maximum, 3.0f, 0.3f * maximum) : glm::vec4(0.0f);
  vtkTerrainTesting::Paths paths;
  paths.Declarations = arrays.Declarations() + "uniform vec4 tolerance;\n";
  paths.Trace = "terrainTraceTiles(inputRay(input0, input1, input2), tolerance)";
  paths.MaximumCode = maximum;
  paths.SetUniforms = [&](vtkShaderProgram* program)
  {
    arrays.SetUniforms(program);
    program->SetUniform4f("tolerance", &tolerance[0]);
  };
  paths.Twin = [&](const TerrainRay& ray, std::uint32_t& visits)
  {
    return field.Rays.TraceTiles(ray, tolerance,
      [&](glm::ivec2 node, int level, bool) { vtkTerrainTesting::AddVisit(visits, node, level); });
  };
  return vtkTerrainTesting::ExpectSamePaths(window, paths, beams);
}

/// Finds the starts of beams by both; returns how many get on.
int CompareBeams(
  vtkRenderWindow* window, const TiledField& field, const TileArrays& arrays, unsigned seed)
{
  const float maximum = field.Rays.heights.maximumCode;
  const Beams beams(field.Rays.heights.size, maximum, seed);
  const terrain::PyramidBeam<terrain::TiledTexel> finder(field.Rays);
  return vtkTerrainTesting::ExpectSameStarts(
    window, arrays.Declarations() + ReadShader("vtkTerrainView") + ReadShader("vtkTerrainBeam"),
    beams, finder,
    [&](const TerrainRay& ray)
    {
      const terrain::TerrainHit hit =
        field.Rays.TraceTiles(ray, glm::vec4(0.0f), [](glm::ivec2, int, bool) {});
      return hit.found ? static_cast<double>(hit.s) : std::numeric_limits<double>::infinity();
    },
    [&](vtkShaderProgram* program) { arrays.SetUniforms(program); });
}

/// Reads slots, codes, bounds and heights of random cells by both.
void CompareReads(
  vtkRenderWindow* window, const TiledField& field, const TileArrays& arrays, unsigned seed)
{
  const terrain::TileSlots& slots = field.Slots;
  const glm::ivec2 size = field.Rays.heights.size;
  std::minstd_rand random(seed);
  std::vector<std::vector<float>> inputs(1);
  std::vector<glm::vec4> expected[3];
  for (int k = 0; k < kCells; ++k)
  {
    const glm::ivec2 cell(
      random() % static_cast<unsigned>(size.x - 1), random() % static_cast<unsigned>(size.y - 1));
    const auto level = static_cast<int>(random() % static_cast<unsigned>(slots.PyramidTop() + 1));
    const float part = static_cast<float>(random() % 4096u) / 1024.0f - 2.0f;
    inputs[0].insert(inputs[0].end(),
      { static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(level), part });
    int finest = level;
    const int slot = slots.FinestSlot(cell, finest);
    const glm::vec2 bounds =
      finest > 0 ? slots.SlotBounds(cell >> finest, finest, slot) : glm::vec2(0.0f);
    const bool empty = bounds.x < bounds.y;
    expected[0].emplace_back(slots.TileSlot(cell >> level, level), finest, empty ? 0.0f : bounds.x,
      empty ? 0.0f : bounds.y);
    expected[1].push_back(slots.TileCellCodes(cell));
    expected[2].emplace_back(
      slots.TileHeight(cell, { part, 0.5f * part }, std::min(level, slots.Top()), size),
      glm::vec3(0.0f));
  }
  const std::string bodies[3] = {
    "ivec2 cell = ivec2(input0.xy); int level = int(input0.z); int finest = level;"
    "int slot = terrainFinestSlot(cell, finest);"
    "vec2 bounds = finest > 0 ? terrainSlotBounds(cell >> finest, finest, slot) : vec2(0.0);"
    "result = vec4(terrainTileSlot(cell >> level, level), finest,"
    "bounds.x < bounds.y ? vec2(0.0) : bounds);",
    "result = terrainTileCellCodes(ivec2(input0.xy));",
    "result.x = terrainTileHeight(ivec2(input0.xy), vec2(input0.w, 0.5 * input0.w),"
    "min(int(input0.z), terrainTileTop), terrainSize);"
  };
  for (int part = 0; part < 3; ++part)
  {
    SCOPED_TRACE(part);
    const std::vector<float> values = vtkTerrainTesting::RunShader(window, arrays.Declarations(),
      bodies[part], inputs, [&](vtkShaderProgram* program) { arrays.SetUniforms(program); });
    ASSERT_EQ(values.size(), 4 * expected[part].size());
    int different = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      const float number = expected[part][k / 4][static_cast<int>(k % 4)];
      different += std::abs(values[k] - number) <= 1e-6f * std::max(1.0f, std::abs(number)) ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
  }
}
}

//------------------------------------------------------------------------------
TEST(TerrainShaderTwinsTiles, TakeTheSamePath)
{
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(16, 16);
  scene.Window->Render();
  unsigned seed = 0;
  int hits = 0;
  int advanced = 0;
  for (const TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    ++seed;
    const bool integer = seed / 3 % 2 == 1;
    TiledField field(vtkTerrainTesting::MakeTiles(test, integer));
    if (field.Slots.Top() < 1)
    {
      continue;
    }
    vtkTerrainTesting::ShowSome(field, seed);
    const TileArrays arrays(scene.Window, field);
    hits += CompareTraces(scene.Window, field, arrays, seed, false);
    hits += CompareTraces(scene.Window, field, arrays, seed, true);
    advanced += CompareBeams(scene.Window, field, arrays, seed);
    CompareReads(scene.Window, field, arrays, seed);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(advanced, 1000);
}
