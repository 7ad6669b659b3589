// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mapper against the definition of the surface: every distance that it draws must lie on the
// bilinear surface, and no point of the surface may lie before it on the ray.
#include "vtkTerrainTestDrawing.h"

#include "core/rays/PixelRays.h"
#include "data/ImageHeights.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;
using vtkTerrainTesting::CountDifferentDistances;
using vtkTerrainTesting::Drawing;

constexpr int Columns = 41;
constexpr int Rows = 33;
constexpr int PixelsX = vtkTerrainTesting::DrawingWidth;
constexpr int PixelsY = vtkTerrainTesting::DrawingHeight;

vtkSmartPointer<vtkImageData> Hills(double originX, double originY, bool withHole)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetNumberOfValues(vtkIdType{ Columns } * Rows);
  for (int j = 0; j < Rows; ++j)
  {
    for (int i = 0; i < Columns; ++i)
    {
      const double roughness = (i * 7 + j * 13) % 5;
      const bool hole = withHole && std::abs(i - 20) < 4 && std::abs(j - 14) < 4;
      heights->SetValue(i + Columns * j,
        hole ? std::numeric_limits<double>::quiet_NaN()
             : 100.0 + 40.0 * std::sin(0.4 * i) * std::cos(0.35 * j) + 4.0 * roughness);
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, 1);
  image->SetOrigin(originX, originY, 0.0);
  image->SetSpacing(10.0, 12.0, 1.0);
  image->GetPointData()->SetScalars(heights);
  return image;
}

/// Ray height minus surface height at a grid position; NaN where there is no surface.
double Above(const terrain::HeightfieldView<double>& view, const glm::dvec3& p)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  if (!(p.x >= 0.0 && p.y >= 0.0 && p.x <= view.Width - 1.0 && p.y <= view.Height - 1.0))
  {
    return nothing;
  }
  const auto i = std::min<std::int64_t>(static_cast<std::int64_t>(p.x), view.Width - 2);
  const auto j = std::min<std::int64_t>(static_cast<std::int64_t>(p.y), view.Height - 2);
  const double u = p.x - i;
  const double v = p.y - j;
  return p.z -
    ((1.0 - v) * ((1.0 - u) * view.At(i, j) + u * view.At(i + 1, j)) +
      v * ((1.0 - u) * view.At(i, j + 1) + u * view.At(i + 1, j + 1)));
}

/// The sides of the surface that are drawn.
enum class Sides
{
  Both,
  Top
};

/// Distance at which a ray, sampled finely, first passes through such a side of the surface; NaN if
/// it does not.
double SampledDistance(const terrain::HeightfieldView<double>& view, const terrain::PixelRays& rays,
  const glm::dvec2& pixel, double end, Sides sides)
{
  const glm::dvec3 origin = terrain::AtPixel(rays.OriginGC, pixel);
  const glm::dvec3 direction = terrain::AtPixel(rays.DirectionGC, pixel);
  const double step = 0.01 / std::max(glm::length(glm::dvec2(direction)), 1e-3);
  double before = std::numeric_limits<double>::quiet_NaN();
  for (double s = rays.Near; s < end; s += step)
  {
    const double now = Above(view, origin + s * direction);
    if (before * now <= 0.0 && (sides == Sides::Both || now < before))
    {
      return s - step * now / (now - before);
    }
    before = now;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Pixels that differ from the sampled surface by more than a thousandth of the distance.
int CountWrong(Drawing& drawing, Sides sides = Sides::Both)
{
  vtkImageData* distances = drawing.Distances();
  const auto view = terrain::ImageHeights::View<double>(drawing.Heights);
  const terrain::PixelRays rays = drawing.Rays();
  const double end = std::min(rays.Far, rays.Near + 2000.0);
  int wrong = 0;
  for (int y = 0; y < PixelsY; ++y)
  {
    for (int x = 0; x < PixelsX; ++x)
    {
      const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
      const double truth = SampledDistance(view, rays, { x + 0.5, y + 0.5 }, end, sides);
      const bool same =
        std::isnan(truth) ? std::isnan(drawn) : std::abs(drawn - truth) <= 1e-3 * truth;
      wrong += same ? 0 : 1;
    }
  }
  return wrong;
}

/// Sampling at a hundredth of a cell misses the tips of silhouettes: so many of the 4,800 pixels
/// may differ.
constexpr int SamplingMisses = 8;
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapper, DrawsTheSurfaceFromOutside)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, DrawsTheSurfaceFromTheSide)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(-30.0, 10.0, 90.0, 20.0, 16.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, DrawsTheSurfaceFromWithinTheBox)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(5.0, 5.0, 150.0, 30.0, 20.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, DrawsWithEqualSteps)
{
  // steps of half a cell may pass a narrow ridge: one pixel in a hundred
  Drawing drawing(Hills(0.0, 0.0, true), Techniques::Equidistant);
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), PixelsX * PixelsY / 100);
}

TEST(OpenGLTerrainMapper, DrawsTheSameThroughAComputeShader)
{
  using Modes = vtkOpenGLTerrainMapper::ComputeModes;
  Drawing drawing(Hills(500000.0, 5000000.0, true));
  drawing.Mapper->SetComputeMode(Modes::On);
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
  const auto computed = vtkTerrainTesting::Render(drawing.Scene.Window);
  drawing.Mapper->SetComputeMode(Modes::Off);
  const auto fragments = vtkTerrainTesting::Render(drawing.Scene.Window);
  EXPECT_LE(vtkTerrainTesting::CountDifferentPixels(computed, fragments, 2), 2);
  drawing.Mapper->SetComputeMode(Modes::On);
  drawing.Look(5.0, 5.0, 150.0, 30.0, 20.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, DrawsTheSameWithAndWithoutBeams)
{
  Drawing drawing(Hills(500000.0, 5000000.0, true));
  vtkNew<vtkPlane> plane; // keeps the north
  plane->SetOrigin(500000.0, 5000000.0 + 100.0, 0.0);
  plane->SetNormal(0.0, 1.0, 0.0);
  const auto compare = [&drawing](const char* view)
  {
    SCOPED_TRACE(view);
    drawing.Mapper->SetUseBeams(true);
    vtkNew<vtkImageData> with;
    with->DeepCopy(drawing.Distances());
    drawing.Mapper->SetUseBeams(false);
    EXPECT_EQ(CountDifferentDistances(with, drawing.Distances()), 0);
  };
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  compare("outside");
  drawing.Mapper->AddClippingPlane(plane);
  compare("clipped");
  drawing.Actor->GetProperty()->BackfaceCullingOn();
  compare("clipped and culled");
  drawing.Mapper->RemoveAllClippingPlanes();
  drawing.Look(5.0, 5.0, 150.0, 30.0, 20.0, 100.0);
  compare("within");
  drawing.Actor->GetProperty()->BackfaceCullingOff();
  drawing.Look(20.5, 16.5, 80.0, 30.0, 20.0, 90.0);
  compare("below");
  drawing.Camera()->ParallelProjectionOn();
  drawing.Camera()->SetParallelScale(150.0);
  compare("parallel");
}

TEST(OpenGLTerrainMapper, DrawsTheUnderside)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -10.0, -200.0, 20.0, 16.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
  drawing.Look(20.5, 16.5, 80.0, 30.0, 20.0, 90.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, DrawsInParallelProjection)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Camera()->ParallelProjectionOn();
  drawing.Camera()->SetParallelScale(150.0);
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, LeavesHolesWhereThereAreNoData)
{
  Drawing drawing(Hills(0.0, 0.0, true));
  drawing.Look(20.0, -10.0, 500.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, IsExactAtLargeCoordinates)
{
  Drawing drawing(Hills(500000.0, 5000000.0, false));
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, FollowsTheActor)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Actor->SetOrientation(10.0, 5.0, 30.0);
  drawing.Actor->SetScale(1.0, 0.8, -1.2);
  drawing.Actor->SetPosition(20.0, 10.0, 150.0);
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
}

TEST(OpenGLTerrainMapper, ExaggeratesWithoutUploads)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
  const double before = drawing.Mapper->GetBounds()[5];
  drawing.Mapper->SetVerticalExaggeration(2.0);
  drawing.Scene.Renderer->ResetCameraClippingRange();
  EXPECT_LE(CountWrong(drawing), SamplingMisses);
  EXPECT_DOUBLE_EQ(drawing.Mapper->GetBounds()[5], 2.0 * before);
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 1);
}

TEST(OpenGLTerrainMapper, ShowsWhatLiesBehindAClippingPlane)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  vtkNew<vtkPlane> plane; // keeps the north
  plane->SetOrigin(0.0, 200.0, 0.0);
  plane->SetNormal(0.0, 1.0, 0.0);
  drawing.Mapper->AddClippingPlane(plane);
  vtkImageData* distances = drawing.Distances();
  const terrain::PixelRays rays = drawing.Rays();
  int drawn = 0;
  for (int y = 0; y < PixelsY; ++y)
  {
    for (int x = 0; x < PixelsX; ++x)
    {
      const double s = distances->GetScalarComponentAsDouble(x, y, 0, 0);
      if (!std::isnan(s))
      {
        const glm::dvec2 pixel(x + 0.5, y + 0.5);
        const double j = terrain::AtPixel(rays.OriginGC, pixel).y +
          s * terrain::AtPixel(rays.DirectionGC, pixel).y;
        EXPECT_GE(12.0 * j, 200.0 - 1e-2);
        ++drawn;
      }
    }
  }
  EXPECT_GT(drawn, 500);
}

TEST(OpenGLTerrainMapper, CullsFacesOfTheSurface)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -10.0, -200.0, 20.0, 16.0, 100.0); // from below
  drawing.Actor->GetProperty()->BackfaceCullingOn();
  EXPECT_LE(CountWrong(drawing, Sides::Top), SamplingMisses);
  vtkDataArray* distances = drawing.Distances()->GetPointData()->GetScalars();
  int drawn = 0;
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    drawn += std::isnan(distances->GetComponent(i, 0)) ? 0 : 1;
  }
  EXPECT_GT(drawn, 2 * SamplingMisses); // tops of hills behind the undersides that are passed by
  EXPECT_LT(drawn, PixelsX * PixelsY / 10);
}

TEST(OpenGLTerrainMapper, UploadsHeightsOncePerChange)
{
  Drawing drawing(Hills(0.0, 0.0, false));
  drawing.Look(20.0, -30.0, 400.0, 20.0, 14.0, 100.0);
  drawing.Scene.Window->Render();
  drawing.Camera()->Azimuth(10.0);
  drawing.Scene.Window->Render();
  drawing.Actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  drawing.Mapper->SetTechnique(Techniques::Mesh);
  drawing.Scene.Window->Render();
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 1);
  drawing.Heights->Modified();
  drawing.Scene.Window->Render();
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 2);
}

TEST(OpenGLTerrainMapper, HasTheBoundsOfTheHeights)
{
  Drawing drawing(Hills(1000.0, 2000.0, true));
  double bounds[6];
  drawing.Mapper->GetBounds(bounds);
  double range[2] = { 1e300, -1e300 };
  const auto view = terrain::ImageHeights::View<double>(drawing.Heights);
  for (int index = 0; index < Columns * Rows; ++index)
  {
    if (view.IsValid(index))
    {
      range[0] = std::min(range[0], view.Samples[index]);
      range[1] = std::max(range[1], view.Samples[index]);
    }
  }
  EXPECT_DOUBLE_EQ(bounds[0], 1000.0);
  EXPECT_DOUBLE_EQ(bounds[3], 2000.0 + 12.0 * (Rows - 1));
  EXPECT_DOUBLE_EQ(bounds[4], range[0]);
  EXPECT_DOUBLE_EQ(bounds[5], range[1]);
}

TEST(OpenGLTerrainMapper, DrawsNothingWhereThereIsNoSurface)
{
  for (const glm::ivec2 size : { glm::ivec2(1, 1), glm::ivec2(1, 5), glm::ivec2(5, 1) })
  {
    vtkNew<vtkShortArray> heights;
    heights->SetNumberOfValues(vtkIdType{ size.x } * size.y);
    heights->FillValue(7);
    vtkNew<vtkImageData> image;
    image->SetDimensions(size.x, size.y, 1);
    image->GetPointData()->SetScalars(heights);
    Drawing drawing(image);
    drawing.Look(0.0, -5.0, 20.0, 0.0, 0.0, 7.0);
    vtkImageData* distances = drawing.Distances();
    for (int y = 0; y < PixelsY; ++y)
    {
      for (int x = 0; x < PixelsX; ++x)
      {
        ASSERT_TRUE(std::isnan(distances->GetScalarComponentAsDouble(x, y, 0, 0)));
      }
    }
  }
}
