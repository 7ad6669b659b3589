// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How many triangles each tolerance takes, for triangle budgets.
 */
#ifndef terrain_RefinementCounts_h
#define terrain_RefinementCounts_h

#include "core/strips/HierarchyRecord.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace terrain
{
/// Counts triangles by the tolerance, relative to the frame's, at which they would appear.
class ToleranceCounts
{
public:
  /// Steps of a factor of 2 in tolerance.
  static constexpr int StepsPerOctave = 32;

  /// `limit` triangles are enough to know that there are too many.
  explicit ToleranceCounts(std::int64_t limit)
    : Limit(limit)
    , Buckets(64 * StepsPerOctave + 1)
  {
  }

  /// Counts triangles that are split below `ratio` times the tolerance: each becomes two.
  void Add(double ratio, int triangles)
  {
    this->Buckets[BucketOf(ratio)] += triangles;
    this->Total += triangles;
  }
  bool AreEnough() const
  {
    return this->Total >= this->Limit;
  }

  /// Triangles besides the first four.
  std::int64_t Triangles() const
  {
    return this->Total;
  }

  /// Smallest factor on the tolerance that leaves at most `budget` triangles besides the first
  /// four. Infinite if none of the steps does: the eye is inside the spheres of that many.
  double FactorFor(std::int64_t budget) const
  {
    std::int64_t sum = 0;
    for (std::size_t bucket = this->Buckets.size(); bucket-- > 0;)
    {
      sum += this->Buckets[bucket];
      if (sum > budget)
      {
        return bucket + 1 == this->Buckets.size() ? std::numeric_limits<double>::infinity()
                                                  : EdgeOf(bucket + 1);
      }
    }
    return 1.0;
  }

private:
  /// A step is a range of floats with the same leading bits; 1.0 begins the first one.
  static constexpr int Shift = 23 - 5;
  static std::size_t BucketOf(double ratio)
  {
    const double largest = std::ldexp(1.0, 64);
    // What is no number, as damaged records make it, is counted as 1.
    const auto known = static_cast<float>(std::min(std::max(1.0, ratio), largest));
    const std::uint32_t bits = FloatBits(known);
    return (bits - FloatBits(1.0f)) >> Shift;
  }
  static double EdgeOf(std::size_t bucket)
  {
    return BitsFloat(FloatBits(1.0f) + (static_cast<std::uint32_t>(bucket) << Shift));
  }

  std::int64_t Limit;
  std::int64_t Total = 0;
  std::vector<std::int64_t> Buckets;
};
}

#endif
