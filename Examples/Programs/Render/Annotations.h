// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn over the terrain: scale bar, north arrow, legend.
 */
#ifndef terrain_render_Annotations_h
#define terrain_render_Annotations_h

#include <string>

class vtkRenderer;
struct Options;
struct PlacedHeights;
struct Terrain;

/// Adds scale bar and north arrow, as they are right at the focal point of the renderer's camera.
void AddOverlay(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options);

/// Adds the colours of heights beside the picture's right border, with round numbers, if the
/// options ask for that.
void AddLegend(vtkRenderer* renderer, const Terrain& terrain, const Options& options);

/// A number that is a multiple of a round step, with commas between thousands: "1,500", "0.25".
std::string GroupedNumber(double number, double step);

#endif
