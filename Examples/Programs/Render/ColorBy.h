// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Brings to heights what their colours show.
 */
#ifndef terrain_render_ColorBy_h
#define terrain_render_ColorBy_h

#include "ColorSource.h"

class Statistics;
struct Options;
struct PlacedHeights;

/// Brings the values of the raster that the options name to the heights, as their array
/// kColorValues. Classes become their numbers in the colours. Throws a Failure.
ColorSource ReadColorSource(PlacedHeights& heights, const Options& options, Statistics& statistics);

#endif
