// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/MeshOutput.h"

#include "data/ImageHeights.h"
#include "data/PointArrays.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

namespace terrain
{
namespace
{
/// Where a point of the output comes from.
struct MeshPoint
{
  glm::ivec2 Sample{ 0, 0 };
  bool IsOnFloor = false;
  /// Of the part it belongs to; unused on the surface, whose normals follow from heights.
  glm::dvec3 Normal{ 0.0, 0.0, 0.0 };
};

/// Points and triangles of the surface, and of walls and floor.
class MeshParts
{
public:
  MeshParts(const GridMesh& mesh, const GridGeometry& geometry)
    : Mesh(mesh)
    , Geometry(geometry)
  {
    for (const glm::ivec2& sample : mesh.Vertices)
    {
      this->Points.push_back({ sample, false, {} });
    }
    this->SurfacePoints = this->Points.size();
    this->Triangles.assign(mesh.Triangles.begin(), mesh.Triangles.end());
  }

  /// Closes the surface. Parts have points of their own if they have normals of their own.
  void AddBlock(bool sharp)
  {
    const std::vector<glm::ivec2> border = FindBorderEdges(this->Mesh);
    const auto floor = static_cast<vtkIdType>(this->Points.size());
    for (const glm::ivec2& sample : this->Mesh.Vertices)
    {
      this->Points.push_back({ sample, true, { 0.0, 0.0, -1.0 } });
    }
    const std::size_t corners = this->Triangles.size();
    for (std::size_t k = 0; k < corners; k += 3)
    {
      this->AddTriangle(
        floor + this->Triangles[k], floor + this->Triangles[k + 2], floor + this->Triangles[k + 1]);
    }
    for (const glm::ivec2& edge : border)
    {
      vtkIdType top[2] = { edge.x, edge.y };
      vtkIdType bottom[2] = { floor + edge.x, floor + edge.y };
      if (sharp)
      {
        const glm::dvec3 normal = this->WallNormal(edge);
        for (int end = 0; end < 2; ++end)
        {
          top[end] = this->AddPoint(this->Mesh.Vertices[edge[end]], false, normal);
          bottom[end] = this->AddPoint(this->Mesh.Vertices[edge[end]], true, normal);
        }
      }
      this->AddTriangle(bottom[0], bottom[1], top[1]);
      this->AddTriangle(bottom[0], top[1], top[0]);
    }
  }

  std::vector<MeshPoint> Points;
  std::vector<vtkIdType> Triangles;
  /// The first so many points are those of the surface.
  std::size_t SurfacePoints = 0;

private:
  vtkIdType AddPoint(const glm::ivec2& sample, bool isOnFloor, const glm::dvec3& normal)
  {
    this->Points.push_back({ sample, isOnFloor, normal });
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Triangles.insert(this->Triangles.end(), { a, b, c });
  }

  /// To the right of the edge: away from the surface.
  glm::dvec3 WallNormal(const glm::ivec2& edge) const
  {
    const glm::dvec2 along = glm::dvec2(this->Mesh.Vertices[edge.y] - this->Mesh.Vertices[edge.x]) *
      this->Geometry.Spacing;
    return glm::normalize(glm::dvec3(along.y, -along.x, 0.0));
  }

  const GridMesh& Mesh;
  const GridGeometry& Geometry;
};

/// Slope along an axis at a sample, in height units a cell: to the neighbours that have heights.
template <typename T>
double Slope(const HeightfieldView<T>& view, const glm::ivec2& sample, int axis)
{
  const std::int64_t size = axis == 0 ? view.Width : view.Height;
  double ends[2];
  double cells = 0.0;
  for (int side = 0; side < 2; ++side)
  {
    glm::ivec2 at = sample;
    at[axis] += 2 * side - 1;
    const bool isThere = at[axis] >= 0 && at[axis] < size && view.IsValid(view.Index(at.x, at.y));
    cells += isThere ? 1.0 : 0.0;
    at = isThere ? at : sample;
    ends[side] = view.At(at.x, at.y);
  }
  return cells > 0.0 ? (ends[1] - ends[0]) / cells : 0.0;
}

template <typename T, typename Real>
void FillPoints(const HeightfieldView<T>& view, const MeshParts& parts,
  const GridGeometry& geometry, double base, Real* points)
{
  for (const MeshPoint& point : parts.Points)
  {
    const double height = point.IsOnFloor ? base : view.At(point.Sample.x, point.Sample.y);
    const glm::dvec3 position = geometry.ToModel(glm::dvec2(point.Sample), height);
    *points++ = static_cast<Real>(position.x);
    *points++ = static_cast<Real>(position.y);
    *points++ = static_cast<Real>(position.z);
  }
}

template <typename T>
void AddNormals(const HeightfieldView<T>& view, const MeshParts& parts,
  const GridGeometry& geometry, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(parts.Points.size()));
  for (std::size_t k = 0; k < parts.Points.size(); ++k)
  {
    glm::dvec3 normal = parts.Points[k].Normal;
    if (k < parts.SurfacePoints)
    {
      const glm::ivec2& sample = parts.Points[k].Sample;
      normal = glm::normalize(
        geometry.NormalToModel({ -Slope(view, sample, 0), -Slope(view, sample, 1), 1.0 }));
    }
    normals->SetTuple3(static_cast<vtkIdType>(k), normal.x, normal.y, normal.z);
  }
  output->GetPointData()->SetNormals(normals);
}

void AddTextureCoordinates(vtkImageData* image, const MeshParts& parts, vtkPolyData* output)
{
  const int* size = image->GetDimensions();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(parts.Points.size()));
  for (std::size_t k = 0; k < parts.Points.size(); ++k)
  {
    const glm::dvec2 sample = parts.Points[k].Sample;
    coordinates->SetTuple2(
      static_cast<vtkIdType>(k), (sample.x + 0.5) / size[0], (sample.y + 0.5) / size[1]);
  }
  output->GetPointData()->SetTCoords(coordinates);
}

void AddArraysOfSamples(vtkImageData* image, const MeshParts& parts, vtkPolyData* output)
{
  vtkNew<vtkIdList> samples;
  samples->SetNumberOfIds(static_cast<vtkIdType>(parts.Points.size()));
  for (std::size_t k = 0; k < parts.Points.size(); ++k)
  {
    const glm::ivec2& sample = parts.Points[k].Sample;
    samples->SetId(
      static_cast<vtkIdType>(k), ImageHeights::PointOfSample(image, sample.x, sample.y));
  }
  AddPointArrays(image, samples, output);
}

vtkSmartPointer<vtkCellArray> MakeTriangles(const MeshParts& parts)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(parts.Triangles.size()));
  std::copy(parts.Triangles.begin(), parts.Triangles.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, connectivity);
  return triangles;
}
}

//------------------------------------------------------------------------------
void FillMeshOutput(vtkImageData* image, const GridMesh& mesh, const GridGeometry& geometry,
  const MeshOutputOptions& options, vtkPolyData* output)
{
  MeshParts parts(mesh, geometry);
  if (options.Block)
  {
    parts.AddBlock(options.Normals);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(options.SinglePrecision ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(parts.Points.size()));
  output->SetPoints(points);
  output->SetPolys(MakeTriangles(parts));
  ImageHeights::Dispatch(image,
    [&](const auto& view)
    {
      void* target = points->GetVoidPointer(0);
      if (options.SinglePrecision)
      {
        FillPoints(view, parts, geometry, options.BlockBase, static_cast<float*>(target));
      }
      else
      {
        FillPoints(view, parts, geometry, options.BlockBase, static_cast<double*>(target));
      }
      if (options.Normals)
      {
        AddNormals(view, parts, geometry, output);
      }
    });
  if (options.TextureCoordinates)
  {
    AddTextureCoordinates(image, parts, output);
  }
  if (options.PointArrays)
  {
    AddArraysOfSamples(image, parts, output);
  }
}
}
