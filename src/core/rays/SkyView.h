// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What of the sky is seen over a horizon.
 */
#ifndef terrain_SkyView_h
#define terrain_SkyView_h

#include "core/grid/Constants.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
/**
 * Sky view factor of a level plate from horizon angles (degrees) in count >= 1 directions at equal
 * distances: the mean of cos^2 of the horizons, of which those below 0 count as 0. It is the light
 * of an evenly bright sky that the plate receives, over that of the whole sky; 0 to 1.
 *
 * Source: J. Dozier, J. Frew, Rapid calculation of terrain parameters for radiation modeling from
 * digital elevation data, IEEE Trans. Geosci. Remote Sens. 28 (1990), Eq. (7b) for slope 0.
 * SkyViewPart is one direction's share before division by count.
 */
inline double SkyViewPart(double horizon)
{
  const double sine = std::sin(std::max(horizon, 0.0) * kDegree);
  return 1.0 - sine * sine;
}
}

#endif
