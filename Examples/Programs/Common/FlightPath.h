// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the camera of a flight stands in each frame.
 */
#ifndef terrain_render_FlightPath_h
#define terrain_render_FlightPath_h

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

class vtkCamera;

using Place3 = std::array<double, 3>;

/// Eye and focal point, in the scene.
struct FlightView
{
  Place3 Eye{};
  Place3 Focus{};
};

/// Places a camera, upright; with north on top where it looks straight down.
void LookAlong(vtkCamera* camera, const FlightView& view);

/// A view at a time, in seconds.
struct FlightKey
{
  double Time = 0.0;
  FlightView View;
};

/// Points on the ground, and when they were passed, in seconds that do not fall; no times for even
/// speed.
struct FlightTrack
{
  std::vector<Place3> Points;
  std::vector<double> Times;
};

/// Number of frames, at least 2, of so many seconds.
std::size_t CountFrames(double seconds, double rate);

/// Once round the vertical through the focus of a view: at steady speed, the last frame one step
/// before the first; or eased, from rest to rest, the last frame as the first.
std::vector<FlightView> FlyRound(const FlightView& view, std::size_t frames, bool isEased);

/// From key to key, two or more whose times rise, through all of them (a cubic of Hermite in each
/// interval, with the slope between the neighbours), from rest to rest.
std::vector<FlightView> FlyThrough(const std::vector<FlightKey>& keys, std::size_t frames);

/// Behind and above a track on the ground, so far behind and so far above the ground; the focus is
/// a little ahead on the track. The track is smoothed over the distance behind. From rest to rest;
/// with times as fast as the track was, the first frame at its first time and the last one at its
/// last, jumps of the speed smoothed over kSmoothedTime. Two or more points that are not all the
/// same.
std::vector<FlightView> FlyAlong(
  const FlightTrack& track, double behind, double above, std::size_t frames);

/// Part of the duration of a track before and after a time over which its way is averaged.
constexpr double kSmoothedTime = 0.02;

/// Raises eyes that are less than a clearance above the ground, and their neighbours before and
/// after, over so many frames, so that the way stays smooth. `ground` returns z at x, y, or NaN.
/// Returns the least height of an eye above the ground; infinity where there is none.
double StayAbove(std::vector<FlightView>& views,
  const std::function<double(double x, double y)>& ground, double clearance, std::size_t smooth);

#endif
