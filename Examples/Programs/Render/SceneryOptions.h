// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about what is around the terrain.
 */
#ifndef terrain_render_SceneryOptions_h
#define terrain_render_SceneryOptions_h

#include "ColorName.h"

#include <array>
#include <optional>
#include <string>

namespace CLI
{
class App;
}

struct SceneryOptions
{
  /// "COLOUR", "LOW,HIGH", "sky" or "transparent"; empty for the program's own gradient.
  std::string Background;
  /// Height of a plane of water, in metres.
  std::optional<double> Water;
  /// Distance in metres at which half of a colour is that of the fog; 0 for none.
  double Fog = 0.0;

  void Declare(CLI::App& app);

  bool IsSky() const;
  bool IsTransparent() const;
  /// Colours of the lower and the upper border; those of the program unless colours are given.
  std::array<RGB, 2> GetColors() const;
};

#endif
