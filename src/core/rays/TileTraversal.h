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
  /// Of a node whose tile is there.
  PyramidNode<float> At(glm::ivec2 node, int level) const
  {
    const glm::vec2 bounds =
      this->tiles->SlotBounds(node, level, this->tiles->TileSlot(node, level));
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

  /// The step in the finest node that is there. The line it stands on is a line of that node too:
  /// were it not, the tile of the node's finer ones would be there, for the ray comes from one.
  Step Ascend(const Path& path, Step at) const;
  /// Position on a path in a node, as fractions of the node; see CellFraction().
  glm::vec2 NodeFraction(
    const Path& path, glm::ivec2 cell, int level, float s, int line, float side) const;
  /// Passes a node, or a cell at level 0, by its patch.
  Passage PassPatch(const Path& path, const Step& at, const Span& span, float side) const;
  /// The hit of a passage, in cells of level 0.
  TerrainHit HitInNode(const Path& path, const Step& at, const Passage& passage) const;
  /// The side on which a ray passes a node by its bounds, or the part of it before `s`, where it
  /// goes down.
  float PassBounds(const Path& path, const Step& at, const Span& span, const glm::vec2& bounds,
    bool down, float s, float side) const;

  /// What becomes of a ray at a node above level 0.
  struct Descent
  {
    bool down = false;    ///< it comes within the bounds
    bool small = false;   ///< and ends there, within the tolerance
    bool missing = false; ///< or would go on in a finer node whose tile is not there
    float passes = 0.0f;  ///< as PassBounds() tells
    Step next;
  };
  Descent Descend(const Path& path, const Step& at, const Span& span, float side,
    const glm::vec4& tolerance) const;

  /// The first point of the surface on a ray; tolerance: see TracePyramidWithin().
  /// visit(node, level, missing) is called for each node; missing: its finer nodes were wanted and
  /// are not there.
  template <typename Visit>
  TerrainHit TraceTiles(const TerrainRay& ray, const glm::vec4& tolerance, Visit&& visit) const;
};

inline TiledPyramid::Step TiledPyramid::Ascend(const Path& path, Step at) const
{
  while (this->heights.tiles->TileSlot((at.cell >> at.level) ^ path.mirror, at.level) < 0)
  {
    ++at.level;
  }
  return at;
}

inline glm::vec2 TiledPyramid::NodeFraction(
  const Path& path, glm::ivec2 cell, int level, float s, int line, float side) const
{
  const glm::ivec2 first = (cell >> level) << level;
  const float width = 1.0f / static_cast<float>(1 << level);
  glm::vec2 fraction = glm::clamp(
    (glm::vec2(path.origin) + glm::vec2(path.direction) * s - glm::vec2(first - path.anchor)) *
      width,
    glm::vec2(0.0f), glm::vec2(1.0f));
  fraction = { line == 1 ? side : fraction.x, line == 2 ? side : fraction.y };
  return glm::mix(fraction, 1.0f - fraction, glm::notEqual(path.mirror, glm::ivec2(0)));
}

inline TiledPyramid::Passage TiledPyramid::PassPatch(
  const Path& path, const Step& at, const Span& span, float side) const
{
  Passage passage;
  const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
  glm::vec4 codes = this->heights.LevelCodes(node, at.level);
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
  const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
  const glm::vec2 bounds = this->NodeBounds(path, at);
  descent.down = std::min(at.z, span.z) <= bounds.x && std::max(at.z, span.z) >= bounds.y;
  const float bound = path.direction.z < 0.0f ? bounds.x : bounds.y;
  const float s = std::min(std::max(at.s + (bound - at.z) * path.inverse.z, at.s), span.s);
  descent.next = this->NextStep(path, at, span, descent.down, descent.down ? s : span.s);
  const glm::ivec2 finer = (descent.next.cell >> std::max(at.level - 1, 0)) ^ path.mirror;
  descent.small = descent.down && at.level <= this->heights.tiles->Top() &&
    IsWithin(tolerance, at.s, at.level, bounds) &&
    glm::all(glm::greaterThanEqual(this->heights.LevelCodes(node, at.level), glm::vec4(0.0f)));
  descent.missing =
    descent.down && !descent.small && this->heights.tiles->TileSlot(finer, at.level - 1) < 0;
  descent.passes = PassBounds(path, at, span, bounds, descent.down, s, side);
  return descent;
}

template <typename Visit>
TerrainHit TiledPyramid::TraceTiles(
  const TerrainRay& ray, const glm::vec4& tolerance, Visit&& visit) const
{
  const Path path = this->ClipPath(this->MirrorRay(ray));
  TerrainHit hit;
  if (!(path.sBegin <= path.sEnd))
  {
    return hit;
  }
  Step at = this->FirstStep(path);
  const int most = 2 * (this->heights.size.x + this->heights.size.y) + this->pyramid->LevelCount();
  float side = 0.0f;
  bool ended = false;
  int crossings = 0;
  while (!ended && crossings < most)
  {
    ++crossings;
    const glm::ivec2 node = (at.cell >> at.level) ^ path.mirror;
    const Span span = this->NodeSpan(path, at);
    bool down = false;
    bool byPatch = at.level == 0;
    bool missing = false;
    Step next = at;
    if (at.level > 0)
    {
      const Descent descent = this->Descend(path, at, span, side, tolerance);
      down = descent.down;
      next = descent.next;
      missing = descent.missing;
      byPatch = missing;
      const bool wall = !byPatch && descent.passes * side < 0.0f;
      side = byPatch ? side : descent.passes;
      if (wall || descent.small)
      {
        const Step& where = wall ? at : next;
        hit = { true, where.s, where.cell ^ path.mirror,
          this->CellFraction(path, where.cell, where.s, where.line, 0.0f), 0 };
        ended = true;
      }
    }
    visit(node, at.level, missing);
    if (byPatch)
    {
      const Passage passage = this->PassPatch(path, at, span, side);
      side = passage.side;
      if (passage.meets)
      {
        hit = this->HitInNode(path, at, passage);
      }
      next = this->NextStep(path, at, span, false, span.s);
      down = false;
      ended = passage.meets;
    }
    ended = ended || (span.ends && !down);
    at = ended ? next : this->Ascend(path, next);
  }
  hit.crossings = crossings;
  return hit;
}
}

#endif
