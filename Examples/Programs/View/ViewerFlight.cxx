// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Flights: views that keys record, a file of them, and the flight played.
#include "Viewer.h"

#include "vtkCamera.h"
#include "vtkTerrainViewpoint.h"

#include <sstream>
#include <utility>

namespace
{
constexpr const char* kFlightFile = "terrain-view-flight";
/// Milliseconds between two pictures of a flight, at least.
constexpr unsigned long kFlightInterval = 33;
/// Least height of a played flight above the ground, as a part of the terrain's diagonal: that of
/// terrain-render.
constexpr double kClearance = 0.004;

std::string TimeText(double seconds)
{
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}
}

//------------------------------------------------------------------------------
FlightView Viewer::GetView() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  FlightView view;
  camera->GetPosition(view.Eye.data());
  camera->GetFocalPoint(view.Focus.data());
  return view;
}

//------------------------------------------------------------------------------
void Viewer::SetView(const FlightView& view)
{
  LookAlong(this->Renderer->GetActiveCamera(), view);
}

//------------------------------------------------------------------------------
void Viewer::AddToFlight()
{
  this->Flight.Add(this->GetView());
  this->Note = "  view " + std::to_string(this->Flight.GetKeys().size()) + " of the flight, at " +
    TimeText(this->Flight.GetKeys().back().Time) + " (f plays, F saves)";
}

//------------------------------------------------------------------------------
void Viewer::DropFromFlight()
{
  this->Note = this->Flight.DropLast()
    ? "  the flight has " + std::to_string(this->Flight.GetKeys().size()) + " views"
    : "  the flight has no view (k adds one)";
}

//------------------------------------------------------------------------------
bool Viewer::HasFlight()
{
  const bool isThere = this->Flight.GetKeys().size() >= 2;
  if (!isThere)
  {
    this->Note = "  a flight needs two views or more: k adds one";
  }
  return isThere;
}

//------------------------------------------------------------------------------
void Viewer::SwitchFlight()
{
  if (this->Flight.IsPlaying())
  {
    this->Flight.Stop();
    return;
  }
  if (!this->HasFlight())
  {
    return;
  }
  std::vector<FlightView> way = this->Flight.Plan();
  const vtkNew<vtkTerrainViewpoint> ground;
  ground->SetHeights(this->Terrain->GetHeights());
  ground->SetExaggeration(this->Terrain->GetVerticalExaggeration());
  StayAbove(
    way, [&ground](double x, double y) { return ground->GetGround(x, y); },
    kClearance * this->Terrain->GetLength(), static_cast<std::size_t>(kFlightRate));
  this->Flight.Play(std::move(way));
  this->FlightTimer = this->Interactor->CreateOneShotTimer(kFlightInterval);
}

//------------------------------------------------------------------------------
void Viewer::FlyOn()
{
  if (this->Flight.IsPlaying())
  {
    this->SetView(this->Flight.GetNow());
    this->Refresh();
    // a timer for each picture: VTK 9.1 loops for ever where one is destroyed in its own event
    this->FlightTimer = this->Interactor->CreateOneShotTimer(kFlightInterval);
  }
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeFlight() const
{
  // places where all of them are known, else points of the scene
  for (const bool arePlaces : { true, false })
  {
    std::ostringstream text;
    text.precision(12);
    text << (arePlaces ? "seconds,lon,lat,height,look_lon,look_lat,look_height\n"
                       : "seconds,x,y,z,look_x,look_y,look_z\n");
    bool isKnown = true;
    for (const FlightKey& key : this->Flight.GetKeys())
    {
      text << key.Time;
      for (const Place3& point : { key.View.Eye, key.View.Focus })
      {
        const std::string place = this->DescribePoint(point, arePlaces);
        isKnown = isKnown && !place.empty();
        text << ',' << place;
      }
      text << '\n';
    }
    if (isKnown)
    {
      return text.str();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void Viewer::SaveFlight()
{
  if (this->HasFlight())
  {
    this->SaveText(this->FreeName(kFlightFile, ".csv"), this->DescribeFlight(), "flight");
  }
}
