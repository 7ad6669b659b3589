// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which part of a grid is drawn, and the block below it, as planes that cut rays off.
 */
#ifndef terrain_Cutting_h
#define terrain_Cutting_h

#include "core/grid/Coordinates.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace terrain
{
/// Clipping planes of a mapper, four sides of a rectangle or block, and its floor.
constexpr int kMaximumClipPlanes = 6 + 4 + 1;

/// A rectangle of samples, both corners included.
struct SampleRectangle
{
  glm::dvec2 First{ 0.0 };
  glm::dvec2 Last{ 0.0 };
};

/// Twin of terrainClipRange(): the part of the distances [range.x, range.y] of a ray that no plane
/// cuts off, kept being dot(plane, (x, y, z, 1)) >= 0; and the plane at which it begins, or -1.
/// Nothing is left if range.x >= range.y.
inline glm::vec2 ClipRange(const std::vector<glm::vec4>& planes, const glm::vec3& origin,
  const glm::vec3& direction, glm::vec2 range, int& begin)
{
  begin = -1;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    const auto distance = [&](float s)
    { return glm::dot(planes[i], glm::vec4(origin + s * direction, 1.0f)); };
    const float atStart = distance(range.x);
    const float atEnd = distance(range.y);
    const float crossing = glm::mix(range.x, range.y, atStart / (atStart - atEnd));
    begin = atStart < 0.0f ? static_cast<int>(i) : begin;
    range.x = atStart < 0.0f ? (atEnd < 0.0f ? range.y : crossing) : range.x;
    range.y = atEnd < 0.0f ? (atStart < 0.0f ? range.x : crossing) : range.y;
  }
  return range;
}

struct Cutting
{
  /// Draw the rectangle of the samples First to Last only.
  bool Extracts = false;
  glm::ivec2 First{ 0 };
  glm::ivec2 Last{ 0 };
  /// Draw a block from the surface down to a height.
  bool Block = false;
  double BlockBase = 0.0;

  /// True if there are planes that bound what is drawn: PlanesGC().
  bool Cuts() const
  {
    return this->Extracts || this->Block;
  }

  /// The rectangle that is drawn of a grid of size samples, of which there are `cells` cells along
  /// one between First and Last.
  SampleRectangle Drawn(const glm::ivec2& size, int cells) const
  {
    const glm::ivec2 last = size - 1;
    const glm::ivec2 from = this->Extracts ? cells * this->First : glm::ivec2(0);
    const glm::ivec2 to = this->Extracts ? cells * this->Last : last;
    return { glm::dvec2(glm::clamp(from, glm::ivec2(0), last)),
      glm::dvec2(glm::clamp(to, glm::ivec2(0), last)) };
  }

  /// The lowest height that is drawn above a lowest height of the surface.
  double Lowest(double surface) const
  {
    return this->Block ? std::min(this->BlockBase, surface) : surface;
  }

  /// The planes that bound what is drawn, in grid coordinates (z in codes): kept is
  /// dot(plane, (x, y, z, 1)) >= 0. Empty if nothing is cut.
  std::vector<glm::dvec4> PlanesGC(const SampleRectangle& drawn, double baseCode) const
  {
    std::vector<glm::dvec4> planes;
    if (this->Cuts())
    {
      planes.emplace_back(1.0, 0.0, 0.0, -drawn.First.x);
      planes.emplace_back(-1.0, 0.0, 0.0, drawn.Last.x);
      planes.emplace_back(0.0, 1.0, 0.0, -drawn.First.y);
      planes.emplace_back(0.0, -1.0, 0.0, drawn.Last.y);
    }
    if (this->Block)
    {
      planes.emplace_back(0.0, 0.0, 1.0, -baseCode);
    }
    return planes;
  }
};
}

#endif
