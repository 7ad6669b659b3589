// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of the surface. Needs vtkTerrainSurface.glsl.
// Defines: TERRAIN_SHOW_CROSSINGS or TERRAIN_COLOR_BY_HEIGHT.

#ifdef TERRAIN_SHOW_CROSSINGS
uniform float terrainMaximumShownCrossings;

// Blue for no work over green to red for the largest number and above.
vec4 terrainSurfaceColor(TerrainSurface surface)
{
  float work = clamp(float(surface.crossings) / terrainMaximumShownCrossings, 0.0, 1.0);
  return vec4(clamp(vec3(2.0 - abs(4.0 * work - 4.0), 2.0 - abs(4.0 * work - 2.0),
    2.0 - abs(4.0 * work)), 0.0, 1.0), 1.0);
}
#endif

#ifdef TERRAIN_COLOR_BY_HEIGHT
uniform sampler2D terrainColorMap;  // colours over 0..1
uniform vec2 terrainColorScale;     // position in the map = x * code + y

vec4 terrainSurfaceColor(TerrainSurface surface)
{
  return textureLod(terrainColorMap,
    vec2(terrainColorScale.x * surface.code + terrainColorScale.y, 0.5), 0.0);
}
#endif
