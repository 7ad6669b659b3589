// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a file of tiles (TileFile.h) holds, and what it was made from.
 */
#ifndef terrain_TileFileContent_h
#define terrain_TileFileContent_h

#include "core/surface/TileSource.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace terrain
{
/// Version of the files that are written, and the only one that is read.
constexpr std::uint32_t kTileFileVersion = 1;

/// What a file was made from. A file with another key is of another raster, or of an older state.
struct TileFileKey
{
  /// Size of the raster file in bytes, when it was last written in nanoseconds since 1970, and
  /// checksums of some of its content and of the settings it was read with.
  std::uint64_t Bytes = 0;
  std::uint64_t Time = 0;
  std::uint64_t Content = 0;
  std::uint64_t Settings = 0;

  bool operator==(const TileFileKey& other) const
  {
    return this->Bytes == other.Bytes && this->Time == other.Time &&
      this->Content == other.Content && this->Settings == other.Settings;
  }
};

/// How samples are stored.
enum class StoredType : std::uint32_t
{
  Short = 1,
  UnsignedShort = 2,
  Float = 3
};

template <typename T>
constexpr StoredType StoredTypeOf()
{
  if constexpr (std::is_same_v<T, float>)
  {
    return StoredType::Float;
  }
  return std::is_signed_v<T> ? StoredType::Short : StoredType::UnsignedShort;
}

/// What a file holds.
struct TileFileContent
{
  TileLayout Layout;
  /// Levels from this one on are stored.
  int FirstLevel = 2;
  StoredType Type = StoredType::Short;
  TileFileKey Key;
  /// Of all samples; minimum > maximum if none has a height.
  double Minimum = 0.0;
  double Maximum = -1.0;
  bool HasNoData = false;

  std::size_t SampleBytes() const
  {
    return this->Type == StoredType::Float ? sizeof(float) : sizeof(short);
  }
};
}

#endif
