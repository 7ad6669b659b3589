// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Strips drawn by VTK's own mapper: at each of three tolerances the depths stay within the
// tolerance of the full mesh, and the pictures are known.
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainStrips.h"
#include "vtkTerrainTesting.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
constexpr int Width = 400;
constexpr int Height = 300;
/// The surface itself: every cell as 4 x 4 squares of two triangles on its bilinear patch.
vtkNew<vtkPolyData> MakeReference(vtkImageData* heights)
{
  constexpr int parts = 4;
  const int* dims = heights->GetDimensions();
  const int columns = (dims[0] - 1) * parts + 1;
  const int rows = (dims[1] - 1) * parts + 1;
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double* origin = heights->GetOrigin();
  const double* spacing = heights->GetSpacing();
  const auto at = [&](int i, int j) { return heights->GetScalarComponentAsDouble(i, j, 0, 0); };
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int ci = std::min(i / parts, dims[0] - 2);
      const int cj = std::min(j / parts, dims[1] - 2);
      const double u = static_cast<double>(i) / parts - ci;
      const double v = static_cast<double>(j) / parts - cj;
      const double h = (1 - u) * (1 - v) * at(ci, cj) + u * (1 - v) * at(ci + 1, cj) +
        (1 - u) * v * at(ci, cj + 1) + u * v * at(ci + 1, cj + 1);
      points->InsertNextPoint(
        origin[0] + (ci + u) * spacing[0], origin[1] + (cj + v) * spacing[1], origin[2] + h);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j + 1 < rows; ++j)
  {
    cells->InsertNextCell(2 * columns);
    for (int i = 0; i < columns; ++i)
    {
      cells->InsertCellPoint((j + 1) * static_cast<vtkIdType>(columns) + i);
      cells->InsertCellPoint(j * static_cast<vtkIdType>(columns) + i);
    }
  }
  mesh->SetPoints(points);
  mesh->SetStrips(cells);
  return mesh;
}

struct Picture
{
  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(Width, Height);
  vtkNew<vtkTerrainSource> Source;
  vtkNew<vtkTerrainStrips> Strips;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;

  Picture()
  {
    this->Source->SetDimensions(257, 257);
    this->Source->Update();
    double bounds[6];
    this->Source->GetOutput()->GetBounds(bounds);
    double range[2];
    this->Source->GetOutput()->GetScalarRange(range);
    const double size = bounds[1] - bounds[0];
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetFocalPoint(
      bounds[0] + 0.5 * size, bounds[2] + 0.5 * size, 0.5 * (range[0] + range[1]));
    camera->SetPosition(bounds[0] + 0.4 * size, bounds[2] - 0.3 * size, range[1] + 0.25 * size);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.1 * size, 2.5 * size);
    this->Strips->SetInputConnection(this->Source->GetOutputPort());
    this->Strips->SetCamera(camera);
    this->Strips->SetViewportSize(Width, Height);
    this->Strips->NormalsOn();
    this->Actor->SetMapper(this->Mapper);
    this->Mapper->SetInputConnection(this->Strips->GetOutputPort());
    this->Scene.Renderer->AddActor(this->Actor);
  }

  /// Distance along the viewing direction of each pixel, infinite where nothing is drawn.
  std::vector<double> Depths()
  {
    this->Scene.Window->Render();
    const double* range = this->Scene.Renderer->GetActiveCamera()->GetClippingRange();
    std::vector<double> distances;
    for (const float depth : vtkTerrainTesting::ReadDepth(this->Scene.Window))
    {
      distances.push_back(depth >= 1.0f
          ? HUGE_VAL
          : range[0] * range[1] / (range[1] - depth * (range[1] - range[0])));
    }
    return distances;
  }
};

/// Part of the pixels whose depth no pixel of the reference within `reach` pixels has, or brackets
/// between its neighbours.
double PartBeyond(
  const std::vector<double>& depths, const std::vector<double>& reference, int reach)
{
  int wrong = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (int j = std::max(0, y - reach); j <= std::min(Height - 1, y + reach); ++j)
      {
        for (int i = std::max(0, x - reach); i <= std::min(Width - 1, x + reach); ++i)
        {
          low = std::min(low, reference[i + j * Width]);
          high = std::max(high, reference[i + j * Width]);
        }
      }
      const double depth = depths[x + y * Width];
      const bool inside = depth >= low * (1.0 - 1.0e-4) && depth <= high * (1.0 + 1.0e-4);
      wrong += inside ? 0 : 1;
    }
  }
  return static_cast<double>(wrong) / (Width * Height);
}

/// Share of the pixels with some colour in which a channel is the brightest: red, green or blue.
/// Edges are black: the shares hardly depend on how wide they are.
double BrightestShare(vtkImageData* picture, int channel)
{
  constexpr int kSome = 32;
  const auto brightest = [](const unsigned char* p) { return std::max({ p[0], p[1], p[2] }); };
  const int some = vtkTerrainTesting::CountPixels(
    picture, [&](const unsigned char* p) { return brightest(p) >= kSome; });
  const int those = vtkTerrainTesting::CountPixels(picture,
    [&](const unsigned char* p) { return brightest(p) >= kSome && p[channel] == brightest(p); });
  return static_cast<double>(those) / std::max(some, 1);
}
}

TEST(TerrainStripsDrawing, DepthsStayWithinTheTolerance)
{
  Picture picture;
  picture.Mapper->SetInputConnection(nullptr);
  picture.Mapper->SetInputDataObject(MakeReference(picture.Source->GetOutput()));
  const std::vector<double> reference = picture.Depths();
  picture.Mapper->SetInputConnection(picture.Strips->GetOutputPort());
  for (const int tolerance : { 1, 3, 8 })
  {
    picture.Strips->SetTolerance(tolerance);
    const double beyond = PartBeyond(picture.Depths(), reference, tolerance);
    RecordProperty("beyond" + std::to_string(tolerance), std::to_string(beyond));
    std::printf("tolerance %d: %g of the pixels beyond, %lld triangles\n", tolerance, beyond,
      static_cast<long long>(picture.Strips->GetNumberOfTriangles()));
    EXPECT_LE(beyond, 0.001);
  }
}

TEST(TerrainStripsDrawing, MatchesBaselines)
{
  Picture picture;
  const std::pair<int, double> drawnAt[] = { { 1, 0.710 }, { 3, 0.703 }, { 8, 0.687 } };
  for (const auto& [tolerance, share] : drawnAt)
  {
    picture.Strips->SetTolerance(tolerance);
    const auto drawn = vtkTerrainTesting::Render(picture.Scene.Window);
    EXPECT_TRUE(
      vtkTerrainTesting::MatchesBaseline(drawn, "TerrainStrips" + std::to_string(tolerance)));
    EXPECT_NEAR(vtkTerrainTesting::DrawnShare(drawn), share, 0.005) << tolerance;
  }
  picture.Strips->DepthColorsOn();
  const auto colored = vtkTerrainTesting::Render(picture.Scene.Window);
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(colored), 0.687, 0.005);
  // how wide edges are is VTK's: it has changed since 9.1
  picture.Actor->GetProperty()->EdgeVisibilityOn();
  const auto depths = vtkTerrainTesting::Render(picture.Scene.Window);
  const double brightest[] = { 0.303, 0.358, 0.363 };
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(BrightestShare(depths, channel), brightest[channel], 0.02) << channel;
  }
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(depths, "TerrainStripsDepths", { 40, 0.01 }));
}

TEST(TerrainStripsDrawing, TheTerrainMapperShadesThemByTheHeights)
{
  Picture picture;
  const auto render = [&] { return vtkTerrainTesting::Render(picture.Scene.Window); };
  vtkNew<vtkOpenGLTerrainMapper> mapper;
  mapper->SetHeightsConnection(picture.Source->GetOutputPort());
  picture.Actor->SetMapper(mapper);
  const vtkSmartPointer<vtkImageData> surface = render();
  mapper->SetInputConnection(0, picture.Strips->GetOutputPort());
  mapper->SetTechnique(vtkOpenGLTerrainMapper::Techniques::Mesh);
  picture.Strips->SetTolerance(3.0);
  const vtkSmartPointer<vtkImageData> shaded = render();
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(shaded, "TerrainStripsShaded"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(shaded), 0.694, 0.005);
  const vtkIdType shadedByHeights = vtkTerrainTesting::CountDifferentPixels(surface, shaded, 20);
  picture.Actor->SetMapper(picture.Mapper);
  const vtkIdType shadedByPoints = vtkTerrainTesting::CountDifferentPixels(surface, render(), 20);
  RecordProperty("shadedByHeights", std::to_string(shadedByHeights));
  RecordProperty("shadedByPoints", std::to_string(shadedByPoints));
  std::printf("pixels shaded otherwise: %lld by heights, %lld by points\n",
    static_cast<long long>(shadedByHeights), static_cast<long long>(shadedByPoints));
  // The strips leave the surface by up to 3 pixels, so some differ in either case.
  EXPECT_LT(2 * shadedByHeights, shadedByPoints);
}

TEST(TerrainStripsDrawing, WithDetailTheyAreTheSurfaceOfTheRays)
{
  Picture picture;
  vtkNew<vtkTerrainDetailSource> detail;
  detail->SetSize(64);
  detail->SetRelief(30.0);
  vtkNew<vtkOpenGLTerrainMapper> rays;
  rays->SetHeightsConnection(picture.Source->GetOutputPort());
  rays->SetDetailConnection(detail->GetOutputPort());
  rays->SetDetailCells(8);
  rays->SetDetailScale(2.0); // the box of the terrain ends 40 m below the eye
  picture.Actor->SetMapper(rays);
  vtkCamera* camera = picture.Scene.Renderer->GetActiveCamera();
  double bounds[6];
  picture.Source->Update();
  picture.Source->GetOutput()->GetBounds(bounds);
  const double size = bounds[1] - bounds[0];
  camera->SetFocalPoint(bounds[0] + 0.6 * size, bounds[2] + 0.6 * size, 0.0);
  camera->SetPosition(bounds[0] + 0.45 * size, bounds[2] + 0.4 * size,
    picture.Source->GetOutput()->GetScalarRange()[1] + 100.0);
  camera->SetClippingRange(0.002 * size, 2.0 * size);
  const std::vector<double> reference = picture.Depths();
  const auto render = [&] { return vtkTerrainTesting::Render(picture.Scene.Window); };
  const vtkSmartPointer<vtkImageData> surface = render();

  picture.Actor->SetMapper(picture.Mapper);
  picture.Strips->SetDetailConnection(detail->GetOutputPort());
  picture.Strips->SetDetailCells(8);
  picture.Strips->SetDetailScale(2.0);
  picture.Strips->SetTolerance(1.0);
  const double beyond = PartBeyond(picture.Depths(), reference, 1);
  std::printf("%g of the pixels beyond, %lld triangles\n", beyond,
    static_cast<long long>(picture.Strips->GetNumberOfTriangles()));
  EXPECT_LE(beyond, 0.001);
  const vtkSmartPointer<vtkImageData> detailed = render();
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(detailed, "TerrainStripsDetail"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(detailed), 0.875, 0.005);

  // Coarse strips: the terrain mapper lights them by what no triangle carries.
  picture.Strips->SetTolerance(6.0);
  const vtkIdType byPoints = vtkTerrainTesting::CountDifferentPixels(surface, render(), 20);
  rays->SetInputConnection(0, picture.Strips->GetOutputPort());
  rays->SetTechnique(vtkOpenGLTerrainMapper::Techniques::Mesh);
  picture.Actor->SetMapper(rays);
  const vtkSmartPointer<vtkImageData> shaded = render();
  const vtkIdType byHeights = vtkTerrainTesting::CountDifferentPixels(surface, shaded, 20);
  std::printf("pixels shaded otherwise: %lld by heights, %lld by points, %lld triangles\n",
    static_cast<long long>(byHeights), static_cast<long long>(byPoints),
    static_cast<long long>(picture.Strips->GetNumberOfTriangles()));
  EXPECT_LT(2 * byHeights, byPoints);
  picture.Actor->SetMapper(picture.Mapper);
  picture.Strips->SetTolerance(1.0);

  // Without the detail they are another surface: the comparison can fail.
  picture.Strips->SetDetailScale(0.0);
  EXPECT_GT(PartBeyond(picture.Depths(), reference, 1), 0.01);
}
