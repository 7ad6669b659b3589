// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Units of angles.
 */
#ifndef terrain_Angles_h
#define terrain_Angles_h

namespace terrain
{
/// A degree in radians.
constexpr double kDegree = 0.017453292519943295769236907684886;
}

#endif
