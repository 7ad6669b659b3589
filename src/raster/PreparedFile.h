// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files of vtkTerrainHierarchy, read as rasters. Private to the module.
 */
#ifndef vtkTerrain_raster_PreparedFile_h
#define vtkTerrain_raster_PreparedFile_h

#include <cstdint>
#include <string>

class vtkImageData;
class vtkInformation;

namespace terrain
{
/// What a reader is asked for beside the file.
struct PreparedWishes
{
  /// For a file that names none; empty for none.
  std::string CoordinateSystem;
  /// Whether a part of the samples is wanted, or another band than the first: both are refused.
  bool IsPart = false;
  bool IsOtherBand = false;
  /// Most samples a side and in all, 0 for any: larger files are refused.
  std::int64_t MaximumSize = 0;
  std::int64_t MaximumNumberOfSamples = 0;
};

/// Tells the pipeline size, place and type of the image; and, if an image is given, fills it with
/// the extent that the pipeline asks for, as vtkTerrainHierarchy::GetHeights does. Returns one
/// sentence if that cannot be done; the image is empty then.
std::string ReadPreparedFile(
  const std::string& path, const PreparedWishes& wishes, vtkInformation* info, vtkImageData* image);
}
#endif
