// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper that writes shaders and sets their uniforms. Each
 * ReplaceShader method says whether it extends VTK's code at a tag or replaces it.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "vtkTerrainGL.h"
#include "vtkTerrainMapperInternals.h"

#include "core/HeightSearch.h"

#include "vtkTerrainColor.h"
#include "vtkTerrainHeights.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainRay.h"
#include "vtkTerrainSearch.h"
#include "vtkTerrainSurface.h"
#include "vtkTerrainTrace.h"
#include "vtkTerrainView.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr int ColorMapSize = 1024;

/// Substitutes a tag in a shader; says so if the tag is not there.
void substitute(vtkObject* self, vtkShader* shader, const std::string& tag, const std::string& text)
{
  std::string source = shader->GetSource();
  if (!vtkShaderProgram::Substitute(source, tag, text))
  {
    vtkErrorWithObjectMacro(self, "The shader has no tag " << tag);
  }
  shader->SetSource(source);
}

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

terrain::SearchKind searchKind(vtkOpenGLTerrainMapper::Techniques technique)
{
  switch (technique)
  {
    case vtkOpenGLTerrainMapper::Techniques::Linear:
      return terrain::SearchKind::Linear;
    case vtkOpenGLTerrainMapper::Techniques::Exponential:
      return terrain::SearchKind::Exponential;
    default:
      return terrain::SearchKind::Equidistant;
  }
}

/// What the coarse mesh tells of itself; the fallback for other meshes.
double fieldValue(vtkPolyData* mesh, const char* name, double fallback)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : fallback;
}

using FloatVectors = std::array<std::array<float, 3>, 6>;

/// A pixel vector as floats, followed by what float cuts off.
FloatVectors split(const terrain::PixelVector& vector)
{
  FloatVectors result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double value = vector[i][k];
      result[i][k] = static_cast<float>(value);
      result[i + 3][k] = static_cast<float>(value - result[i][k]);
    }
  }
  return result;
}

void setVectors(
  vtkShaderProgram* program, const char* name, const terrain::PixelVector& vector, int count)
{
  if (program->IsUniformUsed(name))
  {
    const FloatVectors vectors = split(vector);
    program->SetUniform3fv(name, count, vectors.front().data());
  }
}
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::ShaderDefines(vtkActor* act) const
{
  if (!this->UsesSurface(act))
  {
    return std::string();
  }
  std::string defines = this->CastsRays(act)
    ? std::string("#define TERRAIN_CAST\n") + searchDefine(this->Technique)
    : std::string("#define TERRAIN_MESH\n");
  if (this->Internals->Heights.GetCodes().Format == terrain::HeightCodes::TexelFormat::UInt16)
  {
    defines += "#define TERRAIN_HEIGHTS_INTEGER\n";
  }
  if (this->CastsRays(act) && !this->Internals->EyeInBox)
  {
    defines += "#define TERRAIN_BELOW_MESH\n";
  }
  if (act->GetProperty()->GetInterpolation() == VTK_FLAT)
  {
    defines += "#define TERRAIN_FLAT\n";
  }
  if (act->GetProperty()->GetBackfaceCulling())
  {
    defines += "#define TERRAIN_CULL_BACK\n";
  }
  if (act->GetProperty()->GetFrontfaceCulling())
  {
    defines += "#define TERRAIN_CULL_FRONT\n";
  }
  if (this->ShowCrossings)
  {
    defines += "#define TERRAIN_SHOW_CROSSINGS\n";
  }
  else if (this->ColorsByHeight())
  {
    defines += "#define TERRAIN_COLOR_BY_HEIGHT\n";
  }
  return defines;
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::ColorsByHeight() const
{
  return this->ScalarVisibility && !this->Colors && this->Internals->Heights.HasSurface();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderValues(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  const std::string defines = this->ShaderDefines(act);
  if (!defines.empty())
  {
    // extend: our functions stand before main, after VTK's declarations of the camera
    vtkShader* fragment = shaders[vtkShader::Fragment];
    substitute(this, fragment, "//VTK::System::Dec",
      "//VTK::System::Dec\n"
      "#extension GL_ARB_gpu_shader_fp64 : enable\n"
      "#extension GL_ARB_conservative_depth : enable\n" +
        defines);
    std::string functions = std::string(vtkTerrainHeights) + vtkTerrainRay + vtkTerrainView;
    if (this->CastsRays(act))
    {
      functions += this->Technique == Techniques::Pyramid ? vtkTerrainPyramid : vtkTerrainSearch;
      functions += vtkTerrainTrace;
    }
    functions += std::string(vtkTerrainSurface) + vtkTerrainColor;
    substitute(this, fragment, "//VTK::Camera::Dec", "//VTK::Camera::Dec\n" + functions);
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (!defines.empty())
  {
    // the surface that is hit decides what is its front, not the proxy
    std::string source = shaders[vtkShader::Fragment]->GetSource();
    vtkShaderProgram::Substitute(source, "gl_FrontFacing", "terrainPoint.front");
    shaders[vtkShader::Fragment]->SetSource(source);
  }
}

//------------------------------------------------------------------------------
// Replace: vertices are exaggerated, and the position in view coordinates is there without lights,
// too.
void vtkOpenGLTerrainMapper::ReplaceShaderPositionVC(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkShader* vertex = shaders[vtkShader::Vertex];
  substitute(this, vertex, "//VTK::PositionVC::Dec",
    "uniform vec2 terrainExaggeration; // z drawn = x * z + y, in the coordinates of the buffer\n"
    "out vec4 vertexVCVSOutput;\n");
  substitute(this, vertex, "//VTK::PositionVC::Impl",
    "vec4 terrainVertexMC = vec4(vertexMC.xy,\n"
    "    terrainExaggeration.x * vertexMC.z + terrainExaggeration.y, 1.0);\n"
    "  vertexVCVSOutput = MCVCMatrix * terrainVertexMC;\n"
    "  gl_Position = MCDCMatrix * terrainVertexMC;\n");
  substitute(
    this, vertex, "//VTK::Camera::Dec", "uniform mat4 MCDCMatrix;\nuniform mat4 MCVCMatrix;\n");

  vtkShader* fragment = shaders[vtkShader::Fragment];
  substitute(this, fragment, "//VTK::PositionVC::Dec", "in vec4 vertexVCVSOutput;");
  substitute(this, fragment, "//VTK::PositionVC::Impl", "vec4 vertexVC = vertexVCVSOutput;");
  this->Superclass::ReplaceShaderPositionVC(shaders, ren, act);
}

//------------------------------------------------------------------------------
// Replace: finds the point of the surface that the fragment shows.
void vtkOpenGLTerrainMapper::ReplaceShaderDepth(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkShader* fragment = shaders[vtkShader::Fragment];
  if (this->CastsRays(act))
  {
    substitute(this, fragment, "//VTK::Depth::Impl",
      "TerrainSurface terrainPoint = terrainCast(gl_FragCoord.xy, terrainEntry(vertexVC));\n"
      "  if (!terrainPoint.found) { discard; }\n"
      "  vertexVC = terrainPoint.positionVC;\n"
      "  gl_FragDepth = terrainFragmentDepth(vertexVC, gl_FragCoord.z);\n");
  }
  else if (this->UsesSurface(act))
  {
    substitute(this, fragment, "//VTK::Depth::Impl",
      "TerrainSurface terrainPoint = terrainBelow(vertexVC,\n"
      "    terrainDirectionAt(gl_FragCoord.xy));\n"
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
  substitute(this, shaders[vtkShader::Fragment], "//VTK::Normal::Impl", normal);
}

//------------------------------------------------------------------------------
// Extend: the colours of VTK's code are overwritten where the surface has its own.
void vtkOpenGLTerrainMapper::ReplaceShaderColor(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->UsesSurface(act) && (this->ShowCrossings || this->ColorsByHeight()))
  {
    substitute(this, shaders[vtkShader::Fragment], "//VTK::Color::Impl",
      "//VTK::Color::Impl\n"
      "  vec4 terrainColor = terrainSurfaceColor(terrainPoint);\n"
      "  ambientColor = ambientIntensity * terrainColor.rgb;\n"
      "  diffuseColor = diffuseIntensity * terrainColor.rgb;\n"
      "  opacity *= terrainColor.a;\n");
  }
  this->Superclass::ReplaceShaderColor(shaders, ren, act);
}

//------------------------------------------------------------------------------
// Replace for rays: they are clipped before they are cast, so that the cut shows what lies behind.
void vtkOpenGLTerrainMapper::ReplaceShaderClip(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->CastsRays(act))
  {
    this->Superclass::ReplaceShaderClip(shaders, ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  this->SetVertexUniforms(cellBO.Program);
  if (this->UsesSurface(act))
  {
    this->Internals->Heights.SetUniforms(cellBO.Program);
    this->SetViewUniforms(cellBO.Program);
    this->SetSearchUniforms(cellBO.Program);
    this->SetClipUniforms(cellBO.Program, act);
    this->SetColorUniforms(cellBO.Program);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetVertexUniforms(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("terrainExaggeration"))
  {
    return;
  }
  double shift = 0.0;
  double scale = 1.0;
  vtkOpenGLVertexBufferObject* vertices = this->VBOs->GetVBO("vertexMC");
  if (vertices && vertices->GetCoordShiftAndScaleEnabled())
  {
    shift = vertices->GetShift()[2];
    scale = vertices->GetScale()[2];
  }
  // in the buffer z is (z - shift) * scale; drawn is origin + exaggeration * (z - origin)
  const double factor = this->Internals->Why.empty() ? this->VerticalExaggeration : 1.0;
  const double origin = this->Internals->Heights.GetGeometry().Origin.z;
  const std::array<float, 2> exaggeration{ static_cast<float>(factor),
    static_cast<float>((1.0 - factor) * (origin - shift) * scale) };
  program->SetUniform2f("terrainExaggeration", exaggeration.data());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetViewUniforms(vtkShaderProgram* program)
{
  const terrain::PixelRays& rays = this->Internals->Rays;
  setVectors(program, "terrainOriginGC", rays.OriginGC, 6);
  setVectors(program, "terrainDirectionGC", rays.DirectionGC, 6);
  setVectors(program, "terrainOriginVC", rays.OriginVC, 3);
  setVectors(program, "terrainDirectionVC", rays.DirectionVC, 3);
  glm::mat3 normalMatrix(rays.NormalMatrix);
  program->SetUniformMatrix3x3("terrainNormalMatrix", &normalMatrix[0][0]);
  const glm::vec4 depthRow(rays.DepthRow);
  const glm::vec4 weightRow(rays.WeightRow);
  program->SetUniform4f("terrainDepthRow", &depthRow[0]);
  program->SetUniform4f("terrainWeightRow", &weightRow[0]);
  program->SetUniformf("terrainNear", static_cast<float>(rays.Near));
  program->SetUniformf("terrainFar", static_cast<float>(rays.Far));
  glm::mat4 viewToGrid(this->Internals->ViewToGrid);
  program->SetUniformMatrix4x4("terrainViewToGrid", &viewToGrid[0][0]);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetSearchUniforms(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("terrainSecantSteps"))
  {
    return;
  }
  const vtkTerrainHeightTexture& heights = this->Internals->Heights;
  const terrain::HeightCodes& codes = heights.GetCodes();
  const glm::dvec2 spacing = heights.GetGeometry().Spacing;
  terrain::SearchScene scene;
  scene.Width = heights.GetSize().x;
  scene.Height = heights.GetSize().y;
  scene.CellsPerQuad = std::max<std::int64_t>(
    1, static_cast<std::int64_t>(fieldValue(this->GetInput(), "SamplesPerQuad", 1.0)));
  scene.LargestGap =
    fieldValue(this->GetInput(), "LargestGap", codes.MaximumCode * codes.Scale) / codes.Scale;
  scene.MaximumCode = codes.MaximumCode;
  scene.CodesPerCell =
    std::sqrt(spacing.x * spacing.y) / (this->VerticalExaggeration * codes.Scale);

  terrain::SearchParameters search =
    terrain::ChooseSearchParameters(scene, searchKind(this->Technique));
  search.Steps = this->Steps > 0 ? this->Steps : search.Steps;
  search.LongSteps = this->LongSteps > 0 ? this->LongSteps : search.LongSteps;
  search.SecantSteps = this->SecantSteps > 0 ? this->SecantSteps : search.SecantSteps;
  search.StepLength =
    this->StepLength > 0.0 ? static_cast<float>(this->StepLength) : search.StepLength;
  if (this->Internals->EyeInBox)
  {
    search.LargestGap = std::numeric_limits<float>::max(); // rays do not start at the mesh
  }
  program->SetUniformi("terrainSteps", search.Steps);
  program->SetUniformi("terrainLongSteps", search.LongSteps);
  program->SetUniformi("terrainSecantSteps", search.SecantSteps);
  program->SetUniformf("terrainStepLength", search.StepLength);
  program->SetUniformf("terrainStepRelief", search.StepRelief);
  program->SetUniformf("terrainLargestGap", search.LargestGap);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetClipUniforms(vtkShaderProgram* program, vtkActor* act)
{
  if (!program->IsUniformUsed("terrainClipPlaneCount"))
  {
    return;
  }
  const int count = std::min(this->GetNumberOfClippingPlanes(), 6);
  std::array<std::array<float, 4>, 6> planes{};
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(act->GetMatrix(), i, plane);
    const glm::dvec4 planeVC =
      glm::dvec4(plane[0], plane[1], plane[2], plane[3]) * this->Internals->ViewToModel;
    const double length = glm::length(glm::dvec3(planeVC));
    for (int k = 0; k < 4; ++k)
    {
      planes[i][k] = static_cast<float>(planeVC[k] / length);
    }
  }
  program->SetUniformi("terrainClipPlaneCount", count);
  program->SetUniform4fv("terrainClipPlanesVC", 6, planes.front().data());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateColorMap(vtkRenderer* ren)
{
  if (!this->ColorsByHeight())
  {
    return;
  }
  vtkInternals& internals = *this->Internals;
  vtkScalarsToColors* table = this->GetLookupTable();
  const double* range =
    this->UseLookupTableScalarRange ? table->GetRange() : this->GetScalarRange();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
  const bool current = internals.ColorMap->GetContext() == window &&
    internals.ColorMapTime == table->GetMTime() &&
    std::equal(range, range + 2, internals.ColorRange);
  if (!current)
  {
    std::copy(range, range + 2, internals.ColorRange);
    std::vector<double> values(ColorMapSize);
    for (int i = 0; i < ColorMapSize; ++i)
    {
      values[i] = range[0] + (range[1] - range[0]) * (i + 0.5) / ColorMapSize;
    }
    table->SetRange(range);
    table->Build();
    std::vector<unsigned char> colors(4 * ColorMapSize);
    table->MapScalarsThroughTable2(
      values.data(), colors.data(), VTK_DOUBLE, ColorMapSize, 1, VTK_RGBA);
    internals.ColorMap->ReleaseGraphicsResources(internals.ColorMap->GetContext());
    internals.ColorMap->SetContext(window);
    internals.ColorMap->SetMinificationFilter(vtkTextureObject::Linear);
    internals.ColorMap->SetMagnificationFilter(vtkTextureObject::Linear);
    internals.ColorMap->SetWrapS(vtkTextureObject::ClampToEdge);
    internals.ColorMap->SetWrapT(vtkTextureObject::ClampToEdge);
    internals.ColorMap->Create2DFromRaw(ColorMapSize, 1, 4, VTK_UNSIGNED_CHAR, colors.data());
    internals.ColorMapTime = table->GetMTime();
  }
  internals.ColorMap->Activate();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetColorUniforms(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("terrainMaximumShownCrossings"))
  {
    program->SetUniformf(
      "terrainMaximumShownCrossings", static_cast<float>(this->MaximumShownCrossings));
  }
  if (program->IsUniformUsed("terrainColorMap"))
  {
    const terrain::HeightCodes& codes = this->Internals->Heights.GetCodes();
    const double* range = this->Internals->ColorRange;
    const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
    const std::array<float, 2> scale{ static_cast<float>(codes.Scale / width),
      static_cast<float>((codes.Offset - range[0]) / width) };
    program->SetUniformi("terrainColorMap", this->Internals->ColorMap->GetTextureUnit());
    program->SetUniform2f("terrainColorScale", scale.data());
  }
}
