// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Beams: a safe common start for all rays of a tile of pixels. Needs vtkTerrainPyramid.glsl,
// vtkTerrainView.glsl and their uniforms; no further ones. Defines: TERRAIN_TILES as in the former.
// Constants: terrainBeamSteps, terrainBeamMargin, terrainBeamReach (src/render/Features.h).
//
// Twins in src/core/: rays/PyramidBeam.h, which documents the method and why it is conservative.

struct TerrainBeam
{
  TerrainRay ray; // in the middle of the tile
  vec3 radius;    // all rays of the tile lie in ray(s) -+ (radius + s * growth), both >= 0:
  vec3 growth;    // cells, cells, height codes; growth per unit of s
};

// The edges of a beam's box, mirrored as the path: origin and change per unit of s; cells, cells,
// height codes.
struct TerrainBeamEdges
{
  vec3 low;
  vec3 lowMove;
  vec3 high;
  vec3 highMove;
};

// Where a beam has got to: the level of the nodes it tries next, 0 for a cell; or stops for good.
struct TerrainBeamStep
{
  float s;
  int level;
  bool stops;
};

// The beam of all pixels that lie within so many pixels of a position (gl_FragCoord.xy) both ways,
// between two distances along the viewing direction.
TerrainBeam terrainTileBeam(vec2 pixel, float pixels, float startDistance, float endDistance)
{
  vec3 growth = pixels * (abs(terrainDirectionGC[1]) + abs(terrainDirectionGC[2]));
  vec3 radius = pixels * (abs(terrainOriginGC[1]) + abs(terrainOriginGC[2]));
  return TerrainBeam(
    terrainPixelRay(pixel, startDistance, endDistance), radius + startDistance * growth, growth);
}

// The edges of a beam's box over the distance, relative to the path's origin: its radius and
// growth, and room for what float rounds, terrainBeamMargin of the numbers.
TerrainBeamEdges terrainBeamEdges(TerrainPath path, TerrainBeam beam)
{
  vec3 radius = beam.radius + terrainBeamMargin * (abs(path.origin) + 1.0) +
    vec3(0.0, 0.0, path.slack);
  vec3 growth = beam.growth + terrainBeamMargin * abs(path.direction);
  return TerrainBeamEdges(path.origin - radius, path.direction - growth, path.origin + radius,
    path.direction + growth);
}

// The distance, at least s, where the box reaches the grid along an axis; end if it never does.
// ahead: cells at distance 0 from the box's far edge to the grid's near one, move: that edge's
// cells a unit of distance; past, pastMove: likewise from the grid's far edge to the box's near
// one.
float terrainBeamReaches(float s, float end, float ahead, float move, float past, float pastMove)
{
  float reached = move > 0.0 ? max(s, ahead / move) : (ahead > 0.0 ? end : s);
  return past + pastMove * reached > 0.0 && pastMove >= 0.0 ? end : reached;
}

// The distance where the box reaches the box of all surfaces; the path's end if it never does.
float terrainBeamEntry(TerrainPath path, TerrainBeamEdges edges)
{
  vec2 first = vec2(path.firstCell - path.anchor);
  vec2 last = vec2(path.lastCell + 1 - path.anchor);
  vec2 ahead = first - edges.high.xy;
  vec2 past = edges.low.xy - last;
  float s = path.sBegin;
  s = terrainBeamReaches(s, path.sEnd, ahead.x, edges.highMove.x, past.x, edges.lowMove.x);
  s = terrainBeamReaches(s, path.sEnd, ahead.y, edges.highMove.y, past.y, edges.lowMove.y);
  float above = edges.low.z - (terrainMaximumCode - path.anchorCode);
  float below = -path.anchorCode - edges.high.z;
  if (above + edges.lowMove.z * s > 0.0)
  {
    s = edges.lowMove.z < 0.0 ? -above / edges.lowMove.z : path.sEnd;
  }
  if (below - edges.highMove.z * s > 0.0)
  {
    s = edges.highMove.z > 0.0 ? below / edges.highMove.z : path.sEnd;
  }
  return clamp(s, path.sBegin, path.sEnd);
}

// The lowest level, 0 or more, whose nodes are at least 4/3 as wide as the box at a distance.
int terrainBeamLevel(TerrainBeamEdges edges, float s)
{
  vec2 width = edges.high.xy - edges.low.xy + (edges.highMove.xy - edges.lowMove.xy) * s;
  return int(ceil(log2(max(max(width.x, width.y) * (4.0 / 3.0), 1.0))));
}

// The distance where the box leaves the cells first <= cell < end, mirrored.
float terrainBeamLeaves(TerrainPath path, TerrainBeamEdges edges, ivec2 first, ivec2 end)
{
  vec2 ahead = vec2(end - path.anchor) - edges.high.xy;
  vec2 behind = vec2(first - path.anchor) - edges.low.xy;
  float s = path.sEnd;
  s = edges.highMove.x > 0.0 ? min(s, ahead.x / edges.highMove.x) : s;
  s = edges.highMove.y > 0.0 ? min(s, ahead.y / edges.highMove.y) : s;
  s = edges.lowMove.x < 0.0 ? min(s, behind.x / edges.lowMove.x) : s;
  s = edges.lowMove.y < 0.0 ? min(s, behind.y / edges.lowMove.y) : s;
  return s;
}

// Highest and lowest code, less the path's anchorCode, of the nodes (block.x + 0..1,
// block.y + 0..1) of a level, mirrored.
vec2 terrainBlockBounds(TerrainPath path, ivec2 block, int level)
{
  ivec2 near = max(block ^ path.mirror, ivec2(0));
  ivec2 far = max((block + 1) ^ path.mirror, ivec2(0));
  vec2 a = terrainNodeExtremes(near, level);
  vec2 b = terrainNodeExtremes(ivec2(far.x, near.y), level);
  vec2 c = terrainNodeExtremes(ivec2(near.x, far.y), level);
  vec2 d = terrainNodeExtremes(far, level);
  return vec2(max(max(a.x, b.x), max(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y))) -
    path.anchorCode;
}

// On to where the box leaves the block of 2 x 2 nodes, if no height in it meets the box; else to
// where it comes down to the highest, or up to the lowest height of the block.
TerrainBeamStep terrainBeamOverBlock(TerrainPath path, TerrainBeamEdges edges, TerrainBeamStep at)
{
  ivec2 block =
    (ivec2(floor(edges.low.xy + edges.lowMove.xy * at.s)) + path.anchor) >> at.level;
  int size = 1 << at.level;
  float leaves = max(terrainBeamLeaves(path, edges, block * size, (block + 2) * size), at.s);
  vec2 bounds = terrainBlockBounds(path, block, at.level);
  float lowest = edges.low.z + min(edges.lowMove.z * at.s, edges.lowMove.z * leaves);
  float highest = edges.high.z + max(edges.highMove.z * at.s, edges.highMove.z * leaves);
  bool clear = lowest > bounds.x || highest < bounds.y;
  float above = edges.low.z + edges.lowMove.z * at.s - bounds.x;
  float below = bounds.y - edges.high.z - edges.highMove.z * at.s;
  float fall = above > 0.0 ? above / -edges.lowMove.z : 0.0;
  float rise = below > 0.0 ? below / edges.highMove.z : 0.0;
  float s = clear ? leaves : min(at.s + max(fall, rise), leaves);
  int lowestLevel = terrainBeamLevel(edges, s);
  int level = clear ? max(at.level + 1, lowestLevel) : at.level - 1;
  return TerrainBeamStep(s, min(level, terrainPyramidTop), level < lowestLevel);
}

// Codes of the corners of a cell; none of a tile that is not there, since no slope bounds the step
// to a coarser one.
vec4 terrainBeamCodes(ivec2 cell)
{
#ifdef TERRAIN_TILES
  int slot = terrainTileSlot(cell, 0);
  return slot < 0 ? vec4(-1.0) : terrainSlotCodes(cell, slot);
#else
  return terrainCellCodes(cell);
#endif
}

// Steepest change of the code along an edge between samples of a cell and those around it, east and
// north; and the codes of the cell's corners. False if some of the 4 x 4 samples have no height.
bool terrainSlopeBound(ivec2 cell, out vec2 slope, out vec4 codes)
{
  vec4 southWest = terrainBeamCodes(cell - 1);
  vec4 southEast = terrainBeamCodes(cell + ivec2(1, -1));
  vec4 northWest = terrainBeamCodes(cell + ivec2(-1, 1));
  vec4 northEast = terrainBeamCodes(cell + 1);
  codes = vec4(southWest.w, southEast.z, northWest.y, northEast.x);
  // The columns of samples, each from south to north.
  vec4 a = vec4(southWest.xz, northWest.xz);
  vec4 b = vec4(southWest.yw, northWest.yw);
  vec4 c = vec4(southEast.xz, northEast.xz);
  vec4 d = vec4(southEast.yw, northEast.yw);
  vec4 east = max(max(abs(b - a), abs(c - b)), abs(d - c));
  vec3 north = max(max(abs(a.yzw - a.xyz), abs(b.yzw - b.xyz)),
    max(abs(c.yzw - c.xyz), abs(d.yzw - d.xyz)));
  slope = vec2(max(max(east.x, east.y), max(east.z, east.w)), max(max(north.x, north.y), north.z));
  return terrainCellValid(min(min(a, b), min(c, d)));
}

// On to where the ray in the middle leaves a cell, if it stays so far above or below the cell's
// patch that the steepest slope around cannot reach the box.
TerrainBeamStep terrainBeamOverCell(TerrainPath path, TerrainBeamEdges edges, TerrainBeamStep at)
{
  vec2 position = path.origin.xy + path.direction.xy * at.s;
  ivec2 cell = ivec2(floor(position + terrainBeamReach)) + path.anchor;
  vec2 leave = (vec2(cell + 1 - path.anchor) - path.lineOrigin) * path.inverse.xy;
  float s = clamp(min(leave.x, leave.y), at.s, path.sEnd);
  vec3 radius = 0.5 * (edges.high - edges.low + (edges.highMove - edges.lowMove) * s) +
    vec3(2.0 * terrainBeamReach, 2.0 * terrainBeamReach, 0.0);
  bool inside = all(greaterThan(cell, path.firstCell)) && all(lessThan(cell, path.lastCell));
  if (!inside || max(radius.x, radius.y) > 0.9)
  {
    return TerrainBeamStep(at.s, 0, true);
  }
  vec2 slope;
  vec4 codes;
  bool valid = terrainSlopeBound(cell ^ path.mirror, slope, codes);
  codes -= path.anchorCode;
  vec2 begin = terrainCellFraction(path, cell, at.s, 0, 0.0);
  vec2 end = terrainCellFraction(path, cell, s, 0, 0.0);
  vec2 difference = path.origin.z + path.direction.z * vec2(at.s, s) -
    vec2(terrainPatchCode(codes, begin), terrainPatchCode(codes, end));
  // On the way the difference leaves the straight line between its ends by a quarter of this.
  float bend = -((codes.x - codes.y) - (codes.z - codes.w)) * (end.x - begin.x) * (end.y - begin.y);
  float reach = radius.z + dot(slope, radius.xy);
  bool clear = valid && (min(difference.x, difference.y) - 0.25 * max(bend, 0.0) > reach ||
    max(difference.x, difference.y) - 0.25 * min(bend, 0.0) < -reach);
  vec2 after = path.origin.xy + path.direction.xy * s;
  ivec2 next = ivec2(floor(after + terrainBeamReach)) + path.anchor;
  bool leavesBlock = any(notEqual(next >> 1, cell >> 1)) || terrainBeamLevel(edges, s) > 0;
  return TerrainBeamStep(clear ? s : at.s, leavesBlock ? 1 : 0, !clear);
}

// A distance sBegin <= s <= sEnd of the beam's ray that no ray of the tile has met the surface
// before; sEnd if none does at all.
float terrainBeamStart(TerrainBeam beam)
{
  TerrainPath path = terrainMirrorRay(beam.ray);
  TerrainBeamEdges edges = terrainBeamEdges(path, beam);
  float s = terrainPyramidTop < 1 ? path.sEnd : terrainBeamEntry(path, edges);
  TerrainBeamStep at =
    TerrainBeamStep(s, clamp(terrainBeamLevel(edges, s) + 2, 1, terrainPyramidTop), false);
  int steps = 0;
  bool going = at.s < path.sEnd;
  // Two loops in turn, as in terrainTracePyramidWithin(): a step over a cell reads 16 samples.
  do
  {
    do
    {
      if (going && at.level > 0)
      {
        at = terrainBeamOverBlock(path, edges, at);
        going = ++steps < terrainBeamSteps && !at.stops && at.s < path.sEnd;
      }
    } while (going && at.level > 0);
    do
    {
      if (going && at.level == 0)
      {
        at = terrainBeamOverCell(path, edges, at);
        going = ++steps < terrainBeamSteps && !at.stops && at.s < path.sEnd;
      }
    } while (going && at.level == 0);
  } while (going);
  return min(at.s, path.sEnd);
}
