// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour lines: where they are, and what becomes of those that crowd.
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTerrainPicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using vtkTerrainTesting::CountPixels;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

/// Puts heights higher, in double.
vtkSmartPointer<vtkImageData> Raise(vtkImageData* heights, double by)
{
  vtkNew<vtkDoubleArray> raised;
  raised->DeepCopy(heights->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < raised->GetNumberOfTuples(); ++i)
  {
    raised->SetValue(i, raised->GetValue(i) + by);
  }
  vtkNew<vtkImageData> image;
  image->CopyStructure(heights);
  image->GetPointData()->SetScalars(raised);
  return image;
}
}

class OpenGLTerrainMapperLevels : public testing::TestWithParam<double>
{
};

// Float tells heights of the second level 8 apart.
TEST_P(OpenGLTerrainMapperLevels, LieAtTheirHeights)
{
  const double level = this->GetParam();
  constexpr double interval = 12.5;
  constexpr double width = 2.0;
  vtkNew<vtkTerrainPicker> picker;
  int compared = 0;
  TerrainScene scene(Techniques::Pyramid);
  const TerrainProp terrain = scene.AddTerrain(Raise(MakeHills(), level));
  terrain.Actor->GetProperty()->LightingOff();
  terrain.Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  terrain.Mapper->SetContours(true);
  terrain.Mapper->SetContourInterval(interval);
  terrain.Mapper->SetContourWidth(width);
  scene.Look({ 200.0, 500.0, level + 600.0 }, { 200.0, 190.0, level + 80.0 });
  const auto picture = vtkTerrainTesting::Render(scene.Window);
  auto height = [&](int x, int y)
  {
    picker->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer);
    return picker->GetHeight(); // NaN beside the terrain
  };
  for (int y = 3; y < 147; y += 3)
  {
    for (int x = 3; x < 197; x += 3)
    {
      // slopes change within a pixel: the line's is between those to the neighbours
      const double here = height(x, y);
      const auto [flatX, steepX] =
        std::minmax({ std::abs(height(x + 1, y) - here), std::abs(here - height(x - 1, y)) });
      const auto [flatY, steepY] =
        std::minmax({ std::abs(height(x, y + 1) - here), std::abs(here - height(x, y - 1)) });
      const double flat = std::hypot(flatX, flatY);
      const double steep = std::hypot(steepX, steepY);
      const double off = std::abs(here - interval * std::round(here / interval));
      if (std::isfinite(flat + steep) && flat > 0.05 && steep < 2.0)
      {
        const auto white = [&](double slope)
        { return 1.0 - std::clamp(0.5 * width + 0.5 - off / slope, 0.0, 1.0); };
        const double drawn = picture->GetScalarComponentAsDouble(x, y, 0, 0) / 255.0;
        ++compared;
        EXPECT_GE(drawn, white(steep) - 0.2) << x << " " << y;
        EXPECT_LE(drawn, white(flat) + 0.2) << x << " " << y;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

INSTANTIATE_TEST_SUITE_P(Levels, OpenGLTerrainMapperLevels, testing::Values(0.0, 1.0e8 + 3.7));

// As where the surface turns away: lines closer than pixels must not leave it black.
TEST(OpenGLTerrainMapperContours, TooCloseToTellFade)
{
  auto draw = [](TerrainScene&, const TerrainProp& terrain)
  {
    terrain.Actor->GetProperty()->LightingOff();
    terrain.Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    terrain.Mapper->SetContours(true);
    terrain.Mapper->SetContourInterval(0.2);
  };
  const auto picture = vtkTerrainTesting::DrawScene(draw);
  using Pixel = const unsigned char*;
  const auto isGrey = [](Pixel pixel) { return pixel[0] == pixel[2]; }; // the background is blue
  const int terrain = CountPixels(picture, isGrey);
  const int dark =
    CountPixels(picture, [&](Pixel pixel) { return isGrey(pixel) && pixel[0] < 120; });
  EXPECT_GT(terrain, 5000);
  EXPECT_LT(dark, terrain / 20); // level places show single lines
}

// A plane whose lines are 1.5 pixels apart, every tenth of them an index line.
TEST(OpenGLTerrainMapperContours, IndexLinesStayWhereLinesCrowd)
{
  constexpr double slope = 0.5;
  vtkNew<vtkImageData> plane;
  plane->SetDimensions(41, 31, 1);
  plane->SetSpacing(10.0, 10.0, 1.0);
  plane->AllocateScalars(VTK_DOUBLE, 1);
  for (int j = 0; j < 31; ++j)
  {
    for (int i = 0; i < 41; ++i)
    {
      plane->SetScalarComponentFromDouble(i, j, 0, 0, slope * 10.0 * i);
    }
  }
  TerrainScene scene(Techniques::Pyramid);
  const TerrainProp terrain = scene.AddTerrain(plane);
  terrain.Actor->GetProperty()->LightingOff();
  terrain.Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Look({ 200.0, 150.0, 1000.0 }, { 200.0, 150.0, 0.0 });
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(75.0); // 1 m a pixel in a window 150 pixels high
  const double interval = 1.5 * slope;
  terrain.Mapper->SetContours(true);
  terrain.Mapper->SetContourInterval(interval);
  terrain.Mapper->SetContourWidth(1.0);
  terrain.Mapper->SetContourIndex(10);
  const auto picture = vtkTerrainTesting::Render(scene.Window);
  const int* size = picture->GetDimensions();
  int dark = 0;
  for (int x = 10; x < size[0] - 10; ++x)
  {
    const double east = 200.0 + (x + 0.5 - 0.5 * size[0]) * 150.0 / size[1];
    const double lines = slope * east / (10.0 * interval);
    const double away = std::abs(lines - std::round(lines)) * 15.0; // in pixels
    const double drawn = picture->GetScalarComponentAsDouble(x, size[1] / 2, 0, 0) / 255.0;
    EXPECT_NEAR(drawn, 1.0 - std::clamp(1.5 - away, 0.0, 1.0), 0.02) << x;
    dark += drawn < 0.5 ? 1 : 0;
  }
  EXPECT_GT(dark, 10);
}
