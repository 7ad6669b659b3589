// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The point of a surface that a pixel shows, with its normal, and the light that it gets: of the
 * sky and of lights that cast shadows. Twins of functions of shaders/vtkTerrainSurface.glsl,
 * vtkTerrainLight.glsl and vtkTerrainSky.glsl, which have the prefix terrain and document them;
 * uniforms are arguments here. For tests: nothing is drawn by it.
 */
#ifndef terrain_ShadedSurface_h
#define terrain_ShadedSurface_h

#include "core/rays/Outlook.h"
#include "core/rays/SurfaceShading.h"
#include "core/surface/HeightGradient.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace terrain
{
/// What lights and colours work on.
struct ShadedSurface : ShadedPoint
{
  glm::vec3 NormalVC{ 0.0F, 0.0F, 1.0F }; ///< unit length, on the side of the viewer
  bool Front = true;                      ///< seen from above
  bool Cut = false;                       ///< a face at which a plane cuts a block
};

/// Codes: of the cell's corners. Flat: the normal is that of the patch alone.
template <typename Heights>
ShadedSurface SurfaceAt(const PixelRays& rays, const Heights& heights, const HeightSlopes& slopes,
  const glm::ivec2& cell, const glm::vec2& fraction, const glm::vec4& codes,
  const glm::vec4& positionVC, bool front, bool flat)
{
  ShadedSurface surface;
  surface.PositionVC = positionVC;
  surface.Cell = cell;
  surface.Fraction = fraction;
  surface.Code = PatchCode(codes, fraction);
  surface.Gradient = PatchGradient(codes, fraction);
  const auto width = static_cast<float>(PixelCells(rays, -static_cast<double>(positionVC.z)));
  const glm::vec2 gradient =
    flat ? surface.Gradient : terrain::Gradient(heights, slopes, cell, fraction, codes, width);
  surface.NormalVC = (front ? 1.0F : -1.0F) * terrain::NormalVC(rays, gradient);
  surface.Front = front;
  return surface;
}

/// The point of the surface below one of a mesh, whose face has a normal; pixel: the fragment's.
template <typename Heights>
ShadedSurface PointBelow(const PixelRays& rays, const Heights& heights, const HeightSlopes& slopes,
  const glm::dmat4& viewToGrid, const glm::vec4& positionVC, const glm::vec3& faceVC,
  const glm::dvec2& pixel, bool front, bool flat)
{
  const glm::dvec2 positionGC(viewToGrid * glm::dvec4(positionVC));
  const glm::ivec2 cell =
    glm::clamp(glm::ivec2(glm::floor(positionGC)), glm::ivec2(0), heights.size - 2);
  const glm::vec2 fraction(glm::clamp(positionGC - glm::dvec2(cell), 0.0, 1.0));
  ShadedSurface surface = SurfaceAt(
    rays, heights, slopes, cell, fraction, heights.CellCodes(cell), positionVC, front, flat);
  surface.NormalVC = FacingNormal(
    surface.NormalVC, faceVC, -glm::normalize(glm::vec3(AtPixel(rays.DirectionVC, pixel))));
  return surface;
}

/// The cell of the heights' own arrays, of which one has 2^level cells each way, and the position
/// in it.
inline glm::ivec2 ArrayCell(const ShadedPoint& point, int level, glm::vec2& fraction)
{
  const glm::ivec2 cell = point.Cell >> level;
  fraction =
    (glm::vec2(point.Cell - (cell << level)) + point.Fraction) / static_cast<float>(1 << level);
  return cell;
}

/// Shares of the sky over the heights' own arrays, as a texture that ends at its edge.
struct SkyShares
{
  glm::ivec2 Size{ 1, 1 };
  std::vector<float> Texels;     ///< row by row
  glm::vec2 Scale{ 1.0F, 1.0F }; ///< texture coordinates a sample
  float Light = 1.0F;            ///< what the whole sky gives

  float SkyShare(const ShadedSurface& surface, int level) const
  {
    glm::vec2 fraction;
    const glm::ivec2 cell = ArrayCell(surface, level, fraction);
    const glm::vec2 at =
      (glm::vec2(cell) + fraction + 0.5F) * this->Scale * glm::vec2(this->Size) - 0.5F;
    const glm::ivec2 low(glm::floor(at));
    float share = 0.0F;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::ivec2 offset(corner & 1, corner >> 1);
      const glm::ivec2 texel = glm::clamp(low + offset, glm::ivec2(0), this->Size - 1);
      const glm::vec2 part = at - glm::vec2(low);
      share += (offset.x == 1 ? part.x : 1.0F - part.x) * (offset.y == 1 ? part.y : 1.0F - part.y) *
        this->Texels[static_cast<std::size_t>(texel.x + this->Size.x * texel.y)];
    }
    return this->Light * (surface.Cut ? 0.5F : (surface.Front ? share : 0.0F));
  }
};

/// A light that casts shadows: the uniforms terrainLightsGC, terrainLightsVC and terrainLightDiscs.
struct ShadowLight
{
  glm::vec4 WayGC{ 0.0F };
  glm::vec4 WayVC{ 0.0F };
  glm::vec4 Disc{ 0.0F };
};

/// Shares of lights that points of a surface see.
template <typename Rays>
struct LightShares
{
  const OutlookSearch<Rays>& Search;
  glm::mat3 ViewToGrid{ 1.0F };
  std::vector<glm::vec4> PlanesVC;

  float LightShare(const ShadowLight& light, Outlook outlook, const ShadedSurface& surface) const
  {
    glm::vec4 wayGC = light.WayGC;
    glm::vec4 wayVC = light.WayVC;
    const glm::vec3 position(surface.PositionVC);
    double end = 1e30;
    if (wayVC.w > 0.0F)
    {
      wayVC -= glm::vec4(position, 0.0F);
      const glm::vec3 way = this->ViewToGrid * glm::vec3(wayVC);
      end = glm::length(glm::vec2(way));
      const auto pace = static_cast<float>(1.0 / std::max(end, 1e-20));
      wayGC = pace * glm::vec4(way, way.z);
      wayVC = glm::vec4(pace * glm::vec3(wayVC), wayVC.w);
    }
    outlook.direction = glm::vec2(wayGC);
    outlook.low = wayGC.z;
    outlook.high = wayGC.w;
    outlook.end = static_cast<float>(PlaneEnd(this->PlanesVC, position, glm::vec3(wayVC), end));
    double share = wayGC.w > 0.0F ? 1.0 : 0.0;
    if (glm::dot(outlook.direction, outlook.direction) > 0.25F && outlook.end > 1e-6F &&
      glm::dot(surface.NormalVC, glm::vec3(wayVC)) >= 0.0F)
    {
      const float tangent = this->Search.HorizonTangent(outlook, [](glm::ivec2, int) {});
      share = tangent <= outlook.low
        ? 1.0
        : (tangent > outlook.high ? 0.0 : DiscShare(glm::dvec4(light.Disc), tangent));
    }
    return static_cast<float>(1.0 - static_cast<double>(light.Disc.w) * (1.0 - share));
  }

  /// Pixel and rays: those of the surface's point, which columns need.
  std::vector<float> FindShares(const std::vector<ShadowLight>& lights,
    const ShadedSurface& surface, const PixelRays& rays, const glm::dvec2& pixel) const
  {
    Outlook outlook;
    outlook.cell = surface.Cell;
    outlook.fraction = surface.Fraction;
    outlook.codes = this->Search.CellCodes(surface.Cell);
    outlook.code = PatchCode(outlook.codes, surface.Fraction);
    if (this->Search.rays.columns)
    {
      const glm::dvec3 way = AtPixel(rays.DirectionGC, pixel);
      const ColumnFace face = FindColumnFace(outlook.codes, surface.Fraction, glm::vec3(way));
      outlook.fraction =
        glm::clamp(surface.Fraction - kColumnReach * glm::sign(glm::vec2(way)), 0.0F, 1.0F);
      const double height = AtPixel(rays.OriginGC, pixel).z - surface.PositionVC.z * way.z;
      outlook.code = face.normal.z > 0.0F ? face.code : static_cast<float>(height);
    }
    std::vector<float> shares;
    for (const ShadowLight& light : lights)
    {
      shares.push_back(
        surface.Cut || !surface.Front ? 1.0F : this->LightShare(light, outlook, surface));
    }
    return shares;
  }
};

///@{
/// Two shares in each channel, of so many steps each.
inline glm::vec4 PackShares(const std::vector<float>& shares, float shareSteps)
{
  glm::vec4 texel(0.0F);
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const float steps = std::floor(shares[i] * (shareSteps - 1.0F) + 0.5F);
    texel[static_cast<int>(i / 2)] += i % 2 == 0 ? steps : steps * shareSteps;
  }
  return texel;
}
inline std::vector<float> UnpackShares(const glm::vec4& texel, std::size_t count, float shareSteps)
{
  std::vector<float> shares;
  for (std::size_t i = 0; i < count; ++i)
  {
    const float pair = texel[static_cast<int>(i / 2)];
    const float high = std::floor(pair / shareSteps);
    shares.push_back((i % 2 == 0 ? pair - high * shareSteps : high) / (shareSteps - 1.0F));
  }
  return shares;
}
///@}
}

#endif
