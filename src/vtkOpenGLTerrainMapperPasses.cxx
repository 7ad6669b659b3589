// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper for what draws the surface more than once or asks for more
 * than colours: translucency, render passes, depth offsets, samples, selection.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "render/Driver.h"
#include "vtkTerrainMapperInternals.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetMaximumLayers(int layers)
{
  if (layers < 1)
  {
    vtkErrorMacro("At least one layer must be drawn, not " << layers);
    return;
  }
  this->Internals->MaximumLayers = layers;
  this->UniformModified();
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::GetMaximumLayers() const
{
  return this->Internals->MaximumLayers;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetSampleShading(bool shade)
{
  this->Internals->SampleShading = shade;
  this->UniformModified();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetSampleShading() const
{
  return this->Internals->SampleShading;
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::LayersToDraw(vtkRenderer* ren, vtkActor* act)
{
  const bool several = this->Technique == Techniques::Pyramid && !ren->GetSelector() &&
    act->HasTranslucentPolygonalGeometry();
  return several ? this->Internals->MaximumLayers : 1;
}

//------------------------------------------------------------------------------
// From the last layer to the first, so that blending has the order that it needs.
void vtkOpenGLTerrainMapper::DrawLayers(vtkRenderer* ren, vtkActor* act)
{
  const bool samples = this->Internals->SampleShading;
  if (samples)
  {
    glEnable(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
  }
  for (int layer = this->LayersToDraw(ren, act) - 1; layer >= 0; --layer)
  {
    this->Internals->Layer = layer;
    this->ComputeSightings(ren, act);
    this->Superclass::RenderPieceDraw(ren, act);
  }
  if (samples)
  {
    glDisable(GL_SAMPLE_SHADING);
  }
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::ShiftsDepth(vtkRenderer* ren, vtkActor* act)
{
  float factor = 0.0f;
  float offset = 0.0f;
  this->GetCoincidentParameters(ren, act, factor, offset);
  return factor != 0.0f || offset != 0.0f;
}

//------------------------------------------------------------------------------
// Replace: it is the depth of the surface that is shifted.
void vtkOpenGLTerrainMapper::ReplaceShaderCoincidentOffset(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->UsesSurface(act))
  {
    this->Superclass::ReplaceShaderCoincidentOffset(shaders, ren, act);
    return;
  }
  if (this->ShiftsDepth(ren, act))
  {
    vtkShader* fragment = shaders[vtkShader::Fragment];
    vtkTerrainSubstitute(this, fragment, "//VTK::Coincident::Dec",
      "uniform float cOffset;\nuniform float cFactor; // stays 0 before VTK 9.3\n");
    vtkTerrainSubstitute(this, fragment, "//VTK::Depth::Impl",
      "//VTK::Depth::Impl\n"
      "  gl_FragDepth = terrainDepth(vertexVC) +\n"
      "    cFactor * terrainDepthSlope(gl_FragCoord.xy, terrainPoint) + cOffset / 65000.0;\n");
  }
}

//------------------------------------------------------------------------------
// Render passes that read the fragment's depth mean that of the surface.
void vtkOpenGLTerrainMapper::FollowDepth(ShaderMap shaders, vtkActor* act)
{
  if (this->CastsRays(act))
  {
    vtkShader* fragment = shaders[vtkShader::Fragment];
    std::string source = fragment->GetSource();
    vtkShaderProgram::Substitute(source, "gl_FragCoord.z", "gl_FragDepth");
    vtkShaderProgram::Substitute(
      source, "gl_FragCoord.w", "(1.0 / dot(terrainWeightRow, vertexVC))");
    fragment->SetSource(source);
  }
}

//------------------------------------------------------------------------------
// vtkValuePass in its floating-point mode means values of the surface, not of the proxy.
void vtkOpenGLTerrainMapper::FollowValues(ShaderMap shaders)
{
  vtkShader* fragment = shaders[vtkShader::Fragment];
  std::string source = fragment->GetSource();
  if (this->Internals->Coloring.Paints() &&
    vtkShaderProgram::Substitute(source, "in float dataValue;", "float dataValue;"))
  {
    // of points, or of cells
    if (vtkShaderProgram::Substitute(source, "vec4(vec3(dataValue), 1.0)",
          "vec4(vec3(terrainShownValue(terrainPoint)), 1.0)") ||
      vtkShaderProgram::Substitute(source,
        "texelFetchBuffer(textureF, gl_PrimitiveID +\n    PrimitiveIDOffset)",
        "vec4(terrainShownValue(terrainPoint))"))
    {
      fragment->SetSource(source);
    }
    else
    {
      vtkErrorMacro("The shader of vtkValuePass has changed: its values are those of the proxy");
    }
  }
}

//------------------------------------------------------------------------------
// The edges of a proxy are not the surface's.
bool vtkOpenGLTerrainMapper::DrawingEdges(vtkRenderer* ren, vtkActor* act)
{
  return !this->CastsRays(act) && this->Superclass::DrawingEdges(ren, act);
}

//------------------------------------------------------------------------------
// Extend: with rays, identifiers are those of the grid.
void vtkOpenGLTerrainMapper::ReplaceShaderPicking(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  const int pass = this->LastSelectionState;
  const bool high =
    pass == vtkHardwareSelector::CELL_ID_HIGH24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  const bool cells =
    pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool points =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  if (this->CastsRays(act) && (cells || points))
  {
    vtkTerrainSubstitute(this, shaders[vtkShader::Fragment], "//VTK::Picking::Impl",
      std::string("int terrainId = ") +
        (cells ? "terrainCellId(terrainPoint);\n" : "terrainSampleId(terrainPoint);\n") +
        "  gl_FragData[0] = terrainIdColor(terrainId" + (high ? " >> 24);\n" : ");\n"));
  }
  this->Superclass::ReplaceShaderPicking(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* act)
{
  if (!this->CastsRays(act))
  {
    this->Superclass::UpdateMaximumPointCellIds(ren, act);
    return;
  }
  const int* size = this->GetHeights()->GetDimensions();
  ren->GetSelector()->UpdateMaximumPointId(vtkIdType{ size[0] } * size[1] - 1);
  ren->GetSelector()->UpdateMaximumCellId(vtkIdType{ size[0] - 1 } * (size[1] - 1) - 1);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !this->CastsRays(actor))
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, offsets, prop);
  }
}
