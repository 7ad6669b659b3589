// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reading the heightfield. Twin: CodedHeights in src/core/Ray.h; codes: src/core/HeightCodes.h.
// Defines: TERRAIN_HEIGHTS_INTEGER if texels are 16-bit integers; TERRAIN_GATHER if textureGather()
// can be used (GLSL 4.00, or GL_ARB_texture_gather enabled): one look-up a cell instead of four.

#ifdef TERRAIN_HEIGHTS_INTEGER
uniform usampler2D terrainHeights; // texels, W x H
#else
uniform sampler2D terrainHeights;
#endif
uniform ivec2 terrainSize;         // W, H: samples
uniform float terrainBias;         // texel minus code
uniform float terrainMaximumCode;  // largest code; the smallest is 0

// Code of a sample; negative if it has no height. 0 <= sampleIndex < terrainSize.
float terrainCode(ivec2 sampleIndex)
{
  return float(texelFetch(terrainHeights, sampleIndex, 0).r) - terrainBias;
}

// Codes of the corners of a cell: south-west, south-east, north-west, north-east.
vec4 terrainCellCodes(ivec2 cell)
{
#ifdef TERRAIN_GATHER
  // The position amidst the four texels: half a texel of room for any rounding.
  vec2 positionTC = (vec2(cell) + 1.0) / vec2(terrainSize);
  return vec4(textureGather(terrainHeights, positionTC).wzxy) - terrainBias;
#else
  return vec4(terrainCode(cell), terrainCode(cell + ivec2(1, 0)), terrainCode(cell + ivec2(0, 1)),
    terrainCode(cell + ivec2(1, 1)));
#endif
}

// True if all corners of a cell have heights.
bool terrainCellValid(vec4 codes)
{
  return all(greaterThanEqual(codes, vec4(0.0)));
}

// Height code of the bilinear patch at a position in its cell, 0 <= fraction <= 1. Not by mix(), which
// compilers may round so that neighbouring cells differ on the edge they share.
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
