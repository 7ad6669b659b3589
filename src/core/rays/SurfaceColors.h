// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of a point of the surface: twins of the functions of shaders/vtkTerrainColor.glsl, which
 * have the prefix terrain and document them. The uniforms are members. For tests: nothing is drawn
 * by it.
 */
#ifndef terrain_SurfaceColors_h
#define terrain_SurfaceColors_h

#include "core/rays/PaintKinds.h"
#include "core/rays/SurfaceShading.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace terrain
{
/// Texture coordinates of a grid of size samples, and how they change from a pixel to the next.
inline glm::vec2 TexturePosition(const ShadedPoint& point, const glm::ivec2& size)
{
  return glm::vec2((glm::dvec2(point.Cell) + glm::dvec2(point.Fraction)) / glm::dvec2(size - 1));
}
inline glm::dmat2 TextureFootprint(
  const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point, const glm::ivec2& size)
{
  const glm::dmat2 footprint = Footprint(rays, pixel, point);
  return { footprint[0] / glm::dvec2(size - 1), footprint[1] / glm::dvec2(size - 1) };
}

struct SurfacePaint
{
  glm::vec3 Add{ 0.0F, 0.0F, 0.0F };
  float Keep = 1.0F;
  float Alpha = 1.0F;
};

inline SurfacePaint Over(const SurfacePaint& paint, const glm::vec3& color, float coverage)
{
  return { glm::mix(paint.Add, color, coverage), (1.0F - coverage) * paint.Keep,
    glm::mix(paint.Alpha, 1.0F, coverage) };
}

inline float CornerWeight(const glm::ivec2& corner, const glm::vec2& fraction)
{
  return (corner.x == 1 ? fraction.x : 1.0F - fraction.x) *
    (corner.y == 1 ? fraction.y : 1.0F - fraction.y);
}

/// The uniforms of the colours, and what is made of them.
struct SurfaceColors
{
  PaintKinds Kind = PaintKinds::Material;
  glm::ivec2 Size{ 0, 0 };   ///< samples
  std::vector<float> Values; ///< of samples, row by row
  std::vector<glm::vec4> Colors;
  glm::vec2 GradientScale{ 1.0F, 1.0F };
  std::vector<glm::vec4> ColorMap; ///< kColorMapSize
  std::array<glm::vec4, 3> SpecialColors{};
  glm::vec2 ValueScale{ 1.0F, 0.0F };
  glm::vec2 ColorScale{ 1.0F, 0.0F };
  bool ColorLogarithm = false;
  float MaximumShownCrossings = 1.0F;
  glm::vec4 Drape{ 0.0F, 0.0F, 0.0F, 0.0F }; ///< a picture of one colour, multiplied by its alpha
  glm::dvec4 DrapeScale{ 0.0, 0.0, 0.0, 0.0 };
  glm::vec3 SunDirection{ 0.0F, 0.0F, 1.0F };
  float ShadeRelief = 1.0F;
  float ShadeStrength = 0.0F;
  glm::dvec2 ContourScale{ 1.0, 0.0 };
  double ContourWidth = 1.0;
  double ContourIndex = 0.0;
  glm::vec4 ContourColor{ 0.0F, 0.0F, 0.0F, 0.0F };

  ///@{
  /// Numbers that colours are made of.
  float ArrayValue(const ShadedPoint& point, glm::vec4& color) const
  {
    float value = 0.0F;
    color = glm::vec4(0.0F);
    for (int k = 0; k < 4; ++k)
    {
      const glm::ivec2 corner(k & 1, k >> 1);
      const glm::ivec2 at = point.Cell + corner;
      const auto texel = static_cast<std::size_t>(at.x) +
        static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(at.y);
      const float weight = CornerWeight(corner, point.Fraction);
      const bool valid = std::min(this->Values[texel], value) > 0.5F * kNotANumber;
      value = valid ? value + weight * this->Values[texel] : kNotANumber;
      color += weight * this->Colors[texel];
    }
    return value;
  }
  glm::vec2 Steepness(const ShadedPoint& point) const
  {
    return this->GradientScale * point.Gradient;
  }
  float Slope(const ShadedPoint& point) const
  {
    return glm::degrees(std::atan(glm::length(this->Steepness(point))));
  }
  float Aspect(const ShadedPoint& point) const
  {
    const glm::vec2 down = -this->Steepness(point);
    const float aspect = glm::degrees(std::atan2(down.x, down.y));
    return glm::length(down) < 1e-6F ? kNotANumber : (aspect < 0.0F ? aspect + 360.0F : aspect);
  }
  float OwnValue(const ShadedPoint& point, glm::vec4& arrayColor) const
  {
    const float arrayValue = this->ArrayValue(point, arrayColor);
    switch (this->Kind)
    {
      case PaintKinds::Slope:
        return this->Slope(point);
      case PaintKinds::Aspect:
        return this->Aspect(point);
      case PaintKinds::Values:
        return arrayValue;
      default:
        return point.Code;
    }
  }
  float ShownValue(const ShadedPoint& point) const
  {
    glm::vec4 arrayColor;
    const float value = this->OwnValue(point, arrayColor);
    return value < 0.5F * kNotANumber ? std::numeric_limits<float>::quiet_NaN()
                                      : this->ValueScale.x * value + this->ValueScale.y;
  }
  ///@}

  ///@{
  /// Colours.
  glm::vec4 MapColor(float value) const
  {
    const float logarithm =
      std::log(std::max(this->ValueScale.x * value + this->ValueScale.y, 1e-37F));
    const float t =
      this->ColorScale.x * (this->ColorLogarithm ? logarithm : value) + this->ColorScale.y;
    const double texel = std::clamp(t * 1.0 * kColorMapSize, 0.0, kColorMapSize - 1.0);
    if (value < 0.5F * kNotANumber)
    {
      return this->SpecialColors[2];
    }
    return t < -1e-6F ? this->SpecialColors[0]
                      : (t > 1.0F + 1e-6F ? this->SpecialColors[1]
                                          : this->ColorMap[static_cast<std::size_t>(texel)]);
  }
  glm::vec4 CrossingsColor(int crossings) const
  {
    const float work =
      glm::clamp(static_cast<float>(crossings) / this->MaximumShownCrossings, 0.0F, 1.0F);
    const glm::vec3 hues(
      std::abs(4.0F * work - 4.0F), std::abs(4.0F * work - 2.0F), std::abs(4.0F * work));
    return { glm::clamp(2.0F - hues, 0.0F, 1.0F), 1.0F };
  }
  glm::vec4 OwnColor(const ShadedPoint& point) const
  {
    glm::vec4 arrayColor;
    const float value = this->OwnValue(point, arrayColor);
    switch (this->Kind)
    {
      case PaintKinds::Material:
        return { 0.0F, 0.0F, 0.0F, 1.0F };
      case PaintKinds::Colors:
        return arrayColor;
      case PaintKinds::Crossings:
        return this->CrossingsColor(point.Crossings);
      default:
        return this->MapColor(value);
    }
  }
  ///@}

  ///@{
  /// Pictures, shades and lines.
  glm::vec4 DrapeColor(
    const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point) const
  {
    const glm::dvec2 scale(this->DrapeScale);
    const glm::dvec2 first(this->DrapeScale.z, this->DrapeScale.w);
    const glm::dvec2 last = first + scale * glm::dvec2(this->Size - 1);
    const glm::dvec2 position =
      first + scale * (glm::dvec2(point.Cell) + glm::dvec2(point.Fraction));
    const glm::dmat2 footprint = Footprint(rays, pixel, point);
    double coverage = 1.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double width = std::max(
        std::hypot(scale[axis] * footprint[0][axis], scale[axis] * footprint[1][axis]), 1e-30);
      const bool bordersLow = std::min(first[axis], last[axis]) <= -1e-6;
      const bool bordersHigh = std::max(first[axis], last[axis]) >= 1.0 + 1e-6;
      const double low = bordersLow ? position[axis] / width + 0.5 : 1.0;
      const double high = bordersHigh ? (1.0 - position[axis]) / width + 0.5 : 1.0;
      coverage *= glm::clamp(std::min(low, high), 0.0, 1.0);
    }
    return static_cast<float>(coverage) * this->Drape;
  }
  float Hillshade(const ShadedPoint& point) const
  {
    const glm::vec2 slope = this->ShadeRelief * this->Steepness(point);
    const float shade =
      std::max(glm::dot(glm::normalize(glm::vec3(-slope, 1.0F)), this->SunDirection), 0.0F);
    return glm::mix(1.0F, shade, this->ShadeStrength);
  }
  static double LineCoverage(double distance, double spacing, double width)
  {
    const double line = glm::clamp(std::min(0.5 * width + 0.5 - distance, width), 0.0, 1.0);
    return line * glm::clamp(spacing / (width + 1.0) - 1.0, 0.0, 1.0);
  }
  double ContourCoverage(
    const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point) const
  {
    const glm::dmat2 footprint = Footprint(rays, pixel, point);
    const glm::dvec2 gradient(point.Gradient);
    const double change = this->ContourScale.x *
      std::hypot(glm::dot(gradient, footprint[0]), glm::dot(gradient, footprint[1]));
    const double spacing = 1.0 / std::max(change, 1e-6);
    const double number = this->ContourScale.x * point.Code + this->ContourScale.y;
    const double nearest = std::floor(number + 0.5);
    const double index = this->ContourIndex;
    const double group = index * std::floor(number / std::max(index, 1.0) + 0.5);
    const double lines =
      LineCoverage(spacing * std::abs(number - nearest), spacing, this->ContourWidth);
    const double indexLines =
      LineCoverage(spacing * std::abs(number - group), spacing * index, 2.0 * this->ContourWidth);
    const bool isIndex = index > 0.0 && std::abs(nearest - group) < 0.5;
    return change < 1e-6 ? 0.0 : std::max(isIndex ? 0.0 : lines, index > 0.0 ? indexLines : 0.0);
  }
  SurfacePaint PaintSurface(
    const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point) const
  {
    const glm::vec4 color = this->OwnColor(point);
    SurfacePaint paint{ glm::vec3(color), this->Kind == PaintKinds::Material ? 1.0F : 0.0F,
      color.a };
    const glm::vec4 drape = this->DrapeColor(rays, pixel, point);
    paint = Over(paint, glm::vec3(drape) / std::max(drape.a, 1e-6F), drape.a);
    const float shade = this->Hillshade(point);
    paint = { shade * paint.Add, shade * paint.Keep, paint.Alpha };
    return Over(paint, glm::vec3(this->ContourColor),
      this->ContourColor.a * static_cast<float>(this->ContourCoverage(rays, pixel, point)));
  }
  /// Intensities and colours: ambient, diffuse.
  void PaintMaterial(const PixelRays& rays, const glm::dvec2& pixel, const ShadedPoint& point,
    const glm::vec2& intensities, glm::vec3& ambient, glm::vec3& diffuse, float& opacity) const
  {
    const SurfacePaint paint = this->PaintSurface(rays, pixel, point);
    ambient = intensities.x * paint.Add + paint.Keep * ambient;
    diffuse = intensities.y * paint.Add + paint.Keep * diffuse;
    opacity *= paint.Alpha;
  }
  ///@}
};
}

#endif
