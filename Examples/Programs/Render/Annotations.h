// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn onto and over the terrain: track, graticule, scale bar, north arrow.
 */
#ifndef terrain_render_Annotations_h
#define terrain_render_Annotations_h

class Statistics;
class vtkRenderer;
struct Options;
struct PlacedHeights;

/// Adds the track and the graticule that the options ask for, as the renderer's camera needs them.
/// Throws a Failure.
void AddLines(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  Statistics& statistics);

/// Adds scale bar and north arrow, as they are right at the focal point of the renderer's camera.
void AddOverlay(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options);

#endif
