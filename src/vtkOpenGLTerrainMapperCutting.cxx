// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of vtkOpenGLTerrainMapper that cuts the terrain: rectangles, blocks, clipping planes.
 */
#include "vtkOpenGLTerrainMapper.h"

#include "render/Uniforms.h"
#include "vtkTerrainMapperInternals.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkShader.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr int MaximumMapperPlanes = 6; // VTK's

/// Triangles of a box, outward, from points numbered x + 2 y + 4 z.
constexpr vtkIdType BoxTriangles[12][3] = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 },
  { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 },
  { 1, 7, 5 } };

void buildBox(vtkPolyData* box, const std::array<glm::dvec3, 2>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(corners[i & 1].x, corners[(i >> 1) & 1].y, corners[i >> 2].z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : BoxTriangles)
  {
    triangles->InsertNextCell(3, triangle);
  }
  box->Initialize();
  box->SetPoints(points);
  box->SetPolys(triangles);
}
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetExtract(const int first[2], const int last[2])
{
  if (first[0] >= last[0] || first[1] >= last[1])
  {
    vtkErrorMacro("An extract must have at least two samples each way");
    return;
  }
  terrain::Cutting& cutting = this->Internals->Cutting;
  cutting.Extracts = true;
  cutting.First = { first[0], first[1] };
  cutting.Last = { last[0], last[1] };
  this->UniformModified();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ExtractAll()
{
  this->Internals->Cutting.Extracts = false;
  this->UniformModified();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetBlock(bool show)
{
  this->Internals->Cutting.Block = show;
  this->UniformModified();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetBlock() const
{
  return this->Internals->Cutting.Block;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetBlockBase(double height)
{
  if (!std::isfinite(height))
  {
    vtkErrorMacro("The base of the block must be a number");
    return;
  }
  this->Internals->Cutting.BlockBase = height;
  this->UniformModified();
}

//------------------------------------------------------------------------------
double vtkOpenGLTerrainMapper::GetBlockBase() const
{
  return this->Internals->Cutting.BlockBase;
}

//------------------------------------------------------------------------------
terrain::SampleRectangle vtkOpenGLTerrainMapper::DrawnRectangle() const
{
  const terrain::HeightTexture& heights = this->Internals->Heights;
  return this->Internals->Cutting.Drawn(
    heights.GetSize(), heights.HasDetail() ? this->DetailCells : 1);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateBox()
{
  vtkInternals& internals = *this->Internals;
  if (!internals.Why.empty())
  {
    if (internals.Box->GetNumberOfPoints() > 0)
    {
      internals.Box->Initialize();
      internals.BoxCorners = {};
    }
    return;
  }
  const terrain::HeightCodes& codes = internals.Heights.GetCodes();
  const glm::dvec2 last = internals.Heights.GetSize() - 1;
  const double lowest = codes.ToCode(internals.Cutting.Lowest(codes.ToHeight(0.0)));
  const double margin = 1e-3 * std::max(codes.MaximumCode - lowest, 1e-3);
  const double beside = 1e-3; // cells by which rounding may not put a ray beside the grid
  internals.BoxMinimumGC = glm::dvec3(-beside, -beside, lowest - margin);
  internals.BoxMaximumGC = glm::dvec3(last + beside, codes.MaximumCode + margin);
  const terrain::GridGeometry& geometry = internals.Heights.GetGeometry();
  const std::array<glm::dvec3, 2> corners{ geometry.ToModel(
                                             { 0.0, 0.0 }, codes.ToHeight(lowest - margin)),
    geometry.ToModel(last, codes.ToHeight(codes.MaximumCode + margin)) };
  if (internals.BoxCorners != corners)
  {
    internals.BoxCorners = corners;
    buildBox(internals.Box, corners);
  }
}

//------------------------------------------------------------------------------
// Replace for rays: they are clipped before they are cast, so that the cut shows what lies behind.
// Replace for meshes: planes cut what is exaggerated, not what is in the buffer.
void vtkOpenGLTerrainMapper::ReplaceShaderClip(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->UsesSurface(act))
  {
    this->Superclass::ReplaceShaderClip(shaders, ren, act);
    return;
  }
  if (this->GetNumberOfClippingPlanes() > MaximumMapperPlanes)
  {
    vtkErrorMacro("At most " << MaximumMapperPlanes << " clipping planes cut the terrain, not "
                             << this->GetNumberOfClippingPlanes());
  }
  if (!this->CastsRays(act))
  {
    vtkTerrainSubstitute(this, shaders[vtkShader::Fragment], "//VTK::Clip::Impl",
      "if (terrainIsClipped(vertexVC)) { discard; }\n");
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetClipUniforms(terrain::Uniforms& uniforms, vtkActor* act)
{
  if (!uniforms.Uses("terrainClipPlaneCount") && !uniforms.Uses("terrainClipPlanesVC"))
  {
    return;
  }
  std::array<glm::vec4, terrain::MaximumClipPlanes> planes{};
  int count = 0;
  auto add = [&](const glm::dvec4& planeVC)
  { planes[count++] = glm::vec4(planeVC / glm::length(glm::dvec3(planeVC))); };
  for (int i = 0; i < std::min(this->GetNumberOfClippingPlanes(), MaximumMapperPlanes); ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(act->GetMatrix(), i, plane);
    add(glm::dvec4(plane[0], plane[1], plane[2], plane[3]) * this->Internals->ViewToModel);
  }
  const terrain::Cutting& cutting = this->Internals->Cutting;
  const terrain::HeightTexture& heights = this->Internals->Heights;
  for (const glm::dvec4& plane :
    cutting.PlanesGC(this->DrawnRectangle(), heights.GetCodes().ToCode(cutting.BlockBase)))
  {
    add(plane * this->Internals->ViewToGrid);
  }
  uniforms.Set("terrainClipPlaneCount", count);
  uniforms.SetArray("terrainClipPlanesVC", terrain::MaximumClipPlanes, planes.data());
}
