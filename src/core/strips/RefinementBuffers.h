// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Memory that a refinement appends to, again and again.
 */
#ifndef terrain_RefinementBuffers_h
#define terrain_RefinementBuffers_h

#include "core/strips/RefinementFrame.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace terrain
{
/// Appends to the memory of a vector without asking whether there is room; Reserve() makes it.
template <typename T>
class AppendBuffer
{
public:
  /// Takes the vector's memory and begins at its start.
  void Begin(std::vector<T>& memory)
  {
    this->Memory.swap(memory);
    this->Used = 0;
    this->SetMemory();
  }
  /// Gives the memory back, as a vector of what was appended.
  void Finish(std::vector<T>& memory)
  {
    this->Memory.resize(this->Used);
    this->Memory.swap(memory);
    this->Memory.clear();
  }
  /// Begins again in its own memory.
  void Clear()
  {
    this->Used = 0;
    this->Reserve();
  }
  TERRAIN_INLINE void Append(const T& element)
  {
    this->Data[this->Used++] = element;
  }
  /// Takes the last element away.
  TERRAIN_INLINE void Drop()
  {
    --this->Used;
  }
  TERRAIN_INLINE std::uint32_t Count() const
  {
    return this->Used;
  }
  /// Makes room for what two triangles of each depth take, and their joins.
  TERRAIN_INLINE void Reserve()
  {
    if (this->Used >= this->Limit)
    {
      this->Grow();
    }
  }
  /// The end of what was appended, with room as Reserve() makes; for loops that keep it themselves
  /// and give it back to Reserve(end) and SetEnd().
  T* Reserved()
  {
    this->Reserve();
    return this->Data + this->Used;
  }
  TERRAIN_INLINE T* Reserve(T* end)
  {
    if (end < this->Data + this->Limit)
    {
      return end;
    }
    this->SetEnd(end);
    return this->Reserved();
  }
  void SetEnd(const T* end)
  {
    this->Used = static_cast<std::uint32_t>(end - this->Data);
  }
  /// After writing to the reserved elements at operator[](Count()): there are so many now.
  TERRAIN_INLINE void SetCount(std::uint32_t count)
  {
    this->Used = count;
  }
  TERRAIN_INLINE T& operator[](std::uint32_t index)
  {
    return this->Data[index];
  }
  TERRAIN_INLINE const T& operator[](std::uint32_t index) const
  {
    return this->Data[index];
  }

private:
  static constexpr std::size_t Slack = 512;

  TERRAIN_NO_INLINE void Grow()
  {
    this->Memory.resize(this->Memory.size() + this->Memory.size() / 4 + 2 * Slack);
    this->SetMemory();
  }
  void SetMemory()
  {
    this->Data = this->Memory.data();
    this->Limit = static_cast<std::uint32_t>(std::max(this->Memory.size(), Slack) - Slack);
  }

  std::vector<T> Memory;
  T* Data = nullptr;
  std::uint32_t Used = 0;
  std::uint32_t Limit = 0;
};

/// An active vertex of which one of the two triangles has been refined.
struct WaitingVertex
{
  std::uint64_t Position = 0;
  /// Of the sink.
  std::uint32_t Index = 0;
};

/**
 * The active vertices of the plain procedure that wait for their second triangle.
 *
 * The path through the triangles never crosses itself, so on each side of it edges are passed the
 * second time in the reverse order of the first: two stacks hold them, one for vertices of even
 * depths, which lie on one side of the path, one for odd ones. A vertex is put there when its first
 * triangle is left, after those on its own two halves of the edge, and taken away when the second
 * is entered.
 *
 * After Bader and others (2008), "Memory efficient adaptive mesh generation and implementation of
 * multigrid algorithms using Sierpinski curves", who pass values of vertices and edges so.
 */
class WaitingVertices
{
public:
  void Clear()
  {
    for (AppendBuffer<WaitingVertex>& stack : this->Stacks)
    {
      stack.Clear();
      // A position that no vertex has.
      stack.Append({ ~std::uint64_t(0) });
    }
  }
  TERRAIN_INLINE void Push(bool isOdd, const WaitingVertex& vertex)
  {
    AppendBuffer<WaitingVertex>& stack = this->Stacks[isOdd ? 1 : 0];
    stack.Reserve();
    stack.Append(vertex);
  }
  TERRAIN_INLINE void Pop(bool isOdd)
  {
    this->Stacks[isOdd ? 1 : 0].Drop();
  }
  /// The topmost vertex.
  TERRAIN_INLINE const WaitingVertex& Top(bool isOdd) const
  {
    const AppendBuffer<WaitingVertex>& stack = this->Stacks[isOdd ? 1 : 0];
    return stack[stack.Count() - 1];
  }

private:
  std::array<AppendBuffer<WaitingVertex>, 2> Stacks;
};
}

#endif
