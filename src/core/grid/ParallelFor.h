// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How algorithms in src/core/ run in parallel without knowing a threading library: the caller hands
 * them a ParallelFor. Results never depend on how a range is split.
 */
#ifndef terrain_ParallelFor_h
#define terrain_ParallelFor_h

#include <cstdint>
#include <functional>

namespace terrain
{
/// Calls body(begin, end) on disjoint subranges that cover [0, count); any order, any thread.
using RangeBody = std::function<void(std::int64_t begin, std::int64_t end)>;
using ParallelFor = std::function<void(std::int64_t count, const RangeBody& body)>;

/// The whole range at once, on the calling thread.
inline void SerialFor(std::int64_t count, const RangeBody& body)
{
  if (count > 0)
  {
    body(0, count);
  }
}
}

#endif
