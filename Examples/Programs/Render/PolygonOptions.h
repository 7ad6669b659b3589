// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about polygons.
 */
#ifndef terrain_render_PolygonOptions_h
#define terrain_render_PolygonOptions_h

#include "FieldOptions.h"

#include <string>
#include <vector>

struct PolygonOptions : FieldOptions
{
  PolygonOptions()
    : FieldOptions("polygon")
  {
  }

  /// Vector files.
  std::vector<std::string> Files;
  /// Of the fill, from 0 for none to 1.
  double Opacity = 0.45;
  /// Of the outlines in pixels of a picture 720 pixels high, from 0 for none.
  double Width = 2.0;

  void Declare(CLI::App& app);

  /// Throws a CLI::ValidationError if an option is given that has nothing to show.
  void Check() const;
};

#endif
