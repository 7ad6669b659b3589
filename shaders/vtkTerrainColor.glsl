// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of the surface: values through a colour map or direct colours, a draped picture,
// hillshade and contour lines, in this order over the material's own colour. Needs
// vtkTerrainSurface.glsl. Defines: TERRAIN_PAINT if there is or was anything but the material's
// colour; TERRAIN_DRAPE with the number of the picture's components; TERRAIN_TEXTURED for textures
// of VTK. All else is chosen by uniforms: to build another program takes as long as several frames.
// Constants: terrainNotANumber, terrainColorMapSize and the kinds of colours, terrainOfMaterial to
// terrainOfCrossings (src/core/rays/PaintKinds.h).
//
// Twins in src/core/: rays/SurfaceColors.h, rays/SurfaceShading.h.

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

// How the grid position, in cells, changes from a pixel to the next: in x, in y. On the tangent
// plane of the surface, whose gradient is in codes per cell. Unlike differences between pixels it
// does not see what lies behind a silhouette.
mat2 terrainFootprint(vec2 pixel, TerrainSurface surface)
{
  float s = -surface.positionVC.z;
  vec2 pace = terrainPlanePace(pixel, s, surface.gradient);
  vec3 direction = terrainAtPixelGC(pixel);
  return mat2(
    terrainToCells(terrainOriginGC[1] + s * terrainDirectionGC[1] + pace.x * direction).xy,
    terrainToCells(terrainOriginGC[2] + s * terrainDirectionGC[2] + pace.y * direction).xy);
}

#ifdef TERRAIN_TEXTURED
// Texture coordinates: 0 at the first sample, 1 at the last.
vec2 terrainTexturePosition(TerrainSurface surface)
{
  return (vec2(surface.cell) + surface.fraction) / vec2(terrainSize - 1);
}

// How texture coordinates change from a pixel to the next, in x, in y.
mat2 terrainTextureFootprint(vec2 pixel, TerrainSurface surface)
{
  mat2 footprint = terrainFootprint(pixel, surface);
  vec2 cells = vec2(terrainSize - 1);
  return mat2(footprint[0] / cells, footprint[1] / cells);
}
#endif

#ifdef TERRAIN_PAINT
uniform int terrainColorKind;         // one of the constants terrainOf...
uniform sampler2D terrainValues;      // of samples or cells, less the offset
uniform sampler2D terrainColors;      // RGBA of samples or cells
uniform ivec2 terrainArrayTexels;     // a place's: 4 of samples, 1 of cells, 0 of none
uniform vec2 terrainGradientScale;    // codes per cell to heights per length, not exaggerated
uniform sampler2D terrainColorMap;    // colours over the range
uniform vec4 terrainSpecialColors[3]; // below the range, above it, not a number
uniform vec2 terrainValueScale;       // value = x * the number that terrainMapColor() takes + y
uniform vec2 terrainColorScale;       // position in the map, 0..1 = x * that number + y
uniform int terrainColorLogarithm;    // 1 if it is x * logarithm of the value + y instead
uniform float terrainMaximumShownCrossings; // work, see TerrainHit, that is red; > 0

// Weight of a corner, 0 or 1 each way, in bilinear interpolation.
float terrainCornerWeight(ivec2 corner, vec2 fraction)
{
  vec2 weights = mix(1.0 - fraction, fraction, vec2(corner));
  return weights.x * weights.y;
}

// Value, less the offset, and colour of an array of samples or cells at a point; terrainNotANumber
// if one of the samples has no value.
float terrainArrayValue(TerrainSurface surface, out vec4 color)
{
  vec2 fraction;
  ivec2 cell = terrainArrayCell(surface, fraction);
  fraction = terrainArrayTexels.x + terrainArrayTexels.y == 1 ? vec2(0.0) : fraction;
  float value = 0.0;
  for (int k = 0; k < terrainArrayTexels.x; ++k)
  {
    ivec2 corner = ivec2(k & 1, k >> 1);
    float texel = texelFetch(terrainValues, cell + corner, 0).r;
    bool valid = min(texel, value) > 0.5 * terrainNotANumber;
    value = valid ? value + terrainCornerWeight(corner, fraction) * texel : terrainNotANumber;
  }
  color = vec4(0.0);
  for (int k = 0; k < terrainArrayTexels.y; ++k)
  {
    ivec2 corner = ivec2(k & 1, k >> 1);
    color += terrainCornerWeight(corner, fraction) * texelFetch(terrainColors, cell + corner, 0);
  }
  return value;
}

// Heights per unit of length east and north, not exaggerated.
vec2 terrainSteepness(TerrainSurface surface)
{
#ifdef TERRAIN_GLOBE
  return terrainGradientScale * terrainCellsPerMetre() * surface.gradient;
#else
  return terrainGradientScale * surface.gradient;
#endif
}

// Degrees from the horizontal, 0 to 90.
float terrainSlope(TerrainSurface surface)
{
  return degrees(atan(length(terrainSteepness(surface))));
}

// Direction downhill, degrees clockwise from the grid's north, 0 to 360; not a number where it is
// level.
float terrainAspect(TerrainSurface surface)
{
  vec2 down = -terrainSteepness(surface);
  float aspect = degrees(atan(down.x, down.y));
  return length(down) < 1e-6 ? terrainNotANumber : aspect < 0.0 ? aspect + 360.0 : aspect;
}

// Colour of a number: a height code, or a slope, aspect or value in its own unit. Exact but for the
// map's terrainColorMapSize texels.
vec4 terrainMapColor(float value)
{
  float logarithm = log(max(terrainValueScale.x * value + terrainValueScale.y, 1e-37));
  float t = terrainColorScale.x * (terrainColorLogarithm == 1 ? logarithm : value) +
    terrainColorScale.y;
  int texel = clamp(int(t * float(terrainColorMapSize)), 0, terrainColorMapSize - 1);
  vec4 color = texelFetch(terrainColorMap, ivec2(texel, 0), 0);
  color = t < -1e-6 ? terrainSpecialColors[0] : t > 1.0 + 1e-6 ? terrainSpecialColors[1] : color;
  return value < 0.5 * terrainNotANumber ? terrainSpecialColors[2] : color;
}

// Colour of work (see TerrainHit), >= 0: blue for none over green to red for
// terrainMaximumShownCrossings and above.
vec4 terrainCrossingsColor(int crossings)
{
  float work = clamp(float(crossings) / terrainMaximumShownCrossings, 0.0, 1.0);
  return vec4(clamp(vec3(2.0 - abs(4.0 * work - 4.0), 2.0 - abs(4.0 * work - 2.0),
                      2.0 - abs(4.0 * work)), 0.0, 1.0), 1.0);
}

// The number that colours are made of, as terrainMapColor() takes it, and the colour of an array of
// colours.
float terrainOwnValue(TerrainSurface surface, out vec4 arrayColor)
{
  float arrayValue = terrainArrayValue(surface, arrayColor);
  float value = surface.code;
  value = terrainColorKind == terrainOfSlope ? terrainSlope(surface) : value;
  value = terrainColorKind == terrainOfAspect ? terrainAspect(surface) : value;
  return terrainColorKind == terrainOfValues ? arrayValue : value;
}

// The value that this number stands for, in its own unit; NaN for none.
float terrainShownValue(TerrainSurface surface)
{
  vec4 arrayColor;
  float value = terrainOwnValue(surface, arrayColor);
  return value < 0.5 * terrainNotANumber ? log(-1.0)
                                         : terrainValueScale.x * value + terrainValueScale.y;
}

// The surface's own colour; of one that shows the material's, nothing: black, alpha 1.
vec4 terrainOwnColor(TerrainSurface surface)
{
  vec4 arrayColor;
  vec4 color = terrainMapColor(terrainOwnValue(surface, arrayColor));
  color = terrainColorKind == terrainOfColors ? arrayColor : color;
  color = terrainColorKind == terrainOfMaterial ? vec4(0.0, 0.0, 0.0, 1.0) : color;
  return terrainColorKind == terrainOfCrossings ? terrainCrossingsColor(surface.crossings) : color;
}

#ifdef TERRAIN_DRAPE
uniform sampler2D terrainDrape;
uniform vec4 terrainDrapeScale;    // texture coordinates = xy * position in cells + zw

// Colour of the picture, multiplied by its alpha; 0 beside it, and as much of it at its border as
// the pixel covers. Where the picture ends with the terrain or beyond it, it has no border: walls
// of blocks stand there.
vec4 terrainDrapeColor(vec2 pixel, TerrainSurface surface)
{
  vec2 positionTC = terrainDrapeScale.xy * vec2(surface.cell) + terrainDrapeScale.zw +
    terrainDrapeScale.xy * surface.fraction;
  mat2 footprint = terrainFootprint(pixel, surface);
  vec2 moveX = terrainDrapeScale.xy * footprint[0];
  vec2 moveY = terrainDrapeScale.xy * footprint[1];
  vec4 texel = textureGrad(terrainDrape, positionTC, moveX, moveY);
#if TERRAIN_DRAPE == 1
  texel = vec4(texel.rrr, 1.0);
#elif TERRAIN_DRAPE == 2
  texel = texel.rrrg;
#elif TERRAIN_DRAPE == 3
  texel.a = 1.0;
#endif
  vec2 width = max(sqrt(moveX * moveX + moveY * moveY), 1e-30);
  vec2 first = terrainDrapeScale.zw; // of the terrain in the picture
  vec2 last = first + terrainDrapeScale.xy * vec2(terrainSize - 1);
  vec2 low = mix(positionTC / width + 0.5, vec2(1.0), greaterThan(min(first, last), vec2(-1e-6)));
  vec2 high =
    mix((1.0 - positionTC) / width + 0.5, vec2(1.0), lessThan(max(first, last), vec2(1.0 + 1e-6)));
  vec2 coverage = clamp(min(low, high), 0.0, 1.0);
  return coverage.x * coverage.y * texel;
}
#endif

uniform vec3 terrainSunDirection;  // to the sun: east, north, up; length 1
uniform float terrainShadeRelief;  // exaggeration
uniform float terrainShadeStrength; // 1, or 0 for none

// Cosine of the angle between the surface's normal and the sun, 0..1; 1 without hillshade.
float terrainHillshade(TerrainSurface surface)
{
  vec2 slope = terrainShadeRelief * terrainSteepness(surface);
  float shade = max(dot(normalize(vec3(-slope, 1.0)), terrainSunDirection), 0.0);
  return mix(1.0, shade, terrainShadeStrength);
}

uniform vec2 terrainContourScale;  // number of the contour = x * code + y
uniform float terrainContourWidth; // pixels
uniform float terrainContourIndex; // every n-th line is twice as wide; 0 for none
uniform vec4 terrainContourColor;  // alpha 0 for none

// How much of a pixel, 0..1, a line covers that is so far away, one of many; in pixels. Lines fade
// where their spacing is less than twice (their width + 1); at half of that there are none.
float terrainLineCoverage(float distance, float spacing, float width)
{
  float line = clamp(min(0.5 * width + 0.5 - distance, width), 0.0, 1.0);
  return line * clamp(spacing / (width + 1.0) - 1.0, 0.0, 1.0);
}

// How much of a pixel, 0..1, contour lines cover. Where they crowd, those between the index lines
// fade first, as on maps; slopes that turn away have no dark border.
float terrainContourCoverage(vec2 pixel, TerrainSurface surface)
{
  mat2 footprint = terrainFootprint(pixel, surface);
  float change = terrainContourScale.x *
    length(vec2(dot(surface.gradient, footprint[0]), dot(surface.gradient, footprint[1])));
  float spacing = 1.0 / max(change, 1e-6);
  float number = terrainContourScale.x * surface.code + terrainContourScale.y;
  float nearest = floor(number + 0.5);
  float index = terrainContourIndex;
  float group = index * floor(number / max(index, 1.0) + 0.5);
  float lines =
    terrainLineCoverage(spacing * abs(number - nearest), spacing, terrainContourWidth);
  float indexLines = terrainLineCoverage(
    spacing * abs(number - group), spacing * index, 2.0 * terrainContourWidth);
  bool isIndex = index > 0.0 && abs(nearest - group) < 0.5;
  lines = max(isIndex ? 0.0 : lines, index > 0.0 ? indexLines : 0.0);
  return change < 1e-6 ? 0.0 : lines;
}

// What the surface's colour, a draped picture, hillshade and contour lines make of the material's
// colour at a pixel.
TerrainPaint terrainPaintSurface(vec2 pixel, TerrainSurface surface)
{
  vec4 color = terrainOwnColor(surface);
  TerrainPaint paint =
    TerrainPaint(color.rgb, terrainColorKind == terrainOfMaterial ? 1.0 : 0.0, color.a);
#ifdef TERRAIN_DRAPE
  vec4 drape = terrainDrapeColor(pixel, surface);
  paint = terrainOver(paint, drape.rgb / max(drape.a, 1e-6), drape.a);
#endif
  float shade = terrainHillshade(surface);
  paint = TerrainPaint(shade * paint.add, shade * paint.keep, paint.alpha);
  // the faces that cut a block have none: their heights run down, not along the surface
  float lines = surface.cut ? 0.0 : terrainContourCoverage(pixel, surface);
  return terrainOver(paint, terrainContourColor.rgb, terrainContourColor.a * lines);
}

// Paints over the material's colours, which VTK's lights then shade; intensities: those of the
// property.
void terrainPaintMaterial(vec2 pixel, TerrainSurface surface, float ambientIntensity,
  float diffuseIntensity, inout vec3 ambientColor, inout vec3 diffuseColor, inout float opacity)
{
  TerrainPaint paint = terrainPaintSurface(pixel, surface);
  ambientColor = ambientIntensity * paint.add + paint.keep * ambientColor;
  diffuseColor = diffuseIntensity * paint.add + paint.keep * diffuseColor;
  opacity *= paint.alpha;
}
#endif
