// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileFile.h"

#include "core/grid/Checksum.h"
#include "core/surface/TileFileHeader.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terrain
{
namespace
{
/// Reads a range of a file; false if it is not all there.
bool ReadRange(int descriptor, void* out, std::size_t size, std::size_t offset)
{
  auto* bytes = static_cast<unsigned char*>(out);
  while (size > 0)
  {
    const ssize_t got = pread(descriptor, bytes, size, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      return false;
    }
    bytes += got;
    size -= static_cast<std::size_t>(got);
    offset += static_cast<std::size_t>(got);
  }
  return true;
}

/// One sentence about a header that cannot be used, or empty.
std::string WhyNotHeader(const TileFileHeader& header, std::size_t fileSize)
{
  if (std::memcmp(header.Magic, kTileFileMagic, sizeof(kTileFileMagic)) != 0)
  {
    return "this is no file of tiles";
  }
  if (header.ByteOrder != kTileFileByteOrder)
  {
    return "the file was written on a machine of another byte order";
  }
  if (header.Version != kTileFileVersion)
  {
    return "the file has version " + std::to_string(header.Version) + ", known is " +
      std::to_string(kTileFileVersion);
  }
  if (header.State != kTileFileComplete)
  {
    return "the file was never finished";
  }
  if (HeaderChecksum(header) != header.Checksum)
  {
    return "the header is damaged: its checksum is wrong";
  }
  if (static_cast<std::uint64_t>(fileSize) != header.FileBytes)
  {
    return "the file has " + std::to_string(fileSize) + " bytes and should have " +
      std::to_string(header.FileBytes);
  }
  return {};
}

/// True if a height is one that the type of the samples can hold.
template <typename T>
bool CanHold(double height)
{
  return height >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
    height <= static_cast<double>(std::numeric_limits<T>::max());
}

bool CanHold(StoredType type, double height)
{
  return type == StoredType::Float ? CanHold<float>(height)
    : type == StoredType::Short    ? CanHold<short>(height)
                                   : CanHold<unsigned short>(height);
}

/// True if a content can be that of a file of some bytes: before anything is made from it.
bool IsSound(const TileFileContent& content, std::uint64_t fileBytes)
{
  constexpr std::int64_t mostSamples = std::numeric_limits<std::int32_t>::max();
  constexpr int mostTileLevel = 16;
  const TileLayout& layout = content.Layout;
  const bool isLayout = layout.Width > 1 && layout.Width <= mostSamples && layout.Height > 1 &&
    layout.Height <= mostSamples && layout.TileLevel >= 0 && layout.TileLevel <= mostTileLevel &&
    content.FirstLevel > 0 && content.FirstLevel < layout.LevelCount();
  const bool isType = content.Type == StoredType::Short ||
    content.Type == StoredType::UnsignedShort || content.Type == StoredType::Float;
  const bool isEmpty = !(content.Minimum <= content.Maximum);
  if (!isLayout || !isType ||
    !(isEmpty ||
      (CanHold(content.Type, content.Minimum) && CanHold(content.Type, content.Maximum))))
  {
    return false;
  }
  const glm::i64vec2 tiles = layout.Tiles(content.FirstLevel);
  return static_cast<std::uint64_t>(tiles.x * tiles.y) <= fileBytes / sizeof(std::uint64_t);
}
}

//------------------------------------------------------------------------------
TileFileIndex::TileFileIndex(const TileFileContent& content)
  : Layout(content.Layout)
  , FirstLevel(content.FirstLevel)
  , Offsets{ kTileFileHeaderBytes }
{
  for (int level = this->FirstLevel; level < this->Layout.LevelCount(); ++level)
  {
    this->LevelBegin.push_back(this->Offsets.size() - 1);
    const glm::i64vec2 tiles = this->Layout.Tiles(level);
    for (std::int64_t tile = 0; tile < tiles.x * tiles.y; ++tile)
    {
      const glm::i64vec2 cells = this->Layout.CellCount({ level, tile % tiles.x, tile / tiles.x });
      const std::int64_t numbers = (cells.x + 1) * (cells.y + 1) + 2 * cells.x * cells.y;
      this->Offsets.push_back(
        this->Offsets.back() + static_cast<std::size_t>(numbers) * content.SampleBytes());
    }
  }
}

//------------------------------------------------------------------------------
std::size_t TileFileIndex::Number(const TileKey& key) const
{
  return this->LevelBegin[static_cast<std::size_t>(key.Level - this->FirstLevel)] +
    static_cast<std::size_t>(key.Column + this->Layout.Tiles(key.Level).x * key.Row);
}

//------------------------------------------------------------------------------
TileFile::~TileFile()
{
  this->Close();
}

//------------------------------------------------------------------------------
void TileFile::Close()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
}

//------------------------------------------------------------------------------
std::string TileFile::Open(const std::string& path)
{
  this->Close();
  std::string error = this->OpenUnchecked(path);
  if (!error.empty())
  {
    this->Close();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string TileFile::OpenUnchecked(const std::string& path)
{
  this->Descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status = {};
  if (this->Descriptor < 0 || fstat(this->Descriptor, &status) != 0)
  {
    return std::strerror(errno);
  }
  TileFileHeader header{};
  if (!ReadRange(this->Descriptor, &header, sizeof(header), 0))
  {
    return "the file is too short";
  }
  std::string error = WhyNotHeader(header, static_cast<std::size_t>(status.st_size));
  if (!error.empty())
  {
    return error;
  }
  this->Content = ContentOf(header);
  this->Index =
    IsSound(this->Content, header.FileBytes) ? TileFileIndex(this->Content) : TileFileIndex();
  if (this->Index.Count() == 0 || this->Index.FileSize() != header.FileBytes)
  {
    return "the header is damaged: its numbers contradict each other";
  }
  this->Checksums.resize(this->Index.Count());
  const std::size_t bytes = this->Checksums.size() * sizeof(std::uint64_t);
  auto* table = reinterpret_cast<unsigned char*>(this->Checksums.data());
  if (!ReadRange(this->Descriptor, table, bytes, this->Index.TableBegin()) ||
    Checksum(table, bytes) != header.TableChecksum)
  {
    return "the table of tiles is damaged: its checksum is wrong";
  }
  return {};
}

//------------------------------------------------------------------------------
template <typename T>
std::string TileFile::Read(
  const TileKey& key, std::vector<T>& samples, std::vector<PyramidNode<T>>& nodes) const
{
  const std::size_t number = this->Index.Number(key);
  const glm::i64vec2 cells = this->Content.Layout.CellCount(key);
  std::vector<unsigned char> bytes(this->Index.Size(number));
  if (!ReadRange(this->Descriptor, bytes.data(), bytes.size(), this->Index.Begin(number)))
  {
    return "the file of tiles has been cut short";
  }
  if (Checksum(bytes.data(), bytes.size()) != this->Checksums[number])
  {
    return "a tile in the file of tiles is damaged: its checksum is wrong";
  }
  samples.resize(static_cast<std::size_t>((cells.x + 1) * (cells.y + 1)));
  nodes.resize(static_cast<std::size_t>(cells.x * cells.y));
  const std::size_t sampleBytes = samples.size() * sizeof(T);
  std::memcpy(samples.data(), bytes.data(), sampleBytes);
  std::memcpy(static_cast<void*>(nodes.data()), bytes.data() + sampleBytes,
    nodes.size() * sizeof(PyramidNode<T>));
  return {};
}

template std::string TileFile::Read<short>(
  const TileKey&, std::vector<short>&, std::vector<PyramidNode<short>>&) const;
template std::string TileFile::Read<unsigned short>(
  const TileKey&, std::vector<unsigned short>&, std::vector<PyramidNode<unsigned short>>&) const;
template std::string TileFile::Read<float>(
  const TileKey&, std::vector<float>&, std::vector<PyramidNode<float>>&) const;
}
