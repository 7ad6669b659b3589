// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the pixel to its ray and back to the view. Needs vtkTerrainRay.glsl. Defines:
// TERRAIN_CLIP_PLANES, the most clipping planes, if there are any. Uses double precision where
// ARB_gpu_shader_fp64 exists: the ray's start is then exact to 1e-9 of a cell at any distance; else
// to 1e-7 of the distance. Pixels are those of gl_FragCoord.xy; distances are in world units.
//
// Twins in src/core/: rays/PixelRays.h, rays/SurfaceShading.h.

// Vectors that depend on the pixel: times (1, x, y); Low holds what float cuts off.
uniform mat3 terrainOriginGC;
uniform mat3 terrainOriginLowGC;
uniform mat3 terrainDirectionGC;
uniform mat3 terrainDirectionLowGC;
uniform mat3 terrainOriginVC;
uniform mat3 terrainDirectionVC;
uniform mat3 terrainNormalMatrix;  // (-dz/dx, -dz/dy, 1) in codes per cell to view coordinates
uniform vec4 terrainDepthRow;      // depth = 0.5 + 0.5 * dot(depth row, p) / dot(weight row, p)
uniform vec4 terrainWeightRow;
uniform vec3 terrainBoxMinimum;    // grid coordinates of the box of the terrain
uniform vec3 terrainBoxMaximum;
#ifdef TERRAIN_CLIP_PLANES
uniform int terrainClipPlaneCount;
uniform vec4 terrainClipPlanesVC[TERRAIN_CLIP_PLANES]; // kept is dot(plane, position) >= 0
#endif
uniform mat4 terrainViewToGrid; // view to grid coordinates
uniform float terrainBegin; // where rays begin and end, along the viewing direction: PixelRays.h
uniform float terrainFar;
uniform ivec2 terrainViewportOrigin; // lower left pixel of the viewport

#ifdef GL_ARB_gpu_shader_fp64
#define terrainReal double
#define terrainReal3 dvec3
#define terrainReal3x3 dmat3

// A number as two floats: its leading bits, and what those cut off. The bits are picked by hand:
// compilers take a number for the same after its way to float and back, and the rest for 0.
vec2 terrainSplit(double number)
{
  uvec2 bits = unpackDouble2x32(number);
  double leading = packDouble2x32(uvec2(bits.x & 0xE0000000u, bits.y));
  return vec2(leading, number - leading);
}
#else
#define terrainReal float
#define terrainReal3 vec3
#define terrainReal3x3 mat3

// Nothing is cut off where there is no double precision.
vec2 terrainSplit(float number)
{
  return vec2(number, 0.0);
}
#endif

// A vector that depends on the pixel, from its leading bits and what those cut off.
terrainReal3 terrainAtPixel(mat3 leading, mat3 low, vec2 pixel)
{
  return (terrainReal3x3(leading) + terrainReal3x3(low)) * terrainReal3(1.0, pixel);
}

// Where a pixel's ray is at distance 0 along the viewing direction, in grid coordinates.
terrainReal3 terrainPixelOrigin(vec2 pixel)
{
  return terrainAtPixel(terrainOriginGC, terrainOriginLowGC, pixel);
}

// How a pixel's ray moves per unit of distance along the viewing direction, in grid coordinates.
terrainReal3 terrainPixelDirection(vec2 pixel)
{
  return terrainAtPixel(terrainDirectionGC, terrainDirectionLowGC, pixel);
}

// The ray of a pixel (gl_FragCoord.xy) between two distances along the viewing direction, stored
// relative to the cell where it starts.
TerrainRay terrainPixelRay(vec2 pixel, float startDistance, float endDistance)
{
  terrainReal3 direction = terrainPixelDirection(pixel);
  terrainReal3 position = terrainPixelOrigin(pixel) + terrainReal(startDistance) * direction;
  terrainReal3 anchor = floor(position);
  vec2 height = terrainSplit(position.z);
  return TerrainRay(ivec2(anchor.xy), vec3(position.xy - anchor.xy, height.x), vec3(direction), 0.0,
    endDistance - startDistance, height.y);
}

// Direction of a pixel's ray in grid coordinates, per unit of distance along the viewing direction.
vec3 terrainAtPixelGC(vec2 pixel)
{
  return terrainDirectionGC * vec3(1.0, pixel);
}

// Position at a distance along the viewing direction, in grid coordinates.
vec3 terrainPositionGC(vec2 pixel, float distanceVC)
{
  return vec3(
    terrainPixelOrigin(pixel) + terrainReal(distanceVC) * terrainPixelDirection(pixel));
}

// The part of the distances [range.x, range.y] of a pixel's ray within the box of the terrain, a
// little widened; range.x >= range.y if there is none.
vec2 terrainEnterBox(vec2 pixel, vec2 range)
{
  vec3 origin = vec3(terrainPixelOrigin(pixel));
  vec3 direction = terrainAtPixelGC(pixel);
  vec3 still = vec3(equal(direction, vec3(0.0)));
  vec3 inverse = (1.0 - still) / (direction + still);
  vec3 lower = (terrainBoxMinimum - origin) * inverse;
  vec3 upper = (terrainBoxMaximum - origin) * inverse;
  vec3 nearest = mix(min(lower, upper), vec3(range.x), still);
  vec3 farthest = mix(max(lower, upper), vec3(range.y), still);
  float enter = max(max(nearest.x, nearest.y), nearest.z);
  float leave = min(min(farthest.x, farthest.y), farthest.z);
  float slack = 1e-5 * max(abs(enter), abs(leave));
  return vec2(max(range.x, enter - slack), min(range.y, leave + slack));
}

#ifdef TERRAIN_GLOBE
// About the point that a pixel shows: from the axes of the anchor to cells, cells and height codes
// (terrainGlobeSetLocal()).
mat3 terrainGlobeLocal;

// A direction in cells and height codes, from grid coordinates.
vec3 terrainToCells(vec3 directionGC)
{
  return terrainGlobeLocal * directionGC;
}

// Cells to the east and north along a metre.
vec2 terrainCellsPerMetre()
{
  mat3 rows = transpose(terrainGlobeLocal);
  return vec2(length(rows[0]), length(rows[1]));
}
#else
// Grid coordinates are cells and height codes already.
vec3 terrainToCells(vec3 directionGC)
{
  return directionGC;
}
#endif

// How the distance along the viewing direction changes from a pixel to the next on the plane
// through a point of the pixel's ray at distance s: in x, in y. The plane's gradient is in codes
// per cell. At grazing angles the change is limited.
vec2 terrainPlanePace(vec2 pixel, float s, vec2 gradient)
{
  vec3 direction = terrainToCells(terrainAtPixelGC(pixel));
  float slope = dot(gradient, direction.xy);
  float least = 1e-3 * (abs(direction.z) + abs(slope)) + 1e-30;
  float closing = direction.z - slope;
  closing = (closing < 0.0 ? -1.0 : 1.0) * max(abs(closing), least);
  vec3 moveX = terrainToCells(terrainOriginGC[1] + s * terrainDirectionGC[1]);
  vec3 moveY = terrainToCells(terrainOriginGC[2] + s * terrainDirectionGC[2]);
  return vec2(dot(gradient, moveX.xy) - moveX.z, dot(gradient, moveY.xy) - moveY.z) / closing;
}

// Direction of a pixel's ray in view coordinates, z = -1.
vec3 terrainDirectionAt(vec2 pixel)
{
  return terrainDirectionVC * vec3(1.0, pixel);
}

// Position at a distance along the viewing direction, in view coordinates.
vec4 terrainPositionVC(vec2 pixel, float distanceVC)
{
  return vec4(
    terrainOriginVC * vec3(1.0, pixel) + distanceVC * terrainDirectionAt(pixel), 1.0);
}

// Depth, 0 to 1 between the near and the far plane, of a position in view coordinates; 0 before the
// near plane.
float terrainDepth(vec4 positionVC)
{
  float weight = max(dot(terrainWeightRow, positionVC), 1e-30);
  return max(0.5 + 0.5 * dot(terrainDepthRow, positionVC) / weight, 0.0);
}

// Unit normal in view coordinates from the gradient in codes per cell; points up in the grid.
vec3 terrainNormalVC(vec2 gradient)
{
#ifdef TERRAIN_GLOBE
  return normalize(terrainNormalMatrix * (vec3(-gradient, 1.0) * terrainGlobeLocal));
#else
  return normalize(terrainNormalMatrix * vec3(-gradient, 1.0));
#endif
}
