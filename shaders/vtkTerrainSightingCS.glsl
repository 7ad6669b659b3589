// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compute shader: casts the rays of all pixels of a viewport into a texture of sightings, whose
// texels vtkTerrainSighting.glsl describes. Needs vtkTerrainCast.glsl.

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) writeonly uniform image2D terrainSightingImage;

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(terrainSightingImage))))
  {
    return;
  }
  TerrainSighting sighting =
    terrainCast(vec2(texel + terrainViewportOrigin) + 0.5, terrainNear);
  float work = float(sighting.crossings + 1);
  work += sighting.found ? float(sighting.wall + 1) / 32.0 : 0.0;
  imageStore(terrainSightingImage, texel,
    sighting.found ? vec4(sighting.distanceVC, vec2(sighting.cell) + sighting.fraction,
                       sighting.front ? work : -work)
                   : vec4(-1.0, 0.0, 0.0, work));
}
