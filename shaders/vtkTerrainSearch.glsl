// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Searches for the first point of the surface on a ray, by steps where the min-max pyramid lets it
// be. Needs vtkTerrainPyramid.glsl and its uniforms.
// Defines: TERRAIN_LINEAR, TERRAIN_EXPONENTIAL or, else, the equidistant search.
// Constants: terrainJustBelow (src/render/Features.h).
//
// Twins in src/core/: rays/HeightSearch.h, which documents the method and its parameters.

uniform int terrainSteps;          // all, or the short ones of an equidistant search
uniform int terrainLongSteps;      // further steps of double length of an equidistant search
uniform int terrainSecantSteps;    // steps of root polishing
uniform float terrainStepLength;   // of an equidistant search, in cells
uniform float terrainStepRelief;   // height codes that count as long as one cell
uniform int terrainStepLevel;      // level of the nodes in which steps are taken

// Height of a ray above the surface at a distance.
struct TerrainSample
{
  bool valid;   // there is a surface
  float s;
  float above;  // codes, < 0 below the surface
  float slope;  // change of above per unit of s, within the cell
};

// A search under way.
struct TerrainMarch
{
  TerrainSample last;
  TerrainSample next; // on the other side of the surface, if found
  bool found;
  bool ended;
  float begin;        // distance of the first step
  float dip;          // where to look between last and the step after it; < 0: nowhere
  int steps;          // taken
  int crossings;      // nodes visited and samples taken
};

// Distance of one step of terrainStepLength cells along a path.
float terrainStepDistance(TerrainPath path)
{
  return terrainStepLength /
    max(length(vec3(path.direction.xy, path.direction.z / terrainStepRelief)), 1e-30);
}

// The sample at a distance, of the cells from firstCell to lastCell.
TerrainSample terrainSamplePath(TerrainPath path, ivec2 firstCell, ivec2 lastCell, float s)
{
  vec2 position = path.origin.xy + path.direction.xy * s;
  ivec2 cell = clamp(ivec2(floor(position)) + path.anchor, firstCell, lastCell);
  vec4 codes = terrainCellCodes(cell ^ path.mirror);
  bool valid = terrainCellValid(codes);
  codes -= path.anchorCode;
  vec2 fraction = terrainCellFraction(path, cell, s, 0, 0.0);
  vec2 move = mix(path.direction.xy, -path.direction.xy, notEqual(path.mirror, ivec2(0)));
  return TerrainSample(valid, s,
    path.origin.z + path.direction.z * s - terrainPatchCode(codes, fraction),
    path.direction.z - dot(terrainPatchGradient(codes, fraction), move));
}

// Distance where the line through two samples meets the surface's height, between them; weights, 0
// to 1, of their heights above it: of regula falsi, which halves that of an end that stays.
float terrainSecant(TerrainSample a, TerrainSample b, float weightA, float weightB)
{
  float above = a.above * weightA;
  float difference = above - b.above * weightB;
  float t = difference != 0.0 ? above / difference : 0.0;
  return a.s + clamp(t, 0.0, 1.0) * (b.s - a.s);
}

// Of two samples on one side of the surface, the distance between them where the ray is on the
// other, or may be; -1 if nowhere.
float terrainDip(TerrainSample a, TerrainSample b)
{
  float side = a.above < 0.0 ? -1.0 : 1.0;
  float interval = b.s - a.s;
  bool parabola = terrainStepLevel == 0;
  float opening = side * b.slope;
  float fall = side * (a.above - b.above);
  float closing = parabola ? -2.0 * fall / interval - opening : side * a.slope;
  float t = (parabola ? -closing * interval : fall + opening * interval) / (opening - closing);
  float lowest = side * a.above + (parabola ? 0.5 : 1.0) * closing * t;
  return closing < 0.0 && opening > 0.0 && t > 0.0 && t < interval && lowest < 0.0 ? a.s + t : -1.0;
}

// The part of the path at whose end a step from a place on ends at the latest: a cell, or all the
// rest.
TerrainSpan terrainStepSpan(TerrainPath path, TerrainStep at)
{
  TerrainSpan span = TerrainSpan(path.lastCell, false, true, path.sEnd, 0.0);
#if !defined(TERRAIN_LINEAR) && !defined(TERRAIN_EXPONENTIAL)
  if (terrainStepLevel == 0)
  {
    span = terrainNodeSpan(path, at);
  }
#endif
  return span;
}

// Distance where the next step ends.
float terrainNextSample(TerrainPath path, TerrainMarch march)
{
#if defined(TERRAIN_LINEAR)
  return march.begin +
    float(march.steps + 1) / float(terrainSteps) * (path.sEnd - march.begin);
#elif defined(TERRAIN_EXPONENTIAL)
  return march.begin + exp2(float(march.steps + 1 - terrainSteps)) * (path.sEnd - march.begin);
#else
  return march.last.s + (march.steps < terrainSteps ? 1.0 : 2.0) * terrainStepDistance(path);
#endif
}

// True if all steps have been taken.
bool terrainHasStepped(TerrainMarch march)
{
#if defined(TERRAIN_LINEAR) || defined(TERRAIN_EXPONENTIAL)
  return march.steps >= terrainSteps;
#else
  return march.steps >= terrainSteps + terrainLongSteps;
#endif
}

// Samples where steps begin, unless the last step has ended there. What lies within rounding of
// the surface counts as on the side that the ray comes from.
void terrainBeginSteps(TerrainPath path, TerrainStep at, inout TerrainMarch march)
{
  if (at.s != march.last.s || !march.last.valid)
  {
    TerrainSpan span = terrainStepSpan(path, at);
    march.last = terrainSamplePath(path, at.cell, span.lastCell, at.s);
    float above = march.last.above;
    float side = march.last.slope > 0.0 ? min(above, -terrainJustBelow) : max(above, 0.0);
    march.last.above = abs(above) < 2.0 * path.slack ? side : above;
    march.begin = march.steps == 0 ? at.s : march.begin;
    ++march.crossings;
  }
}

// Where a step has got to: in its cell or the next, or, with longer steps, to be visited again.
TerrainStep terrainStepTo(TerrainPath path, TerrainStep at, TerrainSpan span, float s)
{
  vec2 position = path.origin.xy + path.direction.xy * s;
  ivec2 cell = clamp(ivec2(floor(position)) + path.anchor, at.cell, span.lastCell);
  float z = path.origin.z + path.direction.z * s;
#if defined(TERRAIN_LINEAR) || defined(TERRAIN_EXPONENTIAL)
  return TerrainStep(cell, at.level, s, z, 0);
#else
  TerrainStep next = terrainNextStep(path, at, span, false, span.s);
  bool leaves = terrainStepLevel == 0 && s >= span.s;
  int level = terrainStepLevel == 0 ? 0 : min(terrainStepLevel + 1, terrainPyramidTop);
  return TerrainStep(leaves ? next.cell : cell, leaves ? next.level : level, s, z,
    leaves ? next.line : 0);
#endif
}

// One step, or a look at a dip between two.
TerrainStep terrainTakeStep(TerrainPath path, TerrainStep at, inout TerrainMarch march)
{
  TerrainSpan span = terrainStepSpan(path, at);
  bool looks = march.dip >= 0.0;
  float s = looks ? march.dip : min(terrainNextSample(path, march), span.s);
  march.next = terrainSamplePath(path, at.cell, span.lastCell, s);
  ++march.crossings;
  bool both = march.last.valid && march.next.valid;
  march.found = both && (march.last.above < 0.0) != (march.next.above < 0.0);
#if defined(TERRAIN_LINEAR) || defined(TERRAIN_EXPONENTIAL)
  march.dip = -1.0;
#else
  march.dip = both && !march.found && !looks ? terrainDip(march.last, march.next) : -1.0;
#endif
  if (march.found || march.dip >= 0.0)
  {
    march.ended = march.found;
    return at;
  }
  march.last = march.next;
  march.steps += looks ? 0 : 1;
  march.ended = (s >= span.s && span.ends) || terrainHasStepped(march);
  return terrainStepTo(path, at, span, s);
}

// Root polishing between the last samples; nothing is found where there are no data.
TerrainHit terrainPolish(TerrainPath path, TerrainStep at, TerrainMarch march)
{
  TerrainSample a = march.last;
  TerrainSample b = march.next;
  ivec2 lastCell = terrainStepSpan(path, at).lastCell;
  float weightA = 1.0;
  float weightB = 1.0;
  bool valid = true;
  for (int i = 0; i < terrainSecantSteps; ++i)
  {
    TerrainSample c =
      terrainSamplePath(path, at.cell, lastCell, terrainSecant(a, b, weightA, weightB));
    valid = valid && c.valid;
    bool sideOfA = (c.above < 0.0) == (a.above < 0.0);
    weightA = sideOfA ? 1.0 : 0.5 * weightA;
    weightB = sideOfA ? 0.5 * weightB : 1.0;
    if (sideOfA)
    {
      a = c;
    }
    else
    {
      b = c;
    }
  }
  TerrainHit hit;
  hit.s = terrainSecant(a, b, 1.0, 1.0);
  vec2 position = path.origin.xy + path.direction.xy * hit.s;
  ivec2 cell = clamp(ivec2(floor(position)) + path.anchor, at.cell, lastCell);
  hit.cell = cell ^ path.mirror;
  hit.fraction = terrainCellFraction(path, cell, hit.s, 0, 0.0);
  hit.found = valid && terrainCellValid(terrainCellCodes(hit.cell));
  hit.crossings = march.crossings + terrainSecantSteps;
  return hit;
}

// The first point of the surface on a ray, as the steps find it.
TerrainHit terrainSearch(TerrainRay ray)
{
  TerrainPath path = terrainClipPath(terrainMirrorRay(ray));
  TerrainStep at = terrainFirstStep(path);
  TerrainSample none = TerrainSample(false, 0.0, 0.0, 0.0);
  TerrainMarch march = TerrainMarch(none, none, false, false, 0.0, -1.0, 0, 0);
  march.ended = !(path.sBegin <= path.sEnd) || terrainHasStepped(march);
  bool small;
  // Loops in turn, which test at their ends: see terrainTracePyramidWithin().
  do
  {
    do
    {
      if (!march.ended && at.level > terrainStepLevel)
      {
        ++march.crossings;
        TerrainSpan span = terrainNodeSpan(path, at);
        bool down;
        at = terrainVisitNode(path, at, span, vec4(0.0), down, small);
        march.ended = span.ends && !down;
      }
    } while (!march.ended && at.level > terrainStepLevel);
    if (!march.ended)
    {
      terrainBeginSteps(path, at, march);
    }
    do
    {
      if (!march.ended && at.level <= terrainStepLevel)
      {
        at = terrainTakeStep(path, at, march);
      }
    } while (!march.ended && march.next.valid && at.level <= terrainStepLevel);
  } while (!march.ended);
  TerrainHit hit = terrainNoHit();
  hit.crossings = march.crossings;
  if (march.found)
  {
    hit = terrainPolish(path, at, march);
  }
  return hit;
}
