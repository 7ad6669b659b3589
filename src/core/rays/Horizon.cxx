// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/Horizon.h"

#include "core/rays/HorizonWay.h"
#include "core/rays/PreparedGrid.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace terrain
{
namespace
{
/// An error of slopes that is left to float: 0.001 degrees.
constexpr double kLeastSlope = 2e-5;

/// Largest |sw - se - nw + ne| of the cells; infinite if a sample of theirs is without data.
double FindLargestTwist(const LaneGrid<float>& grid, const ParallelFor& parallelFor)
{
  double largest = 0.0;
  std::mutex mutex;
  parallelFor(grid.Height - 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      float most = 0.0F;
      bool hasHoles = false;
      for (std::int64_t row = begin; row < end; ++row)
      {
        const float* south = grid.Samples + grid.Stride * row;
        const float* north = south + grid.Stride;
        for (std::int64_t i = 0; i + 1 < grid.Width; ++i)
        {
          const float twist = std::abs((south[i] - south[i + 1]) - (north[i] - north[i + 1]));
          most = twist > most ? twist : most;
          hasHoles |= !(twist == twist);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      largest = std::max(largest, hasHoles ? kInfinity : static_cast<double>(most));
    });
  // the twist of doubles, or in another order of sums, may be a little more
  return largest * (1.0 + 1e-5);
}
} // namespace

HorizonGrid::HorizonGrid(
  std::int64_t width, std::int64_t height, const RowReader& read, const ParallelFor& parallelFor)
  : Width(width)
  , Height(height)
{
  // How far heights are off as floats.
  double rounding = 0.0;
  std::mutex mutex;
  parallelFor(height,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<double> heights(static_cast<std::size_t>(width));
      double most = 0.0;
      for (std::int64_t row = begin; row < end; ++row)
      {
        read(row, heights.data());
        for (const double h : heights)
        {
          const double off = std::abs(h - static_cast<double>(static_cast<float>(h)));
          most = off > most ? off : most; // NaN is not
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      rounding = std::max(rounding, most);
    });
  this->Rounding = rounding;
  this->Single = std::make_unique<PreparedGrid<float>>(
    PaddedGrid<float>(width, height, read, parallelFor), parallelFor);
  this->LargestTwist = FindLargestTwist(this->Single->View, parallelFor) + 4.0 * rounding;
  if (rounding > 0.0)
  {
    this->Double = std::make_unique<PreparedGrid<double>>(
      PaddedGrid<double>(width, height, read, parallelFor), parallelFor);
  }
}

HorizonGrid::~HorizonGrid() = default;

template <typename Real>
void HorizonGrid::CastRows(const PreparedGrid<Real>& prepared, HorizonKernel<Real> kernel,
  int lanes, double azimuth, const HorizonOptions& options, const RowRange& rows, float* degrees,
  const ParallelFor& parallelFor) const
{
  const glm::i64vec2 size(this->Width, this->Height);
  const HorizonPath path(azimuth, options.Spacing, size);
  HorizonWay<Real> way(path, options.Drop, prepared.View.Stride, lanes, size);
  way.View.LargestCurvature =
    static_cast<Real>(options.Drop + std::abs(way.View.Twist) * this->LargestTwist);
  parallelFor(rows.End - rows.First,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        kernel(prepared.View, way.View, static_cast<Real>(options.EyeHeight), rows.First + row,
          degrees + row * this->Width);
      }
    });
}

void HorizonGrid::Cast(double azimuth, const HorizonOptions& options, const RowRange& rows,
  float* degrees, const ParallelFor& parallelFor, const LaneKernels& kernels) const
{
  // Two heights may be off, over the distance of one cell.
  const double slope = 2.0 * this->Rounding / std::min(options.Spacing.x, options.Spacing.y);
  if (this->Double && slope > kLeastSlope)
  {
    this->CastRows(*this->Double, kernels.HorizonInDouble,
      kernels.Bytes / static_cast<int>(sizeof(double)), azimuth, options, rows, degrees,
      parallelFor);
  }
  else
  {
    this->CastRows(*this->Single, kernels.Horizon, kernels.Bytes / static_cast<int>(sizeof(float)),
      azimuth, options, rows, degrees, parallelFor);
  }
}
} // namespace terrain
