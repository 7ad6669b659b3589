// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Flights from files.
 */
#ifndef terrain_render_FlightFile_h
#define terrain_render_FlightFile_h

#include "FlightPath.h"

#include <string>
#include <vector>

struct PlacedHeights;

/// True for tables: .csv.
bool IsFlightTable(const std::string& path);

/**
 * Keys of a table: a line of names, then one line a key. Names, in any order and case: `seconds`;
 * `lon`, `lat`, `height` (metres, or metres above the ground as in "120agl"), or `x`, `y`, `z` of
 * the scene; and `look_lon`, `look_lat`, `look_height` or `look_x`, `look_y`, `look_z`, without
 * which the camera looks ahead along its way. Throws a Failure with the line: no such columns, no
 * number, times that do not rise, fewer than two keys.
 */
std::vector<FlightKey> ReadFlightTable(const std::string& path, const PlacedHeights& heights);

/**
 * The lines of a vector file on the ground, one after another. With times where all points of the
 * tracks of a GPX file have one and none is before the one that precedes it; a warning tells of
 * times that go back. Throws a Failure: no file, no lines, fewer than two places.
 */
FlightTrack ReadFlightTrack(const std::string& path, const PlacedHeights& heights, bool isTimed);

#endif
