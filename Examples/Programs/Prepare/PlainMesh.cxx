// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlainMesh.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace
{
/// Appends a number as it lies in memory; both formats are little endian, as are the machines that
/// the module runs on.
template <typename T>
void Append(std::string& bytes, T number)
{
  std::array<char, sizeof(T)> memory{};
  std::memcpy(memory.data(), &number, sizeof(T));
  bytes.append(memory.data(), memory.size());
}

template <typename T>
void AppendTuple(std::string& bytes, vtkDataArray* array, vtkIdType index)
{
  for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
  {
    Append(bytes, static_cast<T>(array->GetComponent(index, c)));
  }
}

template <typename Visit>
void ForEachTriangle(vtkPolyData* mesh, Visit&& visit)
{
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* triangles = mesh->GetPolys();
  for (triangles->InitTraversal(); triangles->GetNextCell(count, corners) != 0;)
  {
    visit(corners);
  }
}
}

std::string MakePLY(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  std::string bytes =
    "ply\nformat binary_little_endian 1.0\ncomment terrain-prepare\nelement vertex " +
    std::to_string(mesh->GetNumberOfPoints()) +
    "\nproperty double x\nproperty double y\nproperty double z\n";
  bytes += normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "";
  bytes += coordinates ? "property float s\nproperty float t\n" : "";
  bytes += "element face " + std::to_string(mesh->GetNumberOfPolys()) +
    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    AppendTuple<double>(bytes, mesh->GetPoints()->GetData(), k);
    AppendTuple<float>(bytes, normals, k);
    AppendTuple<float>(bytes, coordinates, k);
  }
  ForEachTriangle(mesh,
    [&bytes](const vtkIdType* corners)
    {
      Append(bytes, std::uint8_t{ 3 });
      for (int c = 0; c < 3; ++c)
      {
        Append(bytes, static_cast<std::int32_t>(corners[c]));
      }
    });
  return bytes;
}

std::string MakeSTL(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const std::array<double, 3> origin{ { std::floor(bounds[0]), std::floor(bounds[2]), 0.0 } };
  std::string bytes = "terrain-prepare";
  bytes.resize(80, ' ');
  Append(bytes, static_cast<std::uint32_t>(mesh->GetNumberOfPolys()));
  vtkPoints* points = mesh->GetPoints();
  ForEachTriangle(mesh,
    [&](const vtkIdType* corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        Append(bytes, 0.0F); // readers compute normals from the corners
      }
      for (int c = 0; c < 3; ++c)
      {
        double point[3];
        points->GetPoint(corners[c], point);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          Append(bytes, static_cast<float>(point[axis] - origin[axis]));
        }
      }
      Append(bytes, std::uint16_t{ 0 });
    });
  return bytes;
}
