// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sunlight under a sky without clouds.
 *
 * Source: the European Solar Radiation Atlas as C. Rigollier, O. Bauer, L. Wald, On the clear sky
 * model of the ESRA, Solar Energy 68 (2000), Eqs. (3) to (9), give it; r.sun of GRASS uses the
 * same.
 */
#ifndef terrain_ClearSky_h
#define terrain_ClearSky_h

#include "core/grid/Constants.h"

#include <cmath>

namespace terrain
{
/// The sun's light outside the atmosphere at the mean distance of the earth, W/m^2.
constexpr double kSolarConstant = 1367.0;

/// Optical thickness of an atmosphere that only scatters, for a relative optical air mass m > 0.
/// Source: F. Kasten, The Linke turbidity factor based on improved values of the integral Rayleigh
/// optical thickness, Solar Energy 56 (1996).
inline double RayleighThickness(double m)
{
  return m > 20.0 ? 1.0 / (10.4 + 0.718 * m)
                  : 1.0 / (6.6296 + m * (1.7513 + m * (-0.1202 + m * (0.0065 - m * 0.00013))));
}

/**
 * Direct sunlight on a plate that faces the sun, W/m^2. elevation: of the sun in degrees, without
 * refraction; 0 at or below 0. height: above the sea in metres. turbidity: Linke's factor at an air
 * mass of 2, about 2 in clean cold air, 3 on average, 6 in haze. day: of the year, from 1 on.
 */
inline double ClearSkyDirect(double elevation, double height, double turbidity, int day)
{
  if (!(elevation > 0.0))
  {
    return 0.0;
  }
  const double angle = elevation * kDegree;
  const double refraction = 0.061359 * (0.1594 + angle * (1.123 + 0.065656 * angle)) /
    (1.0 + angle * (28.9344 + 277.3971 * angle));
  const double seen = elevation + refraction / kDegree;
  const double mass = std::exp(-height / 8434.5) /
    (std::sin(seen * kDegree) + 0.50572 * std::pow(seen + 6.07995, -1.6364));
  const double turn = 360.0 * kDegree * day / 365.25;
  const double distance = 1.0 + 0.03344 * std::cos(turn - 0.048869);
  return kSolarConstant * distance * std::exp(-0.8662 * turbidity * mass * RayleighThickness(mass));
}
}

#endif
