// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The rays of core/rays/RayQuery.h.
 */
#ifndef terrain_QueryRay_h
#define terrain_QueryRay_h

#include "core/grid/Constants.h"

#include <glm/glm.hpp>

namespace terrain
{
/**
 * A ray in model coordinates: position = Origin + distance * Direction, Begin <= distance <= End.
 * Distances are multiples of the length of Direction, which need not be 1.
 */
struct QueryRay
{
  glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 };
  double Begin = 0.0;
  double End = kInfinity;
  /// The ray rises by Bend * distance^2 over that line, in height units (not exaggerated). That is
  /// how a straight line of sight runs over a map of the round earth: see EarthBend(). Default 0.
  double Bend = 0.0;
};

/**
 * The bend of a ray over a flat map of the round earth, in metres. A straight line that leaves
 * level at distance 0 is d^2 / 2R above the ground at distance d; refraction bends it back by the
 * part k of that. metres: horizontal length of the ray's direction. refraction: k, 0.13 on average,
 * 0 for none.
 */
inline double EarthBend(double metres, double refraction)
{
  return metres * metres * (1.0 - refraction) / (2.0 * kEarthRadius);
}
}

#endif
