// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sightings of all pixels of a viewport as a texture, which a compute shader has filled
// (vtkTerrainSightingCS.glsl). One texel a pixel: distance along the viewing direction, < 0 for
// none; position in cells, to 1/1000 of a cell in grids of 16384 cells and 1/16 in such
// of 2^20 (with detail), which is for normals and colours; work done plus 1 plus a 32th of the wall's
// number plus 1, < 0 if the back is seen. Needs vtkTerrainHeights.glsl and vtkTerrainView.glsl.

struct TerrainSighting
{
  bool found;
  float distanceVC;
  ivec2 cell;
  vec2 fraction;
  bool front;
  int crossings;
  int wall;
  vec4 codes; // of the cell's corners
};

uniform sampler2D terrainSightings;

TerrainSighting terrainReadSighting(vec2 pixel)
{
  vec4 texel = texelFetch(terrainSightings, ivec2(pixel) - terrainViewportOrigin, 0);
  ivec2 cell = clamp(ivec2(texel.yz), ivec2(0), terrainSize - 2);
  return TerrainSighting(texel.x >= 0.0, texel.x, cell, texel.yz - vec2(cell), texel.w > 0.0,
    int(abs(texel.w)) - 1, int(32.0 * fract(abs(texel.w))) - 1, terrainCellCodes(cell));
}
