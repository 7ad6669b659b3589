// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact ray casting through the min-max pyramid. Needs vtkTerrainHeights.glsl and
// vtkTerrainRay.glsl.
//
// Uniforms to set:
//   terrainPyramid       texture with mip levels, two channels (maximum, minimum) in the heights'
//                        own texels: RG16UI where TERRAIN_HEIGHTS_INTEGER is defined, else RG32F.
//                        Mip level k - 1 is level k of MinMaxPyramid, same sizes. Filters NEAREST
//                        (and NEAREST_MIPMAP_NEAREST), GL_TEXTURE_MAX_LEVEL = LevelCount() - 1.
//                        With TERRAIN_PYRAMID_BUFFER a buffer instead: MinMaxPyramid::AllNodes().
//   terrainPyramidLayout, terrainPyramidLevels  with it: Quarters and Halves, and Top of
//                        terrain::PyramidLayout
//   terrainPyramidSize   size of level 1, texels
//   terrainPyramidTop    LevelCount(), with detail of the sum; 0 where the grid has no cells
//   terrainPyramidStart  level of the first node, 1..top (0 if there are no cells)
// Defines:
//   TERRAIN_PYRAMID_BUFFER  optional: see terrainPyramid
//   TERRAIN_COLUMNS   optional: the surface of constant columns instead of bilinear patches; needs
//                     vtkTerrainColumns.glsl
//   TERRAIN_WITHIN    optional: tolerances count; without, terrainTracePyramidWithin() is exact
//   TERRAIN_VISIT(node, level)  optional: run for every node visited, which counts from the
//                     south-west
//   TERRAIN_DETAIL    see vtkTerrainHeights.glsl; with the uniforms declared below
//
// Twins in src/core/: rays/PyramidTraversal.h, node for node, which documents the method; of what
// reads nodes, surface/MinMaxPyramid.h and surface/DetailHeights.h.

#ifdef TERRAIN_TILES
// terrainSlotBounds() in vtkTerrainTiles.glsl in its place
#elif defined(TERRAIN_PYRAMID_BUFFER) && defined(TERRAIN_HEIGHTS_INTEGER)
uniform usamplerBuffer terrainPyramid;
#elif defined(TERRAIN_PYRAMID_BUFFER)
uniform samplerBuffer terrainPyramid;
#elif defined(TERRAIN_HEIGHTS_INTEGER)
uniform usampler2D terrainPyramid;
#else
uniform sampler2D terrainPyramid;
#endif
uniform ivec2 terrainPyramidSize;
uniform int terrainPyramidTop;
uniform int terrainPyramidStart;

#ifndef TERRAIN_VISIT
#define TERRAIN_VISIT(node, level)
#endif

// A ray mirrored so that it runs north-east; cells are mirrored likewise.
struct TerrainPath
{
  ivec2 mirror;     // cell ^ mirror takes cells to the grid and back: -1 where mirrored, else 0
  ivec2 anchor;     // corner that origin is relative to
  ivec2 firstCell;  // range of the grid's cells
  ivec2 lastCell;
  float anchorCode; // code that heights are relative to
  vec3 origin;      // position at s = 0: cells, height code, both relative
  vec3 direction;   // change per unit of s; x, y >= 0
  vec2 lineOrigin;  // origin for distances to grid lines
  vec3 inverse;     // 1 / direction; 0 in z if the ray is level
  float slack;      // above the rounding of heights on the ray, codes
  float sBegin;
  float sEnd;
};

// Where a ray is: the cell in which it runs on, and the node over it.
struct TerrainStep
{
  ivec2 cell;  // mirrored
  int level;
  float s;
  float z;     // height code
  int line;    // the grid line it stands on: 0 none, 1 runs north-south, 2 runs east-west
};

// The part of a ray in a node.
struct TerrainSpan
{
  ivec2 lastCell;  // of the node, where the ray leaves
  bool crossEast;  // leaves through the east side, else through the north side
  bool ends;       // the ray ends in the node
  float s;         // where it leaves
  float z;
};

#ifdef TERRAIN_PYRAMID_BUFFER
uniform ivec2 terrainPyramidLayout;
uniform int terrainPyramidLevels;

// Where the nodes of a level, 1..levels, begin in a buffer, in nodes; parts and levels: Quarters
// and Halves, and Top of terrain::PyramidLayout. Twin: PyramidLayout::Begin().
int terrainLevelBegin(ivec2 parts, int levels, int level)
{
  return (parts.x >> (2 * level - 2)) + (parts.y >> (level - 1)) + 2 * (levels - level);
}
#endif

// Highest and lowest code of a node of the texels; level >= 1.
vec2 terrainTexelExtremes(ivec2 node, int level)
{
#ifdef TERRAIN_TILES
  ivec2 cell = min(node << level, terrainSize - 2); // a tile at the border is not full
  int slot = terrainFinestSlot(cell, level);
  return terrainSlotBounds(cell >> level, level, slot);
#else
  ivec2 size = max(terrainPyramidSize >> (level - 1), ivec2(1));
  ivec2 texel = min(node, size - 1);
#ifdef TERRAIN_PYRAMID_BUFFER
  int index = terrainLevelBegin(terrainPyramidLayout, terrainPyramidLevels, level) + texel.x +
    size.x * texel.y;
  return vec2(texelFetch(terrainPyramid, index).rg) - terrainBias;
#else
  return vec2(texelFetch(terrainPyramid, texel, level - 1).rg) - terrainBias;
#endif
#endif
}

#ifdef TERRAIN_DETAIL
#ifdef TERRAIN_PYRAMID_BUFFER
uniform usamplerBuffer terrainDetailPyramid; // of one period, as terrainPyramid
uniform ivec2 terrainDetailLayout; // as terrainPyramidLayout and terrainPyramidLevels
uniform int terrainDetailLevels;
#else
uniform usampler2D terrainDetailPyramid;
#endif
uniform int terrainDetailTop;       // highest level whose nodes divide the period
uniform float terrainDetailUnit;    // height codes per unit of the nodes
uniform float terrainDetailMaximum; // largest code of the detail, scaled: height codes

// Highest and lowest code of the base in a node of the sum; level >= 1.
vec2 terrainBaseExtremes(ivec2 node, int level)
{
  int above = level - terrainDetailLevel;
  if (above > 0)
  {
    return terrainTexelExtremes(node, above);
  }
  vec4 codes = terrainPartCodes(min(node, (terrainSize - 2) >> level), -above);
  return vec2(max(max(codes.x, codes.y), max(codes.z, codes.w)),
    min(min(codes.x, codes.y), min(codes.z, codes.w)));
}

// Highest and lowest code of the detail, scaled, in a node of the sum; level >= 1.
vec2 terrainDetailExtremes(ivec2 node, int level)
{
  ivec2 nodes = max(terrainDetailPeriod >> level, ivec2(1));
  ivec2 texel = terrainWrap(node, nodes);
#ifdef TERRAIN_PYRAMID_BUFFER
  int begin = terrainLevelBegin(terrainDetailLayout, terrainDetailLevels, level);
  vec2 extremes = vec2(texelFetch(terrainDetailPyramid, begin + texel.x + nodes.x * texel.y).rg);
#else
  vec2 extremes = vec2(texelFetch(terrainDetailPyramid, texel, level - 1).rg);
#endif
  return level > terrainDetailTop ? vec2(terrainDetailMaximum, 0.0) : terrainDetailUnit * extremes;
}

// Highest and lowest code of a node; 1 <= level <= top.
vec2 terrainNodeExtremes(ivec2 node, int level)
{
  return terrainBaseExtremes(node, level) + terrainDetailExtremes(node, level);
}
#else
// Highest and lowest code of a node; 1 <= level <= top.
vec2 terrainNodeExtremes(ivec2 node, int level)
{
  return terrainTexelExtremes(node, level);
}
#endif

// A ray as one that moves east and north or not at all, in cells counted backwards where it does
// not: mirror is -1 along such an axis. Codes are relative to anchorCode, the nearest code of a
// height.
TerrainPath terrainMirrorRay(TerrainRay ray)
{
  TerrainPath path;
  bvec2 backward = lessThan(ray.directionGC.xy, vec2(0.0));
  path.mirror = -ivec2(backward);
  path.anchor = (ray.anchorCell ^ path.mirror) - path.mirror;
  path.anchorCode = clamp(ray.originGC.z, 0.0, terrainMaximumCode);
  path.origin = vec3(
    mix(ray.originGC.xy, -ray.originGC.xy, backward),
    ray.originGC.z - path.anchorCode + ray.originLow);
  path.direction = vec3(abs(ray.directionGC.xy), ray.directionGC.z);
  bvec2 still = lessThan(path.direction.xy, vec2(1e-20));
  path.direction.xy = mix(path.direction.xy, vec2(0.0), still);
  bool level = abs(path.direction.z) < 1e-30;
  path.inverse = vec3(mix(1.0 / path.direction.xy, vec2(1e20), still),
    level ? 0.0 : 1.0 / path.direction.z);
  path.lineOrigin = mix(path.origin.xy, vec2(-1e8), still);
  ivec2 cells = terrainSize - 1;
  path.firstCell = path.mirror * cells;
  path.lastCell = path.firstCell + cells - 1;
  path.slack = 1e-6 * (terrainMaximumCode + abs(path.origin.z));
  path.sBegin = ray.sBegin;
  path.sEnd = ray.sEnd;
  return path;
}

// Clips a path to the grid's rectangle and to the codes; empty if sBegin > sEnd.
TerrainPath terrainClipPath(TerrainPath path)
{
  bvec2 still = equal(path.direction.xy, vec2(0.0));
  bool level = path.inverse.z == 0.0;
  vec2 firstLine = vec2(path.firstCell - path.anchor);
  vec2 lastLine = vec2(path.lastCell + 1 - path.anchor);
  vec2 enter = mix((firstLine - path.origin.xy) * path.inverse.xy, vec2(path.sBegin), still);
  vec2 leave = (lastLine - path.lineOrigin) * path.inverse.xy;
  path.sBegin = max(max(enter.x, enter.y), path.sBegin);
  path.sEnd = min(min(leave.x, leave.y), path.sEnd);

  vec2 planes = vec2(0.0, terrainMaximumCode) - path.anchorCode - path.origin.z +
    vec2(-path.slack, path.slack);
  vec2 meet = planes * path.inverse.z;
  path.sBegin = level ? path.sBegin : max(path.sBegin, min(meet.x, meet.y));
  path.sEnd = level ? path.sEnd : min(path.sEnd, max(meet.x, meet.y));

  bvec2 beside = bvec2(path.origin.x < firstLine.x || path.origin.x > lastLine.x,
    path.origin.y < firstLine.y || path.origin.y > lastLine.y);
  bool outside = (still.x && beside.x) || (still.y && beside.y) ||
    (level && (planes.x > 0.0 || planes.y < 0.0)) || terrainPyramidTop < 1;
  float sum = dot(path.origin, vec3(1.0)) + dot(path.direction, vec3(1.0));
  outside = outside || !(abs(sum) < 1e38); // not a number, or infinite
  path.sEnd = outside ? path.sBegin - 1.0 : path.sEnd;
  return path;
}

// The node in which a path starts.
TerrainStep terrainFirstStep(TerrainPath path)
{
  vec2 position = path.origin.xy + path.direction.xy * path.sBegin;
  ivec2 cell = clamp(ivec2(floor(position)) + path.anchor, path.firstCell, path.lastCell);
  return TerrainStep(cell, min(terrainPyramidStart, terrainPyramidTop), path.sBegin,
    path.origin.z + path.direction.z * path.sBegin, 0);
}

// The part of the path in the node of a step.
TerrainSpan terrainNodeSpan(TerrainPath path, TerrainStep at)
{
  TerrainSpan span;
  span.lastCell = min(at.cell | ((1 << at.level) - 1), path.lastCell);
  vec2 leave = (vec2(span.lastCell + 1 - path.anchor) - path.lineOrigin) * path.inverse.xy;
  span.crossEast = leave.x <= leave.y;
  float s = min(leave.x, leave.y);
  span.ends = s >= path.sEnd;
  span.s = clamp(s, at.s, path.sEnd);
  span.z = path.origin.z + path.direction.z * span.s;
  return span;
}

// The next step: down a level at distance s; or else into the next node, one level up if the line
// between them is that of a parent too, and s is where the ray leaves.
TerrainStep terrainNextStep(TerrainPath path, TerrainStep at, TerrainSpan span, bool down, float s)
{
  vec2 position = path.origin.xy + path.direction.xy * s;
  ivec2 cell = clamp(ivec2(floor(position)) + path.anchor, at.cell, span.lastCell);
  bool moves = s > at.s;
  int line = (span.crossEast ? span.lastCell.x : span.lastCell.y) + 1;
  int up = ((line >> at.level) & 1) ^ 1;
  ivec2 across = span.crossEast ? ivec2(line, cell.y) : ivec2(cell.x, line);
  return TerrainStep(down ? (moves ? cell : at.cell) : across,
    down ? at.level - 1 : min(at.level + up, terrainPyramidTop), s,
    moves ? path.origin.z + path.direction.z * s : at.z,
    down ? (moves ? 0 : at.line) : (span.crossEast ? 1 : 2));
}

// Highest and lowest code that the path must not pass in the node of a step, widened by the slack.
vec2 terrainNodeBounds(TerrainPath path, TerrainStep at)
{
  ivec2 node = (at.cell >> at.level) ^ path.mirror;
  TERRAIN_VISIT(node, at.level)
  return terrainNodeExtremes(node, at.level) - path.anchorCode + vec2(path.slack, -path.slack);
}

// True if a node is no larger than a tolerance (terrainTracePyramidWithin()) allows at a distance.
bool terrainIsWithin(vec4 tolerance, float s, int level, vec2 bounds)
{
  vec2 allowed = tolerance.xy + s * tolerance.zw;
  return float(1 << level) <= allowed.x && bounds.x - bounds.y <= allowed.y;
}

// Visits the node of a step: down if the path's heights meet the bounds, from where they do; small
// if the node where they do is within the tolerance.
TerrainStep terrainVisitNode(TerrainPath path, TerrainStep at, TerrainSpan span, vec4 tolerance,
  out bool down, out bool small)
{
  vec2 bounds = terrainNodeBounds(path, at);
  down = min(at.z, span.z) <= bounds.x && max(at.z, span.z) >= bounds.y;
#ifdef TERRAIN_WITHIN
  small = down && terrainIsWithin(tolerance, at.s, at.level, bounds);
#else
  small = false;
#endif
  float bound = path.direction.z < 0.0 ? bounds.x : bounds.y;
  float s = clamp(at.s + (bound - at.z) * path.inverse.z, at.s, span.s);
  return terrainNextStep(path, at, span, down, down ? s : span.s);
}

// First t in 0..1 with c + b t + a t^2 = 0, where c and e are the values at 0 and 1; -1 if there is
// none. There is one if c and e differ in sign.
float terrainFirstRoot(float c, float e, float a)
{
  float side = c < 0.0 ? -1.0 : 1.0;
  c *= side;
  e *= side;
  a *= side;
  float b = e - c - a;
  float discriminant = b * b - 4.0 * a * c;
  bool dips = b < 0.0 && b > -2.0 * a && discriminant >= 0.0;
  float root = sqrt(max(discriminant, 0.0));
  float t = b <= 0.0 ? 2.0 * c / (root - b) : (b + root) / (-2.0 * a);
  t = c > 0.0 ? clamp(t, 0.0, 1.0) : 0.0;
  return c == 0.0 || e <= 0.0 || dips ? t : -1.0;
}

// Where a segment from one position in a cell to another first meets the cell's patch, as a part of
// the segment; -1 if it does not. Positions are fractions of the cell and height codes.
float terrainIntersectPatch(vec4 codes, vec3 begin, vec3 end)
{
  vec2 move = end.xy - begin.xy;
  float twist = (codes.x - codes.y) - (codes.z - codes.w);
  return terrainFirstRoot(begin.z - terrainPatchCode(codes, begin.xy),
    end.z - terrainPatchCode(codes, end.xy), -twist * move.x * move.y);
}

// Position on a path in a cell, as fractions of the cell in the grid; line: see TerrainStep, and
// the side of the cell where it lies, 0 or 1.
vec2 terrainCellFraction(TerrainPath path, ivec2 cell, float s, int line, float side)
{
  vec2 fraction =
    clamp(path.origin.xy + path.direction.xy * s - vec2(cell - path.anchor), vec2(0.0), vec2(1.0));
  fraction = vec2(line == 1 ? side : fraction.x, line == 2 ? side : fraction.y);
  return mix(fraction, 1.0 - fraction, notEqual(path.mirror, ivec2(0)));
}

// The first point of the path on the surface of a cell.
TerrainHit terrainMeetCell(TerrainPath path, TerrainStep at, TerrainSpan span)
{
  TerrainHit hit = terrainNoHit();
  hit.cell = at.cell ^ path.mirror;
  TERRAIN_VISIT(hit.cell, 0)
  vec4 codes = terrainCellCodes(hit.cell);
  bool valid = terrainCellValid(codes);
  codes -= path.anchorCode;
  vec2 begin = terrainCellFraction(path, at.cell, at.s, at.line, 0.0);
  vec2 end = terrainCellFraction(
    path, at.cell, span.s, span.ends ? 0 : span.crossEast ? 1 : 2, 1.0);
#ifdef TERRAIN_COLUMNS
  float t = terrainIntersectColumns(codes, vec3(begin, at.z), vec3(end, span.z));
#else
  float t = terrainIntersectPatch(codes, vec3(begin, at.z), vec3(end, span.z));
#endif
  hit.found = valid && t >= 0.0;
  hit.s = at.s + t * (span.s - at.s);
  hit.fraction = begin + t * (end - begin);
  return hit;
}

// Where a path enters the box of a node that is small enough.
TerrainHit terrainMeetBox(TerrainPath path, TerrainStep at)
{
  return TerrainHit(true, at.s, at.cell ^ path.mirror,
    terrainCellFraction(path, at.cell, at.s, at.line, 0.0), 0);
}

// The first point of the surface on a ray. The search may end at a node of the pyramid that, in
// cells and in height codes, is no larger than tolerance.xy + s * tolerance.zw: the hit is then
// where the ray enters the node's box, hence off the surface by less than that, and found even if
// the ray would pass by the surface within the box. 0 is exact; less than 2 cells has no effect. A
// ray that enters such a box in a cell without surface goes on exactly.
TerrainHit terrainTracePyramidWithin(TerrainRay ray, vec4 tolerance)
{
  TerrainPath path = terrainClipPath(terrainMirrorRay(ray));
  TerrainStep at = terrainFirstStep(path);
  TerrainHit hit = terrainNoHit();
  bool ended = !(path.sBegin <= path.sEnd);
  // Bound of the nodes visited: PyramidTraversal.h.
  int most = 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop;
  int crossings = 0;
  bool small = false;
  // Two loops in turn, so that rays that run side by side do the same work at the same time. They
  // test at their ends: processors that run both sides of a branch then do no round in vain.
  do
  {
    do
    {
      if (!ended && at.level > 0)
      {
        ++crossings;
        TerrainSpan span = terrainNodeSpan(path, at);
        bool down;
        at = terrainVisitNode(path, at, span, tolerance, down, small);
        ended = (span.ends && !down) || small || crossings >= most;
      }
    } while (!ended && at.level > 0);
    do
    {
      if (!ended && at.level == 0)
      {
        ++crossings;
        TerrainSpan span = terrainNodeSpan(path, at);
        hit = terrainMeetCell(path, at, span);
        ended = span.ends || hit.found || crossings >= most;
        at = terrainNextStep(path, at, span, false, span.s);
      }
    } while (!ended && at.level == 0);
#ifdef TERRAIN_WITHIN
    if (small && !terrainCellValid(terrainCellCodes(at.cell ^ path.mirror)))
    {
      tolerance = vec4(0.0);
      small = false;
      ended = crossings >= most;
    }
#endif
  } while (!ended);
  if (small)
  {
    hit = terrainMeetBox(path, at);
  }
  hit.crossings = crossings;
  return hit;
}

// The first point of the surface on a ray.
TerrainHit terrainTracePyramid(TerrainRay ray)
{
  return terrainTracePyramidWithin(ray, vec4(0.0));
}
