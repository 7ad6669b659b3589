// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/MeshOutput.h"

#include "data/ImageHeights.h"
#include "data/PointArrays.h"
#include "data/SMPParallelFor.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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
  MeshParts(GridMesh& mesh, const GridGeometry& geometry)
    : Mesh(mesh)
    , Geometry(geometry)
  {
  }

  std::size_t NumberOfPoints() const
  {
    return this->Mesh.Vertices.size() + this->Others.size();
  }

  /// The first ones are those of the surface.
  MeshPoint Point(std::size_t k) const
  {
    const std::size_t surface = this->Mesh.Vertices.size();
    return k < surface ? MeshPoint{ this->Mesh.Vertices[k], false, {} } : this->Others[k - surface];
  }
  bool IsOnSurface(std::size_t k) const
  {
    return k < this->Mesh.Vertices.size();
  }

  /// Closes the surface. Parts have points of their own if they have normals of their own.
  void AddBlock(const MeshOutputOptions& options)
  {
    const bool sharp = options.Normals;
    const std::vector<glm::ivec2> border = FindBorderEdges(this->Mesh);
    const auto floor = static_cast<std::int32_t>(this->Mesh.Vertices.size());
    for (const glm::ivec2& sample : this->Mesh.Vertices)
    {
      this->Others.push_back({ sample, true, { 0.0, 0.0, -1.0 } });
    }
    std::vector<std::int32_t>& triangles = this->Mesh.Triangles;
    const std::size_t corners = triangles.size();
    for (std::size_t k = 0; k < corners; k += 3)
    {
      this->AddTriangle(floor + triangles[k], floor + triangles[k + 2], floor + triangles[k + 1]);
    }
    for (const glm::ivec2& edge : border)
    {
      if (!options.WallsOfHoles && !this->IsOnSide(edge, options))
      {
        continue;
      }
      std::int32_t top[2] = { edge.x, edge.y };
      std::int32_t bottom[2] = { floor + edge.x, floor + edge.y };
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

  /// Takes the triangles out of the mesh.
  vtkSmartPointer<vtkCellArray> TakeTriangles()
  {
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(this->Mesh.Triangles.size()));
    std::copy(this->Mesh.Triangles.begin(), this->Mesh.Triangles.end(), corners->GetPointer(0));
    this->Mesh.Triangles = {};
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(3, corners);
    return triangles;
  }

private:
  std::int32_t AddPoint(const glm::ivec2& sample, bool isOnFloor, const glm::dvec3& normal)
  {
    this->Others.push_back({ sample, isOnFloor, normal });
    return static_cast<std::int32_t>(this->NumberOfPoints()) - 1;
  }

  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c)
  {
    this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), { a, b, c });
  }

  /// True if an edge lies along a side of the rectangle of samples.
  bool IsOnSide(const glm::ivec2& edge, const MeshOutputOptions& options) const
  {
    const glm::ivec2& a = this->Mesh.Vertices[edge.x];
    const glm::ivec2& b = this->Mesh.Vertices[edge.y];
    const auto both = [&](const glm::ivec2& corner)
    {
      return glm::any(
        glm::bvec2(a.x == corner.x && b.x == corner.x, a.y == corner.y && b.y == corner.y));
    };
    return both(options.First) || both(options.Last);
  }

  /// To the right of the edge: away from the surface.
  glm::dvec3 WallNormal(const glm::ivec2& edge) const
  {
    const glm::dvec2 along = glm::dvec2(this->Mesh.Vertices[edge.y] - this->Mesh.Vertices[edge.x]) *
      this->Geometry.Spacing;
    return glm::normalize(glm::dvec3(along.y, -along.x, 0.0));
  }

  GridMesh& Mesh;
  const GridGeometry& Geometry;
  /// Points of walls and floor.
  std::vector<MeshPoint> Others;
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

/// Calls body(k) for the points of the output, in parallel.
template <typename Body>
void ForEachPoint(const MeshParts& parts, const Body& body)
{
  SMPParallelFor(static_cast<std::int64_t>(parts.NumberOfPoints()),
    [&body](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = begin; k < end; ++k)
      {
        body(k);
      }
    });
}

template <typename T, typename Real>
void FillPoints(const HeightfieldView<T>& view, const MeshParts& parts,
  const GridGeometry& geometry, double base, Real* points)
{
  ForEachPoint(parts,
    [&](std::int64_t k)
    {
      const MeshPoint point = parts.Point(k);
      const double height = point.IsOnFloor ? base : view.At(point.Sample.x, point.Sample.y);
      const glm::dvec3 position = geometry.ToModel(glm::dvec2(point.Sample), height);
      for (int axis = 0; axis < 3; ++axis)
      {
        points[3 * k + axis] = static_cast<Real>(position[axis]);
      }
    });
}

/// Array of floats of a name for all points of the output.
vtkSmartPointer<vtkFloatArray> MakeFloats(
  const MeshParts& parts, const char* name, int numberOfComponents)
{
  auto floats = vtkSmartPointer<vtkFloatArray>::New();
  floats->SetName(name);
  floats->SetNumberOfComponents(numberOfComponents);
  floats->SetNumberOfTuples(static_cast<vtkIdType>(parts.NumberOfPoints()));
  return floats;
}

template <typename T>
void AddNormals(const HeightfieldView<T>& view, const MeshParts& parts,
  const GridGeometry& geometry, vtkPolyData* output)
{
  const vtkSmartPointer<vtkFloatArray> normals = MakeFloats(parts, "Normals", 3);
  float* target = normals->GetPointer(0);
  ForEachPoint(parts,
    [&](std::int64_t k)
    {
      glm::dvec3 normal = parts.Point(k).Normal;
      if (parts.IsOnSurface(k))
      {
        const glm::ivec2 sample = parts.Point(k).Sample;
        normal = glm::normalize(
          geometry.NormalToModel({ -Slope(view, sample, 0), -Slope(view, sample, 1), 1.0 }));
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        target[3 * k + axis] = static_cast<float>(normal[axis]);
      }
    });
  output->GetPointData()->SetNormals(normals);
}

/// Gives the floor of a block its own height in the array of heights, as far as its type has it.
void SetFloorHeights(const MeshParts& parts, const char* name, double base, vtkPolyData* output)
{
  vtkDataArray* heights = name ? output->GetPointData()->GetArray(name) : nullptr;
  for (std::size_t k = 0; heights && k < parts.NumberOfPoints(); ++k)
  {
    if (parts.Point(k).IsOnFloor)
    {
      heights->SetComponent(static_cast<vtkIdType>(k), 0,
        std::clamp(base, heights->GetDataTypeMin(), heights->GetDataTypeMax()));
    }
  }
}

/// Slopes and their directions, see vtkTerrainMesh::SetComputeSlopes().
template <typename T>
void AddSlopes(const HeightfieldView<T>& view, const MeshParts& parts, const GridGeometry& geometry,
  vtkPolyData* output)
{
  const vtkSmartPointer<vtkFloatArray> slopes = MakeFloats(parts, "Slope", 1);
  const vtkSmartPointer<vtkFloatArray> aspects = MakeFloats(parts, "Aspect", 1);
  constexpr double kLevel = 1e-6; // as where rays are coloured
  ForEachPoint(parts,
    [&](std::int64_t k)
    {
      const glm::ivec2 sample = parts.Point(k).Sample;
      const glm::dvec2 down =
        -glm::dvec2(Slope(view, sample, 0), Slope(view, sample, 1)) / geometry.Spacing;
      const double steepness = glm::length(down);
      const double aspect = glm::degrees(std::atan2(down.x, down.y));
      slopes->SetValue(k, static_cast<float>(glm::degrees(std::atan(steepness))));
      aspects->SetValue(k,
        steepness < kLevel ? std::numeric_limits<float>::quiet_NaN()
                           : static_cast<float>(aspect < 0.0 ? aspect + 360.0 : aspect));
    });
  output->GetPointData()->AddArray(slopes);
  output->GetPointData()->AddArray(aspects);
}

void AddTextureCoordinates(vtkImageData* image, const MeshParts& parts,
  const GridGeometry& geometry, const std::array<double, 4>& bounds, vtkPolyData* output)
{
  const glm::dvec2 corner(bounds[0], bounds[2]);
  const glm::dvec2 extent = glm::dvec2(bounds[1], bounds[3]) - corner;
  const glm::dvec2 size(image->GetDimensions()[0], image->GetDimensions()[1]);
  const vtkSmartPointer<vtkFloatArray> coordinates = MakeFloats(parts, "TextureCoordinates", 2);
  float* target = coordinates->GetPointer(0);
  ForEachPoint(parts,
    [&](std::int64_t k)
    {
      const glm::dvec2 sample(parts.Point(k).Sample);
      const glm::vec2 place(extent.x > 0.0 && extent.y > 0.0
          ? (glm::dvec2(geometry.ToModel(sample, 0.0)) - corner) / extent
          : (sample + 0.5) / size);
      target[2 * k] = place.x;
      target[2 * k + 1] = place.y;
    });
  output->GetPointData()->SetTCoords(coordinates);
}
}

//------------------------------------------------------------------------------
void FillMeshOutput(vtkImageData* image, GridMesh& mesh, const GridGeometry& geometry,
  const MeshOutputOptions& options, vtkPolyData* output)
{
  MeshParts parts(mesh, geometry);
  if (options.Block)
  {
    parts.AddBlock(options);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(options.SinglePrecision ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(parts.NumberOfPoints()));
  output->SetPoints(points);
  output->SetPolys(parts.TakeTriangles());
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
      if (options.Slopes)
      {
        AddSlopes(view, parts, geometry, output);
      }
    });
  if (options.TextureCoordinates)
  {
    AddTextureCoordinates(image, parts, geometry, options.TextureBounds, output);
  }
  if (options.PointArrays)
  {
    AddPointArrays(
      image, static_cast<vtkIdType>(parts.NumberOfPoints()),
      [&](vtkIdType k)
      {
        const glm::ivec2 sample = parts.Point(k).Sample;
        return ImageHeights::PointOfSample(image, sample.x, sample.y);
      },
      output);
    SetFloorHeights(
      parts, image->GetPointData()->GetScalars()->GetName(), options.BlockBase, output);
  }
}
}
