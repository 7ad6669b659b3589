// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyFile.h"

#include "core/files/OutputFile.h"
#include "core/grid/Checksum.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>

namespace terrain
{
namespace
{
constexpr char kMagic[8] = { 'v', 't', 'k', 'T', 'e', 'r', 'r', 'H' };
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kComplete = 1;

struct FileHeader
{
  char Magic[8];
  std::uint32_t ByteOrder;
  std::uint32_t Version;
  std::uint32_t State;
  std::uint32_t HasHoles;
  std::int64_t Width;
  std::int64_t Height;
  double Origin[3];
  double Spacing[2];
  float Corners[4];
  std::uint32_t CornerGradients[4];
  float MinimumHeight;
  float MaximumHeight;
  std::int64_t RecordCount;
  std::int64_t CrsBytes;
  std::int64_t FileBytes;
  std::uint64_t TableChecksum;
  /// Of the header with this field 0.
  std::uint64_t Checksum;
};
static_assert(sizeof(FileHeader) <= kHierarchyHeaderBytes, "the header has its own pages");

/// How heights are laid out, kPlacingOffset bytes from the begin of the file; all 0 if that is not
/// known.
struct FilePlacing
{
  double LayoutOrigin[2];
  double LayoutScale[2];
  std::uint64_t Checksum;
};
constexpr std::size_t kPlacingOffset = 2048;
static_assert(sizeof(FileHeader) <= kPlacingOffset &&
    kPlacingOffset + sizeof(FilePlacing) <= kHierarchyHeaderBytes,
  "both lie in the header's pages");

/// Where the parts of a file begin.
struct FileParts
{
  std::size_t Records = kHierarchyHeaderBytes;
  std::size_t Gradients = 0;
  std::size_t Crs = 0;
  std::size_t Table = 0;
  std::size_t End = 0;

  FileParts(std::int64_t recordCount, std::size_t crsBytes)
  {
    const auto count = static_cast<std::size_t>(recordCount);
    this->Gradients = this->Records + count * sizeof(HierarchyRecord);
    this->Crs = this->Gradients + count * sizeof(HierarchyGradient);
    this->Table = (this->Crs + crsBytes + 7) & ~std::size_t(7);
    this->End = this->Table + this->Blocks() * sizeof(std::uint64_t);
  }
  std::size_t Blocks() const
  {
    return (this->Table - this->Records + kHierarchyBlockBytes - 1) / kHierarchyBlockBytes;
  }
};

std::uint64_t BlockChecksum(const unsigned char* file, const FileParts& parts, std::size_t block)
{
  const std::size_t begin = parts.Records + block * kHierarchyBlockBytes;
  return Checksum(file + begin, std::min(kHierarchyBlockBytes, parts.Table - begin));
}

std::uint64_t HeaderChecksum(FileHeader header)
{
  header.Checksum = 0;
  unsigned char bytes[sizeof(FileHeader)];
  std::memcpy(bytes, &header, sizeof(header));
  return Checksum(bytes, sizeof(bytes));
}

std::uint64_t PlacingChecksum(const FilePlacing& placing)
{
  unsigned char bytes[offsetof(FilePlacing, Checksum)];
  std::memcpy(bytes, &placing, sizeof(bytes));
  return Checksum(bytes, sizeof(bytes));
}

void WritePlacing(const HierarchyPlacing& placing, unsigned char* file)
{
  if (placing.HasLayout)
  {
    FilePlacing layout = { { placing.LayoutOrigin.x, placing.LayoutOrigin.y },
      { placing.LayoutScale.x, placing.LayoutScale.y }, 0 };
    layout.Checksum = PlacingChecksum(layout);
    std::memcpy(file + kPlacingOffset, &layout, sizeof(layout));
  }
}

/// Returns one sentence if the layout is damaged.
std::string ReadPlacing(const unsigned char* file, HierarchyPlacing& placing)
{
  FilePlacing layout = {};
  std::memcpy(&layout, file + kPlacingOffset, sizeof(layout));
  placing.HasLayout = layout.LayoutScale[0] != 0.0;
  if (placing.HasLayout && layout.Checksum != PlacingChecksum(layout))
  {
    return "the header is damaged: the checksum of the layout is wrong";
  }
  if (placing.HasLayout)
  {
    placing.LayoutOrigin = { layout.LayoutOrigin[0], layout.LayoutOrigin[1] };
    placing.LayoutScale = { layout.LayoutScale[0], layout.LayoutScale[1] };
  }
  return {};
}

/// One sentence about a header that cannot be used, or empty.
std::string WhyNotHeader(const FileHeader& header, std::size_t fileSize)
{
  if (std::memcmp(header.Magic, kMagic, sizeof(kMagic)) != 0)
  {
    return "this is no hierarchy file";
  }
  if (header.ByteOrder != kByteOrder)
  {
    return "the file was written on a machine of another byte order";
  }
  if (header.Version > kHierarchyFileVersion)
  {
    return "the file has version " + std::to_string(header.Version) + ", the newest known is " +
      std::to_string(kHierarchyFileVersion);
  }
  if (header.State != kComplete)
  {
    return "the file is still being written, or was never finished";
  }
  if (HeaderChecksum(header) != header.Checksum)
  {
    return "the header is damaged: its checksum is wrong";
  }
  if (static_cast<std::int64_t>(fileSize) != header.FileBytes)
  {
    return "the file has " + std::to_string(fileSize) + " bytes and should have " +
      std::to_string(header.FileBytes);
  }
  return HierarchyLayout::WhyNotSize(header.Width, header.Height);
}

/// True if the numbers of a header can be those of a raster.
bool AreNumbersSound(const FileHeader& header)
{
  bool sound = header.Spacing[0] > 0.0 && header.Spacing[1] > 0.0;
  for (const double number :
    { header.Origin[0], header.Origin[1], header.Origin[2], header.Spacing[0], header.Spacing[1] })
  {
    sound = sound && std::isfinite(number);
  }
  for (const float height : { header.Corners[0], header.Corners[1], header.Corners[2],
         header.Corners[3], header.MinimumHeight, header.MaximumHeight })
  {
    sound = sound && std::isfinite(height);
  }
  return sound;
}

/// An output whose space is reserved on the disk and mapped.
class MappedOutput
{
public:
  MappedOutput() = default;
  MappedOutput(const MappedOutput&) = delete;
  MappedOutput& operator=(const MappedOutput&) = delete;
  ~MappedOutput()
  {
    this->Unmap();
  }

  /// Reserves `size` bytes on the disk and maps them.
  std::string Create(const std::string& path, std::size_t size)
  {
    std::string error = this->File.Open(path);
    if (!error.empty())
    {
      return error;
    }
    const int reserved = posix_fallocate(this->File.GetDescriptor(), 0, static_cast<off_t>(size));
    if (reserved != 0)
    {
      return std::strerror(reserved);
    }
    void* begin =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, this->File.GetDescriptor(), 0);
    if (begin == MAP_FAILED)
    {
      return std::strerror(errno);
    }
    this->Begin = static_cast<unsigned char*>(begin);
    this->Size = size;
    return {};
  }

  unsigned char* Data() const
  {
    return this->Begin;
  }

  /// Flushes the file to the disk and gives it its name.
  std::string Finish()
  {
    if (msync(this->Begin, this->Size, MS_SYNC) != 0)
    {
      return std::strerror(errno);
    }
    this->Unmap();
    return this->File.Commit();
  }

private:
  void Unmap()
  {
    if (this->Begin)
    {
      munmap(this->Begin, this->Size);
      this->Begin = nullptr;
    }
  }

  OutputFile File;
  unsigned char* Begin = nullptr;
  std::size_t Size = 0;
};

/// Writes a file whose records, gradients and summary `fill` gives.
std::string WriteFile(const std::string& path, const HierarchyLayout& layout,
  const GridGeometry& geometry, const HierarchyPlacing& placing,
  const std::function<std::string(HierarchyTarget&)>& fill)
{
  const std::string& crs = placing.CoordinateSystem;
  const FileParts parts(layout.RecordCount(), crs.size());
  MappedOutput file;
  std::string error = file.Create(path, parts.End);
  if (!error.empty())
  {
    return error;
  }
  FileHeader header = {};
  std::memcpy(header.Magic, kMagic, sizeof(kMagic));
  header.ByteOrder = kByteOrder;
  header.Version = kHierarchyFileVersion;
  std::memcpy(file.Data(), &header, sizeof(header));
  HierarchyTarget target;
  target.Layout = &layout;
  target.Geometry = geometry;
  target.Records = reinterpret_cast<HierarchyRecord*>(file.Data() + parts.Records);
  target.Gradients = reinterpret_cast<HierarchyGradient*>(file.Data() + parts.Gradients);
  error = fill(target);
  if (!error.empty())
  {
    return error;
  }
  std::memcpy(file.Data() + parts.Crs, crs.data(), crs.size());
  WritePlacing(placing, file.Data());
  std::vector<std::uint64_t> table(parts.Blocks());
  for (std::size_t block = 0; block < table.size(); ++block)
  {
    table[block] = BlockChecksum(file.Data(), parts, block);
  }
  std::memcpy(file.Data() + parts.Table, table.data(), table.size() * sizeof(std::uint64_t));
  header.TableChecksum = Checksum(file.Data() + parts.Table, parts.End - parts.Table);
  header.HasHoles = target.Summary.HasHoles ? 1 : 0;
  header.Width = layout.Width();
  header.Height = layout.Height();
  for (int i = 0; i < 3; ++i)
  {
    header.Origin[i] = geometry.Origin[i];
  }
  header.Spacing[0] = geometry.Spacing.x;
  header.Spacing[1] = geometry.Spacing.y;
  for (int corner = 0; corner < 4; ++corner)
  {
    header.Corners[corner] = target.Summary.Corners[corner];
    header.CornerGradients[corner] = target.Summary.CornerGradients[corner].Packed;
  }
  header.MinimumHeight = target.Summary.MinimumHeight;
  header.MaximumHeight = target.Summary.MaximumHeight;
  header.RecordCount = layout.RecordCount();
  header.CrsBytes = static_cast<std::int64_t>(crs.size());
  header.FileBytes = static_cast<std::int64_t>(parts.End);
  header.State = kComplete;
  header.Checksum = HeaderChecksum(header);
  std::memcpy(file.Data(), &header, sizeof(header));
  return file.Finish();
}
}

bool IsHierarchyFile(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) // a pipe would wait for a writer
  {
    return false;
  }
  char begin[sizeof(kMagic)] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(begin, sizeof(begin));
  return file && std::memcmp(begin, kMagic, sizeof(kMagic)) == 0;
}

std::string HierarchyFile::Open(const std::string& path, bool verify)
{
  std::string error = this->File.Open(path);
  if (!error.empty())
  {
    return error;
  }
  FileHeader header = {};
  if (this->File.Size() < kHierarchyHeaderBytes)
  {
    const std::size_t known = std::min(this->File.Size(), sizeof(kMagic));
    const bool begins = std::memcmp(this->File.Data(), kMagic, known) == 0;
    return begins ? "the file ends within its header" : "this is no hierarchy file";
  }
  std::memcpy(&header, this->File.Data(), sizeof(header));
  error = WhyNotHeader(header, this->File.Size());
  if (!error.empty())
  {
    return error;
  }
  this->Layout = HierarchyLayout(header.Width, header.Height);
  const FileParts parts(this->Layout.RecordCount(), static_cast<std::size_t>(header.CrsBytes));
  if (header.CrsBytes < 0 || header.RecordCount != this->Layout.RecordCount() ||
    parts.End != this->File.Size() || !AreNumbersSound(header))
  {
    return "the header contradicts itself";
  }
  this->RecordOffset = parts.Records;
  this->GradientOffset = parts.Gradients;
  this->TableOffset = parts.Table;
  if (Checksum(this->File.Data() + parts.Table, parts.End - parts.Table) != header.TableChecksum)
  {
    return "the table of checksums is damaged";
  }
  this->Geometry.Origin = { header.Origin[0], header.Origin[1], header.Origin[2] };
  this->Geometry.Spacing = { header.Spacing[0], header.Spacing[1] };
  for (int corner = 0; corner < 4; ++corner)
  {
    this->Summary.Corners[corner] = header.Corners[corner];
    this->Summary.CornerGradients[corner].Packed = header.CornerGradients[corner];
  }
  this->Summary.MinimumHeight = header.MinimumHeight;
  this->Summary.MaximumHeight = header.MaximumHeight;
  this->Summary.HasHoles = header.HasHoles != 0;
  this->Place.CoordinateSystem.assign(reinterpret_cast<const char*>(this->File.Data() + parts.Crs),
    static_cast<std::size_t>(header.CrsBytes));
  error = ReadPlacing(this->File.Data(), this->Place);
  if (error.empty() && verify)
  {
    error = this->Verify();
  }
  // The coarse half of the pairs is needed in every view, the rest near the eye.
  const std::size_t fine = this->RecordOffset +
    static_cast<std::size_t>(this->Layout.FirstRecord((this->Layout.Pairs() + 1) / 2)) *
      sizeof(HierarchyRecord);
  this->File.AdviseRandom(fine, this->TableOffset);
  this->File.AdviseNeeded(this->RecordOffset, fine);
  return error.empty() && this->IsDamaged() ? "the file shrank while it was opened" : error;
}

std::string HierarchyFile::Verify() const
{
  const FileParts parts(this->Layout.RecordCount(), this->Place.CoordinateSystem.size());
  for (std::size_t block = 0; block < parts.Blocks(); ++block)
  {
    std::uint64_t expected = 0;
    std::memcpy(
      &expected, this->File.Data() + parts.Table + block * sizeof(expected), sizeof(expected));
    if (BlockChecksum(this->File.Data(), parts, block) != expected)
    {
      return "block " + std::to_string(block) + " of " + std::to_string(parts.Blocks()) +
        " is damaged: its checksum is wrong";
    }
  }
  const HierarchyView view = this->View();
  for (std::int64_t i = 0; i < this->Layout.RecordCount(); ++i)
  {
    const HierarchyRecord& record = view.Records[i];
    // Errors and radii may be infinite.
    if (!std::isfinite(record.Height) || std::isnan(record.Error()) || std::isnan(record.Radius()))
    {
      return "record " + std::to_string(i) + " has no number, although its checksum is right";
    }
  }
  return {};
}

HierarchyView HierarchyFile::View() const
{
  HierarchyView view;
  view.Layout = &this->Layout;
  view.Records = reinterpret_cast<const HierarchyRecord*>(this->File.Data() + this->RecordOffset);
  view.Gradients =
    reinterpret_cast<const HierarchyGradient*>(this->File.Data() + this->GradientOffset);
  view.Geometry = this->Geometry;
  view.Summary = this->Summary;
  return view;
}

void HierarchyFile::ReleasePages() const
{
  this->File.Release(this->RecordOffset, this->TableOffset);
}

std::string WriteHierarchyFile(const std::string& path, std::int64_t width, std::int64_t height,
  const GridGeometry& geometry, const HierarchyPlacing& placing, const HeightRows& rows,
  const ParallelFor& parallelFor, const BuildProgress& progress)
{
  std::string error = HierarchyLayout::WhyNotSize(width, height);
  if (!error.empty())
  {
    return error;
  }
  const HierarchyLayout layout(width, height);
  return WriteFile(path, layout, geometry, placing,
    [&](HierarchyTarget& target) { return BuildHierarchy(target, rows, parallelFor, progress); });
}

std::string WriteHierarchyFile(const std::string& path, const HierarchyView& hierarchy,
  const HierarchyPlacing& placing, const BuildProgress& progress)
{
  return WriteFile(path, *hierarchy.Layout, hierarchy.Geometry, placing,
    [&](HierarchyTarget& target)
    {
      const auto count = static_cast<std::size_t>(hierarchy.Layout->RecordCount());
      std::copy_n(hierarchy.Records, count, target.Records);
      std::copy_n(hierarchy.Gradients, count, target.Gradients);
      target.Summary = hierarchy.Summary;
      return std::string(progress && !progress(1.0) ? kBuildAborted : "");
    });
}
}
