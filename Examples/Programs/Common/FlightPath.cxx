// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlightPath.h"

#include "vtkCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double kTurn = 6.283185307179586;

Place3 Mix(const Place3& a, const Place3& b, double share)
{
  Place3 mixed{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    mixed[k] = a[k] + share * (b[k] - a[k]);
  }
  return mixed;
}

/// From rest to rest, 0 to 1.
double Ease(double share)
{
  return share * share * (3.0 - 2.0 * share);
}

double Flat(const Place3& a, const Place3& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// Slope of a coordinate at a key, in units a second; 0 at both ends.
double SlopeAt(
  const std::vector<FlightKey>& keys, std::size_t k, Place3 FlightView::*place, std::size_t axis)
{
  if (k == 0 || k + 1 == keys.size())
  {
    return 0.0;
  }
  return ((keys[k + 1].View.*place)[axis] - (keys[k - 1].View.*place)[axis]) /
    (keys[k + 1].Time - keys[k - 1].Time);
}

/// A place between key k and the next one, at a share of their interval.
Place3 Between(
  const std::vector<FlightKey>& keys, std::size_t k, double share, Place3 FlightView::*place)
{
  const double span = keys[k + 1].Time - keys[k].Time;
  const double s2 = share * share;
  const double s3 = s2 * share;
  Place3 at{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] = (2.0 * s3 - 3.0 * s2 + 1.0) * (keys[k].View.*place)[axis] +
      (s3 - 2.0 * s2 + share) * span * SlopeAt(keys, k, place, axis) +
      (3.0 * s2 - 2.0 * s3) * (keys[k + 1].View.*place)[axis] +
      (s3 - s2) * span * SlopeAt(keys, k + 1, place, axis);
  }
  return at;
}

/// A track by the distance along it, on the plane.
class Track
{
public:
  explicit Track(const FlightTrack& track)
    : Times(track.Times)
  {
    for (const Place3& point : track.Points)
    {
      const double step = this->Points.empty() ? 0.0 : Flat(this->Points.back(), point);
      if (this->Points.empty() || step > 0.0)
      {
        this->Distances.push_back(this->Points.empty() ? 0.0 : this->Distances.back() + step);
        this->Points.push_back(point);
      }
      this->WayOfPoints.push_back(this->Distances.back());
    }
  }
  /// Distance at a part of the duration, 0 to 1; without times from rest to rest.
  double WayAt(double share) const
  {
    if (this->Times.empty())
    {
      return this->Length() * Ease(share);
    }
    constexpr int kSteps = 16;
    const double reach = std::min({ kSmoothedTime, share, 1.0 - share }); // exact at both ends
    double sum = 0.0;
    for (int step = -kSteps; step <= kSteps; ++step)
    {
      sum += this->WayAtTime(this->Times.front() +
        (share + reach * step / kSteps) * (this->Times.back() - this->Times.front()));
    }
    return sum / (2 * kSteps + 1);
  }
  double Length() const
  {
    return this->Distances.back();
  }
  /// The point at a distance; beyond the ends straight on.
  Place3 At(double distance) const
  {
    const auto next =
      std::upper_bound(this->Distances.begin() + 1, this->Distances.end() - 1, distance);
    const auto k = static_cast<std::size_t>(next - this->Distances.begin());
    return Mix(this->Points[k - 1], this->Points[k],
      (distance - this->Distances[k - 1]) / (this->Distances[k] - this->Distances[k - 1]));
  }
  /// Mean of the points within a distance, weighted by a parabola.
  Place3 SmoothAt(double distance, double within) const
  {
    constexpr int kSteps = 16;
    Place3 sum{};
    double weights = 0.0;
    for (int step = -kSteps; step <= kSteps; ++step)
    {
      const double share = step / (kSteps + 1.0);
      const double weight = 1.0 - share * share;
      const Place3 point = this->At(std::clamp(distance + share * within, 0.0, this->Length()));
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum[k] += weight * point[k];
      }
      weights += weight;
    }
    for (double& coordinate : sum)
    {
      coordinate /= weights;
    }
    return sum;
  }

private:
  double WayAtTime(double time) const
  {
    const auto next = std::upper_bound(this->Times.begin() + 1, this->Times.end() - 1, time);
    const auto k = static_cast<std::size_t>(next - this->Times.begin());
    const double span = this->Times[k] - this->Times[k - 1];
    const double within = span > 0.0 ? (time - this->Times[k - 1]) / span : 1.0;
    return this->WayOfPoints[k - 1] +
      std::clamp(within, 0.0, 1.0) * (this->WayOfPoints[k] - this->WayOfPoints[k - 1]);
  }

  std::vector<Place3> Points;
  std::vector<double> Distances;
  /// Of all points of the track that was given, those too that are where the one before is.
  std::vector<double> WayOfPoints;
  std::vector<double> Times;
};
}

//------------------------------------------------------------------------------
void LookAlong(vtkCamera* camera, const FlightView& view)
{
  camera->SetPosition(view.Eye.data());
  camera->SetFocalPoint(view.Focus.data());
  constexpr double kSteepView = 1e-3;
  const bool isSteep =
    Flat(view.Eye, view.Focus) < kSteepView * std::abs(view.Eye[2] - view.Focus[2]);
  camera->SetViewUp(0.0, isSteep ? 1.0 : 0.0, isSteep ? 0.0 : 1.0);
}

//------------------------------------------------------------------------------
std::size_t CountFrames(double seconds, double rate)
{
  return static_cast<std::size_t>(std::max(2.0, std::round(seconds * rate)));
}

//------------------------------------------------------------------------------
std::vector<FlightView> FlyRound(const FlightView& view, std::size_t frames, bool isEased)
{
  std::vector<FlightView> views(frames, view);
  const double x = view.Eye[0] - view.Focus[0];
  const double y = view.Eye[1] - view.Focus[1];
  for (std::size_t k = 0; k < frames; ++k)
  {
    const auto at = static_cast<double>(k);
    const auto count = static_cast<double>(frames);
    const double angle = kTurn * (isEased ? Ease(at / (count - 1.0)) : at / count);
    views[k].Eye[0] = view.Focus[0] + x * std::cos(angle) - y * std::sin(angle);
    views[k].Eye[1] = view.Focus[1] + x * std::sin(angle) + y * std::cos(angle);
  }
  return views;
}

//------------------------------------------------------------------------------
std::vector<FlightView> FlyThrough(const std::vector<FlightKey>& keys, std::size_t frames)
{
  std::vector<FlightView> views(frames);
  std::size_t key = 0;
  for (std::size_t k = 0; k < frames; ++k)
  {
    const double share = static_cast<double>(k) / static_cast<double>(frames - 1);
    const double time = keys.front().Time + share * (keys.back().Time - keys.front().Time);
    while (key + 2 < keys.size() && time > keys[key + 1].Time)
    {
      ++key;
    }
    const double within = (time - keys[key].Time) / (keys[key + 1].Time - keys[key].Time);
    views[k].Eye = Between(keys, key, within, &FlightView::Eye);
    views[k].Focus = Between(keys, key, within, &FlightView::Focus);
  }
  return views;
}

//------------------------------------------------------------------------------
std::vector<FlightView> FlyAlong(
  const FlightTrack& flown, double behind, double above, std::size_t frames)
{
  const Track track(flown);
  std::vector<FlightView> views(frames);
  for (std::size_t k = 0; k < frames; ++k)
  {
    const double at = track.WayAt(static_cast<double>(k) / static_cast<double>(frames - 1));
    const Place3 here = track.SmoothAt(at, behind);
    // where the track is heading, over as much of it as the eye is behind
    const Place3 last = track.SmoothAt(std::max(at - behind, -0.0), behind);
    const Place3 next = track.SmoothAt(std::min(at + behind, track.Length()), behind);
    const double length = std::max(Flat(last, next), 1e-9 * behind);
    const double east = (next[0] - last[0]) / length;
    const double north = (next[1] - last[1]) / length;
    constexpr double kAhead = 0.3;
    views[k].Eye = { here[0] - behind * east, here[1] - behind * north, here[2] + above };
    views[k].Focus = { here[0] + kAhead * behind * east, here[1] + kAhead * behind * north,
      here[2] };
  }
  return views;
}

//------------------------------------------------------------------------------
double StayAbove(std::vector<FlightView>& views,
  const std::function<double(double x, double y)>& ground, double clearance, std::size_t smooth)
{
  const std::size_t count = views.size();
  std::vector<double> lifts(count, 0.0);
  std::vector<double> grounds(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    grounds[k] = ground(views[k].Eye[0], views[k].Eye[1]);
    const double lift = grounds[k] + clearance - views[k].Eye[2];
    lifts[k] = lift > 0.0 ? lift : 0.0; // NaN: no ground there
  }
  // the mean of maxima over windows that reach as far as the mean does is nowhere too low
  std::vector<double> highest(count, 0.0);
  const auto window = [count, smooth](std::size_t k, const auto& visit)
  {
    const std::size_t end = std::min(k + smooth, count - 1);
    for (std::size_t other = k > smooth ? k - smooth : 0; other <= end; ++other)
    {
      visit(other);
    }
  };
  for (std::size_t k = 0; k < count; ++k)
  {
    window(k, [&](std::size_t other) { highest[k] = std::max(highest[k], lifts[other]); });
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count; ++k)
  {
    double sum = 0.0;
    double terms = 0.0;
    window(k,
      [&](std::size_t other)
      {
        sum += highest[other];
        terms += 1.0;
      });
    views[k].Eye[2] += sum / terms;
    least = std::isnan(grounds[k]) ? least : std::min(least, views[k].Eye[2] - grounds[k]);
  }
  return least;
}
