// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Flight.h"

#include "Canvas.h"
#include "Day.h"
#include "DefaultView.h"
#include "Failure.h"
#include "FlightFile.h"
#include "FlightFrames.h"
#include "FlightPath.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "Placing.h"
#include "Progress.h"
#include "Scenery.h"
#include "Statistics.h"
#include "Terrain.h"
#include "View.h"
#include "ViewMarks.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTerrainViewpoint.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{
constexpr double kOrbitSeconds = 12.0;
constexpr double kTrackSeconds = 20.0;
/// Angle of an orbit above the ground, in degrees.
constexpr double kOrbitTilt = 32.0;
constexpr std::size_t kMostFrames = 99999;
const char* const kSceneFile = "scene.toml";
const char* const kViewsFile = "flight.csv";

/// Height of eyes above the ground: above what the near plane cuts away, and some cells.
double ClearanceOf(const FlightStage& stage)
{
  constexpr double kOfDiagonal = 0.004;
  constexpr double kCells = 3.0;
  return std::max(kOfDiagonal * stage.Ground.Bounds.GetDiagonalLength(),
    kCells * stage.Heights.Image->GetSpacing()[0]);
}

/// All of the terrain in view from all sides.
FlightView ViewOfAll(const FlightStage& stage, const Options& options)
{
  FlightView view;
  const vtkBoundingBox& box = stage.Ground.Bounds;
  box.GetCenter(view.Focus.data());
  constexpr double kFilled = 0.94;
  const double slopeUp = kFilled * std::tan(0.5 * vtkMath::RadiansFromDegrees(options.ViewAngle));
  const double slopeAside = slopeUp * options.Size[0] / options.Size[1];
  const double tilt = vtkMath::RadiansFromDegrees(kOrbitTilt);
  double distance = 0.0;
  constexpr int kSides = 72;
  for (int side = 0; side < kSides; ++side)
  {
    const double angle = 2.0 * vtkMath::Pi() * side / kSides;
    for (int corner = 0; corner < 8; ++corner)
    {
      Place3 point{};
      box.GetCorner(corner, point.data());
      vtkMath::Subtract(point.data(), view.Focus.data(), point.data());
      const double away = std::cos(angle) * point[0] + std::sin(angle) * point[1];
      const double aside = std::cos(angle) * point[1] - std::sin(angle) * point[0];
      const double depth = away * std::cos(tilt) + point[2] * std::sin(tilt);
      const double up = point[2] * std::cos(tilt) - away * std::sin(tilt);
      distance = std::max(
        { distance, depth + std::abs(aside) / slopeAside, depth + std::abs(up) / slopeUp });
    }
  }
  view.Eye = { view.Focus[0], view.Focus[1] - distance * std::cos(tilt),
    view.Focus[2] + distance * std::sin(tilt) };
  return view;
}

FlightView FirstView(const FlightStage& stage, const Options& options)
{
  FlightView view;
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->GetPosition(view.Eye.data());
  camera->GetFocalPoint(view.Focus.data());
  const bool isChosen = options.View || !options.Place.LookFrom.empty();
  return isChosen || stage.Heights.IsGlobe() ? view : ViewOfAll(stage, options);
}

std::size_t FramesOf(double usualSeconds, const FlightOptions& flight)
{
  const std::size_t frames =
    CountFrames(flight.Seconds > 0.0 ? flight.Seconds : usualSeconds, flight.Rate);
  if (frames > kMostFrames)
  {
    throw Failure("--flight",
      "there are " + std::to_string(frames) + " frames, at most " + std::to_string(kMostFrames) +
        ": take fewer a second (--fps) or less time "
        "(--flight-seconds)");
  }
  return frames;
}

/// Behind and above a track: a part of the extent of the track.
std::vector<FlightView> FollowTrack(const FlightStage& stage, const FlightOptions& flight)
{
  const FlightTrack track = ReadFlightTrack(flight.Flight, stage.Heights, !flight.HasEvenSpeed);
  vtkBoundingBox box;
  for (Place3 point : track.Points)
  {
    box.AddPoint(point.data());
  }
  constexpr double kBehind = 0.2;
  constexpr double kAbove = 0.6;
  const double behind = kBehind * std::hypot(box.GetLength(0), box.GetLength(1));
  return FlyAlong(track, behind, kAbove * behind, FramesOf(kTrackSeconds, flight));
}

std::vector<FlightView> PlanFlight(const FlightStage& stage, const Options& options)
{
  const FlightOptions& flight = options.Flight;
  if (!flight.IsFile())
  {
    const double spin = flight.SpinSeconds();
    return FlyRound(
      FirstView(stage, options), FramesOf(spin > 0.0 ? spin : kOrbitSeconds, flight), spin == 0.0);
  }
  if (IsFlightTable(flight.Flight))
  {
    const std::vector<FlightKey> keys = ReadFlightTable(flight.Flight, stage.Heights);
    return FlyThrough(keys, FramesOf(keys.back().Time - keys.front().Time, flight));
  }
  return FollowTrack(stage, flight);
}

/// Whatever the frames depend on: the options, and the files as they are.
std::string DescribeFlight(const Options& options)
{
  std::ostringstream text;
  text << options.Flight.Scene;
  for (const std::string& file : { options.Heights, options.Flight.Flight })
  {
    std::error_code error;
    if (fs::is_regular_file(file, error))
    {
      text << "# " << fs::path(file).filename().string() << ": " << fs::file_size(file, error)
           << " bytes, " << fs::last_write_time(file, error).time_since_epoch().count() << '\n';
    }
  }
  return text.str();
}

/// Makes the folder, or goes on with it. Throws a Failure if it has anything else in it.
void OpenFolder(const std::string& folder, const std::string& description)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
  {
    throw Failure(folder, "no folder can be made: " + error.message());
  }
  const fs::path scene = fs::path(folder) / kSceneFile;
  if (fs::exists(scene, error))
  {
    std::ifstream file(scene);
    std::ostringstream text;
    text << file.rdbuf();
    if (text.str() != description)
    {
      throw Failure(folder, "it holds frames of another flight: remove it, or name another output");
    }
    return;
  }
  if (!fs::is_empty(folder, error))
  {
    throw Failure(folder, "it is not empty, and holds no flight: name another output");
  }
  const PendingFile file(scene.string());
  WriteText(description, file);
  file.Commit();
}

/// The views as a flight of their own.
void WriteViews(const std::string& folder, const std::vector<FlightView>& views, double rate)
{
  std::ostringstream text;
  text.precision(12);
  text << "seconds,x,y,z,look_x,look_y,look_z\n";
  for (std::size_t k = 0; k < views.size(); ++k)
  {
    text << static_cast<double>(k) / rate;
    for (const Place3& place : { views[k].Eye, views[k].Focus })
    {
      text << ',' << place[0] << ',' << place[1] << ',' << place[2];
    }
    text << '\n';
  }
  const PendingFile file((fs::path(folder) / kViewsFile).string());
  WriteText(text.str(), file);
  file.Commit();
}

void SetView(const FlightStage& stage, const FlightView& view, const Options& options)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  LookAlong(camera, view);
  SetClippingRange(camera, stage.Ground.Bounds, stage.Heights);
  SetBackground(stage.Renderer, options);
}

/// Time that is left, as people say it.
std::string TimeLeft(double seconds)
{
  const auto whole = static_cast<long>(std::ceil(seconds));
  std::ostringstream text;
  text << "drawing, " << whole / 60 << ':' << (whole % 60 < 10 ? "0" : "") << whole % 60 << " left";
  return text.str();
}

/// Draws the frames that are missing; returns their number.
std::size_t DrawMissing(const FlightStage& stage, const std::vector<FlightView>& views,
  FlightFrames& frames, const Options& options, Statistics& statistics)
{
  ProgressBar progress;
  FrameQueue queue(frames);
  const Stopwatch watch;
  std::size_t drawn = 0;
  for (std::size_t k = 0; k < views.size(); ++k)
  {
    if (frames.Has(k))
    {
      continue;
    }
    const Stopwatch frame;
    SetView(stage, views[k], options);
    stage.Marks.Refresh();
    RefineTerrain(stage.Ground, stage.Renderer, options, statistics);
    const vtkSmartPointer<vtkImageData> picture = stage.Frame.Draw();
    ThrowOnError("frame " + std::to_string(k + 1));
    queue.Add(k, picture);
    statistics.AddTime("flight_frame", frame.GetMilliseconds());
    ++drawn;
    const double each = watch.GetMilliseconds() / 1e3 / static_cast<double>(drawn);
    progress.Show(static_cast<double>(k + 1) / static_cast<double>(views.size()),
      TimeLeft(each * static_cast<double>(views.size() - k - 1)));
  }
  queue.Finish();
  statistics.AddTime("flight", watch.GetMilliseconds());
  return drawn;
}
}

//------------------------------------------------------------------------------
void DrawFlight(const FlightStage& stage, const Options& options, Statistics& statistics)
{
  if (stage.Heights.IsGlobe() && options.Flight.IsFile())
  {
    throw Failure("--flight", "over a globe there are orbit and spin: choose --frame map");
  }
  if (stage.Heights.IsGlobe() &&
    vtkMath::Norm(stage.Renderer->GetActiveCamera()->GetFocalPoint()) > 0.0)
  {
    throw Failure("--flight",
      "over a globe orbit and spin turn about its axis: choose --frame plane for a part of it");
  }
  std::vector<FlightView> views = PlanFlight(stage, options);
  if (!stage.Heights.IsGlobe())
  {
    const vtkNew<vtkTerrainViewpoint> viewpoint;
    viewpoint->SetHeights(stage.Heights.Image);
    viewpoint->SetExaggeration(stage.Heights.Exaggeration);
    const double least = StayAbove(
      views, [&viewpoint](double x, double y) { return viewpoint->GetGround(x, y); },
      ClearanceOf(stage), static_cast<std::size_t>(options.Flight.Rate));
    statistics.SetNumber("flight_least_height", std::isfinite(least) ? least : -1.0);
  }
  const std::string folder = FramesFolder(options.Output);
  OpenFolder(folder, DescribeFlight(options));
  const double rate = options.Flight.Rate;
  WriteViews(folder, views, rate);
  const std::unique_ptr<FlightFrames> frames =
    OpenFrames({ folder, options.Output, views.size(), options.Size, rate, options.Dots });
  const std::size_t drawn = DrawMissing(stage, views, *frames, options, statistics);
  statistics.SetCount("flight_frames", static_cast<std::int64_t>(views.size()));
  statistics.SetCount("flight_frames_drawn", static_cast<std::int64_t>(drawn));
  const Stopwatch watch;
  frames->Finish();
  if (IsFilm(options.Output))
  {
    statistics.AddTime("film", watch.GetMilliseconds());
  }
  TellName(options.Output);
}
