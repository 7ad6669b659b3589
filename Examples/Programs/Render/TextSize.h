// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How large texts, lines and marks of a picture are.
 */
#ifndef terrain_render_TextSize_h
#define terrain_render_TextSize_h

#include "Options.h"

#include <algorithm>

/// Height of the pictures that sizes are thought for, in pixels.
constexpr double kUsualHeight = 720.0;
/// Dots per inch at which these have their size on paper, too.
constexpr double kUsualDots = 96.0;

/// Pixels of what takes one pixel of a picture 720 pixels high: as much more as the picture is
/// higher; with --dpi what takes 1/96 inch on paper, at most twice that.
inline double PixelScale(const Options& options)
{
  const double byHeight = options.Size[1] / kUsualHeight;
  return options.Dots > 0.0 ? std::min(options.Dots / kUsualDots, 2.0 * byHeight) : byHeight;
}

/// Pixels of a line or point that takes so many in a picture 720 pixels high; at least half.
inline double LinePixels(double usual, const Options& options)
{
  return usual * std::max(0.5, PixelScale(options));
}

/// Height in pixels of a text that takes a share of the height of a usual picture.
inline double TextPixels(double share, const Options& options)
{
  return share * kUsualHeight * PixelScale(options);
}

#endif
