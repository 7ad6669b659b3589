// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point of the surface that a fragment shows: what VTK's lights and colours work on.
// Needs vtkTerrainHeights.glsl, vtkTerrainView.glsl, vtkTerrainGradient.glsl and, for rays,
// vtkTerrainSighting.glsl and vtkTerrainCast.glsl; for columns, vtkTerrainColumns.glsl.
// Defines: TERRAIN_CAST for rays, TERRAIN_MESH for meshes; TERRAIN_BELOW_BOX if rays begin at the
// box; TERRAIN_DEPTH_OFFSET if depths are shifted thereafter; TERRAIN_COLUMNS for columns;
// TERRAIN_BLOCK if the surface covers a block that clipping planes cut; TERRAIN_CLIP_PLANES if
// there are such; TERRAIN_READ_SIGHTINGS if a compute shader has cast the rays
// (vtkTerrainSighting.glsl).
//
// Twins in src/core/: rays/ShadedSurface.h; of depths, sides and numbers, rays/SurfaceShading.h.

uniform int terrainFlat; // 1 for the normals of single patches, not of differences across them
uniform int terrainRowsFromNorth; // 1 if the image's first row is the last one here

struct TerrainSurface
{
  bool found;
  vec4 positionVC;
  vec3 normalVC;   // unit length, on the side of the viewer
  bool front;      // seen from above
  bool cut;        // a face at which a plane cuts a block
  ivec2 cell;
  vec2 fraction;   // position in the cell, 0..1
  float code;      // height code
  vec2 gradient;   // of the patch, codes per cell
  int crossings;   // work done, see TerrainHit
};

// The surface at a position in a cell, 0 <= fraction <= 1, with the normal of what its pixel
// covers, seen from above (front) or below. Codes: of the cell's corners; positionVC: the same
// place, as the pixel has it.
TerrainSurface terrainSurfaceAt(
  ivec2 cell, vec2 fraction, vec4 codes, vec4 positionVC, bool front)
{
  vec2 gradient = terrainPatchGradient(codes, fraction);
#ifdef TERRAIN_GLOBE
  terrainGlobeSetLocal(cell, fraction, codes, (terrainViewToGrid * positionVC).xyz);
#endif
  vec3 normalVC = terrainNormalVC(
    terrainFlat == 1 ? gradient : terrainGradient(cell, fraction, codes, -positionVC.z));
  return TerrainSurface(true, positionVC, front ? normalVC : -normalVC, front, false, cell,
    fraction, terrainPatchCode(codes, fraction), gradient, 0);
}

#ifdef TERRAIN_TILES
uniform int terrainArrayLevel; // level of the tiles of which the heights' own arrays are
#endif

// The cell of the heights' own arrays, without detail, and the position in it, 0..1.
ivec2 terrainArrayCell(TerrainSurface surface, out vec2 fraction)
{
#ifdef TERRAIN_DETAIL
  ivec2 cell = surface.cell >> terrainDetailLevel;
  fraction = (vec2(surface.cell - (cell << terrainDetailLevel)) + surface.fraction) /
    float(1 << terrainDetailLevel);
  return cell;
#elif defined(TERRAIN_TILES)
  ivec2 cell = surface.cell >> terrainArrayLevel;
  fraction = (vec2(surface.cell - (cell << terrainArrayLevel)) + surface.fraction) /
    float(1 << terrainArrayLevel);
  return cell;
#else
  fraction = surface.fraction;
  return surface.cell;
#endif
}

// Samples of these arrays.
ivec2 terrainArraySize()
{
#ifdef TERRAIN_TILES
  return ((terrainSize - 2) >> terrainArrayLevel) + 2;
#else
  return terrainTexelSize();
#endif
}

// Number of the cell in the image of the heights.
int terrainCellId(TerrainSurface surface)
{
  vec2 fraction;
  ivec2 cell = terrainArrayCell(surface, fraction);
  cell.y = terrainRowsFromNorth == 1 ? terrainArraySize().y - 2 - cell.y : cell.y;
  return cell.x + (terrainArraySize().x - 1) * cell.y;
}

// Number of the nearest sample in the image of the heights.
int terrainSampleId(TerrainSurface surface)
{
  vec2 fraction;
  ivec2 nearest = terrainArrayCell(surface, fraction);
  nearest += ivec2(floor(fraction + 0.5));
  nearest.y = terrainRowsFromNorth == 1 ? terrainArraySize().y - 1 - nearest.y : nearest.y;
  return nearest.x + terrainArraySize().x * nearest.y;
}

// The lower 24 bits of a number as a colour, as VTK's selection reads them.
vec4 terrainIdColor(int id)
{
  return vec4(float(id & 255), float((id >> 8) & 255), float((id >> 16) & 255), 255.0) / 255.0;
}

#ifdef TERRAIN_CAST
#if defined(TERRAIN_BELOW_BOX) && !defined(TERRAIN_DEPTH_OFFSET)
#ifdef GL_ARB_conservative_depth
layout(depth_greater) out float gl_FragDepth; // the hit lies behind the proxy
#endif
#endif

// Distance along the viewing direction, in world units, at which the ray of a fragment of the proxy
// begins; proxyVC: the fragment's position. On the box that is a little before the fragment, by
// what interpolation rounds.
float terrainEntry(vec4 proxyVC)
{
#ifdef TERRAIN_BELOW_BOX
  return -proxyVC.z - 1e-5 * abs(proxyVC.z);
#else
  return terrainBegin;
#endif
}

// Depth, 0..1, of a hit. Early depth tests with depth_greater need it behind the fragment, rounding
// included.
float terrainFragmentDepth(vec4 positionVC, float fragmentDepth)
{
#ifdef TERRAIN_BELOW_BOX
  return max(terrainDepth(positionVC), fragmentDepth);
#else
  return terrainDepth(positionVC);
#endif
}

// The point of the surface on the ray of a pixel (gl_FragCoord.xy), that of a fragment of the proxy
// at proxyVC; of one that meets nothing only found and crossings are set.
TerrainSurface terrainSeen(vec2 pixel, vec4 proxyVC)
{
#ifdef TERRAIN_READ_SIGHTINGS
  TerrainSighting sighting = terrainReadSighting(pixel);
#else
  TerrainSighting sighting = terrainCast(pixel, terrainEntry(proxyVC));
#endif
  TerrainSurface surface;
  surface.found = sighting.found;
  if (sighting.found)
  {
    surface = terrainSurfaceAt(sighting.cell, sighting.fraction, sighting.codes,
      terrainPositionVC(pixel, sighting.distanceVC), sighting.front);
#ifdef TERRAIN_COLUMNS
    TerrainColumnFace face =
      terrainFindColumnFace(sighting.codes, sighting.fraction, terrainAtPixelGC(pixel));
    surface.normalVC =
      normalize(terrainNormalMatrix * (sighting.front ? face.normal : -face.normal));
    surface.code = face.code;
#endif
  }
#ifdef TERRAIN_BLOCK
  if (sighting.found && sighting.wall >= 0)
  {
    surface.cut = true;
    surface.normalVC = -terrainClipPlanesVC[sighting.wall].xyz;
    surface.code = terrainPositionGC(pixel, sighting.distanceVC).z;
  }
#endif
  surface.crossings = sighting.crossings;
  return surface;
}
#endif

// Difference of depth, 0 to 1, from a pixel to the next on the surface, in the direction in which
// it is greatest.
float terrainDepthSlope(vec2 pixel, TerrainSurface surface)
{
  float s = -surface.positionVC.z;
  vec2 pace = terrainPlanePace(pixel, s, surface.gradient);
  vec2 depths = vec2(terrainDepth(terrainPositionVC(pixel + vec2(1.0, 0.0), s + pace.x)),
    terrainDepth(terrainPositionVC(pixel + vec2(0.0, 1.0), s + pace.y)));
  return length(depths - terrainDepth(surface.positionVC));
}

// Depth of the surface moved as coincident topology moves that of polygons: by a factor times its
// slope, and by an offset in 1/65000 of the range of depths.
float terrainShiftedDepth(vec2 pixel, TerrainSurface surface, float factor, float offset)
{
  return terrainDepth(surface.positionVC) + factor * terrainDepthSlope(pixel, surface) +
    offset / 65000.0;
}

#ifdef TERRAIN_MESH
// True if a clipping plane cuts a position off.
bool terrainIsClipped(vec4 positionVC)
{
  bool clipped = false;
#ifdef TERRAIN_CLIP_PLANES
  for (int i = 0; i < terrainClipPlaneCount; ++i)
  {
    clipped = clipped || dot(terrainClipPlanesVC[i], positionVC) < 0.0;
  }
#endif
  return clipped;
}

uniform int terrainMirrored; // 1 if triangles turn round on their way to the view

// A normal of the surface, on the viewer's side; all are of length 1, towardsVC points to the
// viewer. A mesh can be seen over a ridge where the surface below it falls away from the viewer
// already, whose normals would be lit from behind the ridge: there it turns to that of the mesh's
// face.
vec3 terrainFacingNormal(vec3 normalVC, vec3 faceVC, vec3 towardsVC)
{
  float facing = min(dot(normalVC, towardsVC), 0.0);
  return normalize(mix(normalVC - facing * towardsVC, faceVC, min(-4.0 * facing, 1.0)));
}

// The point of the surface below a point of a mesh, of which the front or the back is seen. faceVC:
// normal of the mesh's face on the viewer's side, of length 1; pixel: gl_FragCoord.xy.
TerrainSurface terrainPointBelow(vec4 positionVC, vec3 faceVC, vec2 pixel, bool front)
{
  vec2 positionGC = (terrainViewToGrid * positionVC).xy;
  ivec2 cell = clamp(ivec2(floor(positionGC)), ivec2(0), terrainSize - 2);
  TerrainSurface surface = terrainSurfaceAt(cell, clamp(positionGC - vec2(cell), 0.0, 1.0),
    terrainCellCodes(cell), positionVC, front != (terrainMirrored == 1));
  surface.normalVC = terrainFacingNormal(
    surface.normalVC, faceVC, -normalize(terrainDirectionAt(pixel)));
  return surface;
}

// The same of a fragment of a mesh, whose face it tells from the fragments beside it.
TerrainSurface terrainBelow(vec4 positionVC, bool front)
{
  vec3 face = cross(dFdx(positionVC.xyz), dFdy(positionVC.xyz));
  return terrainPointBelow(positionVC, normalize(face), gl_FragCoord.xy, front);
}
#endif
