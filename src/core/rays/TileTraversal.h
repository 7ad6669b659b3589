// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ray casting through tiles (TileSource.h), some of which may be missing. Twin, node for node, of
 * shaders/vtkTerrainTileTrace.glsl.
 *
 * It is the traversal of PyramidTraversal.h with the levels of the pyramid in tiles, and two
 * differences:
 *
 * - A node whose four finer nodes are in a tile that is not there is the end of its branch: the ray
 *   is intersected with the bilinear patch of its own four samples. The patch lies within the
 *   node's bounds (TileSource.h), so that whoever crosses the node by its bounds clears the patch.
 * - Where such nodes meet finer ones, or cells, the surface has a step. The ray remembers on which
 *   side of the surface it is: above, below, or unknown after a hole. Wherever it comes to the
 * other side without having crossed the surface, it has crossed a step, and meets it there: a wall,
 *   never a hole. Between neighbours of one level this does not happen, for both see the same
 *   height at the line between them.
 *
 * With all tiles there and no tolerance, hits are those of TracePyramid(), to the bit.
 */
#ifndef terrain_TileTraversal_h
#define terrain_TileTraversal_h

#include "core/rays/PyramidTraversal.h"
#include "core/surface/TileSlots.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace terrain
{
/// Names the heights and the pyramid of tiles, in place of a type of texels.
struct TiledTexel
{
};

/// Heights in tiles, with the functions of CodedHeights.
struct TiledHeights
{
  const TileSlots* tiles = nullptr;
  glm::ivec2 size{ 0, 0 };
  int bias = 0; // tiles hold codes
  float maximumCode = 0.0f;

  /// Codes of the corners of a cell of a level; all negative where its tile is not there.
  glm::vec4 LevelCodes(glm::ivec2 cell, int level) const
  {
    const int slot = this->tiles->TileSlot(cell, level);
    return slot < 0 ? glm::vec4(kNoDataCode) : this->tiles->SlotCodes(cell, slot);
  }
  glm::vec4 CellCodes(glm::ivec2 cell) const
  {
    return this->LevelCodes(cell, 0);
  }
};

/// Bounds in tiles, with the functions of MinMaxPyramid.
struct TiledLevels
{
  const TileSlots* tiles = nullptr;

  int LevelCount() const
  {
    return this->tiles->PyramidTop();
  }
  /// Of a node; of the finest one over it whose tile is there. A tile at the border is not full.
  PyramidNode<float> At(glm::ivec2 node, int level) const
  {
    const TileLayout& layout = this->tiles->GetPages().GetLayout();
    const glm::ivec2 cell =
      glm::min(node << level, glm::ivec2(glm::i64vec2(layout.Width, layout.Height)) - 2);
    const int slot = this->tiles->FinestSlot(cell, level);
    const glm::vec2 bounds = this->tiles->SlotBounds(cell >> level, level, slot);
    return { bounds.x, bounds.y };
  }
};

template <>
struct CodedTypes<TiledTexel>
{
  using Heights = TiledHeights;
  using Pyramid = TiledLevels;
};

/// Traces rays through tiles. The heightfield has more than one level.
struct TiledPyramid : CodedPyramid<TiledTexel>
{
  /// True if some samples have no height.
  bool holes = false;

  /// How a ray passes a node: on which side of the surface it leaves it, or that it meets it.
  struct Passage
  {
    float side = 0.0f; ///< above 1, below -1, unknown 0
    bool meets = false;
    float s = 0.0f; ///< where, and at which fraction of the node
    glm::vec2 fraction{ 0.0f, 0.0f };
  };

  /// Position on a path in a node, as fractions of the node; see CellFraction().
  glm::vec2 NodeFraction(
    const Path& path, glm::ivec2 cell, int level, float s, int line, float side) const;
  /// Passes a node, or a cell at level 0, by its patch; codes: of the patch.
  Passage PassPatch(
    const Path& path, const Step& at, const Span& span, float side, glm::vec4 codes) const;
  /// The hit of a passage, in cells of level 0.
  TerrainHit HitInNode(const Path& path, const Step& at, const Passage& passage) const;
  /// The side on which a ray passes a node by its bounds, or the part of it before `s`, where it
  /// goes down.
  float PassBounds(const Path& path, const Step& at, const Span& span, const glm::vec2& bounds,
    bool down, float s, float side) const;

  /// What becomes of a ray at a node above level 0.
  struct Descent
  {
    bool down = false;   ///< it comes within the bounds
    bool small = false;  ///< and they are within the tolerance
    float passes = 0.0f; ///< as PassBounds() tells
    Step next;
  };
  Descent Descend(const Path& path, const Step& at, const Span& span, float side,
    const glm::vec4& tolerance) const;

  /// A step and the slot of its node, negative if its tile is not there.
  struct SlottedStep
  {
    Step step;
    int slot = -1;
  };
  SlottedStep TileStep(const Path& path, const Step& step) const
  {
    return { step,
      this->heights.tiles->TileSlot((step.cell >> step.level) ^ path.mirror, step.level) };
  }
  /// True for a cell whose tile is there.
  static bool TileStepIsCell(const SlottedStep& at)
  {
    return at.step.level == 0 && at.slot >= 0;
  }
  /// Codes of the corners of the node of a step.
  glm::vec4 TileStepCodes(const Path& path, const SlottedStep& at) const
  {
    return this->heights.tiles->SlotCodes((at.step.cell >> at.step.level) ^ path.mirror, at.slot);
  }

  /// How far a ray has come.
  struct Walk
  {
    SlottedStep at;
    SlottedStep from;     ///< the step before
    float side = 0.0f;    ///< as in Passage
    bool byPatch = false; ///< at is passed by its patch
    bool wall = false;    ///< met from the step before
    bool small = false;   ///< within the tolerance at the node of the step before
    bool ended = false;
    int crossings = 0;
    int most = 0;
  };
  /// On over a node by its bounds, or up where its tile is not there. The line that a ray stands on
  /// is a line of the coarser node too: were it not, the tile would be there, for the ray comes
  /// from a finer one.
  template <typename Visit>
  void WalkNode(const Path& path, const glm::vec4& tolerance, Walk& walk, Visit&& visit) const;
  /// On over a hole, where no tolerance ends a ray.
  static void WalkOverHole(Walk& walk);
  /// On over a cell, or a node whose finer ones are not there, by its patch.
  template <typename Visit>
  void WalkPatch(const Path& path, Walk& walk, Passage& passage, Visit&& visit) const;

  /// The first point of the surface on a ray; tolerance: see TracePyramidWithin().
  /// visit(node, level, missing) is called for each node; missing: its finer nodes were wanted and
  /// are not there.
  template <typename Visit>
  TerrainHit TraceTiles(const TerrainRay& ray, const glm::vec4& tolerance, Visit&& visit) const;
};

inline glm::vec2 TiledPyramid::NodeFraction(
  const Path& path, glm::ivec2 cell, int level, float s, int line, float side) const
{
  const glm::ivec2 first = cell & -(1 << level); // cells of mirrored axes are below 0
  const float width = 1.0f / static_cast<float>(1 << level);
  glm::vec2 fraction = glm::clamp(
    (glm::vec2(path.origin) + glm::vec2(path.direction) * s - glm::vec2(first - path.anchor)) *
      width,
    glm::vec2(0.0f), glm::vec2(1.0f));
  fraction = { line == 1 ? side : fraction.x, line == 2 ? side : fraction.y };
  return glm::mix(fraction, 1.0f - fraction, glm::notEqual(path.mirror, glm::ivec2(0)));
}

inline TiledPyramid::Passage TiledPyramid::PassPatch(
  const Path& path, const Step& at, const Span& span, float side, glm::vec4 codes) const
{
  Passage passage;
  const bool valid = glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0f)));
  codes -= path.anchorCode;
  const glm::vec2 begin = this->NodeFraction(path, at.cell, at.level, at.s, at.line, 0.0f);
  const glm::vec2 end = this->NodeFraction(
    path, at.cell, at.level, span.s, span.ends ? 0 : (span.crossEast ? 1 : 2), 1.0f);
  const float above = at.z - PatchCode(codes, begin);
  const float t = IntersectPatch(codes, glm::vec3(begin, at.z), glm::vec3(end, span.z));
  const bool wall = above * side < 0.0f;
  passage.meets = valid && (wall || t >= 0.0f);
  passage.s = wall ? at.s : at.s + t * (span.s - at.s);
  passage.fraction = wall ? begin : begin + t * (end - begin);
  passage.side = valid ? (above < 0.0f ? -1.0f : 1.0f) : 0.0f;
  return passage;
}

inline TerrainHit TiledPyramid::HitInNode(
  const Path& path, const Step& at, const Passage& passage) const
{
  const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
  const float cells = static_cast<float>(1 << at.level);
  const glm::vec2 position = passage.fraction * cells;
  const glm::ivec2 cell = glm::min(glm::ivec2(position), (1 << at.level) - 1);
  return { true, passage.s, (node << at.level) + cell, position - glm::vec2(cell), 0 };
}

inline float TiledPyramid::PassBounds(const Path& path, const Step& at, const Span& span,
  const glm::vec2& bounds, bool down, float s, float side) const
{
  const float passed = std::min(at.z, span.z) > bounds.x ? 1.0f : -1.0f;
  const float before = s > at.s ? (path.direction.z < 0.0f ? 1.0f : -1.0f) : side;
  return this->holes || bounds.x < bounds.y ? 0.0f : (down ? before : passed);
}

inline TiledPyramid::Descent TiledPyramid::Descend(
  const Path& path, const Step& at, const Span& span, float side, const glm::vec4& tolerance) const
{
  Descent descent;
  const glm::vec2 bounds = this->NodeBounds(path, at);
  descent.down = std::min(at.z, span.z) <= bounds.x && std::max(at.z, span.z) >= bounds.y;
  const float bound = path.direction.z < 0.0f ? bounds.x : bounds.y;
  const float s = std::min(std::max(at.s + (bound - at.z) * path.inverse.z, at.s), span.s);
  descent.next = this->NextStep(path, at, span, descent.down, descent.down ? s : span.s);
  descent.small = descent.down && at.level <= this->heights.tiles->Top() &&
    IsWithin(tolerance, at.s, at.level, bounds);
  descent.passes = PassBounds(path, at, span, bounds, descent.down, s, side);
  return descent;
}

template <typename Visit>
void TiledPyramid::WalkNode(
  const Path& path, const glm::vec4& tolerance, Walk& walk, Visit&& visit) const
{
  Descent descent;
  descent.passes = walk.side;
  descent.next = walk.at.step;
  ++descent.next.level;
  const Step& step = walk.at.step;
  const bool isThere = walk.at.slot >= 0;
  bool last = false;
  if (isThere)
  {
    ++walk.crossings;
    const Span span = this->NodeSpan(path, step);
    descent = this->Descend(path, step, span, walk.side, tolerance);
    last = (span.ends && !descent.down) || walk.crossings >= walk.most;
  }
  const SlottedStep next = this->TileStep(path, descent.next);
  walk.byPatch = descent.down && !descent.small && next.slot < 0;
  if (isThere)
  {
    visit((step.cell >> step.level) ^ path.mirror, step.level, walk.byPatch);
  }
  if (!walk.byPatch)
  {
    walk.wall = descent.passes * walk.side < 0.0f;
    walk.small = descent.small;
    walk.ended = last || walk.wall || walk.small;
    walk.side = walk.small ? walk.side : descent.passes;
    walk.from = walk.at;
    walk.at = next;
    walk.byPatch = TileStepIsCell(next);
  }
}

inline void TiledPyramid::WalkOverHole(Walk& walk)
{
  walk.small = false;
  walk.ended = walk.crossings >= walk.most;
  walk.byPatch = walk.at.slot < 0 || walk.at.step.level == 0;
  walk.side = walk.at.slot < 0 ? walk.side : 0.0f;
  if (walk.at.slot < 0)
  {
    walk.at = walk.from;
  }
}

template <typename Visit>
void TiledPyramid::WalkPatch(const Path& path, Walk& walk, Passage& passage, Visit&& visit) const
{
  const Step step = walk.at.step;
  if (step.level == 0) // nodes were visited as such
  {
    ++walk.crossings;
    visit(step.cell ^ path.mirror, 0, false);
  }
  const Span span = this->NodeSpan(path, step);
  passage = this->PassPatch(path, step, span, walk.side, this->TileStepCodes(path, walk.at));
  walk.side = passage.side;
  walk.ended = passage.meets || span.ends || walk.crossings >= walk.most;
  walk.from = walk.at;
  walk.at = this->TileStep(path, this->NextStep(path, step, span, false, span.s));
  walk.byPatch = TileStepIsCell(walk.at);
}

template <typename Visit>
TerrainHit TiledPyramid::TraceTiles(
  const TerrainRay& ray, const glm::vec4& tolerance, Visit&& visit) const
{
  const Path path = this->ClipPath(this->MirrorRay(ray));
  Walk walk;
  walk.at = this->TileStep(path, this->FirstStep(path));
  walk.from = walk.at;
  walk.byPatch = TileStepIsCell(walk.at);
  walk.ended = !(path.sBegin <= path.sEnd);
  walk.most = 2 * (this->heights.size.x + this->heights.size.y) + this->pyramid->LevelCount();
  Passage passage;
  while (!walk.ended)
  {
    while (!walk.ended && !walk.byPatch)
    {
      this->WalkNode(path, tolerance, walk, visit);
    }
    if (walk.small && !walk.wall && this->holes &&
      !glm::all(glm::greaterThanEqual(this->TileStepCodes(path, walk.from), glm::vec4(0.0f))))
    {
      WalkOverHole(walk);
    }
    while (!walk.ended && walk.byPatch)
    {
      this->WalkPatch(path, walk, passage, visit);
    }
  }
  TerrainHit hit;
  if (passage.meets)
  {
    hit = this->HitInNode(path, walk.from.step, passage);
  }
  if (walk.wall || walk.small)
  {
    const Step& where = walk.wall ? walk.from.step : walk.at.step;
    hit = { true, where.s, where.cell ^ path.mirror,
      this->CellFraction(path, where.cell, where.s, where.line, 0.0f), 0 };
  }
  hit.crossings = walk.crossings;
  return hit;
}
}

#endif
