// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the mapper draws against rays cast in double precision: adversarial fields from every side,
// a walk through the box of the terrain, culling, and the other surfaces.
#include "vtkTerrainTestDrawing.h"

#include "../Unit/UnitTestFields.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

namespace
{
using vtkTerrainTesting::CompareWithReference;
using vtkTerrainTesting::Comparison;
using vtkTerrainTesting::Culling;
using vtkTerrainTesting::Drawing;

vtkSmartPointer<vtkImageData> ToImage(const terrain::TestField& field)
{
  vtkNew<vtkDoubleArray> heights;
  for (const double height : field.Samples)
  {
    heights->InsertNextValue(height);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(field.Width, field.Height, 1);
  image->SetSpacing(10.0, 12.0, 1.0);
  image->GetPointData()->SetScalars(heights);
  return image;
}

/// How high a field of some samples is drawn.
double HeightOf(int columns, int rows)
{
  return 2.5 * std::max(columns, rows);
}

/// Eye and focal point as parts of the box of the terrain, in height of heightOf() at least.
struct Place
{
  const char* Name;
  std::array<double, 3> Eye;
  std::array<double, 3> Focus;
  bool Parallel;
};

constexpr std::array<Place, 6> Places{
  { { "oblique", { -0.4, -0.9, 4.0 }, { 0.5, 0.5, 0.5 }, false },
    { "from the side", { 1.8, 0.3, 0.8 }, { 0.4, 0.5, 0.5 }, false },
    { "straight down", { 0.5, 0.52, 9.0 }, { 0.5, 0.5, 0.0 }, false },
    { "from within", { 0.2, 0.15, 0.9 }, { 0.8, 0.9, 0.2 }, false },
    { "from below", { 0.3, -0.2, -5.0 }, { 0.5, 0.5, 0.5 }, false },
    { "parallel", { 0.5, -0.9, 5.0 }, { 0.5, 0.5, 0.5 }, true } }
};

void Look(Drawing& drawing, const Place& place)
{
  const int* size = drawing.Heights->GetDimensions();
  double range[2];
  drawing.Mapper->GetHeightRange(range);
  const double factor = drawing.Mapper->GetVerticalExaggeration();
  const double rise = std::max(factor * (range[1] - range[0]), HeightOf(size[0], size[1]));
  const auto height = [&](double part) { return factor * range[0] + part * rise; };
  drawing.Camera()->SetParallelProjection(place.Parallel);
  drawing.Camera()->SetParallelScale(4.0 * std::max(size[0], size[1]));
  drawing.Look(place.Eye[0] * (size[0] - 1), place.Eye[1] * (size[1] - 1), height(place.Eye[2]),
    place.Focus[0] * (size[0] - 1), place.Focus[1] * (size[1] - 1), height(place.Focus[2]));
}

void Add(Comparison& sum, const Comparison& other)
{
  sum.Pixels += other.Pixels;
  sum.Hits += other.Hits;
  sum.Disagreements += other.Disagreements;
  sum.Off += other.Off;
  sum.Unexplained += other.Unexplained;
  sum.Largest = std::max(sum.Largest, other.Largest);
}

terrain::TestField RollingHills(int width, int height)
{
  return { "hills", width, height, [](int i, int j) {
            return 100.0 + 60.0 * std::sin(0.21 * i) * std::cos(0.17 * j) +
              3.0 * ((i * 7 + j * 13) % 5);
          } };
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperExact, DrawsAdversarialFields)
{
  Drawing drawing(ToImage(terrain::AdversarialFields()[0]));
  Comparison sum;
  for (const terrain::TestField& field : terrain::AdversarialFields())
  {
    SCOPED_TRACE(field.Name);
    drawing.SetHeights(ToImage(field));
    double range[2];
    drawing.Mapper->GetHeightRange(range);
    const double relief = range[1] - range[0];
    drawing.Mapper->SetVerticalExaggeration(
      relief > 0.0 ? HeightOf(field.Width, field.Height) / relief : 1.0);
    int hits = 0;
    for (const Place& place : Places)
    {
      SCOPED_TRACE(place.Name);
      Look(drawing, place);
      const Comparison comparison = CompareWithReference(drawing);
      EXPECT_EQ(comparison.Unexplained, 0);
      hits += comparison.Hits;
      Add(sum, comparison);
    }
    EXPECT_GT(hits, 1000);
  }
  EXPECT_LE(sum.Disagreements, sum.Pixels / 10000);
  EXPECT_EQ(sum.Off, 0);
  std::cout << sum.Pixels << " pixels, " << sum.Hits << " hits, " << sum.Disagreements
            << " disagree, " << sum.Off << " off, largest " << sum.Largest << "\n";
}

// From above through the box's boundary, between hull and surface, to the side and under the
// terrain. A pop would be a step whose pictures before and after agree with the reference, but this
// one does not.
TEST(OpenGLTerrainMapperExact, WalksThroughTheTerrain)
{
  Drawing drawing(ToImage(RollingHills(41, 33)));
  constexpr int Steps = 500;
  Comparison sum;
  int within = 0;
  for (int step = 0; step < Steps; ++step)
  {
    SCOPED_TRACE(step);
    const double t = step / (Steps - 1.0);
    const double i = -6.0 + 50.0 * t;
    const double j = 4.0 + 24.0 * t + 3.0 * std::sin(20.0 * t);
    const double z = 260.0 - 330.0 * t + 10.0 * std::cos(31.0 * t);
    drawing.Look(i, j, z, i + 8.0 * std::cos(5.0 * t), j + 8.0 * std::sin(5.0 * t), z - 20.0);
    const Comparison comparison = CompareWithReference(drawing);
    EXPECT_EQ(comparison.Unexplained, 0);
    within += i > 0.0 && i < 40.0 && z > 30.0 && z < 180.0 ? 1 : 0;
    Add(sum, comparison);
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(sum.Hits, sum.Pixels / 3);
  EXPECT_LE(sum.Disagreements, sum.Pixels / 10000);
  EXPECT_EQ(sum.Off, 0);
  std::cout << sum.Pixels << " pixels, " << sum.Hits << " hits, " << sum.Disagreements
            << " disagree, " << sum.Off << " off, largest " << sum.Largest << "\n";
}

TEST(OpenGLTerrainMapperExact, DrawsTheGroundBeforeTheNearPlane)
{
  using Techniques = vtkOpenGLTerrainMapper::Techniques;
  Drawing drawing(ToImage(RollingHills(41, 33)));
  for (const Techniques technique : { Techniques::Pyramid, Techniques::Equidistant })
  {
    drawing.Mapper->SetTechnique(technique);
    // half a metre above the ground, closer to it than VTK puts the near plane
    const double ground = drawing.Heights->GetScalarComponentAsDouble(20, 16, 0, 0);
    drawing.Camera()->SetViewAngle(90.0);
    drawing.Look(20.0, 16.0, ground + 0.5, 20.1, 16.0, ground - 30.0);
    drawing.Camera()->SetClippingRange(5.0, 1000.0);
    vtkImageData* distances = drawing.Distances();
    int before = 0;
    for (vtkIdType i = 0; i < distances->GetNumberOfPoints(); ++i)
    {
      before += distances->GetPointData()->GetScalars()->GetTuple1(i) < 5.0 ? 1 : 0;
    }
    EXPECT_GT(before, 2000);
    const bool exact = technique == Techniques::Pyramid;
    const Comparison comparison = CompareWithReference(drawing);
    EXPECT_EQ(comparison.Unexplained, 0);
    EXPECT_TRUE(!exact || comparison.Off == 0) << comparison.Largest;
    EXPECT_LE(comparison.Farthest, vtkOpenGLTerrainMapper::EquidistantError);
    EXPECT_GE(comparison.Hits, before);
    // in the window, too
    drawing.Scene.Window->Render();
    const std::vector<float> depths = vtkTerrainTesting::ReadDepth(drawing.Scene.Window);
    EXPECT_GT(std::count(depths.begin(), depths.end(), 0.0f), 2000);
    EXPECT_EQ(std::count(depths.begin(), depths.end(), 1.0f),
      static_cast<int>(depths.size()) - comparison.Hits);
  }
}

TEST(OpenGLTerrainMapperExact, PassesByCulledFaces)
{
  Drawing drawing(ToImage(RollingHills(41, 33)));
  vtkProperty* property = drawing.Actor->GetProperty();
  for (const Place& place : Places)
  {
    SCOPED_TRACE(place.Name);
    Look(drawing, place);
    for (const Culling culling : { Culling::Front, Culling::Back })
    {
      property->SetFrontfaceCulling(culling == Culling::Front);
      property->SetBackfaceCulling(culling == Culling::Back);
      // Behind a culled hit rays go on after a hundredth of a cell: what lies nearer is lost.
      const Comparison comparison = CompareWithReference(drawing, culling);
      EXPECT_LE(comparison.Disagreements + comparison.Off, comparison.Pixels / 500);
    }
  }
}

namespace
{
/// The codes of the heights of a drawing, and their pyramid, in memory.
struct Twin
{
  terrain::TestField Field;
  terrain::CodedField<float> Coded;

  explicit Twin(terrain::TestField field)
    : Field(std::move(field))
    , Coded(this->Field)
  {
    this->Coded.Coded.start = 5;
  }

  /// Distance of a pixel's hit; NaN for none.
  double Distance(const terrain::PixelRays& rays, int x, int y) const
  {
    // Codes are heights less the lowest.
    terrain::PixelRays coded = rays;
    coded.OriginGC[0].z -= this->Coded.Codes.Offset;
    const terrain::TerrainHit hit = this->Coded.Coded.TracePyramid(
      terrain::PixelRay(coded, { x + 0.5, y + 0.5 }, rays.Near, rays.Far));
    return hit.found ? rays.Near + static_cast<double>(hit.s)
                     : std::numeric_limits<double>::quiet_NaN();
  }
};
}

TEST(OpenGLTerrainMapperExact, DrawsColumns)
{
  const terrain::TestField field = RollingHills(41, 33);
  Drawing drawing(ToImage(field));
  Twin twin(field);
  twin.Coded.Coded.columns = true;
  drawing.Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  for (const Place& place : Places)
  {
    SCOPED_TRACE(place.Name);
    Look(drawing, place);
    vtkImageData* distances = drawing.Distances();
    const terrain::PixelRays rays = drawing.Rays();
    int different = 0;
    int hits = 0;
    for (int y = 0; y < vtkTerrainTesting::DrawingHeight; ++y)
    {
      for (int x = 0; x < vtkTerrainTesting::DrawingWidth; ++x)
      {
        const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
        const double truth = twin.Distance(rays, x, y);
        // The twin rounds, too.
        const double allowed = 2.0 * vtkOpenGLTerrainMapper::HitError * truth;
        const bool same =
          std::isnan(truth) ? std::isnan(drawn) : std::abs(drawn - truth) <= allowed;
        different += same ? 0 : 1;
        hits += std::isnan(truth) ? 0 : 1;
      }
    }
    EXPECT_GT(hits, 400);
    EXPECT_LE(different, 3); // rays along walls
  }
}

// Columns are lit by their own faces: their tops are as bright as flat ground.
TEST(OpenGLTerrainMapperExact, LightsTheFacesOfColumns)
{
  Drawing drawing(ToImage(RollingHills(41, 33)));
  drawing.Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  drawing.Look(20.0, 16.1, 900.0, 20.0, 16.0, 100.0); // from above: tops, lit by the headlight
  const auto picture = vtkTerrainTesting::Render(drawing.Scene.Window);
  const auto* middle = static_cast<unsigned char*>(picture->GetScalarPointer(40, 30, 0));
  EXPECT_GT(int{ middle[0] }, 250);
  drawing.Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Bilinear);
  const auto patches = vtkTerrainTesting::Render(drawing.Scene.Window);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(picture, patches, 20), 500);
}

// With a tolerance the surface is off by less than so many pixels, and never later on a ray.
TEST(OpenGLTerrainMapperExact, StaysWithinThePixelTolerance)
{
  Drawing drawing(ToImage(RollingHills(401, 333)));
  drawing.Look(200.0, -150.0, 2500.0, 200.0, 160.0, 100.0);
  vtkNew<vtkImageData> exact;
  exact->DeepCopy(drawing.Distances());
  const terrain::PixelRays rays = drawing.Rays();
  double before = 0.0;
  for (const double tolerance : { 0.25, 1.0, 4.0 })
  {
    SCOPED_TRACE(tolerance);
    drawing.Mapper->SetPixelTolerance(tolerance);
    vtkImageData* distances = drawing.Distances();
    std::vector<double> errors; // along the ray, in pixels
    for (int y = 0; y < vtkTerrainTesting::DrawingHeight; ++y)
    {
      for (int x = 0; x < vtkTerrainTesting::DrawingWidth; ++x)
      {
        const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
        const double truth = exact->GetScalarComponentAsDouble(x, y, 0, 0);
        if (!std::isnan(truth))
        {
          ASSERT_LE(drawn, truth * (1.0 + 2.0 * vtkOpenGLTerrainMapper::HitError));
          const double pixel = drawn * glm::length(rays.DirectionVC[1]);
          const double along =
            glm::length(terrain::AtPixel(rays.DirectionVC, { x + 0.5, y + 0.5 }));
          errors.push_back((truth - drawn) * along / pixel);
        }
      }
    }
    std::sort(errors.begin(), errors.end());
    const double median = errors[errors.size() / 2];
    std::cout << "tolerance " << tolerance << ": median " << median << ", 95 % within "
              << errors[errors.size() * 95 / 100] << ", largest " << errors.back()
              << " pixels along the ray\n";
    EXPECT_LE(
      median, tolerance); // where rays pass by the surface in a box, what lies behind counts
    EXPECT_GE(median, before);
    before = median;
  }
  EXPECT_GT(before, 0.5);

  // No speck of the underside at the border, over which the eye looks from outside, down on slopes
  // that fall less than the rays.
  drawing.Mapper->SetVerticalExaggeration(0.02);
  drawing.Look(-60.0, -60.0, 250.0, 200.0, 160.0, 0.0);
  drawing.Mapper->SetPixelTolerance(8.0);
  vtkNew<vtkImageData> both;
  both->DeepCopy(drawing.Distances());
  drawing.Actor->GetProperty()->BackfaceCullingOn();
  EXPECT_EQ(vtkTerrainTesting::CountDifferentDistances(both, drawing.Distances()), 0);
  drawing.Actor->GetProperty()->BackfaceCullingOff();
  drawing.Mapper->SetVerticalExaggeration(1.0);

  drawing.Look(200.0, -150.0, 2500.0, 200.0, 160.0, 100.0);
  drawing.Mapper->SetPixelTolerance(0.0);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentDistances(exact, drawing.Distances()), 0);
}

namespace
{
vtkSmartPointer<vtkImageData> ShortHills(int width, int height)
{
  vtkNew<vtkShortArray> heights;
  for (const double value : RollingHills(width, height).Samples)
  {
    heights->InsertNextValue(static_cast<short>(value));
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->SetSpacing(10.0, 12.0, 1.0);
  image->GetPointData()->SetScalars(heights);
  return image;
}

/// Lays a hill of a height onto some samples.
void Raise(vtkImageData* image, int x0, int x1, int y0, int y1, double height)
{
  for (int y = y0; y <= y1; ++y)
  {
    for (int x = x0; x <= x1; ++x)
    {
      image->SetScalarComponentFromDouble(x, y, 0, 0, height);
    }
  }
  image->Modified();
}
}

TEST(OpenGLTerrainMapperExact, BringsChangedPartsUpToDate)
{
  for (const bool integer : { true, false })
  {
    SCOPED_TRACE(integer);
    const auto image = integer ? ShortHills(101, 83) : ToImage(RollingHills(101, 83));
    Drawing drawing(image);
    Look(drawing, Places[0]);
    drawing.Distances();
    const vtkIdType all = drawing.Mapper->GetNumberOfUploadedTexels();
    EXPECT_GE(all, 101 * 83 + 50 * 41);

    Raise(image, 30, 37, 20, 25, 160.0);
    drawing.Mapper->HeightsModified(30, 37, 20, 25);
    Raise(image, 100, 100, 82, 82, 42.0); // a corner
    drawing.Mapper->HeightsModified(100, 100, 82, 82);
    vtkNew<vtkImageData> part;
    part->DeepCopy(drawing.Distances());
    const auto partPicture = vtkTerrainTesting::Render(drawing.Scene.Window);
    EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 1);
    // 8 x 6 samples, 5 x 4 nodes above them, 3 x 2, ...; and one of each level
    EXPECT_LE(drawing.Mapper->GetNumberOfUploadedTexels() - all, 48 + 2 * 20 + 10 + 1 + 7);
    EXPECT_EQ(CompareWithReference(drawing).Unexplained, 0);

    Drawing whole(image);
    Look(whole, Places[0]);
    EXPECT_EQ(vtkTerrainTesting::CountDifferentDistances(part, whole.Distances()), 0);
    const auto wholePicture = vtkTerrainTesting::Render(whole.Scene.Window);
    EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(partPicture, wholePicture), 0);
  }
}

TEST(OpenGLTerrainMapperExact, TakesAllHeightsWhereAPartLeavesTheirRange)
{
  const auto image = ShortHills(101, 83);
  Drawing drawing(image);
  Look(drawing, Places[0]);
  drawing.Distances();
  Raise(image, 50, 52, 40, 42, 900.0);
  drawing.Mapper->HeightsModified(50, 52, 40, 42);
  Look(drawing, Places[0]);
  EXPECT_EQ(CompareWithReference(drawing).Unexplained, 0);
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 2);
  EXPECT_DOUBLE_EQ(drawing.Mapper->GetBounds()[5], 900.0);
  // nothing said: all of them as well
  Raise(image, 10, 12, 40, 42, 100.0);
  drawing.Distances();
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), 3);
  // beside the heights: nothing at all
  const vtkIdType texels = drawing.Mapper->GetNumberOfUploadedTexels();
  drawing.Mapper->HeightsModified(200, 300, -5, -2);
  drawing.Distances();
  EXPECT_EQ(drawing.Mapper->GetNumberOfUploadedTexels(), texels);
}
