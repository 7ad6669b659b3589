// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/Viewshed.h"

#include "core/rays/PreparedGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace terrain
{
namespace
{
/// Samples along a side of the blocks that are turned over, so that both sides are read in lines of
/// memory.
constexpr std::int64_t kTurned = 64;

/// Where there are no data, if that blocks: above all ground, below what overflows squared, and the
/// same as a float.
constexpr double kWallHeight = 0x1p50;
/// Only a part of a wall hides by as much.
constexpr double kNoRise = 1e9;

/// Calls take(i + size.x * j, value) for values[j + size.y * i], which may be empty, in parallel.
template <typename Value, typename Take>
void ForEachTurned(const glm::i64vec2& size, const std::vector<Value>& values,
  const ParallelFor& parallelFor, const Take& take)
{
  parallelFor(values.empty() ? 0 : (size.y + kTurned - 1) / kTurned,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t first = begin * kTurned; first < std::min(end * kTurned, size.y);
           first += kTurned)
      {
        for (std::int64_t i = 0; i < size.x; i += kTurned)
        {
          for (std::int64_t j = first; j < std::min(first + kTurned, size.y); ++j)
          {
            const Value* from = values.data() + j + size.y * i;
            for (std::int64_t k = 0; k < std::min(kTurned, size.x - i); ++k)
            {
              take(i + k + size.x * j, from[size.y * k]);
            }
          }
        }
      }
    });
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

double ViewshedOptions::RiseToBeSeen(const glm::dvec3& target, double hidden) const
{
  const double distance = glm::length(glm::dvec2(target));
  double turn = std::fmod(std::atan2(target.x, target.y) / kDegree - this->FirstAzimuth, 360.0);
  turn += turn < 0.0 ? 360.0 : 0.0;
  const bool isAhead = turn <= this->LastAzimuth - this->FirstAzimuth || distance == 0.0;
  if (!isAhead || distance < this->NearestDistance || distance > this->FarthestDistance)
  {
    return kInfinity;
  }
  const double fall = this->Drop * distance * distance;
  const double lowest = this->LowestElevation <= -90.0
    ? -kInfinity
    : fall + distance * std::tan(this->LowestElevation * kDegree);
  const double height = std::max(target.z + hidden, lowest);
  return std::atan2(height - fall, distance) > this->HighestElevation * kDegree ? kInfinity
                                                                                : height - target.z;
}

ViewshedGrid::ViewshedGrid(const glm::i64vec2& size, const glm::dvec2& range, const RowReader& read,
  const ParallelFor& parallelFor, bool holesBlock)
  : Width(size.x)
  , Height(size.y)
{
  const bool isEmpty = range.x > range.y;
  this->Relief = isEmpty ? 0.0 : range.y - range.x;
  this->Middle = isEmpty ? 0.0 : 0.5 * (range.x + range.y);
  const RowReader readSide = [&](std::int64_t row, double* heights)
  {
    read(row, heights);
    for (std::int64_t i = 0; i < this->Width; ++i)
    {
      const double h = heights[i] - this->Middle;
      heights[i] = holesBlock && std::isnan(h) ? kWallHeight : h;
    }
  };
  PaddedGrid<float> grid(this->Width, this->Height, readSide, parallelFor);
  PaddedGrid<float> turned = grid.Transposed(parallelFor);
  // NOLINTBEGIN(modernize-make-unique): it is an aggregate that cannot be moved
  this->Upright.reset(new Side{ PreparedGrid<float>(std::move(grid), parallelFor), false });
  this->Transposed.reset(new Side{ PreparedGrid<float>(std::move(turned), parallelFor), true });
  // NOLINTEND(modernize-make-unique)
}

/// One call: what is asked, and where the answers go: for samples by rows, and turned, by columns.
struct ViewshedGrid::Looking
{
  const ViewshedOptions& Options;
  const ParallelFor& InParallel;
  const LaneKernels& Kernels;
  std::uint32_t* Counts;
  std::uint8_t* TurnedCounts;
  float* Rises; ///< null if they are not asked for
  float* TurnedRises;
};

/// Takes what an observer sees on one side.
class ViewshedGrid::Taker
{
public:
  Taker(
    const Looking& looking, const Side& side, const ViewshedGrid& grid, const Observer& observer)
    : Asked(looking)
    , On(side)
    , Middle(grid.Middle)
    , From(observer)
  {
    const glm::dvec2 spacing = this->Turn(looking.Options.Spacing);
    const glm::dvec2 position = this->Turn(observer.Position);
    this->Eye.X = position.x;
    this->Eye.Y = position.y;
    this->Eye.Z = static_cast<float>(observer.Eye - grid.Middle);
    this->Eye.Ground = static_cast<float>(observer.Ground - grid.Middle);
    this->Eye.TargetHeight = static_cast<float>(looking.Options.TargetHeight);
    this->Eye.FallEast = static_cast<float>(looking.Options.Drop * spacing.x * spacing.x);
    this->Eye.FallNorth = static_cast<float>(looking.Options.Drop * spacing.y * spacing.y);
    this->Eye.Tolerance =
      static_cast<float>(kSightTolerance * (grid.Relief + std::min(spacing.x, spacing.y)));
    this->Eye.Strict = side.IsTransposed;
  }

  void LookAlong(const LaneFan& fan) const
  {
    const bool measures = this->Asked.Rises != nullptr;
    const HiddenSink sink{ [](void* context, std::int64_t row, std::int64_t first,
                             std::int64_t count, const float* hidden)
      { static_cast<const Taker*>(context)->Take(row, first, count, hidden); },
      const_cast<Taker*>(this) };
    this->Asked.Kernels.Viewshed(this->On.Grid.View, this->Eye, fan, measures, sink);
  }

  /// The target above a sample, of which it is known by how much it is hidden.
  void TakeOne(std::int64_t row, std::int64_t column, double hidden) const
  {
    const float ground = *this->On.Grid.Grid.At(column, row);
    if (!(ground < kWallHeight))
    {
      return;
    }
    const glm::dvec2 place = this->Turn(this->Asked.Options.Spacing) *
      glm::dvec2(static_cast<double>(column) - this->Eye.X, static_cast<double>(row) - this->Eye.Y);
    const double up = static_cast<double>(ground) + this->Middle +
      this->Asked.Options.TargetHeight - this->From.Eye;
    const bool buried = hidden >= kNoRise || this->From.Eye < this->From.Ground;
    this->Put(row, column,
      this->Asked.Options.RiseToBeSeen({ this->Turn(place), up }, buried ? kInfinity : hidden));
  }

private:
  glm::dvec2 Turn(const glm::dvec2& v) const
  {
    return this->On.IsTransposed ? glm::dvec2(v.y, v.x) : v;
  }

  void Put(std::int64_t row, std::int64_t column, double rise) const
  {
    const std::int64_t at = column + this->On.Grid.View.Width * row;
    const bool seen = rise <= 0.0;
    if (this->On.IsTransposed)
    {
      this->Asked.TurnedCounts[at] = static_cast<std::uint8_t>(this->Asked.TurnedCounts[at] + seen);
    }
    else
    {
      this->Asked.Counts[at] += seen ? 1 : 0;
    }
    if (this->Asked.Rises)
    {
      float& lowest = (this->On.IsTransposed ? this->Asked.TurnedRises : this->Asked.Rises)[at];
      lowest = std::min(lowest, static_cast<float>(std::max(rise, 0.0)));
    }
  }

  template <typename Number>
  void Add(std::int64_t row, std::int64_t first, std::int64_t count, const float* hidden,
    Number* counts) const
  {
    const float* grounds = this->On.Grid.Grid.At(first, row);
    for (std::int64_t k = 0; k < count; ++k)
    {
      const bool seen = hidden[k] == 0.0f && grounds[k] < kWallHeight;
      counts[k] = static_cast<Number>(counts[k] + (seen ? 1 : 0));
    }
  }

  void Take(std::int64_t row, std::int64_t first, std::int64_t count, const float* hidden) const
  {
    if (!this->Asked.Rises && !this->Asked.Options.HasLimits())
    {
      const std::int64_t at = first + this->On.Grid.View.Width * row;
      if (this->On.IsTransposed)
      {
        this->Add(row, first, count, hidden, this->Asked.TurnedCounts + at);
      }
      else
      {
        this->Add(row, first, count, hidden, this->Asked.Counts + at);
      }
      return;
    }
    for (std::int64_t k = 0; k < count; ++k)
    {
      this->TakeOne(row, first + k, static_cast<double>(hidden[k]));
    }
  }

  const Looking& Asked;
  const Side& On;
  double Middle;
  const Observer& From;
  LaneObserver Eye;
};

void ViewshedGrid::LookAround(const Looking& looking, const Observer& observer) const
{
  const std::array<Taker, 2> takers{ Taker(looking, *this->Upright, *this, observer),
    Taker(looking, *this->Transposed, *this, observer) };
  const glm::dvec2 size(
    static_cast<double>(this->Width - 1), static_cast<double>(this->Height - 1));
  std::vector<std::pair<const Taker*, LaneFan>> fans;
  for (int side = 0; side < 2; ++side)
  {
    const int axis = 1 - side; // away from the observer
    const double within =
      std::ceil(std::min(looking.Options.FarthestDistance / looking.Options.Spacing[axis], 1e9)) +
      1.0;
    for (const int step : { 1, -1 })
    {
      const double place = observer.Position[axis];
      const double ahead = std::ceil(step > 0 ? size[axis] - place : place);
      const int rows = static_cast<int>(std::min(ahead, within));
      const int count = 2 * rows / LaneFan::Columns + 1;
      const auto slope = [count](int edge) { return -1.0 + 2.0 * edge / count; };
      for (int fan = 0; fan < count && rows > 0; ++fan)
      {
        fans.push_back(
          { &takers[static_cast<std::size_t>(side)], { step, slope(fan), slope(fan + 1), rows } });
      }
    }
  }
  looking.InParallel(static_cast<std::int64_t>(fans.size()),
    [&fans](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = begin; k < end; ++k)
      {
        const auto& [taker, fan] = fans[static_cast<std::size_t>(k)];
        taker->LookAlong(fan);
      }
    });
  // The sample at one's feet is in none of the fans.
  const glm::i64vec2 sample(observer.Position);
  if (glm::dvec2(sample) == observer.Position)
  {
    takers[0].TakeOne(sample.y, sample.x, 0.0);
  }
}

void ViewshedGrid::Count(const std::vector<Observer>& observers, const ViewshedOptions& options,
  std::uint32_t* counts, const ParallelFor& parallelFor, const LaneKernels& kernels) const
{
  this->Measure(observers, options, counts, nullptr, parallelFor, kernels);
}

void ViewshedGrid::Measure(const std::vector<Observer>& observers, const ViewshedOptions& options,
  std::uint32_t* counts, float* rises, const ParallelFor& parallelFor,
  const LaneKernels& kernels) const
{
  if (this->Width < 1 || this->Height < 1)
  {
    return;
  }
  const auto size = static_cast<std::size_t>(this->Width * this->Height);
  std::vector<std::uint8_t> turnedCounts;
  std::vector<float> turnedRises(rises ? size : 0, std::numeric_limits<float>::infinity());
  const glm::i64vec2 grid(this->Width, this->Height);
  const auto add = [counts](std::int64_t to, std::uint8_t count) { counts[to] += count; };
  for (std::size_t k = 0; k < observers.size(); ++k)
  {
    if (k % std::numeric_limits<std::uint8_t>::max() == 0)
    {
      ForEachTurned(grid, turnedCounts, parallelFor, add);
      turnedCounts.assign(size, 0);
    }
    this->LookAround(
      { options, parallelFor, kernels, counts, turnedCounts.data(), rises, turnedRises.data() },
      observers[k]);
  }
  ForEachTurned(grid, turnedCounts, parallelFor, add);
  ForEachTurned(grid, turnedRises, parallelFor,
    [rises](std::int64_t to, float rise) { rises[to] = std::min(rises[to], rise); });
}
} // namespace terrain
