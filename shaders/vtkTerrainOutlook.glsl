// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How high the surface stands before a light: the horizon of a point of the surface in one
// direction, through the max pyramid. Needs vtkTerrainPyramid.glsl; for columns,
// vtkTerrainColumns.glsl; for tiles, vtkTerrainTileTrace.glsl.
//
// The horizon is the highest tangent (h(s) - h(0)) / s over all distances s > 0 at which there is
// surface, as in src/core/rays/Horizon.h; the ground is solid, so that no light comes up through a
// hole. The ray starts on the surface itself. Its own patch counts by the slope b and the bend a
// that the patch has in the direction: the tangent there is b + a s, in which h(0) does not appear.
// No distance and no height is added to get off the surface. Beyond, the ray that runs at the
// horizon so far goes through the pyramid as in vtkTerrainPyramid.glsl, and rises where it meets
// something higher. Tangents are in height codes per cell.
//
// Twins in src/core/: rays/Outlook.h, node for node; of bounds, rays/ShadowBounds.h.

// A way over the grid from a point of the surface.
struct TerrainOutlook
{
  ivec2 cell;
  vec2 fraction;   // position in the cell, 0..1
  vec4 codes;      // of the cell's corners
  float code;      // height code of the point
  vec2 direction;  // of length 1, in cells
  float low;       // tangents, codes per cell: lower horizons count as this
  float high;      // the search ends where the horizon is higher
  float end;       // distance at which it ends, cells
  bool bounded;    // the rays are those of terrainShadowBounds
};

#ifdef TERRAIN_SHADOW_BOUNDS
// Bounds of what stands before rays of one direction: src/core/rays/ShadowBounds.h, which documents
// all. Constant: terrainShadowMargin, kShadowMargin there.
uniform sampler2D terrainShadowBounds; // a texel a node: columns along the rays, rows of strips
uniform vec4 terrainBoundsAxes;  // Major, Minor: the axes along and across, in cells
uniform vec4 terrainBoundsPlace; // MajorStart, Slope, FirstStrip; nodes a cell
uniform vec2 terrainBoundsRises; // LowRise, HighRise: codes per cell
uniform int terrainBoundsLevel;  // Level: rays ask the bounds in nodes of this level and above

// A ray among the bounds.
struct TerrainShadowStrip
{
  int strip;
  float column;   // where it starts, in columns
  float pace;     // columns a cell
  vec2 codes;     // its own numbers with both rises
};

// Where the ray of an outlook runs among the bounds of its direction.
TerrainShadowStrip terrainFindShadowStrip(TerrainOutlook outlook)
{
  vec2 position = vec2(outlook.cell) + outlook.fraction;
  float major = dot(terrainBoundsAxes.xy, position) + terrainBoundsPlace.x;
  float across = dot(terrainBoundsAxes.zw, position) - terrainBoundsPlace.y * major;
  return TerrainShadowStrip(int((across - terrainBoundsPlace.z) * terrainBoundsPlace.w),
    major * terrainBoundsPlace.w,
    dot(terrainBoundsAxes.xy, outlook.direction) * terrainBoundsPlace.w,
    outlook.code - terrainBoundsRises * major);
}

// True if something hides the ray from the next column on.
bool terrainIsHidden(TerrainShadowStrip strip)
{
  int column = int(strip.column + 0.5 * terrainShadowMargin) + 1;
  return column < textureSize(terrainShadowBounds, 0).x &&
    strip.codes.y < texelFetch(terrainShadowBounds, ivec2(column, strip.strip), 0).y;
}

// True if the ray meets nothing from a distance in cells on.
bool terrainIsFree(TerrainShadowStrip strip, float s)
{
  ivec2 size = textureSize(terrainShadowBounds, 0);
  int column = clamp(int(strip.column + s * strip.pace - 0.5 * terrainShadowMargin), 0, size.x - 1);
  return strip.codes.x > texelFetch(terrainShadowBounds, ivec2(column, strip.strip), 0).x;
}
#endif

// The highest tangent to three points of the surface, height over distance (codes above the ray's
// origin, cells), that lie above the ray of a tangent by more than rounding, codes; else that
// tangent.
float terrainRaise(float tangent, vec3 heights, vec3 distances, float rounding)
{
  vec3 tangents = mix(vec3(tangent), heights / max(distances, vec3(1e-9)),
    greaterThan(heights - tangent * distances, vec3(rounding)));
  return max(max(tangents.x, tangents.y), max(tangents.z, tangent));
}

#ifdef TERRAIN_COLUMNS
// The tangent of a ray that has passed the columns of a cell, which are level: each is highest at
// its near end if it stands above the ray's origin, else at its far end. Arguments: as of the
// function of patches below.
float terrainPassCell(
  float tangent, vec4 codes, float originCode, vec2 begin, vec2 end, vec2 span, float rounding)
{
  bvec2 from = greaterThanEqual(begin, vec2(0.5));
  bvec2 to = greaterThanEqual(end, vec2(0.5));
  vec2 wall = mix(vec2(1.0), clamp((0.5 - begin) / (end - begin), vec2(0.0), vec2(1.0)),
    notEqual(from, to));
  bvec2 between = wall.x <= wall.y ? bvec2(to.x, from.y) : bvec2(from.x, to.y);
  vec3 heights = vec3(terrainColumnCode(codes, from), terrainColumnCode(codes, between),
                   terrainColumnCode(codes, to)) - originCode;
  vec2 walls = mix(span.xx, span.yy, vec2(min(wall.x, wall.y), max(wall.x, wall.y)));
  vec3 nearEnds = vec3(span.x, walls);
  vec3 farEnds = vec3(walls, span.y);
  tangent = terrainRaise(tangent, heights, nearEnds, rounding);
  return terrainRaise(tangent, heights, farEnds, rounding);
}
#else
// The tangent of a ray that has passed the patch of a cell between two positions in it, as
// fractions 0..1, and two distances in cells (span). Codes are those of the cell's corners and of
// the ray's origin; rounding: codes by which heights may be off.
//
// Over the ray the height is c + b u + a u^2 for u = 0..1, and the tangent to it highest at an end
// or, if a < 0, where a L u^2 + 2 a s u + b s - L c = 0, with the distance s + L u.
float terrainPassCell(
  float tangent, vec4 codes, float originCode, vec2 begin, vec2 end, vec2 span, float rounding)
{
  vec2 move = end - begin;
  float bend = ((codes.x - codes.y) - (codes.z - codes.w)) * move.x * move.y;
  float atBegin = terrainPatchCode(codes - originCode, begin);
  float atEnd = terrainPatchCode(codes - originCode, end);
  float slope = atEnd - atBegin - bend;
  float length = span.y - span.x;
  float square = length * (slope * span.x - length * atBegin) / max(-bend, 1e-30);
  float root = span.x + sqrt(max(span.x * span.x + square, 0.0));
  float summit = bend < 0.0 ? clamp(square / max(length * root, 1e-20), 0.0, 1.0) : 0.0;
  return terrainRaise(tangent, vec3(atBegin, atEnd, atBegin + summit * (slope + summit * bend)),
    vec3(span, mix(span.x, span.y, summit)), rounding);
}
#endif

// Turns a path, and the height of the step on it, to a tangent: the heights on it have their origin
// at the point's own.
void terrainAim(inout TerrainPath path, inout TerrainStep at, float tangent)
{
  path.direction.z = tangent;
  path.inverse.z = abs(tangent) < 1e-30 ? 0.0 : 1.0 / tangent;
  at.z = path.origin.z + tangent * at.s;
}

// The horizon of the point's own cell: the tangent, and the step out of the cell.
float terrainLeaveCell(
  TerrainOutlook outlook, TerrainPath path, inout TerrainStep at, out bool ends)
{
  // A point on the far side of its cell leaves it at once: its own cell is the next.
  vec2 position = path.origin.xy - vec2(at.cell - path.anchor);
  at.cell += ivec2(greaterThanEqual(position, vec2(1.0))) *
    ivec2(greaterThan(path.direction.xy, vec2(0.0)));
  ends = any(greaterThan(at.cell, path.lastCell));
  at.cell = min(at.cell, path.lastCell);
  ivec2 cell = at.cell ^ path.mirror;
  vec4 codes = cell == outlook.cell ? outlook.codes : terrainCellCodes(cell);
  TerrainSpan span = terrainNodeSpan(path, at);
  vec2 begin = terrainCellFraction(path, at.cell, 0.0, 0, 0.0);
#ifdef TERRAIN_COLUMNS
  vec2 end =
    terrainCellFraction(path, at.cell, span.s, span.ends ? 0 : span.crossEast ? 1 : 2, 1.0);
  float tangent = terrainPassCell(outlook.low, codes, outlook.code, begin, end, vec2(0.0, span.s),
    1e-6 * terrainMaximumCode);
#else
  float slope = dot(terrainPatchGradient(codes, begin), outlook.direction);
  float bend =
    ((codes.x - codes.y) - (codes.z - codes.w)) * outlook.direction.x * outlook.direction.y;
  float tangent = max(outlook.low, slope + max(bend * span.s, 0.0));
#endif
  tangent = terrainCellValid(codes) ? tangent : outlook.low;
  ends = ends || span.ends;
  at = terrainNextStep(path, at, span, false, span.s);
#ifdef TERRAIN_TILES
  at.line = 0; // of cells, which nodes of coarser tiles do not have
#endif
  return tangent;
}

// The path of the ray from a point, and its first step. It ends where the lowest ray is above all
// codes. That one goes down does not end it: what is below all codes has the surface above it.
TerrainPath terrainOutlookPath(TerrainOutlook outlook, out TerrainStep at)
{
  float anchorCode = clamp(outlook.code, 0.0, terrainMaximumCode);
  TerrainRay ray = TerrainRay(outlook.cell, vec3(outlook.fraction, anchorCode),
    vec3(outlook.direction, max(outlook.low, 0.0)), 0.0, outlook.end, outlook.code - anchorCode);
  TerrainPath path = terrainMirrorRay(ray);
#ifndef TERRAIN_COLUMNS
  path.origin.z = terrainPatchCode(outlook.codes - anchorCode, outlook.fraction);
#endif
  path = terrainClipPath(path);
  ivec2 cell = clamp(outlook.cell ^ path.mirror, path.firstCell, path.lastCell);
  at = TerrainStep(cell, 0, 0.0, path.origin.z, 0);
  return path;
}

// The tangent of a ray that has passed a node by the patch over it, of these codes; of a cell,
// level 0.
float terrainPassNode(
  TerrainPath path, TerrainStep at, TerrainSpan span, vec4 codes, float tangent)
{
  int leaves = span.ends ? 0 : span.crossEast ? 1 : 2;
#ifdef TERRAIN_TILES
  vec2 begin = terrainNodeFraction(path, at.cell, at.level, at.s, at.line, 0.0);
  vec2 end = terrainNodeFraction(path, at.cell, at.level, span.s, leaves, 1.0);
#else
  vec2 begin = terrainCellFraction(path, at.cell, at.s, at.line, 0.0);
  vec2 end = terrainCellFraction(path, at.cell, span.s, leaves, 1.0);
#endif
  bool valid = terrainCellValid(codes);
  codes -= path.anchorCode;
  float rounding = 5e-7 * (dot(abs(codes), vec4(1.0)) + abs(at.z));
  float passed =
    terrainPassCell(tangent, codes, path.origin.z, begin, end, vec2(at.s, span.s), rounding);
  return valid ? passed : tangent;
}

// The step after a node whose highest code is given: down if the ray meets that, from where it
// does.
TerrainStep terrainPassTop(
  TerrainPath path, TerrainStep at, TerrainSpan span, float topCode, out bool down)
{
  float top = topCode - path.anchorCode + path.slack;
  down = min(at.z, span.z) <= top;
  float meets = path.direction.z < 0.0 ? at.s + (top - at.z) * path.inverse.z : at.s;
  return terrainNextStep(path, at, span, down, down ? clamp(meets, at.s, span.s) : span.s);
}

#ifdef TERRAIN_TILES
// The tangent at which a ray ends that goes on from a step through the nodes of tiles.
float terrainOutlookTiles(
  TerrainOutlook outlook, TerrainPath path, TerrainStep at, float tangent, bool ended)
{
  int most = 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop;
  int crossings = 0;
  while (!ended)
  {
    ++crossings;
    int slot = terrainFinestSlot(at.cell ^ path.mirror, at.level);
    ivec2 node = (at.cell >> at.level) ^ path.mirror;
    TERRAIN_VISIT(node, at.level)
    TerrainSpan span = terrainNodeSpan(path, at);
    bool down = true;
    TerrainStep next = at;
    if (at.level > 0)
    {
      next = terrainPassTop(path, at, span, terrainSlotBounds(node, at.level, slot).x, down);
    }
    int finer = max(at.level - 1, 0);
    if (down && (at.level == 0 || terrainTileSlot((next.cell >> finer) ^ path.mirror, finer) < 0))
    {
      tangent = terrainPassNode(path, at, span, terrainSlotCodes(node, slot), tangent);
      next = terrainNextStep(path, at, span, false, span.s);
      down = false;
    }
    ended = (span.ends && !down) || tangent > outlook.high || crossings >= most;
    at = next;
    terrainAim(path, at, tangent);
  }
  return tangent;
}
#else
// The tangent at which a ray ends that goes on from a step through the pyramid: two loops in turn,
// as in terrainTracePyramidWithin().
float terrainOutlookNodes(
  TerrainOutlook outlook, TerrainPath path, TerrainStep at, float tangent, bool ended)
{
#ifdef TERRAIN_SHADOW_BOUNDS
  TerrainShadowStrip strip = terrainFindShadowStrip(outlook);
  bool hidden = outlook.bounded && !ended && terrainIsHidden(strip);
  tangent = hidden ? 1e30 : tangent;
  ended = ended || hidden;
#endif
  int most = 2 * (terrainSize.x + terrainSize.y) + terrainPyramidTop;
  int crossings = 0;
  do
  {
    do
    {
      if (!ended && at.level > 0)
      {
        ++crossings;
#ifdef TERRAIN_SHADOW_BOUNDS
        if (outlook.bounded && at.level >= terrainBoundsLevel && terrainIsFree(strip, at.s))
        {
          ended = true;
          break;
        }
#endif
        ivec2 node = (at.cell >> at.level) ^ path.mirror;
        TERRAIN_VISIT(node, at.level)
        TerrainSpan span = terrainNodeSpan(path, at);
        bool down;
        at = terrainPassTop(path, at, span, terrainNodeExtremes(node, at.level).x, down);
        ended = (span.ends && !down) || crossings >= most;
      }
    } while (!ended && at.level > 0);
    do
    {
      if (!ended && at.level == 0)
      {
        ++crossings;
        ivec2 cell = at.cell ^ path.mirror;
        TERRAIN_VISIT(cell, 0)
        TerrainSpan span = terrainNodeSpan(path, at);
        tangent = terrainPassNode(path, at, span, terrainCellCodes(cell), tangent);
        ended = span.ends || tangent > outlook.high || crossings >= most;
        at = terrainNextStep(path, at, span, false, span.s);
        terrainAim(path, at, tangent);
      }
    } while (!ended && at.level == 0);
  } while (!ended);
  return tangent;
}
#endif

// The horizon of a point as a tangent: that of outlook.low if nothing is higher, and any that is
// above outlook.high for all such.
float terrainHorizonTangent(TerrainOutlook outlook)
{
  TerrainStep at;
  TerrainPath path = terrainOutlookPath(outlook, at);
  bool ended;
  float tangent = terrainLeaveCell(outlook, path, at, ended);
  ended = ended || tangent > outlook.high || !(path.sEnd > 0.0);
  terrainAim(path, at, tangent);
#ifdef TERRAIN_TILES
  return terrainOutlookTiles(outlook, path, at, tangent, ended);
#else
  return terrainOutlookNodes(outlook, path, at, tangent, ended);
#endif
}
