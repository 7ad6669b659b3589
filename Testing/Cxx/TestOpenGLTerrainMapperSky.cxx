// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light of an evenly bright sky, judged pixel by pixel by the horizons of vtkTerrainHorizon.
#include "vtkTerrainTestSunlit.h"
#include "vtkTerrainTestingScene.h"

#include "core/rays/RayQuery.h"
#include "vtkTerrainHorizon.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using vtkTerrainTesting::DrawingHeight;
using vtkTerrainTesting::DrawingWidth;
using vtkTerrainTesting::LookOver;
using vtkTerrainTesting::Sunlit;
using vtkTerrainTesting::SurfaceOf;

/// A point array of an image between its samples.
double ValueAt(vtkImageData* image, const char* name, double x, double y)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  const int* size = image->GetDimensions();
  const int i = std::clamp(static_cast<int>(x), 0, size[0] - 2);
  const int j = std::clamp(static_cast<int>(y), 0, size[1] - 2);
  double value = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double share =
      (corner % 2 == 1 ? x - i : 1.0 - (x - i)) * (corner / 2 == 1 ? y - j : 1.0 - (y - j));
    const vtkIdType sample = i + corner % 2 + vtkIdType{ size[0] } * (j + corner / 2);
    value += share * array->GetComponent(sample, 0);
  }
  return value;
}
}

// The light of the sky is the sky view factor of vtkTerrainHorizon.
TEST(OpenGLTerrainMapperSky, IsTheShareOfTheSkyThatIsSeen)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  hills.Mapper->SetVerticalExaggeration(3.0);
  hills.Look(20.0, -20.0, 600.0, 20.0, 16.0, 250.0);
  hills.Sun->SetIntensity(0.0);
  hills.Actor->GetProperty()->SetDiffuse(0.9);
  hills.Mapper->SetSkyLight(0.8);
  vtkNew<vtkImageData> drawn; // of the heights as drawn
  drawn->DeepCopy(hills.Heights);
  vtkDataArray* heights = drawn->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < heights->GetNumberOfTuples(); ++k)
  {
    heights->SetComponent(k, 0, 3.0 * heights->GetComponent(k, 0));
  }
  vtkNew<vtkTerrainHorizon> horizon;
  horizon->SetInputData(drawn);
  horizon->Update();
  const auto picture = vtkTerrainTesting::Render(hills.Scene.Window);
  const terrain::RayQuery query(SurfaceOf(hills));
  const terrain::PixelRays rays = hills.Rays();
  const glm::dvec3 scale(10.0, 12.0, 3.0);
  int pixels = 0;
  int wrong = 0;
  double darkest = 1.0;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    for (int x = 0; x < DrawingWidth; ++x)
    {
      terrain::QueryRay ray;
      ray.Origin = scale * terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 });
      ray.Direction = scale * terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 });
      const terrain::SurfaceHit hit = query.First(ray);
      if (hit.Found && hit.FromAbove)
      {
        const glm::dvec2 at = glm::dvec2(hit.Cell) + hit.Fraction;
        const double share = ValueAt(horizon->GetOutput(), "SkyView", at.x, at.y);
        const double expected = 255.0 * 0.8 * 0.9 * share;
        ++pixels;
        wrong += std::abs(picture->GetScalarComponentAsDouble(x, y, 0, 0) - expected) > 1.6 ? 1 : 0;
        darkest = std::min(darkest, share);
      }
    }
  }
  EXPECT_GT(pixels, 1000);
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(darkest, 0.7);
}

TEST(OpenGLTerrainMapperSky, IsAddedToEveryMaterial)
{
  Sunlit hills(vtkTerrainTesting::MakeHills(true));
  LookOver(hills);
  hills.Shine(135.0, 30.0);
  for (const int interpolation : { VTK_GOURAUD, VTK_PBR })
  {
    hills.Actor->GetProperty()->SetInterpolation(interpolation);
    hills.Mapper->SetSkyLight(0.0);
    const auto without = vtkTerrainTesting::Render(hills.Scene.Window);
    hills.Mapper->SetSkyLight(0.4);
    const auto with = vtkTerrainTesting::Render(hills.Scene.Window);
    int brighter = 0;
    int darker = 0;
    for (vtkIdType k = 0; k < with->GetNumberOfPoints(); ++k)
    {
      const double change = with->GetPointData()->GetScalars()->GetComponent(k, 0) -
        without->GetPointData()->GetScalars()->GetComponent(k, 0);
      brighter += change > 8.0 ? 1 : 0;
      darker += change < 0.0 ? 1 : 0;
    }
    EXPECT_GT(brighter, 1000) << interpolation;
    EXPECT_EQ(darker, 0) << interpolation;
  }
}
