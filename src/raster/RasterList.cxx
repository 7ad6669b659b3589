// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterList.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace terrain
{
namespace
{
// Pictures and virtual rasters, which lie beside tiles, are none.
constexpr std::array<const char*, 30> kTileExtensions{ { "tif", "tiff", "hgt", "dem", "asc", "img",
  "dt0", "dt1", "dt2", "bil", "bip", "bsq", "flt", "grd", "jp2", "sdat", "nc", "xyz", "bag", "bt",
  "cub", "gxf", "grb", "grib", "grib2", "hf2", "mtw", "ntf", "rst", "sigdem" } };
// Files that may hold several rasters, or none, which are told of.
constexpr std::array<const char*, 10> kOtherExtensions{ { "zip", "tar", "tgz", "gz", "7z", "gpkg",
  "h5", "hdf", "csv", "dat" } };
constexpr std::size_t kListedOthers = 5;
// Folders below each other that are looked into.
constexpr int kDeepest = 6;

template <std::size_t N>
bool EndsAsOneOf(const std::array<const char*, N>& extensions, const char* name)
{
  const char* extension = CPLGetExtension(name);
  return std::any_of(extensions.begin(), extensions.end(),
    [extension](const char* other) { return EQUAL(extension, other); });
}

/// Names of the files below a directory with one of these extensions, sorted.
template <std::size_t N>
std::vector<std::string> FindFiles(
  const std::string& directory, const std::array<const char*, N>& extensions)
{
  std::vector<std::string> files;
  VSIDIR* entries = VSIOpenDir(directory.c_str(), kDeepest, nullptr);
  if (!entries)
  {
    throw RasterError("it is a directory that cannot be listed, or an empty one");
  }
  while (const VSIDIREntry* entry = VSIGetNextDirEntry(entries))
  {
    if (EndsAsOneOf(extensions, entry->pszName) && !VSI_ISDIR(entry->nMode))
    {
      files.emplace_back(CPLFormFilename(directory.c_str(), entry->pszName, nullptr));
    }
  }
  VSICloseDir(entries);
  std::sort(files.begin(), files.end());
  return files;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> FindRasters(const std::string& directory)
{
  return FindFiles(directory, kTileExtensions);
}

//------------------------------------------------------------------------------
std::string ListOthers(const std::string& directory)
{
  std::vector<std::string> names;
  for (const std::string& file : FindFiles(directory, kOtherExtensions))
  {
    names.emplace_back(CPLGetFilename(file.c_str()));
  }
  return names.empty() ? std::string() : ListText(names, kListedOthers);
}

//------------------------------------------------------------------------------
void TellOfOthers(const std::string& directory, RasterRecord& record)
{
  const std::string others = ListOthers(directory);
  if (!others.empty())
  {
    record.Warn("not looked into in the folder: " + others + " (unpack it, or open it alone)");
  }
}
}
