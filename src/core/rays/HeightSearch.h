// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Searches for the first point of the surface on a ray that starts at the coarse mesh. Twin of
 * shaders/vtkTerrainSearch.glsl: the same functions (there with the prefix terrain).
 *
 * Source: Zsolt Feher, "Terrain Rendering with the Combination of Mesh Simplification and
 * Displacement Mapping", section 4. Samples are taken along the part of the ray that lies over the
 * grid and between the lowest and the highest code (downward rays end at H = 0, upward rays at
 * H = 1). Two samples on different sides of the surface bracket a hit, which secant steps narrow.
 *   SearchLinear       N equal steps over the segment; the paper takes 4 or 5
 *   SearchExponential  step i at H = 1 - 1 / 2^(N - 1 - i) (eq. 3, table 1); the paper takes 10
 *   SearchEquidistant  steps of one length whatever the slope of the ray (eq. 4-5), then steps of
 *                      double length, then none; the paper takes 5 steps of 0.025 of the grid's
 *                      extent for a mesh of 32 x 32 quads, 10 long ones, 2 secant steps
 *
 * Departures from the paper:
 * - A hit is a change of sign either way, so that the surface is seen from below as well.
 * - A search ends where the ray has risen above the coarse mesh, that is, farther above the surface
 *   than the mesh lies anywhere: if the ray meets the mesh again, it starts a search of its own.
 * - Lengths are counted in cells, and StepRelief height codes count as one cell. With StepRelief =
 *   codes / cells of the longer side, that is the paper's measure in the unit cube.
 * - Where two samples lie on one side but their tangents meet on the other, a third is taken there:
 *   ridges thinner than a step are not passed by.
 * - Where the surface begins or ends between two samples, bisection finds the last one on it.
 * - The secant keeps its bracket and halves the weight of an end that stays (the Illinois rule).
 */
#ifndef terrain_HeightSearch_h
#define terrain_HeightSearch_h

#include "core/rays/Ray.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

namespace terrain
{
/// The parameters of the searches; each is a uniform of shaders/vtkTerrainSearch.glsl.
struct SearchParameters
{
  /// terrainSteps: all of a linear or exponential search, the short ones of an equidistant; >= 0.
  int Steps = 5;
  /// terrainLongSteps: further steps of double length of an equidistant search; >= 0.
  int LongSteps = 10;
  /// terrainSecantSteps: steps of root polishing; >= 0.
  int SecantSteps = 2;
  /// terrainStepLength: length of a short step, in cells; > 0.
  float StepLength = 1.0f;
  /// terrainStepRelief: height codes that count as long as one cell; > 0.
  float StepRelief = 1.0f;
  /// terrainLargestGap: highest that the coarse mesh lies above the surface, in codes. For rays
  /// that do not start at the mesh: the largest float.
  float LargestGap = 3e38f;
};

/// The searches, by the paper's names.
enum class SearchKind
{
  Linear,
  Exponential,
  Equidistant
};

/// What default parameters are chosen from.
struct SearchScene
{
  /// Samples of the grid.
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  /// Cells along a side of a quad of the coarse mesh.
  std::int64_t CellsPerQuad = 1;
  /// Largest vertical distance of mesh and surface, and largest code, in codes.
  double LargestGap = 0.0;
  double MaximumCode = 0.0;
  /// Height codes that are as long as one cell as drawn: spacing / (exaggeration * scale); > 0.
  double CodesPerCell = 1.0;
};

/**
 * Parameters from the mesh itself, such that a default picture has no visible hole.
 * Equidistant: steps of kDefaultStepLength cells, over at least the longest way that a ray can have
 * over the grid, so that it never gives up within the mesh. Linear: as many steps, at most
 * kDefaultLinearSteps. Exponential: kDefaultExponentialSteps; the last steps of
 * this search are a half and a quarter of the ray, however many come before, so it has holes where
 * rays are flat (section 4.3). The paper's own values: PaperSearchParameters().
 */
SearchParameters ChooseSearchParameters(const SearchScene& scene, SearchKind kind);

/// The paper's values for a mesh of 32 x 32 quads, the step length scaled to the quads in use.
SearchParameters PaperSearchParameters(const SearchScene& scene, SearchKind kind);

/// Values behind ChooseSearchParameters().
constexpr float kDefaultStepLength = 0.75f;
constexpr int kDefaultLinearSteps = 4096;
constexpr int kDefaultExponentialSteps = 16;
constexpr int kDefaultSecantSteps = 4;

/// Halvings of a step in which the surface begins or ends.
constexpr int kEdgeSteps = 8;

/// The searches over heights that have Code() and CellCodes() as CodedHeights and its members size
/// and maximumCode.
template <typename Heights>
struct HeightSearch
{
  Heights heights;
  SearchParameters parameters;

  /// Height of a ray above the surface at a distance.
  struct Sample
  {
    bool valid; ///< there is a surface
    float s;
    float above; ///< codes, < 0 below the surface
    float slope; ///< change of above per unit of s, within the cell
  };

  /// A search under way.
  struct March
  {
    bool running;
    Sample last;
    TerrainHit hit;
  };

  /// The part of the distances range.x to range.y where low <= origin + s * direction <= high;
  /// empty, range.x > range.y, if there is none.
  static glm::vec2 ClipToSlab(glm::vec2 range, float origin, float direction, float low, float high)
  {
    if (std::abs(direction) < 1e-30f)
    {
      return origin >= low && origin <= high ? range : glm::vec2(1.0f, 0.0f);
    }
    const float atLow = (low - origin) / direction;
    const float atHigh = (high - origin) / direction;
    return { glm::max(range.x, glm::min(atLow, atHigh)),
      glm::min(range.y, glm::max(atLow, atHigh)) };
  }

  /// The distances to search: above the grid's rectangle, and down to code 0 or up to the largest
  /// code.
  glm::vec2 Segment(const TerrainRay& ray) const
  {
    if (this->heights.size.x < 2 || this->heights.size.y < 2)
    {
      return { 1.0f, 0.0f };
    }
    const glm::vec2 low(-ray.anchorCell);
    const glm::vec2 high(this->heights.size - 1 - ray.anchorCell);
    const float margin = 1e-4f * glm::max(this->heights.maximumCode, this->parameters.StepRelief);
    glm::vec2 range(ray.sBegin, ray.sEnd);
    range = ClipToSlab(range, ray.originGC.x, ray.directionGC.x, low.x, high.x);
    range = ClipToSlab(range, ray.originGC.y, ray.directionGC.y, low.y, high.y);
    return ClipToSlab(
      range, ray.originGC.z, ray.directionGC.z, -margin, this->heights.maximumCode + margin);
  }

  /// Distance of one step of StepLength cells.
  float StepDistance(const TerrainRay& ray) const
  {
    const glm::vec3 direction(
      ray.directionGC.x, ray.directionGC.y, ray.directionGC.z / this->parameters.StepRelief);
    return this->parameters.StepLength / glm::max(glm::length(direction), 1e-30f);
  }

  /// The cell at a distance; positions beyond the border count as on it.
  glm::ivec2 CellAt(const TerrainRay& ray, const glm::vec3& positionGC) const
  {
    return glm::clamp(ray.anchorCell + glm::ivec2(glm::floor(glm::vec2(positionGC))), glm::ivec2(0),
      this->heights.size - 2);
  }

  /// Position within a cell, 0..1.
  static glm::vec2 FractionAt(
    const TerrainRay& ray, const glm::vec3& positionGC, const glm::ivec2& cell)
  {
    return glm::clamp(
      glm::vec2(positionGC) - glm::vec2(cell - ray.anchorCell), glm::vec2(0.0f), glm::vec2(1.0f));
  }

  static bool IsCellValid(const glm::vec4& codes)
  {
    return codes.x >= 0.0f && codes.y >= 0.0f && codes.z >= 0.0f && codes.w >= 0.0f;
  }

  static float PatchCodeAt(const glm::vec4& codes, const glm::vec2& fraction)
  {
    return glm::mix(
      glm::mix(codes.x, codes.y, fraction.x), glm::mix(codes.z, codes.w, fraction.x), fraction.y);
  }

  Sample SampleRay(const TerrainRay& ray, float s) const
  {
    const glm::vec3 positionGC = ray.originGC + s * ray.directionGC;
    const glm::ivec2 cell = this->CellAt(ray, positionGC);
    const glm::vec4 codes = this->heights.CellCodes(cell);
    const glm::vec2 fraction = FractionAt(ray, positionGC, cell);
    return { IsCellValid(codes), s, positionGC.z - PatchCodeAt(codes, fraction),
      ray.directionGC.z - glm::dot(PatchGradient(codes, fraction), glm::vec2(ray.directionGC)) };
  }

  /// Where the line through two samples meets the surface's height, between them.
  static float Secant(const Sample& a, const Sample& b, float weightA, float weightB)
  {
    const float above = a.above * weightA;
    const float difference = above - b.above * weightB;
    const float t = difference != 0.0f ? above / difference : 0.0f;
    return glm::mix(a.s, b.s, glm::clamp(t, 0.0f, 1.0f));
  }

  Sample ValidEdge(const TerrainRay& ray, Sample a, Sample b, March& march) const;
  Sample Dip(const TerrainRay& ray, const Sample& a, const Sample& b, March& march) const;
  void Polish(const TerrainRay& ray, Sample a, Sample b, March& march) const;
  March MarchFrom(const TerrainRay& ray, const glm::vec2& segment) const;
  void MarchTo(const TerrainRay& ray, float s, float end, March& march) const;
  TerrainHit SearchLinear(const TerrainRay& ray) const;
  TerrainHit SearchExponential(const TerrainRay& ray) const;
  TerrainHit SearchEquidistant(const TerrainRay& ray) const;
};

//------------------------------------------------------------------------------
/// Of two samples one of which is valid, the valid one after moving them together to where the
/// surface begins or ends, to StepLength / 2^kEdgeSteps.
template <typename Heights>
typename HeightSearch<Heights>::Sample HeightSearch<Heights>::ValidEdge(
  const TerrainRay& ray, Sample a, Sample b, March& march) const
{
  for (int i = 0; i < kEdgeSteps; ++i)
  {
    const Sample c = this->SampleRay(ray, 0.5f * (a.s + b.s));
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
  return a.valid ? a : b;
}

//------------------------------------------------------------------------------
/// Of two samples on one side of the surface, the place between them where the ray may be on the
/// other: where the tangents meet, if that is on the other side. Else b.
template <typename Heights>
typename HeightSearch<Heights>::Sample HeightSearch<Heights>::Dip(
  const TerrainRay& ray, const Sample& a, const Sample& b, March& march) const
{
  const float side = a.above < 0.0f ? -1.0f : 1.0f;
  const float closing = side * a.slope;
  const float opening = side * b.slope;
  if (closing >= 0.0f || opening <= 0.0f)
  {
    return b;
  }
  const float interval = b.s - a.s;
  const float t = (side * (a.above - b.above) + opening * interval) / (opening - closing);
  if (!(t > 0.0f && t < interval) || side * a.above + closing * t >= 0.0f)
  {
    return b;
  }
  ++march.hit.crossings;
  return this->SampleRay(ray, a.s + t);
}

//------------------------------------------------------------------------------
/// Root polishing between two samples on different sides; march.hit.found stays false where there
/// are no data.
template <typename Heights>
void HeightSearch<Heights>::Polish(const TerrainRay& ray, Sample a, Sample b, March& march) const
{
  float weightA = 1.0f;
  float weightB = 1.0f;
  for (int i = 0; i < this->parameters.SecantSteps; ++i)
  {
    const Sample c = this->SampleRay(ray, Secant(a, b, weightA, weightB));
    ++march.hit.crossings;
    if (!c.valid)
    {
      return;
    }
    const bool sideOfA = (c.above < 0.0f) == (a.above < 0.0f);
    weightA = sideOfA ? 1.0f : 0.5f * weightA;
    weightB = sideOfA ? 0.5f * weightB : 1.0f;
    if (sideOfA)
    {
      a = c;
    }
    else
    {
      b = c;
    }
  }
  march.hit.s = Secant(a, b, 1.0f, 1.0f);
  const glm::vec3 positionGC = ray.originGC + march.hit.s * ray.directionGC;
  march.hit.cell = this->CellAt(ray, positionGC);
  march.hit.fraction = FractionAt(ray, positionGC, march.hit.cell);
  march.hit.found = IsCellValid(this->heights.CellCodes(march.hit.cell));
}

//------------------------------------------------------------------------------
/// The first sample of a search. What rounding puts just below the surface counts as on it.
template <typename Heights>
typename HeightSearch<Heights>::March HeightSearch<Heights>::MarchFrom(
  const TerrainRay& ray, const glm::vec2& segment) const
{
  March march{ segment.x <= segment.y, { false, segment.x, 0.0f, 0.0f }, TerrainHit{} };
  if (march.running)
  {
    march.last = this->SampleRay(ray, segment.x);
    ++march.hit.crossings;
    const float rounding = 2e-6f * (this->heights.maximumCode + this->parameters.StepRelief);
    march.last.above =
      std::abs(march.last.above) < rounding ? glm::max(march.last.above, 0.0f) : march.last.above;
  }
  return march;
}

//------------------------------------------------------------------------------
/// One step of a search, to distance s. Stops at a hit, at the end of the segment, and where the
/// ray has risen above the coarse mesh.
template <typename Heights>
void HeightSearch<Heights>::MarchTo(const TerrainRay& ray, float s, float end, March& march) const
{
  const Sample next = this->SampleRay(ray, glm::min(s, end));
  ++march.hit.crossings;
  if (march.last.valid || next.valid)
  {
    const bool both = march.last.valid == next.valid;
    const Sample edge = both ? next : this->ValidEdge(ray, march.last, next, march);
    const Sample a = march.last.valid ? march.last : edge;
    const Sample b = next.valid ? next : edge;
    const bool crosses = (a.above < 0.0f) != (b.above < 0.0f);
    const Sample c = crosses ? b : this->Dip(ray, a, b, march);
    if (c.valid && (a.above < 0.0f) != (c.above < 0.0f))
    {
      this->Polish(ray, a, c, march);
    }
    march.running = b.above <= this->parameters.LargestGap || b.above <= a.above;
  }
  march.running = march.running && !march.hit.found && s < end;
  march.last = next;
}

//------------------------------------------------------------------------------
/// Equal steps from the beginning to the end of the segment.
template <typename Heights>
TerrainHit HeightSearch<Heights>::SearchLinear(const TerrainRay& ray) const
{
  const glm::vec2 segment = this->Segment(ray);
  March march = this->MarchFrom(ray, segment);
  for (int i = 0; i < this->parameters.Steps && march.running; ++i)
  {
    const float t = static_cast<float>(i + 1) / static_cast<float>(this->parameters.Steps);
    this->MarchTo(ray, glm::mix(segment.x, segment.y, t), segment.y, march);
  }
  return march.hit;
}

//------------------------------------------------------------------------------
/// Steps that double: at H = 1 - 1 / 2^(N - 1 - i), where H is 1 at the beginning and 0 at the end
/// (eq. 3).
template <typename Heights>
TerrainHit HeightSearch<Heights>::SearchExponential(const TerrainRay& ray) const
{
  const glm::vec2 segment = this->Segment(ray);
  March march = this->MarchFrom(ray, segment);
  for (int i = 0; i < this->parameters.Steps && march.running; ++i)
  {
    const float h = 1.0f - std::exp2(static_cast<float>(i + 1 - this->parameters.Steps));
    this->MarchTo(ray, glm::mix(segment.y, segment.x, h), segment.y, march);
  }
  return march.hit;
}

//------------------------------------------------------------------------------
/// Steps of one length whatever the ray's slope, then of double length (eq. 4-5); then no hit.
template <typename Heights>
TerrainHit HeightSearch<Heights>::SearchEquidistant(const TerrainRay& ray) const
{
  const glm::vec2 segment = this->Segment(ray);
  March march = this->MarchFrom(ray, segment);
  const float stepDistance = this->StepDistance(ray);
  float s = segment.x;
  const int steps = this->parameters.Steps;
  for (int i = 0; i < steps + this->parameters.LongSteps && march.running; ++i)
  {
    s += i < steps ? stepDistance : 2.0f * stepDistance;
    this->MarchTo(ray, s, segment.y, march);
  }
  return march.hit;
}
}

#endif
