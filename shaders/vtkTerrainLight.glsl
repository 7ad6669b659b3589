// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of each light a point of the surface sees over the surface. Needs vtkTerrainView.glsl
// and vtkTerrainSurface.glsl; to cast rays, vtkTerrainOutlook.glsl, on a globe
// vtkTerrainGlobeTrace.glsl.
// Defines: TERRAIN_SHADOWS, how many lights cast shadows; TERRAIN_SHADOW_BOUNDS if there are bounds
// of one's rays (vtkTerrainOutlook.glsl); TERRAIN_CLIP_PLANES and TERRAIN_COLUMNS as in
// vtkTerrainCast.glsl; TERRAIN_READ_LIGHTS if a compute shader has cast the rays
// (vtkTerrainLightCS.glsl).
// Constant: terrainShareSteps, steps of a share in a texel (kShareSteps in src/render/Features.h).
//
// A sun is a disc of even brightness, whose share above a level horizon is that of the circle
// beyond a chord: (acos(x) - x sqrt(1 - x^2)) / pi for a chord at x radii from the centre, by the
// area of a circular segment. The horizon is that of the sun's azimuth, taken to be level across
// the disc.
//
// Twins in src/core/: rays/ShadedSurface.h; of discs and ends, rays/SurfaceShading.h.

// A texel of shares of lights: two in each channel, in order, each in terrainShareSteps steps from
// 0 to 1; the second of a channel counts terrainShareSteps times as much.
vec4 terrainPackShares(float shares[TERRAIN_SHADOWS])
{
  vec4 texel = vec4(0.0);
  for (int i = 0; i < TERRAIN_SHADOWS; ++i)
  {
    float steps = floor(shares[i] * (terrainShareSteps - 1.0) + 0.5);
    texel[i >> 1] += (i & 1) == 0 ? steps : steps * terrainShareSteps;
  }
  return texel;
}

// The shares, 0..1, that a texel of terrainPackShares() holds, to half a step.
void terrainUnpackShares(vec4 texel, out float shares[TERRAIN_SHADOWS])
{
  for (int i = 0; i < TERRAIN_SHADOWS; ++i)
  {
    float pair = texel[i >> 1];
    float high = floor(pair / terrainShareSteps);
    shares[i] = ((i & 1) == 0 ? pair - high * terrainShareSteps : high) / (terrainShareSteps - 1.0);
  }
}

#ifdef TERRAIN_READ_LIGHTS
uniform sampler2D terrainLightShares; // one texel a pixel of the viewport: terrainPackShares()

// The shares, 0..1, of all lights that cast shadows which a compute shader has found for a pixel
// (gl_FragCoord.xy); surface: not needed here.
void terrainFindShares(vec2 pixel, TerrainSurface surface, out float shares[TERRAIN_SHADOWS])
{
  terrainUnpackShares(
    texelFetch(terrainLightShares, ivec2(pixel) - terrainViewportOrigin, 0), shares);
}
#else
// Sun: direction in cells, of length 1 or, at the zenith, 0; tangents of the disc's lower and upper
// edge, codes per cell.
uniform vec4 terrainLightsGC[TERRAIN_SHADOWS];
// Sun: the same way in view coordinates, w = 0; lamp: position, w = 1.
uniform vec4 terrainLightsVC[TERRAIN_SHADOWS];
// Altitude and radius of the disc, radians; tangent in the model over that in codes per cell; share
// of the light that a shadow takes away, 0..1.
uniform vec4 terrainLightDiscs[TERRAIN_SHADOWS];

#ifdef TERRAIN_GLOBE
// By how much a ray begins above the ground: parts of a cell, and of its distance from the eye.
const vec2 terrainGlobeLift = vec2(1e-3, 4e-7);

// True if the ground or the planet below it stands between a point of the surface and a light. The
// ray starts above the ground by what float rounds; where it starts below, it comes up through the
// ground and goes on.
bool terrainGlobeHides(vec4 positionVC, vec4 lightVC)
{
  vec3 way = mat3(terrainViewToGrid) * (lightVC.xyz - lightVC.w * positionVC.xyz);
  float far = length(way);
  float end = lightVC.w > 0.0 ? far : terrainGlobeNever;
  vec3 point = (terrainViewToGrid * positionVC).xyz;
  vec2 cells = terrainCellsPerMetre();
  float lift = dot(terrainGlobeLift,
    vec2(1.0 / max(cells.x, cells.y), length(point) + length(positionVC.xyz)));
  vec3 up = normalize(transpose(terrainGlobeLocal)[2]);
  vec3 origin = point + lift * up;
  way /= max(far, 1e-20);
  TerrainGlobePath path = terrainGlobeMakePath(origin, way, 0.0, end);
  vec2 inner = terrainGlobeMeetShell(path, terrainGlobeInner.xyz);
  bool hidden = inner.x < inner.y && inner.x > 0.0 && inner.x < end;
  float begin = 0.0;
  bool on = !hidden;
  for (int i = 0; i < 3 && on; ++i)
  {
    TerrainGlobeHit hit = terrainGlobeTrace(origin, way, begin, end);
    hidden = hit.found && hit.front;
    on = hit.found && !hit.front;
    begin = hit.t + terrainGlobeBeyond;
  }
  return hidden;
}

// The shares of all lights at a point of the surface of a globe: suns are points there.
void terrainFindShares(vec2 pixel, TerrainSurface surface, out float shares[TERRAIN_SHADOWS])
{
  for (int i = 0; i < TERRAIN_SHADOWS; ++i)
  {
    vec4 light = terrainLightsVC[i];
    vec3 way = light.xyz - light.w * surface.positionVC.xyz;
    bool shines = surface.front && dot(surface.normalVC, way) > 0.0; // else VTK's own dark
    bool hidden = shines && terrainGlobeHides(surface.positionVC, light);
    shares[i] = hidden ? 1.0 - terrainLightDiscs[i].w : 1.0;
  }
}
#else
#ifdef TERRAIN_SHADOW_BOUNDS
uniform int terrainBoundedLight; // whose rays terrainShadowBounds is for
#endif

// The share, 0..1, of a sun's disc above a horizon, whose tangent is in codes per cell; disc: its
// terrainLightDiscs.
float terrainDiscShare(vec4 disc, float tangent)
{
  float x = clamp((atan(tangent * disc.z) - disc.x) / max(disc.y, 1e-6), -1.0, 1.0);
  return (acos(x) - x * sqrt(1.0 - x * x)) / 3.14159265;
}

// Distance along a way from a position at which the first clipping plane ends it, end at most, in
// units of directionVC's length.
float terrainPlaneEnd(vec3 positionVC, vec3 directionVC, float end)
{
#ifdef TERRAIN_CLIP_PLANES
  for (int i = 0; i < terrainClipPlaneCount; ++i)
  {
    float inside = max(dot(terrainClipPlanesVC[i], vec4(positionVC, 1.0)), 0.0);
    float leaving = -dot(terrainClipPlanesVC[i].xyz, directionVC);
    end = leaving > 0.0 ? min(end, inside / leaving) : end;
  }
#endif
  return end;
}

// The share, 0..1, of a light (its number among those that cast shadows) that a point sees;
// outlook: of the point, its way still to be set. None is looked for where the light is behind the
// normal.
float terrainLightShare(int light, TerrainOutlook outlook, vec3 positionVC, vec3 normalVC)
{
  vec4 wayGC = terrainLightsGC[light];
  vec4 wayVC = terrainLightsVC[light];
  float end = 1e30;
  if (wayVC.w > 0.0)
  {
    wayVC.xyz -= positionVC;
    vec3 way = mat3(terrainViewToGrid) * wayVC.xyz;
    end = length(way.xy);
    float pace = 1.0 / max(end, 1e-20);
    wayGC = vec4(way.xy, way.zz) * pace;
    wayVC.xyz *= pace;
  }
  outlook.direction = wayGC.xy;
#ifdef TERRAIN_SHADOW_BOUNDS
  outlook.bounded = light == terrainBoundedLight;
#endif
  outlook.low = wayGC.z;
  outlook.high = wayGC.w;
  outlook.end = terrainPlaneEnd(positionVC, wayVC.xyz, end);
  float share = wayGC.w > 0.0 ? 1.0 : 0.0; // of a light overhead
  if (dot(wayGC.xy, wayGC.xy) > 0.25 && end > 1e-6 && dot(normalVC, wayVC.xyz) >= 0.0)
  {
    float tangent = terrainHorizonTangent(outlook);
    share = tangent <= wayGC.z ? 1.0 : tangent > wayGC.w ? 0.0 :
      terrainDiscShare(terrainLightDiscs[light], tangent);
  }
  return 1.0 - terrainLightDiscs[light].w * (1.0 - share);
}

// The shares, 0..1, that a point of the surface sees of all lights that cast shadows, in a pixel
// (gl_FragCoord.xy). Those behind a block's cut faces, where nothing is left, and those of the
// underside are whole: VTK's own light.
void terrainFindShares(vec2 pixel, TerrainSurface surface, out float shares[TERRAIN_SHADOWS])
{
  vec4 codes = terrainCellCodes(surface.cell);
  TerrainOutlook outlook = TerrainOutlook(surface.cell, surface.fraction, codes,
    terrainPatchCode(codes, surface.fraction), vec2(0.0), 0.0, 0.0, 0.0, false);
#ifdef TERRAIN_COLUMNS
  // The pixel's ray has come through the air before a wall: the way begins there.
  vec3 ray = terrainAtPixelGC(pixel);
  TerrainColumnFace face = terrainFindColumnFace(codes, surface.fraction, ray);
  outlook.fraction = clamp(surface.fraction - terrainColumnReach * sign(ray.xy), 0.0, 1.0);
  outlook.code =
    face.normal.z > 0.0 ? face.code : terrainPositionGC(pixel, -surface.positionVC.z).z;
#endif
  for (int i = 0; i < TERRAIN_SHADOWS; ++i)
  {
    shares[i] = surface.cut || !surface.front
      ? 1.0
      : terrainLightShare(i, outlook, surface.positionVC.xyz, surface.normalVC);
  }
}
#endif
#endif
