// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a rectangle of samples from a raster file, reduced if asked for, without VTK. Private to
 * the module.
 */
#ifndef vtkTerrain_raster_RasterPiece_h
#define vtkTerrain_raster_RasterPiece_h

#include "raster/RasterFile.h"

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace terrain
{
/// What to read and where it goes.
struct RasterRequest
{
  /// Pixels of the file at full resolution, and the samples they become, counted from the
  /// south-western one; never more samples than pixels.
  RasterWindow Window;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  bool NorthFirst = true;
  bool EastFirst = false;

  /// The rectangle of samples to read: first and last, east and north.
  std::int64_t Extent[4] = { 0, -1, 0, -1 };

  /// Values of the file that are no heights; the second ones are counted as found in Undeclared.
  std::vector<double> NoData;
  std::vector<double> UndeclaredNoData;
  /// False if overviews may have been made of values that are no heights, as if they were.
  bool UseOverviews = true;

  /// height = Offset + Scale * value; other than 0 and 1 for floating-point samples only.
  double Scale = 1.0;
  double Offset = 0.0;

  /// Is called between blocks with the share that is done; returns false to stop.
  std::function<bool(double)> Progress;
  /// Gives the array of hidden marks, one zero byte a sample of the extent, when the first sample
  /// of an integer type has no height. Floating-point samples become NaN instead.
  std::function<unsigned char*()> Hidden;
  unsigned char HiddenMark = 1;
};

/// What was found on the way.
struct RasterFindings
{
  bool Completed = true;
  /// How many samples held each undeclared value.
  std::map<double, std::int64_t> Undeclared;
};

/// Reads the extent to samples, row by row from the south. Hidden integer samples hold 0.
/// Reduced samples are means over the area of a sample, of what has data there, where at least half
/// of it has; integers are rounded to the nearest. The same samples whatever the extent.
/// Throws RasterError.
template <typename T>
RasterFindings ReadRasterPiece(const RasterFile& file, const RasterRequest& request, T* samples);
}
#endif
