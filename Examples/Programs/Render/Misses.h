// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the searches by steps do not find.
 */
#ifndef terrain_render_Misses_h
#define terrain_render_Misses_h

#include "Options.h"
#include "Statistics.h"
#include "Terrain.h"

class Canvas;

/// For searches that can miss the surface (linear, exponential, equidistant with steps of the
/// user's): draws depths once more with the search and once with the technique pyramid, which is
/// exact. Adds the pixels of the surface that the search leaves empty or fills wrongly, and those
/// that it has more than a thousandth of their distance off, to the statistics; and a line to
/// stderr. Hides all other props.
void CountMisses(
  const Terrain& terrain, const Options& options, Canvas& canvas, Statistics& statistics);

#endif
