// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about places on earth.
 */
#ifndef terrain_render_PlaceOptions_h
#define terrain_render_PlaceOptions_h

#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// What the command line asks for, with the defaults of the options that were left out. Frames,
/// heights and modes are told where vtkTerrainGeoreference and vtkTerrainDrape are.
struct PlaceOptions
{
  /// None: chosen by the program.
  std::optional<vtkTerrainGeoreference::FrameType> Frame;
  /// The program chooses none but a flat frame.
  bool IsMap = false;
  /// Longitude, latitude, height.
  std::optional<std::array<double, 3>> Origin;
  /// 1 to 60, 0 for UPS, -1 for that of the middle of the heights.
  int Zone = -1;
  bool Northern = true;
  /// Distance of samples in metres; 0: that of the file.
  double Cell = 0.0;
  bool Cubic = false;
  vtkTerrainGeoreference::HeightType Vertical = vtkTerrainGeoreference::HeightType::AsIs;
  /// Name of geoid data; empty for the default.
  std::string Geoid;

  /// Files of heights in finer cells on the same globe.
  std::vector<std::string> Finer;
  /// File of a picture; empty for none.
  std::string Drape;
  /// Files of points and lines.
  std::vector<std::string> Tracks;
  vtkTerrainDrape::ModeType TrackMode = vtkTerrainDrape::ModeType::Clamped;

  /// Places of the eye and of what it looks at, both or none.
  std::string LookFrom;
  std::string LookAt;
  /// Whether the sun is that of a time (LightOptions).
  bool HasTimeOfSun = false;
  /// Whether there are labels (MarkOptions).
  bool HasLabels = false;
  /// Whether there are polygons (PolygonOptions).
  bool HasPolygons = false;

  std::optional<vtkTerrainGraticule::GridType> Graticule;
  bool ScaleBar = false;
  bool NorthArrow = false;

  /// The file of the geoid data; empty where no heights are converted, or where there are none.
  std::string GetGeoidFile() const;

  /// The first option that needs to know where on earth the heights are; null if there is none.
  const char* FirstThatNeedsPlaces() const;
};

/// Reads these options in two steps, as CLI11 needs it.
class PlaceArguments
{
public:
  /// Adds the options to a command line, which fills `options` and this object.
  void Declare(CLI::App& app, PlaceOptions& options);
  /// Fills the rest of `options` from what was given as text. Refuses (Arguments.h) what is wrong.
  void Interpret(PlaceOptions& options) const;

private:
  std::string Frame;
  std::string Origin;
  std::string Zone;
  std::string Cell;
  bool Curvature = false;
};

#endif
