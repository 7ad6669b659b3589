// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How much of its extent a terrain rises, and how many times as high it is drawn so that this is
 * seen.
 */
#ifndef terrain_Relief_h
#define terrain_Relief_h

#include <vector>

namespace terrain
{
/// Difference of the heights that 2 % and 98 % of the samples lie below, in their unit; spikes and
/// pits of a few samples do not count. NaN are left out; 0 for fewer than two others. Reorders the
/// samples.
double ReliefOf(std::vector<double>& samples);

/// Relief over extent of which a view of all the terrain shows the shape at true scale.
constexpr double kSeenRelief = 0.08;
/// Relief over extent above which such a view shows towers rather than terrain.
constexpr double kSteepestRelief = 0.5;
/// Relief over extent below which it shows a sheet.
constexpr double kFlattestRelief = 0.01;

/// Drawn height over true height for a relief (ReliefOf) and an extent in the same unit, one of 1,
/// 1.5, 2, 3, 5, 7 times a power of ten from 0.001 to 1000: 1 from kSeenRelief to kSteepestRelief;
/// below that (kSeenRelief extent / relief)^0.6, which leaves plains flatter than hills; above,
/// what brings it down to kSteepestRelief. 1 where relief or extent is not > 0 and finite. Our own
/// rule.
double SuggestExaggeration(double relief, double extent);

/// Where a scale of colours that shows slopes ends, in degrees: at the slope that 98 % of the
/// samples lie below, up to the next of 0.1, 0.2, 0.5, 1, 2, 5, 10, 15 and so on by 5 to 90. NaN
/// are left out; 60 for none others. Reorders the samples. Our own rule.
double SuggestSteepest(std::vector<double>& slopes);
}

#endif
