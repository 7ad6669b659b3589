// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What shaders make of pixels and of points of the surface: functions of
// shaders/vtkTerrainView.glsl, vtkTerrainGradient.glsl, vtkTerrainSurface.glsl and
// vtkTerrainLight.glsl against their twins in src/core/rays/PixelRays.h and SurfaceShading.h.
#include "vtkTerrainTestPoints.h"

#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using terrain::ShadedPoint;
using vtkTerrainTesting::kRounding;
using vtkTerrainTesting::MagnitudesAt;
using vtkTerrainTesting::Points;
using vtkTerrainTesting::RaysOf;
using vtkTerrainTesting::ReadShader;
using vtkTerrainTesting::SetRays;
using TerrainShaderTwinsShading = vtkTerrainTesting::PointTwins;

// At an offset of half a million cells as well: there float alone would be off by 0.03 cells.
TEST_P(TerrainShaderTwinsShading, RaysOfPixels)
{
  for (const double offset : { 0.0, 500000.0 })
  {
    SCOPED_TRACE(offset);
    const terrain::PixelRays rays = RaysOf(GetParam(), offset);
    const Points points(rays);
    const auto ray = [&](std::size_t k)
    {
      return terrain::PixelRay(
        rays, points.Pixels[k], points.Distances[k], points.Distances[k] + 100.0);
    };
    const std::string trace =
      "TerrainRay ray = terrainPixelRay(pixel, input0.z, input0.z + 100.0);";
    // Anchors are whole cells, but a position at the line between two may go to either.
    this->Compare(points, rays,
      trace + "result = vec4(vec2(ray.anchorCell - ivec2(" + std::to_string(int(offset)) +
        ")) + ray.originGC.xy, ray.originGC.z + ray.originLow, ray.sEnd - ray.sBegin);",
      2e-6f,
      [&](std::size_t k)
      {
        const terrain::TerrainRay expected = ray(k);
        return glm::vec4(
          glm::vec2(expected.anchorCell - static_cast<int>(offset)) + glm::vec2(expected.originGC),
          expected.originGC.z + expected.originLow, expected.sEnd - expected.sBegin);
      });
    this->Compare(points, rays, trace + "result = vec4(ray.directionGC, ray.originGC.x < 1.0);",
      2e-6f, [&](std::size_t k) { return glm::vec4(ray(k).directionGC, 1.0f); });
    // What float cuts off the height is kept, where shaders have double precision.
    const std::vector<float> heights = this->Run(points, rays,
      trace +
        "result.xy = vec2(ray.originGC.z, ray.originLow);\n"
        "#ifdef GL_ARB_gpu_shader_fp64\nresult.z = 1.0;\n#endif\n");
    ASSERT_EQ(heights.size(), 4 * points.Items.size());
    int different = 0;
    for (std::size_t k = 0; k < points.Items.size(); ++k)
    {
      const terrain::TerrainRay expected = ray(k);
      const double height = static_cast<double>(expected.originGC.z) + expected.originLow;
      const double drawn = static_cast<double>(heights[4 * k]) + heights[4 * k + 1];
      const double room = heights[4 * k + 2] == 1.0f ? 1e-9 : 1e-6;
      different += std::abs(drawn - height) <= room * std::max(1.0, std::abs(height)) ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
  }
}

TEST_P(TerrainShaderTwinsShading, DepthsAndNormals)
{
  const terrain::PixelRays rays = RaysOf(GetParam(), 0.0);
  const Points points(rays);
  this->CompareWithin(
    points, rays, "result = terrainPositionVC(pixel, input0.z);",
    [&](std::size_t k) { return points.Items[k].PositionVC; },
    [&](std::size_t k, const glm::vec4&)
    {
      // of the products that are added up
      const glm::dvec3 position = MagnitudesAt(rays.OriginVC, points.Pixels[k]) +
        static_cast<double>(points.Distances[k]) * MagnitudesAt(rays.DirectionVC, points.Pixels[k]);
      return kRounding * glm::vec4(glm::vec3(position), 1.0f);
    });
  this->Compare(points, rays, "result.xyz = terrainPositionGC(pixel, input0.z);", 2e-6f,
    [&](std::size_t k)
    {
      const glm::dvec2 pixel(points.Pixels[k]);
      return glm::vec4(
        glm::vec3(terrain::AtPixel(rays.OriginGC, pixel) +
          static_cast<double>(points.Distances[k]) * terrain::AtPixel(rays.DirectionGC, pixel)),
        0.0f);
    });
  // The slope of depths counts a hundred times, so that float shows it to 1e-4 of itself.
  this->Compare(points, rays,
    "result = vec4(terrainDepth(point.positionVC), terrainDepth(vec4(0.0, 0.0, -0.5, 1.0)),"
    "terrainShiftedDepth(pixel, point, 100.0, 65.0), terrainPixelCells(input0.z));",
    1e-3f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      return glm::vec4(terrain::Depth(rays, point.PositionVC),
        terrain::Depth(rays, { 0.0, 0.0, -0.5, 1.0 }),
        terrain::ShiftedDepth(rays, points.Pixels[k], point, 100.0, 65.0),
        terrain::PixelCells(rays, points.Distances[k]));
    });
  // VTK's unit of offsets is 1/65000 of the range of depths (vtkOpenGLPolyDataMapper).
  this->Compare(points, rays, "result.x = terrainShiftedDepth(pixel, point, 0.0, 6500.0);", 1e-4f,
    [&](std::size_t k)
    { return glm::vec4(terrain::Depth(rays, points.Items[k].PositionVC) + 0.1, 0.0, 0.0, 0.0); });
  this->Compare(points, rays, "result.xyz = terrainNormalVC(point.gradient);", 2e-6f,
    [&](std::size_t k)
    { return glm::vec4(terrain::NormalVC(rays, points.Items[k].Gradient), 0.0f); });
  const glm::vec3 face = glm::normalize(glm::vec3(0.2f, 0.3f, 0.9f));
  this->Compare(points, rays,
    "vec3 normal = normalize(vec3(input1.zw - 0.5, input0.w - 5.0));"
    "result.xyz = terrainFacingNormal(normal, normalize(vec3(0.2, 0.3, 0.9)),"
    "-normalize(terrainDirectionAt(pixel)));",
    1e-5f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      const glm::vec3 normal = glm::normalize(glm::vec3(point.Fraction - 0.5f, point.Code - 5.0f));
      const glm::vec3 towards(
        -glm::normalize(terrain::AtPixel(rays.DirectionVC, points.Pixels[k])));
      return glm::vec4(terrain::FacingNormal(normal, face, towards), 0.0f);
    });
}

/// A program that casts rays to lights.
std::string LightDeclarations()
{
  terrain::Features features;
  features.Way = terrain::Features::Ways::Pyramid;
  features.Gathers = terrain::Driver().Gathers;
  features.ClipPlanes = 3;
  features.ShadowMask = 1;
  std::string text = features.Defines() + terrain::Features::Constants();
  for (const char* name : { "Heights", "Ray", "Pyramid", "Trace", "View", "Sighting", "Cast",
         "Gradient", "Surface", "Outlook", "Light" })
  {
    text += ReadShader(std::string("vtkTerrain") + name);
  }
  return text;
}

// Discs that a horizon cuts, passes below and above; planes that end the way to a light, and not.
TEST_P(TerrainShaderTwinsShading, SharesAndEndsOfLight)
{
  const terrain::PixelRays rays = RaysOf(GetParam(), 0.0);
  const Points points(rays);
  const std::vector<glm::vec4> planes{ { 1.0f, 0.0f, 0.0f, 5.0f }, { 0.0f, -0.6f, -0.8f, 50.0f },
    { 0.3f, 0.0f, -1.0f, 70.0f } };
  std::vector<glm::vec4> expected;
  int cut = 0;
  int ended = 0;
  for (const ShadedPoint& point : points.Items)
  {
    const glm::dvec4 disc(0.2 * point.Fraction.x, 0.05 * point.Fraction.y, 1.7, 1.0);
    const double share = terrain::DiscShare(disc, 0.1 * point.Gradient.x + 0.05);
    const double end = terrain::PlaneEnd(
      planes, glm::dvec3(point.PositionVC), glm::dvec3(glm::dvec2(point.Gradient), 0.3), 30.0);
    cut += share > 0.01 && share < 0.99 ? 1 : 0;
    ended += end > 0.1 && end < 30.0 ? 1 : 0;
    expected.emplace_back(share, end, 0.0, 0.0);
  }
  EXPECT_GT(cut, 50);
  EXPECT_GT(ended, 50);
  const std::vector<float> results = vtkTerrainTesting::RunShader(this->Canvas.Window,
    LightDeclarations(),
    "vec4 disc = vec4(0.2 * input1.z, 0.05 * input1.w, 1.7, 1.0);"
    "result.x = terrainDiscShare(disc, 0.1 * input2.x + 0.05);"
    "result.y = terrainPlaneEnd(terrainPositionVC(input0.xy, input0.z).xyz,"
    "vec3(input2.xy, 0.3), 30.0);",
    points.Inputs,
    [&](vtkShaderProgram* program)
    {
      SetRays(program, rays);
      program->SetUniformi("terrainClipPlaneCount", static_cast<int>(planes.size()));
      program->SetUniform4fv("terrainClipPlanesVC", static_cast<int>(planes.size()), &planes[0][0]);
    });
  ASSERT_EQ(results.size(), 4 * expected.size());
  int different = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    // A disc of any size: what an angle in float is off by, over the radius.
    const float room = 1e-4f + 1e-6f / (0.05f * points.Items[k].Fraction.y + 1e-6f);
    different += std::abs(results[4 * k] - expected[k].x) <= room ? 0 : 1;
    different += std::abs(results[4 * k + 1] - expected[k].y) <= 2e-3f ? 0 : 1;
  }
  EXPECT_EQ(different, 0);
}

INSTANTIATE_TEST_SUITE_P(Projections, TerrainShaderTwinsShading, testing::Bool(),
  [](const auto& projection) { return projection.param ? "Parallel" : "Perspective"; });
}
