// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of lines, shade and block of a surface: the same words in every program.
 */
#ifndef terrain_common_SurfaceOptions_h
#define terrain_common_SurfaceOptions_h

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
  bool Hillshade = false;
  /// Metres that a block reaches below the lowest height; 0 for none.
  double Block = 0.0;

  /// Adds the options to a command line, which fills this object and refuses what is no value.
  void Declare(CLI::App& app);

  /// Throws a CLI::ValidationError if a light is asked for that these options leave out.
  void CheckLight(const LightOptions& light) const;

  /// Draws a terrain with them, whose lowest height is given. Property and lights are left alone.
  void Apply(vtkTerrainActor* terrain, double lowest) const;
};

#endif
