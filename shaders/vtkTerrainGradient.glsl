// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The slope of the surface, for its normal: differences of heights over a cell, or over what a
// pixel covers where that is more, so that distant ridges do not shimmer. Gradients are in codes
// per cell. Needs vtkTerrainHeights.glsl and vtkTerrainView.glsl. Constant: terrainFirstSlopeLevel,
// kFirstSlopeLevel in src/core/surface/HeightSlopes.h.
//
// Twins in src/core/: surface/HeightGradient.h, surface/HeightSlopes.h, rays/SurfaceShading.h.

uniform sampler2D terrainSlopes;   // of squares of cells: src/core/surface/HeightSlopes.h
uniform float terrainSlopesScale; // codes per cell and unit of terrainSlopes

// Code of the texels' surface at a position in cells relative to a cell of texels; negative where
// there is none.
float terrainTexelHeight(ivec2 cell, vec2 position)
{
  ivec2 at = clamp(cell + ivec2(floor(position)), ivec2(0), terrainTexelSize() - 2);
  vec4 codes = terrainTexelCodes(at);
  return terrainCellValid(codes) ? terrainPatchCode(codes, position - vec2(at - cell)) : -1.0;
}

// Mean slope along x and y from low to high, positions on both sides of one in a cell; here, atLow
// and atHigh: codes there, negative where there is no height. A difference ends at the position on
// a side without height; without any on both sides it is `none`. Per cell of the positions' unit.
vec2 terrainDifference(
  vec2 position, vec2 low, vec2 high, float here, vec2 atLow, vec2 atHigh, vec2 none)
{
  bvec2 noLow = lessThan(atLow, vec2(0.0));
  bvec2 noHigh = lessThan(atHigh, vec2(0.0));
  vec2 apart = mix(high, position, noHigh) - mix(low, position, noLow);
  vec2 mean = (mix(atHigh, vec2(here), noHigh) - mix(atLow, vec2(here), noLow)) / max(apart, 1e-3);
  return mix(mean, none, bvec2(noLow.x && noHigh.x, noLow.y && noHigh.y));
}

// Gradient of the texels' surface at a position in a cell of texels, as the central difference over
// a width in texels: the mean slope along it. Continuous away from holes, and for a width of 1 the
// gradient of the patch at the centre of a cell. The difference ends at the border, and at the
// position where there are no heights; without any it is the patch's own. Codes: of the cell's
// corners.
vec2 terrainWideGradient(ivec2 cell, vec2 fraction, vec4 codes, float width)
{
  vec2 low = max(fraction - 0.5 * width, vec2(-cell));
  vec2 high =
    min(fraction + 0.5 * width, vec2(terrainTexelSize() - 1 - cell));
  float here = terrainPatchCode(codes, fraction);
  vec2 atLow = vec2(terrainTexelHeight(cell, vec2(low.x, fraction.y)),
    terrainTexelHeight(cell, vec2(fraction.x, low.y)));
  vec2 atHigh = vec2(terrainTexelHeight(cell, vec2(high.x, fraction.y)),
    terrainTexelHeight(cell, vec2(fraction.x, high.y)));
  return terrainDifference(
    fraction, low, high, here, atLow, atHigh, terrainPatchGradient(codes, fraction));
}

// The mean gradient over squares of 2^level cells of texels a side, level >=
// terrainFirstSlopeLevel, at a position in cells of texels.
vec2 terrainMeanGradient(vec2 position, float level)
{
  vec2 cells = vec2(terrainTexelSize() - 1);
  return terrainSlopesScale *
    textureLod(terrainSlopes, position / cells, level - terrainFirstSlopeLevel).rg;
}

#ifdef TERRAIN_TILES
// Gradient of the surface at a position in a cell of level 0, as the central difference over
// 2^level cells; over one if level < 0. The heights are those of the tiles' level that has cells of
// that size, or of the finest that is there. Codes: of the cell's corners.
vec2 terrainTexelGradient(ivec2 cell, vec2 fraction, vec4 codes, float level)
{
  int from = clamp(int(level), 0, terrainTileTop);
  float width = exp2(max(level, 0.0));
  vec2 low = max(fraction - 0.5 * width, vec2(-cell));
  vec2 high = min(fraction + 0.5 * width, vec2(terrainSize - 1 - cell));
  // A loop, so that the function stands in the program once: five times take a third of a frame of
  // llvmpipe. The height here is needed only beside holes.
  vec2 atLow = vec2(0.0);
  vec2 atHigh = vec2(0.0);
  float here = 0.0;
  int reads = 4;
  for (int i = 0; i < reads; ++i)
  {
    float x = i == 0 ? low.x : i == 1 ? high.x : fraction.x;
    float y = i == 2 ? low.y : i == 3 ? high.y : fraction.y;
    here = terrainTileHeight(cell, vec2(x, y), from, terrainSize);
    atLow = vec2(i == 0 ? here : atLow.x, i == 2 ? here : atLow.y);
    atHigh = vec2(i == 1 ? here : atHigh.x, i == 3 ? here : atHigh.y);
    reads = here < 0.0 ? 5 : reads;
  }
  vec2 own = terrainPatchGradient(codes, fraction);
  return reads == 5 && here < 0.0 ? own
                                  : terrainDifference(fraction, low, high, here, atLow, atHigh,
                                      from == 0 ? own : vec2(0.0));
}
#else
// Gradient of the texels' surface at a position in a cell of texels over squares of 2^level texels
// a side; of one texel if level < 0. Codes: of the cell's corners.
vec2 terrainTexelGradient(ivec2 cell, vec2 fraction, vec4 codes, float level)
{
  float coarse = clamp(level - terrainFirstSlopeLevel + 1.0, 0.0, 1.0);
  vec2 gradient = vec2(0.0);
  if (coarse < 1.0)
  {
    float fine = clamp(level, 0.0, terrainFirstSlopeLevel);
    gradient = terrainWideGradient(cell, fraction, codes, exp2(fine));
  }
  if (coarse > 0.0)
  {
    vec2 mean = terrainMeanGradient(vec2(cell) + fraction, max(level, terrainFirstSlopeLevel));
    gradient = mix(gradient, mean, coarse);
  }
  return gradient;
}
#endif

#ifdef TERRAIN_DETAIL
// Gradient of the detail at a position in a cell over squares of 2^level of its cells a side,
// level >= 0.
vec2 terrainDetailGradient(ivec2 cell, vec2 fraction, float level)
{
  vec2 period = vec2(terrainDetailPeriod);
  vec2 at = (vec2(terrainWrap(cell, terrainDetailPeriod)) + fraction + 0.5) / period;
  vec2 step = 0.5 * exp2(level) / period;
  vec2 difference = vec2(textureLod(terrainDetail, vec2(at.x + step.x, at.y), level).r -
      textureLod(terrainDetail, vec2(at.x - step.x, at.y), level).r,
    textureLod(terrainDetail, vec2(at.x, at.y + step.y), level).r -
      textureLod(terrainDetail, vec2(at.x, at.y - step.y), level).r);
  return terrainDetailScale * difference * exp2(-level);
}
#endif

// Cells that a pixel is wide at a distance along the viewing direction, on a plane across it.
float terrainPixelCells(float distanceVC)
{
#ifdef TERRAIN_GLOBE
  // from south to north: near a pole, cells are narrow
  vec3 right = terrainOriginGC[1] + distanceVC * terrainDirectionGC[1];
  vec3 up = terrainOriginGC[2] + distanceVC * terrainDirectionGC[2];
  return sqrt(max(dot(right, right), dot(up, up))) * terrainCellsPerMetre().y;
#else
  vec2 right = terrainOriginGC[1].xy + distanceVC * terrainDirectionGC[1].xy;
  vec2 up = terrainOriginGC[2].xy + distanceVC * terrainDirectionGC[2].xy;
  return sqrt(max(dot(right, right), dot(up, up)));
#endif
}

// Gradient of what a pixel shows of the surface at a distance along the viewing direction. With
// detail it is the sum of both gradients, each over its own cells: the base then shows no creases
// between its patches, as in Balogh's chapter 7.
vec2 terrainGradient(ivec2 cell, vec2 fraction, vec4 codes, float distanceVC)
{
  float level = log2(max(terrainPixelCells(distanceVC), 1e-6));
#ifdef TERRAIN_DETAIL
  ivec2 texel = cell >> terrainDetailLevel;
  float texelWidth = 1.0 / float(1 << terrainDetailLevel);
  vec2 position = (vec2(cell - (texel << terrainDetailLevel)) + fraction) * texelWidth;
  return texelWidth *
    terrainTexelGradient(
      texel, position, terrainTexelCodes(texel), level - float(terrainDetailLevel)) +
    terrainDetailGradient(cell, fraction, max(level, 0.0));
#else
  return terrainTexelGradient(cell, fraction, codes, level);
#endif
}
