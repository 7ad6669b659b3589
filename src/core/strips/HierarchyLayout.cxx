// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyLayout.h"

#include <algorithm>

namespace terrain
{
namespace
{
constexpr int kGroupRecords = 3;

/// Columns or rows of vertices that refinement can reach, for a raster of `size` samples. Ancestors
/// of a vertex on the raster's last row lie up to three of their steps beyond it, their children
/// one more.
std::int64_t ReachableSteps(std::int64_t size, int shift, std::int64_t cells)
{
  return std::min(cells >> shift, ((size - 1) >> shift) + 5) + 1;
}

std::int64_t BlocksOf(std::int64_t steps)
{
  const std::int64_t groups = (steps - 1) / 2 + 1;
  return (groups + HierarchyLayout::BlockSide - 1) / HierarchyLayout::BlockSide;
}

/// Terms of one axis: which block, which group in it, which vertex of the group. `blockStride` and
/// `groupStride` are the records from one block or group of this axis to the next.
std::vector<std::uint32_t> TermsOf(
  std::int64_t steps, std::int64_t blockStride, std::int64_t groupStride, std::int64_t slot)
{
  std::vector<std::uint32_t> terms(static_cast<std::size_t>(steps));
  for (std::int64_t step = 0; step < steps; ++step)
  {
    const std::int64_t group = step / 2;
    terms[step] = static_cast<std::uint32_t>((group / HierarchyLayout::BlockSide) * blockStride +
      (group % HierarchyLayout::BlockSide) * groupStride + (step & 1) * slot);
  }
  return terms;
}
}

std::string HierarchyLayout::WhyNotSize(std::int64_t width, std::int64_t height)
{
  if (width < 1 || height < 1 || width > MaximumSize || height > MaximumSize)
  {
    return "a hierarchy needs 1 to " + std::to_string(MaximumSize) +
      " samples in each direction, not " + std::to_string(width) + " x " + std::to_string(height);
  }
  return {};
}

HierarchyLayout::HierarchyLayout(std::int64_t width, std::int64_t height)
  : Size{ { width, height } }
{
  this->PairCount = 1;
  while (this->Cells() < std::max(width, height) - 1)
  {
    ++this->PairCount;
  }
  constexpr std::int64_t blockRecords = std::int64_t(BlockSide) * BlockSide * kGroupRecords;
  std::int64_t begin = 0;
  for (int pair = 0; pair < this->PairCount; ++pair)
  {
    this->PairBegin.push_back(begin);
    const std::int64_t columns = ReachableSteps(width, this->Shift(pair), this->Cells());
    const std::int64_t rows = ReachableSteps(height, this->Shift(pair), this->Cells());
    // South side (x odd, y even) is slot 0, west side (x even, y odd) 1, centre (both odd) 2.
    this->Terms[0].push_back(TermsOf(columns, blockRecords, kGroupRecords, 1));
    this->Terms[1].push_back(
      TermsOf(rows, blockRecords * BlocksOf(columns), std::int64_t(kGroupRecords) * BlockSide, 2));
    for (std::uint32_t& term : this->Terms[1].back())
    {
      term += static_cast<std::uint32_t>(begin - 1);
    }
    begin += blockRecords * BlocksOf(columns) * BlocksOf(rows);
  }
  this->PairBegin.push_back(begin);
}

int HierarchyLayout::PairOf(std::int64_t x, std::int64_t y) const
{
  const std::int64_t both = x | y;
  int shift = 0;
  while (shift < this->PairCount && ((both >> shift) & 1) == 0)
  {
    ++shift;
  }
  return this->PairCount - 1 - shift;
}

int HierarchyLayout::DepthOf(std::int64_t index) const
{
  const auto next = std::upper_bound(this->PairBegin.begin(), this->PairBegin.end(), index);
  const auto pair = static_cast<int>(next - this->PairBegin.begin()) - 1;
  const bool isCentre = (index - this->PairBegin[pair]) % kGroupRecords == 2;
  return 2 * pair + (isCentre ? 0 : 1);
}

int HierarchyLayout::DiamondDirection(int pair, std::int64_t x, std::int64_t y)
{
  if ((x & y & 1) == 0)
  {
    return (x & 1) != 0 ? 2 : 0;
  }
  if (pair == 0)
  {
    return -1;
  }
  // The apexes are the corners of the square that came last: those with one odd coordinate.
  return (((x >> 1) + (y >> 1)) & 1) == 0 ? 3 : 1;
}

bool HierarchyLayout::IsOutside(int depth, std::int64_t x, std::int64_t y, int direction) const
{
  const std::int64_t step = this->Step(depth / 2);
  const std::int64_t apexX = x + step * Directions[direction][0];
  const std::int64_t apexY = y + step * Directions[direction][1];
  if (apexX < 0 || apexY < 0)
  {
    return true;
  }
  // The hypotenuse lies across the triangle's direction; that of an even depth is a diagonal.
  const std::int64_t west = apexX > x && (depth & 1) != 0 ? x : x - step;
  const std::int64_t south = apexY > y && (depth & 1) != 0 ? y : y - step;
  return west >= this->Size[0] - 1 || south >= this->Size[1] - 1;
}
}
