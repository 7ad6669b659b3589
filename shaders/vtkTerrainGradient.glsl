// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The slope of the surface, for its normal: differences of heights over a cell, or over what a pixel
// covers where that is more, so that distant ridges do not shimmer. Gradients are in codes per cell.
// Needs vtkTerrainHeights.glsl and vtkTerrainView.glsl.

uniform sampler2D terrainMeans;  // mean codes of squares of texels: src/core/HeightMeans.h
uniform float terrainMeansScale; // codes per unit of terrainMeans

const float terrainFirstMeanLevel = 3.0;

// Slope of a neighbouring cell, from the codes of its outer corners and of those it shares; the
// cell's own slope if the neighbour has no heights.
float terrainNextSlope(vec2 outer, vec2 inner, float across, float direction, float own)
{
  bool valid = all(greaterThanEqual(outer, vec2(0.0)));
  float slope = direction * (mix(outer.x, outer.y, across) - mix(inner.x, inner.y, across));
  return valid ? slope : own;
}

// Code of a sample, negative outside of the grid.
float terrainCodeOrNone(ivec2 sampleIndex)
{
  bool inside = all(greaterThanEqual(sampleIndex, ivec2(0))) &&
    all(lessThan(sampleIndex, terrainSize));
  return inside ? terrainCode(sampleIndex) : -1.0;
}

// Gradient as the central difference of the surface over the width of one cell: continuous
// everywhere, and the gradient of the patch at the centre of a cell. At borders and next to cells
// without heights the difference stays within the cell.
vec2 terrainSmoothGradient(ivec2 cell, vec2 fraction, vec4 codes)
{
  vec2 own = terrainPatchGradient(codes, fraction);
  bvec2 back = lessThan(fraction, vec2(0.5));
  ivec2 outer = cell + ivec2(back.x ? -1 : 2, back.y ? -1 : 2);
  vec2 column = vec2(terrainCodeOrNone(ivec2(outer.x, cell.y)),
    terrainCodeOrNone(ivec2(outer.x, cell.y + 1)));
  vec2 row = vec2(terrainCodeOrNone(ivec2(cell.x, outer.y)),
    terrainCodeOrNone(ivec2(cell.x + 1, outer.y)));
  vec2 next = vec2(
    terrainNextSlope(column, back.x ? codes.xz : codes.yw, fraction.y, back.x ? -1.0 : 1.0, own.x),
    terrainNextSlope(row, back.y ? codes.xy : codes.zw, fraction.x, back.y ? -1.0 : 1.0, own.y));
  return mix(own, next, abs(fraction - 0.5));
}

// Code of the texels' surface at a position in texels; negative where there is none.
float terrainTexelHeight(vec2 position)
{
  ivec2 cell = clamp(ivec2(position), ivec2(0), textureSize(terrainHeights, 0) - 2);
  vec4 codes = terrainTexelCodes(cell);
  return terrainCellValid(codes) ? terrainPatchCode(codes, position - vec2(cell)) : -1.0;
}

// Gradient of the texels' surface as the central difference over a width in texels: the mean slope
// along it. Where there are no heights the difference ends at the position.
vec2 terrainWideGradient(vec2 position, float width)
{
  vec2 last = vec2(textureSize(terrainHeights, 0) - 1);
  vec2 low = max(position - 0.5 * width, vec2(0.0));
  vec2 high = min(position + 0.5 * width, last);
  float here = terrainTexelHeight(position);
  vec2 atLow = vec2(terrainTexelHeight(vec2(low.x, position.y)),
    terrainTexelHeight(vec2(position.x, low.y)));
  vec2 atHigh = vec2(terrainTexelHeight(vec2(high.x, position.y)),
    terrainTexelHeight(vec2(position.x, high.y)));
  bvec2 noLow = lessThan(atLow, vec2(0.0));
  bvec2 noHigh = lessThan(atHigh, vec2(0.0));
  vec2 apart = mix(high, position, noHigh) - mix(low, position, noLow);
  return (mix(atHigh, vec2(here), noHigh) - mix(atLow, vec2(here), noLow)) / max(apart, 1e-3);
}

// The same of the means of squares of 2^level texels a side, level >= terrainFirstMeanLevel.
vec2 terrainMeanGradient(vec2 position, float level)
{
  vec2 size = vec2(textureSize(terrainHeights, 0));
  float side = exp2(level);
  vec2 edge = min(vec2(0.5 * side - 0.5), 0.5 * (size - 1.0)); // means end half a square from the border
  vec2 low = clamp(position - 0.5 * side, edge, size - 1.0 - edge);
  vec2 high = clamp(position + 0.5 * side, edge, size - 1.0 - edge);
  float lod = level - terrainFirstMeanLevel;
  vec2 at = (position + 0.5) / size;
  vec2 atLow = (low + 0.5) / size;
  vec2 atHigh = (high + 0.5) / size;
  vec2 difference =
    vec2(textureLod(terrainMeans, vec2(atHigh.x, at.y), lod).r -
        textureLod(terrainMeans, vec2(atLow.x, at.y), lod).r,
      textureLod(terrainMeans, vec2(at.x, atHigh.y), lod).r -
        textureLod(terrainMeans, vec2(at.x, atLow.y), lod).r);
  return terrainMeansScale * difference / max(high - low, 1e-3);
}

// Gradient of the texels' surface over squares of 2^level texels a side; of one texel if level < 0.
vec2 terrainTexelGradient(vec2 position, float level)
{
  vec2 gradient = vec2(0.0);
  if (level < terrainFirstMeanLevel)
  {
    gradient = terrainWideGradient(position, exp2(max(level, 0.0)));
  }
  float means = clamp(level - terrainFirstMeanLevel + 1.0, 0.0, 1.0);
  if (means > 0.0)
  {
    gradient = mix(gradient,
      terrainMeanGradient(position, max(level, terrainFirstMeanLevel)), means);
  }
  return gradient;
}

#ifdef TERRAIN_DETAIL
// Gradient of the detail over squares of 2^level of its cells a side, level >= 0.
vec2 terrainDetailGradient(ivec2 cell, vec2 fraction, float level)
{
  vec2 period = vec2(terrainDetailPeriod);
  vec2 at = (vec2(cell % terrainDetailPeriod) + fraction + 0.5) / period;
  vec2 step = 0.5 * exp2(level) / period;
  vec2 difference = vec2(textureLod(terrainDetail, vec2(at.x + step.x, at.y), level).r -
      textureLod(terrainDetail, vec2(at.x - step.x, at.y), level).r,
    textureLod(terrainDetail, vec2(at.x, at.y + step.y), level).r -
      textureLod(terrainDetail, vec2(at.x, at.y - step.y), level).r);
  return terrainDetailScale * difference * exp2(-level);
}
#endif

// Cells that a pixel is wide at a distance along the viewing direction.
float terrainPixelCells(float distanceVC)
{
  vec2 right = terrainOriginGC[1].xy + distanceVC * terrainDirectionGC[1].xy;
  vec2 up = terrainOriginGC[2].xy + distanceVC * terrainDirectionGC[2].xy;
  return sqrt(max(dot(right, right), dot(up, up)));
}

// Gradient of what a pixel shows of the surface at a distance along the viewing direction. With
// detail it is the sum of both gradients, each over its own cells: the base then shows no creases
// between its patches, as in Balogh's chapter 7.
vec2 terrainGradient(ivec2 cell, vec2 fraction, vec4 codes, float distanceVC)
{
  float level = log2(max(terrainPixelCells(distanceVC), 1e-6));
#ifdef TERRAIN_DETAIL
  float texelWidth = 1.0 / float(1 << terrainDetailLevel);
  vec2 position = (vec2(cell) + fraction) * texelWidth;
  return texelWidth * terrainTexelGradient(position, level - float(terrainDetailLevel)) +
    terrainDetailGradient(cell, fraction, max(level, 0.0));
#else
  vec2 gradient = vec2(0.0);
  if (level < 1.0)
  {
    gradient = terrainSmoothGradient(cell, fraction, codes);
  }
  if (level > 0.0)
  {
    gradient =
      mix(gradient, terrainTexelGradient(vec2(cell) + fraction, level), min(level, 1.0));
  }
  return gradient;
#endif
}
