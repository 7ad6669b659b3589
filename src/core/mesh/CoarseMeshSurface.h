// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The triangles of a coarse mesh, alone or as a closed hull.
 *
 * The hull has a wall below every edge that only one kept quad has, and a floor under every kept
 * quad. It is a closed manifold without T-junctions, oriented outward: every ray that comes from
 * outside enters it through a front face. Where two kept quads touch at a corner only, each has a
 * vertex of its own there.
 */
#ifndef terrain_CoarseMeshSurface_h
#define terrain_CoarseMeshSurface_h

#include "core/mesh/CoarseMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace terrain
{
/// A vertex of the triangles: a sample's column and row, and on the floor of the hull or not.
struct CoarseMeshVertex
{
  std::int64_t Column = 0;
  std::int64_t Row = 0;
  /// Height in height units; of floor vertices FloorHeight.
  double Height = 0.0;
};

/// Numbers the vertices and triangles of a coarse mesh; keeps a reference to it.
class CoarseMeshSurface
{
public:
  /// Triangles of the mesh, with closedHull also walls down to a floor at floorHeight.
  CoarseMeshSurface(const CoarseMesh& mesh, bool closedHull, double floorHeight);

  /// Number of vertices: those on the mesh first, then as many on the floor.
  std::int64_t NumberOfVertices() const
  {
    return this->ClosedHull ? 2 * this->TopVertices : this->TopVertices;
  }
  /// Number of triangles: those of the mesh first, then walls and floor.
  std::int64_t NumberOfTriangles() const
  {
    return this->ClosedHull ? 2 * this->TopTriangles + 2 * this->BorderEdges : this->TopTriangles;
  }

  /// Calls write(vertexId, vertex) for every vertex.
  template <typename Write>
  void ForEachVertex(Write&& write) const;

  /// Calls write(a, b, c) for every triangle, counterclockwise seen from outside.
  template <typename Write>
  void ForEachTriangle(Write&& write) const;

private:
  using Corners = std::array<std::int64_t, 4>;

  /// Ids of the top vertices of a quad: south-west, south-east, north-west, north-east.
  Corners CornersOf(std::int64_t qx, std::int64_t qy) const;
  /// Two kept quads meet at the vertex, and only there.
  bool IsPinched(std::int64_t vx, std::int64_t vy) const;
  std::int64_t CountBorderEdges(std::int64_t qx, std::int64_t qy) const;
  template <typename Write>
  void ForEachWall(std::int64_t qx, std::int64_t qy, Write&& write) const;

  const CoarseMesh& Mesh;
  bool ClosedHull = false;
  double FloorHeight = 0.0;
  /// Id of the (first) top vertex at each vertex of the mesh.
  std::vector<std::int64_t> FirstIds;
  std::int64_t TopVertices = 0;
  std::int64_t TopTriangles = 0;
  std::int64_t BorderEdges = 0;
};

//------------------------------------------------------------------------------
template <typename Write>
void CoarseMeshSurface::ForEachVertex(Write&& write) const
{
  for (std::int64_t vy = 0; vy <= this->Mesh.QuadsY && this->TopVertices > 0; ++vy)
  {
    for (std::int64_t vx = 0; vx <= this->Mesh.QuadsX; ++vx)
    {
      const double height = this->Mesh.VertexHeight(vx, vy);
      if (height != height)
      {
        continue;
      }
      const std::int64_t id = this->FirstIds[vx + (this->Mesh.QuadsX + 1) * vy];
      const CoarseMeshVertex top{ this->Mesh.Column(vx), this->Mesh.Row(vy), height };
      const CoarseMeshVertex floor{ top.Column, top.Row, this->FloorHeight };
      const std::int64_t copies = this->ClosedHull && this->IsPinched(vx, vy) ? 2 : 1;
      for (std::int64_t copy = 0; copy < copies; ++copy)
      {
        write(id + copy, top);
        if (this->ClosedHull)
        {
          write(id + copy + this->TopVertices, floor);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
template <typename Write>
void CoarseMeshSurface::ForEachWall(std::int64_t qx, std::int64_t qy, Write&& write) const
{
  const Corners top = this->CornersOf(qx, qy);
  const std::int64_t down = this->TopVertices;
  // Top edge from a to b, counterclockwise around the quad.
  const auto wall = [&](std::int64_t a, std::int64_t b)
  {
    write(b, a, a + down);
    write(b, a + down, b + down);
  };
  if (!this->Mesh.IsKept(qx, qy - 1))
  {
    wall(top[0], top[1]);
  }
  if (!this->Mesh.IsKept(qx + 1, qy))
  {
    wall(top[1], top[3]);
  }
  if (!this->Mesh.IsKept(qx, qy + 1))
  {
    wall(top[3], top[2]);
  }
  if (!this->Mesh.IsKept(qx - 1, qy))
  {
    wall(top[2], top[0]);
  }
}

//------------------------------------------------------------------------------
template <typename Write>
void CoarseMeshSurface::ForEachTriangle(Write&& write) const
{
  const auto forEachQuad = [this](auto&& body)
  {
    for (std::int64_t qy = 0; qy < this->Mesh.QuadsY; ++qy)
    {
      for (std::int64_t qx = 0; qx < this->Mesh.QuadsX; ++qx)
      {
        if (this->Mesh.IsKept(qx, qy))
        {
          body(qx, qy);
        }
      }
    }
  };
  forEachQuad(
    [&](std::int64_t qx, std::int64_t qy)
    {
      const Corners top = this->CornersOf(qx, qy);
      write(top[0], top[1], top[3]);
      write(top[0], top[3], top[2]);
    });
  if (!this->ClosedHull)
  {
    return;
  }
  forEachQuad([&](std::int64_t qx, std::int64_t qy) { this->ForEachWall(qx, qy, write); });
  forEachQuad(
    [&](std::int64_t qx, std::int64_t qy)
    {
      Corners floor = this->CornersOf(qx, qy);
      for (std::int64_t& id : floor)
      {
        id += this->TopVertices;
      }
      write(floor[0], floor[3], floor[1]);
      write(floor[0], floor[2], floor[3]);
    });
}
}

#endif
