// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light of an evenly bright sky: the share of it that a point of the surface sees. Needs
// vtkTerrainSurface.glsl. Defines: TERRAIN_SKY if there is such light.
//
// Twins in src/core/: rays/ShadedSurface.h.

uniform sampler2D terrainSky;   // shares, 0..1, over the heights' arrays: src/render/SkyTexture.h
uniform vec2 terrainSkyScale;   // texture coordinates a sample
uniform float terrainSkyLight;  // what the whole sky gives, over a light of intensity 1

// The light of the sky at a point, over a light of intensity 1: on faces that cut a block that of
// half the sky, none from below.
float terrainSkyShare(TerrainSurface surface)
{
  vec2 fraction;
  ivec2 cell = terrainArrayCell(surface, fraction);
  float share = textureLod(terrainSky, (vec2(cell) + fraction + 0.5) * terrainSkyScale, 0.0).r;
  return terrainSkyLight * (surface.cut ? 0.5 : surface.front ? share : 0.0);
}
