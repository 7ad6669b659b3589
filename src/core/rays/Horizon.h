// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How high the terrain stands in the way of one who looks out from a sample of
 * it.
 */
#ifndef terrain_Horizon_h
#define terrain_Horizon_h

#include "core/grid/Constants.h"
#include "core/grid/Heightfield.h"
#include "core/grid/PaddedGrid.h"
#include "core/grid/ParallelFor.h"
#include "core/rays/LaneKernels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>

namespace terrain
{
/// Largest error of a horizon angle, in degrees.
constexpr double kHorizonError = 0.01;
/// The horizon where no surface lies ahead: the sight is free down to the
/// ground at one's feet.
constexpr float kNoHorizon = -90.0f;

/// From where, and over what earth, horizons are seen.
struct HorizonOptions
{
  /// Distance of neighbouring samples east and north in height units, both > 0.
  glm::dvec2 Spacing{ 1.0, 1.0 };
  /// Height of the eye above the sample, in height units, >= 0.
  double EyeHeight = 0.0;
  /// What the ground falls by at a distance d is Drop * d^2, in height units: 0
  /// on a flat earth, (1 - k) / (2 R) on one of radius R under a refraction k.
  double Drop = 0.0;
};

template <typename Real>
struct PreparedGrid;

/// First <= row < End.
struct RowRange
{
  std::int64_t First = 0;
  std::int64_t End = 0;
};

/**
 * The horizon of every sample of a heightfield, in any direction.
 *
 * The horizon angle of a sample in a direction is the supremum, over all
 * distances t > 0 at which there is surface in that direction, of the elevation
 *
 *   atan((h(t) - Drop t^2 - h(0) - EyeHeight) / t),
 *
 * where h is the bilinear surface, not only its samples. It is negative where
 * the terrain falls away on all sides that are ahead. With EyeHeight 0 it is no
 * less than the slope of the sample's own cell. Cells that touch a sample
 * without data have no surface and stand in nobody's way. If no surface is
 * ahead, the angle is kNoHorizon; of a sample without data it is NaN.
 *
 * A ray along a line of the grid sees the cells on both sides of it.
 *
 * Method: the rays of all samples in one direction are translates of each other
 * by whole cells. They cross the same lines at the same fractions. So 4 to 16
 * neighbours go together, one a SIMD lane (Lanes.h), and read neighbouring
 * heights. In a cell the tangent of the elevation is (c + b t + a t^2) / t; its
 * maximum is at an end or, if a and c are negative, at t = sqrt(c / a). A
 * stretch of the rays is left out if the maximum of the min-max pyramid over
 * all cells that it touches is not above the horizon so far, in any lane.
 * Stretches double in length with distance. The place where the neighbours met
 * their horizon is looked at first.
 *
 * Error: kHorizonError. Heights are worked on as floats where their rounding
 * makes no more than 0.001 degrees of a difference, else as doubles. Results
 * are the same for any number of threads; on other processors they differ by
 * rounding.
 *
 * Cost: about 70 ns a sample and direction on one core with AVX-512, 85 with
 * AVX2, on rough terrain of 1024^2 samples. Memory: a copy of the heights and
 * their pyramid, 7 bytes a sample; 21 if heights are not floats.
 */
class HorizonGrid
{
public:
  /// Copies the heights; the view need not live on.
  template <typename T>
  HorizonGrid(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
    : HorizonGrid(view.Width, view.Height, ReadRows(view), parallelFor)
  {
  }
  ~HorizonGrid();
  HorizonGrid(const HorizonGrid&) = delete;
  void operator=(const HorizonGrid&) = delete;

  /**
   * Horizon angles, in degrees, of the samples of some rows in the direction
   * azimuth (degrees clockwise from north, finite), to degrees[i + Width * (j -
   * rows.First)]. Runs in parallel over rows. kernels: one of
   * RunnableLaneKernels(), the fastest if not given.
   */
  void Cast(double azimuth, const HorizonOptions& options, const RowRange& rows, float* degrees,
    const ParallelFor& parallelFor,
    const LaneKernels& kernels = RunnableLaneKernels().back()) const;

private:
  HorizonGrid(std::int64_t width, std::int64_t height, const RowReader& read, const ParallelFor&);

  template <typename Real>
  void CastRows(const PreparedGrid<Real>& prepared, HorizonKernel<Real> kernel, int lanes,
    double azimuth, const HorizonOptions& options, const RowRange& rows, float* degrees,
    const ParallelFor& parallelFor) const;

  std::int64_t Width;
  std::int64_t Height;
  double Rounding = 0.0; ///< largest error of a height as float
  /// Largest |sw - se - nw + ne| of a cell; infinite if samples are without data.
  double LargestTwist = 0.0;
  std::unique_ptr<PreparedGrid<float>> Single;
  std::unique_ptr<PreparedGrid<double>> Double; ///< if Rounding is above 0
};
} // namespace terrain

#endif
