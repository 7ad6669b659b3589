// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture on the terrain.
 */
#ifndef terrain_render_Draping_h
#define terrain_render_Draping_h

class Statistics;
struct Options;
struct PlacedHeights;
struct PolygonLayer;
struct Terrain;

/// Lays the picture that the options ask for onto the terrain, of which it may cover a part, and
/// what fills polygons over it. Throws a Failure: no picture, no coordinate system, no overlap.
void DrapePicture(const Terrain& terrain, const PlacedHeights& heights,
  const PolygonLayer& polygons, const Options& options, Statistics& statistics);

/// Lays what fills polygons onto another site in the same plane.
void DrapePolygons(const Terrain& site, const PolygonLayer& polygons, const Options& options);

#endif
