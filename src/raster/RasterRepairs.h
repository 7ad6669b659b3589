// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that GDAL refuses, or whose place it loses: read or repaired here. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterRepairs_h
#define vtkTerrain_raster_RasterRepairs_h

#include "raster/RasterRecord.h"

#include <gdal.h>

#include <array>
#include <string>
#include <vector>

namespace terrain
{
/// A raster of one band in memory. `samples` of the given type, row by row, are used in place and
/// must outlive it; null for samples of its own. Throws RasterError. The caller closes it.
GDALDatasetH MakeMemoryRaster(int width, int height, GDALDataType type, void* samples);

/// A band as a raster in memory, its rows made columns, with what the band says of its heights.
/// Throws RasterError. The caller closes it.
GDALDatasetH MakeTransposed(GDALDatasetH dataset, int band);

/// Unit, scale, offset, description, NoData and metadata of a band.
void CopyBandFacts(GDALRasterBandH from, GDALRasterBandH to);

/// A grid of GMT before version 4 (netCDF of one dimension, beside it ranges and numbers of rows
/// and columns), which GDAL's netCDF driver refuses; null if the file is none. The caller closes
/// it.
GDALDatasetH OpenGMTGrid(const std::string& file, RasterRecord& record);

/// Depths of an S-102 product (HDF5), for versions of GDAL before 3.8, which have no driver for it;
/// null if the file is none. The caller closes it.
GDALDatasetH OpenS102(const std::string& file, RasterRecord& record);

/// The transform of an ESRI ASCII grid that names the centre of the lower left cell along one axis
/// and its corner along the other, of which GDAL takes neither. False if the header says no such
/// thing.
bool ReadGridHeader(const std::string& file, std::array<double, 6>& transform);

/// True if the first 4 kB of a text hold the word "nan".
bool NamesNaN(const std::string& file);

/// True if the first line of a file is a comment: begins with #, %, / or !.
bool HasComments(const std::string& file);

/// True if a file begins with the byte order mark of UTF-8, as some editors on Windows write it.
bool HasByteOrderMark(const std::string& file);

/// The name under which GDAL reads such a file from the byte behind the mark on.
std::string BehindByteOrderMark(const std::string& file);

/// The file that such a name is of; another name as it is.
std::string BeforeByteOrderMark(const std::string& name);

/// The CRS in the .prj beside a file, as OSRSetFromUserInput takes it; empty if there is none.
std::string SystemBeside(const std::string& file);

/// Names of the columns of a text of points, lower case, without quotes; empty if its first line is
/// of numbers.
std::vector<std::string> ReadColumnNames(const std::string& file);
}
#endif
