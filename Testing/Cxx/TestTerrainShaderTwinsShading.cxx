// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What shaders make of pixels and of points of the surface: functions of
// shaders/vtkTerrainView.glsl, vtkTerrainGradient.glsl, vtkTerrainSurface.glsl and
// vtkTerrainColor.glsl against their twins in src/core/rays/PixelRays.h and SurfaceShading.h.
#include "vtkTerrainTesting.h"

#include "core/rays/SurfaceShading.h"
#include "render/Driver.h"
#include "render/Features.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::ShadedPoint;
using vtkTerrainTesting::ReadShader;

constexpr int kPixels = 2000;
const glm::ivec2 kSize(41, 33);
const glm::vec2 kGradientScale(2.0f, 2.4f);
const glm::vec3 kSun = glm::normalize(glm::vec3(-0.5f, 0.6f, 0.7f));
constexpr float kRelief = 1.5f;
constexpr float kStrength = 0.8f;
const glm::vec2 kContours(0.25f, 0.3f);
constexpr float kContourWidth = 1.5f;
constexpr float kMostCrossings = 40.0f;
const glm::vec2 kColorScale(0.1f, -0.2f);

/// A program that casts nothing, of all functions that work on points.
std::string declarations()
{
  terrain::Features features;
  features.Way = terrain::Features::Ways::Mesh;
  features.Gathers = terrain::Driver().Gathers;
  features.Paints = true;
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") + ReadShader("vtkTerrainGradient") +
    ReadShader("vtkTerrainSurface") + ReadShader("vtkTerrainColor") +
    "TerrainSurface inputPoint(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainSurface(true, terrainPositionVC(a.xy, a.z), vec3(0.0), true, false, "
    "ivec2(b.xy),"
    " b.zw, a.w, c.xy, int(c.z)); }\n";
}

/// Rays of a view of 200 x 100 pixels onto a grid that lies at an offset in cells.
terrain::PixelRays raysOf(bool parallel, double offset)
{
  const glm::dvec3 at(offset, offset, 0.0);
  const glm::dmat4 view = glm::lookAt(glm::dvec3(30.0, -50.0, 80.0) + at,
    glm::dvec3(20.0, 15.0, 5.0) + at, glm::dvec3(0.0, 0.0, 1.0));
  const glm::dmat4 projection = parallel ? glm::ortho(-40.0, 40.0, -20.0, 20.0, 1.0, 300.0)
                                         : glm::perspective(0.6, 2.0, 1.0, 300.0);
  return terrain::MakePixelRays(view, projection, glm::dvec4(0.0, 0.0, 200.0, 100.0));
}

/// Sets a vector that depends on the pixel, and what float cuts off where that is asked for.
void setVector(
  vtkShaderProgram* program, const std::string& name, const terrain::PixelVector& vector, bool low)
{
  const glm::dmat3 exact(vector[0], vector[1], vector[2]);
  glm::mat3 leading(exact);
  program->SetUniformMatrix3x3((name + "GC").c_str(), &leading[0][0]);
  if (low)
  {
    glm::mat3 rest(exact - glm::dmat3(leading));
    program->SetUniformMatrix3x3((name + "LowGC").c_str(), &rest[0][0]);
  }
}

void setMatrix(vtkShaderProgram* program, const char* name, const glm::dmat3& exact)
{
  glm::mat3 matrix(exact);
  program->SetUniformMatrix3x3(name, &matrix[0][0]);
}

void setRays(vtkShaderProgram* program, const terrain::PixelRays& rays)
{
  setVector(program, "terrainOrigin", rays.OriginGC, true);
  setVector(program, "terrainDirection", rays.DirectionGC, true);
  const auto matrix = [](const terrain::PixelVector& vector)
  { return glm::dmat3(vector[0], vector[1], vector[2]); };
  setMatrix(program, "terrainOriginVC", matrix(rays.OriginVC));
  setMatrix(program, "terrainDirectionVC", matrix(rays.DirectionVC));
  setMatrix(program, "terrainNormalMatrix", rays.NormalMatrix);
  const glm::vec4 depth(rays.DepthRow);
  const glm::vec4 weight(rays.WeightRow);
  program->SetUniform4f("terrainDepthRow", &depth[0]);
  program->SetUniform4f("terrainWeightRow", &weight[0]);
}

/// Points as the inputs of a shader, with what depends on no view.
struct Points
{
  std::vector<std::vector<float>> Inputs = std::vector<std::vector<float>>(3);
  std::vector<glm::vec2> Pixels;
  std::vector<float> Distances;
  std::vector<ShadedPoint> Items;
  std::vector<int> Crossings;

  explicit Points(const terrain::PixelRays& rays)
  {
    std::mt19937 generator(11);
    const auto number = [&](double low, double high)
    { return static_cast<float>(std::uniform_real_distribution<double>(low, high)(generator)); };
    for (int k = 0; k < kPixels; ++k)
    {
      ShadedPoint point;
      const glm::vec2 pixel(number(0.0, 200.0), number(0.0, 100.0));
      const float distance = number(2.0, 290.0);
      point.PositionVC = terrain::PositionVC(rays, pixel, distance);
      point.Cell = { static_cast<int>(number(0.0, kSize.x - 1.001)),
        static_cast<int>(number(0.0, kSize.y - 1.001)) };
      // every tenth at a border of its cell, every other tenth on level ground
      point.Fraction =
        k % 10 == 0 ? glm::vec2(k % 20 == 0, 1.0f) : glm::vec2(number(0.0, 1.0), number(0.0, 1.0));
      point.Code = number(-3.0, 14.0);
      // level, away from the viewer, and any that rays do not graze: there depths jump
      point.Gradient = glm::vec2(number(-0.5, 0.5), number(-0.5, 0.5));
      point.Gradient = k % 10 == 1 ? glm::vec2(0.0f) : point.Gradient;
      point.Gradient = k % 10 == 2 ? glm::vec2(0.0f, -4.0f) : point.Gradient;
      const int crossings = static_cast<int>(number(0.0, 60.0));
      this->Pixels.push_back(pixel);
      this->Distances.push_back(distance);
      this->Items.push_back(point);
      this->Crossings.push_back(crossings);
      this->Add(0, { pixel, distance, point.Code });
      this->Add(1, { glm::vec2(point.Cell), point.Fraction });
      this->Add(2, { point.Gradient, static_cast<float>(crossings), 0.0f });
    }
  }

private:
  void Add(std::size_t input, const glm::vec4& value)
  {
    this->Inputs[input].insert(this->Inputs[input].end(), { value.x, value.y, value.z, value.w });
  }
};

class TerrainShaderTwinsShading : public testing::TestWithParam<bool>
{
protected:
  void SetUp() override
  {
    this->Scene.Window->Render();
    this->Declarations = declarations();
  }

  /// Expects what a shader makes of each point; the tolerance is relative above 1.
  void Compare(const Points& points, const terrain::PixelRays& rays, const std::string& body,
    float tolerance, const std::function<glm::vec4(std::size_t)>& twin)
  {
    SCOPED_TRACE(body);
    const std::vector<float> results =
      vtkTerrainTesting::RunShader(this->Scene.Window, this->Declarations,
        "TerrainSurface point = inputPoint(input0, input1, input2); vec2 pixel = input0.xy;" + body,
        points.Inputs,
        [&](vtkShaderProgram* program)
        {
          setRays(program, rays);
          this->SetConstants(program);
        });
    ASSERT_EQ(results.size(), 4 * points.Items.size());
    int different = 0;
    for (std::size_t k = 0; k < points.Items.size(); ++k)
    {
      const glm::vec4 expected = twin(k);
      for (int c = 0; c < 4; ++c)
      {
        const float allowed = tolerance * std::max(std::abs(expected[c]), 1.0f);
        different +=
          std::abs(results[4 * k + static_cast<std::size_t>(c)] - expected[c]) <= allowed ? 0 : 1;
      }
    }
    EXPECT_EQ(different, 0);
  }

  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(16, 16);
  int ColorMapUnit = 0;

private:
  void SetConstants(vtkShaderProgram* program) const
  {
    program->SetUniform2i("terrainSize", &kSize[0]);
    program->SetUniform2f("terrainGradientScale", &kGradientScale[0]);
    program->SetUniform3f("terrainSunDirection", &kSun[0]);
    program->SetUniformf("terrainShadeRelief", kRelief);
    program->SetUniformf("terrainShadeStrength", kStrength);
    program->SetUniform2f("terrainContourScale", &kContours[0]);
    program->SetUniformf("terrainContourWidth", kContourWidth);
    program->SetUniformf("terrainMaximumShownCrossings", kMostCrossings);
    program->SetUniform2f("terrainColorScale", &kColorScale[0]);
    program->SetUniformi("terrainColorLogarithm", 0);
    program->SetUniformi("terrainColorMap", this->ColorMapUnit);
    const float specials[3][4] = { { -1.0f * terrain::kColorMapSize, 0.0f, 0.0f, 1.0f },
      { -2.0f * terrain::kColorMapSize, 0.0f, 0.0f, 1.0f },
      { -3.0f * terrain::kColorMapSize, 0.0f, 0.0f, 1.0f } };
    program->SetUniform4fv("terrainSpecialColors", 3, specials);
  }

  std::string Declarations;
};

// At an offset of half a million cells as well: there float alone would be off by 0.03 cells.
TEST_P(TerrainShaderTwinsShading, RaysOfPixels)
{
  for (const double offset : { 0.0, 500000.0 })
  {
    SCOPED_TRACE(offset);
    const terrain::PixelRays rays = raysOf(GetParam(), offset);
    const Points points(rays);
    const auto ray = [&](std::size_t k)
    {
      return terrain::MakePixelRay(
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
    // What float cuts off the height is kept.
    this->Compare(points, rays,
      trace + "result.x = abs(ray.originLow) <= 1e-6 * abs(ray.originGC.z) ? 1.0 : 0.0;", 0.0f,
      [](std::size_t) { return glm::vec4(1.0f, 0.0f, 0.0f, 0.0f); });
  }
}

TEST_P(TerrainShaderTwinsShading, DepthsAndNormals)
{
  const terrain::PixelRays rays = raysOf(GetParam(), 0.0);
  const Points points(rays);
  this->Compare(points, rays, "result = terrainPositionVC(pixel, input0.z);", 2e-6f,
    [&](std::size_t k) { return points.Items[k].PositionVC; });
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

TEST_P(TerrainShaderTwinsShading, FootprintsAndContours)
{
  const terrain::PixelRays rays = raysOf(GetParam(), 0.0);
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
    "result.xy = vec2(terrainContourCoverage(pixel, point), terrainHillshade(point));", 1e-3f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      return glm::vec4(
        terrain::ContourCoverage(rays, points.Pixels[k], point, kContours, kContourWidth),
        terrain::Hillshade(point, kGradientScale, kRelief, kSun, kStrength), 0.0f, 0.0f);
    });
}

TEST_P(TerrainShaderTwinsShading, NumbersAndColors)
{
  const terrain::PixelRays rays = raysOf(GetParam(), 0.0);
  const Points points(rays);
  // The map's texels say their own number.
  std::vector<float> texels;
  for (int texel = 0; texel < terrain::kColorMapSize; ++texel)
  {
    texels.insert(texels.end(), { static_cast<float>(texel), 0.0f, 0.0f, 1.0f });
  }
  vtkNew<vtkTextureObject> map;
  map->SetContext(vtkOpenGLRenderWindow::SafeDownCast(this->Scene.Window));
  map->SetMinificationFilter(vtkTextureObject::Nearest);
  map->SetMagnificationFilter(vtkTextureObject::Nearest);
  map->Create2DFromRaw(terrain::kColorMapSize, 1, 4, VTK_FLOAT, texels.data());
  map->Activate();
  this->ColorMapUnit = map->GetTextureUnit();

  this->Compare(points, rays,
    "result = vec4(terrainSlope(point), terrainAspect(point) < 0.0 ? -1.0 : terrainAspect(point),"
    "terrainCellId(point), terrainSampleId(point));",
    1e-4f,
    [&](std::size_t k)
    {
      const ShadedPoint& point = points.Items[k];
      const float aspect = terrain::Aspect(point, kGradientScale, terrain::kNotANumber);
      return glm::vec4(terrain::Slope(point, kGradientScale), std::max(aspect, -1.0f),
        terrain::CellId(point, kSize), terrain::SampleId(point, kSize));
    });
  // Above and below the map, and numbers that are none.
  const auto value = [&](std::size_t k)
  { return k % 7 == 0 ? terrain::kNotANumber : points.Items[k].Code; };
  this->Compare(points, rays,
    "int k = texel.x + 1024 * texel.y;"
    "result.x = terrainMapColor(k % 7 == 0 ? terrainNotANumber : point.code).r /"
    "float(terrainColorMapSize);",
    1.5f / terrain::kColorMapSize, // one texel beside, where the number is at a border
    [&](std::size_t k)
    {
      const int texel =
        terrain::MapTexel(value(k), kColorScale, terrain::kColorMapSize, terrain::kNotANumber);
      return glm::vec4(
        texel < 0 ? static_cast<float>(texel) : static_cast<float>(texel) / terrain::kColorMapSize,
        0.0f, 0.0f, 0.0f);
    });
  this->Compare(points, rays, "result = terrainCrossingsColor(point.crossings);", 1e-6f,
    [&](std::size_t k) { return terrain::CrossingsColor(points.Crossings[k], kMostCrossings); });
  this->Compare(points, rays,
    "result = terrainIdColor(int(point.code + 3.0) * 70001 + point.crossings);", 1e-6f,
    [&](std::size_t k)
    {
      return terrain::IdColor(
        static_cast<int>(points.Items[k].Code + 3.0f) * 70001 + points.Crossings[k]);
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
  map->Deactivate();
}

INSTANTIATE_TEST_SUITE_P(Projections, TerrainShaderTwinsShading, testing::Bool(),
  [](const auto& projection) { return projection.param ? "Parallel" : "Perspective"; });
}
