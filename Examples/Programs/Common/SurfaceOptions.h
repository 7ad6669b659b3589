// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of lines, shade and block of a surface: the same words in every program.
 */
#ifndef terrain_common_SurfaceOptions_h
#define terrain_common_SurfaceOptions_h

#include "BlockWalls.h"

#include <string>
#include <vector>

struct LightOptions;
class vtkTerrainActor;
namespace CLI
{
class App;
}

struct SurfaceOptions
{
  /// Metres between contour lines; 0 for none.
  double Contours = 0.0;
  /// Every n-th line is twice as wide; 0 for none.
  int ContourIndex = 5;
  bool Hillshade = false;
  /// Metres that a block reaches below the lowest height; 0 for none.
  double Block = 0.0;
  /// Layers of its sides, "COLOUR=METRES,COLOUR"; empty for the colours of the surface.
  std::string Strata;

  /// Adds the options to a command line, which fills this object and refuses what is no value.
  void Declare(CLI::App& app);

  /// The layers, the last one filling what is left; none if there are no own ones.
  std::vector<Stratum> GetStrata() const;

  /// Throws a CLI::ValidationError if layers are asked for without a block.
  void CheckStrata() const;

  /// Throws a CLI::ValidationError if a light is asked for that these options leave out.
  void CheckLight(const LightOptions& light) const;

  /// Draws a terrain with them, whose lowest height is given. Property and lights are left alone.
  /// `pixels` are those that a width of 1 takes.
  void Apply(vtkTerrainActor* terrain, double lowest, double pixels = 1.0) const;
};

#endif
