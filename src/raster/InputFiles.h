// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which files an input is read from, so that nothing is written over them. Private to the module.
 */
#ifndef vtkTerrain_raster_InputFiles_h
#define vtkTerrain_raster_InputFiles_h

#include <string>

namespace terrain
{
/// True if `path` is an existing file that `input` is read from: the file itself, through links of
/// either kind; a file that GDAL reads with it (world file, header, mask, overviews, statistics);
/// what a virtual raster refers to; a tile of a directory, and what lies with it; an archive that
/// it is in. Files are compared by device and inode.
/// `input` is a raster, a file of vectors, or any other name that GDAL opens.
bool IsPartOfInput(const std::string& path, const std::string& input);
}

#endif
