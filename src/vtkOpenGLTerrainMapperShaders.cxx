// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper that writes shaders. Each
 * ReplaceShader method says whether it extends VTK's code at a tag or replaces it.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "render/Driver.h"
#include "vtkTerrainMapperInternals.h"

#include "vtkTerrainCast.h"
#include "vtkTerrainColor.h"
#include "vtkTerrainColumns.h"
#include "vtkTerrainGradient.h"
#include "vtkTerrainHeights.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainRay.h"
#include "vtkTerrainSearch.h"
#include "vtkTerrainSighting.h"
#include "vtkTerrainSurface.h"
#include "vtkTerrainTrace.h"
#include "vtkTerrainView.h"

#include "vtkActor.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
/// Components of the uniforms that UniformPasser passes; drivers have 128 for all varyings.
constexpr int MostPassedComponents = 120;

int componentsOf(const std::string& type)
{
  return type == "mat3" ? 9 : type == "float" || type == "int" ? 1 : type.back() - '0';
}

/// Turns uniforms of a fragment shader into those of the vertex shader, which passes them on.
/// Mesa's llvmpipe reads a uniform for each pixel by itself, in some 25 instructions, and a flat
/// input in two.
class UniformPasser
{
public:
  /// The vertex shader, and the lines that define what the fragment shader has defined.
  UniformPasser(std::string vertexSource, std::string defines)
    : VertexSource(std::move(vertexSource))
    , Defines(std::move(defines))
  {
  }

  /// The fragment shader with inputs instead of uniforms.
  std::string Fragment(const std::string& source)
  {
    std::istringstream lines(source);
    std::string result;
    for (std::string line; std::getline(lines, line);)
    {
      this->Follow(line);
      result += (this->IsRead() ? this->WithInputs(line) : line) + "\n";
    }
    return result;
  }

  /// The vertex shader with these uniforms.
  std::string Vertex() const
  {
    std::string source = this->VertexSource;
    const std::size_t mainAt = source.find("void main()");
    source.insert(source.find('{', mainAt) + 1, "\n" + this->Assignments);
    return source.insert(mainAt, this->Declarations);
  }

private:
  /// Keeps track of which parts of the source our defines leave out.
  void Follow(const std::string& line)
  {
    if (line.rfind("#if", 0) == 0)
    {
      const bool ours = line.rfind("#ifdef TERRAIN_", 0) == 0;
      this->Parts.push_back(!ours || this->Defines.find(line.substr(7)) != std::string::npos);
    }
    else if (line.rfind("#el", 0) == 0 && !this->Parts.empty())
    {
      this->Parts.back() = true;
    }
    else if (line.rfind("#endif", 0) == 0 && !this->Parts.empty())
    {
      this->Parts.pop_back();
    }
  }

  bool IsRead() const
  {
    return std::find(this->Parts.begin(), this->Parts.end(), false) == this->Parts.end();
  }

  std::string WithInputs(std::string line)
  {
    static const std::regex uniform("uniform (float|int|ivec2|vec[234]|mat3) (\\w+);");
    std::smatch match;
    if (!std::regex_search(line, match, uniform))
    {
      return line;
    }
    const std::string type = match[1];
    const std::string name = match[2];
    const std::string rest = this->WithInputs(match.suffix());
    if (this->Left < componentsOf(type) || this->VertexSource.find(name) != std::string::npos)
    {
      return match.prefix().str() + match[0].str() + rest;
    }
    this->Left -= componentsOf(type);
    const std::string passed = name + "VSOutput";
    this->Declarations += "uniform " + type + " " + name + ";\n";
    this->Declarations += "flat out " + type + " " + passed + ";\n";
    this->Assignments += "  " + passed + " = " + name + ";\n";
    return match.prefix().str() + "flat in " + type + " " + passed + ";" + rest + "\n#define " +
      name + " " + passed;
  }

  std::string VertexSource;
  std::string Defines;
  std::string Declarations;
  std::string Assignments;
  std::vector<bool> Parts;
  int Left = MostPassedComponents;
};

/// Name of the search of a technique in shaders/vtkTerrainSearch.glsl.
const char* searchDefine(vtkOpenGLTerrainMapper::Techniques technique)
{
  switch (technique)
  {
    case vtkOpenGLTerrainMapper::Techniques::Linear:
      return "#define TERRAIN_LINEAR\n";
    case vtkOpenGLTerrainMapper::Techniques::Exponential:
      return "#define TERRAIN_EXPONENTIAL\n";
    case vtkOpenGLTerrainMapper::Techniques::Pyramid:
      return "#define TERRAIN_PYRAMID\n";
    default:
      return "#define TERRAIN_EQUIDISTANT\n";
  }
}

/// Planes that cut the surface, a tenth of a frame on processors that run both sides of a branch.
std::string cutDefines(vtkPlaneCollection* planes, const terrain::Cutting& cutting)
{
  std::string defines;
  if ((planes && planes->GetNumberOfItems() > 0) || cutting.Cuts())
  {
    defines += "#define TERRAIN_CLIP_PLANES " + std::to_string(terrain::MaximumClipPlanes) + "\n";
  }
  return defines + (cutting.Block ? "#define TERRAIN_BLOCK\n" : "");
}
}

//------------------------------------------------------------------------------
void vtkTerrainSubstitute(
  vtkObject* self, vtkShader* shader, const std::string& tag, const std::string& text)
{
  std::string source = shader->GetSource();
  if (!vtkShaderProgram::Substitute(source, tag, text))
  {
    vtkErrorWithObjectMacro(self, "The shader has no tag " << tag);
  }
  shader->SetSource(source);
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::HeightDefines() const
{
  const terrain::HeightTexture& heights = this->Internals->Heights;
  std::string defines;
  if (heights.GetCodes().Format == terrain::HeightCodes::TexelFormat::UInt16)
  {
    defines += "#define TERRAIN_HEIGHTS_INTEGER\n";
  }
  defines += heights.HasPyramidBuffer() ? "#define TERRAIN_PYRAMID_BUFFER\n" : "";
  defines += heights.HasDetail() ? "#define TERRAIN_DETAIL\n" : "";
  return defines;
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::CastDefines() const
{
  std::string defines = this->HeightDefines() + searchDefine(this->Technique);
  if (this->Technique == Techniques::Pyramid)
  {
    defines += this->Surface == Surfaces::Columns ? "#define TERRAIN_COLUMNS\n" : "";
    defines += this->PixelTolerance > 0.0 ? "#define TERRAIN_WITHIN\n" : "";
  }
  return defines + cutDefines(this->ClippingPlanes, this->Internals->Cutting);
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::BeamDefines() const
{
  return this->Internals->BeamStarts.IsFilled() ? vtkInternals::BeamDefine() : "";
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::ShaderDefines(vtkActor* act)
{
  if (!this->UsesSurface(act))
  {
    return {};
  }
  std::string defines;
  if (this->CastsRays(act))
  {
    defines = "#define TERRAIN_CAST\n" + this->CastDefines() + this->BeamDefines();
    defines += this->Internals->EyeInBox ? "" : "#define TERRAIN_BELOW_BOX\n";
    defines += this->Internals->Sightings.IsFilled() ? "#define TERRAIN_READ_SIGHTINGS\n" : "";
  }
  else
  {
    defines = "#define TERRAIN_MESH\n" + this->HeightDefines() +
      cutDefines(this->ClippingPlanes, this->Internals->Cutting);
  }
  defines += this->IsTextured(act) ? "#define TERRAIN_TEXTURED\n" : "";
  return defines + this->Internals->Coloring.Defines();
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::CastFunctions() const
{
  return std::string(vtkTerrainPyramid) +
    (this->Technique == Techniques::Pyramid ? "" : vtkTerrainSearch) + vtkTerrainTrace +
    vtkTerrainCast;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderValues(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  ++this->Internals->ShaderBuilds;
  const std::string defines = this->ShaderDefines(act);
  if (!defines.empty())
  {
    // extend: our functions stand before main, after VTK's declarations of the camera
    vtkShader* fragment = shaders[vtkShader::Fragment];
    vtkTerrainSubstitute(this, fragment, "//VTK::System::Dec",
      "//VTK::System::Dec\n"
      "#extension GL_ARB_conservative_depth : enable\n" +
        std::string(vtkInternals::Extensions) + defines);
    std::string functions =
      std::string(vtkTerrainHeights) + vtkTerrainColumns + vtkTerrainRay + vtkTerrainView;
    if (this->CastsRays(act))
    {
      functions +=
        this->Internals->Sightings.IsFilled() ? vtkTerrainSighting : this->CastFunctions();
    }
    functions += std::string(vtkTerrainGradient) + vtkTerrainSurface + vtkTerrainColor;
    vtkTerrainSubstitute(this, fragment, "//VTK::Camera::Dec", "//VTK::Camera::Dec\n" + functions);
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (!defines.empty())
  {
    // the surface that is hit decides what is its front, not the proxy
    std::string source = shaders[vtkShader::Fragment]->GetSource();
    vtkShaderProgram::Substitute(source, "gl_FrontFacing == false", "!terrainPoint.front");
    shaders[vtkShader::Fragment]->SetSource(source);
    this->FollowDepth(shaders, act);
    this->FollowValues(shaders);
  }
  if (this->CastsRays(act) && terrain::IsSoftware())
  {
    // its proxy is a box, whose few vertices cost nothing
    UniformPasser passer(shaders[vtkShader::Vertex]->GetSource(), defines);
    vtkShader* fragment = shaders[vtkShader::Fragment];
    fragment->SetSource(passer.Fragment(fragment->GetSource()));
    shaders[vtkShader::Vertex]->SetSource(passer.Vertex());
  }
}

//------------------------------------------------------------------------------
// Replace: detail moves vertices, and the position in view coordinates is there without lights,
// too.
void vtkOpenGLTerrainMapper::ReplaceShaderPositionVC(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkShader* vertex = shaders[vtkShader::Vertex];
  vtkTerrainSubstitute(this, vertex, "//VTK::PositionVC::Dec",
    "uniform vec3 terrainLift; // z in the buffer is moved by x, or by y where it is < z\n"
    "out vec4 vertexVCVSOutput;\n");
  vtkTerrainSubstitute(this, vertex, "//VTK::PositionVC::Impl",
    "vec4 terrainVertexMC = vec4(vertexMC.xy,\n"
    "    vertexMC.z + (vertexMC.z < terrainLift.z ? terrainLift.y : terrainLift.x), 1.0);\n"
    "  vertexVCVSOutput = MCVCMatrix * terrainVertexMC;\n"
    "  gl_Position = MCDCMatrix * terrainVertexMC;\n");
  vtkTerrainSubstitute(
    this, vertex, "//VTK::Camera::Dec", "uniform mat4 MCDCMatrix;\nuniform mat4 MCVCMatrix;\n");

  vtkShader* fragment = shaders[vtkShader::Fragment];
  vtkTerrainSubstitute(this, fragment, "//VTK::PositionVC::Dec", "in vec4 vertexVCVSOutput;");
  vtkTerrainSubstitute(
    this, fragment, "//VTK::PositionVC::Impl", "vec4 vertexVC = vertexVCVSOutput;");
  this->Superclass::ReplaceShaderPositionVC(shaders, ren, act);
}

//------------------------------------------------------------------------------
// Replace: finds the point of the surface that the fragment shows.
void vtkOpenGLTerrainMapper::ReplaceShaderDepth(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkShader* fragment = shaders[vtkShader::Fragment];
  const std::string textured = this->IsTextured(act)
    ? "  tcoordVCVSOutput = terrainTexturePosition(terrainPoint);\n"
      "  mat2 terrainTextureMove = terrainTextureFootprint(gl_FragCoord.xy, terrainPoint);\n"
    : "";
  if (this->CastsRays(act))
  {
    vtkTerrainSubstitute(this, fragment, "//VTK::Depth::Impl",
      "TerrainSurface terrainPoint = terrainSeen(gl_FragCoord.xy, vertexVC);\n"
      "  if (!terrainPoint.found) { discard; }\n"
      "  vertexVC = terrainPoint.positionVC;\n"
      "  gl_FragDepth = terrainFragmentDepth(vertexVC, gl_FragCoord[2]);\n" +
        textured + "  //VTK::Depth::Impl\n");
  }
  else if (this->UsesSurface(act))
  {
    vtkTerrainSubstitute(this, fragment, "//VTK::Depth::Impl",
      "TerrainSurface terrainPoint = terrainBelow(vertexVC, gl_FrontFacing);\n" + textured +
        "  //VTK::Depth::Impl\n");
  }
  this->Superclass::ReplaceShaderDepth(shaders, ren, act);
}

//------------------------------------------------------------------------------
// Replace: the normal is the surface's, not the proxy's.
void vtkOpenGLTerrainMapper::ReplaceShaderNormal(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->UsesSurface(act))
  {
    this->Superclass::ReplaceShaderNormal(shaders, ren, act);
    return;
  }
  std::string normal = "vec3 normalVCVSOutput = terrainPoint.normalVC;\n";
  if (act->GetProperty()->GetInterpolation() == VTK_PBR &&
    act->GetProperty()->GetCoatStrength() > 0.0)
  {
    normal += "  vec3 coatNormalVCVSOutput = terrainPoint.normalVC;\n";
  }
  vtkTerrainSubstitute(this, shaders[vtkShader::Fragment], "//VTK::Normal::Impl", normal);
}
