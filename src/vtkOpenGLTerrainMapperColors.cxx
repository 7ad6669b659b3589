// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper that colours the surface.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "vtkTerrainMapperInternals.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <utility>

//------------------------------------------------------------------------------
#define vtkTerrainColoringMacro(Name, Type, Member, Condition, Demand)                             \
  void vtkOpenGLTerrainMapper::Set##Name(Type value)                                               \
  {                                                                                                \
    if (!(Condition))                                                                              \
    {                                                                                              \
      vtkErrorMacro(#Name " must be " Demand);                                                     \
      return;                                                                                      \
    }                                                                                              \
    if (this->Internals->Coloring.Member != value)                                                 \
    {                                                                                              \
      this->Internals->Coloring.Member = value;                                                    \
      this->UniformModified();                                                                     \
    }                                                                                              \
  }                                                                                                \
  Type vtkOpenGLTerrainMapper::Get##Name() const                                                   \
  {                                                                                                \
    return this->Internals->Coloring.Member;                                                       \
  }

vtkTerrainColoringMacro(ShowCrossings, bool, ShowCrossings, true, "");
vtkTerrainColoringMacro(MaximumShownCrossings, int, MaximumShownCrossings, value > 0, "above 0");
vtkTerrainColoringMacro(Contours, bool, Contours, true, "");
vtkTerrainColoringMacro(ContourInterval, double, ContourInterval, value > 0.0, "above 0");
vtkTerrainColoringMacro(ContourWidth, double, ContourWidth, value >= 0.0, "0 or more");
vtkTerrainColoringMacro(Hillshade, bool, Hillshade, true, "");
vtkTerrainColoringMacro(
  HillshadeAzimuth, double, HillshadeAzimuth, std::isfinite(value), "a number");
vtkTerrainColoringMacro(
  HillshadeAltitude, double, HillshadeAltitude, std::isfinite(value), "a number");

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetColorSource(ColorSources source)
{
  if (this->Internals->Coloring.Source != source)
  {
    this->Internals->Coloring.Source = source;
    this->UniformModified();
  }
}

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper::ColorSources vtkOpenGLTerrainMapper::GetColorSource() const
{
  return this->Internals->Coloring.Source;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetContourColor(double red, double green, double blue, double opacity)
{
  this->Internals->Coloring.ContourColor = { red, green, blue, opacity };
  this->UniformModified();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetDrape(vtkImageData* picture, const double bounds[4])
{
  if (picture && (!(bounds[0] < bounds[1]) || !(bounds[2] < bounds[3])))
  {
    vtkErrorMacro("A drape must lie between bounds west < east and south < north");
    return;
  }
  this->Internals->Coloring.Drape = picture;
  if (picture)
  {
    std::copy(bounds, bounds + 4, this->Internals->Coloring.DrapeBounds.begin());
  }
  this->UniformModified();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetDrape(vtkImageData* picture)
{
  double bounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  for (std::size_t axis = 0; picture && axis < 2; ++axis)
  {
    const int* extent = picture->GetExtent() + 2 * axis;
    const double origin = picture->GetOrigin()[axis];
    const double spacing = picture->GetSpacing()[axis];
    bounds[2 * axis] = origin + (extent[0] - 0.5) * spacing;
    bounds[2 * axis + 1] = origin + (extent[1] + 0.5) * spacing;
  }
  this->SetDrape(picture, bounds);
}

//------------------------------------------------------------------------------
vtkImageData* vtkOpenGLTerrainMapper::GetDrape() const
{
  return this->Internals->Coloring.Drape;
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::HasTranslucentPolygonalGeometry()
{
  return terrain::Coloring::IsTranslucent(this) ||
    this->Superclass::HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateColors(vtkRenderer* ren)
{
  terrain::Coloring& coloring = this->Internals->Coloring;
  const std::string words =
    coloring.Update(this, static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow()));
  if (!words.empty())
  {
    vtkErrorMacro(<< words);
  }
  coloring.Activate();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::IsTextured(vtkActor* act)
{
  return this->UsesSurface(act) && this->HaveTextures(act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateProxy(vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  if (this->CastsRays(act))
  {
    this->CurrentInput = internals.Box;
  }
  if (this->IsTextured(act) && !this->CurrentInput->GetPointData()->GetTCoords())
  {
    const vtkMTimeType time = this->CurrentInput->GetMTime();
    if (internals.TexturedTime != time)
    {
      internals.TexturedTime = time;
      vtkNew<vtkFloatArray> positions;
      positions->SetName("TextureCoordinates");
      positions->SetNumberOfComponents(2);
      positions->SetNumberOfTuples(this->CurrentInput->GetNumberOfPoints());
      positions->Fill(0.0); // the shader knows better
      internals.TexturedProxy->ShallowCopy(this->CurrentInput);
      internals.TexturedProxy->GetPointData()->SetTCoords(positions);
    }
    this->CurrentInput = internals.TexturedProxy;
  }
}

//------------------------------------------------------------------------------
// Extend: the colours of VTK's code are painted over where the surface has its own.
void vtkOpenGLTerrainMapper::ReplaceShaderColor(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->UsesSurface(act) && this->Internals->Coloring.Paints())
  {
    vtkTerrainSubstitute(this, shaders[vtkShader::Fragment], "//VTK::Color::Impl",
      "//VTK::Color::Impl\n"
      "  TerrainPaint terrainPaint = terrainPaintSurface(gl_FragCoord.xy, terrainPoint);\n"
      "  ambientColor = ambientIntensity * terrainPaint.add + terrainPaint.keep * ambientColor;\n"
      "  diffuseColor = diffuseIntensity * terrainPaint.add + terrainPaint.keep * diffuseColor;\n"
      "  opacity *= terrainPaint.alpha;\n");
  }
  this->Superclass::ReplaceShaderColor(shaders, ren, act);
}

//------------------------------------------------------------------------------
// Extend: texture coordinates are the surface's, not the proxy's.
void vtkOpenGLTerrainMapper::ReplaceShaderTCoord(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderTCoord(shaders, ren, act);
  if (this->IsTextured(act))
  {
    vtkShader* fragment = shaders[vtkShader::Fragment];
    vtkTerrainSubstitute(this, fragment, "in vec2 tcoordVCVSOutput;", "vec2 tcoordVCVSOutput;\n");
    std::string source = fragment->GetSource();
    // neighbouring pixels may show far places: the surface tells how its texture changes
    vtkShaderProgram::Substitute(source, "texture(actortexture, tcoordVCVSOutput)",
      "textureGrad(actortexture, tcoordVCVSOutput, terrainTextureMove[0], terrainTextureMove[1])");
    vtkShaderProgram::Substitute(source, "gl_FrontFacing == true ||", "terrainPoint.front ||");
    fragment->SetSource(source);
  }
}
