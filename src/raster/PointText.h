// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Texts of points that lie on a grid, which GDAL's driver XYZ refuses or takes other columns of:
 * points in any order, or columns with names that it does not know. Private to the module.
 */
#ifndef vtkTerrain_raster_PointText_h
#define vtkTerrain_raster_PointText_h

#include "raster/RasterRecord.h"

#include <gdal.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace terrain
{
/// What GDAL's driver XYZ warns of where it takes the first three columns.
constexpr const char* kDefaultedColumns = "column names in header";

/// Numbers of the columns of x, y and height, from 0 on.
using PointColumns = std::array<std::size_t, 3>;

/// The columns that names tell: of x (east, longitude) and y (north, latitude), and of the heights,
/// by their name or as the first behind both. Nothing if they do not tell.
std::optional<PointColumns> FindPointColumns(const std::vector<std::string>& names);

/// True if x and y are called longitude and latitude.
bool AreDegrees(const std::vector<std::string>& names, const PointColumns& columns);

/// True for names that texts of points have.
bool IsCalledPoints(const std::string& file);

/// Points of a text as a raster in memory, in float64, NaN where no point lies. The columns are
/// those that its first line names, else the first three; separators are commas, semicolons, tabs
/// and spaces, the decimal sign a point, or a comma where the separator is another. Of several
/// points at one place the last counts, with a warning. Null if the file is no such text, or if
/// its points do not lie on a grid, within a tenth of a cell; they may leave up to nine tenths of
/// it empty. The caller closes it. Throws RasterError if there is not enough memory.
GDALDatasetH OpenPointText(const std::string& file, RasterRecord& record);
}
#endif
