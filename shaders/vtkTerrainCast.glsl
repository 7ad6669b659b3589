// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the ray of a pixel sees: clips the ray, traces it, passes by what is culled.
// Needs vtkTerrainHeights.glsl, vtkTerrainRay.glsl, vtkTerrainView.glsl, vtkTerrainTrace.glsl.
// Defines: TERRAIN_CULL_FRONT, TERRAIN_CULL_BACK if hits from above, from below are to be passed
// by; TERRAIN_BEAM_PIXELS if starts of tiles of so many pixels each way are there
// (vtkTerrainBeamCS.glsl).

uniform int terrainClipPlaneCount;
uniform vec4 terrainClipPlanesVC[6]; // kept is dot(plane, position) >= 0

#ifdef TERRAIN_BEAM_PIXELS
uniform sampler2D terrainBeamStarts;

// Distance before which no ray of the pixel's tile meets the surface.
float terrainSafeStart(vec2 pixel)
{
  return texelFetch(
    terrainBeamStarts, (ivec2(pixel) - terrainViewportOrigin) / TERRAIN_BEAM_PIXELS, 0).r;
}
#else
float terrainSafeStart(vec2 pixel)
{
  return terrainNear;
}
#endif

// The first point of the surface on a pixel's ray.
struct TerrainSighting
{
  bool found;
  float distanceVC;  // along the viewing direction
  ivec2 cell;
  vec2 fraction;     // position in the cell, 0..1
  bool front;        // seen from above
  int crossings;     // work done, see TerrainHit
};

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

// Cells that a ray may be long before what float rounds along it counts: a ray whose hit lies
// farther is traced again from near the hit.
const float terrainLongRay = 256.0;

// The first hit of a pixel's ray between two distances; hit.s counts from range.x. The loop is there
// so that the trace stands in the program once.
TerrainHit terrainTraceRange(vec2 pixel, vec2 range, out bool front)
{
  TerrainHit hit = terrainNoHit();
  vec3 direction = terrainAtPixelGC(pixel);
  float pace = length(direction.xy);
  float begin = 0.0;
  bool again = true;
  for (int attempt = 0; again && attempt < 2; ++attempt)
  {
    TerrainHit next = terrainTrace(terrainPixelRay(pixel, range.x + begin, range.y));
    next.crossings += hit.crossings;
    next.s += begin;
    if (next.found || attempt == 0)
    {
      hit = next;
    }
    again = hit.found && (hit.s - begin) * pace > terrainLongRay;
    begin = hit.s - 4.0 / max(pace, 1e-30);
  }
  vec2 gradient = terrainPatchGradient(terrainCellCodes(hit.cell), hit.fraction);
  front = direction.z <= dot(gradient, direction.xy);
  return hit;
}

// What the ray of a pixel sees from a distance on.
TerrainSighting terrainCast(vec2 pixel, float entryDistance)
{
  float start = max(max(entryDistance, terrainNear), terrainSafeStart(pixel));
  vec2 range = terrainEnterBox(pixel, vec2(start, terrainFar));
  range = terrainClipRange(pixel, range);
  TerrainSighting sighting;
  sighting.found = false;
  sighting.crossings = 0;
  while (range.x < range.y)
  {
    bool front;
    TerrainHit hit = terrainTraceRange(pixel, range, front);
    sighting = TerrainSighting(hit.found, range.x + hit.s, hit.cell, hit.fraction, front,
      sighting.crossings + hit.crossings);
#ifdef TERRAIN_CULL_FRONT
    bool culled = hit.found && front;
#else
    bool culled = false;
#endif
#ifdef TERRAIN_CULL_BACK
    culled = culled || (hit.found && !front);
#endif
    if (!culled)
    {
      break;
    }
    // on from behind the hit: by a hundredth of a cell, and by what float can tell
    float pace = 0.01 / max(length(terrainAtPixelGC(pixel).xy), 1e-30);
    range.x += hit.s + max(pace, 1e-6 * sighting.distanceVC);
    sighting.found = false;
  }
  return sighting;
}
