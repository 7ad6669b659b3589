// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The judge of all ways to cast rays at a globe: brute force in double precision. It cuts a ray at
 * all meridians and parallels of the grid and looks in every piece for the first point where the
 * ray's height above the ellipsoid (GeographicLib's) is the surface's. No pyramid, no order, no
 * expansion; slow.
 */
#ifndef terrain_GlobeReference_h
#define terrain_GlobeReference_h

#include "core/globe/GlobeGrid.h"

#include <functional>

namespace terrain
{
/// A ray in geocentric coordinates: origin + t * direction, for begin <= t <= end.
struct GlobeReferenceRay
{
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Direction{ 0.0 };
  double Begin = 0.0;
  double End = 0.0;
};

struct GlobeReferenceHit
{
  bool Found = false;
  double T = 0.0;
  glm::ivec2 Cell{ 0 };
  glm::dvec2 Fraction{ 0.0 };
  /// Where no surface is hit, the least distance of heights on the way to it, in metres; how near a
  /// miss was. With a hit, by how much the ray comes through the surface in the hit's piece.
  double Nearest = 0.0;
};

class GlobeReference
{
public:
  /// Heights of samples in metres above the ellipsoid, as drawn; NaN without data.
  /// They lie in a range.
  GlobeReference(GlobeGrid grid, std::function<double(int, int)> heights, const GlobeRange& range);

  GlobeReferenceHit Cast(const GlobeReferenceRay& ray) const;
  /// Height of a position less that of the surface below it; NaN where there is none. The cell and
  /// the position in it, unless the cell is given.
  double Above(
    const glm::dvec3& position, glm::ivec2& cell, glm::dvec2& fraction, bool given) const;

private:
  std::vector<double> Cuts(const GlobeReferenceRay& ray) const;
  /// False if a part of a ray lies outside or inside of all heights, by its distance from the
  /// centre.
  bool IsNear(const GlobeReferenceRay& ray, double begin, double end) const;

  GlobeGrid Grid;
  std::function<double(int, int)> Heights;
  GlobeRange Range;
};
}

#endif
