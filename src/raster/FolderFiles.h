// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the files of a directory or archive are, through GDAL's C API. Private to the module.
 */
#ifndef vtkTerrain_raster_FolderFiles_h
#define vtkTerrain_raster_FolderFiles_h

#include "raster/RasterRecord.h"

#include <string>
#include <vector>

namespace terrain
{
/// Paths below a directory, sorted. What belongs to another file (.prj, .hdr, .aux.xml, overviews)
/// is in none of the lists.
struct FolderFiles
{
  /// Elevation tiles: files called as those are, texts that GDAL opens as rasters, and other
  /// rasters that may be heights (IsCalledTile() is false): of more than bytes, with a place, not
  /// virtual.
  std::vector<std::string> Rasters;
  /// .zip, .tar and others.
  std::vector<std::string> Archives;
  /// Other files that GDAL knows as rasters: pictures, virtual rasters.
  std::vector<std::string> OtherRasters;
  /// Points, lines and meshes.
  std::vector<std::string> Shapes;
  /// All others, such as a read-me.
  std::vector<std::string> Documents;
};

/// True for names that elevation tiles have.
bool IsCalledTile(const std::string& path);

/// Looks at the files of a directory or archive and of six levels below it. Throws RasterError if
/// it cannot be listed.
FolderFiles FindFolderFiles(const std::string& directory);

/// What beside the elevation tiles there is and what to do with it; empty for nothing.
std::string DescribeOthers(const FolderFiles& files);

/// Warns of what DescribeOthers() tells, and notes the documents in the record.
void TellOfOthers(const FolderFiles& files, RasterRecord& record);
}
#endif
