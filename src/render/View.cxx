// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/View.h"

#include "core/surface/Cutting.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace terrain
{
namespace
{
/// Sets a pixel vector, whose columns take (1, x, y) to its value, as floats; and what float cuts
/// off.
void SetVector(
  Uniforms& uniforms, const char* name, const PixelVector& vector, const char* lowName = nullptr)
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
glm::dmat4 ToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
glm::dmat4 ModelFromGrid(const GridGeometry& geometry, const HeightCodes& codes)
{
  glm::dmat4 heightsFromCodes(1.0);
  heightsFromCodes[2][2] = codes.Scale;
  heightsFromCodes[3][2] = codes.Offset;
  return geometry.GridToModel() * heightsFromCodes;
}

//------------------------------------------------------------------------------
CameraMatrices::CameraMatrices(vtkRenderer* renderer)
{
  vtkMatrix4x4* worldToView = nullptr;
  vtkMatrix4x4* viewToDisplay = nullptr;
  vtkMatrix4x4* worldToDisplay = nullptr;
  vtkMatrix3x3* normals = nullptr;
  static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, viewToDisplay, worldToDisplay);
  // the camera keeps them transposed, for OpenGL
  this->ViewFromWorld = glm::transpose(ToGlm(worldToView));
  this->DisplayFromView = glm::transpose(ToGlm(viewToDisplay));
}

//------------------------------------------------------------------------------
void View::Update(
  vtkRenderer* renderer, vtkActor* actor, const glm::dmat4& modelFromGrid, const BoxGC& box)
{
  const CameraMatrices camera(renderer);
  const glm::dmat4 viewFromModel = camera.ViewFromWorld * ToGlm(actor->GetMatrix());
  const glm::dmat4 viewFromGrid = viewFromModel * modelFromGrid;
  std::array<int, 4> viewport{};
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  this->Viewport = { viewport[0], viewport[1], viewport[2], viewport[3] };
  const glm::dvec4 pixels(this->Viewport);
  this->Rays = MakePixelRays(viewFromGrid, camera.DisplayFromView, pixels);
  this->GridFromView = glm::inverse(viewFromGrid);
  this->DisplayFromGrid = camera.DisplayFromView * viewFromGrid;
  this->ModelFromView = glm::inverse(viewFromModel);
  this->HeightOfCode = modelFromGrid[2][2];
  this->OrientationKept = glm::determinant(glm::dmat3(viewFromGrid)) > 0.0;
  this->Box = box;
  const auto nearBounds = NearBoundsGC(this->Rays, pixels);
  this->EyeInBox = glm::all(glm::lessThanEqual(nearBounds[0], box[1])) &&
    glm::all(glm::greaterThanEqual(nearBounds[1], box[0]));
}

//------------------------------------------------------------------------------
void View::SetClippingPlanes(
  vtkMapper* mapper, vtkActor* actor, const std::vector<glm::dvec4>& planesGC)
{
  this->PlanesVC.clear();
  const auto add = [this](const glm::dvec4& planeVC)
  { this->PlanesVC.emplace_back(planeVC / glm::length(glm::dvec3(planeVC))); };
  for (int i = 0; i < std::min(mapper->GetNumberOfClippingPlanes(), MostMapperPlanes); ++i)
  {
    double plane[4];
    mapper->GetClippingPlaneInDataCoords(actor->GetMatrix(), i, plane);
    add(glm::dvec4(plane[0], plane[1], plane[2], plane[3]) * this->ModelFromView);
  }
  for (const glm::dvec4& plane : planesGC)
  {
    add(plane * this->GridFromView);
  }
}

//------------------------------------------------------------------------------
void View::SetUniforms(Uniforms& uniforms) const
{
  SetVector(uniforms, "terrainOriginGC", this->Rays.OriginGC, "terrainOriginLowGC");
  SetVector(uniforms, "terrainDirectionGC", this->Rays.DirectionGC, "terrainDirectionLowGC");
  SetVector(uniforms, "terrainOriginVC", this->Rays.OriginVC);
  SetVector(uniforms, "terrainDirectionVC", this->Rays.DirectionVC);
  uniforms.Set("terrainNormalMatrix", glm::mat3(this->Rays.NormalMatrix));
  uniforms.Set("terrainDepthRow", glm::vec4(this->Rays.DepthRow));
  uniforms.Set("terrainWeightRow", glm::vec4(this->Rays.WeightRow));
  uniforms.Set("terrainBegin", static_cast<float>(this->Rays.Begin));
  uniforms.Set("terrainFar", static_cast<float>(this->Rays.Far));
  uniforms.Set("terrainViewToGrid", glm::mat4(this->GridFromView));
  uniforms.Set("terrainMirrored", this->OrientationKept ? 0 : 1);
  uniforms.Set("terrainViewportOrigin", glm::ivec2(this->Viewport));
  const std::array<glm::vec3, 2> box{ glm::vec3(this->Box[0]), glm::vec3(this->Box[1]) };
  uniforms.SetArray("terrainBoxMinimum", 1, &box[0]);
  uniforms.SetArray("terrainBoxMaximum", 1, &box[1]);
  if (uniforms.Uses("terrainClipPlaneCount") || uniforms.Uses("terrainClipPlanesVC"))
  {
    std::array<glm::vec4, kMaximumClipPlanes> planes{};
    std::copy(this->PlanesVC.begin(), this->PlanesVC.end(), planes.begin());
    uniforms.Set("terrainClipPlaneCount", static_cast<int>(this->PlanesVC.size()));
    uniforms.SetArray("terrainClipPlanesVC", kMaximumClipPlanes, planes.data());
  }
}

//------------------------------------------------------------------------------
TileView View::GetTileView(double pixels) const
{
  const glm::dmat4 viewFromGrid = glm::inverse(this->GridFromView);
  const glm::dmat4 rows = glm::transpose(this->DisplayFromGrid);
  TileView view;
  for (int axis = 0; axis < 3; ++axis)
  {
    view.Planes.push_back(rows[3] + rows[axis]);
    view.Planes.push_back(rows[3] - rows[axis]);
  }
  const glm::dvec4 eye = this->GridFromView * glm::dvec4(0.0, 0.0, 0.0, 1.0);
  view.Eye = glm::dvec3(eye) / eye.w;
  view.Forward = -glm::dvec3(glm::transpose(viewFromGrid)[2]);
  view.Tolerance = PixelExtent(this->Rays, viewFromGrid, pixels);
  return view;
}

//------------------------------------------------------------------------------
void View::SetTolerance(Uniforms& uniforms, double pixels) const
{
  if (uniforms.Uses("terrainTolerance"))
  {
    uniforms.Set("terrainTolerance",
      glm::vec4(PixelExtent(this->Rays, glm::inverse(this->GridFromView), pixels)));
  }
}
}
