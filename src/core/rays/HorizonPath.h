// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The way of a ray from a sample over a grid, cell by cell. It is the same for every sample.
 */
#ifndef terrain_HorizonPath_h
#define terrain_HorizonPath_h

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace terrain
{
/// One cell of the way. Cells and samples are counted from the sample where the ray starts.
struct HorizonCell
{
  glm::ivec2 Cell{ 0, 0 };
  /// The cell on the other side of the line that the ray runs along; else Cell.
  glm::ivec2 Beside{ 0, 0 };
  /// The ray leaves between two samples, at a fraction of the way between them.
  glm::ivec2 ExitBegin{ 0, 0 };
  glm::ivec2 ExitEnd{ 0, 0 };
  double Fraction = 0.0;
  /// Distances where it enters and leaves.
  double Enter = 0.0;
  double Exit = 0.0;
};

/// The way in a direction, until it has left a grid of any of whose samples it starts.
class HorizonPath
{
public:
  /// azimuth: degrees clockwise from north. spacing: of the samples, in units of the distances.
  /// size: samples of the grid.
  HorizonPath(double azimuth, const glm::dvec2& spacing, const glm::i64vec2& size)
  {
    // Exact where the direction is that of an axis.
    const double turn = std::remainder(azimuth, 360.0);
    const double quarter = std::round(turn / 90.0);
    const double rest = glm::radians(turn - 90.0 * quarter);
    const glm::dvec2 local(std::sin(rest), std::cos(rest));
    const std::array<glm::dvec2, 4> turned{ local, glm::dvec2(local.y, -local.x), -local,
      glm::dvec2(-local.y, local.x) };
    this->Speed = turned[static_cast<std::size_t>(quarter + 4.0) % 4] / spacing + 0.0; // no -0
    this->Walk(size);
  }

  const std::vector<HorizonCell>& Cells() const
  {
    return this->Way;
  }
  /// Cells east and north per unit of distance.
  const glm::dvec2& GetSpeed() const
  {
    return this->Speed;
  }

private:
  void Walk(const glm::i64vec2& size)
  {
    const glm::ivec2 sign(glm::sign(this->Speed));
    const glm::dvec2 speed = glm::abs(this->Speed);
    glm::ivec2 line(0, 0); // lines crossed so far
    double enter = 0.0;
    while (line.x < size.x && line.y < size.y)
    {
      const glm::dvec2 next = glm::dvec2(line + 1) / speed; // infinite along an axis
      // Lines that meet within rounding are crossed at their corner.
      const bool corner = std::abs(next.x - next.y) <= 1e-12 * std::min(next.x, next.y);
      const bool east = corner || next.x < next.y;
      const bool north = corner || next.y < next.x;
      HorizonCell cell;
      cell.Enter = enter;
      cell.Exit = std::min(next.x, next.y);
      cell.Cell = sign * line + glm::min(sign, 0);
      cell.Beside = cell.Cell - (1 - glm::abs(sign));
      line += glm::ivec2(east ? 1 : 0, north ? 1 : 0);
      cell.ExitBegin = sign * line;
      cell.ExitEnd = cell.ExitBegin;
      if (!corner && sign.x != 0 && sign.y != 0)
      {
        const int axis = east ? 1 : 0; // along which the line runs that is crossed
        cell.ExitEnd[axis] += sign[axis];
        cell.Fraction = glm::clamp(speed[axis] * cell.Exit - line[axis], 0.0, 1.0);
      }
      this->Way.push_back(cell);
      enter = cell.Exit;
    }
  }

  glm::dvec2 Speed{ 0.0, 0.0 };
  std::vector<HorizonCell> Way;
};
}

#endif
