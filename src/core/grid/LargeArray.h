// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Memory for arrays that are read all over, in no order.
 */
#ifndef terrain_LargeArray_h
#define terrain_LargeArray_h

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace terrain
{
struct FreeLargeArray
{
  void operator()(void* memory) const
  {
    std::free(memory);
  }
};

/// An array whose values are not initialized. In huge pages where the system has them for who asks
/// (Linux with transparent huge pages): a page of 4 KiB costs 2.8 us when it is first written, and
/// reads of many rows miss the processor's table of pages.
template <typename T>
using LargeArray = std::unique_ptr<T[], FreeLargeArray>;

/// Of count values; throws std::bad_alloc if there is no memory for them.
template <typename T>
LargeArray<T> MakeLargeArray(std::size_t count)
{
  static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);
  constexpr std::size_t line = 64;
  constexpr std::size_t hugePage = std::size_t{ 2 } << 20;
  constexpr int populateWrite = 23; // MADV_POPULATE_WRITE of Linux 5.14, which old headers lack
  const std::size_t bytes = count * sizeof(T);
  const std::size_t alignment = bytes < 2 * hugePage ? line : hugePage;
  const std::size_t whole = (bytes / alignment + 1) * alignment;
  void* memory = std::aligned_alloc(alignment, whole);
  if (!memory)
  {
    throw std::bad_alloc();
  }
#ifdef MADV_HUGEPAGE
  // What is not done is done without. Pages are cleared here, by one thread: two that write to a
  // huge page first would both clear it.
  if (alignment == hugePage && madvise(memory, whole, MADV_HUGEPAGE) == 0)
  {
    madvise(memory, whole, populateWrite);
  }
#endif
  return LargeArray<T>(static_cast<T*>(memory));
}
} // namespace terrain

#endif
