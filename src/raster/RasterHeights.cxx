// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterHeights.h"

#include "core/grid/Checksum.h"
#include "raster/RasterTiles.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <utility>

#include <sys/stat.h>

namespace terrain
{
namespace
{
// Samples that are read at once in a pass, and by one thread.
constexpr std::int64_t kBandSamples = std::int64_t{ 1 } << 25;
constexpr std::int64_t kPieceSamples = std::int64_t{ 1 } << 20;
constexpr std::int64_t kMostRows = 512;
// Places of a raster, along each axis, where its content is looked at to know it again, and samples
// along the side of each.
constexpr std::int64_t kPlaces = 4;
constexpr std::int64_t kPlaceSamples = 64;

StoredType StoredTypeFor(const RasterFile& file, bool isScaled)
{
  if (isScaled)
  {
    return StoredType::Float;
  }
  switch (file.GetType())
  {
    case GDT_UInt16:
      return StoredType::UnsignedShort;
    case GDT_UInt32:
    case GDT_Int32:
    case GDT_Float32:
    case GDT_Float64:
      return StoredType::Float;
    default:
      return StoredType::Short;
  }
}

std::uint64_t ChecksumOf(const std::string& text)
{
  return Checksum(reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

/// Adds size and time of a file, if there is a file of this name.
void AddFile(const char* name, TileFileKey& key)
{
  struct stat status = {};
  if (stat(name, &status) == 0)
  {
    key.Bytes += static_cast<std::uint64_t>(status.st_size);
    const auto time = static_cast<std::uint64_t>(status.st_mtim.tv_sec) * 1000000000U +
      static_cast<std::uint64_t>(status.st_mtim.tv_nsec);
    key.Time = std::max(key.Time, time);
  }
}
}

//------------------------------------------------------------------------------
/// A file that nobody else reads from while this lives.
class RasterHeights::Handle
{
public:
  explicit Handle(const RasterHeights& owner)
    : Owner(owner)
  {
    const std::lock_guard<std::mutex> lock(owner.Mutex);
    if (!owner.Idle.empty())
    {
      this->File = std::move(owner.Idle.back());
      owner.Idle.pop_back();
    }
  }
  ~Handle()
  {
    if (this->File)
    {
      const std::lock_guard<std::mutex> lock(this->Owner.Mutex);
      this->Owner.Idle.push_back(std::move(this->File));
    }
  }
  Handle(const Handle&) = delete;
  void operator=(const Handle&) = delete;

  const RasterFile& Get()
  {
    if (!this->File)
    {
      this->File = this->Owner.Open();
    }
    return *this->File;
  }

private:
  const RasterHeights& Owner;
  std::unique_ptr<RasterFile> File;
};

//------------------------------------------------------------------------------
RasterHeights::RasterHeights(RasterHeightsSettings settings)
  : Settings(std::move(settings))
{
  std::unique_ptr<RasterFile> file = this->Open();
  const RasterLayout layout = file->GetLayout();
  RasterRequest& request = this->Request;
  request.Window = { 0, 0, file->GetWidth(), file->GetHeight() };
  request.Width = request.Window.Width;
  request.Height = request.Window.Height;
  request.NorthFirst = layout.NorthFirst;
  request.EastFirst = layout.EastFirst;
  file->GetScaleAndOffset(request.Scale, request.Offset);
  request.NoData = file->GetHoles().Declared;
  request.UndeclaredNoData = file->GetHoles().Undeclared;
  request.Progress = [](double) { return true; };
  this->Type = StoredTypeFor(*file, request.Scale != 1.0 || request.Offset != 0.0);
  this->FileType = file->GetType();
  this->IsSignedByte = file->IsSignedByte();
  this->Block = { std::min(file->GetBlockColumns(-1), request.Width),
    std::min(file->GetBlockRows(-1), request.Height) };
  this->Idle.push_back(std::move(file));
}

//------------------------------------------------------------------------------
std::unique_ptr<RasterFile> RasterHeights::Open() const
{
  auto file =
    std::make_unique<RasterFile>(this->Settings.FileName, this->Settings.Part, OpenRasterTiles);
  file->SelectBand(this->Settings.Band);
  file->TakeIn(this->Settings.Options);
  if (this->Request.Width > 0 &&
    (file->GetWidth() != this->Request.Width || file->GetHeight() != this->Request.Height))
  {
    throw RasterError("it has been replaced by a raster of another size");
  }
  return file;
}

//------------------------------------------------------------------------------
TileFileKey RasterHeights::FindKey() const
{
  Handle handle(*this);
  TileFileKey key;
  for (const std::string& name : handle.Get().GetFileNames())
  {
    AddFile(name.c_str(), key);
  }
  const glm::i64vec2 whole(this->Request.Width, this->Request.Height);
  const glm::i64vec2 size = glm::min(whole, glm::i64vec2(kPlaceSamples));
  std::vector<float> samples(static_cast<std::size_t>(size.x * size.y));
  for (std::int64_t place = 0; place < kPlaces * kPlaces; ++place)
  {
    const glm::i64vec2 at(place % kPlaces, place / kPlaces);
    this->ReadFrom(handle.Get(), (whole - size) * at / (kPlaces - 1), size, samples.data());
    const auto* bytes = reinterpret_cast<const unsigned char*>(samples.data());
    key.Content = key.Content * 31 + Checksum(bytes, samples.size() * sizeof(float));
  }
  std::ostringstream text;
  text.precision(17);
  const RasterRequest& request = this->Request;
  text << this->Settings.Band << ' ' << this->Settings.Part << ' ' << request.Scale << ' '
       << request.Offset << ' ' << request.NorthFirst << request.EastFirst << ' ' << this->FileType
       << ' ' << whole.x << ' ' << whole.y;
  for (const std::vector<double>* values : { &request.NoData, &request.UndeclaredNoData })
  {
    text << " none";
    for (const double value : *values)
    {
      text << ' ' << value;
    }
  }
  key.Settings = ChecksumOf(text.str());
  return key;
}

//------------------------------------------------------------------------------
// Reads samples of the file in a type that holds them.
template <typename Sample, typename T>
void RasterHeights::ReadAs(
  const RasterFile& file, glm::i64vec2 first, glm::i64vec2 size, T* samples) const
{
  const auto count = static_cast<std::size_t>(size.x * size.y);
  RasterRequest request = this->Request;
  request.Extent[0] = first.x;
  request.Extent[1] = first.x + size.x - 1;
  request.Extent[2] = first.y;
  request.Extent[3] = first.y + size.y - 1;
  std::vector<unsigned char> hidden;
  request.Hidden = [&hidden, count]()
  {
    hidden.assign(count, 0);
    return hidden.data();
  };
  std::vector<Sample> converted;
  Sample* read = nullptr;
  if constexpr (std::is_same_v<Sample, T>)
  {
    read = samples;
  }
  else
  {
    converted.resize(count);
    read = converted.data();
  }
  ReadRasterPiece<Sample>(file, request, read);
  for (std::size_t k = 0; k < count; ++k)
  {
    if constexpr (std::is_integral_v<Sample>)
    {
      if (std::is_same_v<Sample, T> && hidden.empty() &&
        static_cast<T>(read[k]) != NoStoredHeight<T>())
      {
        continue;
      }
      const bool none = !hidden.empty() && hidden[k];
      if (!none && static_cast<T>(read[k]) == NoStoredHeight<T>())
      {
        throw RasterError(kHeightEqualsNone);
      }
      samples[k] = none ? NoStoredHeight<T>() : static_cast<T>(read[k]);
    }
    else if constexpr (!std::is_same_v<Sample, T>)
    {
      samples[k] = static_cast<T>(read[k]); // NaN stays NaN
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
void RasterHeights::ReadFrom(
  const RasterFile& file, glm::i64vec2 first, glm::i64vec2 size, T* samples) const
{
  if constexpr (std::is_same_v<T, float>)
  {
    const bool wide =
      this->FileType == GDT_Int32 || this->FileType == GDT_UInt32 || this->FileType == GDT_Float64;
    wide ? this->ReadAs<double>(file, first, size, samples)
         : this->ReadAs<float>(file, first, size, samples);
  }
  else if (std::is_same_v<T, unsigned short> || this->FileType == GDT_Int16)
  {
    this->ReadAs<T>(file, first, size, samples);
  }
  else if (this->IsSignedByte)
  {
    this->ReadAs<signed char>(file, first, size, samples);
  }
  else
  {
    this->ReadAs<unsigned char>(file, first, size, samples);
  }
}

//------------------------------------------------------------------------------
template <typename T>
std::string RasterHeights::Read(glm::i64vec2 first, glm::i64vec2 size, T* samples) const
{
  try
  {
    Handle handle(*this);
    this->ReadFrom(handle.Get(), first, size, samples);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

//------------------------------------------------------------------------------
std::int64_t RasterHeights::CountRows(std::int64_t first) const
{
  const std::int64_t left = this->Request.Height - first;
  const std::int64_t rows =
    std::clamp<std::int64_t>(kBandSamples / this->Request.Width, 16, kMostRows);
  const std::int64_t block = this->Block.y;
  if (left <= rows || block > kMostRows)
  {
    return std::min(left, rows);
  }
  if (this->Request.NorthFirst)
  {
    // The file's rows [left - count, left), the first of which begins a block.
    return left - (left - rows) / block * block;
  }
  return std::max((first + rows) / block, first / block + 1) * block - first;
}

//------------------------------------------------------------------------------
template <typename T>
std::string RasterHeights::ReadRows(
  std::int64_t first, std::int64_t count, T* samples, const ParallelFor& parallelFor) const
{
  const std::int64_t width = this->Request.Width;
  // Pieces of whole blocks: columns of blocks, or rows of them where a block is as wide as the
  // file.
  glm::i64vec2 piece(width, count);
  if (this->Block.x < width)
  {
    piece.x = std::max<std::int64_t>(kPieceSamples / count / this->Block.x, 1) * this->Block.x;
  }
  else
  {
    piece.y = std::max<std::int64_t>(kPieceSamples / width / this->Block.y, 1) * this->Block.y;
  }
  const glm::i64vec2 pieces = (glm::i64vec2(width, count) + piece - std::int64_t{ 1 }) / piece;
  std::mutex mutex;
  std::string error;
  parallelFor(pieces.x * pieces.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<T> part;
      for (std::int64_t k = begin; k < end; ++k)
      {
        // Rows from the north: there whole blocks begin in most files.
        const std::int64_t east = std::min((k % pieces.x + 1) * piece.x, width);
        const std::int64_t south = std::max<std::int64_t>(count - (k / pieces.x + 1) * piece.y, 0);
        const glm::i64vec2 corner(k % pieces.x * piece.x, south);
        const glm::i64vec2 size(east - corner.x, count - k / pieces.x * piece.y - south);
        part.resize(static_cast<std::size_t>(size.x * size.y));
        const std::string failure = this->Read(corner + glm::i64vec2(0, first), size, part.data());
        if (!failure.empty())
        {
          const std::lock_guard<std::mutex> lock(mutex);
          error = failure;
          return;
        }
        for (std::int64_t y = 0; y < size.y; ++y)
        {
          std::copy_n(
            part.data() + size.x * y, size.x, samples + corner.x + width * (corner.y + y));
        }
      }
    });
  return error;
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type in a template's arguments takes none
#define TERRAIN_INSTANTIATE(T)                                                                     \
  template std::string RasterHeights::Read<T>(glm::i64vec2, glm::i64vec2, T*) const;               \
  template std::string RasterHeights::ReadRows<T>(                                                 \
    std::int64_t, std::int64_t, T*, const ParallelFor&) const;
TERRAIN_INSTANTIATE(short)
TERRAIN_INSTANTIATE(unsigned short)
TERRAIN_INSTANTIATE(float)
#undef TERRAIN_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)
}
