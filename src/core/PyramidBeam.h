// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Beams: a safe common start for all rays of a tile of pixels, found through the min-max pyramid.
 * Twin of shaders/vtkTerrainBeam.glsl: the same functions (there with the prefix terrain), the
 * same arithmetic.
 *
 * At one distance s along the viewing direction the rays of a tile fill a parallelogram; the beam
 * is the box around it, c(s) -+ r(s), both linear in s. The beam runs through blocks of 2 x 2 nodes
 * of a level, the first of which holds its trailing corner. While the heights of the box and those
 * of the block do not meet, no ray of the tile meets the surface: the beam goes on to where its
 * box leaves the block, one level up; where they do meet, it goes on to where its heights reach
 * the block's bound, one level down. It ends there when the nodes of that level would be too small
 * for the box (BeamLevel()), or at level 1.
 *
 * Conservative: no ray of the tile meets the surface before the distance returned. Every bound is
 * taken over all cells that the box touches on the way, heights are widened by Path::slack and the
 * box by BeamMargin, more than what rounding moves a ray; if the number of steps runs out, the
 * distance reached so far is as safe as any.
 */
#ifndef terrain_PyramidBeam_h
#define terrain_PyramidBeam_h

#include "core/PyramidTraversal.h"

namespace terrain
{
/// Most steps of a beam.
constexpr int BeamSteps = 96;
/// The box of a beam is widened by this part of its coordinates, above what float rounds them by.
constexpr float BeamMargin = 1e-6f;

/// The rays of a tile of pixels: all lie in ray(s) -+ (radius + s * growth), s being that of the
/// ray.
struct TerrainBeam
{
  /// The ray in the middle of the tile.
  TerrainRay ray;
  /// Half of the box at s = 0, and its change per unit of s, both >= 0: cells, cells, height codes.
  glm::vec3 radius{ 0.0f, 0.0f, 0.0f };
  glm::vec3 growth{ 0.0f, 0.0f, 0.0f };
};

/// Finds safe starts in a pyramid.
template <typename Texel>
class PyramidBeam
{
public:
  explicit PyramidBeam(const CodedPyramid<Texel>& coded)
    : Coded(coded)
  {
  }

  /// A distance sBegin <= s <= sEnd of the beam's ray that no ray of the tile has met the surface
  /// before; sEnd if none does at all. The steps it took are added to steps.
  float BeamStart(const TerrainBeam& beam, int& steps) const;

private:
  using Path = typename CodedPyramid<Texel>::Path;

  /// The edges of the box, mirrored as the path: origin and change per unit of s.
  struct Edges
  {
    glm::vec3 low;
    glm::vec3 lowMove;
    glm::vec3 high;
    glm::vec3 highMove;
  };

  Edges BeamEdges(const Path& path, const TerrainBeam& beam) const;
  float BeamEntry(const Path& path, const Edges& edges) const;
  int BeamLevel(const Edges& edges, float s) const;
  float BeamLeaves(const Path& path, const Edges& edges, glm::ivec2 first, glm::ivec2 end) const;
  glm::vec2 BlockBounds(const Path& path, glm::ivec2 block, int level) const;

  const CodedPyramid<Texel>& Coded;
};

template <typename Texel>
typename PyramidBeam<Texel>::Edges PyramidBeam<Texel>::BeamEdges(
  const Path& path, const TerrainBeam& beam) const
{
  const glm::vec3 radius =
    beam.radius + BeamMargin * (glm::abs(path.origin) + 1.0f) + glm::vec3(0.0f, 0.0f, path.slack);
  const glm::vec3 growth = beam.growth + BeamMargin * glm::abs(path.direction);
  return { path.origin - radius, path.direction - growth, path.origin + radius,
    path.direction + growth };
}

/// The distance, at least s, where the box reaches the grid along an axis; end if it never does.
inline float BeamReaches(float s, float end, float ahead, float move, float past, float pastMove)
{
  const float reached = move > 0.0f ? std::max(s, ahead / move) : (ahead > 0.0f ? end : s);
  return past + pastMove * reached > 0.0f && pastMove >= 0.0f ? end : reached;
}

/// The distance where the box reaches the box of all surfaces; the path's end if it never does.
template <typename Texel>
float PyramidBeam<Texel>::BeamEntry(const Path& path, const Edges& edges) const
{
  const glm::vec2 first(path.firstCell - path.anchor);
  const glm::vec2 last(path.lastCell + 1 - path.anchor);
  const glm::vec2 ahead = first - glm::vec2(edges.high);
  const glm::vec2 past = glm::vec2(edges.low) - last;
  float s = path.sBegin;
  s = BeamReaches(s, path.sEnd, ahead.x, edges.highMove.x, past.x, edges.lowMove.x);
  s = BeamReaches(s, path.sEnd, ahead.y, edges.highMove.y, past.y, edges.lowMove.y);
  const float above = edges.low.z - this->Coded.heights.maximumCode;
  const float below = -edges.high.z;
  if (above + edges.lowMove.z * s > 0.0f)
  {
    s = edges.lowMove.z < 0.0f ? -above / edges.lowMove.z : path.sEnd;
  }
  if (below - edges.highMove.z * s > 0.0f)
  {
    s = edges.highMove.z > 0.0f ? below / edges.highMove.z : path.sEnd;
  }
  return std::min(std::max(s, path.sBegin), path.sEnd);
}

/// The lowest level whose nodes are 4/3 as wide as the box, at least 1.
template <typename Texel>
int PyramidBeam<Texel>::BeamLevel(const Edges& edges, float s) const
{
  const glm::vec3 width = edges.high - edges.low + (edges.highMove - edges.lowMove) * s;
  const float size = std::max(std::max(width.x, width.y) * (4.0f / 3.0f), 2.0f);
  return static_cast<int>(std::ceil(std::log2(size)));
}

/// The distance where the box leaves the cells first <= cell < end, mirrored.
template <typename Texel>
float PyramidBeam<Texel>::BeamLeaves(
  const Path& path, const Edges& edges, glm::ivec2 first, glm::ivec2 end) const
{
  const glm::vec2 ahead = glm::vec2(end - path.anchor) - glm::vec2(edges.high);
  const glm::vec2 behind = glm::vec2(first - path.anchor) - glm::vec2(edges.low);
  float s = path.sEnd;
  s = edges.highMove.x > 0.0f ? std::min(s, ahead.x / edges.highMove.x) : s;
  s = edges.highMove.y > 0.0f ? std::min(s, ahead.y / edges.highMove.y) : s;
  s = edges.lowMove.x < 0.0f ? std::min(s, behind.x / edges.lowMove.x) : s;
  s = edges.lowMove.y < 0.0f ? std::min(s, behind.y / edges.lowMove.y) : s;
  return s;
}

/// Bounds of the nodes (block.x + 0..1, block.y + 0..1) of a level, mirrored.
template <typename Texel>
glm::vec2 PyramidBeam<Texel>::BlockBounds(const Path& path, glm::ivec2 block, int level) const
{
  const glm::ivec2 near = glm::max(block ^ path.mirror, glm::ivec2(0));
  const glm::ivec2 far = glm::max((block + 1) ^ path.mirror, glm::ivec2(0));
  const glm::vec2 a = this->Coded.NodeExtremes(near, level);
  const glm::vec2 b = this->Coded.NodeExtremes({ far.x, near.y }, level);
  const glm::vec2 c = this->Coded.NodeExtremes({ near.x, far.y }, level);
  const glm::vec2 d = this->Coded.NodeExtremes(far, level);
  return { std::max(std::max(a.x, b.x), std::max(c.x, d.x)),
    std::min(std::min(a.y, b.y), std::min(c.y, d.y)) };
}

template <typename Texel>
float PyramidBeam<Texel>::BeamStart(const TerrainBeam& beam, int& steps) const
{
  const Path path = this->Coded.MirrorRay(beam.ray);
  const int top = this->Coded.pyramid->LevelCount();
  const Edges edges = this->BeamEdges(path, beam);
  float s = top < 1 ? path.sEnd : this->BeamEntry(path, edges);
  int level = std::min(this->BeamLevel(edges, s) + 2, top);
  bool stops = false;
  for (int i = 0; i < BeamSteps && !stops && s < path.sEnd; ++i)
  {
    ++steps;
    const glm::vec2 low = glm::vec2(edges.low) + glm::vec2(edges.lowMove) * s;
    const glm::ivec2 block = (glm::ivec2(glm::floor(low)) + path.anchor) >> level;
    const int size = 1 << level;
    const float leaves =
      std::max(this->BeamLeaves(path, edges, block * size, (block + 2) * size), s);
    const glm::vec2 bounds = this->BlockBounds(path, block, level);
    const float lowest = edges.low.z + std::min(edges.lowMove.z * s, edges.lowMove.z * leaves);
    const float highest = edges.high.z + std::max(edges.highMove.z * s, edges.highMove.z * leaves);
    const bool clear = lowest > bounds.x || highest < bounds.y;
    // To where the box comes down to the highest, or up to the lowest height.
    const float above = edges.low.z + edges.lowMove.z * s - bounds.x;
    const float below = bounds.y - edges.high.z - edges.highMove.z * s;
    const float fall = above > 0.0f ? above / -edges.lowMove.z : 0.0f;
    const float rise = below > 0.0f ? below / edges.highMove.z : 0.0f;
    s = clear ? leaves : std::min(s + std::max(fall, rise), leaves);
    const int lowestLevel = this->BeamLevel(edges, s);
    stops = !clear && level - 1 < lowestLevel;
    level = std::min(clear ? std::max(level + 1, lowestLevel) : level - 1, top);
  }
  return std::min(s, path.sEnd);
}
}

#endif
