// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays traced by a shader and by its twin in src/core/: node for node where the driver calculates
 * as C++ does, else hit for hit.
 */
#ifndef vtkTerrainTestTwins_h
#define vtkTerrainTestTwins_h

#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestRays.h"
#include "core/rays/PyramidBeam.h"

#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
constexpr int NumberOfRays = 1000;

/// Random beams as the inputs of a shader.
struct Beams
{
  std::vector<terrain::TerrainBeam> Items;
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(5);

  Beams(glm::ivec2 size, double maximumCode, unsigned seed, bool alongEdges = true)
  {
    terrain::RayMaker maker(size, maximumCode, seed, alongEdges);
    for (int k = 0; k < NumberOfRays; ++k)
    {
      terrain::TerrainBeam beam;
      beam.ray = maker.Make();
      const double width = std::pow(10.0, maker.Uniform(-3.0, 0.0));
      beam.radius = glm::vec3(maker.Uniform(0.0, width), maker.Uniform(0.0, width), 0.0);
      beam.growth = glm::vec3(maker.Uniform(0.0, width), maker.Uniform(0.0, width), width);
      this->Items.push_back(beam);
      const terrain::TerrainRay& ray = beam.ray;
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

/// GLSL: the ray in the first three inputs.
inline std::string InputRay()
{
  return "TerrainRay inputRay(vec4 a, vec4 b, vec4 c)\n"
         "{ return TerrainRay(ivec2(a.xy), b.xyz, c.xyz, a.z, a.w, b.w); }\n";
}

/// GLSL: a number that tells which nodes were visited, and in which order.
inline std::string CountVisits()
{
  return "uint terrainVisits = 0u;\n"
         "#define TERRAIN_VISIT(node, level) terrainVisits = terrainVisits * 31u + "
         "uint((node).x * 7 + (node).y * 13 + level);\n";
}

/// The same in C++.
inline void AddVisit(std::uint32_t& visits, glm::ivec2 node, int level)
{
  visits = visits * 31u + static_cast<std::uint32_t>(node.x * 7 + node.y * 13 + level);
}

/// Runs a shader over beams: a result for each.
inline std::vector<glm::vec4> RunBeams(vtkRenderWindow* window, const std::string& head,
  const std::string& body, const Beams& beams,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const std::vector<float> values = RunShader(window, head, body, beams.Inputs, setUniforms);
  std::vector<glm::vec4> result;
  result.reserve(values.size() / 4);
  for (std::size_t k = 0; k + 3 < values.size(); k += 4)
  {
    result.emplace_back(values[k], values[k + 1], values[k + 2], values[k + 3]);
  }
  return result;
}

/// Mesa's software rasterizer up to LLVM 15 calculates as C++ does, bit for bit; later ones and
/// other drivers fuse and reorder.
inline bool CalculatesAsTwin(vtkRenderWindow* window)
{
  const std::string words = window->ReportCapabilities();
  const std::string name = "llvmpipe (LLVM ";
  const std::size_t at = words.find(name);
  return at != std::string::npos && std::atoi(words.c_str() + at + name.size()) <= 15;
}

/// How far rays are moved to look for what they nearly meet: in cells, and as a part of the largest
/// code. More than what any driver rounds.
constexpr float kNudgeCells = 1e-4f;
constexpr float kNudgeCodes = 1e-5f;

/// True if a hit is the twin's for the ray or for one that is moved by a nudge: no other outcome is
/// a matter of rounding. Of rays that graze the surface or pass a silhouette the distances may lie
/// anywhere between those of rays nearby.
inline bool IsOfARayNearby(const terrain::TerrainHit& drawn, const terrain::TerrainRay& ray,
  float maximumCode, const std::function<terrain::TerrainHit(const terrain::TerrainRay&)>& trace)
{
  constexpr int kDirections = 27; // each coordinate less, the same, more
  bool agrees = false;
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = -nearest;
  for (int k = 0; k < kDirections; ++k)
  {
    const glm::vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    terrain::TerrainRay moved = ray;
    moved.originGC +=
      way * glm::vec3(kNudgeCells, kNudgeCells, kNudgeCodes * (maximumCode + 1e-3f));
    const terrain::TerrainHit hit = trace(moved);
    agrees = agrees || hit.found == drawn.found;
    nearest = hit.found ? std::min(nearest, hit.s) : nearest;
    farthest = hit.found ? std::max(farthest, hit.s) : farthest;
  }
  const float room = 1e-4f * std::max(1.0f, std::abs(drawn.s));
  return agrees && (!drawn.found || (drawn.s >= nearest - room && drawn.s <= farthest + room));
}

/// What is traced, on both sides.
struct Paths
{
  std::string Declarations;
  std::string Trace; ///< GLSL: a TerrainHit of the inputs
  float MaximumCode = 0.0f;
  std::function<void(vtkShaderProgram*)> SetUniforms;
  std::function<terrain::TerrainHit(const terrain::TerrainRay&, std::uint32_t&)> Twin;
};

/// Traces the rays of beams by both and expects the same: the nodes visited, their order, distance
/// and place where the driver calculates as the twin, else hits of the ray or of one nearby.
/// Returns the number of hits.
inline int ExpectSamePaths(vtkRenderWindow* window, const Paths& traced, const Beams& beams)
{
  const std::string trace = "TerrainHit hit = " + traced.Trace + ";";
  const auto paths = RunBeams(window, traced.Declarations,
    trace + "result = vec4(hit.found, hit.s, hit.crossings, terrainVisits & 0xffffffu);", beams,
    traced.SetUniforms);
  const auto places = RunBeams(window, traced.Declarations,
    trace + "result = vec4(hit.cell, hit.fraction);", beams, traced.SetUniforms);
  EXPECT_EQ(paths.size(), beams.Items.size());
  EXPECT_EQ(places.size(), beams.Items.size());
  int hits = 0;
  int otherPaths = 0;
  int wrong = 0;
  int differentPlaces = 0;
  for (std::size_t k = 0; k < std::min(paths.size(), places.size()); ++k)
  {
    const terrain::TerrainRay& ray = beams.Items[k].ray;
    std::uint32_t visits = 0;
    const terrain::TerrainHit hit = traced.Twin(ray, visits);
    hits += hit.found;
    const float s = hit.found ? hit.s : paths[k].y; // of no hit it means nothing
    const glm::vec4 path(hit.found, s, hit.crossings, visits & 0xffffffu);
    const glm::vec4 place(hit.cell, hit.fraction);
    if (paths[k] == path && (!hit.found || places[k] == place))
    {
      continue;
    }
    ++otherPaths;
    terrain::TerrainHit drawn;
    drawn.found = paths[k].x != 0.0f;
    drawn.s = paths[k].y;
    wrong += !IsOfARayNearby(drawn, ray, traced.MaximumCode,
      [&](const terrain::TerrainRay& moved)
      {
        std::uint32_t ignored = 0;
        return traced.Twin(moved, ignored);
      });
    // The place is that of the distance, wherever it is.
    const glm::dvec2 expected = glm::dvec2(ray.anchorCell) + glm::dvec2(ray.originGC) +
      static_cast<double>(drawn.s) * glm::dvec2(ray.directionGC);
    const glm::dvec2 there = glm::dvec2(places[k]) + glm::dvec2(places[k].z, places[k].w);
    differentPlaces += drawn.found &&
      glm::distance(there, expected) > 1e-3 + 1e-5 * glm::length(glm::dvec2(ray.directionGC));
  }
  EXPECT_LE(otherPaths, CalculatesAsTwin(window) ? 0 : NumberOfRays);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(differentPlaces, 0);
  return hits;
}

/// The rays along the edges of a beam, through the middles of its sides, and its middle.
inline std::vector<terrain::TerrainRay> RaysWithin(const terrain::TerrainBeam& beam)
{
  constexpr int kDirections = 27; // each coordinate least, in the middle, greatest
  std::vector<terrain::TerrainRay> rays(kDirections, beam.ray);
  for (int k = 0; k < kDirections; ++k)
  {
    const glm::vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    rays[static_cast<std::size_t>(k)].originGC += way * beam.radius;
    rays[static_cast<std::size_t>(k)].directionGC += way * beam.growth;
  }
  return rays;
}

/// Finds the starts of beams by a shader and by a PyramidBeam. Where the driver calculates as the
/// twin they are the same to the bit. Elsewhere no ray of a beam meets the surface before the start
/// that was drawn, by brute force: first() gives that distance. Returns how many beams get on by
/// more than a cell.
template <typename Finder>
int ExpectSameStarts(vtkRenderWindow* window, const std::string& declarations, const Beams& beams,
  const Finder& finder, const std::function<double(const terrain::TerrainRay&)>& first,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const auto starts = RunBeams(window, declarations,
    "result = vec4(terrainBeamStart(TerrainBeam(inputRay(input0, input1, input2), input3.xyz,"
    "input4.xyz)));",
    beams, setUniforms);
  EXPECT_EQ(starts.size(), beams.Items.size());
  const bool exact = CalculatesAsTwin(window);
  int advanced = 0;
  int advancedTwin = 0;
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    const terrain::TerrainBeam& beam = beams.Items[k];
    const float drawn = starts[k].x;
    int steps = 0;
    const float twin = finder.BeamStart(beam, steps);
    EXPECT_TRUE(!exact || drawn == twin) << k << ": " << drawn << " for " << twin;
    for (const terrain::TerrainRay& ray : RaysWithin(beam))
    {
      EXPECT_TRUE(drawn == twin || first(ray) >= static_cast<double>(drawn))
        << k << ": " << drawn << " for " << twin << ", a ray meets at " << first(ray);
    }
    const float cells = glm::length(glm::vec2(beam.ray.directionGC));
    advanced += (drawn - beam.ray.sBegin) * cells > 1.0f ? 1 : 0;
    advancedTwin += (twin - beam.ray.sBegin) * cells > 1.0f ? 1 : 0;
  }
  EXPECT_NEAR(advanced, advancedTwin, exact ? 0 : 0.02 * static_cast<double>(starts.size()));
  return advanced;
}
}

#endif
