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

// What becomes of a ray at a node above level 0.
struct TerrainDescent
{
  bool down;    // it comes within the bounds
  bool small;   // and they are within the tolerance
  float passes; // as terrainPassBounds() tells
  TerrainStep next;
};

// Slot: of the node.
TerrainDescent terrainDescend(
  TerrainPath path, TerrainStep at, TerrainSpan span, float side, vec4 tolerance, int slot)
{
  TerrainDescent descent;
  ivec2 node = (at.cell >> at.level) ^ path.mirror;
  TERRAIN_VISIT(node, at.level)
  vec2 bounds = terrainSlotBounds(node, at.level, slot) - path.anchorCode +
    vec2(path.slack, -path.slack);
  descent.down = min(at.z, span.z) <= bounds.x && max(at.z, span.z) >= bounds.y;
  float bound = path.direction.z < 0.0 ? bounds.x : bounds.y;
  float s = clamp(at.s + (bound - at.z) * path.inverse.z, at.s, span.s);
  descent.next = terrainNextStep(path, at, span, descent.down, descent.down ? s : span.s);
  descent.small = descent.down && at.level <= terrainTileTop &&
    terrainIsWithin(tolerance, at.s, at.level, bounds);
  descent.passes = terrainPassBounds(path, at, span, bounds, descent.down, s, side);
  return descent;
}

// A step and the slot of its node, negative if its tile is not there.
struct TerrainTileStep
{
  TerrainStep step;
  int slot;
};

TerrainTileStep terrainTileStep(TerrainPath path, TerrainStep step)
{
  return TerrainTileStep(
    step, terrainTileSlot((step.cell >> step.level) ^ path.mirror, step.level));
}

// Codes of the corners of the node of a step.
vec4 terrainTileStepCodes(TerrainPath path, TerrainTileStep at)
{
  return terrainSlotCodes((at.step.cell >> at.step.level) ^ path.mirror, at.slot);
}

// True for a cell whose tile is there.
bool terrainTileStepIsCell(TerrainTileStep at)
{
  return at.step.level == 0 && at.slot >= 0;
}

// The first point of the surface on a ray; tolerance: see terrainTracePyramidWithin(). Two loops in
// turn, as there: over nodes by their bounds, up where the tile is not there; and by their patches
// over cells, and nodes whose finer ones are not there. The loop over nodes reads no heights, which
// would cost a quarter of its time where no ray does (llvmpipe 22.3).
TerrainHit terrainTraceTiles(TerrainRay ray, vec4 tolerance)
{
  TerrainPath path = terrainClipPath(terrainMirrorRay(ray));
  TerrainTileStep at = terrainTileStep(path, terrainFirstStep(path));
  TerrainTileStep from = at; // the step before, of a ray that ends
  TerrainHit hit = terrainNoHit();
  TerrainPassage passage;
  passage.meets = false;
  bool ended = !(path.sBegin <= path.sEnd);
  int most = 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop;
  int crossings = 0;
  float side = 0.0;
  bool wall = false;
  bool small = false;
  bool byPatch = terrainTileStepIsCell(at);
  do
  {
    do
    {
      if (!ended && !byPatch)
      {
        TerrainDescent descent = TerrainDescent(false, false, side, at.step);
        ++descent.next.level;
        bool last = false;
        if (at.slot >= 0)
        {
          ++crossings;
          TerrainSpan span = terrainNodeSpan(path, at.step);
          descent = terrainDescend(path, at.step, span, side, tolerance, at.slot);
          last = (span.ends && !descent.down) || crossings >= most;
        }
        TerrainTileStep next = terrainTileStep(path, descent.next);
        byPatch = descent.down && !descent.small && next.slot < 0;
        if (!byPatch)
        {
          wall = descent.passes * side < 0.0;
          small = descent.small;
          ended = last || wall || small;
          side = small ? side : descent.passes;
          from = at;
          at = next;
          byPatch = terrainTileStepIsCell(at);
        }
      }
    } while (!ended && !byPatch);
    if (small && !wall && terrainHoles == 1 && !terrainCellValid(terrainTileStepCodes(path, from)))
    {
      // over a hole a ray goes on exactly
      small = false;
      ended = crossings >= most;
      byPatch = at.slot < 0 || at.step.level == 0;
      side = at.slot < 0 ? side : 0.0;
      if (at.slot < 0)
      {
        at = from;
      }
    }
    do
    {
      if (!ended && byPatch)
      {
        if (at.step.level == 0) // nodes were visited above
        {
          ++crossings;
          TERRAIN_VISIT(at.step.cell ^ path.mirror, 0)
        }
        TerrainSpan span = terrainNodeSpan(path, at.step);
        passage =
          terrainPassPatch(path, at.step, span, side, terrainTileStepCodes(path, at));
        side = passage.side;
        ended = passage.meets || span.ends || crossings >= most;
        from = at;
        at = terrainTileStep(path, terrainNextStep(path, at.step, span, false, span.s));
        byPatch = terrainTileStepIsCell(at);
      }
    } while (!ended && byPatch);
  } while (!ended);
  if (passage.meets)
  {
    hit = terrainHitInNode(path, from.step, passage);
  }
  if (wall || small)
  {
    hit = terrainMeetBox(path, wall ? from.step : at.step);
  }
  hit.crossings = crossings;
  return hit;
}
