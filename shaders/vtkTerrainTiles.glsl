// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights and their bounds in tiles of several levels, some of which may be missing:
// src/core/surface/TileSource.h. Comes before vtkTerrainHeights.glsl, whose texels it is.
// Defines: TERRAIN_TILES; TERRAIN_HEIGHTS_INTEGER and TERRAIN_GATHER as there.
//
// Twins in src/core/: surface/TileSlots.h.

#ifdef TERRAIN_HEIGHTS_INTEGER
uniform usampler2DArray terrainTileHeights; // layer: slot; samples, one more than the cells
uniform usampler2DArray terrainTileBounds;  // maximum and minimum of its cells, from level 1 on
#else
uniform sampler2DArray terrainTileHeights;
uniform sampler2DArray terrainTileBounds;
#endif
uniform usamplerBuffer terrainTilePages; // for each tile 0, or its slot plus 1
uniform int terrainTileLevel;            // log2 of the cells along a side of a tile
uniform int terrainTileTop;              // the coarsest level, which has one tile
uniform int terrainTileTail;             // slot of the mip tail, bounds of the levels above the top
uniform float terrainTileBias;           // texel minus code

// The slot of the tile over a cell of a level; -1 if it is not there. The tail's above the top.
int terrainTileSlot(ivec2 cell, int level)
{
  int depth = max(terrainTileTop - level, 0);
  ivec2 tile = cell >> terrainTileLevel;
  int place = (0x55555555 & ((1 << (2 * depth)) - 1)) + (tile.y << depth) + tile.x;
  int slot = int(texelFetch(terrainTilePages, place).r) - 1;
  return level > terrainTileTop ? terrainTileTail : slot;
}

// Codes of the corners of a cell of a level, from a slot: south-west, south-east, north-west,
// north-east.
vec4 terrainSlotCodes(ivec2 cell, int slot)
{
  ivec3 at = ivec3(cell & ((1 << terrainTileLevel) - 1), slot);
#ifdef TERRAIN_GATHER
  // The position amidst the four texels: half a texel of room for any rounding.
  vec2 positionTC = (vec2(at.xy) + 1.0) / float((1 << terrainTileLevel) + 1);
  return vec4(textureGather(terrainTileHeights, vec3(positionTC, float(slot))).wzxy) -
    terrainTileBias;
#else
  return vec4(float(texelFetch(terrainTileHeights, at, 0).r),
           float(texelFetch(terrainTileHeights, at + ivec3(1, 0, 0), 0).r),
           float(texelFetch(terrainTileHeights, at + ivec3(0, 1, 0), 0).r),
           float(texelFetch(terrainTileHeights, at + ivec3(1, 1, 0), 0).r)) -
    terrainTileBias;
#endif
}

// Highest and lowest code of a cell of a level, level >= 1, from its slot, 0 or more.
vec2 terrainSlotBounds(ivec2 cell, int level, int slot)
{
  int side = 1 << terrainTileLevel;
  int above = max(level - terrainTileTop, 0);
  int begin = (side - ((2 * side) >> above)) & (side - 1); // TileTailColumn()
  ivec3 at = ivec3((cell & (side - 1)) + ivec2(begin, 0), slot);
  return vec2(texelFetch(terrainTileBounds, at, 0).rg) - terrainTileBias;
}

// The slot over a cell of level 0 at the finest level that is there and not finer than a level,
// which becomes that one.
int terrainFinestSlot(ivec2 cell, inout int level)
{
  int slot = terrainTileSlot(cell >> level, level);
  while (slot < 0 && level < terrainTileTop)
  {
    ++level;
    slot = terrainTileSlot(cell >> level, level);
  }
  return slot;
}

// Codes of the corners of a cell of level 0, of the surface at the finest level that is there:
// parts of a patch of a coarser level are patches. All negative where that has no surface.
vec4 terrainTileCellCodes(ivec2 cell)
{
  int level = 0;
  int slot = terrainFinestSlot(cell, level);
  vec4 codes = terrainSlotCodes(cell >> level, max(slot, 0));
  float width = 1.0 / float(1 << level);
  vec2 low = vec2(cell & ((1 << level) - 1)) * width;
  vec4 east = vec4(low.x, low.x + width, low.x, low.x + width);
  vec4 north = vec4(low.y, low.y, low.y + width, low.y + width);
  vec4 south = codes.x * (1.0 - east) + codes.y * east;
  vec4 corners = south * (1.0 - north) + (codes.z * (1.0 - east) + codes.w * east) * north;
  bool valid = slot >= 0 && all(greaterThanEqual(codes, vec4(0.0)));
  return level == 0 && slot >= 0 ? codes : valid ? corners : vec4(-1.0);
}

// Code of the surface of a level, or of the finest coarser one that is there, at a position
// in cells of level 0 relative to one; negative where there is none. size: of the heightfield, in
// samples of level 0; positions beyond it count as in the cell at its border.
float terrainTileHeight(ivec2 cell, vec2 position, int level, ivec2 size)
{
  ivec2 at = clamp(cell + ivec2(floor(position)), ivec2(0), size - 2);
  int slot = terrainFinestSlot(at, level);
  vec4 codes = terrainSlotCodes(at >> level, max(slot, 0));
  ivec2 first = (at >> level) << level;
  vec2 fraction = clamp((position - vec2(first - cell)) / float(1 << level), 0.0, 1.0);
  float south = codes.x * (1.0 - fraction.x) + codes.y * fraction.x;
  float north = codes.z * (1.0 - fraction.x) + codes.w * fraction.x;
  bool valid = slot >= 0 && all(greaterThanEqual(codes, vec4(0.0)));
  return valid ? south * (1.0 - fraction.y) + north * fraction.y : -1.0;
}
