// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays and hits.
//
// Twins in src/core/: rays/Ray.h, which documents every member.

struct TerrainRay
{
  ivec2 anchorCell;  // cell whose south-west sample is the local origin
  vec3 originGC;     // position at s = 0: cells relative to anchorCell, height codes
  vec3 directionGC;  // change per unit of s
  float sBegin;      // searched are sBegin <= s <= sEnd, distances along the viewing direction
  float sEnd;
  float originLow;   // height codes that float cuts off originGC.z
};

struct TerrainHit
{
  bool found;
  float s;        // distance from the ray's origin
  ivec2 cell;     // the cell that was hit
  vec2 fraction;  // position within it, 0..1
  int crossings;  // nodes visited or samples taken
};

// The hit of a ray that meets nothing, after no work.
TerrainHit terrainNoHit()
{
  return TerrainHit(false, 0.0, ivec2(0), vec2(0.0), 0);
}
