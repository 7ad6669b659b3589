// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about flights.
 */
#ifndef terrain_render_FlightOptions_h
#define terrain_render_FlightOptions_h

#include <string>

namespace CLI
{
class App;
}

/// What the command line asks for, with the defaults of the options that were left out.
struct FlightOptions
{
  /// "orbit", "spin:SECONDS" or a file; empty for none.
  std::string Flight;
  /// Frames a second, 1 to 240.
  double Rate = 30.0;
  /// Duration in seconds; 0: that of the flight.
  double Seconds = 0.0;
  /// True to take no notice of the times of a track.
  bool HasEvenSpeed = false;
  /// The options of the scene, by which frames of an earlier run are known.
  std::string Scene;

  void Declare(CLI::App& app);
  /// Refuses (Arguments.h) what is wrong.
  void Check(const std::string& output) const;

  bool IsWanted() const
  {
    return !this->Flight.empty();
  }
  /// Seconds of a spin; 0 for other flights.
  double SpinSeconds() const;
  /// True if a file says where the camera goes.
  bool IsFile() const;
};

/// Folder of the frames of a flight: the output itself, or beside a film of that name.
std::string FramesFolder(const std::string& output);

/// True for outputs that are films: .mp4, .webm, .gif, .webp.
bool IsFilm(const std::string& output);

#endif
