// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One picture for each sun of a range of times.
 */
#ifndef terrain_render_Day_h
#define terrain_render_Day_h

#include <cstddef>
#include <string>

class Canvas;
class vtkRenderer;
struct Options;
struct PlacedHeights;

/// Name of picture `number`, from 1 on, of so many: "terrain-007.png".
std::string PictureName(const std::string& output, std::size_t number, std::size_t count);

/// Prints the whole name of a file that has been written.
void TellName(const std::string& file);

/// Draws the pictures of all suns of the options, and tells the name of each that is there. Those
/// that were drawn before one fails are kept. Throws a Failure.
void DrawSuns(
  Canvas& canvas, vtkRenderer* renderer, const PlacedHeights& heights, const Options& options);

#endif
