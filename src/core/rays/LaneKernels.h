// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Loops over lanes (Lanes.h) that are compiled for several kinds of processors,
 * the choice of one of them, and the tables they work on, which are plain
 * memory.
 */
#ifndef terrain_LaneKernels_h
#define terrain_LaneKernels_h

#include "core/surface/MinMaxPyramid.h"

#include <cstdint>
#include <vector>

namespace terrain
{
/// A PaddedGrid and the pyramid over it with its margin. Cell (i, j) of the
/// grid is cell (i + Margin, j + 1) of the pyramid.
template <typename Real>
struct LaneGrid
{
  struct Level
  {
    const PyramidNode<Real>* Nodes = nullptr;
    int Width = 0;
    int Height = 0;
  };

  std::int64_t Width = 0; ///< samples
  std::int64_t Height = 0;
  std::int64_t Stride = 0;
  const Real* Samples = nullptr; ///< sample (0, 0)
  int Margin = 0;
  int PyramidWidth = 0; ///< cells of the pyramid
  int PyramidHeight = 0;
  int LevelCount = 0;
  const Level* Levels = nullptr; ///< level k of the pyramid at Levels[k - 1]
};

/// A cell of the way of a ray; offsets are those of samples in memory from
/// where the ray starts.
template <typename Real>
struct WayStep
{
  std::int64_t Cell = 0;
  std::int64_t Beside = 0; ///< the cell across the line that the ray runs along; else Cell
  std::int64_t ExitBegin = 0;
  std::int64_t ExitEnd = 0;
  Real Fraction = 0;
  Real Drop = 0;    ///< of the earth at the exit
  Real Inverse = 0; ///< 1 / Exit
  Real Exit = 0;    ///< distances
  Real EnterEnter = 0;
  Real EnterExit = 0;
  Real ExitExit = 0;
  Real EnterShare = 0; ///< Enter / (Exit - Enter)
  Real ExitShare = 0;  ///< Exit / (Exit - Enter)
  Real Bulge = 0;      ///< (Exit - Enter)^2 / (4 Enter): slope that a curvature of 1
                       ///< adds at most
};

/// A stretch of a way.
template <typename Real>
struct WayStretch
{
  int West = 0; ///< its cells, from where the rays of all lanes start
  int East = 0;
  int South = 0;
  int North = 0;
  int Level = 1; ///< of the pyramid's nodes that bound it
  Real Drop = 0; ///< of the earth where it begins
  Real InverseEnter = 0;
  Real InverseExit = 0;
};

/// The way of rays in one direction.
template <typename Real>
struct LaneWay
{
  /// Steps in a leaf of the tree of stretches.
  static constexpr int LeafSteps = 16;

  const WayStep<Real>* Steps = nullptr;
  int TreeLevels = 0;
  /// Stretch k of a level covers the leaves k * 2^level to (k + 1) * 2^level
  /// - 1.
  const WayStretch<Real>* const* Tree = nullptr;
  /// Steps until a ray has left a grid with so many cells ahead.
  const int* StepsOfColumns = nullptr;
  const int* StepsOfRows = nullptr;
  bool East = true;
  bool North = true;
  /// The parabola over a cell has a = Twist * (sw - se - nw + ne) - Drop.
  Real Twist = 0;
  Real Drop = 0;
};

/// Horizons in degrees of a row of samples (Horizon.h).
template <typename Real>
using HorizonKernel = void (*)(const LaneGrid<Real>& grid, const LaneWay<Real>& way, Real eyeHeight,
  std::int64_t row, float* degrees);

/// An observer of a grid, as Viewshed.h has it; heights are those of the grid.
struct LaneObserver
{
  double X = 0.0; ///< in cells
  double Y = 0.0;
  float Z = 0.0f; ///< of the eye
  float Ground = 0.0f;
  float TargetHeight = 0.0f;
  float FallEast = 0.0f; ///< of the earth at a distance of one cell
  float FallNorth = 0.0f;
  float Tolerance = 0.0f;
  /// Samples that lie as far east or west as north or south of the observer are
  /// left out.
  bool Strict = false;
};

/// Adds 1 to the counts of the samples of a row, not that of the observer, that
/// are seen, as far as they lie rather north or south of the observer than east
/// or west.
using ViewshedKernel = void (*)(
  const LaneGrid<float>& grid, const LaneObserver& eye, std::int64_t row, std::uint32_t* counts);

/// The loops for one kind of processor. Results of the kinds differ by rounding
/// at most.
struct LaneKernels
{
  const char* Name = "";
  int Bytes = 0; ///< of all lanes
  HorizonKernel<float> Horizon = nullptr;
  HorizonKernel<double> HorizonInDouble = nullptr;
  ViewshedKernel Viewshed = nullptr;
};

/// The kinds that this processor runs, the fastest last; at least one.
const std::vector<LaneKernels>& RunnableLaneKernels();
} // namespace terrain

#endif
