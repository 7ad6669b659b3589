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
 * the block's bound, one level down, as long as the nodes of that level are not too small for the
 * box (BeamLevel()). Narrow beams thus come down to cells: they go on while the height of the ray
 * in the middle above the patch exceeds what the box and the steepest slope within reach of it can
 * make up. Eyes close to the ground need that: without, beams from 2 m above it hardly start.
 *
 * Conservative: no ray of the tile meets the surface before the distance returned. Every bound is
 * taken over all cells that the box touches on the way, heights are widened by Path::slack and the
 * box by kBeamMargin and kBeamReach, more than what rounding moves a ray; if the number of steps
 * runs out, the distance reached so far is as safe as any.
 */
#ifndef terrain_PyramidBeam_h
#define terrain_PyramidBeam_h

#include "core/rays/PixelRays.h"
#include "core/rays/PyramidTraversal.h"

namespace terrain
{
/// Most steps of a beam.
constexpr int kBeamSteps = 192;
/// The box of a beam is widened by this part of its coordinates, above what float rounds them by.
constexpr float kBeamMargin = 1e-6f;
/// Cells by which a beam gets past a line between cells: more than what rounding moves positions.
constexpr float kBeamReach = 1e-4f;

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

/// The beam of all pixels that lie within some pixels of a position both ways, between two
/// distances along the viewing direction.
inline TerrainBeam TileBeam(
  const PixelRays& rays, const glm::dvec2& pixel, double pixels, double start, double end)
{
  const auto reach = [pixels](const PixelVector& vector)
  { return pixels * (glm::abs(vector[1]) + glm::abs(vector[2])); };
  TerrainBeam beam;
  beam.ray = PixelRay(rays, pixel, start, end);
  beam.growth = glm::vec3(reach(rays.DirectionGC));
  beam.radius = glm::vec3(reach(rays.OriginGC) + start * reach(rays.DirectionGC));
  return beam;
}

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

  /// Where a beam has got to: the level of the nodes it tries next, 0 for a cell; or stops for
  /// good.
  struct Step
  {
    float s;
    int level;
    bool stops;
  };

  Edges BeamEdges(const Path& path, const TerrainBeam& beam) const;
  float BeamEntry(const Path& path, const Edges& edges) const;
  int BeamLevel(const Edges& edges, float s) const;
  float BeamLeaves(const Path& path, const Edges& edges, glm::ivec2 first, glm::ivec2 end) const;
  glm::vec2 BlockBounds(const Path& path, glm::ivec2 block, int level) const;
  Step BeamOverBlock(const Path& path, const Edges& edges, const Step& at) const;
  bool SlopeBound(glm::ivec2 cell, glm::vec2& slope, glm::vec4& codes) const;
  Step BeamOverCell(const Path& path, const Edges& edges, const Step& at) const;

  const CodedPyramid<Texel>& Coded;
};

template <typename Texel>
typename PyramidBeam<Texel>::Edges PyramidBeam<Texel>::BeamEdges(
  const Path& path, const TerrainBeam& beam) const
{
  const glm::vec3 radius =
    beam.radius + kBeamMargin * (glm::abs(path.origin) + 1.0f) + glm::vec3(0.0f, 0.0f, path.slack);
  const glm::vec3 growth = beam.growth + kBeamMargin * glm::abs(path.direction);
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
  const float above = edges.low.z - (this->Coded.heights.maximumCode - path.anchorCode);
  const float below = -path.anchorCode - edges.high.z;
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

/// The lowest level whose nodes are 4/3 as wide as the box.
template <typename Texel>
int PyramidBeam<Texel>::BeamLevel(const Edges& edges, float s) const
{
  const glm::vec3 width = edges.high - edges.low + (edges.highMove - edges.lowMove) * s;
  const float size = std::max(std::max(width.x, width.y) * (4.0f / 3.0f), 1.0f);
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
  return glm::vec2(std::max(std::max(a.x, b.x), std::max(c.x, d.x)),
           std::min(std::min(a.y, b.y), std::min(c.y, d.y))) -
    path.anchorCode;
}

/// On to where the box leaves the block of 2 x 2 nodes, if no height in it meets the box; else to
/// where it comes down to the highest, or up to the lowest height of the block.
template <typename Texel>
typename PyramidBeam<Texel>::Step PyramidBeam<Texel>::BeamOverBlock(
  const Path& path, const Edges& edges, const Step& at) const
{
  const glm::vec2 low = glm::vec2(edges.low) + glm::vec2(edges.lowMove) * at.s;
  const glm::ivec2 block = (glm::ivec2(glm::floor(low)) + path.anchor) >> at.level;
  const int size = 1 << at.level;
  const float leaves =
    std::max(this->BeamLeaves(path, edges, block * size, (block + 2) * size), at.s);
  const glm::vec2 bounds = this->BlockBounds(path, block, at.level);
  const float lowest = edges.low.z + std::min(edges.lowMove.z * at.s, edges.lowMove.z * leaves);
  const float highest = edges.high.z + std::max(edges.highMove.z * at.s, edges.highMove.z * leaves);
  const bool clear = lowest > bounds.x || highest < bounds.y;
  const float above = edges.low.z + edges.lowMove.z * at.s - bounds.x;
  const float below = bounds.y - edges.high.z - edges.highMove.z * at.s;
  const float fall = above > 0.0f ? above / -edges.lowMove.z : 0.0f;
  const float rise = below > 0.0f ? below / edges.highMove.z : 0.0f;
  const float s = clear ? leaves : std::min(at.s + std::max(fall, rise), leaves);
  const int lowestLevel = this->BeamLevel(edges, s);
  const int level = clear ? std::max(at.level + 1, lowestLevel) : at.level - 1;
  return { s, std::min(level, this->Coded.pyramid->LevelCount()), level < lowestLevel };
}

/// Steepest change of the code along an edge between samples of a cell and those around it, east
/// and north; and the codes of the cell's corners. False if some of the 4 x 4 samples have no
/// height.
template <typename Texel>
bool PyramidBeam<Texel>::SlopeBound(glm::ivec2 cell, glm::vec2& slope, glm::vec4& codes) const
{
  const auto& heights = this->Coded.heights;
  // Samples by column, then row, of four cells beside each other.
  float samples[4][4];
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::ivec2 first(2 * (corner & 1), 2 * (corner >> 1));
    const glm::vec4 part = heights.CellCodes(cell - 1 + first);
    samples[first.x][first.y] = part.x;
    samples[first.x + 1][first.y] = part.y;
    samples[first.x][first.y + 1] = part.z;
    samples[first.x + 1][first.y + 1] = part.w;
  }
  float lowest = 0.0f;
  slope = glm::vec2(0.0f);
  for (int k = 0; k < 4; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      slope.x = std::max(slope.x, std::abs(samples[i + 1][k] - samples[i][k]));
      slope.y = std::max(slope.y, std::abs(samples[k][i + 1] - samples[k][i]));
    }
    lowest = std::min(lowest, *std::min_element(samples[k], samples[k] + 4));
  }
  codes = { samples[1][1], samples[2][1], samples[1][2], samples[2][2] };
  return lowest >= 0.0f;
}

/// On to where the ray in the middle leaves a cell, if it stays so far above or below the cell's
/// patch that the steepest slope around cannot reach the box.
template <typename Texel>
typename PyramidBeam<Texel>::Step PyramidBeam<Texel>::BeamOverCell(
  const Path& path, const Edges& edges, const Step& at) const
{
  const glm::vec2 origin(path.origin);
  const glm::vec2 direction(path.direction);
  const glm::ivec2 cell =
    glm::ivec2(glm::floor(origin + direction * at.s + kBeamReach)) + path.anchor;
  const glm::vec2 leave =
    (glm::vec2(cell + 1 - path.anchor) - path.lineOrigin) * glm::vec2(path.inverse);
  const float s = std::min(std::max(std::min(leave.x, leave.y), at.s), path.sEnd);
  const glm::vec3 radius = 0.5f * (edges.high - edges.low + (edges.highMove - edges.lowMove) * s) +
    glm::vec3(2.0f * kBeamReach, 2.0f * kBeamReach, 0.0f);
  const bool inside = glm::all(glm::greaterThan(cell, path.firstCell)) &&
    glm::all(glm::lessThan(cell, path.lastCell));
  if (!inside || std::max(radius.x, radius.y) > 0.9f)
  {
    return { at.s, 0, true };
  }
  glm::vec2 slope;
  glm::vec4 codes;
  const bool valid = this->SlopeBound(cell ^ path.mirror, slope, codes);
  codes -= path.anchorCode;
  const glm::vec2 begin = this->Coded.CellFraction(path, cell, at.s, 0, 0.0f);
  const glm::vec2 end = this->Coded.CellFraction(path, cell, s, 0, 0.0f);
  const glm::vec2 difference = path.origin.z + path.direction.z * glm::vec2(at.s, s) -
    glm::vec2(PatchCode(codes, begin), PatchCode(codes, end));
  // On the way the difference leaves the straight line between its ends by a quarter of this.
  const float bend =
    -((codes.x - codes.y) - (codes.z - codes.w)) * (end.x - begin.x) * (end.y - begin.y);
  const float reach = radius.z + (slope.x * radius.x + slope.y * radius.y);
  const bool clear = valid &&
    (std::min(difference.x, difference.y) - 0.25f * std::max(bend, 0.0f) > reach ||
      std::max(difference.x, difference.y) - 0.25f * std::min(bend, 0.0f) < -reach);
  const glm::ivec2 next = glm::ivec2(glm::floor(origin + direction * s + kBeamReach)) + path.anchor;
  const bool leavesBlock =
    glm::any(glm::notEqual(next >> 1, cell >> 1)) || this->BeamLevel(edges, s) > 0;
  return { clear ? s : at.s, leavesBlock ? 1 : 0, !clear };
}

template <typename Texel>
float PyramidBeam<Texel>::BeamStart(const TerrainBeam& beam, int& steps) const
{
  const Path path = this->Coded.MirrorRay(beam.ray);
  const int top = this->Coded.pyramid->LevelCount();
  const Edges edges = this->BeamEdges(path, beam);
  const float s = top < 1 ? path.sEnd : this->BeamEntry(path, edges);
  Step at{ s, std::min(std::max(this->BeamLevel(edges, s) + 2, 1), top), false };
  for (int i = 0; i < kBeamSteps && !at.stops && at.s < path.sEnd; ++i)
  {
    ++steps;
    at = at.level > 0 ? this->BeamOverBlock(path, edges, at) : this->BeamOverCell(path, edges, at);
  }
  return std::min(at.s, path.sEnd);
}
}

#endif
