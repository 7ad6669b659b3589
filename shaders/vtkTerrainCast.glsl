// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the ray of a pixel sees: clips the ray, traces it, passes by what is culled.
// Needs vtkTerrainHeights.glsl, vtkTerrainRay.glsl, vtkTerrainView.glsl, vtkTerrainTrace.glsl,
// vtkTerrainSighting.glsl and, for columns, vtkTerrainColumns.glsl.
// Processors that run rays side by side run both sides of a branch: defines leave out what a scene
// does not need.
// Defines: TERRAIN_COLUMNS for columns; TERRAIN_BEAM_PIXELS if starts of tiles of so many pixels
// each way are there (vtkTerrainBeamCS.glsl); TERRAIN_CLIP_PLANES and TERRAIN_BLOCK for what cuts
// rays; TERRAIN_WITHIN for a pixel tolerance.
//
// Pixels are those of gl_FragCoord.xy; distances are along the viewing direction, in world units.
//
// Twins in src/core/: rays/PixelCast.h, rays/SurfaceShading.h, surface/Cutting.h.

uniform int terrainLayer;    // surfaces that the ray passes by
uniform ivec2 terrainCulled; // 1 if hits from above, from below are passed by

#ifdef TERRAIN_BEAM_PIXELS
uniform sampler2D terrainBeamStarts; // a distance a tile of pixels: vtkTerrainBeamCS.glsl

// Distance before which no ray of the pixel's tile meets the surface.
float terrainSafeStart(vec2 pixel)
{
  return texelFetch(
    terrainBeamStarts, (ivec2(pixel) - terrainViewportOrigin) / TERRAIN_BEAM_PIXELS, 0).r;
}
#else
// Likewise where no starts of tiles are known: where all rays begin.
float terrainSafeStart(vec2 pixel)
{
  return terrainBegin;
}
#endif

#ifdef TERRAIN_CLIP_PLANES
// The part of the distances [range.x, range.y] of a pixel's ray that no clipping plane cuts off,
// and the plane at which it begins, or -1. Nothing is left if range.x >= range.y.
vec2 terrainClipRange(vec2 pixel, vec2 range, out int begin)
{
  begin = -1;
  for (int i = 0; i < terrainClipPlaneCount; ++i)
  {
    float atStart = dot(terrainClipPlanesVC[i], terrainPositionVC(pixel, range.x));
    float atEnd = dot(terrainClipPlanesVC[i], terrainPositionVC(pixel, range.y));
    float crossing = mix(range.x, range.y, atStart / (atStart - atEnd));
    begin = atStart < 0.0 ? i : begin;
    range.x = atStart < 0.0 ? (atEnd < 0.0 ? range.y : crossing) : range.x;
    range.y = atEnd < 0.0 ? (atStart < 0.0 ? range.x : crossing) : range.y;
  }
  return range;
}
#endif

// Cells that a ray may be long before what float rounds along it counts: a ray whose hit lies
// farther is traced again from near the hit.
const float terrainLongRay = 256.0;

// True if a ray meets the surface of a cell, whose corners have these codes, from above. Where a
// tolerance has ended the search before the surface, a ray above it does so, too; and so does one
// below it that falls more than the surface: it has come in under the border of the grid or of a
// hole, and does not see the underside.
bool terrainSeesFront(TerrainRay ray, TerrainHit hit, vec4 codes)
{
#ifdef TERRAIN_COLUMNS
  return terrainFindColumnFace(codes, hit.fraction, ray.directionGC).front;
#else
  bool front = ray.directionGC.z <=
    dot(terrainPatchGradient(codes, hit.fraction), ray.directionGC.xy);
#ifdef TERRAIN_WITHIN
  float above =
    ray.originGC.z + hit.s * ray.directionGC.z - terrainPatchCode(codes, hit.fraction);
  float rounding = 1e-5 * (terrainMaximumCode + abs(ray.originGC.z));
  front = front || above > rounding;
#endif
  return front;
#endif
}

// The first hit of a pixel's ray between two distances, whether it is seen from above, and the
// codes of its cell's corners; hit.s counts from range.x. The loop is there so that the trace
// stands in the program once.
TerrainHit terrainTraceRange(vec2 pixel, vec2 range, out bool front, out vec4 codes)
{
#ifdef TERRAIN_GLOBE
  return terrainGlobeTraceRange(pixel, range, front, codes);
#else
  TerrainHit hit = terrainNoHit();
  float pace = length(terrainAtPixelGC(pixel).xy);
  float begin = 0.0;
  bool again = false;
  front = true;
  codes = vec4(0.0);
  bool first = true;
  // The loop tests at its end: processors that run both sides of a branch then do no round in vain.
  do
  {
    float start = range.x + begin;
    TerrainRay ray = terrainPixelRay(pixel, start, range.y);
    TerrainHit next = terrainTrace(ray, start);
    next.crossings += hit.crossings;
    if (next.found || first)
    {
      hit = next;
      hit.s += begin;
      codes = terrainCellCodes(next.cell);
      front = terrainSeesFront(ray, next, codes);
    }
#if defined(TERRAIN_LINEAR) || defined(TERRAIN_EXPONENTIAL)
    again = false; // steps depend on where they begin
#else
    again = first && hit.found && (hit.s - begin) * pace > terrainLongRay;
#endif
    begin = hit.s - 4.0 / max(pace, 1e-30);
    first = false;
  } while (again);
  return hit;
#endif
}

#ifdef TERRAIN_BLOCK
// True if a pixel's ray is below the surface at a distance: within the block. Cell, fraction (0..1)
// and codes of the cell's corners are those of the place where it is.
bool terrainIsWithinBlock(
  vec2 pixel, float distanceVC, out ivec2 cell, out vec2 fraction, out vec4 codes)
{
  TerrainRay ray = terrainPixelRay(pixel, distanceVC, distanceVC);
  ivec2 step = ivec2(floor(ray.originGC.xy));
  cell = clamp(ray.anchorCell + step, ivec2(0), terrainSize - 2);
  fraction = clamp(ray.originGC.xy - vec2(cell - ray.anchorCell), vec2(0.0), vec2(1.0));
  codes = terrainCellCodes(cell);
#ifdef TERRAIN_COLUMNS
  float top = terrainColumnCode(codes, greaterThanEqual(fraction, vec2(0.5)));
#else
  float top = terrainPatchCode(codes, fraction);
#endif
  return terrainCellValid(codes) && ray.originGC.z <= top;
}
#endif

// What the ray of a pixel sees between a distance, or terrainBegin or its tile's start where that
// is more, and terrainFar: the surface behind terrainLayer others, without what is culled. Any
// entryDistance will do, also one before the eye.
TerrainSighting terrainCast(vec2 pixel, float entryDistance)
{
  float start = max(max(entryDistance, terrainBegin), terrainSafeStart(pixel));
  vec2 range = terrainEnterBox(pixel, vec2(start, terrainFar));
  int wall = -1;
#ifdef TERRAIN_CLIP_PLANES
  range = terrainClipRange(pixel, range, wall);
#endif
  TerrainSighting sighting;
  sighting.found = false;
  sighting.crossings = 0;
  int layer = terrainLayer;
#ifdef TERRAIN_BLOCK
  if (wall >= 0 && range.x < range.y &&
    terrainIsWithinBlock(
      pixel, range.x, sighting.cell, sighting.fraction, sighting.codes))
  {
    if (layer == 0)
    {
      sighting.found = true;
      sighting.distanceVC = range.x;
      sighting.front = true;
      sighting.wall = wall;
      return sighting;
    }
    --layer;
  }
#endif
  while (range.x < range.y)
  {
    bool front;
    vec4 codes;
    TerrainHit hit = terrainTraceRange(pixel, range, front, codes);
    sighting = TerrainSighting(hit.found, range.x + hit.s, hit.cell, hit.fraction, front,
      sighting.crossings + hit.crossings, -1, codes);
    bool culled = hit.found && (front ? terrainCulled.x : terrainCulled.y) == 1;
    if (!hit.found || (!culled && layer == 0))
    {
      break;
    }
    layer -= culled ? 0 : 1;
    // on from behind the hit: by a hundredth of a cell, and by what float can tell
#ifdef TERRAIN_GLOBE
    float pace = terrainGlobeBeyond / max(length(terrainAtPixelGC(pixel)), 1e-30);
#else
    float pace = 0.01 / max(length(terrainAtPixelGC(pixel).xy), 1e-30);
#endif
    range.x += hit.s + max(pace, 1e-6 * sighting.distanceVC);
    sighting.found = false;
  }
  return sighting;
}
