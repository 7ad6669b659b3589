// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which neighbours in a row an observer sees, one a lane (Lanes.h); the method
 * is that of Viewshed.h.
 *
 * A line of sight is followed from one row of samples to the next, by the
 * distance w from the observer in rows. Over the column x(w) = X + Slope w it
 * stands at the height Rise w + Fall w^2 above the observer; the last part is
 * the earth's curvature, which lifts the sight instead of dropping the ground.
 * Above is how high the surface stands over the sight.
 */
#ifndef terrain_ViewshedLanes_h
#define terrain_ViewshedLanes_h

#include "core/grid/Lanes.h"
#include "core/rays/LaneKernels.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
struct ViewshedLanes
{
  using L = Lanes<float>;
  using Value = L::Value;
  using Mask = L::Mask;
  static constexpr int LeafRows = 8;

  const LaneGrid<float>& Grid;
  const LaneObserver& Eye;
  int Step;       ///< 1 if the targets lie north of the observer, else -1
  int FirstLine;  ///< the first row beyond the observer
  float FirstRow; ///< its distance
  int Rows;       ///< rows from there to the targets', that included
  double FirstX;  ///< columns of the first lane at the observer, and per row of
                  ///< distance
  double FirstSlope;
  float Spread; ///< columns between lanes, per row of distance
  Value Lane;   ///< 0, 1, 2 ...
  Value Slope;
  Value Raise; ///< of the targets, over what is looked at
  Value Rise;
  Value Fall;
  Mask Along;   ///< lanes whose sight runs along the line between two columns
  Mask Seeking; ///< lanes that nothing has hidden yet

  /// Numbers of a row at 0 <= column < 2 Count.
  TERRAIN_LANES_INLINE static Value Pick(const float* row, Mask column)
  {
#if defined(__AVX512F__)
    return (Value)_mm512_permutex2var_ps(
      (__m512)L::Load(row), (__m512i)column, (__m512)L::Load(row + L::Count));
#else
    Value value;
    for (int k = 0; k < L::Count; ++k)
    {
      value[k] = row[column[k]];
    }
    return value;
#endif
  }

  /// Height at a part of the way from one sample to the next, which does not matter for 0.
  TERRAIN_LANES_INLINE static Value Between(Value west, Value east, Value part)
  {
    return part == 0.0f ? west : west + part * (east - west);
  }

  /// How high a point at height h and distance w stands over the sight.
  TERRAIN_LANES_INLINE Value Above(Value h, Value w) const
  {
    return (h - this->Eye.Z) - w * (this->Rise + w * this->Fall);
  }

  /// Lanes in which the surface over one cell stands above the sight: at an
  /// end, or between, where begin + b t - bulge t^2 is highest. Cells without
  /// surface have a bulge that is no number.
  TERRAIN_LANES_INLINE static Mask Hides(Value begin, Value end, Value bulge)
  {
    const Value lean = end - begin + bulge;
    const Mask between = (bulge > 0.0f) & (lean > 0.0f) & (lean < 2.0f * bulge) &
      (lean * lean > -4.0f * bulge * begin);
    return (bulge == bulge) & ((begin > 0.0f) | (end > 0.0f) | between);
  }

  /// Lets go of the lanes that the surface between two rows hides; the gap
  /// before row k, of which row 0 is the first beyond the observer.
  TERRAIN_LANES_INLINE void VisitGap(int k)
  {
    const float far = this->FirstRow + static_cast<float>(k);
    const float near = far - 1.0f;
    // Columns from one near the first lane, so that float has digits left for
    // their fractions.
    const double enterFirst = this->FirstX + this->FirstSlope * near;
    const double exitFirst = this->FirstX + this->FirstSlope * far;
    const int base = static_cast<int>(enterFirst < exitFirst ? enterFirst : exitFirst) - 1;
    const Value own = L::All(static_cast<float>(this->FirstX - base)); // of the observer
    Value enter = static_cast<float>(enterFirst - base) + this->Lane * (this->Spread * near);
    enter = this->Along ? own : enter;
    Value exit = static_cast<float>(exitFirst - base) + this->Lane * (this->Spread * far);
    exit = this->Along ? own : exit;
    const Mask enterCell = __builtin_convertvector(enter, Mask);
    Mask exitCell = __builtin_convertvector(exit, Mask);
    exitCell = exitCell > enterCell + 1 ? enterCell + 1 : exitCell;
    exitCell = exitCell < enterCell - 1 ? enterCell - 1 : exitCell;
    const float* farRow =
      this->Grid.Samples + this->Grid.Stride * (this->FirstLine + k * this->Step) + base;
    const float* nearRow = farRow - this->Grid.Stride * this->Step;
    const Value enterNearWest = Pick(nearRow, enterCell);
    const Value enterNearEast = Pick(nearRow, enterCell + 1);
    const Value enterFarWest = Pick(farRow, enterCell);
    const Value enterFarEast = Pick(farRow, enterCell + 1);
    const Value exitNearWest = Pick(nearRow, exitCell);
    const Value exitNearEast = Pick(nearRow, exitCell + 1);
    const Value exitFarWest = Pick(farRow, exitCell);
    const Value exitFarEast = Pick(farRow, exitCell + 1);

    const Value enterPart = enter - __builtin_convertvector(enterCell, Value);
    const Value exitPart = exit - __builtin_convertvector(exitCell, Value);
    const bool first = k == 0;
    const Value start = L::All(first ? 0.0f : near);
    const Value begin = first
      ? L::All(this->Eye.Ground - this->Eye.Z)
      : this->Above(Between(enterNearWest, enterNearEast, enterPart), start);
    const Value end = this->Above(Between(exitFarWest, exitFarEast, exitPart), L::All(far));

    // Where a line between columns is crossed, that is west of the eastern
    // cell.
    const Mask crosses = enterCell != exitCell;
    const Mask east = enterCell > exitCell ? enterCell : exitCell;
    const Value line = __builtin_convertvector(east, Value);
    const Value width = exit - enter;
    Value part = crosses ? (line - enter) / width : L::All(1.0f);
    part = part > 0.0f ? part : Value{};
    part = part < 1.0f ? part : L::All(1.0f);
    const Mask eastward = exitCell > enterCell;
    const Value lineNear = eastward ? enterNearEast : enterNearWest;
    const Value lineFar = eastward ? enterFarEast : enterFarWest;
    const Value crossing = near + part;
    const Mask behind = crossing < start; // of the observer
    const Value middle =
      crosses ? this->Above(lineNear + part * (lineFar - lineNear), crossing) : end;

    // Above along w has the second derivative 2 (twist Slope - Fall).
    Value enterTwist = (enterNearWest - enterNearEast) - (enterFarWest - enterFarEast);
    const Value exitTwist = (exitNearWest - exitNearEast) - (exitFarWest - exitFarEast);
    if (L::Any(this->Along))
    {
      const Value west = (Pick(nearRow, enterCell - 1) - enterNearWest) -
        (Pick(farRow, enterCell - 1) - enterFarWest);
      enterTwist = (this->Along & (enterTwist != enterTwist)) ? west : enterTwist;
    }
    const Value enterLength = crossing - start;
    const Value exitLength = far - (behind ? start : crossing);
    const Value enterBulge = (this->Fall - enterTwist * this->Slope) * enterLength * enterLength;
    const Value exitBulge = (this->Fall - exitTwist * this->Slope) * exitLength * exitLength;
    const Mask hidden = (~behind & Hides(begin, middle, enterBulge)) |
      (crosses & Hides(behind ? begin : middle, end, exitBulge));
    this->Seeking &= ~hidden;
  }

  TERRAIN_LANES_INLINE void VisitLeaf(int leaf)
  {
    const int end = (leaf + 1) * LeafRows < this->Rows ? (leaf + 1) * LeafRows : this->Rows;
    for (int k = leaf * LeafRows; k < end; ++k)
    {
      this->VisitGap(k);
    }
  }

  /// True if the surface in the gaps before the rows first to last - 1 may hide
  /// a lane.
  TERRAIN_LANES_INLINE bool MayHide(int first, int last) const
  {
    const float near = first == 0 ? 0.0f : this->FirstRow + static_cast<float>(first - 1);
    const float far = this->FirstRow + static_cast<float>(last - 1);
    const double nearWest = this->FirstX + this->FirstSlope * near;
    const double farWest = this->FirstX + this->FirstSlope * far;
    const double nearEast = nearWest + static_cast<double>(this->Spread * near) * (L::Count - 1);
    const double farEast = farWest + static_cast<double>(this->Spread * far) * (L::Count - 1);
    const double westX = nearWest < farWest ? nearWest : farWest;
    const double eastX = nearEast > farEast ? nearEast : farEast;
    const int nearLine = this->FirstLine + (first - 1) * this->Step;
    const int farLine = this->FirstLine + (last - 1) * this->Step;
    const float maximum =
      this->MaximumOver(static_cast<int>(westX) - 1, static_cast<int>(eastX) + 1,
        nearLine < farLine ? nearLine : farLine, (nearLine < farLine ? farLine : nearLine) - 1);
    const Value a = this->Rise * near;
    const Value b = this->Rise * far;
    const Value lowest = (a < b ? a : b) + this->Fall * (near * near);
    return L::Any(this->Seeking & (maximum - this->Eye.Z - lowest > 0.0f));
  }

  /// Highest sample of the surface over cells of the grid.
  TERRAIN_LANES_INLINE float MaximumOver(int west, int east, int south, int north) const
  {
    const int across = (east - west > north - south ? east - west : north - south) + 1;
    int level = 1;
    while (level < this->Grid.LevelCount && (2 << level) < across)
    {
      ++level;
    }
    const auto& table = this->Grid.Levels[level - 1];
    west = Node(west + this->Grid.Margin, this->Grid.PyramidWidth, level, table.Width);
    east = Node(east + this->Grid.Margin, this->Grid.PyramidWidth, level, table.Width);
    south = Node(south + 1, this->Grid.PyramidHeight, level, table.Height);
    north = Node(north + 1, this->Grid.PyramidHeight, level, table.Height);
    const PyramidNode<float>* row = table.Nodes + static_cast<std::int64_t>(table.Width) * south;
    float maximum = row[west].Maximum;
    for (int y = south; y <= north; ++y, row += table.Width)
    {
      for (int x = west; x <= east; ++x)
      {
        maximum = row[x].Maximum > maximum ? row[x].Maximum : maximum;
      }
    }
    return maximum;
  }
  TERRAIN_LANES_INLINE static int Node(int cell, int cells, int level, int size)
  {
    cell = cell < 0 ? 0 : cell;
    cell = cell < cells ? cell : cells - 1;
    const int node = cell >> level;
    return node < size ? node : size - 1;
  }

  /// guess: the leaf that hid the last of the neighbours, or -1; becomes that
  /// of these.
  TERRAIN_LANES_INLINE void Look(int& guess)
  {
    const int leaves = (this->Rows + LeafRows - 1) / LeafRows;
    if (guess >= 0 && guess < leaves)
    {
      this->VisitLeaf(guess);
    }
    int leaf = 0;
    while (leaf < leaves && L::Any(this->Seeking))
    {
      int size = leaf == 0 ? 1 : (leaf & -leaf);
      int last = leaf + size < leaves ? leaf + size : leaves;
      while (size > 1 &&
        this->MayHide(leaf * LeafRows, last * LeafRows < this->Rows ? last * LeafRows : this->Rows))
      {
        size /= 2;
        last = leaf + size < leaves ? leaf + size : leaves;
      }
      if (size == 1 &&
        this->MayHide(leaf * LeafRows, last * LeafRows < this->Rows ? last * LeafRows : this->Rows))
      {
        const Mask before = this->Seeking;
        this->VisitLeaf(leaf);
        guess = L::Any(before & ~this->Seeking) ? leaf : guess;
      }
      leaf = last;
    }
  }
};

/// Adds 1 to the counts of the samples of a row that an observer sees, as far
/// as they lie rather north or south of it than east or west. The row must not
/// be that of the observer.
inline void CountVisible(
  const LaneGrid<float>& grid, const LaneObserver& eye, std::int64_t row, std::uint32_t* counts)
{
  using L = Lanes<float>;
  const double distance = static_cast<double>(row) - eye.Y;
  const int step = distance > 0.0 ? 1 : -1;
  const double far = distance * step;
  const auto rows = static_cast<float>(far);
  const int below = static_cast<int>(eye.Y); // eye.Y >= 0
  const bool onColumn = static_cast<double>(static_cast<int>(eye.X)) == eye.X;
  const bool onLine = static_cast<double>(below) == eye.Y;
  const int firstLine = step > 0 ? below + 1 : (onLine ? below - 1 : below);
  const auto firstRow = static_cast<float>((firstLine - eye.Y) * step);
  const int count = (static_cast<int>(row) - firstLine) * step + 1;
  const double low = eye.X - far;
  const double high = eye.X + far + 2.0;
  const std::int64_t first = low > 0.0 ? static_cast<std::int64_t>(low) : 0;
  const std::int64_t end =
    high < static_cast<double>(grid.Width) ? static_cast<std::int64_t>(high) : grid.Width;
  L::Value lane;
  for (int k = 0; k < L::Count; ++k)
  {
    lane[k] = static_cast<float>(k);
  }
  int guess = -1;
  for (std::int64_t i = first; i < end; i += L::Count)
  {
    const double firstAcross = static_cast<double>(i) - eye.X;
    const L::Value across = lane + static_cast<float>(firstAcross);
    const L::Value ground = L::Load(grid.Samples + grid.Stride * row + i);
    const L::Value slope = across / rows;
    const L::Value fall = eye.FallNorth + eye.FallEast * (slope * slope);
    const L::Value difference = ground + (eye.TargetHeight - eye.Z);
    const L::Value raise = eye.Tolerance + 4e-6f * (difference < 0.0f ? -difference : difference);
    const L::Value rise = (difference + raise) / rows - fall * rows;
    L::Mask inside = (lane < static_cast<float>(end - i)) & (ground == ground);
    for (int k = 0; k < L::Count; ++k)
    {
      // In double, so that each sample is on one side of the diagonal, here and transposed.
      const double sideways = static_cast<double>(i + k) < eye.X
        ? eye.X - static_cast<double>(i + k)
        : static_cast<double>(i + k) - eye.X;
      inside[k] &= (eye.Strict ? sideways < far : sideways <= far) ? -1 : 0;
    }
    const L::Mask along = (across == 0.0f) & (onColumn ? inside : L::Mask{});
    ViewshedLanes lanes{ grid, eye, step, firstLine, firstRow, count, eye.X, firstAcross / far,
      1.0f / rows, lane, slope, raise, rise, fall, along, inside };
    if (L::Any(inside))
    {
      lanes.Look(guess);
    }
    const L::Mask seen = lanes.Seeking;
    for (int k = 0; k < L::Count && i + k < end; ++k)
    {
      counts[i + k] += seen[k] != 0 ? 1u : 0u;
    }
  }
}
} // namespace TERRAIN_LANES_KIND
} // namespace terrain

#endif
