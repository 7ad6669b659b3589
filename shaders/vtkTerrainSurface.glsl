// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point of the surface that a fragment shows: what VTK's lights and colours work on.
// Needs vtkTerrainHeights.glsl, vtkTerrainView.glsl and, for rays, vtkTerrainCast.glsl.
// Defines: TERRAIN_CAST for rays, TERRAIN_MESH for meshes; TERRAIN_BELOW_MESH if rays begin at the
// coarse mesh; TERRAIN_FLAT for the normals of single patches, not of differences across them.

struct TerrainSurface
{
  bool found;
  vec4 positionVC;
  vec3 normalVC;   // unit length, on the side of the viewer
  bool front;      // seen from above
  ivec2 cell;
  vec2 fraction;   // position in the cell, 0..1
  float code;      // height code
  int crossings;   // work done, see TerrainHit
};

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

// Gradient in codes per cell as the central difference of the surface over the width of one cell:
// continuous everywhere, and the gradient of the patch at the centre of a cell. At borders and next
// to cells without heights the difference stays within the cell.
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

TerrainSurface terrainSurfaceAt(ivec2 cell, vec2 fraction, vec4 positionVC, bool front)
{
  vec4 codes = terrainCellCodes(cell);
#ifdef TERRAIN_FLAT
  vec3 normalVC = terrainNormalVC(terrainPatchGradient(codes, fraction));
#else
  vec3 normalVC = terrainNormalVC(terrainSmoothGradient(cell, fraction, codes));
#endif
  return TerrainSurface(true, positionVC, front ? normalVC : -normalVC, front, cell, fraction,
    terrainPatchCode(codes, fraction), 0);
}

#ifdef TERRAIN_CAST
#if defined(TERRAIN_BELOW_MESH) && defined(GL_ARB_conservative_depth)
layout(depth_greater) out float gl_FragDepth; // the hit lies behind the proxy
#endif

// Distance at which the ray of a fragment of the proxy begins. At the coarse mesh that is a little
// before the fragment, by what interpolation rounds.
float terrainEntry(vec4 proxyVC)
{
#ifdef TERRAIN_BELOW_MESH
  return -proxyVC.z - 1e-5 * abs(proxyVC.z);
#else
  return terrainNear;
#endif
}

// Depth of a hit. Early depth tests with depth_greater need it behind the fragment, rounding
// included.
float terrainFragmentDepth(vec4 positionVC, float fragmentDepth)
{
#ifdef TERRAIN_BELOW_MESH
  return max(terrainDepth(positionVC), fragmentDepth);
#else
  return terrainDepth(positionVC);
#endif
}

// The point of the surface on the ray of a pixel.
TerrainSurface terrainSeen(vec2 pixel, vec4 proxyVC)
{
#ifdef TERRAIN_READ_SIGHTINGS
  TerrainSighting sighting = terrainReadSighting(pixel);
#else
  TerrainSighting sighting = terrainCast(pixel, terrainEntry(proxyVC));
#endif
  TerrainSurface surface;
  surface.found = sighting.found;
  if (sighting.found)
  {
    surface = terrainSurfaceAt(sighting.cell, sighting.fraction,
      terrainPositionVC(pixel, sighting.distanceVC), sighting.front);
  }
  surface.crossings = sighting.crossings;
  return surface;
}
#endif

#ifdef TERRAIN_MESH
uniform mat4 terrainViewToGrid; // view to grid coordinates

// The point of the surface below a point of a mesh, of which the front or the back is seen.
TerrainSurface terrainBelow(vec4 positionVC, bool front)
{
  vec2 positionGC = (terrainViewToGrid * positionVC).xy;
  ivec2 cell = clamp(ivec2(floor(positionGC)), ivec2(0), terrainSize - 2);
  return terrainSurfaceAt(cell, clamp(positionGC - vec2(cell), 0.0, 1.0), positionVC, front);
}
#endif
