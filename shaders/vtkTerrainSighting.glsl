// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the ray of a pixel sees first, and how it is kept in a texel from a compute shader
// (vtkTerrainSightingCS.glsl) to the fragment shader. Needs vtkTerrainHeights.glsl and
// vtkTerrainView.glsl. Defines: TERRAIN_READ_SIGHTINGS for the texture of all pixels of a viewport.
//
// Twins in src/core/: rays/Sighting.h.

// The first point of the surface on a pixel's ray.
struct TerrainSighting
{
  bool found;
  float distanceVC;  // along the viewing direction, world units
  ivec2 cell;
  vec2 fraction;     // position in the cell, 0..1
  bool front;        // seen from above
  int crossings;     // work done, see TerrainHit
  int wall;          // clipping plane at which a block is cut, or -1 for the surface
  vec4 codes;        // of the cell's corners
};

// A texel: x the distance, < 0 for none; yz the position in cells, to 1/1000 of a cell in grids of
// 16384 cells and 1/16 in such of 2^20 (with detail), which is for normals and colours;
// w = +-(work + 1 + (wall + 1) / 32), minus where the back is seen.
vec4 terrainPackSighting(TerrainSighting sighting)
{
  float work = float(sighting.crossings + 1);
  if (!sighting.found)
  {
    return vec4(-1.0, 0.0, 0.0, work);
  }
  work += float(sighting.wall + 1) / 32.0;
  return vec4(sighting.distanceVC, vec2(sighting.cell) + sighting.fraction,
    sighting.front ? work : -work);
}

// The sighting in a texel, of which cell and fraction are those of the rounded position. Codes are
// read anew.
TerrainSighting terrainUnpackSighting(vec4 texel)
{
  ivec2 cell = clamp(ivec2(texel.yz), ivec2(0), terrainSize - 2);
  return TerrainSighting(texel.x >= 0.0, texel.x, cell, texel.yz - vec2(cell), texel.w > 0.0,
    int(abs(texel.w)) - 1, int(32.0 * fract(abs(texel.w))) - 1, terrainCellCodes(cell));
}

#ifdef TERRAIN_READ_SIGHTINGS
uniform sampler2D terrainSightings; // one texel a pixel

// The sighting of a pixel (gl_FragCoord.xy) in the viewport.
TerrainSighting terrainReadSighting(vec2 pixel)
{
  return terrainUnpackSighting(
    texelFetch(terrainSightings, ivec2(pixel) - terrainViewportOrigin, 0));
}
#endif
