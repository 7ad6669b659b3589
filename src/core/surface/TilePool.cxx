// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TilePool.h"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace terrain
{
namespace
{
/// Reads a tile. Memory that is not there is an error as any other: nobody catches what a thread
/// throws.
std::string ReadTile(const TileSource& source, const TileKey& key, Tile& tile)
{
  try
  {
    return source.Read(key, tile);
  }
  catch (const std::bad_alloc&)
  {
    return "there is not enough memory for a tile: lower HostMemoryBudget";
  }
}
}

//------------------------------------------------------------------------------
TilePool::TilePool(std::shared_ptr<const TileSource> source, std::size_t budget, int threads,
  std::function<void()> arrived)
  : Source(std::move(source))
  , Budget(budget)
  , Arrived(std::move(arrived))
{
  for (int k = 0; k < threads; ++k)
  {
    this->Threads.emplace_back([this] { this->Work(); });
  }
}

//------------------------------------------------------------------------------
TilePool::~TilePool()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stops = true;
    this->Queue.clear();
  }
  this->HasWork.notify_all();
  for (std::thread& thread : this->Threads)
  {
    thread.join();
  }
}

//------------------------------------------------------------------------------
void TilePool::Want(const std::vector<TileKey>& keys)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Queue.clear();
    this->WantedSince = ++this->Clock;
    for (auto key = keys.rbegin(); key != keys.rend(); ++key)
    {
      const auto entry = this->Entries.find(*key);
      if (entry != this->Entries.end())
      {
        entry->second.Used = this->Clock;
      }
      else if (this->Failed.count(*key) == 0 && this->InHand.count(*key) == 0)
      {
        this->Queue.push_back(*key);
      }
    }
  }
  this->HasWork.notify_all();
}

//------------------------------------------------------------------------------
std::shared_ptr<const Tile> TilePool::Find(const TileKey& key)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto entry = this->Entries.find(key);
  if (entry == this->Entries.end())
  {
    return nullptr;
  }
  entry->second.Used = ++this->Clock;
  return entry->second.Content;
}

//------------------------------------------------------------------------------
float TilePool::FindRelief(const TileKey& key) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto relief = this->Reliefs.find(key);
  return relief == this->Reliefs.end() ? -1.0F : relief->second;
}

//------------------------------------------------------------------------------
bool TilePool::HasFailed(const TileKey& key) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Failed.count(key) > 0;
}

//------------------------------------------------------------------------------
void TilePool::Wait()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->IsDone.wait(lock, [this] { return this->Queue.empty() && this->InHand.empty(); });
}

//------------------------------------------------------------------------------
std::size_t TilePool::GetMemorySize() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->MemorySize;
}

//------------------------------------------------------------------------------
std::string TilePool::TakeMessage()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::string message = std::move(this->Message);
  this->Message.clear();
  return message;
}

//------------------------------------------------------------------------------
void TilePool::Work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  for (;;)
  {
    this->HasWork.wait(lock, [this] { return this->Stops || !this->Queue.empty(); });
    if (this->Stops)
    {
      return;
    }
    const TileKey key = this->Queue.back();
    this->Queue.pop_back();
    this->InHand[key] = true;
    lock.unlock();
    auto tile = std::make_shared<Tile>();
    const std::string error = ReadTile(*this->Source, key, *tile);
    lock.lock();
    this->InHand.erase(key);
    if (error.empty())
    {
      this->Store(key, std::move(tile));
    }
    else
    {
      this->Message = this->Failed.empty() ? error : this->Message;
      this->Failed[key] = true;
      this->Reliefs[key] = 0.0F;
    }
    lock.unlock();
    this->IsDone.notify_all();
    if (this->Arrived)
    {
      this->Arrived();
    }
    lock.lock();
  }
}

//------------------------------------------------------------------------------
void TilePool::Store(const TileKey& key, std::shared_ptr<const Tile> tile)
{
  this->Reliefs[key] = tile->Relief;
  this->MemorySize += tile->MemorySize();
  this->Entries[key] = { std::move(tile), ++this->Clock };
  this->Evict();
}

//------------------------------------------------------------------------------
// Drops what was used longest ago, but nothing that has been used since Want().
void TilePool::Evict()
{
  while (this->MemorySize > this->Budget)
  {
    const auto oldest = std::min_element(this->Entries.begin(), this->Entries.end(),
      [](const auto& a, const auto& b) { return a.second.Used < b.second.Used; });
    if (oldest->second.Used >= this->WantedSince)
    {
      return;
    }
    this->MemorySize -= oldest->second.Content->MemorySize();
    this->Entries.erase(oldest);
  }
}
}
