// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Searches for the first point of the surface on a ray, by steps. Twin: src/core/rays/HeightSearch.h, which
// documents the method and its parameters. Needs vtkTerrainHeights.glsl and vtkTerrainRay.glsl.

uniform int terrainSteps;          // steps: all of a linear or exponential search, short ones of an equidistant
uniform int terrainLongSteps;      // further steps of double length of an equidistant search
uniform int terrainSecantSteps;    // steps of root polishing
uniform float terrainStepLength;   // of an equidistant search, in cells
uniform float terrainStepRelief;   // height codes that count as long as one cell
uniform float terrainLargestGap;   // highest that the coarse mesh lies above the surface, codes

#define TERRAIN_EDGE_STEPS 8 // halvings of a step in which the surface begins or ends

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
  bool running;
  TerrainSample last;
  TerrainHit hit;
};

// The part of the distances range.x to range.y where low <= origin + s * direction <= high; empty, range.x
// > range.y, if there is none.
vec2 terrainClipToSlab(vec2 range, float origin, float direction, float low, float high)
{
  if (abs(direction) < 1e-30)
  {
    return origin >= low && origin <= high ? range : vec2(1.0, 0.0);
  }
  float atLow = (low - origin) / direction;
  float atHigh = (high - origin) / direction;
  return vec2(max(range.x, min(atLow, atHigh)), min(range.y, max(atLow, atHigh)));
}

// The distances to search: above the grid's rectangle, and down to code 0 or up to the largest code.
vec2 terrainSegment(TerrainRay ray)
{
  if (any(lessThan(terrainSize, ivec2(2))))
  {
    return vec2(1.0, 0.0);
  }
  vec2 low = vec2(-ray.anchorCell);
  vec2 high = vec2(terrainSize - 1 - ray.anchorCell);
  float margin = 1e-4 * max(terrainMaximumCode, terrainStepRelief);
  vec2 range = vec2(ray.sBegin, ray.sEnd);
  range = terrainClipToSlab(range, ray.originGC.x, ray.directionGC.x, low.x, high.x);
  range = terrainClipToSlab(range, ray.originGC.y, ray.directionGC.y, low.y, high.y);
  return terrainClipToSlab(
    range, ray.originGC.z, ray.directionGC.z, -margin, terrainMaximumCode + margin);
}

// Distance of one step of terrainStepLength cells.
float terrainStepDistance(TerrainRay ray)
{
  return terrainStepLength /
    max(length(vec3(ray.directionGC.xy, ray.directionGC.z / terrainStepRelief)), 1e-30);
}

// The cell at a distance; positions beyond the border count as on it.
ivec2 terrainCellAt(TerrainRay ray, vec3 positionGC)
{
  return clamp(ray.anchorCell + ivec2(floor(positionGC.xy)), ivec2(0), terrainSize - 2);
}

// Position within a cell, 0..1.
vec2 terrainFractionAt(TerrainRay ray, vec3 positionGC, ivec2 cell)
{
  return clamp(positionGC.xy - vec2(cell - ray.anchorCell), vec2(0.0), vec2(1.0));
}

TerrainSample terrainSampleRay(TerrainRay ray, float s)
{
  vec3 positionGC = ray.originGC + s * ray.directionGC;
  ivec2 cell = terrainCellAt(ray, positionGC);
  vec4 codes = terrainCellCodes(cell);
  vec2 fraction = terrainFractionAt(ray, positionGC, cell);
  return TerrainSample(terrainCellValid(codes), s, positionGC.z - terrainPatchCode(codes, fraction),
    ray.directionGC.z - dot(terrainPatchGradient(codes, fraction), ray.directionGC.xy));
}

// Where the line through two samples meets the surface's height, between them.
float terrainSecant(TerrainSample a, TerrainSample b, float weightA, float weightB)
{
  float above = a.above * weightA;
  float difference = above - b.above * weightB;
  float t = difference != 0.0 ? above / difference : 0.0;
  return mix(a.s, b.s, clamp(t, 0.0, 1.0));
}

// Of two samples one of which is valid, the valid one after moving them together to where the surface
// begins or ends.
TerrainSample terrainValidEdge(TerrainRay ray, TerrainSample a, TerrainSample b, inout TerrainMarch march)
{
  for (int i = 0; i < TERRAIN_EDGE_STEPS; ++i)
  {
    TerrainSample c = terrainSampleRay(ray, 0.5 * (a.s + b.s));
    ++march.hit.crossings;
    if (c.valid == a.valid)
    {
      a = c;
    }
    else
    {
      b = c;
    }
  }
  if (a.valid)
  {
    return a;
  }
  return b;
}

// Of two samples on one side of the surface, the place between them where the ray may be on the other:
// where the tangents meet, if that is on the other side. Else b.
TerrainSample terrainDip(TerrainRay ray, TerrainSample a, TerrainSample b, inout TerrainMarch march)
{
  float side = a.above < 0.0 ? -1.0 : 1.0;
  float closing = side * a.slope;
  float opening = side * b.slope;
  if (closing >= 0.0 || opening <= 0.0)
  {
    return b;
  }
  float interval = b.s - a.s;
  float t = (side * (a.above - b.above) + opening * interval) / (opening - closing);
  if (!(t > 0.0 && t < interval) || side * a.above + closing * t >= 0.0)
  {
    return b;
  }
  ++march.hit.crossings;
  return terrainSampleRay(ray, a.s + t);
}

// Root polishing between two samples on different sides; march.hit.found is false if there are no data.
void terrainPolish(TerrainRay ray, TerrainSample a, TerrainSample b, inout TerrainMarch march)
{
  float weightA = 1.0;
  float weightB = 1.0;
  for (int i = 0; i < terrainSecantSteps; ++i)
  {
    TerrainSample c = terrainSampleRay(ray, terrainSecant(a, b, weightA, weightB));
    ++march.hit.crossings;
    if (!c.valid)
    {
      return;
    }
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
  march.hit.s = terrainSecant(a, b, 1.0, 1.0);
  vec3 positionGC = ray.originGC + march.hit.s * ray.directionGC;
  march.hit.cell = terrainCellAt(ray, positionGC);
  march.hit.fraction = terrainFractionAt(ray, positionGC, march.hit.cell);
  march.hit.found = terrainCellValid(terrainCellCodes(march.hit.cell));
}

// The first sample of a search. What rounding puts just below the surface counts as on it.
TerrainMarch terrainMarchFrom(TerrainRay ray, vec2 segment)
{
  TerrainMarch march;
  march.hit = terrainNoHit();
  march.running = segment.x <= segment.y;
  march.last = TerrainSample(false, segment.x, 0.0, 0.0);
  if (march.running)
  {
    march.last = terrainSampleRay(ray, segment.x);
    ++march.hit.crossings;
    float rounding = 2e-6 * (terrainMaximumCode + terrainStepRelief);
    march.last.above =
      abs(march.last.above) < rounding ? max(march.last.above, 0.0) : march.last.above;
  }
  return march;
}

// One step of a search, to distance s. Stops at a hit, at the end of the segment, and where the ray has
// risen above the coarse mesh.
void terrainMarchTo(TerrainRay ray, float s, float end, inout TerrainMarch march)
{
  TerrainSample next = terrainSampleRay(ray, min(s, end));
  ++march.hit.crossings;
  if (march.last.valid || next.valid)
  {
    bool both = march.last.valid == next.valid;
    TerrainSample edge = next;
    if (!both)
    {
      edge = terrainValidEdge(ray, march.last, next, march);
    }
    TerrainSample a = edge;
    if (march.last.valid)
    {
      a = march.last;
    }
    TerrainSample b = edge;
    if (next.valid)
    {
      b = next;
    }
    TerrainSample c = b;
    if ((a.above < 0.0) == (b.above < 0.0))
    {
      c = terrainDip(ray, a, b, march);
    }
    if (c.valid && (a.above < 0.0) != (c.above < 0.0))
    {
      terrainPolish(ray, a, c, march);
    }
    march.running = b.above <= terrainLargestGap || b.above <= a.above;
  }
  march.running = march.running && !march.hit.found && s < end;
  march.last = next;
}

// Equal steps from the beginning to the end of the segment.
TerrainHit terrainSearchLinear(TerrainRay ray)
{
  vec2 segment = terrainSegment(ray);
  TerrainMarch march = terrainMarchFrom(ray, segment);
  for (int i = 0; i < terrainSteps && march.running; ++i)
  {
    float t = float(i + 1) / float(terrainSteps);
    terrainMarchTo(ray, mix(segment.x, segment.y, t), segment.y, march);
  }
  return march.hit;
}

// Steps that double: at H = 1 - 1 / 2^(N - 1 - i), where H is 1 at the beginning and 0 at the end (eq. 3).
TerrainHit terrainSearchExponential(TerrainRay ray)
{
  vec2 segment = terrainSegment(ray);
  TerrainMarch march = terrainMarchFrom(ray, segment);
  for (int i = 0; i < terrainSteps && march.running; ++i)
  {
    float h = 1.0 - exp2(float(i + 1 - terrainSteps));
    terrainMarchTo(ray, mix(segment.y, segment.x, h), segment.y, march);
  }
  return march.hit;
}

// Steps of one length whatever the ray's slope, then of double length (eq. 4-5); then no hit.
TerrainHit terrainSearchEquidistant(TerrainRay ray)
{
  vec2 segment = terrainSegment(ray);
  TerrainMarch march = terrainMarchFrom(ray, segment);
  float stepDistance = terrainStepDistance(ray);
  float s = segment.x;
  for (int i = 0; i < terrainSteps + terrainLongSteps && march.running; ++i)
  {
    s += i < terrainSteps ? stepDistance : 2.0 * stepDistance;
    terrainMarchTo(ray, s, segment.y, march);
  }
  return march.hit;
}
