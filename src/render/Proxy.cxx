// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Proxy.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

namespace terrain
{
namespace
{
/// Triangles of a box, outward, from points numbered x + 2 y + 4 z.
constexpr vtkIdType kBoxTriangles[12][3] = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 },
  { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 },
  { 1, 7, 5 } };
/// Cells by which rounding may not put a ray beside the grid.
constexpr double kBeside = 1e-3;

void BuildBox(vtkPolyData* box, const std::array<glm::dvec3, 2>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(corners[i & 1].x, corners[(i >> 1) & 1].y, corners[i >> 2].z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : kBoxTriangles)
  {
    triangles->InsertNextCell(3, triangle);
  }
  box->Initialize();
  box->SetPoints(points);
  box->SetPolys(triangles);
}

/// The buffer of positions, if it is shifted and scaled.
vtkOpenGLVertexBufferObject* ShiftedBuffer(vtkOpenGLVertexBufferObjectGroup* buffers)
{
  vtkOpenGLVertexBufferObject* vertices = buffers->GetVBO("vertexMC");
  return vertices && vertices->GetCoordShiftAndScaleEnabled() ? vertices : nullptr;
}
}

//------------------------------------------------------------------------------
glm::dmat4 ModelFromBuffer(vtkOpenGLVertexBufferObjectGroup* buffers)
{
  glm::dmat4 matrix(1.0);
  if (vtkOpenGLVertexBufferObject* vertices = ShiftedBuffer(buffers))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      matrix[axis][axis] = 1.0 / vertices->GetScale()[axis];
      matrix[3][axis] = vertices->GetShift()[axis];
    }
  }
  return matrix;
}

//------------------------------------------------------------------------------
void Proxy::Update(const GridGeometry& geometry, const HeightCodes& codes, const glm::ivec2& size,
  double lowestHeight)
{
  const glm::dvec2 last(size - 1);
  const double lowest = codes.ToCode(lowestHeight);
  const double margin = 1e-3 * std::max(codes.MaximumCode - lowest, 1e-3);
  this->Bounds = { glm::dvec3(-kBeside, -kBeside, lowest - margin),
    glm::dvec3(last + kBeside, codes.MaximumCode + margin) };
  const std::array<glm::dvec3, 2> corners{ geometry.ToModel(
                                             { 0.0, 0.0 }, codes.ToHeight(lowest - margin)),
    geometry.ToModel(last, codes.ToHeight(codes.MaximumCode + margin)) };
  if (this->CornersMC != corners)
  {
    this->CornersMC = corners;
    BuildBox(this->Box, corners);
  }
}

//------------------------------------------------------------------------------
void Proxy::Update(const BoxGC& boxMC)
{
  if (this->CornersMC != boxMC)
  {
    this->CornersMC = boxMC;
    BuildBox(this->Box, boxMC);
  }
}

//------------------------------------------------------------------------------
void Proxy::Clear()
{
  if (this->Box->GetNumberOfPoints() > 0)
  {
    this->Box->Initialize();
    this->CornersMC = {};
  }
}

//------------------------------------------------------------------------------
vtkPolyData* Proxy::WithTextureCoordinates(vtkPolyData* mesh)
{
  if (mesh->GetPointData()->GetTCoords())
  {
    return mesh;
  }
  if (this->TexturedTime != mesh->GetMTime())
  {
    this->TexturedTime = mesh->GetMTime();
    vtkNew<vtkFloatArray> positions;
    positions->SetName("TextureCoordinates");
    positions->SetNumberOfComponents(2);
    positions->SetNumberOfTuples(mesh->GetNumberOfPoints());
    positions->Fill(0.0); // the shader knows better
    this->Textured->ShallowCopy(mesh);
    this->Textured->GetPointData()->SetTCoords(positions);
  }
  return this->Textured;
}
}
