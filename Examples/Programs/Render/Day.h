// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One picture for each sun of a range of times.
 */
#ifndef terrain_render_Day_h
#define terrain_render_Day_h

class Canvas;
class vtkRenderer;
struct Options;
struct PlacedHeights;

/// Draws the pictures of all suns of the options, and tells the name of each that is there. Those
/// that were drawn before one fails are kept. Throws a Failure.
void DrawSuns(
  Canvas& canvas, vtkRenderer* renderer, const PlacedHeights& heights, const Options& options);

#endif
