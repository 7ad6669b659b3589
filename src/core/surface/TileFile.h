// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Coarse levels of tiles (TileSource.h) in a file beside the raster that has level 0.
 *
 * A file is a header of 4096 bytes, the tiles from the first stored level up, each row by row from
 * the south-west, and a table with a 64-bit checksum of every tile. A tile is its samples and then
 * its nodes (maximum and minimum) in the type of the samples, short, unsigned short or float, in
 * the byte order of the machine that wrote the file; others refuse it. Tiles at the east and north
 * edges are smaller, so that every offset follows from the layout.
 *
 * The header holds magic, version, byte order, state, layout, the key of the raster, the heights'
 * bounds, checksums of itself and of the table. A file is written under its name with ".partial"
 * appended, all of its space reserved first, then flushed to the disk and renamed: under its own
 * name it is complete. The partial file is locked, so that of several processes one writes and the
 * others wait; what a process that died has left behind is written anew.
 */
#ifndef terrain_TileFile_h
#define terrain_TileFile_h

#include "core/grid/ParallelFor.h"
#include "core/surface/TileFileContent.h"
#include "core/surface/TileReduction.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace terrain
{
/// Where the tiles of a file are.
class TileFileIndex
{
public:
  TileFileIndex() = default;
  explicit TileFileIndex(const TileFileContent& content);

  /// Number of a stored tile, in the order of the file.
  std::size_t Number(const TileKey& key) const;
  std::size_t Begin(std::size_t number) const
  {
    return this->Offsets[number];
  }
  std::size_t Size(std::size_t number) const
  {
    return this->Offsets[number + 1] - this->Offsets[number];
  }
  std::size_t Count() const
  {
    return this->Offsets.size() - 1;
  }
  std::size_t TableBegin() const
  {
    return this->Offsets.back();
  }
  std::size_t FileSize() const
  {
    return this->TableBegin() + this->Count() * sizeof(std::uint64_t);
  }

private:
  TileLayout Layout;
  int FirstLevel = 0;
  std::vector<std::size_t> LevelBegin; // number of the first tile of a level
  std::vector<std::size_t> Offsets{ 0 };
};

/// An open file of tiles; reading is safe from several threads.
class TileFile
{
public:
  TileFile() = default;
  ~TileFile();
  TileFile(const TileFile&) = delete;
  TileFile& operator=(const TileFile&) = delete;

  /// Opens a file and checks header, size and table. Returns an error message, empty if all is
  /// well; the content is then GetContent().
  std::string Open(const std::string& path);
  bool IsOpen() const
  {
    return this->Descriptor >= 0;
  }
  void Close();
  const TileFileContent& GetContent() const
  {
    return this->Content;
  }
  std::size_t FileSize() const
  {
    return this->Index.FileSize();
  }

  /// Reads a stored tile; T is the content's type. Returns an error message, empty if all is well.
  template <typename T>
  std::string Read(
    const TileKey& key, std::vector<T>& samples, std::vector<PyramidNode<T>>& nodes) const;

private:
  std::string OpenUnchecked(const std::string& path);

  int Descriptor = -1;
  TileFileContent Content;
  TileFileIndex Index;
  std::vector<std::uint64_t> Checksums;
};

/// Fills rows [first, first + count) of level 0, row by row from the south. Returns an error
/// message, empty if all is well.
template <typename T>
using ReadTileRows = std::function<std::string(std::int64_t first, std::int64_t count, T* samples)>;

/// What the pass over a raster needs.
template <typename T>
struct TilePreparation
{
  TileLayout Layout;
  int FirstLevel = 2;
  TileFileKey Key;
  ReadTileRows<T> Read;
  /// The next number of rows that are cheap to read together, given the first one; at least 1.
  std::function<std::int64_t(std::int64_t first)> CountRows;
  ParallelFor For;
  /// Called with the share that is done; returns false to stop.
  std::function<bool(double)> Progress;
};

/// Errors of WriteTileFile(): a raster's type cannot hold its heights; Progress has said stop.
extern const char* const kHeightEqualsNone;
extern const char* const kPreparationStopped;

/// Reads a raster once and writes its tiles. If another process writes the same file, waits for it.
/// Returns an error message, empty if all is well or stopped; then nothing is left behind.
/// kHeightEqualsNone: a sample's height may be the value that stands for none; use float.
template <typename T>
std::string WriteTileFile(const std::string& path, const TilePreparation<T>& preparation);
}

#endif
