// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTileSource.h"

#include "core/grid/Checksum.h"
#include "core/surface/MemoryTiles.h"
#include "core/surface/PreparedTiles.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace terrain
{
namespace
{
// Finer levels are made of the raster when they are needed.
constexpr int kFirstLevel = 2;

constexpr const char* kSuffix = ".tiles";

TileLayout LayoutOf(const RasterHeights& heights)
{
  return { heights.GetWidth(), heights.GetHeight(), kRasterTileLevel };
}

/// The path without links and dots, if the raster is a file.
std::string FullPath(const std::string& name)
{
  std::error_code error;
  const std::filesystem::path path = std::filesystem::canonical(name, error);
  return error ? name : path.string();
}

/// Writes a file of tiles of samples of type T.
template <typename T>
std::string WriteAs(const RasterHeights& heights, const TileFileKey& key,
  const RasterTileSettings& settings, const std::string& fileName)
{
  TilePreparation<T> preparation;
  preparation.Layout = LayoutOf(heights);
  preparation.FirstLevel = kFirstLevel;
  preparation.Key = key;
  preparation.Read = [&](std::int64_t first, std::int64_t count, T* samples)
  { return heights.ReadRows(first, count, samples, settings.For); };
  preparation.CountRows = [&](std::int64_t first) { return heights.CountRows(first); };
  preparation.For = settings.For;
  preparation.Progress = settings.Progress;
  return WriteTileFile<T>(fileName, preparation);
}

/// Writes a file of tiles in the smallest type. Returns an error message, empty if all is well.
std::string Write(const RasterHeights& heights, const TileFileKey& key,
  const RasterTileSettings& settings, const std::string& fileName)
{
  std::string error = kHeightEqualsNone;
  if (heights.GetType() == StoredType::Short)
  {
    error = WriteAs<short>(heights, key, settings, fileName);
  }
  else if (heights.GetType() == StoredType::UnsignedShort)
  {
    error = WriteAs<unsigned short>(heights, key, settings, fileName);
  }
  return error == kHeightEqualsNone ? WriteAs<float>(heights, key, settings, fileName) : error;
}

template <typename T>
std::shared_ptr<TileSource> OpenAs(
  const std::shared_ptr<RasterHeights>& heights, std::unique_ptr<TileFile> file)
{
  auto tiles = std::make_shared<PreparedTiles<T>>();
  const auto read = [heights](glm::i64vec2 first, glm::i64vec2 size, T* samples)
  { return heights->Read(first, size, samples); };
  return tiles->Open(std::move(file), read).empty() ? tiles : nullptr;
}

/// Takes a prepared file if it is of this raster. Returns why not, empty if it is taken.
std::string Take(const std::string& fileName, const std::shared_ptr<RasterHeights>& heights,
  const TileFileKey& key, PreparedRaster& tiles)
{
  auto file = std::make_unique<TileFile>();
  std::string error = file->Open(fileName);
  if (!error.empty())
  {
    return error;
  }
  const TileFileContent& content = file->GetContent();
  if (!(content.Key == key) || !(content.Layout == LayoutOf(*heights)))
  {
    return "it was prepared from another raster, or from this one before it changed";
  }
  tiles.Type = content.Type;
  tiles.Source = content.Type == StoredType::Short ? OpenAs<short>(heights, std::move(file))
    : content.Type == StoredType::UnsignedShort ? OpenAs<unsigned short>(heights, std::move(file))
                                                : OpenAs<float>(heights, std::move(file));
  return tiles.Source ? "" : "its tiles are damaged";
}

template <typename T>
void HoldAs(const RasterHeights& heights, PreparedRaster& tiles)
{
  const TileLayout layout = LayoutOf(heights);
  std::vector<T> samples(static_cast<std::size_t>(layout.Width * layout.Height));
  const std::string error =
    heights.Read({ 0, 0 }, glm::i64vec2(layout.Width, layout.Height), samples.data());
  if (!error.empty())
  {
    throw RasterError(error);
  }
  tiles.Type = StoredTypeOf<T>();
  tiles.Source = std::make_shared<MemoryTiles<T>>(samples.data(), layout, SerialFor);
}

/// A raster that is too small to be prepared, in memory.
void Hold(const RasterHeights& heights, PreparedRaster& tiles)
{
  try
  {
    heights.GetType() == StoredType::Short             ? HoldAs<short>(heights, tiles)
      : heights.GetType() == StoredType::UnsignedShort ? HoldAs<unsigned short>(heights, tiles)
                                                       : HoldAs<float>(heights, tiles);
  }
  catch (const RasterError& error)
  {
    if (error.what() != std::string(kHeightEqualsNone))
    {
      throw;
    }
    HoldAs<float>(heights, tiles);
  }
}

/// Prepares into the cache, or else into a file that is removed at once and kept open.
void PrepareAndTake(const std::shared_ptr<RasterHeights>& heights, const TileFileKey& key,
  const RasterTileSettings& settings, std::string fileName, PreparedRaster& tiles)
{
  std::string error =
    fileName.empty() ? "no folder for it is known" : Write(*heights, key, settings, fileName);
  bool isKept = settings.UseCache && error.empty();
  if (error == kPreparationStopped)
  {
    throw RasterError(error);
  }
  if (!error.empty() && settings.TileFileName.empty())
  {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    if (!fileName.empty())
    {
      tiles.Message = "its prepared levels cannot be kept in " + fileName + " (" + error + ")";
    }
    fileName = (folder / ("vtkterrain-" + std::to_string(getpid()) + kSuffix)).string();
    error = Write(*heights, key, settings, fileName);
    isKept = false;
  }
  error = error.empty() ? Take(fileName, heights, key, tiles) : error;
  if (!isKept && !fileName.empty())
  {
    std::remove(fileName.c_str());
  }
  if (!error.empty())
  {
    throw RasterError("its levels cannot be prepared in " + fileName + " (" + error + ")");
  }
  tiles.FileName = isKept ? fileName : "";
  tiles.IsNew = true;
}
}

//------------------------------------------------------------------------------
std::string TileFileBeside(const std::string& rasterName)
{
  return FullPath(rasterName) + kSuffix;
}

//------------------------------------------------------------------------------
std::string TileFileInCache(const std::string& rasterName)
{
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (cache && *cache == '/') // the specification ignores relative ones
  {
    folder = cache;
  }
  else if (home && *home)
  {
    folder = std::filesystem::path(home) / ".cache";
  }
  else
  {
    return {};
  }
  const std::string path = FullPath(rasterName);
  std::ostringstream name;
  const std::size_t slash = path.find_last_of('/');
  name << path.substr(slash == std::string::npos ? 0 : slash + 1).substr(0, 100) << '-' << std::hex
       << Checksum(reinterpret_cast<const unsigned char*>(path.data()), path.size()) << kSuffix;
  folder /= "vtkterrain";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return (folder / name.str()).string();
}

//------------------------------------------------------------------------------
PreparedRaster OpenTiles(const RasterTileSettings& settings)
{
  PreparedRaster tiles;
  const auto heights = std::make_shared<RasterHeights>(settings.Heights);
  if (LayoutOf(*heights).LevelCount() <= kFirstLevel)
  {
    Hold(*heights, tiles);
    return tiles;
  }
  const TileFileKey key = heights->FindKey();
  std::string name = settings.TileFileName;
  if (name.empty() && settings.UseCache)
  {
    const std::string& raster = settings.Heights.FileName;
    const std::string beside = TileFileBeside(raster);
    if (Take(beside, heights, key, tiles).empty())
    {
      tiles.FileName = beside;
      return tiles;
    }
    name = TileFileInCache(raster);
  }
  if (settings.UseCache && !name.empty() && Take(name, heights, key, tiles).empty())
  {
    tiles.FileName = name;
    return tiles;
  }
  PrepareAndTake(heights, key, settings, settings.UseCache ? name : "", tiles);
  return tiles;
}

//------------------------------------------------------------------------------
void PrepareTileFile(const RasterTileSettings& settings, const std::string& fileName)
{
  const RasterHeights heights(settings.Heights);
  const std::string error = Write(heights, heights.FindKey(), settings, fileName);
  if (!error.empty())
  {
    throw RasterError(error);
  }
}
}
