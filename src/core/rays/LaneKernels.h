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
  /// -a is nowhere more than this; infinite if samples of the grid are without data.
  Real LargestCurvature = 0;
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

/// A fan of sights from an observer, north or south: those that cross First to Last columns a row.
struct LaneFan
{
  /// Columns between First and Last at the farthest row, at most.
  static constexpr int Columns = 256;

  int Step = 1; ///< 1 if the targets lie north of the observer, else -1
  double First = -1.0;
  double Last = 1.0;
  int Rows = 0; ///< at most so many rows of samples are looked at
};

/// Takes what the sights of a fan found: by how much the targets of a row, from a column eastward,
/// would have to rise to be seen; 0 for those that are.
struct HiddenSink
{
  using Function = void (*)(
    void* context, std::int64_t row, std::int64_t first, std::int64_t count, const float* hidden);
  Function Take = nullptr;
  void* Context = nullptr;
};

/// Looks at the samples in a fan, not those in the row of the observer, as far as they lie rather
/// north or south of it than east or west. measures: the numbers given are right, not only those
/// that are 0.
using ViewshedKernel = void (*)(const LaneGrid<float>& grid, const LaneObserver& eye,
  const LaneFan& fan, bool measures, const HiddenSink& sink);

/// A heightfield for packets of rays, and the pyramid over it. Its heights are
/// those over Base, from 0 to Highest.
struct PacketGrid
{
  static constexpr int MostLevels = 15;

  int CellsX = 0;
  int CellsY = 0;
  int Stride = 0; ///< samples from one row to the next
  bool FloatSamples = false;
  const void* Samples = nullptr; ///< floats, -1 for no data; or 16-bit codes
  /// Nodes by levels: the highest code in the lower 16 bits, the lowest in the upper ones.
  const std::uint32_t* Nodes = nullptr;
  float NodeStep = 1.0f; ///< heights per code of the nodes
  float Highest = 0.0f;
  double Base = 0.0;
  int Levels = 0;
  /// Of level 1 to MostLevels, at their index.
  std::int32_t LevelBegins[MostLevels + 1] = {};
  std::int32_t LevelWidths[MostLevels + 1] = {};
  std::int32_t LevelHeights[MostLevels + 1] = {};
};

/// Rays in grid coordinates and height units, from distance 0 on.
struct PacketRays
{
  static constexpr int Most = 16;

  int Count = 0; ///< the rest up to the next multiple of 16 is cast, too
  double Origin[3][Most];
  double Direction[3][Most];
  double End[Most];
};

/// What the rays of a packet meet.
struct PacketHits
{
  float Distance[PacketRays::Most]; ///< infinity for nothing
  std::int32_t CellX[PacketRays::Most];
  std::int32_t CellY[PacketRays::Most];
  float FractionX[PacketRays::Most];
  float FractionY[PacketRays::Most];
  /// Of the surface, in heights of the PacketGrid per cell.
  float SlopeX[PacketRays::Most];
  float SlopeY[PacketRays::Most];
};

/// Finds the first hits of a packet (PacketLanes.h).
using PacketKernel = void (*)(const PacketGrid& grid, const PacketRays& rays, PacketHits& hits);

/// The loops for one kind of processor. Results of the kinds differ by rounding
/// at most.
struct LaneKernels
{
  const char* Name = "";
  int Bytes = 0; ///< of all lanes
  HorizonKernel<float> Horizon = nullptr;
  HorizonKernel<double> HorizonInDouble = nullptr;
  ViewshedKernel Viewshed = nullptr;
  PacketKernel Packet = nullptr;
};

/// The kinds that this processor runs, the fastest last; at least one.
const std::vector<LaneKernels>& RunnableLaneKernels();
} // namespace terrain

#endif
