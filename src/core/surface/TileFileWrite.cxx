// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileFile.h"
#include "core/surface/TileFileHeader.h"
#include "core/surface/TilePyramid.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terrain
{
const char* const kHeightEqualsNone = "a height equals the value that stands for none";
const char* const kPreparationStopped = "its preparation was stopped";

namespace
{
/// A file under construction, locked. Its destructor removes it unless it was finished.
class PartialTileFile
{
public:
  explicit PartialTileFile(std::string path)
    : FinalPath(std::move(path))
    , Path(this->FinalPath + ".partial")
  {
  }
  PartialTileFile(const PartialTileFile&) = delete;
  PartialTileFile& operator=(const PartialTileFile&) = delete;
  ~PartialTileFile()
  {
    if (this->Descriptor >= 0)
    {
      unlink(this->Path.c_str());
      close(this->Descriptor);
    }
  }

  /// Creates the file, or takes over what a process that died has left; waits for one that lives.
  std::string Lock()
  {
    for (;;)
    {
      const int descriptor = open(this->Path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (descriptor < 0)
      {
        return std::strerror(errno);
      }
      int result = 0;
      while ((result = flock(descriptor, LOCK_EX)) != 0 && errno == EINTR)
      {
      }
      struct stat mine = {};
      struct stat named = {};
      // Whoever had the lock has renamed or removed the file: it is no longer under this name.
      if (result == 0 && fstat(descriptor, &mine) == 0 && stat(this->Path.c_str(), &named) == 0 &&
        mine.st_ino == named.st_ino && mine.st_dev == named.st_dev)
      {
        this->Descriptor = descriptor;
        return {};
      }
      const int error = errno;
      close(descriptor);
      if (result != 0)
      {
        return std::strerror(error);
      }
    }
  }

  /// Empties the file and reserves its space on the disk.
  std::string Reserve(std::size_t size)
  {
    if (ftruncate(this->Descriptor, 0) != 0)
    {
      return std::strerror(errno);
    }
    const int error = posix_fallocate(this->Descriptor, 0, static_cast<off_t>(size));
    return error != 0 ? std::strerror(error) : "";
  }

  std::string Write(const void* data, std::size_t size, std::size_t offset) const
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    while (size > 0)
    {
      const ssize_t done = pwrite(this->Descriptor, bytes, size, static_cast<off_t>(offset));
      if (done < 0 && errno != EINTR)
      {
        return std::strerror(errno);
      }
      const std::size_t written = done < 0 ? 0 : static_cast<std::size_t>(done);
      bytes += written;
      size -= written;
      offset += written;
    }
    return {};
  }

  /// Flushes the file to the disk and gives it its name.
  std::string Finish()
  {
    if (fsync(this->Descriptor) != 0 ||
      std::rename(this->Path.c_str(), this->FinalPath.c_str()) != 0)
    {
      return std::strerror(errno);
    }
    close(this->Descriptor);
    this->Descriptor = -1;
    return {};
  }

private:
  std::string FinalPath;
  std::string Path;
  int Descriptor = -1;
};

/// One sentence if the disk has less space than the finest level alone takes, or empty. It is asked
/// before the index is made, which takes memory in proportion.
template <typename T>
std::string WhyNoSpace(const std::string& path, const TilePreparation<T>& preparation)
{
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  // A cell has a sample and its two bounds.
  const double needed =
    std::ldexp(static_cast<double>(preparation.Layout.Width), -preparation.FirstLevel) *
    std::ldexp(static_cast<double>(preparation.Layout.Height), -preparation.FirstLevel) * 3.0 *
    sizeof(T);
  if (error || needed <= static_cast<double>(space.available))
  {
    return {};
  }
  const auto gigabytes = [](double bytes)
  { return std::to_string(static_cast<std::int64_t>(std::ceil(bytes / 1e9))); };
  return "it needs " + gigabytes(needed) + " GB, and " +
    gigabytes(static_cast<double>(space.available)) +
    " GB are free there; draw a part of the raster";
}

/// The first error of several threads.
class FirstError
{
public:
  void Report(const std::string& error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Text = this->Text.empty() ? error : this->Text;
    this->Any = this->Any || !error.empty();
  }
  bool IsSet() const
  {
    return this->Any;
  }
  std::string Get() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Text;
  }

private:
  mutable std::mutex Mutex;
  std::string Text;
  std::atomic<bool> Any{ false };
};

/// Appends a row of a plane.
template <typename T>
void Append(std::vector<unsigned char>& bytes, const T* values, std::int64_t count)
{
  const auto* begin = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), begin, begin + static_cast<std::size_t>(count) * sizeof(T));
}

/// The pass over a raster, into a file that is locked.
template <typename T>
class TileWriter
{
public:
  TileWriter(const TilePreparation<T>& preparation, PartialTileFile& file)
    : Preparation(preparation)
    , File(file)
  {
    this->Content.Layout = preparation.Layout;
    this->Content.FirstLevel = preparation.FirstLevel;
    this->Content.Type = StoredTypeOf<T>();
    this->Content.Key = preparation.Key;
    this->Index = TileFileIndex(this->Content);
    this->Checksums.resize(this->Index.Count());
  }

  std::string Write()
  {
    const std::string full = this->File.Reserve(this->Index.FileSize());
    return full.empty() ? this->WriteTiles() : full;
  }

private:
  std::string WriteTiles()
  {
    const TilePreparation<T>& p = this->Preparation;
    TilePyramid<T> pyramid(
      p.Layout, p.FirstLevel,
      [this](int level, std::int64_t row, const LevelPlane<const T>& samples,
        const LevelPlane<const PyramidNode<T>>& nodes)
      { this->WriteRow(level, row, samples, nodes); },
      p.For);
    for (std::int64_t first = 0; first < p.Layout.Height;)
    {
      const std::int64_t count =
        std::clamp<std::int64_t>(p.CountRows(first), 1, p.Layout.Height - first);
      T* rows = pyramid.AddRows(count);
      std::string error = p.Read(first, count, rows);
      if (!error.empty())
      {
        return error;
      }
      this->FindRange(rows, count);
      pyramid.Build();
      first += count;
      if (this->Errors.IsSet())
      {
        return this->Errors.Get();
      }
      if (!p.Progress(static_cast<double>(first) / static_cast<double>(p.Layout.Height)))
      {
        return kPreparationStopped;
      }
    }
    return this->WriteEnds();
  }

  void FindRange(const T* rows, std::int64_t count)
  {
    const std::int64_t width = this->Preparation.Layout.Width;
    this->Preparation.For(count,
      [&](std::int64_t begin, std::int64_t end)
      {
        HeightfieldView<T> view;
        view.Samples = rows + width * begin;
        view.Width = width;
        view.Height = end - begin;
        view.HasNoData = !std::is_same_v<T, float>;
        view.NoData = NoStoredHeight<T>();
        const HeightRange<T> range = FindHeightRange(view, SerialFor);
        const std::lock_guard<std::mutex> lock(this->RangeMutex);
        this->Range.Minimum = std::min(this->Range.Minimum, range.Minimum);
        this->Range.Maximum = std::max(this->Range.Maximum, range.Maximum);
        this->Range.HasNoData = this->Range.HasNoData || range.HasNoData;
      });
  }

  void WriteRow(int level, std::int64_t row, const LevelPlane<const T>& samples,
    const LevelPlane<const PyramidNode<T>>& nodes)
  {
    this->Preparation.For(this->Preparation.Layout.Tiles(level).x,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t column = begin; column < end && !this->Errors.IsSet(); ++column)
        {
          this->WriteTile({ level, column, row }, samples, nodes);
        }
      });
  }

  void WriteTile(const TileKey& key, const LevelPlane<const T>& samples,
    const LevelPlane<const PyramidNode<T>>& nodes)
  {
    const glm::i64vec2 first = this->Preparation.Layout.FirstCell(key);
    const glm::i64vec2 cells = this->Preparation.Layout.CellCount(key);
    const std::size_t number = this->Index.Number(key);
    std::vector<unsigned char> bytes;
    bytes.reserve(this->Index.Size(number));
    for (std::int64_t y = first.y; y <= first.y + cells.y; ++y)
    {
      Append(bytes, &samples.At(first.x, y), cells.x + 1);
    }
    for (std::int64_t y = first.y; y < first.y + cells.y; ++y)
    {
      Append(bytes, &nodes.At(first.x, y), cells.x);
    }
    this->Checksums[number] = Checksum(bytes.data(), bytes.size());
    this->Errors.Report(this->File.Write(bytes.data(), bytes.size(), this->Index.Begin(number)));
  }

  std::string WriteEnds()
  {
    const bool any = this->Range.Minimum <= this->Range.Maximum;
    this->Content.Minimum = any ? static_cast<double>(this->Range.Minimum) : 0.0;
    this->Content.Maximum = any ? static_cast<double>(this->Range.Maximum) : -1.0;
    this->Content.HasNoData = this->Range.HasNoData;
    const auto* table = reinterpret_cast<const unsigned char*>(this->Checksums.data());
    const std::size_t bytes = this->Checksums.size() * sizeof(std::uint64_t);
    TileFileHeader header = HeaderOf(this->Content, this->Index.FileSize());
    header.TableChecksum = Checksum(table, bytes);
    header.Checksum = HeaderChecksum(header);
    std::string error = this->File.Write(table, bytes, this->Index.TableBegin());
    error = error.empty() ? this->File.Write(&header, sizeof(header), 0) : error;
    return error;
  }

  const TilePreparation<T>& Preparation;
  PartialTileFile& File;
  TileFileContent Content;
  TileFileIndex Index;
  std::vector<std::uint64_t> Checksums;
  FirstError Errors;
  std::mutex RangeMutex;
  HeightRange<T> Range;
};

/// True if a complete file for this preparation has appeared.
template <typename T>
bool IsThere(const std::string& path, const TilePreparation<T>& preparation)
{
  TileFile file;
  return file.Open(path).empty() && file.GetContent().Key == preparation.Key &&
    file.GetContent().Layout == preparation.Layout;
}
}

//------------------------------------------------------------------------------
template <typename T>
std::string WriteTileFile(const std::string& path, const TilePreparation<T>& preparation)
{
  if (preparation.FirstLevel < 1 || preparation.Layout.LevelCount() <= preparation.FirstLevel)
  {
    return "the raster is too small to need levels";
  }
  if (std::string lack = WhyNoSpace(path, preparation); !lack.empty())
  {
    return lack;
  }
  PartialTileFile file(path);
  std::string error = file.Lock();
  if (!error.empty() || IsThere(path, preparation)) // another process has written it meanwhile
  {
    return error;
  }
  TileWriter<T> writer(preparation, file);
  error = writer.Write();
  return error.empty() ? file.Finish() : error;
}

template std::string WriteTileFile<short>(const std::string&, const TilePreparation<short>&);
template std::string WriteTileFile<unsigned short>(
  const std::string&, const TilePreparation<unsigned short>&);
template std::string WriteTileFile<float>(const std::string&, const TilePreparation<float>&);
}
