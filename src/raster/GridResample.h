// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples at uneven or curvilinear coordinates onto an even grid, without GDAL. Private to the
 * module.
 *
 * Along unevenly spaced axes the result is the bilinear surface between the four samples around a
 * point. In a curvilinear grid it is the same of the cell that holds it, by inverse bilinear
 * mapping of longitude and latitude; the position found is within kGridResampleError. Where one of
 * the four has no data, and outside of all cells, there is none.
 */
#ifndef vtkTerrain_raster_GridResample_h
#define vtkTerrain_raster_GridResample_h

#include <array>
#include <cstddef>
#include <vector>

namespace terrain
{
/// Largest error of a position in a cell, in cells. A point that lies outside of a cell by no more
/// counts as inside, so that neighbours meet.
constexpr double kGridResampleError = 1e-6;

/// An even grid: GDAL's six numbers, from corners of cells, the first row in the north.
struct EvenGrid
{
  std::size_t Width = 0;
  std::size_t Height = 0;
  std::array<double, 6> GeoTransform{ { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 } };

  double X(std::size_t column) const
  {
    return this->GeoTransform[0] + (static_cast<double>(column) + 0.5) * this->GeoTransform[1];
  }
  double Y(std::size_t row) const
  {
    return this->GeoTransform[3] + (static_cast<double>(row) + 0.5) * this->GeoTransform[5];
  }
};

/// The even grid from the first to the last of each axis, its steps the smallest of the axis', but
/// at most `most` samples.
EvenGrid PlanEvenGrid(const std::vector<double>& x, const std::vector<double>& y, std::size_t most);

/// The even grid over a field of width x height places, its cells of their mean area. Steps of
/// degrees keep their shape on the ground (isGeographic).
EvenGrid PlanEvenGrid(const std::vector<double>& x, const std::vector<double>& y, std::size_t width,
  bool isGeographic, std::size_t most);

/// Heights (NaN for none) of x.size() columns and y.size() rows, each rising or falling.
std::vector<double> ResampleAxes(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& heights, const EvenGrid& grid);

/// Heights (NaN for none) of a field of places with `width` columns. Cells wider than `widest`,
/// which close the circle round the earth, are left out.
std::vector<double> ResampleField(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& heights, std::size_t width, double widest, const EvenGrid& grid);
}
#endif
