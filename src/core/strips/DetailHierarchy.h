// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The second hierarchy of a terrain with detail: one period of the detail, prepared for refinement
 * that runs on below the samples of a base.
 *
 * The sum of a base and of detail with 2^level cells along a base cell (DetailHeights.h) is one
 * heightfield; its hierarchy is the base's, followed by `level` more pairs of depths, which this
 * holds. A vertex of pair q of these, 0 <= q < level, lies at a multiple of 2^(level - 1 - q)
 * detail cells, and so do its copies a period away. Nothing here depends on the base: records are
 * for the detail alone, scale 1, and the size is that of the period.
 *
 * Errors are those of HierarchyBuild.h, of the detail's own bilinear surface over the triangles of
 * the vertex and of all its descendants, across the period's border too. A pair whose pattern of
 * triangles does not fit the period (its squares of four times the step do not divide the period)
 * has one error for all its vertices, at least that of any of them: the detail's range.
 *
 * Source: Balogh, chapter 6.
 */
#ifndef terrain_DetailHierarchy_h
#define terrain_DetailHierarchy_h

#include "core/grid/ParallelFor.h"
#include "core/strips/HierarchyRecord.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace terrain
{
/// Made once by Build(), then only read.
class DetailHierarchy
{
public:
  /// Most pairs of depths below the base: 1024 detail cells along a base cell.
  static constexpr int MaximumLevel = 10;
  /// Largest period.
  static constexpr int MaximumPeriod = 16384;

  /// Records of a pair of depths: that of the vertex at detail cell (x, y) is number
  /// (x >> Shift) mod Count.x + Count.x ((y >> Shift) mod Count.y).
  struct Pair
  {
    const HierarchyRecord* Records = nullptr;
    int Shift = 0;
    glm::ivec2 Count{ 1, 1 };
  };

  /// Prepares one period of finite heights, south row first; 0 <= level <= MaximumLevel. Returns an
  /// error message, empty if all is well.
  std::string Build(
    const float* heights, glm::ivec2 period, int level, const ParallelFor& parallelFor);

  int Level() const
  {
    return static_cast<int>(this->Pairs.size());
  }
  glm::ivec2 Period() const
  {
    return this->Size;
  }
  /// The period's heights; sample (i, j) is number i + Period().x j.
  const float* Heights() const
  {
    return this->Samples.data();
  }
  float Minimum() const
  {
    return this->Lowest;
  }
  float Maximum() const
  {
    return this->Highest;
  }
  /// Largest error of any vertex, in units of the detail's heights; 0 without pairs.
  float LargestError() const
  {
    return this->Error;
  }
  const Pair& PairAt(int pair) const
  {
    return this->Pairs[pair];
  }

private:
  std::string BuildFitting(int fitting, const ParallelFor& parallelFor);

  glm::ivec2 Size{ 0, 0 };
  std::vector<float> Samples;
  std::vector<Pair> Pairs;
  /// Records of the pairs that fit the period, finest first, and those that all others share.
  std::vector<std::vector<HierarchyRecord>> Fitting;
  std::vector<HierarchyRecord> Others;
  float Lowest = 0.0f;
  float Highest = 0.0f;
  float Error = 0.0f;
};
}

#endif
