// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/Viewshed.h"

#include "core/rays/PreparedGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace terrain
{
namespace
{
/// Rows that are turned over together, so that both sides are read in lines of
/// memory.
constexpr std::int64_t kTurnedRows = 16;

/// Least and greatest height.
glm::dvec2 FindRange(const std::function<double(std::int64_t i, std::int64_t j)>& heights,
  const glm::i64vec2& size, const ParallelFor& parallelFor)
{
  glm::dvec2 range(kInfinity, -kInfinity);
  std::mutex mutex;
  parallelFor(size.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      glm::dvec2 part(kInfinity, -kInfinity);
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < size.x; ++i)
        {
          const double h = heights(i, j);
          part = { h < part.x ? h : part.x, h > part.y ? h : part.y };
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      range = { std::min(range.x, part.x), std::max(range.y, part.y) };
    });
  return range;
}
} // namespace

/// The grid, or the grid transposed.
struct ViewshedGrid::Side
{
  PreparedGrid<float> Grid;
  bool IsTransposed;
};

ViewshedGrid::~ViewshedGrid() = default;

bool ViewshedOptions::HasLimits() const
{
  return this->NearestDistance > 0.0 || this->FarthestDistance < kInfinity ||
    this->LastAzimuth - this->FirstAzimuth < 360.0 || this->LowestElevation > -90.0 ||
    this->HighestElevation < 90.0;
}

bool ViewshedOptions::IsWithin(const glm::dvec3& target) const
{
  const double distance = glm::length(glm::dvec2(target));
  const double azimuth = std::atan2(target.x, target.y) / kDegree;
  double turn = std::fmod(azimuth - this->FirstAzimuth, 360.0);
  turn += turn < 0.0 ? 360.0 : 0.0;
  const double rise = target.z - this->Drop * distance * distance;
  const double elevation = std::atan2(rise, distance) / kDegree;
  const bool isAhead = turn <= this->LastAzimuth - this->FirstAzimuth || distance == 0.0;
  return distance >= this->NearestDistance && distance <= this->FarthestDistance && isAhead &&
    elevation >= this->LowestElevation && elevation <= this->HighestElevation;
}

ViewshedGrid::ViewshedGrid(
  std::int64_t width, std::int64_t height, const HeightAt& heights, const ParallelFor& parallelFor)
  : Width(width)
  , Height(height)
{
  const glm::dvec2 range = FindRange(heights, { this->Width, this->Height }, parallelFor);
  const bool isEmpty = range.x > range.y;
  this->Relief = isEmpty ? 0.0 : range.y - range.x;
  this->Middle = isEmpty ? 0.0 : 0.5 * (range.x + range.y);
  // NOLINTNEXTLINE(modernize-make-unique): it is an aggregate that cannot be moved
  this->Upright.reset(new Side{ PreparedGrid<float>(
                                  this->Width, this->Height,
                                  [&](std::int64_t row, double* to)
                                  {
                                    for (std::int64_t i = 0; i < this->Width; ++i)
                                    {
                                      to[i] = heights(i, row) - this->Middle;
                                    }
                                  },
                                  parallelFor),
    false });
  const PaddedGrid<float>& grid = this->Upright->Grid.Grid;
  // NOLINTNEXTLINE(modernize-make-unique): it is an aggregate that cannot be moved
  this->Transposed.reset(new Side{ PreparedGrid<float>(
                                     this->Height, this->Width,
                                     [&](std::int64_t column, double* to)
                                     {
                                       const float* from = grid.At(column, 0);
                                       for (std::int64_t j = 0; j < this->Height; ++j)
                                       {
                                         to[j] = static_cast<double>(from[j * grid.Stride]);
                                       }
                                     },
                                     parallelFor),
    true });
}

void ViewshedGrid::CountSide(const Side& side, const std::vector<Observer>& observers,
  const ViewshedOptions& options, std::uint32_t* counts, const ParallelFor& parallelFor,
  const LaneKernels& kernels) const
{
  const LaneGrid<float>& grid = side.Grid.View;
  const glm::dvec2 spacing =
    side.IsTransposed ? glm::dvec2(options.Spacing.y, options.Spacing.x) : options.Spacing;
  const bool hasLimits = options.HasLimits();
  parallelFor(grid.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::uint32_t> seen(hasLimits ? static_cast<std::size_t>(grid.Width) : 0);
      for (std::int64_t row = begin; row < end; ++row)
      {
        for (const Observer& observer : observers)
        {
          LaneObserver eye;
          eye.X = side.IsTransposed ? observer.Position.y : observer.Position.x;
          eye.Y = side.IsTransposed ? observer.Position.x : observer.Position.y;
          eye.Z = static_cast<float>(observer.Eye - this->Middle);
          eye.Ground = static_cast<float>(observer.Ground - this->Middle);
          eye.TargetHeight = static_cast<float>(options.TargetHeight);
          eye.FallEast = static_cast<float>(options.Drop * spacing.x * spacing.x);
          eye.FallNorth = static_cast<float>(options.Drop * spacing.y * spacing.y);
          eye.Tolerance =
            static_cast<float>(kSightTolerance * (this->Relief + std::min(spacing.x, spacing.y)));
          eye.Strict = side.IsTransposed;
          std::uint32_t* const to = counts + row * grid.Width;
          if (eye.Y == static_cast<double>(row))
          {
            continue; // a row of the other side
          }
          if (!hasLimits)
          {
            kernels.Viewshed(grid, eye, row, to);
            continue;
          }
          std::fill(seen.begin(), seen.end(), 0u);
          kernels.Viewshed(grid, eye, row, seen.data());
          for (std::int64_t i = 0; i < grid.Width; ++i)
          {
            const glm::dvec2 place = spacing *
              glm::dvec2(static_cast<double>(i) - eye.X, static_cast<double>(row) - eye.Y);
            const double rise = static_cast<double>(*side.Grid.Grid.At(i, row)) + this->Middle +
              options.TargetHeight - observer.Eye;
            const glm::dvec3 target(side.IsTransposed ? glm::dvec2(place.y, place.x) : place, rise);
            to[i] += seen[static_cast<std::size_t>(i)] != 0 && options.IsWithin(target) ? 1 : 0;
          }
        }
      }
    });
}

void ViewshedGrid::Count(const std::vector<Observer>& observers, const ViewshedOptions& options,
  std::uint32_t* counts, const ParallelFor& parallelFor, const LaneKernels& kernels) const
{
  if (this->Width < 1 || this->Height < 1)
  {
    return;
  }
  this->CountSide(*this->Upright, observers, options, counts, parallelFor, kernels);
  std::vector<std::uint32_t> turned(static_cast<std::size_t>(this->Width * this->Height), 0u);
  this->CountSide(*this->Transposed, observers, options, turned.data(), parallelFor, kernels);
  parallelFor((this->Height + kTurnedRows - 1) / kTurnedRows,
    [&](std::int64_t begin, std::int64_t end)
    {
      const std::int64_t last = std::min(end * kTurnedRows, this->Height);
      for (std::int64_t i = 0; i < this->Width; ++i)
      {
        for (std::int64_t j = begin * kTurnedRows; j < last; ++j)
        {
          counts[i + this->Width * j] += turned[static_cast<std::size_t>(j + this->Height * i)];
        }
      }
    });
  for (const Observer& observer : observers)
  {
    // The sample at one's feet is in neither of the two.
    const glm::i64vec2 sample(observer.Position);
    const bool isSample = glm::dvec2(sample) == observer.Position;
    const float ground = isSample ? *this->Upright->Grid.Grid.At(sample.x, sample.y)
                                  : std::numeric_limits<float>::quiet_NaN();
    const glm::dvec3 target(0.0, 0.0, observer.Ground + options.TargetHeight - observer.Eye);
    counts[sample.x + this->Width * sample.y] +=
      !std::isnan(ground) && observer.Eye >= observer.Ground && options.IsWithin(target) ? 1 : 0;
  }
}
} // namespace terrain
