// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One array of a file of arrays (netCDF, Zarr, HDF5) through GDAL's multidimensional C API, with
 * the variables that say where its samples lie. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterArray_h
#define vtkTerrain_raster_RasterArray_h

#include "raster/GridCoordinates.h"

#include <gdal.h>

#include <map>
#include <memory>
#include <string>

namespace terrain
{
class RasterArray
{
public:
  /// Opens an array by its name in a file, or the only one of two dimensions and more for no name;
  /// null if the file has none of this name, or the array has fewer than two dimensions.
  static std::unique_ptr<RasterArray> Open(const std::string& file, const std::string& variable);
  ~RasterArray();
  RasterArray(const RasterArray&) = delete;
  void operator=(const RasterArray&) = delete;

  /// Attributes that GDAL keeps to itself: names of variables of coordinates, of the grid mapping.
  void SetHints(const std::string& coordinates, const std::string& gridMapping);
  /// Coordinates of the two dimensions that are x and y by their variables, else of the last two.
  GridCoordinates GetCoordinates() const;
  /// Unit of the coordinates of its columns; empty if they tell none.
  std::string GetUnitOfColumns() const;
  /// Attributes of the array.
  std::map<std::string, std::string> GetAttributes() const;
  /// The array as a raster, its other dimensions as bands, rows and columns as GetCoordinates has
  /// them or the other way round. Throws RasterError. The caller closes it.
  GDALDatasetH ToDataset(bool isTransposed) const;

private:
  RasterArray() = default;
  void ChooseDimensions();
  void FindAxesByName(GridCoordinates& grid) const;

  std::string CoordinatesHint;
  std::string GridMappingHint;
  GDALDatasetH File = nullptr;
  GDALGroupH Root = nullptr;
  GDALMDArrayH Array = nullptr;
  std::size_t RowDimension = 0;
  std::size_t ColumnDimension = 0;
};

/// Name of the file and of the array in it, of a name like NETCDF:"FILE":VARIABLE; the whole name
/// and nothing for others.
void SplitArrayName(const std::string& name, std::string& file, std::string& variable);
}
#endif
