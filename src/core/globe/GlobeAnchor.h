// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The lines of a globe's grid as they lie about an anchor: a point near what is looked at, the eye
 * itself where it is near the ground. Made in double precision, once for all rays of a view; what
 * float then rounds is a part of the distance from the anchor, not of the planet's radius.
 *
 * Axes at the anchor: x away from the axis of the planet, y east, z north along the axis; the
 * anchor is at distance Radius from the axis.
 *
 * A meridian whose longitude is D more than the anchor's is the plane y cos D = (Radius + x) sin D.
 *
 * The normals of the ellipsoid along a parallel are a cone (J. Wartell, W. Ribarsky, L. Hodges,
 * "Efficient Ray Intersection for Visualization and Navigation of Global Terrain using Spheroidal
 * Height-Augmented Quadtrees", 1999). With q, how much farther than the anchor a point is from the
 * axis, its distances from the cone (north of it) and from the plane that touches the ellipsoid at
 * the parallel (above it) are
 *
 *   north = North + z cos - q sin        above = Height + Above + z sin + q cos
 */
#ifndef terrain_GlobeAnchor_h
#define terrain_GlobeAnchor_h

#include "core/globe/GlobeGrid.h"

#include <glm/glm.hpp>

#include <vector>

namespace terrain
{
/// A shell about a planet, and where the anchor is in it: the value of
/// (r / a)^2 + (z / b)^2 - 1.
struct GlobeShell
{
  double PerRadius = 0.0; ///< 1 / a^2
  double PerAxis = 0.0;   ///< 1 / b^2
  double Anchor = 0.0;
};

struct GlobeAnchor
{
  GlobeAnchor() = default;
  /// Of a geocentric position.
  GlobeAnchor(const GlobeGrid& grid, const GlobeRange& range, const glm::dvec3& position);

  /// Takes geocentric directions to the axes of the anchor.
  glm::dvec3 ToAxes(const glm::dvec3& direction) const
  {
    return { direction.x * this->Cosine + direction.y * this->Sine,
      direction.y * this->Cosine - direction.x * this->Sine, direction.z };
  }

  glm::dvec3 Position{ 0.0 }; ///< geocentric
  double Sine = 0.0;          ///< of its longitude
  double Cosine = 1.0;
  double Radius = 0.0;
  double Height = 0.0; ///< above the ellipsoid
  double Column = 0.0; ///< its position on the grid, in cells from the first column
  GlobeShell Outer;
  GlobeShell Inner;
  double Curvature = 0.0; ///< greatest of heights along a straight line near the surface, 1/m
  double Spread = 0.0;    ///< relative difference of the ellipsoid's radii of curvature
  /// Sine and cosine of the longitude of each column, from the anchor's.
  std::vector<glm::dvec2> Columns;
  /// Sine and cosine of each latitude, North and Above.
  std::vector<glm::dvec4> Rows;
};

/// The ellipsoid along the meridian at the latitude of each row: radius of curvature, its first and
/// second derivative by the latitude, and 1 / latitudes to the next row.
std::vector<glm::dvec4> GlobeCurves(const GlobeGrid& grid);
}

#endif
