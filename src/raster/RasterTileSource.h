// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A raster file as tiles, its coarse levels prepared in a file beside it or in the user's cache.
 * Private to the module.
 *
 * The prepared file of "dem.tif" is "dem.tif.tiles" if there is one, else
 * $XDG_CACHE_HOME/vtkterrain/dem.tif-<checksum of the path>.tiles, where XDG_CACHE_HOME is ~/.cache
 * unless it is set. A prepared file whose key is not the raster's as it is now is not used: the one
 * in the cache is written anew, the one beside the raster is left as it is.
 */
#ifndef vtkTerrain_raster_RasterTileSource_h
#define vtkTerrain_raster_RasterTileSource_h

#include "raster/RasterHeights.h"

#include "core/surface/TileSource.h"

#include <functional>
#include <memory>
#include <string>

namespace terrain
{
/// log2 of the cells along the side of a tile.
constexpr int kRasterTileLevel = 8;

/// How tiles are prepared.
struct RasterTileSettings
{
  RasterHeightsSettings Heights;
  /// Where the prepared file is; empty: beside the raster, else in the user's cache.
  std::string TileFileName;
  /// False: nothing prepared before is used, and nothing is left behind.
  bool UseCache = true;
  ParallelFor For = SerialFor;
  /// Called during preparation with the share that is done; returns false to stop.
  std::function<bool(double)> Progress = [](double) { return true; };
};

/// A raster as tiles.
struct PreparedRaster
{
  std::shared_ptr<TileSource> Source;
  StoredType Type = StoredType::Short;
  /// The prepared file; empty where it is kept under no name.
  std::string FileName;
  /// True if it was written now.
  bool IsNew = false;
  /// Why prepared files were not used or not kept, one sentence; empty if they were.
  std::string Message;
};

/// The name of the prepared file beside a raster.
std::string TileFileBeside(const std::string& rasterName);
/// Its name in the user's cache; empty if there is no such folder.
std::string TileFileInCache(const std::string& rasterName);

/// Opens a raster; reads all of it once if it is not prepared. Throws RasterError, also where
/// Progress stops the preparation. A raster of few samples is kept in memory.
PreparedRaster OpenTiles(const RasterTileSettings& settings);

/// Prepares a raster into a file of this name, whether or not there is one.
/// Throws RasterError.
void PrepareTileFile(const RasterTileSettings& settings, const std::string& fileName);
}
#endif
