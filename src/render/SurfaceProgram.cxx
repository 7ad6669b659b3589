// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/SurfaceProgram.h"

#include "render/ShaderText.h"
#include "render/Technique.h"
#include "render/UniformPasser.h"

namespace terrain
{
//------------------------------------------------------------------------------
void SurfaceProgram::Begin(const terrain::Features& features, Shaders& shaders)
{
  this->Features = features;
  this->Problem.clear();
  if (features.FindsSurface())
  {
    ShaderText fragment(shaders[vtkShader::Fragment], this->Problem);
    fragment.Behind(
      "//VTK::System::Dec", "#extension GL_ARB_conservative_depth : enable\n" + features.Defines());
    fragment.Behind("//VTK::Camera::Dec", Technique::FragmentFunctions(features));
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::PlaceVertices(Shaders& shaders)
{
  ShaderText vertex(shaders[vtkShader::Vertex], this->Problem);
  vertex.Replace("//VTK::Camera::Dec", "uniform mat4 MCDCMatrix;\nuniform mat4 MCVCMatrix;\n");
  vertex.Replace("//VTK::PositionVC::Dec", "out vec4 vertexVCVSOutput;\n");
  vertex.Replace("//VTK::PositionVC::Impl",
    "  vertexVCVSOutput = MCVCMatrix * vertexMC;\n  gl_Position = MCDCMatrix * vertexMC;\n");
  ShaderText fragment(shaders[vtkShader::Fragment], this->Problem);
  fragment.Replace("//VTK::PositionVC::Dec", "in vec4 vertexVCVSOutput;\n");
  fragment.Replace("//VTK::PositionVC::Impl", "  vec4 vertexVC = vertexVCVSOutput;\n");
}

//------------------------------------------------------------------------------
void SurfaceProgram::FindSurface(Shaders& shaders)
{
  if (!this->Features.FindsSurface())
  {
    return;
  }
  std::string code = this->Features.CastsRays()
    ? "  TerrainSurface terrainPoint = terrainSeen(gl_FragCoord.xy, vertexVC);\n"
      "  if (!terrainPoint.found) { discard; }\n"
      "  vertexVC = terrainPoint.positionVC;\n"
      "  gl_FragDepth = terrainFragmentDepth(vertexVC, gl_FragCoord.z);\n"
    : "  TerrainSurface terrainPoint = terrainBelow(vertexVC, gl_FrontFacing);\n";
  if (this->Features.Textured)
  {
    code += "  tcoordVCVSOutput = terrainTexturePosition(terrainPoint);\n"
            "  mat2 terrainTextureMove = terrainTextureFootprint(gl_FragCoord.xy, terrainPoint);\n";
  }
  ShaderText(shaders[vtkShader::Fragment], this->Problem).Before("//VTK::Depth::Impl", code);
}

//------------------------------------------------------------------------------
void SurfaceProgram::ShiftDepth(Shaders& shaders)
{
  if (this->Features.ShiftsDepth)
  {
    ShaderText fragment(shaders[vtkShader::Fragment], this->Problem);
    fragment.Replace("//VTK::Coincident::Dec",
      "uniform float cOffset;\nuniform float cFactor; // stays 0 before VTK 9.3\n");
    fragment.Behind("//VTK::Depth::Impl",
      "  gl_FragDepth =\n"
      "    terrainShiftedDepth(gl_FragCoord.xy, terrainPoint, cFactor, cOffset);\n");
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::ReplaceNormal(Shaders& shaders, bool hasCoat)
{
  std::string normals = "  vec3 normalVCVSOutput = terrainPoint.normalVC;\n";
  normals += hasCoat ? "  vec3 coatNormalVCVSOutput = terrainPoint.normalVC;\n" : "";
  ShaderText(shaders[vtkShader::Fragment], this->Problem).Replace("//VTK::Normal::Impl", normals);
}

//------------------------------------------------------------------------------
// Variables of main() with the names of VTK's uniforms stand in their place, in all that follows.
void SurfaceProgram::CastShadows(Shaders& shaders)
{
  std::string code;
  if (this->Features.ShadowMask != 0)
  {
    code = "  float terrainShares[TERRAIN_SHADOWS];\n"
           "  terrainFindShares(gl_FragCoord.xy, terrainPoint, terrainShares);\n";
  }
  int share = 0;
  for (int light = 0; light < kMostShadows; ++light)
  {
    if (((this->Features.ShadowMask >> light) & 1) != 0)
    {
      const std::string color = "lightColor" + std::to_string(light);
      code.append("  vec3 ").append(color).append(" = terrainShares[");
      code.append(std::to_string(share++)).append("] * ").append(color).append(";\n");
    }
  }
  if (this->Features.Sky)
  {
    code += "  ambientColor += terrainSkyShare(terrainPoint) * diffuseColor;\n";
  }
  if (!code.empty())
  {
    ShaderText(shaders[vtkShader::Fragment], this->Problem).Before("//VTK::Light::Impl", code);
  }
}

//------------------------------------------------------------------------------
// VTK's code adds no ambient colour to these materials.
void SurfaceProgram::AddSkyLight(Shaders& shaders, bool physicallyBased)
{
  if (this->Features.Sky && physicallyBased)
  {
    ShaderText(shaders[vtkShader::Fragment], this->Problem)
      .Require("vec3 Lo = vec3(0.0);",
        "vec3 Lo = terrainSkyShare(terrainPoint) * (1.0 - metallic) * pow(diffuseColor, "
        "vec3(2.2));",
        "the sky would give no light");
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::PaintColors(Shaders& shaders)
{
  if (this->Features.Paints)
  {
    ShaderText(shaders[vtkShader::Fragment], this->Problem)
      .Behind("//VTK::Color::Impl",
        "  terrainPaintMaterial(gl_FragCoord.xy, terrainPoint, ambientIntensity,\n"
        "    diffuseIntensity, ambientColor, diffuseColor, opacity);\n");
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::FollowTextures(Shaders& shaders, bool isActorTextured)
{
  if (!this->Features.Textured)
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], this->Problem);
  fragment.Require(
    "in vec2 tcoordVCVSOutput;", "vec2 tcoordVCVSOutput;", "textures would lie on the proxy");
  if (isActorTextured)
  {
    // neighbouring pixels may show far places: the surface tells how its texture changes
    fragment.Require("texture(actortexture, tcoordVCVSOutput)",
      "textureGrad(actortexture, tcoordVCVSOutput, terrainTextureMove[0], terrainTextureMove[1])",
      "the texture would be blurred along silhouettes");
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::ClipMesh(Shaders& shaders)
{
  if (!this->Features.CastsRays())
  {
    ShaderText(shaders[vtkShader::Fragment], this->Problem)
      .Replace("//VTK::Clip::Impl", "  if (terrainIsClipped(vertexVC)) { discard; }\n");
  }
}

//------------------------------------------------------------------------------
void SurfaceProgram::ReplaceIds(Shaders& shaders, bool ofCells, bool highBits)
{
  ShaderText(shaders[vtkShader::Fragment], this->Problem)
    .Replace("//VTK::Picking::Impl",
      std::string("  int terrainId = ") +
        (ofCells ? "terrainCellId(terrainPoint);\n" : "terrainSampleId(terrainPoint);\n") +
        "  gl_FragData[0] = terrainIdColor(terrainId" + (highBits ? " >> 24);\n" : ");\n"));
}

//------------------------------------------------------------------------------
std::string SurfaceProgram::End(Shaders& shaders)
{
  if (this->Features.FindsSurface())
  {
    this->FollowSurface(shaders);
  }
  return this->Problem.empty()
    ? std::string()
    : "The terrain does not know these shaders of VTK's, and may draw wrong: " + this->Problem;
}

//------------------------------------------------------------------------------
void SurfaceProgram::FollowSurface(Shaders& shaders)
{
  ShaderText fragment(shaders[vtkShader::Fragment], this->Problem);
  // what is hit decides what is its front, not the proxy; where VTK's text asks for none, fine
  fragment.Follow("gl_FrontFacing", "terrainPoint.front");
  if (this->Features.CastsRays())
  {
    fragment.Follow("gl_FragCoord.z", "gl_FragDepth");
    fragment.Follow("gl_FragCoord.w", "(1.0 / dot(terrainWeightRow, vertexVC))");
    fragment.RequireSwizzles("gl_FragCoord", "xy", "depths would be the proxy's");
  }
  // vtkValuePass in its floating-point mode, of points or of cells
  if (this->Features.Paints && fragment.Follow("in float dataValue;", "float dataValue;") &&
    !fragment.Follow(
      "vec4(vec3(dataValue), 1.0)", "vec4(vec3(terrainShownValue(terrainPoint)), 1.0)"))
  {
    fragment.Require("texelFetchBuffer(textureF, gl_PrimitiveID +\n    PrimitiveIDOffset)",
      "vec4(terrainShownValue(terrainPoint))", "the values of vtkValuePass would be the proxy's");
  }
  if (this->Features.PassesUniforms)
  {
    std::string vertexSource = shaders[vtkShader::Vertex]->GetSource();
    std::string fragmentSource = shaders[vtkShader::Fragment]->GetSource();
    PassUniforms(vertexSource, fragmentSource);
    shaders[vtkShader::Vertex]->SetSource(vertexSource);
    shaders[vtkShader::Fragment]->SetSource(fragmentSource);
  }
}
}
