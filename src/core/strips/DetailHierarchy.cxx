// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/DetailHierarchy.h"

#include "core/strips/HierarchyBuild.h"
#include "core/surface/DetailHeights.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
float LargestErrorOf(const std::vector<HierarchyRecord>& records)
{
  float error = 0.0f;
  for (const HierarchyRecord& record : records)
  {
    error = std::max(error, record.Error());
  }
  return error;
}
}

std::string DetailHierarchy::Build(
  const float* heights, glm::ivec2 period, int level, const ParallelFor& parallelFor)
{
  if (period.x < 1 || period.y < 1 || std::max(period.x, period.y) > MaximumPeriod)
  {
    return "a period of detail has 1 to " + std::to_string(MaximumPeriod) +
      " samples in each direction, not " + std::to_string(period.x) + " x " +
      std::to_string(period.y);
  }
  this->Size = period;
  this->Samples.assign(heights, heights + static_cast<std::size_t>(period.x) * period.y);
  const auto range = std::minmax_element(this->Samples.begin(), this->Samples.end());
  this->Lowest = *range.first;
  this->Highest = *range.second;
  // Pairs of steps 2^e fit if 4 2^e divides the period: two squares of the pair, whose diagonals
  // differ, repeat.
  const int fitting = std::clamp(WholeLevels(period) - 1, 0, level);
  std::string error = this->BuildFitting(fitting, parallelFor);
  if (!error.empty())
  {
    return error;
  }
  float common = this->Highest - this->Lowest;
  this->Pairs.assign(static_cast<std::size_t>(level), Pair());
  for (int e = 0; e < fitting; ++e)
  {
    this->Pairs[level - 1 - e] = { this->Fitting[e].data(), e, period >> e };
    common = std::max(common, LargestErrorOf(this->Fitting[e]));
  }
  this->Others.clear();
  if (fitting < level)
  {
    this->Others.resize(this->Samples.size());
    for (std::size_t i = 0; i < this->Samples.size(); ++i)
    {
      this->Others[i].Height = this->Samples[i];
      this->Others[i].SetError(common);
    }
    std::fill_n(this->Pairs.begin(), level - fitting, Pair{ this->Others.data(), 0, period });
  }
  this->Error = 0.0f;
  if (level > 0)
  {
    this->Error = LargestErrorOf(fitting < level ? this->Others : this->Fitting[level - 1]);
  }
  return {};
}

/// Records of the `fitting` finest pairs: a hierarchy of the period and of as much around it as the
/// descendants of its vertices reach, three of their steps.
std::string DetailHierarchy::BuildFitting(int fitting, const ParallelFor& parallelFor)
{
  this->Fitting.assign(static_cast<std::size_t>(fitting), {});
  if (fitting == 0)
  {
    return {};
  }
  const std::int64_t margin = std::int64_t(2) << fitting;
  const glm::i64vec2 period(this->Size);
  const glm::i64vec2 size = period + 2 * margin + std::int64_t(1);
  const auto rows = [&](std::int64_t first, std::int64_t count, float* out)
  {
    for (std::int64_t y = first; y < first + count; ++y)
    {
      const float* row =
        this->Samples.data() + period.x * ((y + margin * (period.y - 1)) % period.y);
      for (std::int64_t x = 0; x < size.x; ++x)
      {
        *out++ = row[(x + margin * (period.x - 1)) % period.x];
      }
    }
    return std::string();
  };
  MemoryHierarchy hierarchy;
  std::string error = BuildHierarchy(
    hierarchy, size.x, size.y, GridGeometry(), HeightRows(rows), parallelFor, BuildProgress());
  if (!error.empty())
  {
    return error;
  }
  const HierarchyLayout& layout = hierarchy.Layout;
  for (int e = 0; e < fitting; ++e)
  {
    const int pair = layout.Pairs() - 1 - e;
    const glm::i64vec2 count = period >> std::int64_t(e);
    this->Fitting[e].resize(static_cast<std::size_t>(count.x * count.y));
    for (std::int64_t y = 0; y < count.y; ++y)
    {
      for (std::int64_t x = 0; x < count.x; ++x)
      {
        if (((x | y) & 1) != 0)
        {
          this->Fitting[e][x + count.x * y] =
            hierarchy.Records[layout.Index(pair, x + (margin >> e), y + (margin >> e))];
        }
      }
    }
  }
  return {};
}
}
