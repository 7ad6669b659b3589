// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The technique in use. Needs vtkTerrainSearch.glsl or vtkTerrainPyramid.glsl.
// Defines: TERRAIN_LINEAR, TERRAIN_EXPONENTIAL, TERRAIN_EQUIDISTANT or TERRAIN_PYRAMID.

TerrainHit terrainTrace(TerrainRay ray)
{
#if defined(TERRAIN_LINEAR)
  return terrainSearchLinear(ray);
#elif defined(TERRAIN_EXPONENTIAL)
  return terrainSearchExponential(ray);
#elif defined(TERRAIN_EQUIDISTANT)
  return terrainSearchEquidistant(ray);
#else
  return terrainTracePyramid(ray);
#endif
}
