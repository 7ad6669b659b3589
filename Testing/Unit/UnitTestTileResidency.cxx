// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/surface/MemoryTiles.h"
#include "core/surface/TileResidency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <new>
#include <set>
#include <thread>
#include <vector>

namespace
{
using terrain::TestField;
using terrain::Tile;
using terrain::TileKey;
using terrain::TilePool;
using terrain::TileResidency;
using terrain::TileUpload;
using terrain::TileView;

// A source that takes its time, fails for some tiles and counts.
class SlowTiles : public terrain::TileSource
{
public:
  explicit SlowTiles(std::unique_ptr<terrain::TileSource> source)
    : Source(std::move(source))
  {
  }
  terrain::TileLayout GetLayout() const override
  {
    return this->Source->GetLayout();
  }
  terrain::HeightCodes GetCodes() const override
  {
    return this->Source->GetCodes();
  }
  bool AreBoundsTrue() const override
  {
    return true;
  }
  terrain::PyramidNode<float> GetBounds(const TileKey& key) const override
  {
    return this->Source->GetBounds(key);
  }
  std::string Read(const TileKey& key, Tile& tile) const override
  {
    ++this->Reads;
    std::this_thread::sleep_for(std::chrono::microseconds((key.Column * 7 + key.Row * 3) % 5));
    return this->Fails && this->Fails(key) ? "the network is away" : this->Source->Read(key, tile);
  }

  std::function<bool(const TileKey&)> Fails;
  mutable std::atomic<int> Reads{ 0 };

private:
  std::unique_ptr<terrain::TileSource> Source;
};

std::shared_ptr<SlowTiles> MakeSource()
{
  const TestField field("hills", 150, 140,
    [](int i, int j) { return 40.0 * std::sin(0.11 * i) * std::cos(0.13 * j) + 50.0; });
  return std::make_shared<SlowTiles>(terrain::MakeMemoryTiles(field.View(), 2, terrain::SerialFor));
}

// All that lies north of an eye.
TileView ViewFrom(double x, double y, double tolerance)
{
  TileView view;
  view.Eye = { x, y, 120.0 };
  view.Forward = { 0.0, 1.0, 0.0 };
  view.Tolerance = { 0.0, 0.0, tolerance, tolerance };
  view.Planes = { { 0.0, 1.0, 0.0, -y } };
  return view;
}

// What a card holds, by what was sent there.
struct Card
{
  explicit Card(std::size_t slots)
    : Slots(slots)
  {
  }
  void Take(const TileUpload& upload)
  {
    ASSERT_LT(upload.Slot, this->Slots.size());
    this->Slots[upload.Slot] = upload.Key;
  }
  // The tiles that pages show; each must be what its slot holds, and have its parent.
  std::set<TileKey> Shown(const terrain::TilePages& pages) const
  {
    std::set<TileKey> shown;
    const terrain::TileLayout& layout = pages.GetLayout();
    for (int level = layout.LevelCount() - 1; level >= 0; --level)
    {
      const glm::i64vec2 tiles = layout.Tiles(level);
      for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k)
      {
        const TileKey key{ level, k % tiles.x, k / tiles.x };
        const std::uint32_t page = pages.At(key);
        if (page != 0)
        {
          EXPECT_TRUE(this->Slots[page - 1] == key);
          EXPECT_TRUE(level == pages.Top() || pages.IsShown(key.Parent()));
          shown.insert(key);
        }
      }
    }
    return shown;
  }

  std::vector<TileKey> Slots;
};

constexpr std::size_t kPlenty = std::size_t{ 1 } << 30;
}

TEST(TilePages, HaveAPlaceForEachTile)
{
  const terrain::TileLayout layout{ 5000, 700, 4 };
  const terrain::TilePages pages(layout);
  std::set<std::size_t> places;
  std::size_t count = 0;
  for (int level = 0; level < layout.LevelCount(); ++level)
  {
    const glm::i64vec2 tiles = layout.Tiles(level);
    for (std::int64_t k = 0; k < tiles.x * tiles.y; ++k, ++count)
    {
      const std::size_t place = pages.PlaceOf({ level, k % tiles.x, k / tiles.x });
      EXPECT_LT(place, pages.Get().size());
      places.insert(place);
    }
  }
  EXPECT_EQ(places.size(), count);
}

TEST(TileResidency, ConvergesWhateverCameBefore)
{
  const TileView view = ViewFrom(70.0, 60.0, 0.05);
  std::set<TileKey> first;
  for (const int threads : { 1, 3 })
  {
    for (int wander = 0; wander < 3; ++wander)
    {
      auto pool = std::make_shared<TilePool>(MakeSource(), kPlenty, threads, nullptr);
      TileResidency residency(pool, 400, 7);
      Card card(400);
      const auto take = [&card](const TileUpload& upload) { card.Take(upload); };
      for (int step = 0; step < 5 * wander; ++step) // other views, not waited for
      {
        for (const TileUpload& upload : residency.Update(ViewFrom(20.0 * step, 5.0 * step, 0.1)))
        {
          take(upload);
        }
      }
      residency.Finish(view, take);
      EXPECT_TRUE(residency.IsComplete());
      const std::set<TileKey> shown = card.Shown(residency.GetPages());
      first = first.empty() ? shown : first;
      EXPECT_EQ(shown, first);
      EXPECT_GT(shown.size(), 50U);
      EXPECT_EQ(residency.Update(view).size(), 0U); // nothing more to be sent
      EXPECT_TRUE(residency.IsComplete());
    }
  }
}

TEST(TileResidency, UploadsAreBounded)
{
  auto pool = std::make_shared<TilePool>(MakeSource(), kPlenty, 2, nullptr);
  TileResidency residency(pool, 400, 3);
  Card card(400);
  const TileView view = ViewFrom(70.0, 60.0, 0.05);
  int frames = 0;
  do
  {
    const std::vector<TileUpload> uploads = residency.Update(view);
    ASSERT_LE(uploads.size(), 3U);
    for (const TileUpload& upload : uploads)
    {
      card.Take(upload);
    }
    card.Shown(residency.GetPages());
    pool->Wait();
    ASSERT_LT(++frames, 1000);
  } while (!residency.IsComplete());
  EXPECT_GT(frames, 20);
}

TEST(TileResidency, TooFewSlotsCoarsen)
{
  for (const std::size_t slots : { 1, 9, 60 })
  {
    auto pool = std::make_shared<TilePool>(MakeSource(), kPlenty, 2, nullptr);
    TileResidency residency(pool, slots, 100);
    Card card(slots);
    for (const double y : { 60.0, 20.0, 60.0 })
    {
      residency.Finish(
        ViewFrom(70.0, y, 0.01), [&card](const TileUpload& upload) { card.Take(upload); });
      EXPECT_FALSE(residency.Fits());
      const std::set<TileKey> shown = card.Shown(residency.GetPages());
      EXPECT_LE(shown.size(), slots);
      EXPECT_GE(shown.size(), 1U);
    }
  }
}

TEST(TileResidency, ATileThatCannotBeReadIsAMissingOne)
{
  const auto source = MakeSource();
  source->Fails = [](const TileKey& key) { return key.Level == 1 && key.Column == 8; };
  auto pool = std::make_shared<TilePool>(source, kPlenty, 2, nullptr);
  TileResidency residency(pool, 1000, 100);
  Card card(1000);
  const TileView view = ViewFrom(70.0, 20.0, 0.02);
  residency.Finish(view, [&card](const TileUpload& upload) { card.Take(upload); });
  EXPECT_TRUE(residency.IsComplete());
  EXPECT_EQ(pool->TakeMessage(), "the network is away");
  const int reads = source->Reads;
  for (const TileKey& key : card.Shown(residency.GetPages()))
  {
    EXPECT_FALSE(key.Level == 1 && key.Column == 8);
    EXPECT_FALSE(key.Level == 0 && key.Column / 2 == 8);
  }
  for (int frame = 0; frame < 10; ++frame)
  {
    residency.Update(view);
  }
  pool->Wait();
  EXPECT_EQ(source->Reads, reads); // not tried again
  EXPECT_EQ(pool->TakeMessage(), "");
}

TEST(TilePool, KeepsItsBudget)
{
  const auto source = MakeSource();
  Tile tile;
  ASSERT_EQ(source->Read({ 1, 0, 0 }, tile), "");
  const std::size_t size = tile.MemorySize();
  TilePool pool(source, 10 * size, 2, nullptr);
  for (std::int64_t row = 0; row < 10; ++row)
  {
    std::vector<TileKey> keys;
    for (std::int64_t column = 0; column < 6; ++column)
    {
      keys.push_back({ 1, column, row });
    }
    pool.Want(keys);
    pool.Wait();
    for (const TileKey& key : keys)
    {
      ASSERT_TRUE(pool.Find(key));
    }
    EXPECT_LE(pool.GetMemorySize(), 10 * size);
  }
  EXPECT_FALSE(pool.Find({ 1, 0, 0 }));
  EXPECT_GE(pool.FindRelief({ 1, 0, 0 }), 0.0F);
  EXPECT_LT(pool.FindRelief({ 0, 0, 0 }), 0.0F);
  // A budget of nothing keeps what is wanted.
  TilePool none(source, 0, 1, nullptr);
  none.Want({ { 1, 0, 0 }, { 1, 1, 0 } });
  none.Wait();
  EXPECT_TRUE(none.Find({ 1, 0, 0 }));
  EXPECT_TRUE(none.Find({ 1, 1, 0 }));
}

// A pool that goes away while its threads read.
// Nobody catches what its threads throw.
TEST(TilePool, TellsOfMemoryThatIsNotThere)
{
  const auto source = MakeSource();
  source->Fails = [](const TileKey& key) -> bool
  {
    if (key.Level == 0)
    {
      throw std::bad_alloc();
    }
    return false;
  };
  TilePool pool(source, kPlenty, 2, nullptr);
  pool.Want({ { 0, 0, 0 }, { 1, 0, 0 } });
  pool.Wait();
  EXPECT_TRUE(pool.HasFailed({ 0, 0, 0 }));
  EXPECT_TRUE(pool.Find({ 1, 0, 0 }));
  EXPECT_NE(pool.TakeMessage().find("not enough memory"), std::string::npos);
}

TEST(TilePool, StopsAtOnce)
{
  for (int trial = 0; trial < 20; ++trial)
  {
    TilePool pool(MakeSource(), kPlenty, 3, nullptr);
    std::vector<TileKey> keys;
    for (std::int64_t k = 0; k < 400; ++k)
    {
      keys.push_back({ 0, k % 20, k / 20 });
    }
    pool.Want(keys);
  }
}
