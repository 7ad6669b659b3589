// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Water over a terrain.
 */
#ifndef terrain_render_Water_h
#define terrain_render_Water_h

#include <vector>

class vtkRenderer;
struct Options;
struct PlacedHeights;
struct Terrain;

/// Adds water up to a level over the cells of a terrain and of its sites, and at their sides where
/// the ground ends below it. The deeper it is, the darker and the less clear. The terrain's
/// bounds grow by it. Throws a Failure in scenes that are round.
void AddWater(vtkRenderer* renderer, Terrain& terrain, const std::vector<Terrain>& sites,
  const PlacedHeights& heights, const Options& options);

#endif
