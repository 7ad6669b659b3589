// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid of a globe about an anchor (src/core/globe/GlobeAnchor.h), and its axes at a place. Grid
// coordinates are metres in the axes of the anchor. Needs vtkTerrainHeights.glsl and
// vtkTerrainView.glsl.
//
// Uniforms to set, see GlobeLines in src/core/globe/GlobeLines.h:
//   terrainGlobeLines   buffer of the columns, then the rows, then the curves
//   terrainGlobeScene   Radius, Axis, Height of the anchor; Curvature
//   terrainGlobeOuter, terrainGlobeInner  the shells; w of the first: Spread
//   terrainGlobeColumn  PerStep, Turn, AnchorFraction
//   terrainGlobeGrid    AnchorCell, Top
//   terrainGlobeJoined  1 if the last column lies on the first
//   terrainGlobeHeights codeScale, codeBase, anchorCode: GlobeTraversal::SetHeights()

uniform samplerBuffer terrainGlobeLines;
uniform vec4 terrainGlobeScene;
uniform vec4 terrainGlobeOuter;
uniform vec4 terrainGlobeInner;
uniform vec4 terrainGlobeColumn;
uniform ivec2 terrainGlobeGrid;
uniform int terrainGlobeJoined;
uniform vec4 terrainGlobeHeights;

// The meridian, the parallel and its curve at a line of samples: src/core/globe/GlobeLines.h.
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

// The point that a pixel shows: from metres to cells and codes about it. Twin of its axes:
// Ellipsoid::ToPosition().
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
