// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Terrain that is cut, has holes, or stands on a block.
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

using vtkTerrainTesting::CountPixels;
using vtkTerrainTesting::Demands;
using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::DrawsAsThePlainMesh;
using vtkTerrainTesting::DrawScene;
using vtkTerrainTesting::MakeFineMesh;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

constexpr int First[2] = { 6, 5 };
constexpr int Last[2] = { 30, 26 };
constexpr double Base = 20.0;

/// Keeps the west, and what is south of a slanting plane.
void Cut(vtkMapper* mapper)
{
  vtkNew<vtkPlane> west;
  west->SetOrigin(290.0, 0.0, 0.0);
  west->SetNormal(-1.0, 0.0, 0.0);
  vtkNew<vtkPlane> south;
  south->SetOrigin(0.0, 300.0, 100.0);
  south->SetNormal(0.1, -1.0, 0.4);
  mapper->AddClippingPlane(west);
  mapper->AddClippingPlane(south);
}

vtkSmartPointer<vtkImageData> Extract(vtkImageData* heights)
{
  vtkNew<vtkExtractVOI> filter;
  filter->SetInputData(heights);
  filter->SetVOI(First[0], Last[0], First[1], Last[1], 0, 0);
  filter->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(filter->GetOutput());
  image->SetOrigin(10.0 * First[0], 12.0 * First[1], 0.0);
  image->SetExtent(0, Last[0] - First[0], 0, Last[1] - First[1], 0, 0);
  return image;
}

/// Adds a wall below the line from one point of the surface to the next.
void AddWall(vtkPoints* points, vtkCellArray* walls, const double a[3], const double b[3])
{
  const vtkIdType corner = points->GetNumberOfPoints();
  points->InsertNextPoint(a[0], a[1], Base);
  points->InsertNextPoint(b[0], b[1], Base);
  points->InsertNextPoint(b);
  points->InsertNextPoint(a);
  walls->InsertNextCell({ corner, corner + 1, corner + 2, corner + 3 });
}

/// The walls of the block under heights, and its floor.
vtkSmartPointer<vtkPolyData> MakeWalls(vtkImageData* heights)
{
  const int* size = heights->GetDimensions();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> walls;
  auto at = [&](int i, int j, double point[3])
  {
    heights->GetPoint(i + vtkIdType{ size[0] } * j, point);
    point[2] = heights->GetScalarComponentAsDouble(i, j, 0, 0);
  };
  double a[3];
  double b[3];
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i + 1 < size[0]; ++i)
    {
      at(i, side * (size[1] - 1), a);
      at(i + 1, side * (size[1] - 1), b);
      AddWall(points, walls, a, b);
    }
    for (int j = 0; j + 1 < size[1]; ++j)
    {
      at(side * (size[0] - 1), j, a);
      at(side * (size[0] - 1), j + 1, b);
      AddWall(points, walls, a, b);
    }
  }
  const double* bounds = heights->GetBounds();
  const vtkIdType corner = points->GetNumberOfPoints();
  points->InsertNextPoint(bounds[0], bounds[2], Base);
  points->InsertNextPoint(bounds[1], bounds[2], Base);
  points->InsertNextPoint(bounds[1], bounds[3], Base);
  points->InsertNextPoint(bounds[0], bounds[3], Base);
  walls->InsertNextCell({ corner, corner + 1, corner + 2, corner + 3 });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(walls);
  return mesh;
}

/// A block: of a terrain's own, or of walls beside a mesh.
void StandOnBlock(TerrainScene& scene, const TerrainProp& terrain)
{
  if (terrain.Mapper->GetTechnique() == Techniques::Mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeWalls(terrain.Mapper->GetHeights()));
    vtkNew<vtkActor> walls;
    walls->SetMapper(mapper);
    walls->SetProperty(terrain.Actor->GetProperty());
    scene.Renderer->AddActor(walls);
  }
  else
  {
    terrain.Mapper->SetBlock(true);
    terrain.Mapper->SetBlockBase(Base);
  }
  scene.Renderer->ResetCameraClippingRange();
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperCutting, ClippingPlanes)
{
  auto clip = [](vtkMapper* mapper, vtkActor*) { Cut(mapper); };
  EXPECT_TRUE(DrawsAsThePlainMesh(clip, clip));
}

TEST(OpenGLTerrainMapperCutting, ClippingPlanesAndExaggeration)
{
  auto clip = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    Cut(terrain.Mapper);
    terrain.Mapper->SetVerticalExaggeration(1.5);
    scene.AddSphere(330.0, 200.0, 120.0, 40.0);
    scene.Renderer->ResetCameraClippingRange();
  };
  EXPECT_TRUE(DrawsAsTheMesh(clip));
  Demands demands;
  demands.Technique = Techniques::Equidistant;
  EXPECT_TRUE(DrawsAsTheMesh(clip, demands));
}

TEST(OpenGLTerrainMapperCutting, HolesShowWhatLiesBehind)
{
  auto look = [](TerrainScene& scene, const TerrainProp&)
  {
    scene.AddSphere(220.0, 200.0, 60.0, 45.0);
    scene.Look({ 220.0, 500.0, 500.0 }, { 210.0, 200.0, 80.0 });
  };
  Demands demands;
  demands.Heights = MakeHills(true);
  EXPECT_TRUE(DrawsAsTheMesh(look, demands));
}

TEST(OpenGLTerrainMapperCutting, Extract)
{
  auto extractRays = [](vtkMapper* mapper, vtkActor*)
  { static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetExtract(First, Last); };
  auto extractMesh = [](vtkMapper* mapper, vtkActor*)
  { static_cast<vtkPolyDataMapper*>(mapper)->SetInputData(MakeFineMesh(Extract(MakeHills()))); };
  EXPECT_TRUE(DrawsAsThePlainMesh(extractRays, extractMesh));
}

TEST(OpenGLTerrainMapperCutting, ExtractHasBounds)
{
  TerrainScene scene(Techniques::Pyramid);
  const TerrainProp terrain = scene.AddTerrain(MakeHills());
  terrain.Mapper->SetExtract(First, Last);
  const double* bounds = terrain.Actor->GetBounds();
  EXPECT_DOUBLE_EQ(bounds[0], 60.0);
  EXPECT_DOUBLE_EQ(bounds[1], 300.0);
  EXPECT_DOUBLE_EQ(bounds[2], 60.0);
  EXPECT_DOUBLE_EQ(bounds[3], 312.0);
  terrain.Mapper->ExtractAll();
  EXPECT_DOUBLE_EQ(terrain.Actor->GetBounds()[1], 400.0);
}

TEST(OpenGLTerrainMapperCutting, BlockFromAboveAndBelow)
{
  EXPECT_TRUE(DrawsAsTheMesh(StandOnBlock));
  auto lookUp = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    scene.Look({ 600.0, 700.0, -150.0 }, { 200.0, 190.0, 60.0 });
    StandOnBlock(scene, terrain);
  };
  EXPECT_TRUE(DrawsAsTheMesh(lookUp));
}

TEST(OpenGLTerrainMapperCutting, BlockByAComputeShader)
{
  auto compute = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    terrain.Mapper->SetComputeMode(vtkOpenGLTerrainMapper::ComputeModes::On);
    StandOnBlock(scene, terrain);
  };
  EXPECT_TRUE(DrawsAsTheMesh(compute));
}

TEST(OpenGLTerrainMapperCutting, WallsFollowColumns)
{
  const auto heights = MakeHills();
  const auto heightOf = [](int i) { return 60.0 + 20.0 * (7 * i % 5); };
  for (vtkIdType k = 0; k < heights->GetNumberOfPoints(); ++k)
  {
    heights->GetPointData()->GetScalars()->SetComponent(k, 0, heightOf(k % 41));
  }
  auto draw = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    terrain.Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
    terrain.Mapper->SetBlock(true);
    terrain.Mapper->SetBlockBase(Base);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(150.0);
    scene.Look({ 200.0, 900.0, 60.0 }, { 200.0, 190.0, 60.0 }); // from the north, head on
  };
  const auto picture = DrawScene(draw, Techniques::Pyramid, heights);
  int wrong = 0;
  for (int py = 0; py < 150; ++py)
  {
    for (int px = 0; px < 200; ++px)
    {
      const int x = 399 - 2 * px; // what the middle of the pixel shows
      const double z = 2.0 * py - 89.0;
      const bool expected = z > Base && z < heightOf((x + 5) / 10);
      const bool drawn = picture->GetScalarComponentAsDouble(px, py, 0, 0) == 204.0;
      wrong += x % 10 != 5 && drawn != expected ? 1 : 0; // there columns meet
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(OpenGLTerrainMapperCutting, APictureCoversTheWallsToo)
{
  vtkNew<vtkImageData> white;
  white->SetDimensions(2, 2, 1);
  white->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  white->GetPointData()->GetScalars()->Fill(255.0);
  auto drape = [&white](TerrainScene& scene, const TerrainProp& terrain)
  {
    StandOnBlock(scene, terrain);
    const double* bounds = terrain.Mapper->GetHeights()->GetBounds();
    terrain.Mapper->SetDrape(white, bounds);
    terrain.Actor->GetProperty()->LightingOff();
    terrain.Actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    scene.Look({ 200.0, 700.0, 100.0 }, { 200.0, 190.0, 60.0 });
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  };
  const auto picture = vtkTerrainTesting::DrawScene(drape);
  using Pixel = const unsigned char*;
  EXPECT_GT(CountPixels(picture, [](Pixel pixel) { return pixel[0] > 0; }), 5000);
  EXPECT_EQ(CountPixels(picture, [](Pixel pixel) { return pixel[0] > pixel[1] + 8; }), 0); // red
}

TEST(OpenGLTerrainMapperCutting, SaysThatPlanesAreTooMany)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  auto clip = [&errors](TerrainScene&, const TerrainProp& terrain)
  {
    terrain.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
    for (int i = 0; i < 7; ++i)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(100.0, 0.0, 0.0);
      plane->SetNormal(1.0, 0.0, 0.0);
      terrain.Mapper->AddClippingPlane(plane);
    }
  };
  vtkTerrainTesting::DrawScene(clip);
  EXPECT_NE(errors->GetErrorMessage().find("At most 6"), std::string::npos);
}

TEST(OpenGLTerrainMapperCutting, BlockInParallelProjection)
{
  auto look = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(200.0);
    StandOnBlock(scene, terrain);
  };
  EXPECT_TRUE(DrawsAsTheMesh(look));
}

TEST(OpenGLTerrainMapperCutting, PlanesCutABlockOpen)
{
  // the cut is flat: its colour is that of a face towards the plane's normal
  auto open = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    vtkNew<vtkPlane> plane; // keeps the south
    plane->SetOrigin(0.0, 250.0, 0.0);
    plane->SetNormal(0.0, -1.0, 0.0);
    terrain.Mapper->AddClippingPlane(plane);
    terrain.Mapper->SetBlock(true);
    terrain.Mapper->SetBlockBase(Base);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(150.0);
    scene.Look({ 200.0, 900.0, 60.0 }, { 200.0, 190.0, 60.0 });
  };
  const auto picture = DrawScene(open);
  const auto* middle = static_cast<unsigned char*>(picture->GetScalarPointer(100, 75, 0));
  const auto* corner = static_cast<unsigned char*>(picture->GetScalarPointer(30, 65, 0));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(middle[c], corner[c]);
  }
  EXPECT_EQ(middle[0], 204); // the headlight meets the cut head on: 0.8 of 255
}
