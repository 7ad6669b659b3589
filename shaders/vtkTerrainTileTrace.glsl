// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ray casting through tiles, some of which may be missing. Twin, node for node:
// src/core/rays/TileTraversal.h, which documents the method. Needs vtkTerrainTiles.glsl and
// vtkTerrainPyramid.glsl.

uniform int terrainHoles; // 1 if some samples have no height

// How a ray passes a node: on which side of the surface it leaves it, or that it meets it.
struct TerrainPassage
{
  float side;    // above 1, below -1, unknown 0
  bool meets;
  float s;       // where, and at which fraction of the node
  vec2 fraction;
};

// Position on a path in a node, as fractions of the node; see terrainCellFraction().
vec2 terrainNodeFraction(
  TerrainPath path, ivec2 cell, int level, float s, int line, float side)
{
  ivec2 first = (cell >> level) << level;
  float width = 1.0 / float(1 << level);
  vec2 fraction = clamp(
    (path.origin.xy + path.direction.xy * s - vec2(first - path.anchor)) * width,
    vec2(0.0), vec2(1.0));
  fraction = vec2(line == 1 ? side : fraction.x, line == 2 ? side : fraction.y);
  return mix(fraction, 1.0 - fraction, notEqual(path.mirror, ivec2(0)));
}

// Passes a node, or a cell at level 0, by its patch; codes: of the patch.
TerrainPassage terrainPassPatch(
  TerrainPath path, TerrainStep at, TerrainSpan span, float side, vec4 codes)
{
  TerrainPassage passage;
  bool valid = terrainCellValid(codes);
  codes -= path.anchorCode;
  vec2 begin = terrainNodeFraction(path, at.cell, at.level, at.s, at.line, 0.0);
  vec2 end = terrainNodeFraction(
    path, at.cell, at.level, span.s, span.ends ? 0 : span.crossEast ? 1 : 2, 1.0);
  float above = at.z - terrainPatchCode(codes, begin);
  float t = terrainIntersectPatch(codes, vec3(begin, at.z), vec3(end, span.z));
  bool wall = above * side < 0.0;
  passage.meets = valid && (wall || t >= 0.0);
  passage.s = wall ? at.s : at.s + t * (span.s - at.s);
  passage.fraction = wall ? begin : begin + t * (end - begin);
  passage.side = valid ? (above < 0.0 ? -1.0 : 1.0) : 0.0;
  return passage;
}

// The hit of a passage, in cells of level 0.
TerrainHit terrainHitInNode(TerrainPath path, TerrainStep at, TerrainPassage passage)
{
  ivec2 node = (at.cell >> at.level) ^ path.mirror;
  vec2 position = passage.fraction * float(1 << at.level);
  ivec2 cell = min(ivec2(position), ivec2((1 << at.level) - 1));
  return TerrainHit(true, passage.s, (node << at.level) + cell, position - vec2(cell), 0);
}

// The side on which a ray passes a node by its bounds, or the part of it before s, where it goes
// down.
float terrainPassBounds(TerrainPath path, TerrainStep at, TerrainSpan span, vec2 bounds, bool down,
  float s, float side)
{
  float passed = min(at.z, span.z) > bounds.x ? 1.0 : -1.0;
  float before = s > at.s ? (path.direction.z < 0.0 ? 1.0 : -1.0) : side;
  return terrainHoles == 1 || bounds.x < bounds.y ? 0.0 : down ? before : passed;
}

// The step in the finest node that is there, and its slot.
void terrainAscend(TerrainPath path, inout TerrainStep at, inout int slot)
{
  while (slot < 0 && at.level < terrainPyramidTop)
  {
    ++at.level;
    slot = terrainTileSlot((at.cell >> at.level) ^ path.mirror, at.level);
  }
}

// What becomes of a ray at a node above level 0.
struct TerrainDescent
{
  bool down;        // it comes within the bounds
  bool small;       // and ends there, within the tolerance
  float passes;     // as terrainPassBounds() tells
  TerrainStep next;
  int nextSlot;     // of the finer node that it goes down into; negative if its tile is not there
};

// Slot: of the node.
TerrainDescent terrainDescend(
  TerrainPath path, TerrainStep at, TerrainSpan span, float side, vec4 tolerance, int slot)
{
  TerrainDescent descent;
  ivec2 node = (at.cell >> at.level) ^ path.mirror;
  vec2 bounds = terrainSlotBounds(node, slot) - path.anchorCode + vec2(path.slack, -path.slack);
  descent.down = min(at.z, span.z) <= bounds.x && max(at.z, span.z) >= bounds.y;
  float bound = path.direction.z < 0.0 ? bounds.x : bounds.y;
  float s = clamp(at.s + (bound - at.z) * path.inverse.z, at.s, span.s);
  descent.next = terrainNextStep(path, at, span, descent.down, descent.down ? s : span.s);
  descent.small = descent.down && terrainIsWithin(tolerance, at.s, at.level, bounds) &&
    terrainCellValid(terrainSlotCodes(node, slot));
  descent.nextSlot = slot;
  if (descent.down && !descent.small)
  {
    int finer = max(at.level - 1, 0);
    descent.nextSlot = terrainTileSlot((descent.next.cell >> finer) ^ path.mirror, finer);
  }
  descent.passes = terrainPassBounds(path, at, span, bounds, descent.down, s, side);
  return descent;
}

// The first point of the surface on a ray; tolerance: see terrainTracePyramidWithin().
TerrainHit terrainTraceTiles(TerrainRay ray, vec4 tolerance)
{
  TerrainPath path = terrainClipPath(terrainMirrorRay(ray));
  TerrainStep at = terrainFirstStep(path);
  TerrainHit hit = terrainNoHit();
  bool ended = !(path.sBegin <= path.sEnd);
  int most = 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop;
  int crossings = 0;
  float side = 0.0;
  int slot = terrainTileSlot((at.cell >> at.level) ^ path.mirror, at.level);
  while (!ended)
  {
    terrainAscend(path, at, slot);
    ++crossings;
    ivec2 node = (at.cell >> at.level) ^ path.mirror;
    TERRAIN_VISIT(node, at.level)
    TerrainSpan span = terrainNodeSpan(path, at);
    bool down = false;
    bool byPatch = at.level == 0;
    TerrainStep next = at;
    int nextSlot = slot;
    if (at.level > 0)
    {
      TerrainDescent descent = terrainDescend(path, at, span, side, tolerance, slot);
      down = descent.down;
      next = descent.next;
      nextSlot = descent.nextSlot;
      byPatch = nextSlot < 0;
      bool wall = !byPatch && descent.passes * side < 0.0;
      side = byPatch ? side : descent.passes;
      if (wall || descent.small)
      {
        hit = terrainMeetBox(path, wall ? at : next);
        ended = true;
      }
    }
    if (byPatch)
    {
      TerrainPassage passage =
        terrainPassPatch(path, at, span, side, terrainSlotCodes(node, slot));
      side = passage.side;
      if (passage.meets)
      {
        hit = terrainHitInNode(path, at, passage);
      }
      next = terrainNextStep(path, at, span, false, span.s);
      down = false;
      ended = passage.meets;
    }
    ended = ended || (span.ends && !down) || crossings >= most;
    at = next;
    if (!ended && !down)
    {
      nextSlot = terrainTileSlot((at.cell >> at.level) ^ path.mirror, at.level);
    }
    slot = nextSlot;
  }
  hit.crossings = crossings;
  return hit;
}
