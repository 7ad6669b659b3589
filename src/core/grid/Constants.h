// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers that many files need.
 */
#ifndef terrain_Constants_h
#define terrain_Constants_h

#include <glm/glm.hpp>

#include <limits>

namespace terrain
{
/// A degree in radians.
constexpr double kDegree = glm::radians(1.0);
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// Mean radius of the earth in metres, for estimates only.
constexpr double kEarthRadius = 6371008.8;
}

#endif
