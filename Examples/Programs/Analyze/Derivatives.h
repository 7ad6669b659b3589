// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The commands slope, aspect, curvature and ruggedness: what 3 x 3 samples say about the one in
 * their middle.
 */
#ifndef terrain_analyze_Derivatives_h
#define terrain_analyze_Derivatives_h

#include "Raster.h"

#include <string>

/**
 * command: the name of one of
 * - slope: degrees, and aspect: degrees clockwise from grid north of the way down, no data where it
 *   is level. B. K. P. Horn, Hill shading and the reflectance map, Proc. IEEE 69 (1981), as
 * gdaldem.
 * - curvature: profile and plan curvature in 1/m, two bands, positive where water slows down or
 *   comes together. L. W. Zevenbergen, C. R. Thorne, Quantitative analysis of land surface
 *   topography, Earth Surf. Process. Landforms 12 (1987).
 * - ruggedness: the root of the sum of squared differences to the 8 neighbours, in metres.
 *   S. J. Riley, S. D. DeGloria, R. Elliot, A terrain ruggedness index, Intermountain J. Sci. 5
 *   (1999), as gdaldem.
 *
 * The border, and samples with a neighbour without data, have none.
 */
void WriteDerivative(const RasterOptions& raster, const std::string& command);

#endif
