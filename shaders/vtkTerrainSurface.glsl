// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point of the surface that a fragment shows, and how it is found.
// Needs vtkTerrainHeights.glsl, vtkTerrainRay.glsl, vtkTerrainView.glsl and, for rays, a terrainTrace().
// Defines: TERRAIN_FLAT for the normals of single patches, not of differences across them;
// TERRAIN_CULL_FRONT, TERRAIN_CULL_BACK if hits from above, from below are to be passed by.

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

// Slope of the row or column of cells from its corners' codes; that of the cell if the next has none.
float terrainOuterSlope(vec2 outerCodes, vec2 edgeCodes, float across, float direction, float own)
{
  bool valid = all(greaterThanEqual(outerCodes, vec2(0.0)));
  return valid ? direction * (mix(outerCodes.x, outerCodes.y, across) - mix(edgeCodes.x, edgeCodes.y, across))
               : own;
}

// Gradient in codes per cell as the central difference of the surface over one cell's width: continuous
// everywhere, and the gradient of the patch at the centre of a cell. At borders and next to cells without
// data the difference stays within the cell.
vec2 terrainSmoothGradient(ivec2 cell, vec2 fraction, vec4 codes)
{
  vec2 own = terrainPatchGradient(codes, fraction);
  ivec2 direction = ivec2(fraction.x < 0.5 ? -1 : 1, fraction.y < 0.5 ? -1 : 1);
  ivec2 outer = cell + ivec2(fraction.x < 0.5 ? -1 : 2, fraction.y < 0.5 ? -1 : 2);
  bvec2 inside = bvec2(outer.x >= 0 && outer.x < terrainSize.x, outer.y >= 0 && outer.y < terrainSize.y);
  outer = clamp(outer, ivec2(0), terrainSize - 1);
  vec2 column = inside.x
    ? vec2(terrainCode(ivec2(outer.x, cell.y)), terrainCode(ivec2(outer.x, cell.y + 1))) : vec2(-1.0);
  vec2 row = inside.y
    ? vec2(terrainCode(ivec2(cell.x, outer.y)), terrainCode(ivec2(cell.x + 1, outer.y))) : vec2(-1.0);
  vec2 next = vec2(
    terrainOuterSlope(column, direction.x < 0 ? codes.xz : codes.yw, fraction.y, float(direction.x), own.x),
    terrainOuterSlope(row, direction.y < 0 ? codes.xy : codes.zw, fraction.x, float(direction.y), own.y));
  return mix(own, next, abs(fraction - 0.5));
}

TerrainSurface terrainSurfaceAt(ivec2 cell, vec2 fraction, vec4 positionVC, vec3 viewDirectionVC)
{
  vec4 codes = terrainCellCodes(cell);
#ifdef TERRAIN_FLAT
  vec3 normalVC = terrainNormalVC(terrainPatchGradient(codes, fraction));
#else
  vec3 normalVC = terrainNormalVC(terrainSmoothGradient(cell, fraction, codes));
#endif
  bool front = dot(normalVC, viewDirectionVC) <= 0.0;
  return TerrainSurface(true, positionVC, front ? normalVC : -normalVC, front, cell, fraction,
    terrainPatchCode(codes, fraction), 0);
}

#ifdef TERRAIN_CAST
#ifdef TERRAIN_BELOW_MESH
#ifdef GL_ARB_conservative_depth
layout(depth_greater) out float gl_FragDepth; // the hit lies behind the coarse mesh
#endif
#endif

// Distance at which the ray of a fragment of the proxy begins. On the near side of the hull that is a
// little before the fragment, by what interpolation rounds; within the box it is the near plane.
float terrainEntry(vec4 proxyVC)
{
#ifdef TERRAIN_BELOW_MESH
  return -proxyVC.z - 1e-5 * abs(proxyVC.z);
#else
  return terrainNear;
#endif
}

// Depth of a hit. Early depth tests with depth_greater need it behind the fragment, rounding included.
float terrainFragmentDepth(vec4 positionVC, float fragmentDepth)
{
#ifdef TERRAIN_BELOW_MESH
  return max(terrainDepth(positionVC), fragmentDepth);
#else
  return terrainDepth(positionVC);
#endif
}

uniform int terrainClipPlaneCount;
uniform vec4 terrainClipPlanesVC[6]; // kept is dot(plane, position) >= 0

// The part of the distances [range.x, range.y] of a pixel's ray that no clipping plane cuts off.
vec2 terrainClipRange(vec2 pixel, vec2 range)
{
  for (int i = 0; i < terrainClipPlaneCount; ++i)
  {
    float atStart = dot(terrainClipPlanesVC[i], terrainPositionVC(pixel, range.x));
    float atEnd = dot(terrainClipPlanesVC[i], terrainPositionVC(pixel, range.y));
    float crossing = mix(range.x, range.y, atStart / (atStart - atEnd));
    range.x = atStart < 0.0 ? (atEnd < 0.0 ? range.y : crossing) : range.x;
    range.y = atEnd < 0.0 ? (atStart < 0.0 ? range.x : crossing) : range.y;
  }
  return range;
}

// The first point of the surface on the ray of a pixel, from a distance on which it enters the proxy.
TerrainSurface terrainCast(vec2 pixel, float entryDistance)
{
  vec2 range = terrainClipRange(pixel, vec2(max(entryDistance, terrainNear), terrainFar));
  TerrainSurface surface;
  surface.found = false;
  int crossings = 0;
  while (range.x < range.y)
  {
    TerrainRay ray = terrainPixelRay(pixel, range.x, range.y);
    TerrainHit hit = terrainTrace(ray);
    crossings += hit.crossings;
    if (!hit.found)
    {
      break;
    }
    surface = terrainSurfaceAt(hit.cell, hit.fraction, terrainPositionVC(pixel, range.x + hit.s),
      terrainDirectionAt(pixel));
#ifdef TERRAIN_CULL_FRONT
    surface.found = !surface.front;
#endif
#ifdef TERRAIN_CULL_BACK
    surface.found = surface.front;
#endif
#if defined(TERRAIN_CULL_FRONT) || defined(TERRAIN_CULL_BACK)
    if (!surface.found)
    {
      // behind the hit that is culled: a hundredth of a cell, and at least what float can tell
      float pace = 0.01 / max(length(ray.directionGC.xy), 1e-30);
      range.x += hit.s + max(pace, 1e-6 * (range.x + hit.s));
      continue;
    }
#endif
    break;
  }
  surface.crossings = crossings;
  return surface;
}
#endif

#ifdef TERRAIN_MESH
uniform mat4 terrainViewToGrid; // view to grid coordinates

// The point of the surface below a point of a mesh.
TerrainSurface terrainBelow(vec4 positionVC, vec3 viewDirectionVC)
{
  vec2 positionGC = (terrainViewToGrid * positionVC).xy;
  ivec2 cell = clamp(ivec2(floor(positionGC)), ivec2(0), terrainSize - 2);
  return terrainSurfaceAt(
    cell, clamp(positionGC - vec2(cell), 0.0, 1.0), positionVC, viewDirectionVC);
}
#endif
