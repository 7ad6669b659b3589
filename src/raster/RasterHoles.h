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
  /// The value on that side that is next to the gap, and whether it is the only one there.
  double GapEnd = 0.0;
  bool IsGapOne = false;
  /// Between the lowest and the next one, and between the highest and the one before.
  double LowGap = 0.0;
  double HighGap = 0.0;
  /// Share of the samples on that side that have none of them beside them; see FindLone().
  double LoneShare = 0.0;
};

/// Finds fill among at least 16 values (NaN, infinities and magnitudes from 1e30 on are left out).
FillFindings FindFill(std::vector<double> values);

/// Fills in LoneShare from all samples of a raster, row by row.
void FindLone(const std::vector<double>& values, std::size_t width, FillFindings& findings);

/// True if the samples beyond the widest gap are no ground and nothing that stands on it: fewer
/// than 1 % of all, farther from all others than 10 cells and half of what those span, and neither
/// buildings nor masts. These rise, by less than 900 m, in cells of less than 15 m; several samples
/// of one show them, of heights that look like no fill, or single ones up to 100 m.
/// perUnit: metres of a unit of the values, below 0 for depths; cell: metres.
bool AreNeedles(const FillFindings& findings, double perUnit, double cell);

/// The lowest or the highest value, if it is one of at least 1 % of the samples that lies farther
/// from all others than these span, and than 100 m: fill that nobody would know, such as -9999 in
/// another unit. NaN if there is none. What rises above all others may be a building, unless it
/// looks like fill. perUnit: metres of a unit of the values, below 0 for depths.
double FindAloof(const FillFindings& findings, double perUnit);

/// True if 0 is the lowest value, of no more than half of the samples, and farther from the others
/// than a quarter of the range: voids of which nobody says that they are.
bool HasZeroVoids(const FillFindings& findings);
}
#endif
