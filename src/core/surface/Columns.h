// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of constant columns, one around each sample and as high as that: the nearest sample's
 * height. A cell, which lies between samples, shows a quarter of four columns. Twin of
 * shaders/vtkTerrainColumns.glsl: the same functions (there with the prefix terrain).
 *
 * Source: S. Park, K. Oh, "GPU-only Terrain Rendering for Walk-through", section 4.
 */
#ifndef terrain_Columns_h
#define terrain_Columns_h

#include <glm/glm.hpp>

#include <algorithm>

namespace terrain
{
/// Cells by which a point on a wall is told from one on a top.
constexpr float kColumnReach = 1e-3f;

/// Code of the sample whose column has a quarter of a cell: east, north half or not.
inline float ColumnCode(const glm::vec4& codes, const glm::bvec2& quarter)
{
  const glm::vec2 row = quarter.y ? glm::vec2(codes.z, codes.w) : glm::vec2(codes.x, codes.y);
  return quarter.x ? row.y : row.x;
}

/// Where the segment from one position in a cell to another first meets the columns, as a fraction
/// of the segment; -1 if it does not. Positions: fractions of the cell and height codes. Top faces
/// and walls are met.
inline float IntersectColumns(const glm::vec4& codes, const glm::vec3& begin, const glm::vec3& end)
{
  const glm::vec2 begin2(begin);
  const glm::vec2 end2(end);
  const glm::bvec2 from = glm::greaterThanEqual(begin2, glm::vec2(0.5f));
  const glm::bvec2 to = glm::greaterThanEqual(end2, glm::vec2(0.5f));
  // Where the segment goes over into other columns: a wall is crossed if and only if sides differ.
  const glm::vec2 wall = glm::mix(glm::vec2(1.0f),
    glm::clamp((0.5f - begin2) / (end2 - begin2), glm::vec2(0.0f), glm::vec2(1.0f)),
    glm::notEqual(from, to));
  const glm::bvec2 between = wall.x <= wall.y ? glm::bvec2(to.x, from.y) : glm::bvec2(from.x, to.y);
  const float t1 = std::min(wall.x, wall.y);
  const float t2 = std::max(wall.x, wall.y);
  const glm::vec3 columns(
    ColumnCode(codes, from), ColumnCode(codes, between), ColumnCode(codes, to));
  const glm::vec2 z = begin.z + (end.z - begin.z) * glm::vec2(t1, t2);
  const float side = begin.z < columns.x ? -1.0f : 1.0f;
  // Height above each column where the segment begins and ends on it, seen from its first side.
  const glm::vec3 above = side * (glm::vec3(begin.z, z) - columns);
  const glm::vec3 after = side * (glm::vec3(z, end.z) - columns);
  float t = after.z <= 0.0f ? t2 + (1.0f - t2) * above.z / (above.z - after.z) : -1.0f;
  t = above.z <= 0.0f ? t2 : t;
  t = after.y <= 0.0f ? t1 + (t2 - t1) * above.y / (above.y - after.y) : t;
  t = above.y <= 0.0f ? t1 : t;
  t = after.x <= 0.0f ? t1 * above.x / (above.x - after.x) : t;
  return above.x <= 0.0f ? 0.0f : t;
}

/// The face of a column that a ray meets.
struct ColumnFace
{
  /// Of its outer side, in cells and codes: up or along an axis.
  glm::vec3 normal{ 0.0f, 0.0f, 1.0f };
  /// True if the outer side is seen.
  bool front = true;
  /// Height code of the column.
  float code = 0.0f;
};

/// The face that a ray of a direction (cells, cells, codes) meets at a position in a cell: a wall
/// where columns of different height meet there, else a top.
inline ColumnFace FindColumnFace(
  const glm::vec4& codes, const glm::vec2& fraction, const glm::vec3& direction)
{
  const glm::vec2 reach = kColumnReach * glm::sign(glm::vec2(direction));
  const glm::bvec2 from = glm::greaterThanEqual(fraction - reach, glm::vec2(0.5f));
  const glm::bvec2 to = glm::greaterThanEqual(fraction + reach, glm::vec2(0.5f));
  const float near = ColumnCode(codes, from);
  const float far = ColumnCode(codes, to);
  ColumnFace face;
  face.code = std::max(near, far);
  face.front = near == far ? direction.z <= 0.0f : near < far;
  if (near != far)
  {
    const glm::vec2 outward = (near < far ? -1.0f : 1.0f) * glm::sign(glm::vec2(direction));
    face.normal =
      from.x != to.x ? glm::vec3(outward.x, 0.0f, 0.0f) : glm::vec3(0.0f, outward.y, 0.0f);
  }
  return face;
}
}

#endif
