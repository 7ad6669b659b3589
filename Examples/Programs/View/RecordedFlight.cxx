// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RecordedFlight.h"

#include <utility>

//------------------------------------------------------------------------------
void RecordedFlight::Add(const FlightView& view)
{
  this->Keys.push_back({ kSecondsBetweenViews * static_cast<double>(this->Keys.size()), view });
}

//------------------------------------------------------------------------------
bool RecordedFlight::DropLast()
{
  const bool isThere = !this->Keys.empty();
  if (isThere)
  {
    this->Keys.pop_back();
  }
  return isThere;
}

//------------------------------------------------------------------------------
std::vector<FlightView> RecordedFlight::Plan() const
{
  return FlyThrough(this->Keys, CountFrames(this->Keys.back().Time, kFlightRate));
}

//------------------------------------------------------------------------------
void RecordedFlight::Play(std::vector<FlightView> way)
{
  this->Way = std::move(way);
  this->Begin = Clock::now();
}

//------------------------------------------------------------------------------
FlightView RecordedFlight::GetNow()
{
  const double seconds = std::chrono::duration<double>(Clock::now() - this->Begin).count();
  const auto frame = static_cast<std::size_t>(seconds * kFlightRate);
  if (frame + 1 < this->Way.size())
  {
    return this->Way[frame];
  }
  const FlightView last = this->Way.back();
  this->Stop();
  return last;
}
