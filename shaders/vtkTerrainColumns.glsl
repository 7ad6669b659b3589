// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface of constant columns, one around each sample and as high as that: the nearest sample's
// height, as Park and Oh's pyramid without bounding map draws it. A cell, which lies between
// samples, shows a quarter of four columns. Needs vtkTerrainHeights.glsl. Constant:
// terrainColumnReach, cells by which a point on a wall is told from one on a top.
//
// Twins in src/core/: surface/Columns.h.

// The face of a column that a ray meets.
struct TerrainColumnFace
{
  vec3 normal; // of its outer side, in cells and codes: up or along an axis
  bool front;  // the outer side is seen
  float code;  // height code of the column
};

// Code of the sample whose column has a quarter of a cell: east, north half or not.
float terrainColumnCode(vec4 codes, bvec2 quarter)
{
  vec2 row = quarter.y ? codes.zw : codes.xy;
  return quarter.x ? row.y : row.x;
}

// Where a segment from one position in a cell to another first meets the columns, as a part of the
// segment; -1 if it does not. Positions are fractions of the cell and height codes. Top faces and
// side walls are met.
float terrainIntersectColumns(vec4 codes, vec3 begin, vec3 end)
{
  bvec2 from = greaterThanEqual(begin.xy, vec2(0.5));
  bvec2 to = greaterThanEqual(end.xy, vec2(0.5));
  // Where the segment goes over into other columns: a wall is crossed if and only if sides differ.
  vec2 wall = mix(vec2(1.0), clamp((0.5 - begin.xy) / (end.xy - begin.xy), vec2(0.0), vec2(1.0)),
    notEqual(from, to));
  bvec2 between = wall.x <= wall.y ? bvec2(to.x, from.y) : bvec2(from.x, to.y);
  float t1 = min(wall.x, wall.y);
  float t2 = max(wall.x, wall.y);
  vec3 columns = vec3(terrainColumnCode(codes, from), terrainColumnCode(codes, between),
    terrainColumnCode(codes, to));
  vec2 z = begin.z + (end.z - begin.z) * vec2(t1, t2);
  float side = begin.z < columns.x ? -1.0 : 1.0;
  // Height above each column where the segment begins and ends on it, seen from its first side.
  vec3 above = side * (vec3(begin.z, z) - columns);
  vec3 after = side * (vec3(z, end.z) - columns);
  float t = after.z <= 0.0 ? t2 + (1.0 - t2) * above.z / (above.z - after.z) : -1.0;
  t = above.z <= 0.0 ? t2 : t;
  t = after.y <= 0.0 ? t1 + (t2 - t1) * above.y / (above.y - after.y) : t;
  t = above.y <= 0.0 ? t1 : t;
  t = after.x <= 0.0 ? t1 * above.x / (above.x - after.x) : t;
  return above.x <= 0.0 ? 0.0 : t;
}

// The face that a ray of a direction (cells, cells, codes) meets at a position in a cell: a wall
// where columns of different height meet there, else a top.
TerrainColumnFace terrainFindColumnFace(vec4 codes, vec2 fraction, vec3 direction)
{
  vec2 reach = terrainColumnReach * sign(direction.xy);
  bvec2 from = greaterThanEqual(fraction - reach, vec2(0.5));
  bvec2 to = greaterThanEqual(fraction + reach, vec2(0.5));
  float near = terrainColumnCode(codes, from);
  float far = terrainColumnCode(codes, to);
  float outward = near < far ? -1.0 : 1.0;
  vec3 wall = from.x != to.x ? vec3(outward * sign(direction.x), 0.0, 0.0)
                             : vec3(0.0, outward * sign(direction.y), 0.0);
  bool isTop = near == far;
  return TerrainColumnFace(isTop ? vec3(0.0, 0.0, 1.0) : wall,
    isTop ? direction.z <= 0.0 : near < far, max(near, far));
}
