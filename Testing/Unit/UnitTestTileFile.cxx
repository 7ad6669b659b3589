// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/surface/MemoryTiles.h"
#include "core/surface/PreparedTiles.h"
#include "core/surface/TileFileHeader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
using terrain::TestField;
using terrain::Tile;
using terrain::TileFile;
using terrain::TileKey;
using terrain::TileLayout;
using terrain::TilePreparation;

constexpr int kFileTileLevel = 2;

// A folder that is removed at the end.
class TileFileTest : public testing::Test
{
protected:
  TileFileTest()
  {
    char name[] = "/tmp/vtkTerrainTilesXXXXXX";
    this->Folder = mkdtemp(name);
    this->Path = this->Folder + "/raster.tiles";
  }
  ~TileFileTest() override
  {
    unlink(this->Path.c_str());
    unlink((this->Path + ".partial").c_str());
    rmdir(this->Folder.c_str());
  }
  bool Exists(const std::string& path) const
  {
    struct stat status = {};
    return stat(path.c_str(), &status) == 0;
  }

  std::string Folder;
  std::string Path;
};

template <typename T>
TilePreparation<T> Prepare(
  const std::vector<T>& samples, const TileLayout& layout, int firstLevel, std::int64_t step = 5)
{
  TilePreparation<T> preparation;
  preparation.Layout = layout;
  preparation.FirstLevel = firstLevel;
  preparation.Key = { 1, 2, 3, 4 };
  preparation.Read = [&samples, layout](std::int64_t first, std::int64_t count, T* out)
  {
    std::copy_n(samples.data() + first * layout.Width, count * layout.Width, out);
    return std::string();
  };
  preparation.CountRows = [step](std::int64_t) { return step; };
  preparation.For = terrain::BackwardFor;
  preparation.Progress = [](double) { return true; };
  return preparation;
}

template <typename T>
terrain::ReadTileSamples<T> SampleReader(const std::vector<T>& samples, const TileLayout& layout)
{
  return [&samples, layout](glm::i64vec2 first, glm::i64vec2 size, T* out)
  {
    EXPECT_TRUE(first.x >= 0 && first.y >= 0 && first.x + size.x <= layout.Width &&
      first.y + size.y <= layout.Height);
    for (std::int64_t y = 0; y < size.y; ++y)
    {
      std::copy_n(
        samples.data() + first.x + layout.Width * (first.y + y), size.x, out + size.x * y);
    }
    return std::string();
  };
}

template <typename T>
void ExpectSameTiles(const terrain::TileSource& a, const terrain::TileSource& b)
{
  const TileLayout layout = a.GetLayout();
  ASSERT_EQ(layout.Width, b.GetLayout().Width);
  ASSERT_EQ(a.GetCodes().Offset, b.GetCodes().Offset);
  ASSERT_EQ(a.GetCodes().MaximumCode, b.GetCodes().MaximumCode);
  ASSERT_EQ(a.GetCodes().Format, b.GetCodes().Format);
  for (int level = 0; level < layout.LevelCount(); ++level)
  {
    const glm::i64vec2 tiles = layout.Tiles(level);
    for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k)
    {
      const TileKey key{ level, k % tiles.x, k / tiles.x };
      ASSERT_EQ(a.GetBounds(key).Maximum, b.GetBounds(key).Maximum);
      ASSERT_EQ(a.GetBounds(key).Minimum, b.GetBounds(key).Minimum);
      Tile tile;
      Tile other;
      ASSERT_EQ(a.Read(key, tile), "");
      ASSERT_EQ(b.Read(key, other), "");
      ASSERT_EQ(tile.Samples, other.Samples) << level << ' ' << key.Column << ' ' << key.Row;
      ASSERT_EQ(tile.Nodes.size(), other.Nodes.size());
      const std::size_t bytes = tile.Nodes.size() * sizeof(float) * 2;
      ASSERT_TRUE(bytes == 0 || std::memcmp(tile.Nodes.data(), other.Nodes.data(), bytes) == 0);
    }
  }
}

// Hills of whole numbers with some holes.
std::vector<short> Hills(int width, int height)
{
  std::vector<short> samples;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const bool hole = (i * 7 + j * 13) % 101 == 0 || (i > 20 && i < 24 && j < 9);
      samples.push_back(hole
          ? terrain::NoStoredHeight<short>()
          : static_cast<short>(100 + 80 * std::sin(0.4 * i) * std::cos(0.3 * j) + (i * j) % 7));
    }
  }
  return samples;
}

std::string WriteBytes(const std::string& path, std::size_t offset, const std::string& bytes)
{
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(offset));
  file << bytes;
  return file ? "" : "not written";
}

}

TEST_F(TileFileTest, HoldsTheTilesOfTheWhole)
{
  for (const TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    const std::vector<float> samples(field.Samples.begin(), field.Samples.end());
    const TileLayout layout{ field.Width, field.Height, kFileTileLevel };
    const terrain::MemoryTiles<float> whole(samples.data(), layout, terrain::SerialFor);
    for (int firstLevel = 1; firstLevel < layout.LevelCount(); ++firstLevel)
    {
      unlink(this->Path.c_str());
      ASSERT_EQ(
        terrain::WriteTileFile<float>(this->Path, Prepare(samples, layout, firstLevel)), "");
      auto file = std::make_unique<TileFile>();
      ASSERT_EQ(file->Open(this->Path), "");
      terrain::PreparedTiles<float> tiles;
      ASSERT_EQ(tiles.Open(std::move(file), SampleReader(samples, layout)), "");
      ExpectSameTiles<float>(whole, tiles);
    }
  }
}

TEST_F(TileFileTest, HoldsWholeNumbers)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  const terrain::MemoryTiles<short> whole(samples.data(), layout, terrain::SerialFor);
  ASSERT_EQ(terrain::WriteTileFile<short>(this->Path, Prepare(samples, layout, 2)), "");
  EXPECT_FALSE(this->Exists(this->Path + ".partial"));
  auto file = std::make_unique<TileFile>();
  ASSERT_EQ(file->Open(this->Path), "");
  terrain::PreparedTiles<short> tiles;
  ASSERT_EQ(tiles.Open(std::move(file), SampleReader(samples, layout)), "");
  EXPECT_EQ(tiles.GetCodes().Format, terrain::HeightCodes::TexelFormat::UInt16);
  ExpectSameTiles<short>(whole, tiles);
}

TEST_F(TileFileTest, NothingIsLeftOfAPassThatFails)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  TilePreparation<short> failing = Prepare(samples, layout, 2);
  failing.Read = [](std::int64_t first, std::int64_t, short*)
  { return std::string(first > 20 ? "the disk is on fire" : ""); };
  EXPECT_EQ(terrain::WriteTileFile<short>(this->Path, failing), "the disk is on fire");
  TilePreparation<short> stopped = Prepare(samples, layout, 2);
  stopped.Progress = [](double done) { return done < 0.5; };
  EXPECT_NE(terrain::WriteTileFile<short>(this->Path, stopped), "");
  EXPECT_FALSE(this->Exists(this->Path));
  EXPECT_FALSE(this->Exists(this->Path + ".partial"));
  EXPECT_NE(
    terrain::WriteTileFile<short>(this->Folder + "/no/such", Prepare(samples, layout, 2)), "");
  EXPECT_NE(terrain::WriteTileFile<short>(
              this->Path, Prepare(samples, TileLayout{ 3, 3, kFileTileLevel }, 2)),
    "");
}

// A disk that is full: the space is asked for before the raster is read.
TEST_F(TileFileTest, AFullDiskIsNoticedFirst)
{
  const std::vector<short> samples = Hills(70, 45);
  bool read = false;
  TilePreparation<short> preparation = Prepare(samples, { 70, 45, kFileTileLevel }, 2);
  preparation.Read = [&read](std::int64_t, std::int64_t, short*)
  {
    read = true;
    return std::string();
  };
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{ 5000, before.rlim_max };
  auto* const handler = signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = terrain::WriteTileFile<short>(this->Path, preparation);
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_NE(error, "");
  EXPECT_FALSE(read);
  EXPECT_FALSE(this->Exists(this->Path + ".partial"));
}

// What a process that was killed has left is written anew.
// Its index alone would take terabytes of memory.
TEST_F(TileFileTest, ARasterThatFitsNoDiskIsRefusedAtOnce)
{
  const std::vector<short> none;
  auto preparation = Prepare(none, TileLayout{ 2000000000, 2000000000, 8 }, 2);
  preparation.Read = [](std::int64_t, std::int64_t, short*) { return std::string("was read"); };
  const std::string error = terrain::WriteTileFile<short>(this->Path, preparation);
  // 4e18 samples / 16 * 3 numbers * 2 bytes.
  EXPECT_NE(error.find("it needs 1500000000 GB"), std::string::npos) << error;
  EXPECT_FALSE(this->Exists(this->Path + ".partial"));
}

TEST_F(TileFileTest, StartsAgainAfterADeadProcess)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  std::ofstream(this->Path + ".partial") << "half of something else";
  ASSERT_EQ(terrain::WriteTileFile<short>(this->Path, Prepare(samples, layout, 2)), "");
  TileFile file;
  EXPECT_EQ(file.Open(this->Path), "");
  EXPECT_FALSE(this->Exists(this->Path + ".partial"));
}

TEST_F(TileFileTest, OneOfSeveralWritersReadsTheRaster)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  std::atomic<int> passes{ 0 };
  std::vector<std::thread> threads;
  std::vector<std::string> errors(4);
  for (std::string& error : errors)
  {
    threads.emplace_back(
      [&]
      {
        TilePreparation<short> preparation = Prepare(samples, layout, 2, 1000);
        const auto read = preparation.Read;
        preparation.Read = [&passes, read](std::int64_t first, std::int64_t count, short* out)
        {
          ++passes;
          return read(first, count, out);
        };
        error = terrain::WriteTileFile<short>(this->Path, preparation);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(errors, std::vector<std::string>(4));
  EXPECT_EQ(passes, 1);
}

// Any changed byte and any length but the right one is noticed: at once, or by the tile it is in.
TEST_F(TileFileTest, DamageIsNoticed)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  ASSERT_EQ(terrain::WriteTileFile<short>(this->Path, Prepare(samples, layout, 2)), "");
  std::ifstream in(this->Path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  in.close();
  const auto isTrusted = [&]()
  {
    auto file = std::make_unique<TileFile>();
    terrain::PreparedTiles<short> tiles;
    if (!file->Open(this->Path).empty() ||
      !tiles.Open(std::move(file), SampleReader(samples, layout)).empty())
    {
      return false;
    }
    for (int level = 2; level < layout.LevelCount(); ++level)
    {
      const glm::i64vec2 count = layout.Tiles(level);
      for (std::int64_t k = 0; k < count.x * count.y; ++k)
      {
        Tile tile;
        if (!tiles.Read({ level, k % count.x, k / count.x }, tile).empty())
        {
          return false;
        }
      }
    }
    return true;
  };
  ASSERT_TRUE(isTrusted());
  // Between header and tiles are zeros that nobody reads.
  constexpr std::size_t kHeader = sizeof(terrain::TileFileHeader);
  constexpr std::size_t kTiles = terrain::kTileFileHeaderBytes;
  for (std::size_t position = 0; position < good.size();
       position = position + 1 == kHeader ? kTiles : position + (position < kHeader ? 1 : 37))
  {
    const char changed = static_cast<char>(good[position] ^ 0x10);
    ASSERT_EQ(WriteBytes(this->Path, position, std::string(1, changed)), "");
    EXPECT_FALSE(isTrusted()) << "byte " << position;
    ASSERT_EQ(WriteBytes(this->Path, position, std::string(1, good[position])), "");
  }
  ASSERT_TRUE(isTrusted());
  for (const std::size_t size : { std::size_t{ 0 }, std::size_t{ 100 }, good.size() - 1 })
  {
    ASSERT_EQ(truncate(this->Path.c_str(), static_cast<off_t>(size)), 0);
    EXPECT_FALSE(isTrusted()) << size << " bytes";
  }
  std::ofstream(this->Path, std::ios::binary) << good << 'x';
  EXPECT_FALSE(isTrusted());
}

// A header whose numbers no file can have, under checksums that fit: refused before anything is
// made of them.
TEST_F(TileFileTest, RefusesHeadersThatFitNoFile)
{
  using terrain::TileFileHeader;
  const std::vector<short> samples = Hills(70, 45);
  ASSERT_EQ(terrain::WriteTileFile<short>(
              this->Path, Prepare(samples, TileLayout{ 70, 45, kFileTileLevel }, 2)),
    "");
  std::ifstream in(this->Path, std::ios::binary);
  TileFileHeader good{};
  in.read(reinterpret_cast<char*>(&good), sizeof(good));
  in.close();
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::function<void(TileFileHeader&)>> changes{
    [](TileFileHeader& header) { header.Width = 1; },
    [](TileFileHeader& header) { header.Height = -45; },
    [](TileFileHeader& header) { header.Width = header.Height = most; },
    [](TileFileHeader& header) { header.Width = header.Height = 2000000000; },
    [](TileFileHeader& header) { header.TileLevel = 63; },
    [](TileFileHeader& header) { header.TileLevel = -1; },
    [](TileFileHeader& header) { header.FirstLevel = -2; },
    [](TileFileHeader& header) { header.FirstLevel = 1000; },
    [](TileFileHeader& header) { header.Type = static_cast<terrain::StoredType>(0); },
    [](TileFileHeader& header) { header.Maximum = 4e249; },
  };
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    TileFileHeader header = good;
    changes[k](header);
    header.Checksum = terrain::HeaderChecksum(header);
    const std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
    ASSERT_EQ(WriteBytes(this->Path, 0, bytes), "");
    TileFile file;
    EXPECT_NE(file.Open(this->Path).find("contradict"), std::string::npos) << "change " << k;
  }
}

// A file that is cut while it is open: an error for each tile beyond, no crash.
TEST_F(TileFileTest, CutWhileOpen)
{
  const std::vector<short> samples = Hills(70, 45);
  const TileLayout layout{ 70, 45, kFileTileLevel };
  ASSERT_EQ(terrain::WriteTileFile<short>(this->Path, Prepare(samples, layout, 2)), "");
  auto file = std::make_unique<TileFile>();
  ASSERT_EQ(file->Open(this->Path), "");
  terrain::PreparedTiles<short> tiles;
  ASSERT_EQ(tiles.Open(std::move(file), SampleReader(samples, layout)), "");
  ASSERT_EQ(truncate(this->Path.c_str(), 5000), 0);
  Tile tile;
  EXPECT_NE(tiles.Read({ 3, 0, 0 }, tile), "");
  EXPECT_EQ(tiles.Read({ 0, 0, 0 }, tile), "");
}
