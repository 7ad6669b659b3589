// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A globe drawn by the mapper, and what is seen of it by the reference in double precision.
 */
#ifndef vtkTerrainTestGlobeDrawing_h
#define vtkTerrainTestGlobeDrawing_h

#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTestGlobe.h"

#include "core/globe/GlobeReference.h"
#include "data/GlobeData.h"
#include "data/GlobeSurface.h"

#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

namespace vtkTerrainTesting
{
using terrain::kDegree;

inline double GlobeHills(int i, int j)
{
  return std::floor(2000.0 + 2500.0 * std::sin(0.31 * i) * std::cos(0.23 * j) +
    1500.0 * std::sin(0.9 * i + j) * std::cos(1.3 * j));
}

/// Cells of a degree or half of it, all over a planet.
inline vtkSmartPointer<vtkImageData> MakeWorld(
  double step = 1.0, double equatorial = 0.0, double polar = 0.0)
{
  const int columns = static_cast<int>(360.0 / step);
  return LayOnGlobe(
    MakeDegrees(-180.0 + 0.5 * step, -90.0 + 0.5 * step, step, columns, columns / 2,
      [columns](int i, int j) { return GlobeHills(i < columns / 2 ? i : columns - i, j); }),
    equatorial, polar);
}

/// What is drawn against the reference.
struct Agreement
{
  int Pixels = 0;
  int Hits = 0;
  int Disagreements = 0;
  int Off = 0;
  double Largest = 0.0;
};

/// The first point of the surface that a ray meets from above.
inline terrain::GlobeReferenceHit CastSeen(
  const terrain::GlobeReference& reference, terrain::GlobeReferenceRay ray)
{
  const double metre = 1.0 / glm::length(ray.Direction);
  terrain::GlobeReferenceHit hit = reference.Cast(ray);
  const auto isAbove = [&](double t)
  {
    glm::ivec2 cell;
    glm::dvec2 fraction;
    return reference.Above(ray.Origin + t * ray.Direction, cell, fraction, false) > 0.0;
  };
  while (hit.Found && !isAbove(hit.T - 0.1 * metre))
  {
    ray.Begin = hit.T + 10.0 * metre;
    hit = reference.Cast(ray);
  }
  return hit;
}

/// How a picture's shadows agree with the reference.
struct Shadowed
{
  int Dark = 0;
  int Lit = 0;
  int Wrong = 0;
  int Bright = 0; ///< pixels of the picture that are not dark
};

class Globe
{
public:
  explicit Globe(vtkImageData* heights)
    : Shown(heights)
    , Grid(*terrain::GlobeData::Get(heights))
    , Heights(heights)
  {
    this->Shown.Mapper->RemoveMesh();
  }

  /// From a place to another: longitude, latitude in degrees, height in metres.
  void Look(const glm::dvec3& from, const glm::dvec3& to)
  {
    const auto position = [this](const glm::dvec3& place) {
      return this->Grid.Body.ToPosition({ place.x * kDegree, place.y * kDegree, place.z });
    };
    const glm::dvec3 eye = this->Scale * position(from);
    const glm::dvec3 focus = this->Scale * position(to);
    this->Shown.Camera()->SetPosition(eye.x, eye.y, eye.z);
    this->Shown.Camera()->SetFocalPoint(focus.x, focus.y, focus.z);
    const glm::dvec3 way = glm::normalize(focus - eye);
    const glm::dvec3 up = glm::normalize(eye);
    const bool down = std::abs(glm::dot(way, up)) > 0.99;
    this->Shown.Camera()->SetViewUp(down ? 0.13 : up.x, down ? 0.95 : up.y, down ? 0.3 : up.z);
    this->Shown.Scene.Renderer->ResetCameraClippingRange();
  }

  double Ground(double longitude, double latitude) const
  {
    glm::ivec2 cell;
    glm::dvec2 fraction;
    const auto reference = this->Reference();
    return -reference.Above(
      this->Grid.Body.ToPosition({ longitude * kDegree, latitude * kDegree, 0.0 }), cell, fraction,
      false);
  }

  terrain::GlobeReference Reference() const
  {
    double range[2];
    this->Heights->GetPointData()->GetScalars()->GetFiniteRange(range);
    const double exaggeration = this->Exaggeration;
    return { this->Grid,
      [this, exaggeration](int i, int j)
      {
        vtkUnsignedCharArray* ghosts = this->Heights->GetPointGhostArray();
        return ghosts && ghosts->GetValue(i + this->Grid.Columns * j) != 0
          ? terrain::kNaN
          : exaggeration * this->Heights->GetScalarComponentAsDouble(i, j, 0, 0);
      },
      { exaggeration * range[0], exaggeration * range[1] } };
  }

  Agreement Compare(double tolerance = terrain::kGlobeDrawnError)
  {
    vtkImageData* distances = this->Shown.Distances();
    const terrain::GlobeReference reference = this->Reference();
    const terrain::PixelRays rays = this->Rays();
    Agreement result;
    for (int y = 1; y < DrawingHeight; y += 3)
    {
      for (int x = 1; x < DrawingWidth; x += 3)
      {
        terrain::GlobeReferenceRay ray;
        ray.Origin = terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 }) / this->Scale;
        ray.Direction = terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 }) / this->Scale;
        ray.Begin = rays.Begin;
        ray.End = rays.Far;
        const auto hit = CastSeen(reference, ray);
        const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
        const bool both = hit.Found && !std::isnan(drawn);
        const double difference = both ? std::abs(drawn - hit.T) / hit.T : 0.0;
        ++result.Pixels;
        result.Hits += both ? 1 : 0;
        result.Disagreements += hit.Found == std::isnan(drawn) && hit.Nearest > 0.01 ? 1 : 0;
        result.Off += difference > tolerance ? 1 : 0;
        result.Largest = std::max(result.Largest, difference);
      }
    }
    return result;
  }

  /// A picture of what a sun lights, and of nothing else.
  vtkSmartPointer<vtkImageData> RenderSunlit(const glm::dvec3& sun);
  /// Pixels that a sun lights, by the picture and by the reference; those it grazes are left out.
  Shadowed CompareShadows(const glm::dvec3& sun, bool onlyPicture = false);
  /// How far, in pixels, the contour of a height lies from where it should be on the middle row.
  double ContourError(double level);

  terrain::PixelRays Rays()
  {
    vtkMatrix4x4* toView = this->Shown.Camera()->GetModelViewTransformMatrix();
    vtkMatrix4x4* toDisplay = this->Shown.Camera()->GetProjectionTransformMatrix(
      double(DrawingWidth) / DrawingHeight, -1.0, 1.0);
    glm::dmat4 view;
    glm::dmat4 display;
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        view[column][row] = toView->GetElement(row, column);
        display[column][row] = toDisplay->GetElement(row, column);
      }
    }
    return terrain::MakePixelRays(view, display, glm::dvec4(0.0, 0.0, DrawingWidth, DrawingHeight));
  }

  Drawing Shown;
  terrain::GlobeGrid Grid;
  vtkSmartPointer<vtkImageData> Heights;
  double Exaggeration = 1.0;
  double Scale = 1.0; ///< of the actor
};

inline vtkSmartPointer<vtkImageData> Globe::RenderSunlit(const glm::dvec3& sun)
{
  vtkRenderer* renderer = this->Shown.Scene.Renderer;
  renderer->RemoveAllLights();
  const vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(sun.x, sun.y, sun.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  renderer->SetBackground(0.0, 0.0, 0.0);
  this->Shown.Mapper->ScalarVisibilityOff();
  this->Shown.Mapper->SetSunShadows(true);
  this->Shown.Actor->GetProperty()->SetAmbient(0.0);
  this->Shown.Actor->GetProperty()->SetSpecular(0.0);
  return Render(this->Shown.Scene.Window);
}

inline Shadowed Globe::CompareShadows(const glm::dvec3& sun, bool onlyPicture)
{
  const auto picture = this->RenderSunlit(sun);
  this->Shown.Mapper->SetSunShadows(false);
  const auto bright = Render(this->Shown.Scene.Window);
  const terrain::GlobeReference reference = this->Reference();
  const terrain::PixelRays rays = this->Rays();
  terrain::GlobeSurface surface;
  surface.SetImage(this->Heights);
  Shadowed result;
  for (int y = 1; y < DrawingHeight; y += 4)
  {
    for (int x = 1; x < DrawingWidth; x += 4)
    {
      const double shade = picture->GetScalarComponentAsDouble(x, y, 0, 0);
      result.Bright += shade > 8.0 ? 1 : 0;
      terrain::GlobeReferenceRay ray;
      ray.Origin = terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 });
      ray.Direction = terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 });
      ray.Begin = rays.Begin;
      ray.End = rays.Far;
      const auto hit = onlyPicture ? terrain::GlobeReferenceHit() : CastSeen(reference, ray);
      if (!hit.Found)
      {
        continue;
      }
      glm::dvec3 normal;
      const glm::dvec3 point =
        surface.PositionAt(hit.Cell, hit.Fraction, this->Exaggeration, normal);
      if (glm::dot(normal, sun) < 0.3 || bright->GetScalarComponentAsDouble(x, y, 0, 0) <= 8.0)
      {
        continue; // dark by itself, or nearly, or by its normal's mean over the pixel
      }
      const auto isHidden = [&](double lift)
      {
        terrain::GlobeReferenceRay toSun;
        toSun.Origin = point + lift * normal;
        toSun.Direction = sun;
        toSun.End = 4.0 * this->Grid.Body.Equatorial;
        return CastSeen(reference, toSun).Found;
      };
      const bool hidden = isHidden(0.1);
      if (hidden != isHidden(1e-5 * glm::length(point - ray.Origin) + 2.0))
      {
        continue; // at the edge of a shadow
      }
      result.Dark += hidden ? 1 : 0;
      result.Lit += hidden ? 0 : 1;
      result.Wrong += hidden == (shade > 8.0) ? 1 : 0;
    }
  }
  return result;
}

inline double Globe::ContourError(double level)
{
  const auto picture = Render(this->Shown.Scene.Window);
  const terrain::GlobeReference reference = this->Reference();
  const terrain::PixelRays rays = this->Rays();
  constexpr int row = DrawingHeight / 2;
  const auto above = [&](double x)
  {
    terrain::GlobeReferenceRay ray;
    ray.Origin = terrain::AtPixel(rays.OriginGC, { x, row + 0.5 });
    ray.Direction = terrain::AtPixel(rays.DirectionGC, { x, row + 0.5 });
    ray.Begin = rays.Begin;
    ray.End = rays.Far;
    const auto hit = CastSeen(reference, ray);
    return hit.Found ? this->Grid.Body.ToPlace(ray.Origin + hit.T * ray.Direction).z - level
                     : terrain::kNaN;
  };
  double low = 0.2 * DrawingWidth;
  double high = 0.8 * DrawingWidth;
  const double first = above(low);
  EXPECT_LT(first * above(high), 0.0);
  for (int k = 0; k < 40; ++k)
  {
    const double middle = 0.5 * (low + high);
    (above(middle) * first > 0.0 ? low : high) = middle;
  }
  double sum = 0.0;
  double moment = 0.0;
  for (int x = 0; x < DrawingWidth; ++x)
  {
    const double shade = picture->GetScalarComponentAsDouble(x, row, 0, 0);
    sum += shade;
    moment += shade * (x + 0.5);
  }
  EXPECT_GT(sum, 200.0);
  return std::abs(moment / sum - low);
}

inline void ExpectAgreement(Globe& globe, int hits, double tolerance = terrain::kGlobeDrawnError)
{
  const Agreement result = globe.Compare(tolerance);
  EXPECT_GE(result.Hits, hits);
  EXPECT_EQ(result.Disagreements, 0);
  EXPECT_EQ(result.Off, 0) << "the largest difference is " << result.Largest;
}
}

#endif
