// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reading the heightfield, whose codes src/core/grid/HeightCodes.h describes.
// Defines: TERRAIN_HEIGHTS_INTEGER if texels are 16-bit integers;
// TERRAIN_GATHER if textureGather() can be used (GLSL 4.00, or GL_ARB_texture_gather enabled): one
// look-up a cell instead of four. TERRAIN_DETAIL if the heightfield is the sum of the texels, the
// base, and of a repeated detail: all samples, cells and sizes are then those of the sum.
// TERRAIN_TILES if the texels are those of vtkTerrainTiles.glsl, the finest that are there.
//
// Twins in src/core/: surface/CodedHeights.h; of sums, surface/DetailHeights.h.

#ifndef TERRAIN_TILES
#ifdef TERRAIN_HEIGHTS_INTEGER
uniform usampler2D terrainHeights; // texels, W x H
#else
uniform sampler2D terrainHeights;
#endif
#endif
uniform ivec2 terrainSize;         // samples
uniform float terrainBias;         // texel minus code
uniform float terrainMaximumCode;  // largest code; the smallest is 0

#ifdef TERRAIN_TILES
// Number of texels.
ivec2 terrainTexelSize()
{
  return terrainSize;
}

// Codes of the corners of a cell of texels: south-west, south-east, north-west, north-east.
vec4 terrainTexelCodes(ivec2 cell)
{
  return terrainTileCellCodes(cell);
}
#else
// Number of texels.
ivec2 terrainTexelSize()
{
  return textureSize(terrainHeights, 0);
}

// Code of a sample of the texels; negative if it has no height.
float terrainTexelCode(ivec2 sampleIndex)
{
  return float(texelFetch(terrainHeights, sampleIndex, 0).r) - terrainBias;
}

// Codes of the corners of a cell of texels: south-west, south-east, north-west, north-east.
vec4 terrainTexelCodes(ivec2 cell)
{
#ifdef TERRAIN_GATHER
  // The position amidst the four texels: half a texel of room for any rounding.
  vec2 positionTC = (vec2(cell) + 1.0) / vec2(terrainTexelSize());
  return vec4(textureGather(terrainHeights, positionTC).wzxy) - terrainBias;
#else
  return vec4(terrainTexelCode(cell), terrainTexelCode(cell + ivec2(1, 0)),
    terrainTexelCode(cell + ivec2(0, 1)), terrainTexelCode(cell + ivec2(1, 1)));
#endif
}
#endif

// True if all corners of a cell have heights.
bool terrainCellValid(vec4 codes)
{
  return all(greaterThanEqual(codes, vec4(0.0)));
}

// Height code of the bilinear patch at a position in its cell, 0 <= fraction <= 1. Not by mix(),
// which compilers may round so that neighbouring cells differ on the edge they share.
float terrainPatchCode(vec4 codes, vec2 fraction)
{
  vec2 edges = codes.xz * (1.0 - fraction.x) + codes.yw * fraction.x; // south and north edge
  return edges.x * (1.0 - fraction.y) + edges.y * fraction.y;
}

// Change of the code per cell east and north at a position in the cell.
vec2 terrainPatchGradient(vec4 codes, vec2 fraction)
{
  return vec2(mix(codes.y - codes.x, codes.w - codes.z, fraction.y),
    mix(codes.z - codes.x, codes.w - codes.y, fraction.x));
}

#ifdef TERRAIN_DETAIL
uniform sampler2D terrainDetail;   // codes of one period
uniform ivec2 terrainDetailPeriod; // its size, samples
uniform int terrainDetailLevel;    // 2^level detail cells along a cell of texels
uniform float terrainDetailScale;  // height codes per code of the detail

// index % period of 0 <= index < 2^22, more than there are cells: exact, although a quotient may be
// off by one, and on processors that divide integers one by one a tenth of the work.
ivec2 terrainWrap(ivec2 index, ivec2 period)
{
  ivec2 rest = index - period * ivec2(vec2(index) / vec2(period));
  rest += period * ivec2(lessThan(rest, ivec2(0)));
  return rest - period * ivec2(greaterThanEqual(rest, period));
}

// Scaled codes of the repeated detail at the corners of a cell, in the order of
// terrainTexelCodes().
vec4 terrainDetailCodes(ivec2 cell)
{
  ivec2 first = terrainWrap(cell, terrainDetailPeriod);
#ifdef TERRAIN_GATHER
  vec2 positionTC = (vec2(first) + 1.0) / vec2(terrainDetailPeriod); // the texture repeats
  return terrainDetailScale * textureGather(terrainDetail, positionTC).wzxy;
#else
  ivec2 last = terrainWrap(first + 1, terrainDetailPeriod);
  return terrainDetailScale *
    vec4(texelFetch(terrainDetail, first, 0).r,
      texelFetch(terrainDetail, ivec2(last.x, first.y), 0).r,
      texelFetch(terrainDetail, ivec2(first.x, last.y), 0).r,
      texelFetch(terrainDetail, last, 0).r);
#endif
}

// The texels' codes at the corners of part (x, y) of 2^parts x 2^parts parts of a cell of texels,
// cell = part >> parts, parts >= 0; all negative where that has no surface.
vec4 terrainPartCodes(ivec2 part, int parts)
{
  ivec2 cell = part >> parts;
  vec4 codes = terrainTexelCodes(cell);
  float width = 1.0 / float(1 << parts);
  vec2 low = vec2(part - (cell << parts)) * width;
  vec2 high = low + width;
  vec4 corners = vec4(terrainPatchCode(codes, low), terrainPatchCode(codes, vec2(high.x, low.y)),
    terrainPatchCode(codes, vec2(low.x, high.y)), terrainPatchCode(codes, high));
  return terrainCellValid(codes) ? corners : vec4(-1.0);
}

// Codes of the corners of a cell: south-west, south-east, north-west, north-east.
vec4 terrainCellCodes(ivec2 cell)
{
  vec4 codes = terrainPartCodes(cell, terrainDetailLevel);
  return codes.x < 0.0 ? codes : codes + terrainDetailCodes(cell);
}
#else
// Codes of the corners of a cell: south-west, south-east, north-west, north-east.
vec4 terrainCellCodes(ivec2 cell)
{
  return terrainTexelCodes(cell);
}
#endif
