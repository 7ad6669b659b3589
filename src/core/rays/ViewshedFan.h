// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What an observer sees in a fan of sights, row by row outward.
 *
 * The fan is cut into bins: sights between two directions, never farther apart than 3/4 of a cell.
 * A bin carries two bounds of the horizon so far, slopes over the observer by the distance in rows:
 * - Low: every sight in the bin has met a surface at least as steep. It is the least slope of the
 *   surface along a row of samples in the bin; of the rows, the most.
 * - High: no sight in the bin has met a steeper one. It is the greatest slope of the corners of all
 *   cells that the bin touches: seen from the eye, a patch stays within the hull of its corners.
 * A target below Low is hidden. One that is not below High is seen, if the last cells before it,
 * which High leaves out, and the first after the eye let it. The others, a few in a hundred, are
 * looked at along their own sight (ViewshedLanes.h). So are the last and the first cells: what
 * comes out is what ViewshedLanes alone would find.
 *
 * Bounds are widened by more than float rounds off: slopes by Margin / distance, the columns that a
 * bin touches by Reach.
 */
#ifndef terrain_ViewshedFan_h
#define terrain_ViewshedFan_h

#include "core/rays/ViewshedLanes.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
class ViewshedFan
{
public:
  using L = Lanes<float>;
  using Value = L::Value;
  using Mask = L::Mask;

  ViewshedFan(const LaneGrid<float>& grid, const LaneObserver& eye, const LaneFan& fan)
    : Grid(grid)
    , Eye(eye)
    , Fan(fan)
    , Margin(2.5f * eye.Tolerance + 1e-5f * (eye.Z < 0.0f ? -eye.Z : eye.Z))
    , Sag(0.25f * (eye.FallEast + eye.FallNorth))
  {
    const int below = static_cast<int>(eye.Y); // eye.Y >= 0
    const bool onLine = static_cast<double>(below) == eye.Y;
    this->FirstLine = fan.Step > 0 ? below + 1 : (onLine ? below - 1 : below);
    const std::int64_t lines = fan.Step > 0 ? grid.Height - this->FirstLine : this->FirstLine + 1;
    this->Rows = lines < fan.Rows ? static_cast<int>(lines) : fan.Rows;
    for (int k = 0; k < L::Count; ++k)
    {
      this->Lane[k] = static_cast<float>(k);
    }
  }

  template <bool Measures>
  void Look(const HiddenSink& sink)
  {
    if (this->Rows < 1)
    {
      return;
    }
    this->FillBins(0, this->Bins, -__builtin_huge_valf());
    this->ReadRow(-1, this->Slopes[1]);
    for (int k = 0; k < this->Rows; ++k)
    {
      this->Distance = (this->LineOf(k) - this->Eye.Y) * this->Fan.Step;
      const double west = this->Eye.X + this->Fan.First * this->Distance;
      const double east = this->Eye.X + this->Fan.Last * this->Distance;
      const bool leaves = (this->Fan.First > 0.0 && west > static_cast<double>(this->Grid.Width)) ||
        (this->Fan.Last < 0.0 && east < -1.0);
      if (leaves)
      {
        return;
      }
      while (this->Bins < MostBins && (east - west) > 0.75 * this->Bins)
      {
        this->SplitBins();
      }
      this->ReadRow(k, this->Slopes[k & 1]);
      this->RaiseLow(k);
      this->RaiseHigh(k);
      this->LookAtTargets<Measures>(k, sink);
      this->BoundGap(k);
    }
  }

private:
  /// Gaps between rows before a target that High leaves out.
  static constexpr int Lag = 2;
  static constexpr int MostBins = 512;
  static constexpr float Reach = 1e-4f;
  /// Columns that are read on either side of those of the fan.
  static constexpr int Beside = 24;
  static constexpr int RowSize = LaneFan::Columns + 2 * Beside + 2 * L::Count;
  static constexpr float Wall = 1e12f; ///< heights beyond are no ground (Viewshed.h)

  /// Slopes of the samples of a row over the observer.
  struct RowSlopes
  {
    int Base; ///< column of the first
    int Count;
    float Values[RowSize];
  };

  double LineOf(int k) const
  {
    return static_cast<double>(this->FirstLine + k * this->Fan.Step);
  }

  void FillBins(int begin, int end, float value)
  {
    for (int b = begin; b < end; ++b)
    {
      this->Low[b] = this->High[b] = value;
      for (auto& gap : this->Gaps)
      {
        gap[b] = value;
      }
    }
  }

  static void Split(float* values, int count)
  {
    for (std::ptrdiff_t b = count - 1; b >= 0; --b)
    {
      values[2 * b + 1] = values[2 * b] = values[b];
    }
  }
  void SplitBins()
  {
    Split(this->Low, this->Bins);
    Split(this->High, this->Bins);
    for (auto& gap : this->Gaps)
    {
      Split(gap, this->Bins);
    }
    this->Bins *= 2;
  }

  /// Slopes of the samples of row k; those of the row before the first, beside or behind the
  /// observer, only tell where there is ground.
  void ReadRow(int k, RowSlopes& row) const
  {
    const double distance = (this->LineOf(k) - this->Eye.Y) * this->Fan.Step;
    const double west = this->Eye.X + this->Fan.First * distance;
    const double east = this->Eye.X + this->Fan.Last * distance;
    const double low = west < east ? west : east;
    const double high = west < east ? east : west;
    row.Base = static_cast<int>(low < -1.0 ? low - 1.0 : low) - Beside;
    row.Count = static_cast<int>(high) + Beside - row.Base;
    const auto far = static_cast<float>(distance > 0.0 ? distance : 1.0);
    const float inverse = 1.0f / far;
    const float offset = this->Sag - this->Eye.Z - this->Eye.FallNorth * far * far;
    const auto own = static_cast<float>(this->Eye.X - row.Base);
    const float* from = this->Grid.Samples +
      this->Grid.Stride * (this->FirstLine + static_cast<std::int64_t>(k) * this->Fan.Step);
    for (int c = 0; c < row.Count; c += L::Count)
    {
      const std::int64_t column = row.Base + c;
      Value slope = L::All(__builtin_nanf(""));
      if (column > -L::Count && column < this->Grid.Width)
      {
        const Value across = this->Lane + (static_cast<float>(c) - own);
        slope =
          (L::Load(from + column) + offset - this->Eye.FallEast * (across * across)) * inverse;
      }
      L::Store(slope, row.Values + c);
    }
  }

  /// Raises Low by the surface along row k, where the gap before it has one, too.
  TERRAIN_LANES_INLINE void RaiseLow(int k)
  {
    RowSlopes& row = this->Slopes[k & 1];
    const RowSlopes& before = this->Slopes[(k + 1) & 1];
    const float* past = before.Values + (row.Base - before.Base);
    const auto wall = static_cast<float>(Wall / this->Distance);
    for (int c = Beside / 2; c < row.Count - Beside / 2; c += L::Count)
    {
      const Value slope = L::Load(row.Values + c);
      const Value other = L::Load(past + c);
      const Mask ground = (other == other) & (slope < wall);
      L::Store(ground ? slope : L::All(__builtin_nanf("")), this->Ground + c);
    }
    const double step = (this->Fan.Last - this->Fan.First) * this->Distance / this->Bins;
    const double first = this->Eye.X + this->Fan.First * this->Distance - row.Base;
    for (int b = 0; b <= this->Bins; b += L::Count)
    {
      const double own = first + b * step;
      const int base = static_cast<int>(own);
      const Value x = static_cast<float>(own - base) + this->Lane * static_cast<float>(step);
      const Mask cell = __builtin_convertvector(x, Mask);
      const Value part = x - __builtin_convertvector(cell, Value);
      const Value west = PickNear(this->Ground + base, cell);
      const Value east = PickNear(this->Ground + base, cell + 1);
      L::Store(west + part * (east - west), this->Edges + b);
      L::Store(west, this->Samples + b);
      L::Store(__builtin_convertvector(cell + base, Value), this->Cells + b);
    }
    const auto less = static_cast<float>((this->Margin + this->Sag) / this->Distance);
    for (int b = 0; b < this->Bins; b += L::Count)
    {
      const Value west = L::Load(this->Edges + b);
      const Value east = L::Load(this->Edges + b + 1);
      const Mask within = L::Load(this->Cells + b) != L::Load(this->Cells + b + 1);
      const Value middle = within ? L::Load(this->Samples + b + 1) : west;
      Value least = west < east ? west : east;
      least = (middle < least ? middle : least) - less;
      const Mask whole = (west == west) & (east == east) & (middle == middle);
      const Value low = L::Load(this->Low + b);
      L::Store((whole & (least > low)) ? least : low, this->Low + b);
    }
  }

  /// Raises High by the gap that has come to lie far enough behind.
  TERRAIN_LANES_INLINE void RaiseHigh(int k)
  {
    for (int b = 0; b < this->Bins; b += L::Count)
    {
      const Value high = L::Load(this->High + b);
      const Value gap = L::Load(this->Gaps[k % Lag] + b);
      L::Store(gap > high ? gap : high, this->High + b);
    }
  }

  /// The higher of two, where one is a number.
  TERRAIN_LANES_INLINE static Value Highest(Value a, Value b)
  {
    const Value higher = L::Maximum(a, b);
    return higher == higher ? higher : a;
  }

  /// Bounds the slopes in the gap before row k, but for the first, in which the observer may stand.
  TERRAIN_LANES_INLINE void BoundGap(int k)
  {
    if (k == 0)
    {
      return;
    }
    const RowSlopes& row = this->Slopes[k & 1];
    const RowSlopes& before = this->Slopes[(k + 1) & 1];
    const float* past = before.Values + (row.Base - before.Base);
    for (int c = Beside / 2; c < row.Count - Beside / 2; c += L::Count)
    {
      const Value west = Highest(L::Load(row.Values + c), L::Load(past + c));
      const Value east = Highest(L::Load(row.Values + c + 1), L::Load(past + c + 1));
      L::Store(Highest(west, east), this->Ground + c);
    }
    const double turn = (this->Fan.Last - this->Fan.First) / this->Bins;
    const double step = turn * this->Distance;
    const double first = this->Eye.X + this->Fan.First * this->Distance - row.Base;
    const auto more = static_cast<float>(this->Margin / this->Distance);
    float* gaps = this->Gaps[k % Lag];
    for (int b = 0; b < this->Bins; b += L::Count)
    {
      const double own = first + b * step;
      const int base = static_cast<int>(own) - 2;
      const Value x = static_cast<float>(own - base) + this->Lane * static_cast<float>(step);
      const Value slope =
        static_cast<float>(this->Fan.First + b * turn) + this->Lane * static_cast<float>(turn);
      const Value next = slope + static_cast<float>(turn);
      const Value low = x - (slope > 0.0f ? slope : Value{}) - Reach;
      const Value high = x + static_cast<float>(step) - (next < 0.0f ? next : Value{}) + Reach;
      const Mask west = __builtin_convertvector(low, Mask);
      const Mask east = __builtin_convertvector(high, Mask); // one less than where it ends
      const Value most =
        Highest(PickNear(this->Ground + base, west), PickNear(this->Ground + base, east));
      L::Store(most == most ? most + more : L::All(-__builtin_huge_valf()), gaps + b);
    }
  }

  /// The columns of the targets in row k, begin <= i < end.
  void FindTargets(std::int64_t& begin, std::int64_t& end) const
  {
    const double far = this->Distance;
    const auto ceiling = [](double x)
    {
      const auto whole = static_cast<std::int64_t>(x);
      return static_cast<double>(whole) < x ? whole + 1 : whole;
    };
    begin = ceiling(this->Eye.X + this->Fan.First * far);
    end = ceiling(this->Eye.X + this->Fan.Last * far);
    // In double, so that each sample is on one side of a diagonal, here and transposed.
    const auto inside = [this, far](std::int64_t i)
    {
      const double across = static_cast<double>(i) - this->Eye.X;
      const double sideways = across < 0.0 ? -across : across;
      return this->Eye.Strict ? sideways < far : sideways <= far;
    };
    if (this->Fan.First == -1.0)
    {
      begin += inside(begin - 1) ? -1 : (inside(begin) ? 0 : 1);
    }
    if (this->Fan.Last == 1.0)
    {
      end += inside(end) ? 1 : (inside(end - 1) ? 0 : -1);
    }
    begin = begin < 0 ? 0 : begin;
    end = end < this->Grid.Width ? end : this->Grid.Width;
  }

  template <bool Measures>
  TERRAIN_LANES_INLINE void LookAtTargets(int k, const HiddenSink& sink)
  {
    const double far = this->Distance;
    const auto rows = static_cast<float>(far);
    const std::int64_t row = this->FirstLine + static_cast<std::int64_t>(k) * this->Fan.Step;
    std::int64_t begin;
    std::int64_t end;
    this->FindTargets(begin, end);
    const double west = this->Eye.X + this->Fan.First * far;
    const double perColumn = this->Bins / ((this->Fan.Last - this->Fan.First) * far);
    for (std::int64_t i = begin; i < end; i += L::Count)
    {
      const double firstAcross = static_cast<double>(i) - this->Eye.X;
      const Value across = this->Lane + static_cast<float>(firstAcross);
      const Value ground = L::Load(this->Grid.Samples + this->Grid.Stride * row + i);
      const Value slope = across / rows;
      const Value fall = this->Eye.FallNorth + this->Eye.FallEast * (slope * slope);
      const Value difference = ground + (this->Eye.TargetHeight - this->Eye.Z);
      const Value raise =
        this->Eye.Tolerance + 4e-6f * (difference < 0.0f ? -difference : difference);
      const Value rise = (difference + raise) / rows - fall * rows;
      const Mask inside = (this->Lane < static_cast<float>(end - i)) & (ground == ground);
      const Value place = static_cast<float>((static_cast<double>(i) - west) * perColumn) +
        this->Lane * static_cast<float>(perColumn);
      Mask bin = __builtin_convertvector(place, Mask);
      bin = bin < 0 ? Mask{} : bin;
      bin = bin < this->Bins ? bin : Mask{} + (this->Bins - 1);
      const Value low = PickAny(this->Low, bin);
      const Value high = PickAny(this->High, bin);
      const Mask open = inside & ~(rise < low);
      Value hidden = L::All(1.0f);
      if (Measures ? L::Any(inside) : L::Any(open))
      {
        const bool onColumn =
          static_cast<double>(static_cast<std::int64_t>(this->Eye.X)) == this->Eye.X;
        const Mask along = (across == 0.0f) & (onColumn ? inside : Mask{});
        ViewshedLanes<Measures> lanes{ this->Grid, this->Eye, this->Fan.Step, this->FirstLine,
          static_cast<float>((this->FirstLine - this->Eye.Y) * this->Fan.Step), k + 1, this->Eye.X,
          firstAcross / far, 1.0f / rows, this->Lane, slope, rise, fall, along,
          Measures ? inside : open };
        if constexpr (Measures)
        {
          lanes.Rise = low > rise ? low : rise;
          lanes.Look(this->Guess);
          hidden = lanes.Rise > rise ? (lanes.Rise - rise) * rows + raise : Value{};
        }
        else
        {
          this->Decide(lanes, ~(rise < high), k);
          hidden = lanes.Seeking ? Value{} : hidden;
        }
      }
      L::Store(hidden, this->Hidden + (i - begin));
    }
    if (begin < end)
    {
      sink.Take(sink.Context, row, begin, end - begin, this->Hidden);
    }
  }

  /// free: lanes that nothing hides but perhaps the first gap and the last ones.
  TERRAIN_LANES_INLINE void Decide(ViewshedLanes<false>& lanes, Mask free, int k)
  {
    lanes.VisitGap(0);
    for (int gap = k - Lag + 1 > 1 ? k - Lag + 1 : 1; gap <= k; ++gap)
    {
      lanes.VisitGap(gap);
    }
    const Mask seen = lanes.Seeking & free;
    lanes.Seeking &= ~free;
    if (L::Any(lanes.Seeking))
    {
      lanes.Look(this->Guess);
    }
    lanes.Seeking |= seen;
  }

  const LaneGrid<float>& Grid;
  const LaneObserver& Eye;
  const LaneFan& Fan;
  float Margin; ///< heights
  float Sag;    ///< how far the round earth bulges within a cell
  int FirstLine;
  int Rows;
  double Distance = 0.0; ///< of the row, in rows
  int Bins = 16;
  int Guess = -1;
  Value Lane;
  RowSlopes Slopes[2];
  float Ground[RowSize];
  float Low[MostBins];
  float High[MostBins];
  float Gaps[Lag][MostBins];
  float Edges[MostBins + 2 * L::Count];
  float Samples[MostBins + 2 * L::Count];
  float Cells[MostBins + 2 * L::Count];
  float Hidden[RowSize];
};

inline void LookAlongFan(const LaneGrid<float>& grid, const LaneObserver& eye, const LaneFan& fan,
  bool measures, const HiddenSink& sink)
{
  ViewshedFan looking(grid, eye, fan);
  if (measures)
  {
    looking.Look<true>(sink);
  }
  else
  {
    looking.Look<false>(sink);
  }
}
} // namespace TERRAIN_LANES_KIND
} // namespace terrain

#endif
