// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The horizons of neighbours in a row, one a lane (Lanes.h); the method is that of Horizon.h.
 */
#ifndef terrain_HorizonLanes_h
#define terrain_HorizonLanes_h

#include "core/grid/Lanes.h"
#include "core/rays/LaneBounds.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
/// Largest error of ArcTangentDegrees() beside the rounding of Real, in radians.
constexpr double kArcTangentError = 2e-8;

/// arctan in degrees. Source: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.49.
template <typename Real>
TERRAIN_LANES_INLINE typename Lanes<Real>::Value ArcTangentDegrees(
  typename Lanes<Real>::Value tangent)
{
  using L = Lanes<Real>;
  const typename L::Value size = L::Maximum(tangent, -tangent);
  const typename L::Value x = size > Real(1) ? Real(1) / size : size;
  const typename L::Value y = x * x;
  typename L::Value sum = L::All(Real(0.0028662257));
  constexpr double coefficients[] = { -0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393,
    -0.1420889944, 0.1999355085, -0.3333314528, 1.0 };
  for (const double coefficient : coefficients)
  {
    sum = sum * y + Real(coefficient);
  }
  constexpr Real degrees = Real(57.29577951308232);
  const typename L::Value low = sum * x * degrees;
  const typename L::Value angle = size > Real(1) ? Real(90) - low : low;
  return tangent < Real(0) ? -angle : angle;
}

/// The horizons of Lanes::Count samples from (I, J) eastward, in one direction. Along: the rays run
/// along lines of the grid.
template <typename Real, bool Along>
struct HorizonLanes
{
  using L = Lanes<Real>;
  using Value = typename L::Value;
  using Mask = typename L::Mask;
  static constexpr int LeafSteps = LaneWay<Real>::LeafSteps;

  const LaneGrid<Real>& Grid;
  const LaneWay<Real>& Way;
  Real EyeHeight;
  int I; ///< the first sample
  int J;
  const Real* Start; ///< in memory
  int End;           ///< of the steps: all rays have left the grid
  Value Eye;         ///< heights
  Value Best;        ///< tangents of the horizons so far

  /// Height of the surface over the eye where rays leave a cell.
  TERRAIN_LANES_INLINE Value RiseAtExit(const WayStep<Real>& step) const
  {
    const Value begin = L::Load(this->Start + step.ExitBegin) - this->Eye;
    if constexpr (Along)
    {
      return begin - step.Drop;
    }
    const Value end = L::Load(this->Start + step.ExitEnd) - this->Eye;
    return begin + step.Fraction * (end - begin) - step.Drop;
  }

  /// sw - se - nw + ne of a cell; not a number where it has no surface.
  TERRAIN_LANES_INLINE Value TwistOf(std::int64_t cell) const
  {
    const Real* south = this->Start + cell;
    const Real* north = south + this->Grid.Stride;
    return (L::Load(south) - L::Load(south + 1)) - (L::Load(north) - L::Load(north + 1));
  }

  /// Curvature of the parabola over a cell, rise = b t - curvature t^2 - deficit; not a number
  /// where it has no surface.
  TERRAIN_LANES_INLINE Value CurvatureOf(const WayStep<Real>& step) const
  {
    const Value twist = this->TwistOf(step.Cell);
    if constexpr (Along)
    {
      const Value beside = this->TwistOf(step.Beside);
      const Mask valid = (twist == twist) | (beside == beside);
      return valid ? L::All(this->Way.Drop) : twist;
    }
    return this->Way.Drop - this->Way.Twist * twist;
  }

  /// The part of rise = b t - curvature t^2 - deficit over a cell.
  TERRAIN_LANES_INLINE static Value DeficitOf(
    const WayStep<Real>& step, Value curvature, Value enter, Value exit)
  {
    return exit * step.EnterShare - enter * step.ExitShare + curvature * step.EnterExit;
  }

  /// Lanes in which the highest tangent of a cell lies within it and may be above the horizon.
  /// border: the higher one of the tangents at its border.
  TERRAIN_LANES_INLINE Mask RisesWithin(
    const WayStep<Real>& step, Value curvature, Value deficit, Value border) const
  {
    return (border + curvature * step.Bulge > this->Best) &
      (deficit > curvature * step.EnterEnter) & (deficit < curvature * step.ExitExit);
  }

  /// Raises the horizons to the highest tangent within a cell, where there is one.
  TERRAIN_LANES_INLINE void RaiseWithin(int k)
  {
    const WayStep<Real>& step = this->Way.Steps[k];
    const Value enter = k > 0 ? this->RiseAtExit((&step)[-1]) : L::All(-this->EyeHeight);
    const Value exit = this->RiseAtExit(step);
    const Value curvature = this->CurvatureOf(step);
    const Value deficit = DeficitOf(step, curvature, enter, exit);
    const Value enterSlope = enter * (k > 0 ? (&step)[-1].Inverse : Real(0));
    const Value exitSlope = exit * step.Inverse;
    const Mask within =
      this->RisesWithin(step, curvature, deficit, enterSlope > exitSlope ? enterSlope : exitSlope);
    if (!L::Any(within))
    {
      return;
    }
    const Value root = L::Root(within ? deficit * step.Inverse : Value{}) -
      L::Root(within ? curvature * step.Exit : Value{});
    const Value summit = exit * step.Inverse + root * root;
    this->Best = (within & (summit > this->Best)) ? summit : this->Best;
  }

  /// Raises the horizons by the cells of a leaf.
  TERRAIN_LANES_INLINE void VisitLeaf(int leaf)
  {
    const int first = leaf * LeafSteps;
    const int end = first + LeafSteps < this->End ? first + LeafSteps : this->End;
    const WayStep<Real>* step = this->Way.Steps + first;
    Value enter = L::All(-this->EyeHeight);
    Value enterSlope = this->FirstSlope();
    if (first > 0)
    {
      enter = this->RiseAtExit(step[-1]);
      enterSlope = enter * step[-1].Inverse;
    }
    unsigned rising = 0; // a bit for each step that may rise within
    for (int k = first; k < end; ++k, ++step)
    {
      const Value exit = this->RiseAtExit(*step);
      const Value exitSlope = exit * step->Inverse;
      const Value curvature = this->CurvatureOf(*step);
      const Value border = enterSlope > exitSlope ? enterSlope : exitSlope;
      const Mask higher = border > this->Best;
      this->Best = (higher & (curvature == curvature)) ? border : this->Best;
      const Value deficit = DeficitOf(*step, curvature, enter, exit);
      rising |= unsigned(L::Any(this->RisesWithin(*step, curvature, deficit, border)))
        << (k - first);
      enter = exit;
      enterSlope = exitSlope;
    }
    for (; rising != 0; rising &= rising - 1)
    {
      this->RaiseWithin(first + __builtin_ctz(rising));
    }
  }

  /// The same of a leaf but the first, of a grid without holes: there a cell has a surface where
  /// its exit has, and only the few that could rise enough with the largest curvature are looked
  /// into.
  TERRAIN_LANES_INLINE void VisitFarLeaf(int leaf)
  {
    const int first = leaf * LeafSteps;
    const int end = first + LeafSteps < this->End ? first + LeafSteps : this->End;
    const WayStep<Real>* step = this->Way.Steps + first;
    Value enterSlope = this->RiseAtExit(step[-1]) * step[-1].Inverse;
    Value bounds[LeafSteps]; // of the tangents within the cells
    Value highest = this->Best;
    for (int k = first; k < end; ++k, ++step)
    {
      const Value exitSlope = this->RiseAtExit(*step) * step->Inverse;
      const Value border = enterSlope > exitSlope ? enterSlope : exitSlope;
      bounds[k - first] = border + this->Way.LargestCurvature * step->Bulge;
      this->Best = exitSlope > this->Best ? exitSlope : this->Best;
      highest = L::Maximum(bounds[k - first], highest);
      enterSlope = exitSlope;
    }
    if (!L::Any(highest > this->Best))
    {
      return;
    }
    for (int k = first; k < end; ++k)
    {
      if (L::Any(bounds[k - first] > this->Best))
      {
        this->RaiseWithin(k);
      }
    }
  }

  /// Raises the horizons by the cells of a leaf but the first.
  TERRAIN_LANES_INLINE void VisitLater(int leaf)
  {
    if (this->Way.LargestCurvature < Real(__builtin_huge_valf()))
    {
      this->VisitFarLeaf(leaf);
    }
    else
    {
      this->VisitLeaf(leaf);
    }
  }

  /// The slope of the surface at the samples themselves, which eyes on the ground see; else none.
  TERRAIN_LANES_INLINE Value FirstSlope() const
  {
    if (this->EyeHeight > Real(0))
    {
      return L::All(-__builtin_huge_valf());
    }
    const WayStep<Real>& step = this->Way.Steps[0];
    return this->RiseAtExit(step) * step.Inverse + this->CurvatureOf(step) * step.Exit;
  }

  /// True if the surface in a stretch may be above the horizon in a lane.
  TERRAIN_LANES_INLINE bool MayRise(const WayStretch<Real>& stretch) const
  {
    const Real maximum = MaximumOver(this->Grid,
      { this->I + stretch.West, this->I + stretch.East, this->J + stretch.South,
        this->J + stretch.North },
      stretch.Level);
    const Value rise = maximum - stretch.Drop - this->Eye;
    const Value bound = L::Maximum(rise * stretch.InverseEnter, rise * stretch.InverseExit);
    return L::Any(bound > this->Best);
  }

  /// guess: the leaf that raised the horizons of neighbours last; becomes that of these.
  TERRAIN_LANES_INLINE void Raise(int& guess)
  {
    this->VisitLeaf(0);
    if (guess > 0 && guess * LeafSteps < this->End)
    {
      this->VisitLater(guess);
    }
    const int leaves = (this->End + LeafSteps - 1) / LeafSteps;
    int leaf = 1;
    int level = 0;
    while (leaf < leaves)
    {
      if (!this->MayRise(this->Way.Tree[level][leaf >> level]))
      {
        leaf += 1 << level;
      }
      else if (level > 0)
      {
        --level;
        continue;
      }
      else
      {
        const Value before = this->Best;
        this->VisitLater(leaf);
        guess = L::Any(this->Best > before) ? leaf : guess;
        ++leaf;
      }
      level = __builtin_ctz(static_cast<unsigned>(leaf));
      level = level < this->Way.TreeLevels ? level : this->Way.TreeLevels - 1;
    }
  }

  TERRAIN_LANES_INLINE Value Cast(int& guess)
  {
    const Value ground = L::Load(this->Start);
    this->Eye = ground + this->EyeHeight;
    this->Best = L::All(-__builtin_huge_valf());
    if (this->End > 0 && L::Any(ground == ground))
    {
      this->Raise(guess);
    }
    return ground == ground ? ArcTangentDegrees<Real>(this->Best) : ground;
  }
};

template <typename Real, bool Along>
void CastHorizonRow(const LaneGrid<Real>& grid, const LaneWay<Real>& way, Real eyeHeight,
  std::int64_t row, float* degrees)
{
  constexpr int count = Lanes<Real>::Count;
  const int rowSteps = way.StepsOfRows[way.North ? grid.Height - 1 - row : row];
  int guess = 0;
  for (std::int64_t i = 0; i < grid.Width; i += count)
  {
    const std::int64_t last = i + count < grid.Width ? i + count : grid.Width;
    const int columnSteps = way.StepsOfColumns[way.East ? grid.Width - 1 - i : last - 1];
    HorizonLanes<Real, Along> lanes{ grid, way, eyeHeight, static_cast<int>(i),
      static_cast<int>(row), grid.Samples + i + grid.Stride * row,
      rowSteps < columnSteps ? rowSteps : columnSteps, {}, {} };
    Real angles[count];
    Lanes<Real>::Store(lanes.Cast(guess), angles);
    for (std::int64_t k = i; k < last; ++k)
    {
      degrees[k] = static_cast<float>(angles[k - i]);
    }
  }
}

template <typename Real>
void CastHorizons(const LaneGrid<Real>& grid, const LaneWay<Real>& way, Real eyeHeight,
  std::int64_t row, float* degrees)
{
  const auto cast = way.Twist == Real(0) ? CastHorizonRow<Real, true> : CastHorizonRow<Real, false>;
  cast(grid, way, eyeHeight, row, degrees);
}
}
}

#endif
