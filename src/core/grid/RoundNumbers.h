// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers that people count in: lengths of scale bars, steps of graticules, and their labels.
 */
#ifndef terrain_RoundNumbers_h
#define terrain_RoundNumbers_h

#include <string>

namespace terrain
{
/// The largest of 1, 2, 5 times a power of ten that is <= value; 0 for values that are not > 0 and
/// finite.
double RoundDown(double value);

/// The largest round step of an angle in degrees that is <= value: 90, 45, 30, 20, 10, 5, 2, 1
/// degrees, 30, 20, 10, 5, 2, 1 minutes, 30, 20, 10, 5, 2, 1 seconds, then RoundDown; 0 as above.
double RoundAngleDown(double value);

/// A length in metres as a label: "500 m", "2 km", "50 cm".
std::string LengthLabel(double metres);

/// An angle in degrees as a label that is exact for multiples of step: "27°N", "86°30'E",
/// "86°30'15\"E" (UTF-8); positive and negative are the letters for either side of zero.
std::string AngleLabel(double degrees, double step, char positive, char negative);
}

#endif
