// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compute shader: one texel for each tile of TERRAIN_BEAM_PIXELS x TERRAIN_BEAM_PIXELS pixels of a
// viewport: the distance along the viewing direction, in world units, before which none of the
// tile's rays meets the surface. Needs vtkTerrainBeam.glsl and vtkTerrainView.glsl.

layout(local_size_x = TERRAIN_GROUP_SIZE, local_size_y = TERRAIN_GROUP_SIZE) in;
layout(r32f, binding = 0) writeonly uniform image2D terrainBeamImage; // a texel a tile

// Part of a distance that is taken off for what float rounds where rays begin.
const float terrainBeamSlack = 1e-6;

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(terrainBeamImage))))
  {
    return;
  }
  vec2 middle = vec2(terrainViewportOrigin) + float(TERRAIN_BEAM_PIXELS) * (vec2(texel) + 0.5);
  TerrainBeam beam =
    terrainTileBeam(middle, 0.5 * float(TERRAIN_BEAM_PIXELS), terrainBegin, terrainFar);
  float start = terrainBegin + terrainBeamStart(beam);
  imageStore(terrainBeamImage, texel, vec4(start - terrainBeamSlack * abs(start)));
}
