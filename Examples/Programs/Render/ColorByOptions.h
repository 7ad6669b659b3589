// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What colours show: heights, slope, aspect, or the values of another raster.
 */
#ifndef terrain_render_ColorByOptions_h
#define terrain_render_ColorByOptions_h

#include <string>

namespace CLI
{
class App;
}

struct ColorByOptions
{
  /// "slope", "aspect", or a raster; empty for heights.
  std::string By;
  /// Band of the raster, from 1 on.
  int Band = 1;

  void Declare(CLI::App& app);

  bool IsGiven() const
  {
    return !this->By.empty();
  }
  bool IsSlope() const;
  bool IsAspect() const;
  bool IsFile() const;
};

#endif
