// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Searches for the first point of the surface on a ray, by steps. Twin of
 * shaders/vtkTerrainSearch.glsl: the same functions (there with the prefix terrain).
 *
 * Source: Zsolt Feher, "Terrain Rendering with the Combination of Mesh Simplification and
 * Displacement Mapping", section 4. Two samples on different sides of the surface bracket a hit,
 * which secant steps narrow. Segments end at the border of the grid, and at H = 0 for downward, at
 * H = 1 for upward rays (section 4.1).
 *   Linear       N equal steps over the rest of the segment; the paper takes 4 or 5
 *   Exponential  step i at H = 1 - 1 / 2^(N - 1 - i) of it (eq. 3, table 1); the paper takes 10
 *   Equidistant  steps of one length whatever the slope of the ray (eq. 4-5), then steps of double
 *                length, then none; the paper takes 5 steps of 0.025 of the grid's extent for a
 *                mesh of 32 x 32 quads, 10 long ones, 2 secant steps
 *
 * Departures from the paper:
 * - Steps begin where the min-max pyramid first lets the surface be, not at the entry into the
 *   coarse mesh: "using height mipmaps ... the proper intersection always could be found rapidly"
 *   (section 6). So a picture does not depend on what the rays start from.
 * - Equidistant steps are taken only in the nodes of the pyramid that the ray does not clear, and
 * end at the sides of these nodes. The nodes are 2^StepLevel() cells wide, of which a step is at
 *   least as long: steps shorter than two cells stay in one cell. The difference of ray and surface
 *   is a parabola there, and what its ends and slopes tell is exact: no step passes by a thing
 *   in the cell, however thin.
 * - Where two equidistant samples of several cells lie on one side but their tangents meet on the
 *   other, a third is taken there: many ridges thinner than a step are not passed by.
 * - A hit is a change of sign either way, so that the surface is seen from below as well.
 * - Lengths are counted in cells, and StepRelief height codes count as one cell. With StepRelief =
 *   codes / cells of the longer side, that is the paper's measure in the unit cube.
 * - The secant keeps its bracket and halves the weight of an end that stays (the Illinois rule).
 */
#ifndef terrain_HeightSearch_h
#define terrain_HeightSearch_h

#include "core/rays/PyramidTraversal.h"
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

  /// terrainStepLevel: level of the pyramid in whose nodes steps are taken.
  int StepLevel() const;
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
  /// Largest code.
  double MaximumCode = 0.0;
  /// Height codes that are as long as one cell as drawn: spacing / (exaggeration * scale); > 0.
  double CodesPerCell = 1.0;
};

/**
 * Default parameters. Linear and Exponential: the paper's own, with the holes that the paper shows
 * (section 4.2, 4.3). Equidistant: as many steps as the longest ray over the grid can need, so that
 * it never gives up.
 */
SearchParameters ChooseSearchParameters(const SearchScene& scene, SearchKind kind);

/// The paper's values for a mesh of so many quads a side, whose step length is 0.025 of the
/// grid's extent where quads are 32. Source: section 4.4 and 5.
SearchParameters PaperSearchParameters(const SearchScene& scene, SearchKind kind, int quads);

/// The nearest parameters with which a search ends in bounded time: see the constants below.
SearchParameters BoundSearchParameters(const SearchParameters& parameters, SearchKind kind);

/// Values behind ChooseSearchParameters().
constexpr float kDefaultStepLength = 1.5f;
constexpr int kDefaultLinearSteps = 5;
constexpr int kDefaultExponentialSteps = 10;
constexpr int kDefaultSecantSteps = 6;
constexpr int kPaperSecantSteps = 2;

/// Values behind BoundSearchParameters(): steps of a linear or exponential, of an equidistant
/// search; secant steps; cells that an equidistant step is long.
constexpr int kMostSteps = 256;
constexpr int kMostEquidistantSteps = 1000000;
constexpr int kMostSecantSteps = 32;
constexpr float kLeastStepLength = 0.125f;
constexpr float kLargestStepLength = 1e6f;

/// Codes below the surface that tell its side and nothing else.
constexpr float kJustBelow = 1e-30f;

/// A search through heights and their pyramid.
template <typename Texel>
struct HeightSearch
{
  using Path = typename CodedPyramid<Texel>::Path;
  using Step = typename CodedPyramid<Texel>::Step;
  using Span = typename CodedPyramid<Texel>::Span;

  CodedPyramid<Texel> Coded;
  SearchParameters Parameters;
  SearchKind Kind = SearchKind::Equidistant;

  /// Height of a ray above the surface at a distance.
  struct Sample
  {
    bool valid = false; ///< there is a surface
    float s = 0.0f;
    float above = 0.0f; ///< codes, < 0 below the surface
    float slope = 0.0f; ///< change of above per unit of s, within the cell
  };

  /// A search under way.
  struct March
  {
    Sample last;
    Sample next; ///< on the other side of the surface, if found
    bool found = false;
    bool ended = false;
    float begin = 0.0f; ///< distance of the first step
    float dip = -1.0f;  ///< where to look between last and the step after it; < 0: nowhere
    int steps = 0;      ///< taken
    int crossings = 0;  ///< nodes visited and samples taken
  };

  /// Distance of one step of StepLength cells.
  float StepDistance(const Path& path) const
  {
    const glm::vec3 direction(
      path.direction.x, path.direction.y, path.direction.z / this->Parameters.StepRelief);
    return this->Parameters.StepLength / glm::max(glm::length(direction), 1e-30f);
  }

  /// The sample at a distance, of the cells from firstCell to lastCell. Visit(cell) is called for
  /// the cell, counted from the south-west.
  template <typename Visit>
  Sample SamplePath(const Path& path, const glm::ivec2& firstCell, const glm::ivec2& lastCell,
    float s, Visit&& visit) const;

  /// Where the line through two samples meets the surface's height, between them.
  static float Secant(const Sample& a, const Sample& b, float weightA, float weightB)
  {
    const float above = a.above * weightA;
    const float difference = above - b.above * weightB;
    const float t = difference != 0.0f ? above / difference : 0.0f;
    return a.s + glm::clamp(t, 0.0f, 1.0f) * (b.s - a.s);
  }

  /// Of two samples on one side of the surface, the distance between them where the ray is on the
  /// other, or may be; -1 if nowhere. Within a cell that is the vertex of the parabola through
  /// both with b's slope, over several cells the place where the tangents meet.
  float Dip(const Sample& a, const Sample& b) const;

  /// The part of the path at whose end a step from a place on ends at the latest: a cell, or all
  /// the rest.
  Span StepSpan(const Path& path, const Step& at) const
  {
    return this->Kind == SearchKind::Equidistant && this->Parameters.StepLevel() == 0
      ? this->Coded.NodeSpan(path, at)
      : Span{ path.lastCell, false, true, path.sEnd, 0.0f };
  }

  /// Where the next step ends.
  float NextSample(const Path& path, const March& march) const;
  /// True if all steps have been taken.
  bool HasStepped(const March& march) const
  {
    const int further = this->Kind == SearchKind::Equidistant ? this->Parameters.LongSteps : 0;
    return march.steps >= this->Parameters.Steps + further;
  }

  /// Samples where steps begin, unless the last step has ended there. What lies within rounding of
  /// the surface counts as on the side that the ray comes from.
  template <typename Visit>
  void BeginSteps(const Path& path, const Step& at, March& march, Visit&& visit) const;
  /// Where a step has got to: in its cell or the next, or, with longer steps, to be visited again.
  Step StepTo(const Path& path, const Step& at, const Span& span, float s) const;
  /// One step, or a look at a dip between two.
  template <typename Visit>
  Step TakeStep(const Path& path, const Step& at, March& march, Visit&& visit) const;
  /// Root polishing between the last samples; nothing is found where there are no data.
  TerrainHit Polish(const Path& path, const Step& at, const March& march) const;

  /// The first point of the surface on a ray, as the steps find it. Visit(cell) is called for every
  /// sample before those of root polishing, in order.
  template <typename Visit>
  TerrainHit Search(const TerrainRay& ray, Visit&& visit) const;
  TerrainHit Search(const TerrainRay& ray) const
  {
    return this->Search(ray, [](const glm::ivec2&) {});
  }
};

//------------------------------------------------------------------------------
template <typename Texel>
template <typename Visit>
typename HeightSearch<Texel>::Sample HeightSearch<Texel>::SamplePath(const Path& path,
  const glm::ivec2& firstCell, const glm::ivec2& lastCell, float s, Visit&& visit) const
{
  const glm::vec2 position = glm::vec2(path.origin) + glm::vec2(path.direction) * s;
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(position)) + path.anchor, firstCell, lastCell);
  visit(cell ^ path.mirror);
  glm::vec4 codes = this->Coded.heights.CellCodes(cell ^ path.mirror);
  const bool valid = this->Coded.IsCellValid(cell ^ path.mirror);
  codes -= path.anchorCode;
  const glm::vec2 fraction = this->Coded.CellFraction(path, cell, s, 0, 0.0f);
  const glm::vec2 direction(path.direction);
  const glm::vec2 move = glm::mix(direction, -direction, glm::notEqual(path.mirror, glm::ivec2(0)));
  return { valid, s, path.origin.z + path.direction.z * s - PatchCode(codes, fraction),
    path.direction.z - glm::dot(PatchGradient(codes, fraction), move) };
}

//------------------------------------------------------------------------------
template <typename Texel>
float HeightSearch<Texel>::Dip(const Sample& a, const Sample& b) const
{
  const float side = a.above < 0.0f ? -1.0f : 1.0f;
  const float interval = b.s - a.s;
  const bool parabola = this->Parameters.StepLevel() == 0;
  const float opening = side * b.slope;
  const float fall = side * (a.above - b.above);
  const float closing = parabola ? -2.0f * fall / interval - opening : side * a.slope;
  const float t =
    (parabola ? -closing * interval : fall + opening * interval) / (opening - closing);
  const float lowest = side * a.above + (parabola ? 0.5f : 1.0f) * closing * t;
  const bool dips = closing < 0.0f && opening > 0.0f && t > 0.0f && t < interval && lowest < 0.0f;
  return dips ? a.s + t : -1.0f;
}

//------------------------------------------------------------------------------
template <typename Texel>
float HeightSearch<Texel>::NextSample(const Path& path, const March& march) const
{
  const int next = march.steps + 1;
  switch (this->Kind)
  {
    case SearchKind::Linear:
      return march.begin +
        static_cast<float>(next) / static_cast<float>(this->Parameters.Steps) *
        (path.sEnd - march.begin);
    case SearchKind::Exponential:
      return march.begin +
        std::exp2(static_cast<float>(next - this->Parameters.Steps)) * (path.sEnd - march.begin);
    default:
      return march.last.s +
        (march.steps < this->Parameters.Steps ? 1.0f : 2.0f) * this->StepDistance(path);
  }
}

//------------------------------------------------------------------------------
template <typename Texel>
template <typename Visit>
void HeightSearch<Texel>::BeginSteps(
  const Path& path, const Step& at, March& march, Visit&& visit) const
{
  if (at.s != march.last.s || !march.last.valid)
  {
    const Span span = this->StepSpan(path, at);
    march.last = this->SamplePath(path, at.cell, span.lastCell, at.s, visit);
    const float above = march.last.above;
    march.last.above = std::abs(above) >= 2.0f * path.slack ? above
      : march.last.slope > 0.0f                             ? glm::min(above, -kJustBelow)
                                                            : glm::max(above, 0.0f);
    march.begin = march.steps == 0 ? at.s : march.begin;
    ++march.crossings;
  }
}

//------------------------------------------------------------------------------
template <typename Texel>
typename HeightSearch<Texel>::Step HeightSearch<Texel>::StepTo(
  const Path& path, const Step& at, const Span& span, float s) const
{
  const glm::vec2 position = glm::vec2(path.origin) + glm::vec2(path.direction) * s;
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(position)) + path.anchor, at.cell, span.lastCell);
  const float z = path.origin.z + path.direction.z * s;
  if (this->Kind != SearchKind::Equidistant)
  {
    return { cell, at.level, s, z, 0 };
  }
  const int level = this->Parameters.StepLevel();
  if (level > 0)
  {
    return { cell, std::min(level + 1, this->Coded.pyramid->LevelCount()), s, z, 0 };
  }
  const Step next = this->Coded.NextStep(path, at, span, false, span.s);
  return s >= span.s ? Step{ next.cell, next.level, s, z, next.line } : Step{ cell, 0, s, z, 0 };
}

//------------------------------------------------------------------------------
template <typename Texel>
template <typename Visit>
typename HeightSearch<Texel>::Step HeightSearch<Texel>::TakeStep(
  const Path& path, const Step& at, March& march, Visit&& visit) const
{
  const Span span = this->StepSpan(path, at);
  const bool looks = march.dip >= 0.0f;
  const float s = looks ? march.dip : glm::min(this->NextSample(path, march), span.s);
  march.next = this->SamplePath(path, at.cell, span.lastCell, s, visit);
  ++march.crossings;
  const bool both = march.last.valid && march.next.valid;
  march.found = both && (march.last.above < 0.0f) != (march.next.above < 0.0f);
  const bool mayDip = both && !march.found && !looks && this->Kind == SearchKind::Equidistant;
  march.dip = mayDip ? this->Dip(march.last, march.next) : -1.0f;
  if (march.found || march.dip >= 0.0f)
  {
    march.ended = march.found;
    return at;
  }
  march.last = march.next;
  march.steps += looks ? 0 : 1;
  march.ended = (s >= span.s && span.ends) || this->HasStepped(march);
  return this->StepTo(path, at, span, s);
}

//------------------------------------------------------------------------------
template <typename Texel>
TerrainHit HeightSearch<Texel>::Polish(const Path& path, const Step& at, const March& march) const
{
  Sample a = march.last;
  Sample b = march.next;
  const glm::ivec2 lastCell = this->StepSpan(path, at).lastCell;
  float weightA = 1.0f;
  float weightB = 1.0f;
  bool valid = true;
  for (int i = 0; i < this->Parameters.SecantSteps; ++i)
  {
    const Sample c = this->SamplePath(
      path, at.cell, lastCell, Secant(a, b, weightA, weightB), [](const glm::ivec2&) {});
    valid = valid && c.valid;
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
  TerrainHit hit;
  hit.s = Secant(a, b, 1.0f, 1.0f);
  const glm::vec2 position = glm::vec2(path.origin) + glm::vec2(path.direction) * hit.s;
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(position)) + path.anchor, at.cell, lastCell);
  hit.cell = cell ^ path.mirror;
  hit.fraction = this->Coded.CellFraction(path, cell, hit.s, 0, 0.0f);
  hit.found = valid && this->Coded.IsCellValid(hit.cell);
  hit.crossings = march.crossings + this->Parameters.SecantSteps;
  return hit;
}

//------------------------------------------------------------------------------
template <typename Texel>
template <typename Visit>
TerrainHit HeightSearch<Texel>::Search(const TerrainRay& ray, Visit&& visit) const
{
  const Path path = this->Coded.ClipPath(this->Coded.MirrorRay(ray));
  TerrainHit hit;
  March march;
  if (!(path.sBegin <= path.sEnd) || this->HasStepped(march))
  {
    return hit;
  }
  Step at = this->Coded.FirstStep(path);
  const int level = this->Parameters.StepLevel();
  while (!march.ended)
  {
    while (!march.ended && at.level > level)
    {
      ++march.crossings;
      const Span span = this->Coded.NodeSpan(path, at);
      bool down = false;
      bool small = false;
      at = this->Coded.VisitNode(path, at, span, glm::vec4(0.0f), down, small);
      march.ended = span.ends && !down;
    }
    if (!march.ended)
    {
      this->BeginSteps(path, at, march, visit);
    }
    bool goesOn = true;
    while (!march.ended && goesOn && at.level <= level)
    {
      at = this->TakeStep(path, at, march, visit);
      goesOn = march.next.valid;
    }
  }
  hit.crossings = march.crossings;
  return march.found ? this->Polish(path, at, march) : hit;
}
}

#endif
