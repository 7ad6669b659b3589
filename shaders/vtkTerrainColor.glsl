// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of the surface: values through a colour map or direct colours, a draped picture, hillshade
// and contour lines, in this order over the material's own colour. Needs vtkTerrainSurface.glsl.
// Defines: TERRAIN_SHOW_CROSSINGS, which leaves out all else; one of TERRAIN_VALUE_POINTS,
// TERRAIN_VALUE_CELLS, TERRAIN_VALUE_HEIGHT, TERRAIN_VALUE_SLOPE, TERRAIN_VALUE_ASPECT for the colour
// map, or TERRAIN_DIRECT_POINTS, TERRAIN_DIRECT_CELLS; TERRAIN_DRAPE with the number of its
// components; TERRAIN_HILLSHADE; TERRAIN_CONTOURS; TERRAIN_TEXTURED for textures of VTK.

// What the surface's colours make of the material's: add + keep * colour; opacity times alpha.
struct TerrainPaint
{
  vec3 add;
  float keep;
  float alpha;
};

// Lays a colour over a paint; coverage 0..1.
TerrainPaint terrainOver(TerrainPaint paint, vec3 color, float coverage)
{
  return TerrainPaint(mix(paint.add, color, coverage), (1.0 - coverage) * paint.keep,
    mix(paint.alpha, 1.0, coverage));
}

// How the grid position, in cells, changes from a pixel to the next: in x, in y. On the tangent plane
// of the surface, whose gradient is in codes per cell. Unlike differences between pixels it does not
// see what lies behind a silhouette.
mat2 terrainFootprint(vec2 pixel, TerrainSurface surface)
{
  float s = -surface.positionVC.z;
  vec2 pace = terrainPlanePace(pixel, s, surface.gradient);
  vec2 direction = terrainAtPixelGC(pixel).xy;
  return mat2(terrainOriginGC[1].xy + s * terrainDirectionGC[1].xy + pace.x * direction,
    terrainOriginGC[2].xy + s * terrainDirectionGC[2].xy + pace.y * direction);
}

#ifdef TERRAIN_TEXTURED
// Texture coordinates: 0 at the first sample, 1 at the last.
vec2 terrainTexturePosition(TerrainSurface surface)
{
  return (vec2(surface.cell) + surface.fraction) / vec2(terrainSize - 1);
}

// How they change from a pixel to the next, in x, in y.
mat2 terrainTextureFootprint(vec2 pixel, TerrainSurface surface)
{
  mat2 footprint = terrainFootprint(pixel, surface);
  vec2 cells = vec2(terrainSize - 1);
  return mat2(footprint[0] / cells, footprint[1] / cells);
}
#endif

#if defined(TERRAIN_VALUE_POINTS) || defined(TERRAIN_VALUE_CELLS)
uniform sampler2D terrainValues;   // of samples or cells, less the offset
#endif

#if defined(TERRAIN_DIRECT_POINTS) || defined(TERRAIN_DIRECT_CELLS)
uniform sampler2D terrainColors;   // RGBA of samples or cells
#endif

#if defined(TERRAIN_VALUE_SLOPE) || defined(TERRAIN_VALUE_ASPECT) || defined(TERRAIN_HILLSHADE)
uniform vec2 terrainGradientScale; // codes per cell to heights per unit of length, without exaggeration
#endif

const float terrainNotANumber = -3e38;

#if defined(TERRAIN_VALUE_POINTS)
#define TERRAIN_VALUE
float terrainValue(TerrainSurface surface)
{
  vec2 fraction;
  ivec2 cell = terrainArrayCell(surface, fraction);
  vec4 corners = vec4(texelFetch(terrainValues, cell, 0).r,
    texelFetch(terrainValues, cell + ivec2(1, 0), 0).r,
    texelFetch(terrainValues, cell + ivec2(0, 1), 0).r,
    texelFetch(terrainValues, cell + ivec2(1, 1), 0).r);
  bool valid = all(greaterThan(corners, vec4(0.5 * terrainNotANumber)));
  return valid ? terrainPatchCode(corners, fraction) : terrainNotANumber;
}
#elif defined(TERRAIN_VALUE_CELLS)
#define TERRAIN_VALUE
float terrainValue(TerrainSurface surface)
{
  vec2 fraction;
  return texelFetch(terrainValues, terrainArrayCell(surface, fraction), 0).r;
}
#elif defined(TERRAIN_VALUE_HEIGHT)
#define TERRAIN_VALUE
float terrainValue(TerrainSurface surface)
{
  return surface.code;
}
#elif defined(TERRAIN_VALUE_SLOPE)
#define TERRAIN_VALUE
// Degrees from the horizontal, 0 to 90.
float terrainValue(TerrainSurface surface)
{
  return degrees(atan(length(terrainGradientScale * surface.gradient)));
}
#elif defined(TERRAIN_VALUE_ASPECT)
#define TERRAIN_VALUE
// Direction downhill, degrees clockwise from the grid's north, 0 to 360; not a number where it is level.
float terrainValue(TerrainSurface surface)
{
  vec2 down = -terrainGradientScale * surface.gradient;
  float aspect = degrees(atan(down.x, down.y));
  return length(down) < 1e-6 ? terrainNotANumber : aspect < 0.0 ? aspect + 360.0 : aspect;
}
#endif

#ifdef TERRAIN_VALUE
uniform sampler2D terrainColorMap;      // colours over the range
uniform vec4 terrainSpecialColors[3];   // below the range, above it, not a number
uniform vec2 terrainValueScale;         // value = x * terrainValue() + y
uniform vec2 terrainColorScale;         // position in the map, 0..1 = x * value + y
uniform int terrainColorLogarithm;      // 1 if it is the value's logarithm that is mapped

vec4 terrainMapColor(float value)
{
  float scaled = terrainValueScale.x * value + terrainValueScale.y;
  scaled = terrainColorLogarithm == 1 ? log(max(scaled, 1e-37)) : scaled;
  float t = terrainColorScale.x * scaled + terrainColorScale.y;
  int size = textureSize(terrainColorMap, 0).x;
  vec4 color =
    texelFetch(terrainColorMap, ivec2(clamp(int(t * float(size)), 0, size - 1), 0), 0);
  color = t < -1e-6 ? terrainSpecialColors[0] : t > 1.0 + 1e-6 ? terrainSpecialColors[1] : color;
  return value < 0.5 * terrainNotANumber ? terrainSpecialColors[2] : color;
}
#endif

#if defined(TERRAIN_DIRECT_POINTS)
vec4 terrainDirectColor(TerrainSurface surface)
{
  vec2 fraction;
  ivec2 cell = terrainArrayCell(surface, fraction);
  vec4 south = mix(texelFetch(terrainColors, cell, 0),
    texelFetch(terrainColors, cell + ivec2(1, 0), 0), fraction.x);
  vec4 north = mix(texelFetch(terrainColors, cell + ivec2(0, 1), 0),
    texelFetch(terrainColors, cell + ivec2(1, 1), 0), fraction.x);
  return mix(south, north, fraction.y);
}
#elif defined(TERRAIN_DIRECT_CELLS)
vec4 terrainDirectColor(TerrainSurface surface)
{
  vec2 fraction;
  return texelFetch(terrainColors, terrainArrayCell(surface, fraction), 0);
}
#endif

#ifdef TERRAIN_DRAPE
uniform sampler2D terrainDrape;
uniform vec4 terrainDrapeScale;    // texture coordinates = xy * position in cells + zw

// Colour of the picture, multiplied by its alpha; 0 beside it.
vec4 terrainDrapeColor(vec2 pixel, TerrainSurface surface)
{
  vec2 positionTC = terrainDrapeScale.xy * vec2(surface.cell) + terrainDrapeScale.zw +
    terrainDrapeScale.xy * surface.fraction;
  mat2 footprint = terrainFootprint(pixel, surface);
  vec4 texel = textureGrad(terrainDrape, positionTC, terrainDrapeScale.xy * footprint[0],
    terrainDrapeScale.xy * footprint[1]);
#if TERRAIN_DRAPE == 1
  texel = vec4(texel.rrr, 1.0);
#elif TERRAIN_DRAPE == 2
  texel = texel.rrrg;
#elif TERRAIN_DRAPE == 3
  texel.a = 1.0;
#endif
  bool beside = any(lessThan(positionTC, vec2(0.0))) || any(greaterThan(positionTC, vec2(1.0)));
  return beside ? vec4(0.0) : texel;
}
#endif

#ifdef TERRAIN_HILLSHADE
uniform vec3 terrainSunDirection;  // to the sun: east, north, up; length 1
uniform float terrainShadeRelief;  // exaggeration

// Cosine of the angle between the surface's normal and the sun, 0..1.
float terrainHillshade(TerrainSurface surface)
{
  vec2 slope = terrainShadeRelief * terrainGradientScale * surface.gradient;
  return max(dot(normalize(vec3(-slope, 1.0)), terrainSunDirection), 0.0);
}
#endif

#ifdef TERRAIN_CONTOURS
uniform vec2 terrainContourScale;  // number of the contour = x * code + y
uniform float terrainContourWidth; // pixels
uniform vec4 terrainContourColor;

// How much of a pixel contour lines cover. Lines closer than their width run into an even grey.
float terrainContourCoverage(vec2 pixel, TerrainSurface surface)
{
  mat2 footprint = terrainFootprint(pixel, surface);
  float change = terrainContourScale.x *
    length(vec2(dot(surface.gradient, footprint[0]), dot(surface.gradient, footprint[1])));
  float number = terrainContourScale.x * surface.code + terrainContourScale.y;
  float distancePixels = abs(number - floor(number + 0.5)) / max(change, 1e-6);
  float line = clamp(0.5 * terrainContourWidth + 0.5 - distancePixels, 0.0, 1.0);
  float even = terrainContourWidth * change;
  return change < 1e-6 ? 0.0 : mix(line, min(even, 1.0), clamp(2.0 * even - 1.0, 0.0, 1.0));
}
#endif

#ifdef TERRAIN_SHOW_CROSSINGS
uniform float terrainMaximumShownCrossings;

// Blue for no work over green to red for the largest number and above.
TerrainPaint terrainPaintSurface(vec2 pixel, TerrainSurface surface)
{
  float work = clamp(float(surface.crossings) / terrainMaximumShownCrossings, 0.0, 1.0);
  return TerrainPaint(clamp(vec3(2.0 - abs(4.0 * work - 4.0), 2.0 - abs(4.0 * work - 2.0),
    2.0 - abs(4.0 * work)), 0.0, 1.0), 0.0, 1.0);
}
#else
TerrainPaint terrainPaintSurface(vec2 pixel, TerrainSurface surface)
{
  TerrainPaint paint = TerrainPaint(vec3(0.0), 1.0, 1.0);
#if defined(TERRAIN_VALUE)
  vec4 color = terrainMapColor(terrainValue(surface));
  paint = TerrainPaint(color.rgb, 0.0, color.a);
#elif defined(TERRAIN_DIRECT_POINTS) || defined(TERRAIN_DIRECT_CELLS)
  vec4 color = terrainDirectColor(surface);
  paint = TerrainPaint(color.rgb, 0.0, color.a);
#endif
#ifdef TERRAIN_DRAPE
  vec4 drape = terrainDrapeColor(pixel, surface);
  paint = terrainOver(paint, drape.rgb / max(drape.a, 1e-6), drape.a);
#endif
#ifdef TERRAIN_HILLSHADE
  float shade = terrainHillshade(surface);
  paint = TerrainPaint(shade * paint.add, shade * paint.keep, paint.alpha);
#endif
#ifdef TERRAIN_CONTOURS
  paint = terrainOver(paint, terrainContourColor.rgb,
    terrainContourColor.a * terrainContourCoverage(pixel, surface));
#endif
  return paint;
}
#endif
