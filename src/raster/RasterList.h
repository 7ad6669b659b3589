// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which files of a directory or an archive are elevation tiles. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterList_h
#define vtkTerrain_raster_RasterList_h

#include "raster/RasterRecord.h"

#include <string>
#include <vector>

namespace terrain
{
/// Paths of files with the extensions of usual elevation tiles in a directory or archive and in
/// those below it, sorted; empty if there are none. Throws RasterError if it cannot be listed.
std::vector<std::string> FindRasters(const std::string& directory);

/// Names of files of a directory that may hold rasters and are not looked into, for a message;
/// empty for none. Throws RasterError as above.
std::string ListOthers(const std::string& directory);

/// Warns of files of a directory that may hold rasters and are not looked into.
void TellOfOthers(const std::string& directory, RasterRecord& record);
}
#endif
