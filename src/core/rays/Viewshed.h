// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which samples of a heightfield observers see.
 */
#ifndef terrain_Viewshed_h
#define terrain_Viewshed_h

#include "core/grid/Constants.h"
#include "core/grid/HeightCodes.h"
#include "core/grid/Heightfield.h"
#include "core/grid/PaddedGrid.h"
#include "core/grid/ParallelFor.h"
#include "core/rays/LaneKernels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace terrain
{
/// Sights that the surface touches are free: they lead to points this part of
/// the relief, of a cell and of the difference of heights above what is looked
/// at.
constexpr double kSightTolerance = 4e-6;

/// Where an eye is.
struct Observer
{
  /// In grid coordinates, on the grid.
  glm::dvec2 Position{ 0.0, 0.0 };
  /// Height of the surface there, and of the eye, in height units.
  double Ground = 0.0;
  double Eye = 0.0;
};

/// What is looked at, and over what earth.
struct ViewshedOptions
{
  /// Distance of neighbouring samples east and north in height units, both > 0.
  glm::dvec2 Spacing{ 1.0, 1.0 };
  /// Height of what is looked at above the sample, in height units, >= 0.
  double TargetHeight = 0.0;
  /// As HorizonOptions::Drop.
  double Drop = 0.0;
  /// Seen are samples at these horizontal distances, in height units,
  double NearestDistance = 0.0;
  double FarthestDistance = kInfinity;
  /// these directions, in degrees clockwise from north, from the first
  /// clockwise to the last; all if they differ by 360 or more,
  double FirstAzimuth = 0.0;
  double LastAzimuth = 360.0;
  /// and these elevations of the sight, in degrees.
  double LowestElevation = -90.0;
  double HighestElevation = 90.0;

  bool HasLimits() const;
  /// By how much a target would have to rise to be seen, 0 if it is; infinity if it cannot be seen
  /// from here. target: its place from the eye in height units. hidden: by how much it would have
  /// to rise over what stands before it.
  double RiseToBeSeen(const glm::dvec3& target, double hidden) const;
};

/**
 * Viewsheds of a heightfield.
 *
 * An observer sees a sample if the straight line from the eye to the point
 * TargetHeight above the sample does not run below the bilinear surface. The
 * surface may touch the line: it hides where it stands above the line to a
 * point that is raised by a millionth of a cell and of the difference of
 * heights. Cells that touch a sample without data have no surface and hide
 * nothing; such samples are not seen. An eye below the ground sees nothing.
 *
 * What there is no data for may block, too: then such cells are walls without end.
 *
 * Method: the samples around an observer are looked at in fans, row by row outward. In each fan two
 * bounds of the horizon so far decide most samples (ViewshedFan.h). For the others lines of sight
 * to 4 to 16 neighbours go together, one a SIMD lane (Lanes.h), from row to row, since those lines
 * are never more than a cell apart (ViewshedLanes.h). Over each cell the height of the surface
 * above the line is a parabola whose maximum decides. Stretches that the min-max pyramid's maximum
 * shows to be below all lines are left out. Targets that lie rather east or west of the observer
 * are looked for on the transposed grid. Heights are floats relative to the middle of their range;
 * positions keep their digits at any distance.
 *
 * Error: that of float. A sample whose line of sight comes closer to the surface than twice
 * kSightTolerance may come out either way.
 *
 * Memory: two copies of the heights and their pyramids, 15 bytes a sample, and a byte a sample
 * while it counts, 5 while it measures.
 */
class ViewshedGrid
{
public:
  /// Copies the heights; the view need not live on. holesBlock: cells without data are walls.
  template <typename T>
  ViewshedGrid(
    const HeightfieldView<T>& view, const ParallelFor& parallelFor, bool holesBlock = false)
    : ViewshedGrid({ view.Width, view.Height }, RangeOf(FindHeightRange(view, parallelFor)),
        ReadRows(view), parallelFor, holesBlock)
  {
  }
  ~ViewshedGrid();
  ViewshedGrid(const ViewshedGrid&) = delete;
  void operator=(const ViewshedGrid&) = delete;

  /// Adds, to counts[i + Width * j], how many of the observers see sample (i, j). Runs in parallel
  /// over fans. kernels: one of RunnableLaneKernels(), the fastest if not given.
  void Count(const std::vector<Observer>& observers, const ViewshedOptions& options,
    std::uint32_t* counts, const ParallelFor& parallelFor,
    const LaneKernels& kernels = RunnableLaneKernels().back()) const;

  /// As Count(), and lowers rises[i + Width * j] to what the target above sample (i, j) would have
  /// to rise, in height units, to be seen by one of the observers: 0 where it is. Begin with
  /// infinity, which stays where no rise would do. A rise is right to the tolerance of sights.
  void Measure(const std::vector<Observer>& observers, const ViewshedOptions& options,
    std::uint32_t* counts, float* rises, const ParallelFor& parallelFor,
    const LaneKernels& kernels = RunnableLaneKernels().back()) const;

private:
  struct Side;
  struct Looking;
  class Taker;
  /// range: lowest and highest height; the first is greater if there is none.
  ViewshedGrid(const glm::i64vec2& size, const glm::dvec2& range, const RowReader& read,
    const ParallelFor& parallelFor, bool holesBlock);
  template <typename T>
  static glm::dvec2 RangeOf(const HeightRange<T>& range)
  {
    return { static_cast<double>(range.Minimum), static_cast<double>(range.Maximum) };
  }
  void LookAround(const Looking& looking, const Observer& observer) const;

  std::int64_t Width;
  std::int64_t Height;
  double Middle = 0.0; ///< height that is 0 in the copies
  double Relief = 0.0; ///< highest less lowest height
  std::unique_ptr<Side> Upright;
  std::unique_ptr<Side> Transposed;
};
} // namespace terrain

#endif
