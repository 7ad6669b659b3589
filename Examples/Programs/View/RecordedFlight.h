// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A flight that is recorded view by view, and played.
 */
#ifndef terrain_view_RecordedFlight_h
#define terrain_view_RecordedFlight_h

#include "FlightPath.h"

#include <chrono>
#include <cstddef>
#include <vector>

/// Seconds from one view that is recorded to the next.
constexpr double kSecondsBetweenViews = 4.0;
/// Views a second of the way that is played.
constexpr double kFlightRate = 30.0;

class RecordedFlight
{
public:
  /// Adds a view behind the others.
  void Add(const FlightView& view);
  /// Takes the last view away; false if there is none.
  bool DropLast();
  const std::vector<FlightKey>& GetKeys() const
  {
    return this->Keys;
  }

  /// The way through all views, which must be two or more: as terrain-render flies it.
  std::vector<FlightView> Plan() const;

  /// Plays such a way from now on.
  void Play(std::vector<FlightView> way);
  bool IsPlaying() const
  {
    return !this->Way.empty();
  }
  void Stop()
  {
    this->Way.clear();
  }
  /// The view of this moment of what is played; the last one stops it.
  FlightView GetNow();

private:
  using Clock = std::chrono::steady_clock;

  std::vector<FlightKey> Keys;
  std::vector<FlightView> Way;
  Clock::time_point Begin;
};

#endif
