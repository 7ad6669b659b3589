// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tileable small heightfield that looks like stony ground, for detail (DetailHeights.h).
 */
#ifndef terrain_DetailNoise_h
#define terrain_DetailNoise_h

#include "core/grid/ParallelFor.h"

#include <cstdint>
#include <vector>

namespace terrain
{
/**
 * size x size heights, row by row, of one period: sample (size, j) would be sample (0, j). They
 * span -0.5 to 0.5 and have no step at the border. size >= 1; a size below 16 gives zeros.
 *
 * Octaves of gradient noise from size / 4 samples' length down to 4, the amplitude of each going
 * with its length: low ones smooth, fine ones folded at zero, so that ridges and hollows alternate
 * (as in K. Musgrave's ridged multifractals). The same bits on every machine.
 */
std::vector<float> MakeDetailNoise(int size, std::uint32_t seed, const ParallelFor& parallelFor);
}

#endif
