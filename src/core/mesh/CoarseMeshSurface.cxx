// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/CoarseMeshSurface.h"

#include <cmath>

namespace terrain
{
//------------------------------------------------------------------------------
CoarseMeshSurface::CoarseMeshSurface(const CoarseMesh& mesh, bool closedHull, double floorHeight)
  : Mesh(mesh)
  , ClosedHull(closedHull)
  , FloorHeight(floorHeight)
{
  if (mesh.VertexHeights.empty())
  {
    return;
  }
  this->FirstIds.resize(mesh.VertexHeights.size(), -1);
  for (std::int64_t vy = 0; vy <= mesh.QuadsY; ++vy)
  {
    for (std::int64_t vx = 0; vx <= mesh.QuadsX; ++vx)
    {
      if (std::isnan(mesh.VertexHeight(vx, vy)))
      {
        continue;
      }
      this->FirstIds[vx + (mesh.QuadsX + 1) * vy] = this->TopVertices;
      this->TopVertices += closedHull && this->IsPinched(vx, vy) ? 2 : 1;
    }
  }
  for (std::int64_t qy = 0; qy < mesh.QuadsY; ++qy)
  {
    for (std::int64_t qx = 0; qx < mesh.QuadsX; ++qx)
    {
      if (mesh.IsKept(qx, qy))
      {
        this->TopTriangles += 2;
        this->BorderEdges += this->CountBorderEdges(qx, qy);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t CoarseMeshSurface::CountBorderEdges(std::int64_t qx, std::int64_t qy) const
{
  return (this->Mesh.IsKept(qx, qy - 1) ? 0 : 1) + (this->Mesh.IsKept(qx + 1, qy) ? 0 : 1) +
    (this->Mesh.IsKept(qx, qy + 1) ? 0 : 1) + (this->Mesh.IsKept(qx - 1, qy) ? 0 : 1);
}

//------------------------------------------------------------------------------
bool CoarseMeshSurface::IsPinched(std::int64_t vx, std::int64_t vy) const
{
  const bool southWest = this->Mesh.IsKept(vx - 1, vy - 1);
  const bool southEast = this->Mesh.IsKept(vx, vy - 1);
  const bool northWest = this->Mesh.IsKept(vx - 1, vy);
  const bool northEast = this->Mesh.IsKept(vx, vy);
  return southWest == northEast && southEast == northWest && southWest != southEast;
}

//------------------------------------------------------------------------------
CoarseMeshSurface::Corners CoarseMeshSurface::CornersOf(std::int64_t qx, std::int64_t qy) const
{
  Corners ids{};
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::int64_t vx = qx + (corner & 1);
    const std::int64_t vy = qy + (corner >> 1);
    ids[corner] = this->FirstIds[vx + (this->Mesh.QuadsX + 1) * vy];
    // Of two quads that touch at a corner, the northern one has the second vertex.
    if (this->ClosedHull && vy == qy && this->IsPinched(vx, vy))
    {
      ++ids[corner];
    }
  }
  return ids;
}
}
