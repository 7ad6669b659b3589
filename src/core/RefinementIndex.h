// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which vertices of a refinement are known already.
 */
#ifndef terrain_RefinementIndex_h
#define terrain_RefinementIndex_h

#include "core/RefinementFrame.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace terrain
{
/// Index of the vertex of each record, of this mesh alone: entries of meshes before are known by
/// their number and need not be cleared.
class VertexIndex
{
public:
  /// Makes room for a hierarchy's records; false if there is no memory. Memory that is never
  /// touched is not taken.
  bool Allocate(std::int64_t recordCount)
  {
    if (!this->Entries)
    {
      this->RecordCount = static_cast<std::size_t>(recordCount);
      this->Entries.reset(
        static_cast<std::uint32_t*>(std::calloc(this->RecordCount, sizeof(std::uint32_t))));
      this->First = 1;
    }
    return this->Entries != nullptr;
  }
  /// Forgets the vertices of a mesh; `count` were numbered.
  void Forget(std::uint32_t count)
  {
    this->First += count;
    // As many again must fit: a mesh has fewer than 2^31 vertices.
    if (this->First > (1u << 31))
    {
      std::fill_n(this->Entries.get(), this->RecordCount, 0u);
      this->First = 1;
    }
  }
  /// Index of the record's vertex, or a number that is no index below `count`.
  std::uint32_t Find(std::uint32_t record) const
  {
    return this->Entries.get()[record] - this->First;
  }
  TERRAIN_INLINE void Prefetch(std::uint32_t record) const
  {
    __builtin_prefetch(this->Entries.get() + record);
  }
  void Set(std::uint32_t record, std::uint32_t index)
  {
    this->Entries.get()[record] = this->First + index;
  }

private:
  struct FreeMemory
  {
    void operator()(std::uint32_t* memory) const
    {
      std::free(memory);
    }
  };
  std::unique_ptr<std::uint32_t, FreeMemory> Entries;
  std::size_t RecordCount = 0;
  std::uint32_t First = 1;
};

/// Index of the vertex at each position below the samples of a base, of this mesh alone. The three
/// vertices of a pair of depths that share a corner of a square of two steps lie side by side.
class PositionIndex
{
public:
  /// Forgets all vertices.
  void Clear()
  {
    this->Count = 0;
    if (++this->Stamp == 0 || this->Entries.empty())
    {
      this->Entries.assign(std::max<std::size_t>(this->Entries.size(), 1024), Entry());
      this->Stamp = 1;
    }
  }
  /// Index of the vertex at a position, `next` if it is a new one. `shift`: log2 of its step.
  TERRAIN_INLINE std::uint32_t FindOrAdd(std::uint64_t position, int shift, std::uint32_t next)
  {
    const std::size_t mask = this->Entries.size() - 1;
    std::size_t slot = SlotOf(position, shift) & mask;
    for (; this->Entries[slot].Stamp == this->Stamp; slot = (slot + 1) & mask)
    {
      if (this->Entries[slot].Position == position)
      {
        return this->Entries[slot].Index;
      }
    }
    this->Entries[slot] = { position, next, this->Stamp };
    if (2 * ++this->Count > this->Entries.size())
    {
      this->Grow();
    }
    return next;
  }
  TERRAIN_INLINE void Prefetch(std::uint64_t position, int shift) const
  {
    __builtin_prefetch(&this->Entries[SlotOf(position, shift) & (this->Entries.size() - 1)]);
  }

private:
  struct Entry
  {
    std::uint64_t Position = 0;
    std::uint32_t Index = 0;
    std::uint32_t Stamp = 0;
  };

  /// First of four slots.
  static std::size_t SlotOf(std::uint64_t position, int shift)
  {
    constexpr std::uint64_t factor = 0x9e3779b97f4a7c15u;
    const std::uint64_t multiples = ~std::uint32_t(1) << shift;
    const std::uint64_t corner =
      (position & (multiples | (multiples << 32))) + static_cast<std::uint64_t>(shift);
    return static_cast<std::size_t>((corner * factor) >> 30) & ~std::size_t(3);
  }

  TERRAIN_NO_INLINE void Grow()
  {
    std::vector<Entry> old(2 * this->Entries.size());
    old.swap(this->Entries);
    const std::size_t mask = this->Entries.size() - 1;
    for (const Entry& entry : old)
    {
      if (entry.Stamp == this->Stamp)
      {
        std::size_t slot = SlotOf(entry.Position, ShiftOf(entry.Position)) & mask;
        while (this->Entries[slot].Stamp == this->Stamp)
        {
          slot = (slot + 1) & mask;
        }
        this->Entries[slot] = entry;
      }
    }
  }
  /// log2 of the step of the vertex at a position: trailing zeros that both coordinates have.
  static int ShiftOf(std::uint64_t position)
  {
    return __builtin_ctz(static_cast<std::uint32_t>(position | (position >> 32)));
  }

  std::vector<Entry> Entries;
  std::size_t Count = 0;
  std::uint32_t Stamp = 0;
};
}

#endif
