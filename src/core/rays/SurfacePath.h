// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a straight way over a heightfield meets, cell by cell. Positions in GC (Coordinates.h),
 * heights in height units.
 *
 * Over one cell the bilinear surface above a straight line is a parabola,
 * h(t) = Constant + Linear t + Quadratic t^2 with t from 0 to 1 along the whole way, so that
 * heights, largest deviations from a chord and highest points are exact.
 */
#ifndef terrain_SurfacePath_h
#define terrain_SurfacePath_h

#include "core/grid/Heightfield.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace terrain
{
/// A stretch of the way over one cell, or over none: outside the grid or without data.
struct SurfacePiece
{
  double Begin = 0.0;
  double End = 1.0;
  bool HasSurface = false;
  double Constant = 0.0;
  double Linear = 0.0;
  double Quadratic = 0.0;

  double HeightAt(double t) const
  {
    return this->Constant + t * (this->Linear + t * this->Quadratic);
  }
  /// Largest vertical distance of the surface from the chord between Begin and End.
  double ChordError() const
  {
    const double length = this->End - this->Begin;
    return 0.25 * std::abs(this->Quadratic) * length * length;
  }
};

/// Where in (0, 1) the way crosses grid lines of the grid, ascending, with 0 and 1 at the ends.
inline std::vector<double> GridCrossings(
  const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& last)
{
  std::vector<double> crossings{ 0.0, 1.0 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double step = to[axis] - from[axis];
    const double low = std::max(0.0, std::ceil(std::min(from[axis], to[axis])));
    const double high = std::min(last[axis], std::floor(std::max(from[axis], to[axis])));
    for (double line = low; step != 0.0 && line <= high; line += 1.0)
    {
      const double t = (line - from[axis]) / step;
      if (t > 0.0 && t < 1.0)
      {
        crossings.push_back(t);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  return crossings;
}

/// The cell whose surface lies at a position, -1 in x if there is none. On a grid line either
/// neighbour serves.
template <typename Heights>
glm::i64vec2 FindCellWithSurface(const Heights& heights, const glm::dvec2& position)
{
  constexpr double kOnLine = 1e-9;
  // within the grid, for numbers far beyond it are too coarse to be counted by 1
  const glm::dvec2 last(
    static_cast<double>(heights.Width - 2), static_cast<double>(heights.Height - 2));
  const glm::dvec2 low = glm::max(glm::floor(position - kOnLine), 0.0);
  const glm::dvec2 high = glm::min(glm::floor(position + kOnLine), last);
  for (double j = high.y; j >= low.y; j -= 1.0)
  {
    for (double i = high.x; i >= low.x; i -= 1.0)
    {
      const glm::i64vec2 cell(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j));
      if (heights.IsCellValid(cell.x, cell.y))
      {
        return cell;
      }
    }
  }
  return { -1, -1 };
}

/// Calls visit(piece) for every stretch of the way between two positions, in order, without gaps.
/// A way of no length is one piece from 0 to 1. Positions must be finite.
/// Heights is a HeightfieldView, or has Width, Height, At() and IsCellValid() as it has.
/// Cost: O(cells crossed).
template <typename Heights, typename Visit>
void WalkSurface(
  const Heights& heights, const glm::dvec2& from, const glm::dvec2& to, Visit&& visit)
{
  const glm::dvec2 last(
    static_cast<double>(heights.Width - 1), static_cast<double>(heights.Height - 1));
  const std::vector<double> crossings = GridCrossings(from, to, last);
  const glm::dvec2 way = to - from;
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k)
  {
    SurfacePiece piece;
    piece.Begin = crossings[k];
    piece.End = crossings[k + 1];
    const glm::i64vec2 cell =
      FindCellWithSurface(heights, from + 0.5 * (piece.Begin + piece.End) * way);
    if (cell.x >= 0)
    {
      const double h00 = heights.At(cell.x, cell.y);
      const double alongX = heights.At(cell.x + 1, cell.y) - h00;
      const double alongY = heights.At(cell.x, cell.y + 1) - h00;
      const double twist = heights.At(cell.x + 1, cell.y + 1) - h00 - alongX - alongY;
      const glm::dvec2 u = from - glm::dvec2(cell);
      piece.HasSurface = true;
      piece.Constant = h00 + alongX * u.x + alongY * u.y + twist * u.x * u.y;
      piece.Linear = alongX * way.x + alongY * way.y + twist * (u.x * way.y + u.y * way.x);
      piece.Quadratic = twist * way.x * way.y;
    }
    visit(piece);
  }
}

/// Largest value of a parabola minus a line, and where, over [Begin, End].
struct Highest
{
  double Parameter = 0.0;
  double Value = 0.0;
};

inline Highest HighestOf(double constant, double linear, double quadratic, double begin, double end)
{
  const auto value = [&](double t) { return constant + t * (linear + t * quadratic); };
  Highest best{ begin, value(begin) };
  if (value(end) > best.Value)
  {
    best = { end, value(end) };
  }
  if (quadratic < 0.0)
  {
    const double top = std::clamp(-linear / (2.0 * quadratic), begin, end);
    if (value(top) > best.Value)
    {
      best = { top, value(top) };
    }
  }
  return best;
}
}

#endif
