// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about how tracks look.
 */
#ifndef terrain_render_TrackOptions_h
#define terrain_render_TrackOptions_h

#include "FieldOptions.h"

#include <string>

struct TrackOptions : FieldOptions
{
  TrackOptions()
    : FieldOptions("track")
  {
  }

  /// Width in pixels of a picture 720 pixels high, or in metres ("30m"); empty for the usual one.
  std::string Width;

  void Declare(CLI::App& app);

  /// Throws a CLI::ValidationError if an option is given that has nothing to show.
  void Check(bool hasTracks) const;

  /// Width in metres of tubes; 0 for lines.
  double GetMetres() const;
  /// Width of lines in pixels, or a usual one.
  double GetPixels(double usual) const;
};

#endif
