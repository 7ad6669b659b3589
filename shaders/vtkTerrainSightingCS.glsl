// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compute shader: casts the rays of all pixels of a viewport into a texture of sightings, whose
// texels vtkTerrainSighting.glsl describes. Needs vtkTerrainCast.glsl.

layout(local_size_x = TERRAIN_GROUP_SIZE, local_size_y = TERRAIN_GROUP_SIZE) in;
layout(rgba32f, binding = 0) writeonly uniform image2D terrainSightingImage; // a texel a pixel

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(terrainSightingImage))))
  {
    return;
  }
  TerrainSighting sighting =
    terrainCast(vec2(texel + terrainViewportOrigin) + 0.5, terrainBegin);
  imageStore(terrainSightingImage, texel, terrainPackSighting(sighting));
}
