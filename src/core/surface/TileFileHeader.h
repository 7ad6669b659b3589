// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The header of a file of tiles (TileFile.h), as it lies on the disk.
 */
#ifndef terrain_TileFileHeader_h
#define terrain_TileFileHeader_h

#include "core/grid/Checksum.h"
#include "core/surface/TileFileContent.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace terrain
{
constexpr char kTileFileMagic[8] = { 'v', 't', 'k', 'T', 'e', 'r', 'r', 'T' };
constexpr std::uint32_t kTileFileByteOrder = 0x01020304;
constexpr std::uint32_t kTileFileComplete = 1;
constexpr std::size_t kTileFileHeaderBytes = 4096;

struct TileFileHeader
{
  char Magic[8];
  std::uint32_t ByteOrder;
  std::uint32_t Version;
  std::uint32_t State;
  StoredType Type;
  std::int64_t Width;
  std::int64_t Height;
  std::int32_t TileLevel;
  std::int32_t FirstLevel;
  TileFileKey Key;
  double Minimum;
  double Maximum;
  std::uint64_t HasNoData;
  std::uint64_t FileBytes;
  std::uint64_t TableChecksum;
  /// Of the header with this field 0.
  std::uint64_t Checksum;
};
static_assert(sizeof(TileFileHeader) <= kTileFileHeaderBytes, "the header has its own page");

inline std::uint64_t HeaderChecksum(TileFileHeader header)
{
  header.Checksum = 0;
  unsigned char bytes[sizeof(TileFileHeader)];
  std::memcpy(bytes, &header, sizeof(header));
  return Checksum(bytes, sizeof(bytes));
}

/// The header of a complete file but for the table's checksum and its own.
inline TileFileHeader HeaderOf(const TileFileContent& content, std::size_t fileBytes)
{
  TileFileHeader header{};
  std::memcpy(header.Magic, kTileFileMagic, sizeof(kTileFileMagic));
  header.ByteOrder = kTileFileByteOrder;
  header.Version = kTileFileVersion;
  header.State = kTileFileComplete;
  header.Type = content.Type;
  header.Width = content.Layout.Width;
  header.Height = content.Layout.Height;
  header.TileLevel = content.Layout.TileLevel;
  header.FirstLevel = content.FirstLevel;
  header.Key = content.Key;
  header.Minimum = content.Minimum;
  header.Maximum = content.Maximum;
  header.HasNoData = content.HasNoData ? 1 : 0;
  header.FileBytes = fileBytes;
  return header;
}

inline TileFileContent ContentOf(const TileFileHeader& header)
{
  TileFileContent content;
  content.Layout = { header.Width, header.Height, header.TileLevel };
  content.FirstLevel = header.FirstLevel;
  content.Type = header.Type;
  content.Key = header.Key;
  content.Minimum = header.Minimum;
  content.Maximum = header.Maximum;
  content.HasNoData = header.HasNoData != 0;
  return content;
}
}

#endif
