// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points of the surface, with what colours are made of, as the inputs and uniforms of shaders.
 */
#ifndef vtkTerrainTestPoints_h
#define vtkTerrainTestPoints_h

#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTesting.h"

#include "core/rays/PixelRays.h"
#include "core/rays/SurfaceColors.h"
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
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
using terrain::ShadedPoint;

constexpr int kPixels = 2000;
inline const glm::ivec2 kSize(41, 33);
constexpr int kColors = 4096; // texels of a map
// What a sum of two products of float is off by at most, over the sum of their magnitudes.
constexpr float kRounding = 4e-7f;

/// A program that casts nothing, of all functions that work on points.
inline std::string PointDeclarations()
{
  terrain::Features features;
  features.Way = terrain::Features::Ways::Mesh;
  features.Gathers = terrain::Driver().Gathers;
  features.Paints = true;
  features.Textured = true;
  features.DrapeComponents = 4;
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") + ReadShader("vtkTerrainGradient") +
    ReadShader("vtkTerrainSurface") + ReadShader("vtkTerrainColor") +
    "TerrainSurface inputPoint(vec4 a, vec4 b, vec4 c)\n"
    "{ return TerrainSurface(true, terrainPositionVC(a.xy, a.z), vec3(0.0), true, false, "
    "ivec2(b.xy),"
    " b.zw, a.w, c.xy, int(c.z)); }\n";
}

/// All that colours are made of, with holes in the values.
inline terrain::SurfaceColors MakeColors()
{
  terrain::SurfaceColors colors;
  colors.Size = kSize;
  for (int k = 0; k < kSize.x * kSize.y; ++k)
  {
    colors.Values.push_back(
      k % 11 == 0 ? terrain::kNotANumber : 0.25f * static_cast<float>(k % 41));
    colors.Colors.emplace_back(glm::vec4(k % 3, k % 5, k % 7, k % 9) / 8.0f);
  }
  for (int texel = 0; texel < kColors; ++texel)
  {
    const float part = static_cast<float>(texel) / kColors;
    colors.ColorMap.emplace_back(part, 1.0f - part, 0.5f * part, 1.0f - 0.5f * part);
  }
  colors.GradientScale = { 2.0f, 2.4f };
  colors.SpecialColors = { glm::vec4(-1.0f), glm::vec4(-2.0f), glm::vec4(-3.0f) };
  colors.ValueScale = { 10.0f, 35.0f };
  colors.ColorScale = { 0.1f, -0.2f };
  colors.MaximumShownCrossings = 40.0f;
  colors.Drape = { 0.3f, 0.1f, 0.2f, 0.7f };
  colors.DrapeScale = { 0.03, -0.02, -0.1, 0.6 };
  colors.SunDirection = glm::normalize(glm::vec3(-0.5f, 0.6f, 0.7f));
  colors.ShadeRelief = 1.5f;
  colors.ShadeStrength = 0.8f;
  colors.ContourScale = { 0.25, 0.3 };
  colors.ContourWidth = 1.5;
  colors.ContourIndex = 3.0;
  colors.ContourColor = { 0.9f, 0.8f, 0.1f, 0.6f };
  return colors;
}

/// From a grid that lies at an offset in cells to the view.
inline glm::dmat4 ViewOf(double offset = 0.0)
{
  const glm::dvec3 at(offset, offset, 0.0);
  return glm::lookAt(glm::dvec3(30.0, -50.0, 80.0) + at, glm::dvec3(20.0, 15.0, 5.0) + at,
    glm::dvec3(0.0, 0.0, 1.0));
}

/// Rays of a view of 200 x 100 pixels onto such a grid.
inline terrain::PixelRays RaysOf(bool parallel, double offset = 0.0)
{
  const glm::dmat4 view = ViewOf(offset);
  const glm::dmat4 projection = parallel ? glm::ortho(-40.0, 40.0, -20.0, 20.0, 1.0, 300.0)
                                         : glm::perspective(0.6, 2.0, 1.0, 300.0);
  return terrain::MakePixelRays(view, projection, glm::dvec4(0.0, 0.0, 200.0, 100.0));
}

/// The sum of the magnitudes that a vector of a pixel is the sum of.
inline glm::dvec3 MagnitudesAt(const terrain::PixelVector& vector, const glm::dvec2& pixel)
{
  return glm::abs(vector[0]) + pixel.x * glm::abs(vector[1]) + pixel.y * glm::abs(vector[2]);
}

/// Sets a vector that depends on the pixel, and what float cuts off.
inline void SetVector(
  vtkShaderProgram* program, const std::string& name, const terrain::PixelVector& vector)
{
  const glm::dmat3 exact(vector[0], vector[1], vector[2]);
  glm::mat3 leading(exact);
  program->SetUniformMatrix3x3((name + "GC").c_str(), &leading[0][0]);
  glm::mat3 rest(exact - glm::dmat3(leading));
  program->SetUniformMatrix3x3((name + "LowGC").c_str(), &rest[0][0]);
}

inline void SetMatrix3x3(vtkShaderProgram* program, const char* name, const glm::dmat3& exact)
{
  glm::mat3 matrix(exact);
  program->SetUniformMatrix3x3(name, &matrix[0][0]);
}

/// Sets the uniforms of the rays of pixels.
inline void SetRays(vtkShaderProgram* program, const terrain::PixelRays& rays)
{
  SetVector(program, "terrainOrigin", rays.OriginGC);
  SetVector(program, "terrainDirection", rays.DirectionGC);
  const auto matrix = [](const terrain::PixelVector& vector)
  { return glm::dmat3(vector[0], vector[1], vector[2]); };
  SetMatrix3x3(program, "terrainOriginVC", matrix(rays.OriginVC));
  SetMatrix3x3(program, "terrainDirectionVC", matrix(rays.DirectionVC));
  SetMatrix3x3(program, "terrainNormalMatrix", rays.NormalMatrix);
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
      point.Crossings = static_cast<int>(number(0.0, 60.0));
      this->Pixels.push_back(pixel);
      this->Distances.push_back(distance);
      this->Items.push_back(point);
      this->Add(0, { pixel, distance, point.Code });
      this->Add(1, { glm::vec2(point.Cell), point.Fraction });
      this->Add(2, { point.Gradient, static_cast<float>(point.Crossings), 0.0f });
    }
  }

private:
  void Add(std::size_t input, const glm::vec4& value)
  {
    this->Inputs[input].insert(this->Inputs[input].end(), { value.x, value.y, value.z, value.w });
  }
};

class PointTwins : public testing::TestWithParam<bool>
{
protected:
  void SetUp() override
  {
    this->Canvas.Window->Render();
    this->Declarations = PointDeclarations();
    // Numbers of cells and samples are those of the texels' grid.
    const std::vector<float> texels(this->Colors.Values.size(), 0.0f);
    UploadTexels(this->Canvas.Window, this->Heights, glm::uvec2(kSize), texels.data());
    UploadTexels(this->Canvas.Window, this->Values, glm::uvec2(kSize), this->Colors.Values.data());
    this->UploadColors(this->ArrayColors, kSize, this->Colors.Colors);
    this->UploadColors(this->ColorMap, { kColors, 1 }, this->Colors.ColorMap);
    this->UploadColors(this->Drape, { 1, 1 }, { this->Colors.Drape });
  }
  void TearDown() override
  {
    for (vtkTextureObject* texture : this->Textures)
    {
      texture->Deactivate();
    }
  }

  /// Four numbers that a shader makes of each point.
  std::vector<float> Run(
    const Points& points, const terrain::PixelRays& rays, const std::string& body)
  {
    return RunShader(this->Canvas.Window, this->Declarations,
      "TerrainSurface point = inputPoint(input0, input1, input2); vec2 pixel = input0.xy;" + body,
      points.Inputs,
      [&](vtkShaderProgram* program)
      {
        SetRays(program, rays);
        this->SetConstants(program);
      });
  }

  /// Expects what a shader makes of each point; the tolerance is relative above 1.
  void Compare(const Points& points, const terrain::PixelRays& rays, const std::string& body,
    float tolerance, const std::function<glm::vec4(std::size_t)>& twin)
  {
    this->CompareWithin(points, rays, body, twin,
      [&](std::size_t, const glm::vec4& expected)
      { return tolerance * glm::max(glm::abs(expected), 1.0f); });
  }

  /// Likewise; allowed: what each number may be off by.
  void CompareWithin(const Points& points, const terrain::PixelRays& rays, const std::string& body,
    const std::function<glm::vec4(std::size_t)>& twin,
    const std::function<glm::vec4(std::size_t, const glm::vec4&)>& allowed)
  {
    SCOPED_TRACE(body);
    const std::vector<float> results = this->Run(points, rays, body);
    ASSERT_EQ(results.size(), 4 * points.Items.size());
    int different = 0;
    for (std::size_t k = 0; k < points.Items.size(); ++k)
    {
      const glm::vec4 expected = twin(k);
      const glm::vec4 room = allowed(k, expected);
      for (int c = 0; c < 4; ++c)
      {
        const float result = results[4 * k + static_cast<std::size_t>(c)];
        const bool same =
          std::isnan(expected[c]) ? std::isnan(result) : std::abs(result - expected[c]) <= room[c];
        different += same ? 0 : 1;
      }
    }
    EXPECT_EQ(different, 0);
  }

  vtkTerrainTesting::Scene Canvas = MakeScene(16, 16);
  terrain::SurfaceColors Colors = MakeColors();

private:
  void UploadColors(
    vtkTextureObject* texture, const glm::uvec2& size, std::vector<glm::vec4> colors)
  {
    texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(this->Canvas.Window));
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(size.x, size.y, 4, VTK_FLOAT, colors.data());
    texture->Activate();
  }

  void SetConstants(vtkShaderProgram* program) const
  {
    terrain::SurfaceColors colors = this->Colors;
    program->SetUniform2i("terrainSize", &kSize[0]);
    program->SetUniformi("terrainHeights", this->Heights->GetTextureUnit());
    program->SetUniformi("terrainColorKind", static_cast<int>(colors.Kind));
    program->SetUniformi("terrainValues", this->Values->GetTextureUnit());
    program->SetUniformi("terrainColors", this->ArrayColors->GetTextureUnit());
    const int texels[2] = { 4, 4 };
    program->SetUniform2i("terrainArrayTexels", texels);
    program->SetUniform2f("terrainGradientScale", &colors.GradientScale[0]);
    program->SetUniformi("terrainColorMap", this->ColorMap->GetTextureUnit());
    program->SetUniform4fv("terrainSpecialColors", 3, &colors.SpecialColors[0][0]);
    program->SetUniform2f("terrainValueScale", &colors.ValueScale[0]);
    program->SetUniform2f("terrainColorScale", &colors.ColorScale[0]);
    program->SetUniformi("terrainColorLogarithm", colors.ColorLogarithm ? 1 : 0);
    program->SetUniformf("terrainMaximumShownCrossings", colors.MaximumShownCrossings);
    program->SetUniformi("terrainDrape", this->Drape->GetTextureUnit());
    const glm::vec4 drapeScale(colors.DrapeScale);
    program->SetUniform4f("terrainDrapeScale", &drapeScale[0]);
    program->SetUniform3f("terrainSunDirection", &colors.SunDirection[0]);
    program->SetUniformf("terrainShadeRelief", colors.ShadeRelief);
    program->SetUniformf("terrainShadeStrength", colors.ShadeStrength);
    const glm::vec2 contours(colors.ContourScale);
    program->SetUniform2f("terrainContourScale", &contours[0]);
    program->SetUniformf("terrainContourWidth", static_cast<float>(colors.ContourWidth));
    program->SetUniformf("terrainContourIndex", static_cast<float>(colors.ContourIndex));
    program->SetUniform4f("terrainContourColor", &colors.ContourColor[0]);
  }

  vtkNew<vtkTextureObject> Heights;
  vtkNew<vtkTextureObject> Values;
  vtkNew<vtkTextureObject> ArrayColors;
  vtkNew<vtkTextureObject> ColorMap;
  vtkNew<vtkTextureObject> Drape;
  std::array<vtkTextureObject*, 5> Textures{ Heights, Values, ArrayColors, ColorMap, Drape };
  std::string Declarations;
};
}

#endif
