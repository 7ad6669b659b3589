// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of points of the surface, the pictures, shades and lines over them, and their numbers in
// selections: functions of shaders/vtkTerrainColor.glsl and vtkTerrainSurface.glsl against their
// twins in src/core/rays/SurfaceColors.h and SurfaceShading.h.
#include "vtkTerrainTestPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace
{
using terrain::ShadedPoint;
using vtkTerrainTesting::kColors;
using vtkTerrainTesting::kSize;
using vtkTerrainTesting::Points;
using vtkTerrainTesting::RaysOf;
using TerrainShaderTwinsColors = vtkTerrainTesting::PointTwins;

TEST_P(TerrainShaderTwinsColors, FootprintsAndContours)
{
  const terrain::PixelRays rays = RaysOf(GetParam(), 0.0);
  const Points points(rays);
  this->Compare(points, rays,
    "mat2 footprint = terrainFootprint(pixel, point);"
    "result = vec4(footprint[0], footprint[1]);",
    1e-3f,
    [&](std::size_t k)
    {
      const glm::dmat2 footprint = terrain::Footprint(rays, points.Pixels[k], points.Items[k]);
      return glm::vec4(footprint[0], footprint[1]);
    });
  this->Compare(points, rays,
    "mat2 footprint = terrainTextureFootprint(pixel, point);"
    "result = vec4(footprint[0].x, footprint[1].y, terrainTexturePosition(point));",
    1e-3f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      const glm::dmat2 footprint = terrain::TextureFootprint(rays, points.Pixels[k], point, kSize);
      return glm::vec4(footprint[0].x, footprint[1].y, terrain::TexturePosition(point, kSize));
    });
  this->Compare(points, rays,
    "result.xy = vec2(terrainContourCoverage(pixel, point), terrainHillshade(point));", 1e-3f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      return glm::vec4(this->Colors.ContourCoverage(rays, points.Pixels[k], point),
        this->Colors.Hillshade(point), 0.0f, 0.0f);
    });
  this->Compare(points, rays, "result = terrainDrapeColor(pixel, point);", 1e-3f,
    [&](std::size_t k)
    { return this->Colors.DrapeColor(rays, points.Pixels[k], points.Items[k]); });
}

TEST_P(TerrainShaderTwinsColors, Numbers)
{
  const terrain::PixelRays rays = RaysOf(GetParam(), 0.0);
  const Points points(rays);
  this->Compare(points, rays,
    "result = vec4(terrainSlope(point), max(terrainAspect(point), -1.0),"
    "terrainCellId(point), terrainSampleId(point));",
    1e-4f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      return glm::vec4(this->Colors.Slope(point), std::max(this->Colors.Aspect(point), -1.0f),
        terrain::CellId(point, kSize), terrain::SampleId(point, kSize));
    });
  this->Compare(points, rays,
    "result = terrainIdColor(int(point.code + 3.0) * 70001 + point.crossings);", 1e-6f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      return terrain::IdColor(static_cast<int>(point.Code + 3.0f) * 70001 + point.Crossings);
    });
  this->Compare(points, rays,
    "for (int corner = 0; corner < 4; ++corner)"
    "{ result[corner] = terrainCornerWeight(ivec2(corner & 1, corner >> 1), point.fraction); }",
    1e-6f,
    [&](std::size_t k)
    {
      glm::vec4 weights;
      for (int corner = 0; corner < 4; ++corner)
      {
        weights[corner] =
          terrain::CornerWeight({ corner & 1, corner >> 1 }, points.Items[k].Fraction);
      }
      return weights;
    });
  this->Compare(points, rays,
    "vec4 color; float value = max(terrainArrayValue(point, color), -1e3);"
    "result = vec4(value, color.rga);",
    1e-5f,
    [&](std::size_t k)
    {
      glm::vec4 color;
      const float value = std::max(this->Colors.ArrayValue(points.Items[k], color), -1e3f);
      return glm::vec4(value, color.r, color.g, color.a);
    });
}

// Of every kind, and through a map of logarithms; below and above the map, and of no number.
TEST_P(TerrainShaderTwinsColors, ColorsOfAllKinds)
{
  const terrain::PixelRays rays = RaysOf(GetParam(), 0.0);
  const Points points(rays);
  std::array<int, 3> special{};
  for (int variant = 0; variant <= 7; ++variant)
  {
    SCOPED_TRACE(variant);
    this->Colors.ColorLogarithm = variant == 7;
    const bool angles = variant == static_cast<int>(terrain::PaintKinds::Slope) ||
      variant == static_cast<int>(terrain::PaintKinds::Aspect);
    this->Colors.Kind = static_cast<terrain::PaintKinds>(variant % 7);
    this->Colors.Kind = variant == 7 ? terrain::PaintKinds::Height : this->Colors.Kind;
    this->Colors.ColorScale = angles ? glm::vec2(0.005f, -0.1f) : glm::vec2(0.1f, -0.2f);
    this->Compare(points, rays, "result.x = terrainShownValue(point);", 1e-4f,
      [&](std::size_t k)
      { return glm::vec4(this->Colors.ShownValue(points.Items[k]), 0.0f, 0.0f, 0.0f); });
    this->Compare(points, rays, "result = terrainOwnColor(point);",
      1.5f / kColors, // one texel beside, where the number is at a border
      [&](std::size_t k)
      {
        const glm::vec4 color = this->Colors.OwnColor(points.Items[k]);
        for (int kind = 0; kind < 3; ++kind)
        {
          special[static_cast<std::size_t>(kind)] += color.r == -1.0f - kind ? 1 : 0;
        }
        return color;
      });
    this->Compare(points, rays,
      "TerrainPaint paint = terrainPaintSurface(pixel, point);"
      "result = vec4(paint.add.rg, paint.keep, paint.alpha);",
      2e-3f,
      [&](std::size_t k)
      {
        const terrain::SurfacePaint paint =
          this->Colors.PaintSurface(rays, points.Pixels[k], points.Items[k]);
        return glm::vec4(paint.Add.r, paint.Add.g, paint.Keep, paint.Alpha);
      });
    this->Compare(points, rays,
      "vec3 ambient = vec3(0.3, 0.5, 0.7); vec3 diffuse = vec3(0.9, 0.6, 0.2); float opacity = 0.8;"
      "terrainPaintMaterial(pixel, point, 0.4, 0.7, ambient, diffuse, opacity);"
      "result = vec4(ambient.r, diffuse.gb, opacity);",
      2e-3f,
      [&](std::size_t k)
      {
        glm::vec3 ambient(0.3f, 0.5f, 0.7f);
        glm::vec3 diffuse(0.9f, 0.6f, 0.2f);
        float opacity = 0.8f;
        this->Colors.PaintMaterial(
          rays, points.Pixels[k], points.Items[k], { 0.4f, 0.7f }, ambient, diffuse, opacity);
        return glm::vec4(ambient.r, diffuse.g, diffuse.b, opacity);
      });
  }
  for (const int count : special)
  {
    EXPECT_GT(count, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, TerrainShaderTwinsColors, testing::Bool(),
  [](const auto& projection) { return projection.param ? "Parallel" : "Perspective"; });
}
