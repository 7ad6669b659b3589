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

#include "vtkTerrainCast.h"
#include "vtkTerrainColor.h"
#include "vtkTerrainHeights.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainRay.h"
#include "vtkTerrainSearch.h"
#include "vtkTerrainSighting.h"
#include "vtkTerrainSightingCS.h"
#include "vtkTerrainSurface.h"
#include "vtkTerrainTrace.h"
#include "vtkTerrainView.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
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
#include <cstring>
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

/// A pixel vector as floats, followed by what float cuts off.
std::array<glm::vec3, 6> split(const terrain::PixelVector& vector)
{
  std::array<glm::vec3, 6> result{};
  for (int i = 0; i < 3; ++i)
  {
    result[i] = glm::vec3(vector[i]);
    result[i + 3] = glm::vec3(vector[i] - glm::dvec3(result[i]));
  }
  return result;
}

void setVectors(
  vtkTerrainUniforms& uniforms, const char* name, const terrain::PixelVector& vector, int count)
{
  if (uniforms.Uses(name))
  {
    uniforms.SetArray(name, count, split(vector).data());
  }
}
}

//------------------------------------------------------------------------------
std::string vtkOpenGLTerrainMapper::ShaderDefines(vtkActor* act) const
{
  if (!this->UsesSurface(act))
  {
    return {};
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
  if (this->CastsRays(act) && this->Internals->HasSightings)
  {
    defines += "#define TERRAIN_READ_SIGHTINGS\n";
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
std::string vtkOpenGLTerrainMapper::CastFunctions() const
{
  return std::string(
           this->Technique == Techniques::Pyramid ? vtkTerrainPyramid : vtkTerrainSearch) +
    vtkTerrainTrace + vtkTerrainCast;
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::ColorsByHeight() const
{
  return this->ScalarVisibility && !this->Colors && this->Internals->Heights.HasSurface();
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
    substitute(this, fragment, "//VTK::System::Dec",
      "//VTK::System::Dec\n"
      "#extension GL_ARB_gpu_shader_fp64 : enable\n"
      "#extension GL_ARB_conservative_depth : enable\n" +
        defines);
    std::string functions = std::string(vtkTerrainHeights) + vtkTerrainRay + vtkTerrainView;
    if (this->CastsRays(act))
    {
      functions += this->Internals->HasSightings ? vtkTerrainSighting : this->CastFunctions();
    }
    functions += std::string(vtkTerrainSurface) + vtkTerrainColor;
    substitute(this, fragment, "//VTK::Camera::Dec", "//VTK::Camera::Dec\n" + functions);
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (!defines.empty())
  {
    // the surface that is hit decides what is its front, not the proxy
    std::string source = shaders[vtkShader::Fragment]->GetSource();
    vtkShaderProgram::Substitute(source, "gl_FrontFacing == false", "!terrainPoint.front");
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
      "TerrainSurface terrainPoint = terrainSeen(gl_FragCoord.xy, vertexVC);\n"
      "  if (!terrainPoint.found) { discard; }\n"
      "  vertexVC = terrainPoint.positionVC;\n"
      "  gl_FragDepth = terrainFragmentDepth(vertexVC, gl_FragCoord.z);\n");
  }
  else if (this->UsesSurface(act))
  {
    substitute(this, fragment, "//VTK::Depth::Impl",
      "TerrainSurface terrainPoint = terrainBelow(vertexVC, gl_FrontFacing);\n"
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
  vtkTerrainProgramUniforms uniforms(cellBO.Program);
  this->SetVertexUniforms(uniforms);
  if (this->UsesSurface(act))
  {
    this->Internals->Heights.SetUniforms(uniforms);
    this->SetViewUniforms(uniforms);
    this->SetSearchUniforms(uniforms);
    this->SetClipUniforms(uniforms, act);
    this->SetColorUniforms(uniforms);
    if (uniforms.Uses("terrainSightings"))
    {
      uniforms.Set("terrainSightings", this->Internals->Sightings->GetTextureUnit());
      uniforms.Set("terrainViewportOrigin", glm::ivec2(this->Internals->Viewport));
      uniforms.Set("terrainCells", this->Internals->Heights.GetSize() - 1);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::UsesCompute(vtkActor* act) const
{
  if (!this->CastsRays(act) || this->Technique != Techniques::Pyramid ||
    this->ComputeMode == ComputeModes::Off || !vtkTerrainComputeProgram::IsSupported())
  {
    return false;
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool software = renderer && std::strstr(renderer, "llvmpipe");
  return this->ComputeMode == ComputeModes::On || !software;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateSightings(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  internals.HasSightings = false;
  if (!this->UsesCompute(act))
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
  const std::string source = "#extension GL_ARB_gpu_shader_fp64 : enable\n" +
    this->ShaderDefines(act) + vtkTerrainHeights + vtkTerrainRay + vtkTerrainView +
    this->CastFunctions() + vtkTerrainSightingCS;
  if (internals.SightingProgramBuiltWith != source || !internals.SightingProgram.IsBuilt())
  {
    internals.SightingProgramBuiltWith = source;
    const std::string words = internals.SightingProgram.Build(source);
    if (!words.empty())
    {
      vtkErrorMacro("The compute shader does not build: " << words);
    }
  }
  if (!internals.SightingProgram.IsBuilt())
  {
    return;
  }
  const int width = internals.Viewport.z;
  const int height = internals.Viewport.w;
  vtkTextureObject* texture = internals.Sightings;
  if (texture->GetContext() != window || static_cast<int>(texture->GetWidth()) != width ||
    static_cast<int>(texture->GetHeight()) != height)
  {
    texture->ReleaseGraphicsResources(texture->GetContext());
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Allocate2D(
      static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT);
  }
  window->GetShaderCache()->ReleaseCurrentShader();
  internals.SightingProgram.Use();
  internals.Heights.SetUniforms(internals.SightingProgram);
  this->SetViewUniforms(internals.SightingProgram);
  this->SetClipUniforms(internals.SightingProgram, act);
  internals.SightingProgram.Set("terrainViewportOrigin", glm::ivec2(internals.Viewport));
  texture->Activate();
  glBindImageTexture(0, texture->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  glDispatchCompute(static_cast<GLuint>((width + 7) / 8), static_cast<GLuint>((height + 7) / 8), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  glUseProgram(0);
  internals.HasSightings = true;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetVertexUniforms(vtkTerrainUniforms& uniforms)
{
  if (!uniforms.Uses("terrainExaggeration"))
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
  uniforms.Set("terrainExaggeration",
    glm::vec2(glm::dvec2(factor, (1.0 - factor) * (origin - shift) * scale)));
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetViewUniforms(vtkTerrainUniforms& uniforms)
{
  const terrain::PixelRays& rays = this->Internals->Rays;
  setVectors(uniforms, "terrainOriginGC", rays.OriginGC, 6);
  setVectors(uniforms, "terrainDirectionGC", rays.DirectionGC, 6);
  setVectors(uniforms, "terrainOriginVC", rays.OriginVC, 3);
  setVectors(uniforms, "terrainDirectionVC", rays.DirectionVC, 3);
  uniforms.Set("terrainNormalMatrix", glm::mat3(rays.NormalMatrix));
  uniforms.Set("terrainDepthRow", glm::vec4(rays.DepthRow));
  uniforms.Set("terrainWeightRow", glm::vec4(rays.WeightRow));
  uniforms.Set("terrainNear", static_cast<float>(rays.Near));
  uniforms.Set("terrainFar", static_cast<float>(rays.Far));
  uniforms.Set("terrainViewToGrid", glm::mat4(this->Internals->ViewToGrid));
  const std::array<glm::vec3, 2> box{ glm::vec3(this->Internals->BoxMinimumGC),
    glm::vec3(this->Internals->BoxMaximumGC) };
  uniforms.SetArray("terrainBoxMinimum", 1, &box[0]);
  uniforms.SetArray("terrainBoxMaximum", 1, &box[1]);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetSearchUniforms(vtkTerrainUniforms& uniforms)
{
  if (!uniforms.Uses("terrainSecantSteps"))
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
  uniforms.Set("terrainSteps", search.Steps);
  uniforms.Set("terrainLongSteps", search.LongSteps);
  uniforms.Set("terrainSecantSteps", search.SecantSteps);
  uniforms.Set("terrainStepLength", search.StepLength);
  uniforms.Set("terrainStepRelief", search.StepRelief);
  uniforms.Set("terrainLargestGap", search.LargestGap);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetClipUniforms(vtkTerrainUniforms& uniforms, vtkActor* act)
{
  if (!uniforms.Uses("terrainClipPlaneCount"))
  {
    return;
  }
  const int count = std::min(this->GetNumberOfClippingPlanes(), 6);
  std::array<glm::vec4, 6> planes{};
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(act->GetMatrix(), i, plane);
    const glm::dvec4 planeVC =
      glm::dvec4(plane[0], plane[1], plane[2], plane[3]) * this->Internals->ViewToModel;
    planes[i] = glm::vec4(planeVC / glm::length(glm::dvec3(planeVC)));
  }
  uniforms.Set("terrainClipPlaneCount", count);
  uniforms.SetArray("terrainClipPlanesVC", 6, planes.data());
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
    std::vector<unsigned char> colors(std::size_t{ 4 } * ColorMapSize);
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
void vtkOpenGLTerrainMapper::SetColorUniforms(vtkTerrainUniforms& uniforms)
{
  if (uniforms.Uses("terrainMaximumShownCrossings"))
  {
    uniforms.Set("terrainMaximumShownCrossings", static_cast<float>(this->MaximumShownCrossings));
  }
  if (uniforms.Uses("terrainColorMap"))
  {
    const terrain::HeightCodes& codes = this->Internals->Heights.GetCodes();
    const double* range = this->Internals->ColorRange;
    const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
    uniforms.Set("terrainColorMap", this->Internals->ColorMap->GetTextureUnit());
    uniforms.Set("terrainColorScale",
      glm::vec2(glm::dvec2(codes.Scale / width, (codes.Offset - range[0]) / width)));
  }
}
