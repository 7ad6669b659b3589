// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid of a globe about an anchor (src/core/globe/GlobeAnchor.h), and its axes at a place. Grid
// coordinates are metres in the axes of the anchor. Needs vtkTerrainHeights.glsl and
// vtkTerrainView.glsl.
//
// Uniforms to set, with their names in GlobeLines in src/core/globe/GlobeLines.h:
//   terrainGlobeLines   buffer of the columns, then the rows, then the curves: a texel each
//   terrainGlobeScene   the anchor's distance from the axis (Radius), over the equator's plane
//                       (Axis), above the ellipsoid (Height), metres; greatest second derivative of
//                       heights along a line (Curvature), 1 / metres
//   terrainGlobeOuter, terrainGlobeInner  shells above and below all heights: 1 / a^2, 1 / b^2 of
//                       their semi-axes, 1 / square metres, and (r / a)^2 + (z / b)^2 - 1 at the
//                       anchor; w of the first: relative difference of the ellipsoid's radii of
//                       curvature (Spread)
//   terrainGlobeColumn  cells a radian (PerStep), cells that go round (Turn), the anchor's position
//                       in its cell, 0..1 (AnchorFraction)
//   terrainGlobeGrid    the anchor's column of cells (AnchorCell), the level whose nodes are less
//                       than a quarter turn wide (Top)
//   terrainGlobeJoined  1 if the last column lies on the first
//   terrainGlobeHeights metres a code (codeScale); height of anchorCode less the anchor's, metres
//                       (codeBase); the code that heights are relative to (anchorCode):
//                       GlobeTraversal::SetHeights()
//
// Twins in src/core/: globe/GlobePixels.h.

uniform samplerBuffer terrainGlobeLines;
uniform vec4 terrainGlobeScene;
uniform vec4 terrainGlobeOuter;
uniform vec4 terrainGlobeInner;
uniform vec4 terrainGlobeColumn;
uniform ivec2 terrainGlobeGrid;
uniform int terrainGlobeJoined;
uniform vec4 terrainGlobeHeights;

// Sine and cosine of the longitude of a column of samples, from the anchor's.
vec2 terrainGlobeColumnAt(int i)
{
  return texelFetch(terrainGlobeLines, i).xy;
}

// Sine and cosine of a parallel's latitude; terrainGlobeNorth() and terrainGlobeAbove() of the
// anchor, metres.
vec4 terrainGlobeRowAt(int j)
{
  return texelFetch(terrainGlobeLines, terrainSize.x + j);
}

// The meridian at a parallel: its radius of curvature and that one's first and second derivative by
// the latitude, metres; cells a radian to the next parallel.
vec4 terrainGlobeCurveAt(int j)
{
  return texelFetch(terrainGlobeLines, terrainSize.x + terrainSize.y + j);
}

// Sets terrainGlobeLocal: from metres to cells and codes about the point that a pixel shows. Cell,
// fraction (0..1) and codes of the cell's corners tell where it is on the grid, positionGC where it
// is about the anchor, metres.
void terrainGlobeSetLocal(ivec2 cell, vec2 fraction, vec4 codes, vec3 positionGC)
{
  vec4 row = terrainGlobeRowAt(cell.y);
  vec4 curve = terrainGlobeCurveAt(cell.y);
  vec2 column = terrainGlobeColumnAt(cell.x);
  // from the lines of the cell by its small angles
  vec2 angle = fraction / vec2(terrainGlobeColumn.x, curve.w);
  vec2 sines = angle * (1.0 - angle * angle / 6.0);
  vec2 cosines = 1.0 - 0.5 * angle * angle;
  vec2 east = vec2(
    column.x * cosines.x + column.y * sines.x, column.y * cosines.x - column.x * sines.x);
  vec2 north = vec2(row.x * cosines.y + row.y * sines.y, row.y * cosines.y - row.x * sines.y);
  float height = terrainGlobeScene.z + terrainGlobeHeights.y +
    terrainGlobeHeights.x * (terrainPatchCode(codes, fraction) - terrainGlobeHeights.z);
  float offAxis = max(length(positionGC.xy + vec2(terrainGlobeScene.x, 0.0)), 1.0);
  terrainGlobeLocal = transpose(mat3(
    terrainGlobeColumn.x / offAxis * vec3(-east.x, east.y, 0.0),
    curve.w / (curve.x + height) * vec3(-north.x * east.y, -north.x * east.x, north.y),
    vec3(north.y * east.y, north.y * east.x, north.x) / terrainGlobeHeights.x));
}
