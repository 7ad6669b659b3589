// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fill values that a raster holds without declaring them, found among its samples. Without GDAL.
 * Private to the module.
 *
 * A value is taken for fill if it is one that programs fill with (-32768, -9999, 1e20, 65535, ...),
 * is the lowest or the highest of all, and lies far from the others: farther than five times the
 * widest gap between any two of those, and than a fifth of their range. A height that occurs in
 * nature has others near it, so that it never is.
 */
#ifndef vtkTerrain_raster_RasterHoles_h
#define vtkTerrain_raster_RasterHoles_h

#include <cstddef>
#include <vector>

namespace terrain
{
struct FillFindings
{
  /// Values of fill.
  std::vector<double> Values;
  /// Lowest and highest of the other values; low > high if there are none.
  double Low = 1.0;
  double High = -1.0;
  /// Shares of them that are the lowest and the highest.
  double LowShare = 0.0;
  double HighShare = 0.0;
  /// How many different ones there are.
  std::size_t LevelCount = 0;
  /// The widest gap between two of them in order, and the share of them on its smaller side.
  double WidestGap = 0.0;
  double GapShare = 0.0;
  /// True if that side is the lower one.
  bool IsGapLow = false;
};

/// Finds fill among at least 16 values (NaN, infinities and magnitudes from 1e30 on are left out).
FillFindings FindFill(std::vector<double> values);
}
#endif
