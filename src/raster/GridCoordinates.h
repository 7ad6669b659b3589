// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where samples lie by variables of coordinates, as netCDF, Zarr and DataArrays have them. Without
 * GDAL's datasets. Private to the module.
 *
 * Conventions: CF 1.11, chapters 4, 5.2 and 5.6; COARDS.
 */
#ifndef vtkTerrain_raster_GridCoordinates_h
#define vtkTerrain_raster_GridCoordinates_h

#include "raster/RasterRecord.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace terrain
{
/// A variable of coordinates.
struct GridAxis
{
  std::string Name;
  /// "units", "standard_name", "axis", "long_name" and others.
  std::map<std::string, std::string> Attributes;
  /// One a row or column; of an axis that tells nothing but its name, none.
  std::vector<double> Values;

  std::string Get(const std::string& attribute) const;
};

/// What a grid of samples comes with.
struct GridCoordinates
{
  /// Samples along the array's two dimensions: the slow one (its rows), the fast one (its columns).
  std::size_t RowCount = 0;
  std::size_t ColumnCount = 0;
  GridAxis Rows;
  GridAxis Columns;
  /// Variables with a value a sample, in the array's order; those that are no longitude, latitude,
  /// x or y are left alone.
  std::vector<GridAxis> Fields;
  /// Attributes of the grid mapping, if there is one.
  std::map<std::string, std::string> GridMapping;
};

/// Where the samples lie, after the array is transposed if it has to be.
struct GridPlace
{
  /// True if the rows of the array run east and its columns north or south.
  bool IsTransposed = false;
  /// True if GeoTransform says where they lie: GDAL's six numbers, from corners of cells.
  bool HasGeoTransform = false;
  std::array<double, 6> GeoTransform{ { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  /// If they are not evenly spaced: coordinates of columns and rows, or of each sample (IsField),
  /// in the order of the transposed array.
  std::vector<double> X;
  std::vector<double> Y;
  bool IsField = false;
  /// CRS of x and y that follows from names and units (of degrees: WGS84): empty if none does.
  std::string CoordinateSystem;
  /// True if x and y are longitude and latitude.
  bool IsGeographic = false;
  /// Metres in the unit that the coordinates are told in, from which they have been brought to
  /// metres; 0 if they tell none.
  double MetresPerUnit = 0.0;
};

/// 1 for an axis of x or longitude, 2 for one of y or latitude, 0 for others.
int GridSideOf(const GridAxis& axis);

/// Finds the place, notes in the record what it was taken from and warns of what was guessed.
/// Throws RasterError where coordinates cannot be used.
GridPlace FindGridPlace(const GridCoordinates& grid, RasterRecord& record);

/// CRS of CF's attributes of a grid mapping: "crs_wkt", "spatial_ref", or a rotated pole; empty if
/// it is none of these.
std::string SystemOfGridMapping(const std::map<std::string, std::string>& attributes);
}
#endif
