// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Several terrains in one scene: a folder of tiles at sites far from each other, or rasters of
 * several resolutions on a globe.
 */
#ifndef terrain_render_Sites_h
#define terrain_render_Sites_h

#include "Terrain.h"

#include <vector>

struct PlacedHeights;

/// Prepares the sites beside the one that was read and is `terrain`, placed in the scene of its
/// heights, which know them then. All get the colours of one range, and the terrain's bounds hold
/// them all. A site that cannot join the scene is left out with a warning.
std::vector<Terrain> PrepareSites(const ReadHeightsResult& read, PlacedHeights& heights,
  const Options& options, Terrain& terrain, ProgressBar& progress, Statistics& statistics);

/// A terrain for each raster of finer cells on the globe of the first. The first one's bounds grow
/// to hold all of them, and all have the same colours. Throws a Failure.
std::vector<Terrain> PrepareFiner(const PlacedHeights& heights, const Options& options,
  Terrain& terrain, ProgressBar& progress, Statistics& statistics);

/// Adds them to the renderer of the first.
void AddSites(const std::vector<Terrain>& sites, vtkRenderer* renderer, const Options& options);

#endif
