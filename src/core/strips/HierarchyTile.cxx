// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyTile.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace terrain
{
namespace
{
/// Bits of |value|; those of a NaN are above all others.
inline std::int32_t AbsoluteBits(float value)
{
  std::int32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x7fffffff;
}

/// The plane start + slope * x along one row.
struct RowPlane
{
  float Start;
  float Slope;
};

/// Largest distance (as bits) of row[begin..end], both included, from the plane.
std::int32_t LargestDistance(const float* row, int begin, int end, RowPlane plane)
{
  std::int32_t largest = 0;
  for (int x = begin; x <= end; ++x)
  {
    largest =
      std::max(largest, AbsoluteBits(row[x] - (plane.Start + plane.Slope * static_cast<float>(x))));
  }
  return largest;
}

/// Peak (as bits) inside a cell of the parabola along its diagonal: `first` and `last` are the
/// differences at its ends, `twist` is the sum of the heights at its ends minus the other two. On
/// the diagonal the difference is first + (last - first) t - twist t (1 - t), 0 <= t <= 1.
std::int32_t DiagonalPeak(float first, float last, float twist)
{
  if (!(std::abs(last - first) < std::abs(twist)))
  {
    // No peak inside; a NaN in the cell has to come through all the same.
    return std::isnan(twist) ? HierarchyTile::Unknown : 0;
  }
  const float t = (twist - (last - first)) / (2.0f * twist);
  return AbsoluteBits(first - twist * t * t);
}
}

/// A square of the hierarchy in the tile.
struct HierarchyTile::Square
{
  int X;
  int Y;
  int Side;
  /// Height of its south-west corner: Base[x + y * Pitch].
  const float* Base;
  int Pitch;

  float At(int x, int y) const
  {
    return this->Base[x + y * this->Pitch];
  }
  /// h00 + h11 - h10 - h01 of the cell (x, y).
  float Twist(int x, int y) const
  {
    return (this->At(x, y) + this->At(x + 1, y + 1)) - (this->At(x + 1, y) + this->At(x, y + 1));
  }
};

HierarchyTile::HierarchyTile(int side)
  : TileSide(side)
  , Pitch(side + 3)
  , Heights(static_cast<std::size_t>(this->Pitch) * this->Pitch)
  , Errors(static_cast<std::size_t>(side + 1) * (side + 1))
{
}

void HierarchyTile::Merge(int x, int y, std::int32_t error)
{
  std::int32_t& merged = this->Errors[y * (this->TileSide + 1) + x];
  merged = std::max(merged, std::min(error, Unknown));
}

void HierarchyTile::ComputeErrors(std::int64_t cellsX, std::int64_t cellsY, bool rising)
{
  std::fill(this->Errors.begin(), this->Errors.end(), 0);
  for (int side = 2; side <= this->TileSide; side *= 2)
  {
    for (int y = 0; y < std::min<std::int64_t>(this->TileSide, cellsY); y += side)
    {
      for (int x = 0; x < std::min<std::int64_t>(this->TileSide, cellsX); x += side)
      {
        if (x + side <= cellsX && y + side <= cellsY)
        {
          const Square square{ x, y, side, &this->Heights[(y + 1) * this->Pitch + x + 1],
            this->Pitch };
          this->Diagonal(
            square, side == this->TileSide ? rising : (((x / side) + (y / side)) & 1) == 0);
          this->Sides(square);
          continue;
        }
        const int half = side / 2;
        this->Merge(x + half, y + half, Unknown);
        this->Merge(x + half, y, Unknown);
        this->Merge(x + half, y + side, Unknown);
        this->Merge(x, y + half, Unknown);
        this->Merge(x + side, y + half, Unknown);
      }
    }
  }
}

/// The square's two halves on both sides of the diagonal that its centre halves.
void HierarchyTile::Diagonal(const Square& square, bool rising)
{
  const int side = square.Side;
  const float scale = 1.0f / static_cast<float>(side);
  const float sw = square.At(0, 0);
  const float se = square.At(side, 0);
  const float nw = square.At(0, side);
  const float ne = square.At(side, side);
  std::int32_t largest = 0;
  for (int y = 0; y <= side; ++y)
  {
    const float* row = square.Base + static_cast<std::ptrdiff_t>(y) * square.Pitch;
    const auto north = static_cast<float>(y) * scale;
    const int cut = rising ? y : side - y;
    // West of the diagonal lie both western corners and one end, east of it the eastern ones.
    const RowPlane west{ sw + (nw - sw) * north, rising ? (ne - nw) * scale : (se - sw) * scale };
    const float eastSlope = rising ? (se - sw) * scale : (ne - nw) * scale;
    const RowPlane east{ se + (ne - se) * north - eastSlope * static_cast<float>(side), eastSlope };
    largest = std::max(largest, LargestDistance(row, 0, cut, west));
    largest = std::max(largest, LargestDistance(row, cut, side, east));
  }
  const float first = rising ? sw : se;
  const float step = ((rising ? ne : nw) - first) * scale;
  for (int i = 0; i < side; ++i)
  {
    const int x0 = rising ? i : side - i;
    const int x1 = rising ? i + 1 : side - i - 1;
    const float line = first + step * static_cast<float>(i);
    const float twist = square.Twist(std::min(x0, x1), i) * (rising ? 1.0f : -1.0f);
    largest = std::max(
      largest, DiagonalPeak(square.At(x0, i) - line, square.At(x1, i + 1) - (line + step), twist));
  }
  this->Merge(square.X + side / 2, square.Y + side / 2, largest);
}

/// Largest distance along a square's half diagonal from a corner on, whose cells it halves.
std::int32_t HierarchyTile::Spoke(const Square& square, int x, int y, int dx, int dy)
{
  const int half = square.Side / 2;
  const float corner = square.At(x, y);
  const float step = (square.At(half, half) - corner) / static_cast<float>(half);
  std::int32_t largest = 0;
  for (int i = 0; i < half; ++i)
  {
    const int x0 = x + i * dx;
    const int y0 = y + i * dy;
    const float line = corner + step * static_cast<float>(i);
    const float twist = square.Twist(std::min(x0, x0 + dx), std::min(y0, y0 + dy));
    largest = std::max(largest,
      DiagonalPeak(square.At(x0, y0) - line, square.At(x0 + dx, y0 + dy) - (line + step),
        dx == dy ? twist : -twist));
  }
  return largest;
}

/// The square's four quarters between its centre and its sides, which the middles of the sides
/// split.
void HierarchyTile::Sides(const Square& square)
{
  const int side = square.Side;
  const int half = side / 2;
  const auto size = static_cast<float>(side);
  const float sw = square.At(0, 0);
  const float se = square.At(side, 0);
  const float nw = square.At(0, side);
  const float ne = square.At(side, side);
  const float centre = square.At(half, half);
  std::int32_t south = 0;
  std::int32_t north = 0;
  std::int32_t west = 0;
  std::int32_t east = 0;
  for (int y = 0; y <= side; ++y)
  {
    const float* row = square.Base + static_cast<std::ptrdiff_t>(y) * square.Pitch;
    const int near = std::min(y, side - y);
    const auto v = static_cast<float>(y) / size;
    const float westStart = sw + (nw - sw) * v;
    const float eastStart = se + (ne - se) * v;
    const float westSlope = (2.0f * centre - sw - nw) / size;
    const float eastSlope = (se + ne - 2.0f * centre) / size;
    west = std::max(west, LargestDistance(row, 0, near, { westStart, westSlope }));
    east = std::max(
      east, LargestDistance(row, side - near, side, { eastStart - eastSlope * size, eastSlope }));
    if (y <= half)
    {
      const float slope = (se - sw) / size;
      const float start = sw + (2.0f * centre - sw - se) * v;
      south = std::max(south, LargestDistance(row, near, side - near, { start, slope }));
    }
    if (y >= half)
    {
      const float slope = (ne - nw) / size;
      const float start = nw + (2.0f * centre - nw - ne) * (1.0f - v);
      north = std::max(north, LargestDistance(row, near, side - near, { start, slope }));
    }
  }
  const std::int32_t spokeSW = Spoke(square, 0, 0, 1, 1);
  const std::int32_t spokeSE = Spoke(square, side, 0, -1, 1);
  const std::int32_t spokeNW = Spoke(square, 0, side, 1, -1);
  const std::int32_t spokeNE = Spoke(square, side, side, -1, -1);
  this->Merge(square.X + half, square.Y, std::max({ south, spokeSW, spokeSE }));
  this->Merge(square.X + half, square.Y + side, std::max({ north, spokeNW, spokeNE }));
  this->Merge(square.X, square.Y + half, std::max({ west, spokeSW, spokeNW }));
  this->Merge(square.X + side, square.Y + half, std::max({ east, spokeSE, spokeNE }));
}
}
