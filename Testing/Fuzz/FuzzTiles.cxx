// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of tiles with damage in any place, also under checksums that fit: refused, or tiles through
// which rays go on.
#include "FuzzFile.h"
#include "UnitTestRays.h"

#include "core/rays/TileTraversal.h"
#include "core/surface/PreparedTiles.h"
#include "core/surface/TileFileHeader.h"

#include <array>
#include <memory>
#include <vector>

namespace
{
constexpr terrain::TileLayout kLayout{ 34, 19, 2 };

template <typename T>
std::string ReadSamples(glm::i64vec2 first, glm::i64vec2 size, T* samples)
{
  Require(first.x >= 0 && first.y >= 0 && size.x > 0 && size.y > 0 &&
    first.x + size.x <= kLayout.Width && first.y + size.y <= kLayout.Height);
  for (std::int64_t k = 0; k < size.x * size.y; ++k)
  {
    const std::int64_t i = first.x + k % size.x;
    const std::int64_t j = first.y + k / size.x;
    samples[k] =
      (i * 7 + j * 13) % 101 == 0 ? terrain::NoStoredHeight<T>() : static_cast<T>((i * j) % 60);
  }
  return {};
}

template <typename T>
std::string Prepare(int firstLevel)
{
  terrain::TilePreparation<T> preparation;
  preparation.Layout = kLayout;
  preparation.FirstLevel = firstLevel;
  preparation.Read = [](std::int64_t first, std::int64_t count, T* samples) {
    return ReadSamples<T>({ 0, first }, { kLayout.Width, count }, samples);
  };
  preparation.CountRows = [](std::int64_t) { return 5; };
  preparation.For = terrain::SerialFor;
  preparation.Progress = [](double) { return true; };
  return ContentWrittenBy(
    [&](const std::string& path) { return terrain::WriteTileFile<T>(path, preparation); });
}

/// Checksums of the tiles of a sound file's layout, of their table and of the header.
void FitChecksums(std::string& content, const terrain::TileFileIndex& index)
{
  if (content.size() < index.FileSize())
  {
    return;
  }
  const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
  for (std::size_t k = 0; k < index.Count(); ++k)
  {
    PutValue(content, index.TableBegin() + k * sizeof(std::uint64_t),
      terrain::Checksum(bytes + index.Begin(k), index.Size(k)));
  }
  terrain::TileFileHeader header{};
  std::memcpy(&header, bytes, sizeof(header));
  header.FileBytes = content.size();
  header.TableChecksum =
    terrain::Checksum(bytes + index.TableBegin(), index.Count() * sizeof(std::uint64_t));
  header.Checksum = terrain::HeaderChecksum(header);
  PutValue(content, 0, header);
}

/// Rays through the tiles that can be read, the finer ones where the input says so.
void CheckRays(const terrain::TileSource& source, FuzzInput& input)
{
  terrain::TileSlots slots(source.GetLayout());
  std::size_t shown = 0;
  for (int level = slots.Top(); level >= 0; --level)
  {
    const glm::i64vec2 tiles = source.GetLayout().Tiles(level);
    for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k)
    {
      const terrain::TileKey key{ level, k % tiles.x, k / tiles.x };
      source.GetBounds(key);
      auto tile = std::make_shared<terrain::Tile>();
      const bool isRead = source.Read(key, *tile).empty();
      const bool isTop = level == slots.Top();
      if (isRead && (isTop || (slots.IsShown(key.Parent()) && input.Number(3) != 0)))
      {
        slots.Show(key, shown++, tile);
      }
      else if (isTop)
      {
        return;
      }
    }
  }
  const terrain::TiledLevels levels{ &slots };
  terrain::TiledPyramid rays;
  const auto highest = static_cast<float>(source.GetCodes().MaximumCode);
  rays.heights = { &slots, glm::ivec2(kLayout.Width, kLayout.Height), 0, highest };
  rays.pyramid = &levels;
  rays.start = slots.PyramidTop();
  rays.holes = source.GetCodes().HasNoData;
  for (int ray = 0; ray < 4; ++ray)
  {
    const auto end = [&]
    {
      return glm::dvec3(
        40.0 * input.Real(), 40.0 * input.Real(), static_cast<double>(highest) * input.Real());
    };
    const glm::dvec3 begin = end();
    const terrain::TerrainHit hit = rays.TraceTiles(terrain::RayBetween(begin, end()),
      glm::vec4(0.0f, 0.0f, 0.0f, 0.0f), [](glm::ivec2, int, bool) {});
    Require(!hit.found ||
      (hit.cell.x >= 0 && hit.cell.y >= 0 && hit.cell.x < kLayout.Width &&
        hit.cell.y < kLayout.Height));
  }
}

template <typename T>
void Check(std::unique_ptr<terrain::TileFile> file, FuzzInput& input)
{
  terrain::PreparedTiles<T> tiles;
  if (tiles.Open(std::move(file), ReadSamples<T>).empty())
  {
    CheckRays(tiles, input);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<std::string, 4> prepared{ Prepare<short>(1), Prepare<short>(2),
    Prepare<unsigned short>(2), Prepare<float>(2) };
  FuzzInput input(data, size);
  std::string content = prepared[input.Number(4)];
  const bool fits = input.Number(4) != 0;
  FuzzInput rays(input.Rest(), input.Left()); // the same bytes say both
  terrain::TileFileHeader header{};
  std::memcpy(&header, content.data(), sizeof(header));
  const terrain::TileFileIndex index(terrain::ContentOf(header));
  const bool isSound = input.Left() < 4;
  Damage(content, input);
  if (fits)
  {
    FitChecksums(content, index);
  }
  const FuzzFile opened(content);
  auto file = std::make_unique<terrain::TileFile>();
  const std::string why = file->Open(opened.Path());
  Require(!isSound || why.empty());
  // What has another layout is of another raster.
  if (why.empty() && file->GetContent().Layout == kLayout)
  {
    const terrain::StoredType type = file->GetContent().Type;
    (type == terrain::StoredType::Float              ? Check<float>
        : type == terrain::StoredType::UnsignedShort ? Check<unsigned short>
                                                     : Check<short>)(std::move(file), rays);
  }
  return 0;
}
