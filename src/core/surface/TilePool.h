// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tiles in the host's memory, read by threads of its own.
 */
#ifndef terrain_TilePool_h
#define terrain_TilePool_h

#include "core/surface/TileSelection.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

namespace terrain
{
/// Keeps what was used last within a budget, and what is wanted now even beyond it. A tile that
/// cannot be read is never there, and never tried again.
class TilePool
{
public:
  /// `threads` >= 1 read. `arrived` is called by them when a tile has been read or has failed.
  TilePool(std::shared_ptr<const TileSource> source, std::size_t budget, int threads,
    std::function<void()> arrived);
  ~TilePool();
  TilePool(const TilePool&) = delete;
  TilePool& operator=(const TilePool&) = delete;

  const TileSource& GetSource() const
  {
    return *this->Source;
  }

  /// Replaces what is to be read; in this order. Tiles that are there or have failed are skipped.
  void Want(const std::vector<TileKey>& keys);
  /// The tile if it is there, else null; counts as used.
  std::shared_ptr<const Tile> Find(const TileKey& key);
  /// Relief of a tile that has been read at some time, 0 of one that has failed; else -1.
  float FindRelief(const TileKey& key) const;
  bool HasFailed(const TileKey& key) const;
  /// Waits until all that is wanted is there or has failed.
  void Wait();

  /// Bytes of the tiles that are there.
  std::size_t GetMemorySize() const;
  /// Why the first tile that failed could not be read, once; empty if none has.
  std::string TakeMessage();

private:
  struct Entry
  {
    std::shared_ptr<const Tile> Content;
    std::uint64_t Used = 0;
  };

  void Work();
  void Store(const TileKey& key, std::shared_ptr<const Tile> tile);
  void Evict();

  std::shared_ptr<const TileSource> Source;
  std::size_t Budget;
  std::function<void()> Arrived;
  mutable std::mutex Mutex;
  std::condition_variable HasWork;
  std::condition_variable IsDone;
  std::map<TileKey, Entry> Entries;
  std::map<TileKey, float> Reliefs;
  std::map<TileKey, bool> Failed;
  std::vector<TileKey> Queue; ///< the next one last
  std::map<TileKey, bool> InHand;
  std::size_t MemorySize = 0;
  std::uint64_t Clock = 0;
  std::uint64_t WantedSince = 0;
  std::string Message;
  bool Stops = false;
  std::vector<std::thread> Threads;
};
}

#endif
