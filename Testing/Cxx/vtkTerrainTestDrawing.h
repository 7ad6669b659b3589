// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A terrain drawn by the mapper, the rays of its pixels, and its distances against the reference:
 * for tests that draw small pictures.
 */
#ifndef vtkTerrainTestDrawing_h
#define vtkTerrainTestDrawing_h

#include "vtkTerrainTesting.h"

#include "core/rays/PixelRays.h"
#include "core/rays/ReferenceRayCaster.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vtkTerrainTesting
{
constexpr int DrawingWidth = 80;
constexpr int DrawingHeight = 60;

/// A terrain in a scene, with the distances that are drawn and the rays they belong to.
class Drawing
{
public:
  explicit Drawing(vtkImageData* heights,
    vtkOpenGLTerrainMapper::Techniques technique = vtkOpenGLTerrainMapper::Techniques::Pyramid)
    : Heights(heights)
    , Scene(MakeScene(DrawingWidth, DrawingHeight))
  {
    this->Mesh->SetInputData(heights);
    this->Mesh->SetCellsPerQuad(8);
    this->Mapper->SetInputConnection(this->Mesh->GetOutputPort());
    this->Mapper->SetHeightsData(heights);
    this->Mapper->SetTechnique(technique);
    this->Actor->SetMapper(this->Mapper);
    this->Scene.Renderer->AddActor(this->Actor);
    this->Camera()->SetViewUp(0.0, 0.0, 1.0);
  }

  void SetHeights(vtkImageData* heights)
  {
    this->Heights = heights;
    this->Mesh->SetInputData(heights);
    this->Mapper->SetHeightsData(heights);
  }

  vtkCamera* Camera()
  {
    return this->Scene.Renderer->GetActiveCamera();
  }

  /// Eye and focal point in cells of the grid and heights.
  void Look(double ei, double ej, double ez, double fi, double fj, double fz)
  {
    const double* origin = this->Heights->GetOrigin();
    const double* spacing = this->Heights->GetSpacing();
    this->Camera()->SetPosition(origin[0] + spacing[0] * ei, origin[1] + spacing[1] * ej, ez);
    this->Camera()->SetFocalPoint(origin[0] + spacing[0] * fi, origin[1] + spacing[1] * fj, fz);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  vtkImageData* Distances()
  {
    this->Scene.Renderer->SetPass(this->Pass);
    this->Scene.Window->Render();
    this->Scene.Renderer->SetPass(nullptr);
    return this->Pass->GetDistances();
  }

  /// The rays from grid coordinates with z in heights, as drawn.
  terrain::PixelRays Rays()
  {
    vtkMatrix4x4* toView = this->Camera()->GetModelViewTransformMatrix();
    vtkMatrix4x4* toDisplay =
      this->Camera()->GetProjectionTransformMatrix(double(DrawingWidth) / DrawingHeight, -1.0, 1.0);
    vtkMatrix4x4* toWorld = this->Actor->GetMatrix();
    const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(this->Heights);
    glm::dmat4 view;
    glm::dmat4 display;
    glm::dmat4 world;
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        view[column][row] = toView->GetElement(row, column);
        display[column][row] = toDisplay->GetElement(row, column);
        world[column][row] = toWorld->GetElement(row, column);
      }
    }
    glm::dmat4 grid(1.0);
    grid[0][0] = geometry.Spacing.x;
    grid[1][1] = geometry.Spacing.y;
    grid[2][2] = this->Mapper->GetVerticalExaggeration();
    grid[3] = glm::dvec4(geometry.Origin, 1.0);
    return terrain::MakePixelRays(
      view * world * grid, display, glm::dvec4(0.0, 0.0, DrawingWidth, DrawingHeight));
  }

  vtkSmartPointer<vtkImageData> Heights;
  struct Scene Scene;
  vtkNew<vtkTerrainCoarseMesh> Mesh;
  vtkNew<vtkOpenGLTerrainMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkTerrainDepthPass> Pass;
};

/// Pixels of which only one picture has a distance, or whose distances differ by more than what
/// float rounds.
inline int CountDifferentDistances(vtkImageData* a, vtkImageData* b)
{
  int different = 0;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    for (int x = 0; x < DrawingWidth; ++x)
    {
      const double first = a->GetScalarComponentAsDouble(x, y, 0, 0);
      const double second = b->GetScalarComponentAsDouble(x, y, 0, 0);
      const bool same =
        std::isnan(first) ? std::isnan(second) : std::abs(first - second) <= 1e-5 * std::abs(first);
      different += same ? 0 : 1;
    }
  }
  return different;
}

/// Distances of a picture against the reference, pixel by pixel.
struct Comparison
{
  int Pixels = 0;
  int Hits = 0;
  /// Pixels of which only one has a hit.
  int Disagreements = 0;
  /// Hits that differ by more than the tolerance over the sine of their angle with the surface.
  int Off = 0;
  /// Disagreements whose ray passes no silhouette within a thousandth of a cell.
  int Unexplained = 0;
  /// Largest relative difference of hits, times that sine.
  double Largest = 0.0;
  /// Largest difference of hits, times that sine, in cells.
  double Farthest = 0.0;
};

/// The same, with the faces that are culled: none, those seen from above, those from below.
enum class Culling
{
  None,
  Front,
  Back
};

/// Sine of the angle between a pixel's ray and the surface that it hits, as seen. On a ray that
/// grazes the surface, what rounding moves it up or down moves the hit by that over the sine.
inline double SineAtHit(
  const terrain::PixelRays& rays, const glm::dvec2& pixel, const terrain::ReferenceHit& hit)
{
  return std::abs(glm::dot(glm::normalize(rays.NormalMatrix * hit.Normal),
    glm::normalize(terrain::AtPixel(rays.DirectionVC, pixel))));
}

/// Compares distances with rays in grid coordinates, z in heights. The tolerance is a part of the
/// distance.
template <typename T>
Comparison CompareRays(const terrain::HeightfieldView<T>& view, const terrain::PixelRays& rays,
  vtkImageData* distances, Culling culling, double tolerance)
{
  const terrain::ReferenceRayCaster<T> caster(
    view, terrain::GridGeometry(), terrain::SMPParallelFor);
  Comparison result;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    for (int x = 0; x < DrawingWidth; ++x)
    {
      terrain::ReferenceRay ray;
      ray.Origin = terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 });
      ray.Direction = terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 });
      ray.Begin = rays.Begin;
      ray.End = rays.Far;
      terrain::ReferenceHit hit = caster.Cast(ray);
      while (hit.Found && culling != Culling::None && (culling == Culling::Front) == hit.FromAbove)
      {
        ray.Begin = hit.Distance + 1e-3 / glm::length(glm::dvec2(ray.Direction));
        hit = caster.Cast(ray);
      }
      const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
      const bool both = hit.Found && !std::isnan(drawn);
      const double distance =
        both ? std::abs(drawn - hit.Distance) * SineAtHit(rays, { x + 0.5, y + 0.5 }, hit) : 0.0;
      const double difference = both ? distance / hit.Distance : 0.0;
      const bool disagrees = hit.Found == std::isnan(drawn);
      ++result.Pixels;
      result.Hits += both ? 1 : 0;
      result.Disagreements += disagrees ? 1 : 0;
      result.Off += difference > tolerance ? 1 : 0;
      result.Unexplained += disagrees && !caster.IsNearSilhouette(ray, 1e-3) ? 1 : 0;
      result.Largest = std::max(result.Largest, difference);
      result.Farthest = std::max(result.Farthest, distance);
    }
  }
  return result;
}

/// Compares what is drawn with rays cast in double precision at the heights of the drawing.
inline Comparison CompareWithReference(Drawing& drawing, Culling culling = Culling::None,
  double tolerance = vtkOpenGLTerrainMapper::HitError)
{
  vtkImageData* distances = drawing.Distances();
  const terrain::PixelRays rays = drawing.Rays();
  Comparison result;
  terrain::ImageHeights::Dispatch(drawing.Heights,
    [&](const auto& view) { result = CompareRays(view, rays, distances, culling, tolerance); });
  return result;
}
}

#endif
