// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Units of angles.
 */
#ifndef terrain_Angles_h
#define terrain_Angles_h

#include <glm/glm.hpp>

namespace terrain
{
/// A degree in radians.
constexpr double kDegree = glm::radians(1.0);
}

#endif
