// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compute shader: the shares of the lights that the points of all sightings of a viewport see.
// Needs vtkTerrainSighting.glsl, vtkTerrainSurface.glsl and vtkTerrainLight.glsl, whose functions
// and constants it uses; of its own it has no twins.

layout(local_size_x = TERRAIN_GROUP_SIZE, local_size_y = TERRAIN_GROUP_SIZE) in;
// A texel a pixel: terrainPackShares(), or 0 where nothing is seen.
layout(rgba32f, binding = 0) writeonly uniform image2D terrainLightImage;

// The point of a sighting in a pixel (gl_FragCoord.xy). Its position comes from its distance, which
// tells it to a part of a pixel; the position in the texel is coarser.
TerrainSurface terrainSightedPoint(vec2 pixel, TerrainSighting sighting)
{
  TerrainRay ray = terrainPixelRay(pixel, sighting.distanceVC, sighting.distanceVC);
  ivec2 cell = clamp(ray.anchorCell, ivec2(0), terrainSize - 2);
  vec2 fraction = clamp(ray.originGC.xy + vec2(ray.anchorCell - cell), 0.0, 1.0);
  return TerrainSurface(true, terrainPositionVC(pixel, sighting.distanceVC), vec3(0.0),
    sighting.front, sighting.wall >= 0, cell, fraction, 0.0, vec2(0.0), 0);
}

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(terrainLightImage))))
  {
    return;
  }
  vec2 pixel = vec2(texel + terrainViewportOrigin) + 0.5;
  TerrainSighting sighting = terrainReadSighting(pixel);
  vec4 shares = vec4(0.0);
  if (sighting.found)
  {
    float found[TERRAIN_SHADOWS];
    terrainFindShares(pixel, terrainSightedPoint(pixel, sighting), found);
    shares = terrainPackShares(found);
  }
  imageStore(terrainLightImage, texel, shares);
}
