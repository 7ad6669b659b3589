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
#include "core/rays/LaneBounds.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
/// Numbers of a row at 0 <= column < 2 Count.
TERRAIN_LANES_INLINE Lanes<float>::Value PickNear(const float* row, Lanes<float>::Mask column)
{
  using L = Lanes<float>;
#if defined(__AVX512F__)
  return (L::Value)_mm512_permutex2var_ps(
    (__m512)L::Load(row), (__m512i)column, (__m512)L::Load(row + L::Count));
#else
  L::Value value;
  for (int k = 0; k < L::Count; ++k)
  {
    value[k] = row[column[k]];
  }
  return value;
#endif
}

/// Numbers from anywhere in a table.
TERRAIN_LANES_INLINE Lanes<float>::Value PickAny(const float* table, Lanes<float>::Mask index)
{
  using L = Lanes<float>;
#if defined(__AVX512F__)
  return (L::Value)_mm512_mask_i32gather_ps(
    _mm512_setzero_ps(), (__mmask16)-1, (__m512i)index, table, 4);
#else
  L::Value value;
  for (int k = 0; k < L::Count; ++k)
  {
    value[k] = table[index[k]];
  }
  return value;
#endif
}

/// Measures: instead of letting go of hidden lanes, raise their sights until nothing stands above.
template <bool Measures>
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
  Value Rise; ///< of the sights, per row of distance
  Value Fall;
  Mask Along;   ///< lanes whose sight runs along the line between two columns
  Mask Seeking; ///< lanes that nothing has hidden yet

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

  /// Where the sights come into a gap between two rows, or leave it: their columns from a base, the
  /// cells that they are in there, and the heights of those cells' corners.
  struct Crossing
  {
    Value Column;
    Mask Cell;
    Value NearWest;
    Value NearEast;
    Value FarWest;
    Value FarEast;

    TERRAIN_LANES_INLINE Crossing(Value column, Mask cell, const float* near, const float* far)
      : Column(column)
      , Cell(cell)
      , NearWest(PickNear(near, cell))
      , NearEast(PickNear(near, cell + 1))
      , FarWest(PickNear(far, cell))
      , FarEast(PickNear(far, cell + 1))
    {
    }
    TERRAIN_LANES_INLINE Value Part() const
    {
      return this->Column - __builtin_convertvector(this->Cell, Value);
    }
    TERRAIN_LANES_INLINE Value Twist() const
    {
      return (this->NearWest - this->NearEast) - (this->FarWest - this->FarEast);
    }
  };

  /// The surface over one cell, from one distance to another, over the sights: begin + b t - bulge
  /// t^2, in the lanes where the sights come there.
  struct Arc
  {
    Mask Counts;
    Value Begin;
    Value End;
    Value Bulge;
    Value Near;
    Value Far;
  };

  /// Columns of the sights at a distance, of which the first is known; from a base.
  TERRAIN_LANES_INLINE Value ColumnsAt(double first, float distance, int base) const
  {
    const Value own = L::All(static_cast<float>(this->FirstX - base)); // of the observer
    const Value column = static_cast<float>(first - base) + this->Lane * (this->Spread * distance);
    return this->Along ? own : column;
  }

  /// Twist of the cells that the sights come into: of the western ones of those along a line that
  /// have no eastern one.
  TERRAIN_LANES_INLINE Value TwistOf(
    const Crossing& enter, const float* near, const float* far) const
  {
    Value twist = enter.Twist();
    if (L::Any(this->Along))
    {
      const Value west = (PickNear(near, enter.Cell - 1) - enter.NearWest) -
        (PickNear(far, enter.Cell - 1) - enter.FarWest);
      twist = (this->Along & (twist != twist)) ? west : twist;
    }
    return twist;
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
    const Value enterColumn = this->ColumnsAt(enterFirst, near, base);
    const Value exitColumn = this->ColumnsAt(exitFirst, far, base);
    const Mask enterCell = __builtin_convertvector(enterColumn, Mask);
    Mask exitCell = __builtin_convertvector(exitColumn, Mask);
    exitCell = exitCell > enterCell + 1 ? enterCell + 1 : exitCell;
    exitCell = exitCell < enterCell - 1 ? enterCell - 1 : exitCell;
    const float* farRow =
      this->Grid.Samples + this->Grid.Stride * (this->FirstLine + k * this->Step) + base;
    const float* nearRow = farRow - this->Grid.Stride * this->Step;
    const Crossing enter(enterColumn, enterCell, nearRow, farRow);
    const Crossing exit(exitColumn, exitCell, nearRow, farRow);

    const bool first = k == 0;
    const Value start = L::All(first ? 0.0f : near);
    const Value begin = first
      ? L::All(this->Eye.Ground - this->Eye.Z)
      : this->Above(Between(enter.NearWest, enter.NearEast, enter.Part()), start);
    const Value end = this->Above(Between(exit.FarWest, exit.FarEast, exit.Part()), L::All(far));

    // Where a line between columns is crossed, that is west of the eastern
    // cell.
    const Mask crosses = enterCell != exitCell;
    const Mask east = enterCell > exitCell ? enterCell : exitCell;
    const Value line = __builtin_convertvector(east, Value);
    Value part = crosses ? (line - enterColumn) / (exitColumn - enterColumn) : L::All(1.0f);
    part = part > 0.0f ? part : Value{};
    part = part < 1.0f ? part : L::All(1.0f);
    const Mask eastward = exitCell > enterCell;
    const Value lineNear = eastward ? enter.NearEast : enter.NearWest;
    const Value lineFar = eastward ? enter.FarEast : enter.FarWest;
    const Value middle = near + part;
    const Value above = crosses ? this->Above(lineNear + part * (lineFar - lineNear), middle) : end;

    // Above along w has the second derivative 2 (twist Slope - Fall).
    const Mask behind = middle < start; // of the observer
    const Value exitStart = behind ? start : middle;
    const Value enterBulge = (this->Fall - this->TwistOf(enter, nearRow, farRow) * this->Slope) *
      (middle - start) * (middle - start);
    const Value exitBulge =
      (this->Fall - exit.Twist() * this->Slope) * (far - exitStart) * (far - exitStart);
    this->Take({ ~behind, begin, above, enterBulge, start, middle },
      { crosses, behind ? begin : above, end, exitBulge, exitStart, L::All(far) });
  }

  /// Lets go of the lanes that the first or the second cell of a gap hides, or raises their sights.
  TERRAIN_LANES_INLINE void Take(const Arc& enter, const Arc& exit)
  {
    const Mask enterHides = enter.Counts & Hides(enter.Begin, enter.End, enter.Bulge);
    const Mask exitHides = exit.Counts & Hides(exit.Begin, exit.End, exit.Bulge);
    if constexpr (Measures)
    {
      if (L::Any(enterHides | exitHides))
      {
        const Value enterRise = SteepestOver(enter);
        const Value exitRise = SteepestOver(exit);
        Value more = enterHides ? enterRise : Value{};
        more = (exitHides & (exitRise > more)) ? exitRise : more;
        this->Rise += this->Seeking ? more : Value{};
      }
    }
    else
    {
      this->Seeking &= ~(enterHides | exitHides);
    }
  }

  /// The highest slope, from the observer, of what stands above the sight over one cell: of
  /// (begin + b t - bulge t^2) / distance, at an end, or between, where it exceeds the slope at the
  /// end (core/rays/Horizon.h).
  TERRAIN_LANES_INLINE static Value SteepestOver(const Arc& arc)
  {
    const Value near = arc.Near;
    const Value far = arc.Far;
    const Value length = far - near;
    const Value atNear = near > 0.0f ? arc.Begin / near : L::All(-__builtin_huge_valf());
    const Value atFar = arc.End / far;
    const Value curvature = arc.Bulge / (length * length);
    const Value deficit = (arc.End * near - arc.Begin * far) / length + curvature * (near * far);
    const Mask within = (deficit > curvature * (near * near)) & (deficit < curvature * (far * far));
    const Value root =
      L::Root(within ? deficit / far : Value{}) - L::Root(within ? curvature * far : Value{});
    const Value most = L::Maximum(atNear, atFar);
    const Value summit = within ? atFar + root * root : most;
    return summit > most ? summit : most;
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
    const LaneCells cells{ static_cast<int>(westX) - 1, static_cast<int>(eastX) + 1,
      nearLine < farLine ? nearLine : farLine, (nearLine < farLine ? farLine : nearLine) - 1 };
    const int wide = cells.East - cells.West;
    const int deep = cells.North - cells.South;
    const int across = (wide > deep ? wide : deep) + 1;
    int level = 1;
    while (level < this->Grid.LevelCount && (2 << level) < across)
    {
      ++level;
    }
    const float maximum = MaximumOver(this->Grid, cells, level);
    const Value a = this->Rise * near;
    const Value b = this->Rise * far;
    const Value lowest = (a < b ? a : b) + this->Fall * (near * near);
    return L::Any(this->Seeking & (maximum - this->Eye.Z - lowest > 0.0f));
  }

  /// guess: the leaf that hid, or raised, the last of the neighbours, or -1; becomes that
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
        const Value lower = this->Rise;
        this->VisitLeaf(leaf);
        const bool mattered = L::Any(before & ~this->Seeking) || L::Any(this->Rise > lower);
        guess = mattered ? leaf : guess;
      }
      leaf = last;
    }
  }
};
} // namespace TERRAIN_LANES_KIND
} // namespace terrain

#endif
