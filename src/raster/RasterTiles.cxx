// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTiles.h"

#include "raster/RasterFile.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
namespace
{
// Pictures and virtual rasters, which lie beside tiles, are none.
constexpr std::array<const char*, 13> kTileExtensions{ { "tif", "tiff", "hgt", "dem", "asc", "img",
  "dt0", "dt1", "dt2", "bil", "flt", "grd", "jp2" } };

struct FreeStrings
{
  void operator()(char** list) const
  {
    CSLDestroy(list);
  }
};
using Strings = std::unique_ptr<char*, FreeStrings>;

struct FreeOptions
{
  void operator()(GDALBuildVRTOptions* options) const
  {
    GDALBuildVRTOptionsFree(options);
  }
};

bool IsTile(const char* name)
{
  const char* extension = CPLGetExtension(name);
  return std::any_of(kTileExtensions.begin(), kTileExtensions.end(),
    [extension](const char* other) { return EQUAL(extension, other); });
}

/// Paths of the tiles, sorted. Throws RasterError.
std::vector<std::string> FindTiles(const char* directory)
{
  std::vector<std::string> tiles;
  const Strings names(VSIReadDir(directory));
  if (!names)
  {
    throw RasterError("it is a directory that cannot be listed, or an empty one");
  }
  for (char** name = names.get(); *name; ++name)
  {
    if (IsTile(*name))
    {
      tiles.emplace_back(CPLFormFilename(directory, *name, nullptr));
    }
  }
  std::sort(tiles.begin(), tiles.end());
  return tiles;
}

/// How the virtual raster tells gaps, and what the tiles have no data for: by the value of the
/// first tile that declares one, else by the tiles' masks, else by an alpha band.
std::vector<std::string> GapOptions(const std::vector<std::string>& tiles)
{
  bool isMasked = false;
  for (const std::string& tile : tiles)
  {
    GDALDatasetH dataset = GDALOpen(tile.c_str(), GA_ReadOnly);
    GDALRasterBandH band = dataset ? GDALGetRasterBand(dataset, 1) : nullptr;
    int isDeclared = 0;
    const double value = band ? GDALGetRasterNoDataValue(band, &isDeclared) : 0.0;
    isMasked = isMasked || (band && GDALGetMaskFlags(band) == GMF_PER_DATASET);
    if (dataset)
    {
      GDALClose(dataset);
    }
    if (isDeclared != 0)
    {
      return { "-vrtnodata", CPLSPrintf("%.17g", value) };
    }
  }
  return isMasked ? std::vector<std::string>() : std::vector<std::string>{ "-addalpha" };
}

Strings MakeList(const std::vector<std::string>& texts)
{
  char** list = nullptr;
  for (const std::string& text : texts)
  {
    list = CSLAddString(list, text.c_str());
  }
  return Strings(list);
}
}

//------------------------------------------------------------------------------
GDALDatasetH OpenRasterTiles(const char* directory)
{
  const GDALMessages messages;
  const std::vector<std::string> tiles = FindTiles(directory);
  if (tiles.empty())
  {
    throw RasterError("it is a directory without elevation tiles");
  }
  const Strings names = MakeList(tiles);
  std::vector<std::string> words{ "-strict", "-resolution", "highest", "-r", "bilinear" };
  const std::vector<std::string> gaps = GapOptions(tiles);
  words.insert(words.end(), gaps.begin(), gaps.end());
  const Strings arguments = MakeList(words);
  const std::unique_ptr<GDALBuildVRTOptions, FreeOptions> options(
    GDALBuildVRTOptionsNew(arguments.get(), nullptr));
  int misuse = 0;
  GDALDatasetH terrain =
    GDALBuildVRT("", static_cast<int>(tiles.size()), nullptr, names.get(), options.get(), &misuse);
  if (!terrain)
  {
    throw RasterError("its " + std::to_string(tiles.size()) + " tiles make no one raster" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
  return terrain;
}
}
