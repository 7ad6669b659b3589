// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a ray enters the closed hull of a coarse mesh: what a rasterizer finds as the fragments of
 * its front faces.
 */
#ifndef UnitTestHullEntries_h
#define UnitTestHullEntries_h

#include "core/mesh/CoarseMesh.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

/// Distances at which the ray origin + s direction, in grid coordinates and height units, enters
/// the hull with the given floor, for s > 0 in rising order; 0 stands first if it starts inside.
class HullEntries
{
public:
  HullEntries(const terrain::CoarseMesh& mesh, double floor, const glm::dvec3& origin,
    const glm::dvec3& direction)
    : Mesh(mesh)
    , Origin(origin)
    , Direction(direction)
  {
    double begin = 0.0;
    double end = std::numeric_limits<double>::max();
    if (mesh.QuadsX > 0 && mesh.QuadsY > 0 &&
      Clip(0, 0.0, static_cast<double>(mesh.Width - 1), begin, end) &&
      Clip(1, 0.0, static_cast<double>(mesh.Height - 1), begin, end) &&
      Clip(2, floor, 1e300, begin, end))
    {
      this->Walk(begin, end);
    }
  }

  const std::vector<double>& Get() const
  {
    return this->Entries;
  }

private:
  bool Clip(int axis, double low, double high, double& begin, double& end) const
  {
    const double d = this->Direction[axis];
    const double o = this->Origin[axis];
    if (d == 0.0)
    {
      return o >= low && o <= high;
    }
    begin = std::max(begin, std::min((low - o) / d, (high - o) / d));
    end = std::min(end, std::max((low - o) / d, (high - o) / d));
    return begin <= end;
  }

  /// All distances where the ray crosses a line of the quads, and between them the quads.
  void Walk(double begin, double end)
  {
    std::vector<double> cuts{ begin, end };
    for (int axis = 0; axis < 2; ++axis)
    {
      const std::int64_t count = axis == 0 ? this->Mesh.QuadsX : this->Mesh.QuadsY;
      for (std::int64_t v = 0; v <= count && this->Direction[axis] != 0.0; ++v)
      {
        const auto line = static_cast<double>(axis == 0 ? this->Mesh.Column(v) : this->Mesh.Row(v));
        const double s = (line - this->Origin[axis]) / this->Direction[axis];
        if (s > begin && s < end)
        {
          cuts.push_back(s);
        }
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
    {
      this->AddQuad(cuts[k], cuts[k + 1]);
    }
  }

  void AddQuad(double begin, double end)
  {
    const glm::dvec3 middle = this->Origin + 0.5 * (begin + end) * this->Direction;
    const auto step = static_cast<double>(this->Mesh.CellsPerQuad);
    const std::int64_t qx = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(middle.x / step), 0, this->Mesh.QuadsX - 1);
    const std::int64_t qy = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(middle.y / step), 0, this->Mesh.QuadsY - 1);
    if (!this->Mesh.IsKept(qx, qy))
    {
      return;
    }
    const glm::dvec2 first(this->Mesh.Column(qx), this->Mesh.Row(qy));
    const glm::dvec2 size = glm::dvec2(this->Mesh.Column(qx + 1), this->Mesh.Row(qy + 1)) - first;
    const auto side = [&](double s)
    {
      const glm::dvec2 p = (glm::dvec2(this->Origin + s * this->Direction) - first) / size;
      return p.x - p.y;
    };
    const double atBegin = side(begin);
    const double atEnd = side(end);
    double cut = end;
    if ((atBegin < 0.0) != (atEnd < 0.0) && atBegin != atEnd)
    {
      cut = std::clamp(begin + (end - begin) * atBegin / (atBegin - atEnd), begin, end);
    }
    this->AddTriangle(qx, qy, side(0.5 * (begin + cut)) >= 0.0, begin, cut);
    this->AddTriangle(qx, qy, side(0.5 * (cut + end)) >= 0.0, cut, end);
  }

  /// Height of the ray above the plane of a triangle.
  double Above(std::int64_t qx, std::int64_t qy, bool south, double s) const
  {
    const glm::dvec3 p = this->Origin + s * this->Direction;
    const glm::dvec2 first(this->Mesh.Column(qx), this->Mesh.Row(qy));
    const glm::dvec2 size = glm::dvec2(this->Mesh.Column(qx + 1), this->Mesh.Row(qy + 1)) - first;
    const glm::dvec2 f = (glm::dvec2(p) - first) / size;
    const double sw = this->Mesh.VertexHeight(qx, qy);
    const double se = this->Mesh.VertexHeight(qx + 1, qy);
    const double nw = this->Mesh.VertexHeight(qx, qy + 1);
    const double ne = this->Mesh.VertexHeight(qx + 1, qy + 1);
    return p.z -
      (south ? sw + f.x * (se - sw) + f.y * (ne - se) : sw + f.x * (ne - nw) + f.y * (nw - sw));
  }

  void AddTriangle(std::int64_t qx, std::int64_t qy, bool south, double begin, double end)
  {
    if (begin >= end)
    {
      return;
    }
    const double atBegin = this->Above(qx, qy, south, begin);
    const double atEnd = this->Above(qx, qy, south, end);
    if (atBegin > 0.0 && atEnd > 0.0)
    {
      return;
    }
    const double cross = begin + (end - begin) * atBegin / (atBegin - atEnd);
    this->AddInside(atBegin > 0.0 ? cross : begin, atEnd > 0.0 ? cross : end);
  }

  void AddInside(double begin, double end)
  {
    const double touching = 1e-9 * (1.0 + std::abs(begin));
    if (this->Entries.empty() || begin > this->LastEnd + touching)
    {
      this->Entries.push_back(begin);
    }
    this->LastEnd = end;
  }

  const terrain::CoarseMesh& Mesh;
  const glm::dvec3 Origin;
  const glm::dvec3 Direction;
  std::vector<double> Entries;
  double LastEnd = 0.0;
};

#endif
