// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The technique in use. It only chooses, and has no twin. Needs vtkTerrainPyramid.glsl and, for the
// searches, vtkTerrainSearch.glsl.
// Defines: TERRAIN_LINEAR, TERRAIN_EXPONENTIAL, TERRAIN_EQUIDISTANT or TERRAIN_PYRAMID; with the
// last, TERRAIN_WITHIN for a tolerance, and TERRAIN_TILES for heights in tiles.

#ifdef TERRAIN_WITHIN
uniform vec4 terrainTolerance; // cells, codes; and their change per unit of distance (world)
#endif

// The first hit of a ray that begins at a distance along the viewing direction, in world units,
// from which tolerances count.
TerrainHit terrainTrace(TerrainRay ray, float startDistance)
{
#ifndef TERRAIN_PYRAMID
  return terrainSearch(ray);
#elif defined(TERRAIN_TILES) && defined(TERRAIN_WITHIN)
  return terrainTraceTiles(ray,
    vec4(terrainTolerance.xy + startDistance * terrainTolerance.zw, terrainTolerance.zw));
#elif defined(TERRAIN_WITHIN)
  return terrainTracePyramidWithin(ray,
    vec4(terrainTolerance.xy + startDistance * terrainTolerance.zw, terrainTolerance.zw));
#else
  return terrainTracePyramid(ray);
#endif
}
