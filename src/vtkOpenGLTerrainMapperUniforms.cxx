// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper that sets uniforms, and runs what is computed ahead of
 * drawing.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "render/Driver.h"
#include "vtkTerrainMapperInternals.h"

#include "core/rays/HeightSearch.h"

#include "vtkTerrainBeam.h"
#include "vtkTerrainBeamCS.h"
#include "vtkTerrainColumns.h"
#include "vtkTerrainHeights.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainRay.h"
#include "vtkTerrainSightingCS.h"
#include "vtkTerrainView.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
/// Level of the pyramid in which rays begin at the start of a beam, which lies near the surface.
constexpr int BeamLevel = 2;

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

/// Sets a pixel vector, whose columns take (1, x, y) to its value, as floats; and what float cuts
/// off.
void setVector(terrain::Uniforms& uniforms, const char* name, const terrain::PixelVector& vector,
  const char* lowName = nullptr)
{
  const glm::dmat3 matrix(vector[0], vector[1], vector[2]);
  uniforms.Set(name, glm::mat3(matrix));
  if (lowName)
  {
    uniforms.Set(lowName, glm::mat3(matrix - glm::dmat3(glm::mat3(matrix))));
  }
}
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::UsesCompute(vtkActor* act) const
{
  if (!this->CastsRays(act) || this->ComputeMode == ComputeModes::Off ||
    !terrain::ComputeProgram::IsSupported() ||
    this->Internals->SampleShading) // sightings are one a pixel
  {
    return false;
  }
  return this->ComputeMode == ComputeModes::On || !terrain::IsSoftware();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::UsesBeams(vtkActor* act) const
{
  return this->UseBeams && this->CastsRays(act) && this->Surface == Surfaces::Bilinear &&
    terrain::ComputeProgram::IsSupported() &&
    !this->Internals->Cutting.Block; // walls may lie before the start
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::Compute(vtkRenderer* ren, vtkActor* act,
  terrain::ComputeTexture& texture, const std::string& defines, const std::string& functions,
  int pixels, int components)
{
  vtkInternals& internals = *this->Internals;
  const std::string source = vtkInternals::Extensions + defines + vtkTerrainHeights +
    vtkTerrainColumns + vtkTerrainRay + vtkTerrainView + functions;
  const glm::ivec2 viewport(internals.Viewport.z, internals.Viewport.w);
  const std::string words =
    texture.Fill(static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow()), source,
      (viewport + pixels - 1) / pixels, components,
      [&](terrain::Uniforms& uniforms) { this->SetSurfaceUniforms(uniforms, act); });
  if (!words.empty())
  {
    vtkErrorMacro("A compute shader does not build: " << words);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ComputeBeams(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  if (this->UsesBeams(act))
  {
    this->Compute(ren, act, internals.BeamStarts,
      this->HeightDefines() + vtkInternals::BeamDefine(),
      std::string(vtkTerrainPyramid) + vtkTerrainBeam + vtkTerrainBeamCS, vtkInternals::BeamPixels,
      1);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ComputeSightings(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  internals.Sightings.Finish();
  internals.Sightings.Forget();
  if (this->UsesCompute(act))
  {
    this->Compute(ren, act, internals.Sightings, this->CastDefines() + this->BeamDefines(),
      this->CastFunctions() + vtkTerrainSightingCS, 1, 4);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  terrain::ProgramUniforms uniforms(cellBO.Program);
  this->SetVertexUniforms(uniforms);
  if (this->UsesSurface(act))
  {
    this->SetSurfaceUniforms(uniforms, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetSurfaceUniforms(terrain::Uniforms& uniforms, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  internals.Heights.SetUniforms(uniforms);
  this->SetViewUniforms(uniforms);
  this->SetSearchUniforms(uniforms);
  this->SetClipUniforms(uniforms, act);
  internals.Coloring.SetUniforms(uniforms, internals.Heights, this->VerticalExaggeration);
  vtkProperty* property = act->GetProperty();
  uniforms.Set("terrainLayer", internals.Layer);
  uniforms.Set(
    "terrainCulled", glm::ivec2(property->GetFrontfaceCulling(), property->GetBackfaceCulling()));
  uniforms.Set("terrainFlat", property->GetInterpolation() == VTK_FLAT ? 1 : 0);
  if (uniforms.Uses("terrainTolerance"))
  {
    uniforms.Set("terrainTolerance",
      glm::vec4(terrain::PixelExtent(
        internals.Rays, glm::inverse(internals.ViewToGrid), this->PixelTolerance)));
  }
  if (uniforms.Uses("terrainBeamStarts"))
  {
    uniforms.Set("terrainBeamStarts", internals.BeamStarts.GetTextureUnit());
    // with detail, beams stop farther off, counted in its cells: half of its levels higher
    uniforms.Set("terrainPyramidStart",
      std::min(internals.Heights.GetPyramidTop(), BeamLevel) +
        internals.Heights.GetDetailLevel() / 2);
  }
  if (uniforms.Uses("terrainSightings"))
  {
    uniforms.Set("terrainSightings", internals.Sightings.GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkOpenGLTerrainMapper::ReadCrossings()
{
  terrain::ComputeTexture& sightings = this->Internals->Sightings;
  const glm::ivec2 size = sightings.GetSize();
  const std::vector<glm::vec4> texels = sightings.Read();
  if (texels.empty())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, 1);
  image->AllocateScalars(VTK_INT, 1);
  auto* crossings = static_cast<int*>(image->GetScalarPointer());
  for (const glm::vec4& texel : texels)
  {
    *crossings++ = static_cast<int>(std::abs(texel.w)) - 1;
  }
  return image;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetVertexUniforms(terrain::Uniforms& uniforms)
{
  if (!uniforms.Uses("terrainLift"))
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
  // in the buffer z is (z - shift) * scale; the coarse mesh bounds the heights without their
  // detail: its top goes up, its floor down; the box bounds them with it
  const glm::dvec2 detail = this->Internals->Heights.GetDetailRange();
  const bool lifts = this->Technique != Techniques::Mesh &&
    this->CurrentInput->GetPoints() != this->Internals->Box->GetPoints();
  const double floor =
    this->Internals->Heights.GetGeometry().Origin.z + this->Internals->Heights.GetFloorThreshold();
  const std::array<glm::vec3, 1> lift{ glm::vec3(lifts
      ? glm::dvec3(detail.y * scale, detail.x * scale, (floor - shift) * scale)
      : glm::dvec3(0.0)) };
  uniforms.SetArray("terrainLift", 1, lift.data());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetViewUniforms(terrain::Uniforms& uniforms)
{
  const terrain::PixelRays& rays = this->Internals->Rays;
  setVector(uniforms, "terrainOriginGC", rays.OriginGC, "terrainOriginLowGC");
  setVector(uniforms, "terrainDirectionGC", rays.DirectionGC, "terrainDirectionLowGC");
  setVector(uniforms, "terrainOriginVC", rays.OriginVC);
  setVector(uniforms, "terrainDirectionVC", rays.DirectionVC);
  uniforms.Set("terrainNormalMatrix", glm::mat3(rays.NormalMatrix));
  uniforms.Set("terrainDepthRow", glm::vec4(rays.DepthRow));
  uniforms.Set("terrainWeightRow", glm::vec4(rays.WeightRow));
  uniforms.Set("terrainNear", static_cast<float>(rays.Near));
  uniforms.Set("terrainFar", static_cast<float>(rays.Far));
  uniforms.Set("terrainViewToGrid", glm::mat4(this->Internals->ViewToGrid));
  uniforms.Set("terrainMirrored", this->Internals->KeepsOrientation ? 0 : 1);
  uniforms.Set("terrainViewportOrigin", glm::ivec2(this->Internals->Viewport));
  const std::array<glm::vec3, 2> box{ glm::vec3(this->Internals->BoxMinimumGC),
    glm::vec3(this->Internals->BoxMaximumGC) };
  uniforms.SetArray("terrainBoxMinimum", 1, &box[0]);
  uniforms.SetArray("terrainBoxMaximum", 1, &box[1]);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetSearchUniforms(terrain::Uniforms& uniforms)
{
  if (!uniforms.Uses("terrainSecantSteps"))
  {
    return;
  }
  const terrain::HeightTexture& heights = this->Internals->Heights;
  const terrain::HeightCodes& codes = heights.GetCodes();
  const glm::dvec2 spacing = heights.GetGeometry().Spacing;
  terrain::SearchScene scene;
  scene.Width = heights.GetSize().x;
  scene.Height = heights.GetSize().y;
  scene.MaximumCode = codes.MaximumCode;
  scene.CodesPerCell =
    std::sqrt(spacing.x * spacing.y) / (this->VerticalExaggeration * codes.Scale);

  const terrain::SearchKind kind = searchKind(this->Technique);
  terrain::SearchParameters search = terrain::ChooseSearchParameters(scene, kind);
  search.Steps = this->Steps > 0 ? this->Steps : search.Steps;
  search.LongSteps = this->LongSteps > 0 ? this->LongSteps : search.LongSteps;
  search.SecantSteps = this->SecantSteps > 0 ? this->SecantSteps : search.SecantSteps;
  search.StepLength =
    this->StepLength > 0.0 ? static_cast<float>(this->StepLength) : search.StepLength;
  search = terrain::BoundSearchParameters(search, kind);
  uniforms.Set("terrainSteps", search.Steps);
  uniforms.Set("terrainLongSteps", search.LongSteps);
  uniforms.Set("terrainSecantSteps", search.SecantSteps);
  uniforms.Set("terrainStepLength", search.StepLength);
  uniforms.Set("terrainStepRelief", search.StepRelief);
  uniforms.Set("terrainStepLevel", search.StepLevel());
}
