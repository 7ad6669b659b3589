// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A brute-force reference for rays in grid coordinates: every cell, in double precision; and
 * random rays of every kind.
 */
#ifndef UnitTestRays_h
#define UnitTestRays_h

#include "UnitTestFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace terrain
{
/// The difference of a ray's height and the patch's over one cell: c + b s + a s^2, s in [Begin,
/// End].
struct CellPiece
{
  double Begin = 0.0;
  double End = 0.0;
  double A = 0.0;
  double B = 0.0;
  double C = 0.0;

  double At(double s) const
  {
    return this->C + s * (this->B + s * this->A);
  }
  /// Least and greatest difference over the part of the piece before s.
  std::array<double, 2> Extremes(double before) const
  {
    const double end = std::min(this->End, before);
    std::array<double, 2> range{ std::min(this->At(this->Begin), this->At(end)),
      std::max(this->At(this->Begin), this->At(end)) };
    const double vertex = -this->B / (2.0 * this->A);
    if (vertex > this->Begin && vertex < end)
    {
      range = { std::min(range[0], this->At(vertex)), std::max(range[1], this->At(vertex)) };
    }
    return range;
  }
};

/// Along the ray.
inline void SortPieces(std::vector<CellPiece>& pieces)
{
  std::sort(pieces.begin(), pieces.end(),
    [](const CellPiece& a, const CellPiece& b)
    { return a.Begin < b.Begin || (a.Begin == b.Begin && a.End < b.End); });
}

/// The part of a ray, in grid coordinates, over the square [low, low + size]; empty if Begin > End.
inline CellPiece ClipToSquare(const TerrainRay& ray, const glm::dvec2& low, double size)
{
  CellPiece piece;
  piece.Begin = ray.sBegin;
  piece.End = ray.sEnd;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double direction = ray.directionGC[axis];
    const double ahead = low[axis] - ray.anchorCell[axis] - static_cast<double>(ray.originGC[axis]);
    if (direction == 0.0)
    {
      piece.End = ahead > 0.0 || ahead < -size ? piece.Begin - 1.0 : piece.End;
      continue;
    }
    const double t0 = ahead / direction;
    const double t1 = (ahead + size) / direction;
    piece.Begin = std::max(piece.Begin, std::min(t0, t1));
    piece.End = std::min(piece.End, std::max(t0, t1));
  }
  return piece;
}

/// The difference over the patch of a cell: south-west corner, codes, ray.
inline void SetPatch(
  CellPiece& piece, const glm::dvec2& corner, const glm::dvec4& codes, const TerrainRay& ray)
{
  const glm::dvec3 direction(ray.directionGC);
  const double twist = codes.x - codes.y - codes.z + codes.w;
  const double east = codes.y - codes.x;
  const double north = codes.z - codes.x;
  const double u = ray.anchorCell.x - corner.x + static_cast<double>(ray.originGC.x);
  const double v = ray.anchorCell.y - corner.y + static_cast<double>(ray.originGC.y);
  piece.A = -twist * direction.x * direction.y;
  piece.B = direction.z - east * direction.x - north * direction.y -
    twist * (u * direction.y + v * direction.x);
  piece.C = static_cast<double>(ray.originGC.z) + static_cast<double>(ray.originLow) - codes.x -
    east * u - north * v - twist * u * v;
}

/// The pieces of a ray over all cells that have a surface, in order along the ray. The surface is
/// made of bilinear patches, or of columns around the samples, of which a cell has four quarters.
template <typename Heights>
std::vector<CellPiece> RayPieces(
  const Heights& heights, const TerrainRay& ray, bool columns = false)
{
  std::vector<CellPiece> pieces;
  for (int j = 0; j < heights.size.y - 1; ++j)
  {
    for (int i = 0; i < heights.size.x - 1; ++i)
    {
      const glm::dvec2 corner(i, j);
      const glm::dvec4 codes(heights.CellCodes({ i, j }));
      if (codes.x < 0.0 || codes.y < 0.0 || codes.z < 0.0 || codes.w < 0.0)
      {
        continue;
      }
      for (int quarter = 0; quarter < (columns ? 4 : 1); ++quarter)
      {
        const glm::dvec2 low = corner + 0.5 * glm::dvec2(quarter & 1, quarter >> 1);
        CellPiece piece = ClipToSquare(ray, low, columns ? 0.5 : 1.0);
        SetPatch(piece, corner, columns ? glm::dvec4(codes[quarter]) : codes, ray);
        if (piece.Begin <= piece.End)
        {
          pieces.push_back(piece);
        }
      }
    }
  }
  SortPieces(pieces);
  return pieces;
}

/// How far a ray gets from one side of the surface to the other before s, through the surface: the
/// lesser of its heights above and below it over any unbroken run of cells. 0 if it stays on a
/// side.
inline double Penetration(const std::vector<CellPiece>& pieces, double before)
{
  double worst = 0.0;
  double above = 0.0;
  double below = 0.0;
  double end = -std::numeric_limits<double>::infinity();
  for (const CellPiece& piece : pieces)
  {
    if (piece.Begin >= before)
    {
      break;
    }
    if (piece.Begin > end + 1e-9 * (1.0 + std::abs(end)))
    {
      above = 0.0; // a hole: the ray may change sides there
      below = 0.0;
    }
    end = std::max(end, piece.End);
    const std::array<double, 2> range = piece.Extremes(before);
    below = std::max(below, -range[0]);
    above = std::max(above, range[1]);
    worst = std::max(worst, std::min(above, below));
  }
  return worst;
}

/// Distance of the first meeting with the surface; infinity if there is none.
inline double FirstMeeting(const std::vector<CellPiece>& pieces)
{
  double first = std::numeric_limits<double>::infinity();
  for (const CellPiece& piece : pieces)
  {
    const double discriminant = piece.B * piece.B - 4.0 * piece.A * piece.C;
    if (discriminant < 0.0)
    {
      continue;
    }
    const double q = -0.5 * (piece.B + std::copysign(std::sqrt(discriminant), piece.B));
    for (const double root : { q / piece.A, piece.C / q })
    {
      if (root >= piece.Begin && root <= piece.End)
      {
        first = std::min(first, root);
      }
    }
  }
  return first;
}

/// A ray from one point to another, s = 0..1, stored relative to the cell of its origin.
inline TerrainRay RayBetween(const glm::dvec3& begin, const glm::dvec3& end)
{
  TerrainRay ray;
  ray.anchorCell = glm::ivec2(glm::floor(glm::dvec2(begin)));
  ray.originGC = glm::vec3(begin - glm::dvec3(ray.anchorCell.x, ray.anchorCell.y, 0.0));
  ray.originLow = static_cast<float>(begin.z - static_cast<double>(ray.originGC.z));
  ray.directionGC = glm::vec3(end - begin);
  ray.sBegin = 0.0f;
  ray.sEnd = 1.0f;
  return ray;
}

/// Random rays: oblique, grazing, along axes and edges, through vertices, vertical, from below,
/// from inside and outside, beside the grid.
class RayMaker
{
public:
  /// Without alongEdges there are no rays on edges and through vertices: at the rim of a hole they
  /// have the choice whether there is a surface.
  RayMaker(glm::ivec2 size, double maximumCode, unsigned seed, bool alongEdges = true)
    : Size(size)
    , MaximumCode(maximumCode)
    , Generator(seed)
    , AlongEdges(alongEdges)
  {
  }

  TerrainRay Make()
  {
    int kind = static_cast<int>(this->Generator() % 8u);
    kind = !this->AlongEdges && (kind == 3 || kind == 4) ? -1 : kind;
    glm::dvec3 begin = this->Point(kind != 0);
    glm::dvec3 end = this->Point(kind != 1);
    switch (kind)
    {
      case 2: // along an axis
        end.x = begin.x;
        break;
      case 3: // along an edge between cells
        begin.y = end.y = std::floor(begin.y);
        break;
      case 4: // through vertices
        begin = glm::dvec3(glm::floor(glm::dvec2(begin)), begin.z);
        end = glm::dvec3(glm::floor(glm::dvec2(end)), end.z);
        break;
      case 5: // vertical
        end.x = begin.x;
        end.y = begin.y;
        break;
      case 6: // level
        end.z = begin.z;
        break;
      case 7: // diagonal
        end.y = begin.y + (end.x - begin.x);
        break;
      default:
        break;
    }
    return RayBetween(begin, end);
  }

  double Uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Generator);
  }

private:
  glm::dvec3 Point(bool near)
  {
    const double far = near ? 0.1 : 3.0;
    const glm::dvec2 cells(this->Size - 1);
    return { this->Uniform(-far, 1.0 + far) * cells.x, this->Uniform(-far, 1.0 + far) * cells.y,
      this->Uniform(-0.2 - far, 1.2 + far) * std::max(this->MaximumCode, 1e-3) };
  }

  glm::ivec2 Size;
  double MaximumCode;
  std::mt19937 Generator;
  bool AlongEdges;
};
}

#endif
