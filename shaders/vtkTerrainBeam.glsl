// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Beams: a safe common start for all rays of a tile of pixels. Twin, with the documentation of the
// method and why it is conservative: src/core/PyramidBeam.h. Needs vtkTerrainPyramid.glsl and its
// uniforms; no further ones, no defines.

struct TerrainBeam
{
  TerrainRay ray; // in the middle of the tile
  vec3 radius;    // all rays of the tile lie in ray(s) -+ (radius + s * growth)
  vec3 growth;
};

// The edges of a beam's box, mirrored as the path: origin and change per unit of s.
struct TerrainBeamEdges
{
  vec3 low;
  vec3 lowMove;
  vec3 high;
  vec3 highMove;
};

const int terrainBeamSteps = 96;
const float terrainBeamMargin = 1e-6;

TerrainBeamEdges terrainBeamEdges(TerrainPath path, TerrainBeam beam)
{
  vec3 radius = beam.radius + terrainBeamMargin * (abs(path.origin) + 1.0) +
    vec3(0.0, 0.0, path.slack);
  vec3 growth = beam.growth + terrainBeamMargin * abs(path.direction);
  return TerrainBeamEdges(path.origin - radius, path.direction - growth, path.origin + radius,
    path.direction + growth);
}

// The distance, at least s, where the box reaches the grid along an axis; end if it never does.
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
  float above = edges.low.z - terrainMaximumCode;
  float below = -edges.high.z;
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

// The lowest level whose nodes are 4/3 as wide as the box, at least 1.
int terrainBeamLevel(TerrainBeamEdges edges, float s)
{
  vec2 width = edges.high.xy - edges.low.xy + (edges.highMove.xy - edges.lowMove.xy) * s;
  return int(ceil(log2(max(max(width.x, width.y) * (4.0 / 3.0), 2.0))));
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

// Highest and lowest code of the nodes (block.x + 0..1, block.y + 0..1) of a level, mirrored.
vec2 terrainBlockBounds(TerrainPath path, ivec2 block, int level)
{
  ivec2 near = max(block ^ path.mirror, ivec2(0));
  ivec2 far = max((block + 1) ^ path.mirror, ivec2(0));
  vec2 a = terrainNodeExtremes(near, level);
  vec2 b = terrainNodeExtremes(ivec2(far.x, near.y), level);
  vec2 c = terrainNodeExtremes(ivec2(near.x, far.y), level);
  vec2 d = terrainNodeExtremes(far, level);
  return vec2(max(max(a.x, b.x), max(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
}

// A distance sBegin <= s <= sEnd of the beam's ray that no ray of the tile has met the surface
// before; sEnd if none does at all.
float terrainBeamStart(TerrainBeam beam)
{
  TerrainPath path = terrainMirrorRay(beam.ray);
  TerrainBeamEdges edges = terrainBeamEdges(path, beam);
  float s = terrainPyramidTop < 1 ? path.sEnd : terrainBeamEntry(path, edges);
  int level = min(terrainBeamLevel(edges, s) + 2, terrainPyramidTop);
  bool stops = false;
  for (int i = 0; i < terrainBeamSteps && !stops && s < path.sEnd; ++i)
  {
    ivec2 block = (ivec2(floor(edges.low.xy + edges.lowMove.xy * s)) + path.anchor) >> level;
    int size = 1 << level;
    float leaves = max(terrainBeamLeaves(path, edges, block * size, (block + 2) * size), s);
    vec2 bounds = terrainBlockBounds(path, block, level);
    float lowest = edges.low.z + min(edges.lowMove.z * s, edges.lowMove.z * leaves);
    float highest = edges.high.z + max(edges.highMove.z * s, edges.highMove.z * leaves);
    bool clear = lowest > bounds.x || highest < bounds.y;
    // To where the box comes down to the highest, or up to the lowest height.
    float above = edges.low.z + edges.lowMove.z * s - bounds.x;
    float below = bounds.y - edges.high.z - edges.highMove.z * s;
    float fall = above > 0.0 ? above / -edges.lowMove.z : 0.0;
    float rise = below > 0.0 ? below / edges.highMove.z : 0.0;
    s = clear ? leaves : min(s + max(fall, rise), leaves);
    int lowestLevel = terrainBeamLevel(edges, s);
    stops = !clear && level - 1 < lowestLevel;
    level = min(clear ? max(level + 1, lowestLevel) : level - 1, terrainPyramidTop);
  }
  return min(s, path.sEnd);
}
