// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks against what is drawn, and against the definition of the surface.
#include "vtkTerrainTesting.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainPicker.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWorldPointPicker.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace
{
using Point = std::array<double, 3>;

constexpr int Columns = 65;
constexpr int Rows = 49;
constexpr int PixelsX = 160;
constexpr int PixelsY = 120;
constexpr double SpacingX = 10.0;
constexpr double SpacingY = 12.0;

/// Heights of a function of column and row, with an array "Along" = column + 100 row at the points
/// and "Number" = index at the cells.
vtkSmartPointer<vtkImageData> MakeHeights(const std::function<double(int, int)>& height)
{
  vtkNew<vtkDoubleArray> heights;
  vtkNew<vtkFloatArray> along;
  vtkNew<vtkDoubleArray> number;
  heights->SetName("Heights");
  along->SetName("Along");
  number->SetName("Number");
  for (int j = 0; j < Rows; ++j)
  {
    for (int i = 0; i < Columns; ++i)
    {
      heights->InsertNextValue(height(i, j));
      along->InsertNextValue(static_cast<float>(i + 100 * j));
    }
  }
  for (int cell = 0; cell < (Columns - 1) * (Rows - 1); ++cell)
  {
    number->InsertNextValue(cell);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, 1);
  image->SetOrigin(500000.0, 5000000.0, 30.0);
  image->SetSpacing(SpacingX, SpacingY, 1.0);
  image->GetPointData()->SetScalars(heights);
  image->GetPointData()->AddArray(along);
  image->GetCellData()->AddArray(number);
  return image;
}

double Hill(int i, int j)
{
  return 100.0 + 40.0 * std::sin(0.3 * i) * std::cos(0.25 * j) + 4.0 * ((i * 7 + j * 13) % 5);
}

double HillWithHole(int i, int j)
{
  const bool hole = std::abs(i - 32) < 5 && std::abs(j - 24) < 5;
  return hole ? vtkMath::Nan() : Hill(i, j);
}

/// A wall of 100 over the column 32 on a plain at height 10.
double Wall(int i, int)
{
  return i == 32 ? 100.0 : 10.0;
}

/// The surface at a position in cells.
double Bilinear(double (*height)(int, int), double x, double y)
{
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const double south = (i + 1 - x) * height(i, j) + (x - i) * height(i + 1, j);
  const double north = (i + 1 - x) * height(i, j + 1) + (x - i) * height(i + 1, j + 1);
  return (j + 1 - y) * south + (y - j) * north;
}

class TerrainPicker : public testing::Test
{
protected:
  void Show(const std::function<double(int, int)>& height)
  {
    this->Heights = MakeHeights(height);
    this->Mesh->SetInputData(this->Heights);
    this->Mapper->SetInputConnection(this->Mesh->GetOutputPort());
    this->Mapper->SetHeightsData(this->Heights);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer()->AddActor(this->Actor);
    this->Camera()->SetViewUp(0.0, 0.0, 1.0);
  }

  vtkRenderer* Renderer()
  {
    return this->Scene.Renderer;
  }

  vtkCamera* Camera()
  {
    return this->Renderer()->GetActiveCamera();
  }

  /// World position of a position in cells and a z of the model.
  Point World(double i, double j, double z)
  {
    const double* origin = this->Heights->GetOrigin();
    const double model[4] = { origin[0] + i * SpacingX, origin[1] + j * SpacingY, z, 1.0 };
    double world[4];
    this->Actor->GetMatrix()->MultiplyPoint(model, world);
    return { world[0], world[1], world[2] };
  }

  void Look(const Point& eye, const Point& focalPoint)
  {
    this->Camera()->SetPosition(this->World(eye[0], eye[1], eye[2]).data());
    this->Camera()->SetFocalPoint(this->World(focalPoint[0], focalPoint[1], focalPoint[2]).data());
    this->Renderer()->ResetCameraClippingRange();
  }

  /// From straight above, x to the right.
  void LookDown()
  {
    this->Look({ 32.0, 24.0, 1500.0 }, { 32.0, 24.0, 100.0 });
    this->Camera()->SetViewUp(0.0, 1.0, 0.0);
    this->Renderer()->ResetCameraClippingRange();
    this->Scene.Window->Render();
  }

  /// Picks where a point in cells and z of the model is seen.
  bool PickAt(double i, double j, double z)
  {
    const Point world = this->World(i, j, z);
    this->Renderer()->SetWorldPoint(world[0], world[1], world[2], 1.0);
    this->Renderer()->WorldToDisplay();
    const double* display = this->Renderer()->GetDisplayPoint();
    return this->Picker->Pick(display[0], display[1], 0.0, this->Renderer()) != 0;
  }

  /// Distance of the picked point along the viewing direction; NaN without one.
  double PickDistance(double x, double y)
  {
    if (!this->Picker->Pick(x, y, 0.0, this->Renderer()))
    {
      return vtkMath::Nan();
    }
    double offset[3];
    vtkMath::Subtract(this->Picker->GetPickPosition(), this->Camera()->GetPosition(), offset);
    return vtkMath::Dot(offset, this->Camera()->GetDirectionOfProjection());
  }

  /// Picks at the centres of random pixels, and counts those whose distance is not the drawn one.
  int CountWrong(int picks)
  {
    this->Renderer()->SetPass(this->Pass);
    this->Scene.Window->Render();
    this->Renderer()->SetPass(nullptr);
    std::uniform_int_distribution<int> column(0, PixelsX - 1);
    std::uniform_int_distribution<int> row(0, PixelsY - 1);
    int wrong = 0;
    for (int k = 0; k < picks; ++k)
    {
      const int x = column(this->Random);
      const int y = row(this->Random);
      const double drawn = this->Pass->GetDistances()->GetScalarComponentAsDouble(x, y, 0, 0);
      const double picked = this->PickDistance(x + 0.5, y + 0.5);
      this->Hits += std::isnan(picked) ? 0 : 1;
      const bool same =
        std::isnan(drawn) ? std::isnan(picked) : std::abs(picked - drawn) <= Precision * drawn;
      wrong += same ? 0 : 1;
    }
    return wrong;
  }

  /// Of the drawn distances: those are floats, from rays in floats.
  static constexpr double Precision = 1e-6;

  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(PixelsX, PixelsY);
  vtkSmartPointer<vtkImageData> Heights;
  vtkNew<vtkTerrainCoarseMesh> Mesh;
  vtkNew<vtkOpenGLTerrainMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkTerrainDepthPass> Pass;
  vtkNew<vtkTerrainPicker> Picker;
  std::mt19937 Random{ 7 };
  int Hits = 0;
};
}

//------------------------------------------------------------------------------
// 1,000 picks in all; one or two may fall onto a silhouette.
TEST_F(TerrainPicker, AgreesWithTheDrawnDepth)
{
  this->Show(HillWithHole);
  int wrong = 0;
  this->Look({ 32.0, -40.0, 500.0 }, { 32.0, 20.0, 100.0 });
  wrong += this->CountWrong(200);
  this->Look({ -30.0, 10.0, 150.0 }, { 32.0, 24.0, 100.0 });
  wrong += this->CountWrong(100);
  this->Look({ 10.0, 10.0, 190.0 }, { 40.0, 30.0, 100.0 }); // within the box
  wrong += this->CountWrong(100);
  this->Look({ 32.0, -10.0, -200.0 }, { 32.0, 24.0, 100.0 }); // from below
  wrong += this->CountWrong(100);
  this->Mapper->SetVerticalExaggeration(2.5);
  this->Look({ 32.0, -40.0, 700.0 }, { 32.0, 20.0, 300.0 });
  wrong += this->CountWrong(100);
  this->Actor->SetOrigin(500000.0, 5000000.0, 0.0);
  this->Actor->SetOrientation(20.0, -15.0, 70.0);
  this->Actor->SetScale(1.5, -0.8, 1.2);
  this->Look({ 32.0, -40.0, 700.0 }, { 32.0, 20.0, 300.0 });
  wrong += this->CountWrong(200);
  this->Camera()->ParallelProjectionOn();
  this->Camera()->SetParallelScale(300.0);
  this->Look({ 32.0, -40.0, 900.0 }, { 32.0, 20.0, 300.0 });
  wrong += this->CountWrong(200);
  EXPECT_LE(wrong, 2);
  EXPECT_GT(this->Hits, 500);
}

// The walls, the floor and the cut faces of a block; columns; detail. A few picks of each may fall
// onto a silhouette.
TEST_F(TerrainPicker, AgreesWithTheDrawnDepthOfBlocksColumnsAndDetail)
{
  this->Show(Hill);
  const int first[2] = { 12, 7 };
  const int last[2] = { 50, 40 };
  this->Mapper->SetExtract(first, last);
  this->Mapper->SetBlock(true);
  this->Mapper->SetBlockBase(40.0);
  this->Mapper->SetVerticalExaggeration(2.0);
  this->Actor->RotateZ(25.0);
  vtkNew<vtkPlane> plane; // cuts a corner off
  plane->SetOrigin(this->World(20.0, 14.0, 0.0).data());
  plane->SetNormal(1.0, 0.8, 0.1);
  this->Mapper->AddClippingPlane(plane);
  const auto countWrong = [this]()
  {
    this->Look({ 5.0, -25.0, 400.0 }, { 31.0, 23.0, 160.0 });
    int wrong = this->CountWrong(150);
    this->Look({ 70.0, 80.0, -350.0 }, { 31.0, 23.0, 160.0 }); // from below
    wrong += this->CountWrong(150);
    return wrong;
  };
  EXPECT_LE(countWrong(), 2);
  EXPECT_GT(this->Hits, 150);
  this->Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  EXPECT_LE(countWrong(), 4);
  this->Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Bilinear);
  vtkNew<vtkTerrainDetailSource> detail;
  detail->SetSize(64);
  detail->Update();
  this->Mapper->SetDetailConnection(detail->GetOutputPort());
  this->Mapper->SetDetailCells(8);
  double range[2];
  detail->GetOutput()->GetScalarRange(range);
  this->Mapper->SetDetailScale(20.0 / (range[1] - range[0]));
  EXPECT_LE(countWrong(), 4);
  EXPECT_GT(this->Hits, 450);
}

// A pick on a wall: outward normal, the height of the point, the cell behind the wall.
TEST_F(TerrainPicker, PicksTheWallsOfBlocks)
{
  this->Show(Hill);
  this->Mapper->SetBlock(true);
  this->Mapper->SetVerticalExaggeration(2.0);
  this->Look({ 31.5, -200.0, 30.0 + 2.0 * 20.0 }, { 31.5, 24.0, 30.0 + 2.0 * 20.0 });
  this->Scene.Window->Render();
  ASSERT_TRUE(this->PickAt(31.5, 0.0, 30.0 + 2.0 * 20.0));
  EXPECT_NEAR(this->Picker->GetHeight(), 20.0, 1e-6);
  EXPECT_NEAR(this->Picker->GetGridPosition()[0], 31.5, 1e-6);
  EXPECT_EQ(this->Picker->GetGridPosition()[1], 0.0);
  EXPECT_NEAR(this->Picker->GetPickNormal()[1], -1.0, 1e-12);
  EXPECT_NEAR(this->Picker->GetPickPosition()[1], this->World(0.0, 0.0, 0.0)[1], 1e-6);
  // a line of sight through the block
  const Point south = this->World(31.5, -20.0, 60.0);
  const Point north = this->World(31.5, 70.0, 60.0);
  EXPECT_FALSE(this->Picker->HasLineOfSight(this->Actor, south.data(), north.data()));
  this->Mapper->SetBlock(false);
  EXPECT_TRUE(this->Picker->HasLineOfSight(this->Actor, south.data(), north.data()));
}

// Profiles of columns are steps.
TEST_F(TerrainPicker, CutsProfilesOfColumns)
{
  this->Show(Wall);
  this->Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  vtkNew<vtkPolyData> profile;
  ASSERT_TRUE(this->Picker->GetProfile(this->Actor, this->World(31.0, 10.2, 0.0).data(),
    this->World(33.0, 10.2, 0.0).data(), profile));
  ASSERT_EQ(profile->GetNumberOfLines(), 1);
  vtkDataArray* distances = profile->GetPointData()->GetArray("Distance");
  vtkDataArray* heights = profile->GetPointData()->GetArray("Height");
  std::vector<std::array<double, 2>> steps;
  for (vtkIdType k = 0; k < profile->GetNumberOfPoints(); ++k)
  {
    steps.push_back({ distances->GetComponent(k, 0), heights->GetComponent(k, 0) });
  }
  const std::vector<std::array<double, 2>> expected{ { 0.0, 10.0 }, { 5.0, 10.0 }, { 5.0, 100.0 },
    { 10.0, 100.0 }, { 15.0, 100.0 }, { 15.0, 10.0 }, { 20.0, 10.0 } };
  ASSERT_EQ(steps.size(), expected.size());
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    EXPECT_NEAR(steps[k][0], expected[k][0], 1e-6) << k;
    EXPECT_NEAR(steps[k][1], expected[k][1], 1e-9) << k;
  }
}

TEST_F(TerrainPicker, GivesCellSampleHeightAndValues)
{
  this->Show(Hill);
  this->Mapper->SetVerticalExaggeration(2.0);
  this->LookDown();
  ASSERT_TRUE(this->PickAt(20.75, 10.25, 30.0 + 2.0 * Bilinear(Hill, 20.75, 10.25)));
  ASSERT_TRUE(this->Picker->IsTerrainPicked());
  const double* grid = this->Picker->GetGridPosition();
  EXPECT_NEAR(grid[0], 20.75, 1e-6);
  EXPECT_NEAR(grid[1], 10.25, 1e-6);
  const int i = static_cast<int>(grid[0]);
  const int j = static_cast<int>(grid[1]);
  const double v = grid[1] - j;
  const double height = Bilinear(Hill, grid[0], grid[1]);
  EXPECT_NEAR(this->Picker->GetHeight(), height, 1e-9);
  const double* position = this->Picker->GetPickPosition();
  EXPECT_NEAR(position[0], 500000.0 + SpacingX * grid[0], 1e-6);
  EXPECT_NEAR(position[1], 5000000.0 + SpacingY * grid[1], 1e-6);
  EXPECT_NEAR(position[2], 30.0 + 2.0 * height, 1e-6);
  EXPECT_EQ(this->Picker->GetDataSet(), this->Heights.Get());
  EXPECT_EQ(this->Picker->GetMapper(), this->Mapper.Get());
  EXPECT_EQ(this->Picker->GetActor(), this->Actor.Get());
  EXPECT_EQ(this->Picker->GetCellIJK()[0], i);
  EXPECT_EQ(this->Picker->GetCellIJK()[1], j);
  EXPECT_EQ(this->Picker->GetCellId(), i + j * (Columns - 1));
  EXPECT_EQ(this->Picker->GetPointId(), std::lround(grid[0]) + std::lround(grid[1]) * Columns);
  EXPECT_NEAR(this->Picker->GetValue("Along"), grid[0] + 100.0 * grid[1], 1e-3);
  EXPECT_NEAR(this->Picker->GetValue("Heights"), height, 1e-9);
  EXPECT_EQ(this->Picker->GetValue("Number"), this->Picker->GetCellId());
  EXPECT_TRUE(std::isnan(this->Picker->GetValue("Along", 1)));
  EXPECT_TRUE(std::isnan(this->Picker->GetValue("Missing")));
  const double slopeX = 2.0 *
    ((1.0 - v) * (Hill(i + 1, j) - Hill(i, j)) + v * (Hill(i + 1, j + 1) - Hill(i, j + 1))) /
    SpacingX;
  const double* normal = this->Picker->GetPickNormal();
  EXPECT_NEAR(-normal[0] / normal[2], slopeX, 1e-9);
  EXPECT_NEAR(vtkMath::Norm(normal), 1.0, 1e-12);
}

TEST_F(TerrainPicker, PicksTheNearestProp)
{
  this->Show(Hill);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(30.0);
  sphere->SetCenter(this->World(32.0, 24.0, 400.0).data());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(mapper);
  this->Renderer()->AddActor(ball);
  this->LookDown();
  ASSERT_TRUE(this->PickAt(32.0, 24.0, 400.0));
  EXPECT_EQ(this->Picker->GetActor(), ball.Get());
  EXPECT_FALSE(this->Picker->IsTerrainPicked());
  EXPECT_TRUE(std::isnan(this->Picker->GetHeight()));
  EXPECT_TRUE(std::isnan(this->Picker->GetGridPosition()[0]));
  ball->SetPosition(0.0, 0.0, -800.0); // below the surface
  ASSERT_TRUE(this->PickAt(32.0, 24.0, 100.0));
  EXPECT_EQ(this->Picker->GetActor(), this->Actor.Get());
}

TEST_F(TerrainPicker, PicksNothingInHolesAndBeside)
{
  this->Show(HillWithHole);
  this->LookDown();
  EXPECT_FALSE(this->PickAt(32.0, 24.0, 130.0));
  EXPECT_FALSE(this->PickAt(-3.0, 24.0, 130.0));
  EXPECT_FALSE(this->Picker->IsTerrainPicked());
  EXPECT_TRUE(std::isnan(this->Picker->GetValue("Along")));
  EXPECT_TRUE(this->PickAt(20.0, 24.0, 130.0));
}

TEST_F(TerrainPicker, PicksNothingOfOneSample)
{
  this->Show(Hill);
  vtkNew<vtkImageData> one;
  one->SetDimensions(1, 1, 1);
  one->AllocateScalars(VTK_SHORT, 1);
  this->Mapper->SetHeightsData(one);
  this->LookDown();
  EXPECT_FALSE(this->PickAt(32.0, 24.0, 130.0));
}

TEST_F(TerrainPicker, LeavesOutWhatIsClipped)
{
  this->Show(Hill);
  vtkNew<vtkPlane> plane; // keeps the east
  plane->SetOrigin(this->World(32.0, 0.0, 0.0).data());
  plane->SetNormal(1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  this->LookDown();
  EXPECT_FALSE(this->PickAt(20.0, 24.0, 130.0));
  EXPECT_TRUE(this->PickAt(40.0, 24.0, 130.0));
}

TEST_F(TerrainPicker, LeavesOutWhatIsNotExtracted)
{
  this->Show(Hill);
  this->LookDown();
  const int first[2] = { 25, 10 };
  const int last[2] = { 40, 30 };
  this->Mapper->SetExtract(first, last);
  EXPECT_TRUE(this->PickAt(30.0, 20.0, 130.0));
  EXPECT_FALSE(this->PickAt(20.0, 20.0, 130.0));
  EXPECT_FALSE(this->PickAt(30.0, 35.0, 130.0));
  // under the terrain, east of the extract: nothing is in the way up
  const Point low = this->World(50.0, 20.0, 30.0);
  const Point high = this->World(50.0, 20.0, 900.0);
  EXPECT_TRUE(this->Picker->HasLineOfSight(this->Actor, low.data(), high.data()));
  this->Mapper->ExtractAll();
  EXPECT_FALSE(this->Picker->HasLineOfSight(this->Actor, low.data(), high.data()));
}

TEST_F(TerrainPicker, ScansHeightsOncePerChange)
{
  this->Show(Hill);
  this->LookDown();
  EXPECT_TRUE(this->PickAt(20.0, 24.0, 130.0));
  this->Mapper->SetVerticalExaggeration(1.5);
  this->Actor->SetPosition(3.0, 2.0, 1.0);
  this->Camera()->Azimuth(5.0);
  EXPECT_TRUE(this->PickAt(20.0, 24.0, 130.0));
  EXPECT_EQ(this->Picker->GetNumberOfScans(), 1);
  for (int id = 0; id < Columns * Rows; ++id)
  {
    this->Heights->GetPointData()->GetScalars()->SetComponent(id, 0, 55.0);
  }
  this->Heights->Modified();
  EXPECT_TRUE(this->PickAt(20.0, 24.0, 130.0));
  EXPECT_EQ(this->Picker->GetNumberOfScans(), 2);
  EXPECT_DOUBLE_EQ(this->Picker->GetHeight(), 55.0);
}

TEST_F(TerrainPicker, TellsLinesOfSight)
{
  this->Show(Wall);
  this->Mapper->SetVerticalExaggeration(3.0); // the plain at z = 60, the wall up to 330
  this->Actor->RotateZ(30.0);
  const Point west = this->World(20.0, 24.0, 61.0);
  const Point east = this->World(45.0, 20.0, 61.0);
  Point obstacle{};
  EXPECT_FALSE(
    this->Picker->HasLineOfSight(this->Actor, west.data(), east.data(), obstacle.data()));
  const double column = 31.0 + 1.0 / 270.0; // where the wall reaches z = 61
  const Point foot = this->World(column, 24.0 - 4.0 * (column - 20.0) / 25.0, 61.0);
  EXPECT_LT(vtkMath::Distance2BetweenPoints(foot.data(), obstacle.data()), 1e-6);
  EXPECT_FALSE(this->Picker->HasLineOfSight(this->Actor, east.data(), west.data()));
  const Point behind = this->World(31.0, 5.0, 60.0); // on the plain before the wall
  EXPECT_TRUE(this->Picker->HasLineOfSight(this->Actor, west.data(), west.data()));
  const Point high = this->World(20.0, 24.0, 340.0);
  EXPECT_TRUE(
    this->Picker->HasLineOfSight(this->Actor, high.data(), this->World(45.0, 20.0, 340.0).data()));
  EXPECT_TRUE(this->Picker->HasLineOfSight(this->Actor, high.data(), behind.data()));
  EXPECT_TRUE(this->Picker->HasLineOfSight(this->Actor, high.data(), west.data()));
  const Point under = this->World(20.0, 24.0, 20.0);
  EXPECT_FALSE(this->Picker->HasLineOfSight(this->Actor, high.data(), under.data()));
  EXPECT_FALSE(this->Picker->HasLineOfSight(nullptr, high.data(), west.data()));
}

TEST_F(TerrainPicker, CutsProfiles)
{
  this->Show(Wall);
  this->Mapper->SetVerticalExaggeration(3.0);
  this->Actor->SetPosition(7.0, 0.0, 0.0);
  vtkNew<vtkPolyData> profile;
  const Point from = this->World(30.5, 10.0, 0.0);
  const Point to = this->World(33.5, 10.0, 999.0);
  ASSERT_TRUE(this->Picker->GetProfile(this->Actor, from.data(), to.data(), profile));
  ASSERT_EQ(profile->GetNumberOfPoints(), 5);
  ASSERT_EQ(profile->GetNumberOfLines(), 1);
  vtkDataArray* distances = profile->GetPointData()->GetArray("Distance");
  vtkDataArray* heights = profile->GetPointData()->GetArray("Height");
  const double expected[5][2] = { { 0.0, 10.0 }, { 5.0, 10.0 }, { 15.0, 100.0 }, { 25.0, 10.0 },
    { 30.0, 10.0 } };
  for (int k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(distances->GetComponent(k, 0), expected[k][0], 1e-6);
    EXPECT_NEAR(heights->GetComponent(k, 0), expected[k][1], 1e-6);
    double point[3];
    profile->GetPoint(k, point);
    EXPECT_NEAR(point[0], from[0] + expected[k][0], 1e-6);
    EXPECT_NEAR(point[2], 30.0 + 3.0 * expected[k][1], 1e-6);
  }
}

TEST_F(TerrainPicker, CutsProfilesAtHolesAndBorders)
{
  this->Show(HillWithHole);
  vtkNew<vtkPolyData> profile;
  ASSERT_TRUE(this->Picker->GetProfile(this->Actor, this->World(-5.0, 24.5, 0.0).data(),
    this->World(80.0, 23.5, 0.0).data(), profile));
  EXPECT_EQ(profile->GetNumberOfLines(), 2);
  ASSERT_TRUE(this->Picker->GetProfile(this->Actor, this->World(-5.0, -24.5, 0.0).data(),
    this->World(-8.0, 23.5, 0.0).data(), profile));
  EXPECT_EQ(profile->GetNumberOfPoints(), 0);
  const Point nowhere{ vtkMath::Nan(), 0.0, 0.0 };
  EXPECT_FALSE(this->Picker->GetProfile(this->Actor, nowhere.data(), nowhere.data(), profile));
}

// The extremes of the parabola over a twisted cell are points of the profile.
TEST_F(TerrainPicker, FindsTheExtremesOfProfiles)
{
  this->Show([](int i, int j) { return i % 2 == j % 2 ? 0.0 : 1.0; });
  vtkNew<vtkPolyData> profile;
  ASSERT_TRUE(this->Picker->GetProfile(
    this->Actor, this->World(4.0, 4.0, 0.0).data(), this->World(5.0, 5.0, 0.0).data(), profile));
  double range[2];
  profile->GetPointData()->GetArray("Height")->GetRange(range);
  EXPECT_NEAR(range[1], 0.5, 1e-12);
}

// Both read the depth buffer: a point of the surface, to the buffer's precision.
TEST_F(TerrainPicker, PickersOfTheDepthBufferFindTheSurface)
{
  this->Show(Hill);
  this->Look({ 32.0, -40.0, 500.0 }, { 32.0, 20.0, 100.0 });
  this->Scene.Window->Render();
  const int x = PixelsX / 2;
  const int y = PixelsY / 2;
  ASSERT_FALSE(std::isnan(this->PickDistance(x + 0.5, y + 0.5)));
  const double* exact = this->Picker->GetPickPosition();
  // they take the corner of the pixel for its centre
  const double pixel = 2.0 * this->Camera()->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * this->Camera()->GetViewAngle())) / PixelsY;
  vtkNew<vtkPropPicker> propPicker;
  ASSERT_TRUE(propPicker->Pick(x, y, 0.0, this->Renderer()));
  EXPECT_EQ(propPicker->GetActor(), this->Actor.Get());
  EXPECT_LT(
    std::sqrt(vtkMath::Distance2BetweenPoints(propPicker->GetPickPosition(), exact)), 2.0 * pixel);
  this->Scene.Window->Render();
  vtkNew<vtkWorldPointPicker> worldPicker;
  worldPicker->Pick(x, y, 0.0, this->Renderer());
  EXPECT_LT(
    std::sqrt(vtkMath::Distance2BetweenPoints(worldPicker->GetPickPosition(), exact)), 2.0 * pixel);
}
