// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ray casting through tiles, some of which may be missing. Needs vtkTerrainTiles.glsl and
// vtkTerrainPyramid.glsl.
//
// Twins in src/core/: rays/TileTraversal.h, node for node, which documents the method.

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

// Passes a node, or a cell at level 0, by its patch, coming from a side as in TerrainPassage;
// codes: of the patch's corners.
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
// down: as in TerrainPassage. Bounds: highest and lowest code, less the path's anchorCode; side: on
// which the ray comes.
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

// Takes a ray that comes from a side (as in TerrainPassage) over a node above level 0 whose tile is
// in a slot, or down into it where it comes within the bounds; tolerance: see
// terrainTracePyramidWithin().
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

// A step of a path with the slot of its node.
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

// How far a ray has come.
struct TerrainTileWalk
{
  TerrainTileStep at;
  TerrainTileStep from; // the step before
  float side;           // as in TerrainPassage
  bool byPatch;         // at is passed by its patch
  bool wall;            // met from the step before
  bool small;           // within the tolerance at the node of the step before
  bool ended;
  int crossings;
  int most;
};

// On over a node by its bounds, or up where its tile is not there.
void terrainWalkNode(TerrainPath path, vec4 tolerance, inout TerrainTileWalk walk)
{
  TerrainDescent descent = TerrainDescent(false, false, walk.side, walk.at.step);
  ++descent.next.level;
  bool last = false;
  if (walk.at.slot >= 0)
  {
    ++walk.crossings;
    TerrainSpan span = terrainNodeSpan(path, walk.at.step);
    descent = terrainDescend(path, walk.at.step, span, walk.side, tolerance, walk.at.slot);
    last = (span.ends && !descent.down) || walk.crossings >= walk.most;
  }
  TerrainTileStep next = terrainTileStep(path, descent.next);
  walk.byPatch = descent.down && !descent.small && next.slot < 0;
  if (!walk.byPatch)
  {
    walk.wall = descent.passes * walk.side < 0.0;
    walk.small = descent.small;
    walk.ended = last || walk.wall || walk.small;
    walk.side = walk.small ? walk.side : descent.passes;
    walk.from = walk.at;
    walk.at = next;
    walk.byPatch = terrainTileStepIsCell(next);
  }
}

// On over a hole, where no tolerance ends a ray.
void terrainWalkOverHole(inout TerrainTileWalk walk)
{
  walk.small = false;
  walk.ended = walk.crossings >= walk.most;
  walk.byPatch = walk.at.slot < 0 || walk.at.step.level == 0;
  walk.side = walk.at.slot < 0 ? walk.side : 0.0;
  if (walk.at.slot < 0)
  {
    walk.at = walk.from;
  }
}

// On over a cell, or a node whose finer ones are not there, by its patch.
void terrainWalkPatch(TerrainPath path, inout TerrainTileWalk walk, inout TerrainPassage passage)
{
  if (walk.at.step.level == 0) // nodes were visited as such
  {
    ++walk.crossings;
    TERRAIN_VISIT(walk.at.step.cell ^ path.mirror, 0)
  }
  TerrainSpan span = terrainNodeSpan(path, walk.at.step);
  passage = terrainPassPatch(
    path, walk.at.step, span, walk.side, terrainTileStepCodes(path, walk.at));
  walk.side = passage.side;
  walk.ended = passage.meets || span.ends || walk.crossings >= walk.most;
  walk.from = walk.at;
  walk.at = terrainTileStep(path, terrainNextStep(path, walk.at.step, span, false, span.s));
  walk.byPatch = terrainTileStepIsCell(walk.at);
}

// The first point of the surface on a ray; tolerance: see terrainTracePyramidWithin(). Two loops in
// turn, as there. The loop over nodes reads no heights, which would cost a quarter of its time
// where no ray does (llvmpipe 22.3).
TerrainHit terrainTraceTiles(TerrainRay ray, vec4 tolerance)
{
  TerrainPath path = terrainClipPath(terrainMirrorRay(ray));
  TerrainTileStep at = terrainTileStep(path, terrainFirstStep(path));
  TerrainTileWalk walk = TerrainTileWalk(at, at, 0.0, terrainTileStepIsCell(at), false, false,
    !(path.sBegin <= path.sEnd), 0, 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop);
  TerrainPassage passage = TerrainPassage(0.0, false, 0.0, vec2(0.0));
  do
  {
    do
    {
      if (!walk.ended && !walk.byPatch)
      {
        terrainWalkNode(path, tolerance, walk);
      }
    } while (!walk.ended && !walk.byPatch);
    if (walk.small && !walk.wall && terrainHoles == 1 &&
      !terrainCellValid(terrainTileStepCodes(path, walk.from)))
    {
      terrainWalkOverHole(walk);
    }
    do
    {
      if (!walk.ended && walk.byPatch)
      {
        terrainWalkPatch(path, walk, passage);
      }
    } while (!walk.ended && walk.byPatch);
  } while (!walk.ended);
  TerrainHit hit = terrainNoHit();
  if (passage.meets)
  {
    hit = terrainHitInNode(path, walk.from.step, passage);
  }
  if (walk.wall || walk.small)
  {
    hit = terrainMeetBox(path, walk.wall ? walk.from.step : walk.at.step);
  }
  hit.crossings = walk.crossings;
  return hit;
}
