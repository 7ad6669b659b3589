// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where contour lines can be labelled.
 */
#ifndef terrain_render_ContourPlaces_h
#define terrain_render_ContourPlaces_h

#include <array>
#include <vector>

class vtkImageData;

/// A point of a contour line, in the image's coordinates without exaggeration.
struct ContourPlace
{
  std::array<double, 2> Point{};
  /// Along the line, in x and y, as long as a cell.
  std::array<double, 2> Along{};
  /// Height, from the image's origin.
  double Level = 0.0;
};

/// Points where lines of multiples of an interval cross the rows and columns of the samples, of at
/// most 300 rows and columns, in an order that scatters them over the terrain.
std::vector<ContourPlace> FindContourPlaces(vtkImageData* heights, double interval);

#endif
