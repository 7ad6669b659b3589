// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options by which a person chooses sun, shadows and sky: the same words in every program.
 */
#ifndef terrain_common_LightOptions_h
#define terrain_common_LightOptions_h

#include <string>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkTerrainActor;
class vtkTerrainGeoreference;
namespace CLI
{
class App;
}

struct LightOptions
{
  /// "AZIMUTH,ALTITUDE", a date and time, or "FROM/TO/MINUTES"; empty for the north-west.
  std::string Sun;
  bool Shadows = false;
  /// Angular diameter of the sun, in degrees.
  double SunAngle = 0.53;
  /// Light of the sky over that of a light of intensity 1; 0 for a light at the eye instead.
  double SkyLight = 0.0;
  /// As it was typed.
  std::string SkyText;

  /// Adds the options to a command line, which fills this object and refuses what is no value.
  void Declare(CLI::App& app, bool allowRange);

  /// The suns of the pictures to draw, as PlaceSun() takes them: several of a range, else one.
  std::vector<std::string> GetSuns() const;
  /// True if the sun is that of a time, which needs the place on earth.
  bool NeedsPlace() const;

  /// Shadows and sky of a terrain.
  void Apply(vtkTerrainActor* terrain) const;
};

/// Makes a light of the sun of heights in a frame; off where it is below the horizon. Returns one
/// sentence that says why there is no such sun, or an empty string.
std::string PlaceSun(const std::string& sun, vtkTerrainGeoreference* frame, vtkImageData* heights,
  double exaggeration, vtkLight* light);

#endif
