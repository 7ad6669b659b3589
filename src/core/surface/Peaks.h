// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Summits of a raster, by their prominence.
 */
#ifndef terrain_Peaks_h
#define terrain_Peaks_h

#include <cstddef>
#include <vector>

namespace terrain
{
/// A summit: a sample none of whose eight neighbours is higher.
struct Peak
{
  std::size_t Column = 0;
  std::size_t Row = 0;
  double Height = 0.0;
  /// Height over the highest pass from which the way leads on to something higher; over the lowest
  /// sample that can be reached for the highest summit of connected samples.
  double Prominence = 0.0;
};

/// All summits of width x height samples, rows one after another, NaN where there is none; the most
/// prominent first, those alike in the order of the samples. Ways lead from a sample to its eight
/// neighbours. Of samples of the same height in a row one is the summit. Samples at the border of
/// the raster and beside NaN are no summits, for the ground may rise beyond, but ways lead over
/// them. Method: samples from the highest down, joined to the islands that they touch (union-find);
/// where two meet, the lower summit has its pass. O(n log n), 16 bytes a sample.
std::vector<Peak> FindPeaks(const std::vector<double>& heights, std::size_t width);
}

#endif
