// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/globe/GlobeAnchor.h"

#include "core/grid/Constants.h"

#include <algorithm>

namespace terrain
{
namespace
{
GlobeShell MakeShell(const Ellipsoid& body, double height, const glm::dvec2& meridian)
{
  GlobeShell shell;
  const double a = body.Equatorial + height;
  const double b = body.Polar + height;
  shell.PerRadius = 1.0 / (a * a);
  shell.PerAxis = 1.0 / (b * b);
  shell.Anchor = ((meridian.x - a) * (meridian.x + a)) * shell.PerRadius +
    meridian.y * meridian.y * shell.PerAxis;
  return shell;
}

/// Sine and cosine of a latitude: exactly on the axis at the poles.
glm::dvec2 SineCosine(double latitude)
{
  return std::abs(latitude) >= 90.0 * kDegree ? glm::dvec2(std::copysign(1.0, latitude), 0.0)
                                              : glm::dvec2(std::sin(latitude), std::cos(latitude));
}
}

GlobeAnchor::GlobeAnchor(const GlobeGrid& grid, const GlobeRange& range, const glm::dvec3& position)
  : Position(position)
  , Radius(std::hypot(position.x, position.y))
{
  const Ellipsoid& body = grid.Body;
  if (this->Radius > 0.0)
  {
    this->Sine = position.y / this->Radius;
    this->Cosine = position.x / this->Radius;
  }
  const glm::dvec2 meridian(this->Radius, position.z);
  this->Height = body.ToPlace(position).z;
  const double longitude = std::atan2(this->Sine, this->Cosine);
  double east = longitude - grid.West;
  east -= kTurn * std::floor(east / kTurn);
  this->Column = east / grid.Step;

  // Two ellipsoids hold all points of a height between them, up to the square of the flattening;
  // and rounding at an anchor far away has its room.
  const double relief = std::max(std::abs(range.Lowest), std::abs(range.Highest));
  const double margin = 1.0 + 1e-6 * glm::length(position) + 1e-6 * body.Equatorial +
    relief * body.Flattening() * body.Flattening() + 1e-3 * (range.Highest - range.Lowest);
  this->Outer = MakeShell(body, range.Highest + margin, meridian);
  this->Inner =
    MakeShell(body, std::max(range.Lowest - margin, -0.5 * body.LeastRadius()), meridian);
  this->Curvature = 1.0 / (body.LeastRadius() + std::min(range.Lowest - margin, 0.0));
  this->Spread = body.GreatestRadius() / body.LeastRadius() - 1.0;

  this->Columns.resize(static_cast<std::size_t>(grid.Columns));
  for (std::size_t i = 0; i < this->Columns.size(); ++i)
  {
    const double apart = grid.West + static_cast<double>(i) * grid.Step - longitude;
    this->Columns[i] = { std::sin(apart), std::cos(apart) };
  }
  if (grid.IsJoined())
  {
    this->Columns.back() = this->Columns.front();
  }
  this->Rows.resize(grid.Latitudes.size());
  for (std::size_t j = 0; j < this->Rows.size(); ++j)
  {
    const glm::dvec2 line = SineCosine(grid.Latitudes[j]);
    const glm::dvec2 apart = meridian - body.Foot(line.x, line.y);
    this->Rows[j] = { line, apart.y * line.y - apart.x * line.x,
      apart.x * line.y + apart.y * line.x - this->Height };
  }
}

std::vector<glm::dvec4> GlobeCurves(const GlobeGrid& grid)
{
  const double e2 = grid.Body.E2();
  std::vector<glm::dvec4> curves(grid.Latitudes.size());
  for (std::size_t j = 0; j < curves.size(); ++j)
  {
    const glm::dvec2 line = SineCosine(grid.Latitudes[j]);
    const double w2 = 1.0 - e2 * line.x * line.x;
    const double radius = grid.Body.Meridional(line.x);
    const double sc = line.x * line.y;
    const double step =
      j + 1 < curves.size() ? grid.Latitudes[j + 1] - grid.Latitudes[j] : kInfinity;
    curves[j] = { radius, 3.0 * e2 * sc * radius / w2,
      3.0 * e2 * radius / w2 * (line.y * line.y - line.x * line.x + 5.0 * e2 * sc * sc / w2),
      1.0 / step };
  }
  return curves;
}
}
