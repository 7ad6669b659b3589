// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A globe on the graphics card, for tests of shaders/vtkTerrainGlobe*.glsl.
 */
#ifndef vtkTerrainTestGlobeCard_h
#define vtkTerrainTestGlobeCard_h

#include "vtkTerrainTestTextures.h"
#include "vtkTerrainTestTwins.h"
#include "vtkTerrainTesting.h"

#include "../Unit/UnitTestGlobe.h"

#include <string>
#include <vector>

namespace vtkTerrainTesting
{
using GlobeTexel = std::uint16_t;

/// The functions that trace a globe.
inline std::string GlobeDeclarations(terrain::Features features)
{
  features.Globe = true;
  return features.Defines() + terrain::Features::Constants() + ReadShader("vtkTerrainHeights") +
    ReadShader("vtkTerrainColumns") + ReadShader("vtkTerrainRay") + ReadShader("vtkTerrainView") +
    ReadShader("vtkTerrainGlobeLines") + ReadShader("vtkTerrainPyramid") +
    ReadShader("vtkTerrainGlobeTrace");
}

/// The lines of a globe on the GPU.
class GlobeTexture
{
public:
  GlobeTexture(vtkRenderWindow* window, const terrain::WorldTracer<float, GlobeTexel>& tracer)
    : Tracer(tracer)
  {
    std::vector<glm::vec4> texels;
    texels.reserve(tracer.Lines.Columns.size());
    for (const glm::vec2& column : tracer.Lines.Columns)
    {
      texels.emplace_back(column, 0.0f, 0.0f);
    }
    texels.insert(texels.end(), tracer.Lines.Rows.begin(), tracer.Lines.Rows.end());
    texels.insert(texels.end(), tracer.Lines.Curves.begin(), tracer.Lines.Curves.end());
    vtkTerrainTesting::PrepareTexture(window, this->Texture, GL_RGBA32F, GL_RGBA);
    this->Buffer->Upload(&texels[0].x, 4 * texels.size(), vtkOpenGLBufferObject::TextureBuffer);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer);
    this->Texture->Activate();
  }
  GlobeTexture(const GlobeTexture&) = delete;
  GlobeTexture& operator=(const GlobeTexture&) = delete;
  ~GlobeTexture()
  {
    this->Texture->Deactivate();
  }

  void SetUniforms(vtkShaderProgram* program) const
  {
    const terrain::GlobeLines<float>& lines = this->Tracer.Lines;
    const auto set = [program](const char* name, const glm::vec4& value)
    { program->SetUniform4f(name, &value[0]); };
    program->SetUniformi("terrainGlobeLines", this->Texture->GetTextureUnit());
    set("terrainGlobeScene", { lines.Radius, lines.Axis, lines.Height, lines.Curvature });
    set("terrainGlobeOuter", { lines.Outer, lines.Spread });
    set("terrainGlobeInner", { lines.Inner, 0.0f });
    set("terrainGlobeColumn", { lines.PerStep, lines.Turn, lines.AnchorFraction, 0.0f });
    const glm::ivec2 grid(lines.AnchorCell, lines.Top);
    program->SetUniform2i("terrainGlobeGrid", &grid[0]);
    program->SetUniformi("terrainGlobeJoined", lines.Joined ? 1 : 0);
    const auto& traversal = this->Tracer.Traversal;
    set("terrainGlobeHeights",
      { traversal.codeScale, traversal.codeBase, traversal.anchorCode, 0.0f });
  }

private:
  const terrain::WorldTracer<float, GlobeTexel>& Tracer;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};

/// What GLSL says of the hits of rays on the GPU.
inline std::vector<float> CastOnCard(vtkRenderWindow* window, FieldTextures<GlobeTexel>& field,
  const GlobeTexture& lines, const std::vector<terrain::GlobeRay<float>>& rays,
  const std::string& result = "hit.found, hit.t, hit.cell.x + 4096 * hit.cell.y, hit.front")
{
  std::vector<std::vector<float>> inputs(2);
  for (const terrain::GlobeRay<float>& ray : rays)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      inputs[0].push_back(ray.Origin[axis]);
      inputs[1].push_back(ray.Direction[axis]);
    }
    inputs[0].push_back(ray.Begin);
    inputs[1].push_back(ray.End);
  }
  return vtkTerrainTesting::RunShader(window, GlobeDeclarations(field.GetFeatures()),
    "TerrainGlobeHit hit = terrainGlobeTrace(input0.xyz, input1.xyz, input0.w, input1.w);"
    "result = vec4(" +
      result + ");",
    inputs,
    [&](vtkShaderProgram* program)
    {
      field.SetUniforms(program);
      lines.SetUniforms(program);
    });
}

/// Middle of a grid, at a height in metres above the ellipsoid.
inline glm::dvec3 MiddleOf(const terrain::GlobeGrid& grid, double height)
{
  const double latitude = grid.Latitudes[grid.Latitudes.size() / 2] + 0.1 * grid.Step;
  return grid.Body.ToPosition({ grid.West + 0.47 * grid.Columns * grid.Step, latitude, height });
}
}

#endif
