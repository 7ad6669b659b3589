// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The actor against the same pipeline put together by hand, and what changes do to it.
#include "vtkTerrainTesting.h"

#include "vtkTerrainActor.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainGlobe.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainStrips.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"
#include "vtkTestErrorObserver.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>

namespace
{
using Techniques = vtkTerrainActor::Techniques;
using Bounds = std::array<double, 6>;

/// Heights of n x n samples.
vtkSmartPointer<vtkImageData> MakeHeights(int n)
{
  vtkNew<vtkFloatArray> values;
  for (int id = 0; id < n * n; ++id)
  {
    const double x = 20.0 * (id % n) / n;
    const int row = id / n;
    const double y = 20.0 * row / n;
    values->InsertNextValue(
      static_cast<float>(100.0 + 60.0 * std::sin(x) * std::cos(y) + 30.0 * std::sin(0.3 * x * y)));
  }
  auto heights = vtkSmartPointer<vtkImageData>::New();
  heights->SetDimensions(n, n, 1);
  heights->SetSpacing(10.0, 10.0, 1.0);
  heights->GetPointData()->SetScalars(values);
  return heights;
}

void ScaleHeights(vtkImageData* heights, double factor)
{
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    scalars->SetComponent(id, 0, factor * scalars->GetComponent(id, 0));
  }
  scalars->Modified();
}

class TerrainActor : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Terrain->SetInputData(this->Heights);
    this->Scene.Renderer->AddActor(this->Terrain);
    this->LookFromSouth();
  }

  void LookFromSouth()
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, -1.0, 0.7);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCamera();
  }

  vtkSmartPointer<vtkImageData> Draw()
  {
    return vtkTerrainTesting::Render(this->Scene.Window);
  }

  Bounds ActorBounds()
  {
    Bounds bounds{};
    this->Terrain->GetBounds(bounds.data());
    return bounds;
  }

  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(160, 120);
  vtkSmartPointer<vtkImageData> Heights = MakeHeights(129);
  vtkNew<vtkTerrainActor> Terrain;
};

int CountDrawn(vtkImageData* picture)
{
  vtkNew<vtkImageData> black;
  black->DeepCopy(picture);
  black->GetPointData()->GetScalars()->Fill(0.0);
  return static_cast<int>(vtkTerrainTesting::CountDifferentPixels(picture, black, 0));
}
}

//------------------------------------------------------------------------------
TEST_F(TerrainActor, DrawsAsThePipelineByHand)
{
  for (const Techniques technique :
    { Techniques::Pyramid, Techniques::Equidistant, Techniques::Mesh })
  {
    this->Terrain->SetTechnique(technique);
    this->Terrain->SetVerticalExaggeration(2.0);
    this->LookFromSouth();
    const auto picture = this->Draw();
    EXPECT_GT(CountDrawn(picture), 160 * 120 / 6);

    vtkNew<vtkTerrainCoarseMesh> mesh;
    mesh->SetInputData(this->Heights);
    mesh->SetCellsPerQuad(technique == Techniques::Mesh ? 1 : 0);
    mesh->SetPushUp(technique != Techniques::Mesh);
    vtkNew<vtkOpenGLTerrainMapper> mapper;
    mapper->SetInputConnection(mesh->GetOutputPort());
    mapper->SetHeightsData(this->Heights);
    mapper->SetTechnique(technique);
    mapper->SetVerticalExaggeration(2.0);
    double range[2];
    this->Heights->GetScalarRange(range);
    mapper->SetLookupTable(vtkTerrainActor::MakeReliefColors(range[0], range[1]));
    mapper->SetScalarRange(range);
    mapper->ScalarVisibilityOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.0);
    this->Scene.Renderer->AddActor(actor);
    this->Terrain->VisibilityOff();
    EXPECT_LE(vtkTerrainTesting::CountDifferentPixels(this->Draw(), picture, 1), 2)
      << static_cast<int>(technique);
    this->Terrain->VisibilityOn();
    this->Scene.Renderer->RemoveActor(actor);
  }
}

TEST_F(TerrainActor, MakesMeshesOnlyWhereTheyAreNeeded)
{
  vtkPolyData* coarse = this->Terrain->GetCoarseMesh()->GetOutput();
  this->Draw();
  EXPECT_EQ(this->Terrain->GetUsedMesh(), nullptr);
  EXPECT_EQ(coarse->GetNumberOfPoints(), 0);
  this->Terrain->GetCoarseMesh()->SetCellsPerQuad(16);
  this->Terrain->SetTechnique(Techniques::Equidistant);
  this->Draw();
  EXPECT_EQ(coarse->GetNumberOfPoints(), 0);
  this->Terrain->GetProperty()->SetRepresentationToWireframe();
  this->Draw();
  EXPECT_GT(coarse->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Terrain->GetTerrainMapper()->GetInput(), coarse);
  this->Terrain->GetProperty()->SetRepresentationToSurface();
  this->Terrain->SetTechnique(Techniques::Mesh);
  vtkPolyData* full = this->Terrain->GetUsedMesh()->GetOutput();
  this->Draw();
  EXPECT_EQ(full->GetNumberOfPolys(), 2 * 128 * 128);
  this->Terrain->SetTechnique(Techniques::Pyramid);
  this->Draw();
  EXPECT_EQ(full->GetNumberOfPolys(), 0); // its memory is given back
  this->Terrain->SetTechnique(Techniques::Mesh);
  EXPECT_GT(CountDrawn(this->Draw()), 160 * 120 / 6);
}

TEST_F(TerrainActor, StripsAreTheMeshWithinTheTolerance)
{
  this->Terrain->SetTechnique(Techniques::Mesh);
  this->Terrain->SetVerticalExaggeration(1.5);
  this->Terrain->GetStrips()->SetTolerance(0.25);
  for (const double stretch : { 1.0, 20.0 })
  {
    this->Terrain->SetScale(2.0, 2.0 * stretch, 3.0);
    this->Terrain->SetPosition(300.0, -200.0, 40.0);
    this->Terrain->SetOrientation(0.0, 0.0, 5.0);
    const Bounds bounds = this->ActorBounds();
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const double east = 0.5 * (bounds[0] + bounds[1]);
    const double north = 0.5 * (bounds[2] + bounds[3]);
    camera->SetPosition(east, north - 500.0, bounds[5] + 300.0);
    camera->SetFocalPoint(east, north + 500.0, bounds[4]);
    camera->SetViewAngle(70.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Terrain->SetTechnique(Techniques::Mesh);
    const auto mesh = this->Draw();
    this->Terrain->SetTechnique(Techniques::Strips);
    const auto strips = this->Draw();
    EXPECT_GT(CountDrawn(mesh), 160 * 120 / 3);
    EXPECT_LT(
      vtkTerrainTesting::CountDifferentPixels(mesh, strips, 32), 160 * 120 / 50); // silhouettes
    EXPECT_LT(this->Terrain->GetStrips()->GetNumberOfTriangles(), 2 * 128 * 128);
    EXPECT_EQ(this->ActorBounds(), bounds); // of all of it, not of what the camera sees
  }
}

// What an actor does to the heights is done to the camera instead.
TEST_F(TerrainActor, StripsFollowTheCamera)
{
  this->Heights->SetOrigin(0.0, 0.0, 50.0);
  this->Terrain->SetTechnique(Techniques::Strips);
  this->Terrain->SetVerticalExaggeration(3.0);
  this->Draw();
  const vtkIdType triangles = this->Terrain->GetStrips()->GetNumberOfTriangles();
  EXPECT_GT(triangles, 1000);

  vtkNew<vtkTransform> move;
  move->Translate(1000.0, 5000.0, -300.0);
  move->RotateWXYZ(50.0, 0.2, 0.5, 0.8);
  move->Scale(4.0, 4.0, 4.0);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ApplyTransform(move);
  // as high as before by a scale: 50 + 3 h = 2 (50 + 1.5 h) - 50
  move->Translate(0.0, 0.0, -50.0);
  move->Scale(1.0, 1.0, 2.0);
  this->Terrain->SetUserTransform(move);
  this->Terrain->SetVerticalExaggeration(1.5);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Draw();
  const auto near = [triangles](double count) { return std::abs(count - triangles) <= 4.0; };
  EXPECT_PRED1(near, this->Terrain->GetStrips()->GetNumberOfTriangles()); // rounding

  camera->Dolly(0.25);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Draw();
  EXPECT_LT(2 * this->Terrain->GetStrips()->GetNumberOfTriangles(), triangles);
}

// A small island may be no triangle at all, and must not be gone for good: nothing is drawn of what
// has no bounds.
TEST_F(TerrainActor, StripsComeBackFromNothing)
{
  vtkDataArray* scalars = this->Heights->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    const bool isIsland = id % 129 > 90 && id % 129 < 110 && id / 129 > 90 && id / 129 < 110;
    scalars->SetComponent(
      id, 0, isIsland ? scalars->GetComponent(id, 0) : std::numeric_limits<double>::quiet_NaN());
  }
  this->Terrain->SetTechnique(Techniques::Strips);
  const int drawn = CountDrawn(this->Draw());
  EXPECT_GT(drawn, 30);
  const Bounds bounds = this->ActorBounds();
  this->Terrain->GetStrips()->SetTolerance(20.0);
  this->Draw();
  EXPECT_EQ(this->Terrain->GetStrips()->GetNumberOfTriangles(), 0);
  EXPECT_EQ(this->ActorBounds(), bounds);
  this->Terrain->GetStrips()->SetTolerance(1.0);
  EXPECT_EQ(CountDrawn(this->Draw()), drawn);
}

// A prepared file: Strips draws it alone, as the heights that it was made of; other techniques read
// it as an image.
TEST_F(TerrainActor, DrawsPreparedFiles)
{
  this->Heights->SetOrigin(0.0, 0.0, 50.0);
  this->Terrain->SetVerticalExaggeration(2.0);
  this->Terrain->SetScale(1.0, 1.0, 1.5);
  this->Terrain->GetStrips()->SetTolerance(0.25);
  this->Terrain->SetTechnique(Techniques::Strips);
  this->LookFromSouth();
  const auto strips = this->Draw();
  const vtkIdType triangles = this->Terrain->GetStrips()->GetNumberOfTriangles();
  this->Terrain->SetTechnique(Techniques::Pyramid);
  const auto rays = this->Draw();
  const Bounds bounds = this->ActorBounds();
  EXPECT_GT(CountDrawn(strips), 160 * 120 / 6);

  const std::string path = vtkTerrainTesting::OutputPath("prepared.any");
  vtkNew<vtkTerrainHierarchy> hierarchy;
  ASSERT_TRUE(hierarchy->SetHeights(this->Heights));
  ASSERT_TRUE(hierarchy->WriteFile(path)) << hierarchy->GetErrorMessage();
  this->Terrain->SetTechnique(Techniques::Strips);
  ASSERT_TRUE(this->Terrain->SetFileName(path));
  EXPECT_TRUE(this->Terrain->HasSurface());
  const auto alone = this->Draw();
  EXPECT_EQ(this->Terrain->GetHeights(), nullptr) << "the file is not read";
  EXPECT_EQ(this->Terrain->GetStrips()->GetNumberOfTriangles(), triangles);
  EXPECT_LT(vtkTerrainTesting::CountDifferentPixels(alone, strips, 48), 160 * 120 / 50);
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(this->ActorBounds()[i], bounds[i], 1e-3) << i;
  }
  this->Terrain->SetTechnique(Techniques::Pyramid);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), rays, 0), 0);
  EXPECT_NE(this->Terrain->GetHeights(), nullptr);
  this->Terrain->SetTechnique(Techniques::Strips);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), alone, 0), 0);
  this->Terrain->SetInputData(this->Heights); // beside the hierarchy: lit and coloured as rays are
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), strips, 0), 0);
}

TEST_F(TerrainActor, SaysWhyPreparedHeightsCannotBeDrawn)
{
  const std::string path = vtkTerrainTesting::OutputPath("damaged.any");
  vtkNew<vtkTerrainHierarchy> hierarchy;
  ASSERT_TRUE(hierarchy->SetHeights(this->Heights));
  ASSERT_TRUE(hierarchy->WriteFile(path)) << hierarchy->GetErrorMessage();
  std::filesystem::resize_file(path, 5000);
  vtkNew<vtkTest::ErrorObserver> errors;
  this->Terrain->AddObserver(vtkCommand::ErrorEvent, errors);
  EXPECT_FALSE(this->Terrain->SetFileName(path));
  EXPECT_NE(errors->GetErrorMessage().find("5000 bytes"), std::string::npos)
    << errors->GetErrorMessage();
  errors->Clear();
  this->Terrain->SetInputData(nullptr);
  this->Terrain->SetHierarchy(hierarchy);
  this->Draw();
  EXPECT_NE(errors->GetErrorMessage().find("SetFileName"), std::string::npos);
  errors->Clear();
  this->Terrain->SetTechnique(Techniques::Strips);
  EXPECT_GT(CountDrawn(this->Draw()), 160 * 120 / 6);
  EXPECT_FALSE(errors->GetError());
}

TEST_F(TerrainActor, ShowsTheCoarseMeshAsWireframe)
{
  this->Terrain->GetCoarseMesh()->SetCellsPerQuad(32);
  const int surface = CountDrawn(this->Draw());
  this->Terrain->GetProperty()->SetRepresentationToWireframe();
  const int wires = CountDrawn(this->Draw());
  EXPECT_GT(wires, surface / 20);
  EXPECT_LT(wires, 3 * surface / 4);
  EXPECT_EQ(
    this->Terrain->GetTerrainMapper()->GetInput(), this->Terrain->GetCoarseMesh()->GetOutput());
  this->Terrain->GetProperty()->SetRepresentationToSurface();
  EXPECT_EQ(CountDrawn(this->Draw()), surface);
}

TEST_F(TerrainActor, ColoursFollowTheHeights)
{
  this->Draw();
  double range[2];
  this->Heights->GetScalarRange(range);
  EXPECT_DOUBLE_EQ(this->Terrain->GetLookupTable()->GetRange()[1], range[1]);
  ScaleHeights(this->Heights, 3.0);
  this->Draw();
  EXPECT_NEAR(this->Terrain->GetLookupTable()->GetRange()[1], 3.0 * range[1], 1e-3 * range[1]);

  vtkNew<vtkColorTransferFunction> red;
  red->AddRGBPoint(range[0], 1.0, 0.0, 0.0);
  red->AddRGBPoint(3.0 * range[1], 1.0, 0.0, 0.0);
  this->Terrain->SetLookupTable(red);
  EXPECT_EQ(this->Terrain->GetLookupTable(), red.Get());
  const auto picture = this->Draw();
  this->Terrain->SetColorByHeight(false);
  this->Terrain->GetProperty()->SetColor(1.0, 0.0, 0.0);
  EXPECT_LE(vtkTerrainTesting::CountDifferentPixels(this->Draw(), picture, 2), 2);
  this->Terrain->SetLookupTable(nullptr);
  this->Terrain->SetColorByHeight(true);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(this->Draw(), picture, 30), 1000);
}

// A scalar bar has the colours of the terrain, also after the heights have changed.
TEST_F(TerrainActor, ScalarBarHasItsColours)
{
  this->Draw();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(this->Terrain->GetLookupTable());
  bar->SetMaximumNumberOfColors(256);
  this->Scene.Renderer->AddViewProp(bar);
  for (const double factor : { 1.0, 3.0 })
  {
    ScaleHeights(this->Heights, factor);
    this->Draw(); // VTK makes the bar of the table that the frame before left
    const auto picture = this->Draw();
    int rectangle[4];
    bar->GetScalarBarRect(rectangle, this->Scene.Renderer);
    const auto place = [&rectangle](double share, int side)
    { return static_cast<int>(rectangle[side] + share * rectangle[side + 2]); };
    double range[2];
    this->Heights->GetScalarRange(range);
    for (const double share : { 0.1, 0.5, 0.9 })
    {
      double color[3];
      vtkTerrainActor::MakeReliefColors(range[0], range[1])
        ->GetColor(range[0] + share * (range[1] - range[0]), color);
      const auto* pixel =
        static_cast<unsigned char*>(picture->GetScalarPointer(place(0.5, 0), place(share, 1), 0));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(pixel[c], 255.0 * color[c], 6.0) << factor << " " << share;
      }
    }
    EXPECT_NEAR(bar->GetLookupTable()->GetRange()[1], range[1], 1e-3 * range[1]);
  }
}

TEST_F(TerrainActor, ReliefColorsAreBlueBelowTheSea)
{
  double color[3];
  vtkTerrainActor::MakeReliefColors(-1000.0, 1000.0)->GetColor(-500.0, color);
  EXPECT_GT(color[2], color[0]);
  vtkTerrainActor::MakeReliefColors(-20.0, 1000.0)->GetColor(-10.0, color);
  EXPECT_GT(color[1], color[2]);
  vtkTerrainActor::MakeReliefColors(5.0, 5.0)->GetColor(5.0, color);
  EXPECT_GT(color[1], color[2]);
}

TEST_F(TerrainActor, HasASurfaceWhereFourNeighboursHaveHeights)
{
  EXPECT_TRUE(this->Terrain->HasSurface());
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(3, 3, 1);
  heights->AllocateScalars(VTK_FLOAT, 1);
  heights->GetPointData()->GetScalars()->Fill(1.0);
  heights->GetPointData()->GetScalars()->SetComponent(4, 0, vtkMath::Nan());
  this->Terrain->SetInputData(heights);
  EXPECT_FALSE(this->Terrain->HasSurface());
  vtkNew<vtkTerrainActor> none;
  EXPECT_FALSE(none->HasSurface());
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(none->GetBounds()));
}

// Bounds and the clipping range must hold for the very next frame.
TEST_F(TerrainActor, BoundsFollowEveryChange)
{
  this->Draw();
  const Bounds before = this->ActorBounds();
  this->Terrain->SetVerticalExaggeration(3.0);
  EXPECT_DOUBLE_EQ(this->ActorBounds()[5], 3.0 * before[5]);
  this->Scene.Renderer->ResetCameraClippingRange();
  const int tall = CountDrawn(this->Draw());
  ScaleHeights(this->Heights, 0.5);
  EXPECT_NEAR(this->ActorBounds()[5], 1.5 * before[5], 1e-3 * before[5]);
  this->Terrain->SetTechnique(Techniques::Equidistant);
  EXPECT_NEAR(this->ActorBounds()[5], 1.5 * before[5], 1e-3 * before[5]);
  this->Scene.Renderer->ResetCameraClippingRange();
  EXPECT_LT(CountDrawn(this->Draw()), tall);
  const auto larger = MakeHeights(65);
  larger->SetOrigin(-1e5, 2e5, 0.0);
  larger->SetSpacing(1000.0, 500.0, 1.0);
  this->Terrain->SetInputData(larger);
  const Bounds after = this->ActorBounds();
  EXPECT_DOUBLE_EQ(after[0], -1e5);
  EXPECT_DOUBLE_EQ(after[1], -1e5 + 64.0 * 1000.0);
  EXPECT_DOUBLE_EQ(after[3], 2e5 + 64.0 * 500.0);
  this->LookFromSouth();
  EXPECT_GT(CountDrawn(this->Draw()), 160 * 120 / 8);
}

// What a change costs: uploads of heights, builds of shaders and of vertex buffers.
// Points at the samples' true heights: where the terrain has them, exaggerated, turned and shifted.
TEST_F(TerrainActor, PlacesOthersAsItDraws)
{
  this->Heights->SetOrigin(5.0, 6.0, 700.0);
  this->Terrain->SetVerticalExaggeration(3.0);
  vtkNew<vtkActor> other;
  other->SetPosition(1.0, 2.0, 3.0); // which no longer counts
  other->SetScale(7.0, 7.0, 7.0);
  this->Terrain->PlaceAsDrawn(other);
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> samples;
  vtkNew<vtkCellArray> vertices;
  vtkDataArray* heights = this->Heights->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < this->Heights->GetNumberOfPoints(); ++id)
  {
    const double* sample = this->Heights->GetPoint(id);
    samples->InsertNextPoint(sample[0], sample[1], sample[2] + heights->GetComponent(id, 0));
    vertices->InsertNextCell(1, &id);
  }
  points->SetPoints(samples);
  points->SetVerts(vertices);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(points);
  other->SetMapper(mapper);
  for (int axis = 0; axis < 6; ++axis)
  {
    EXPECT_NEAR(other->GetBounds()[axis], this->Terrain->GetBounds()[axis], 1e-3) << axis;
  }
  this->Terrain->SetOrientation(0.0, 0.0, 90.0);
  this->Terrain->SetPosition(30.0, 40.0, 50.0);
  this->Terrain->PlaceAsDrawn(other);
  for (int axis = 0; axis < 6; ++axis)
  {
    EXPECT_NEAR(other->GetBounds()[axis], this->Terrain->GetBounds()[axis], 1e-3) << axis;
  }
  this->Terrain->PlaceAsDrawn(other, 0.0);
  EXPECT_NEAR(other->GetBounds()[5], this->Terrain->GetBounds()[5] + 2.0 * 700.0, 1e-3);
}

// On a globe there is no mesh of the surface, and no matrix that exaggerates.
TEST_F(TerrainActor, HasNoMeshOfAGlobe)
{
  EXPECT_NE(this->Terrain->GetSurfaceActor(), nullptr);
  this->Heights->SetSpacing(0.5, 0.5, 1.0);
  const vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(this->Heights);
  this->Terrain->SetInputConnection(globe->GetOutputPort());
  EXPECT_EQ(this->Terrain->GetSurfaceActor(), nullptr);
  EXPECT_EQ(this->Terrain->GetSurface(), nullptr);
  vtkNew<vtkActor> other;
  this->Terrain->SetPosition(30.0, 40.0, 50.0);
  this->Terrain->PlaceAsDrawn(other);
  EXPECT_EQ(other->GetUserMatrix()->GetElement(2, 2), 1.0);
  EXPECT_EQ(other->GetUserMatrix()->GetElement(2, 3), 50.0);
  this->Terrain->SetVerticalExaggeration(3.0);
  const vtkNew<vtkTest::ErrorObserver> errors;
  this->Terrain->AddObserver(vtkCommand::ErrorEvent, errors);
  this->Terrain->PlaceAsDrawn(other);
  EXPECT_NE(errors->GetErrorMessage().find("globe"), std::string::npos);
  EXPECT_EQ(other->GetUserMatrix()->GetElement(2, 2), 1.0);
}

TEST_F(TerrainActor, BuildsOnlyWhatChanged)
{
  vtkOpenGLTerrainMapper* mapper = this->Terrain->GetTerrainMapper();
  std::array<int, 3> last{};
  const auto costs = [&](const std::function<void()>& change)
  {
    change();
    this->Draw();
    const std::array<int, 3> now{ mapper->GetNumberOfHeightUploads(),
      mapper->GetNumberOfShaderBuilds(), mapper->GetNumberOfBufferBuilds() };
    const std::array<int, 3> cost{ now[0] - last[0], now[1] - last[1], now[2] - last[2] };
    last = now;
    return cost;
  };
  using Costs = std::array<int, 3>;
  EXPECT_EQ(costs([] {}), (Costs{ 1, 1, 1 }));
  EXPECT_EQ(costs([] {}), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(
    costs([&] { this->Scene.Renderer->GetActiveCamera()->Azimuth(3.0); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { this->Terrain->SetPosition(0.0, 0.0, 10.0); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { this->Terrain->SetVerticalExaggeration(0.7); }), (Costs{ 0, 0, 0 }));
  // colours are uniforms
  using ColorSources = vtkOpenGLTerrainMapper::ColorSources;
  EXPECT_EQ(costs([&] { mapper->SetShowCrossings(true); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetMaximumShownCrossings(20); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetShowCrossings(false); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetContours(true); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetHillshade(true); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetColorSource(ColorSources::Slope); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetColorSource(ColorSources::Aspect); }), (Costs{ 0, 0, 0 }));
  EXPECT_EQ(costs([&] { mapper->SetColorSource(ColorSources::Height); }), (Costs{ 0, 0, 0 }));
  // what VTK notices makes it write the text of the shader again, which may be the same
  EXPECT_EQ(costs([&] { this->Terrain->SetColorByHeight(false); })[0], 0);
  EXPECT_EQ(costs([&] { this->Terrain->SetColorByHeight(true); })[0], 0);
  EXPECT_EQ(costs([&] { this->Terrain->GetProperty()->SetDiffuse(0.9); })[0], 0);
  for (const Techniques technique : { Techniques::Linear, Techniques::Exponential,
         Techniques::Equidistant, Techniques::Mesh, Techniques::Pyramid })
  {
    EXPECT_EQ(costs([&] { this->Terrain->SetTechnique(technique); })[0], 0);
    EXPECT_EQ(costs([] {}), (Costs{ 0, 0, 0 }));
  }
  // the box around the heights changes with them
  EXPECT_EQ(costs([&] { ScaleHeights(this->Heights, 1.01); }), (Costs{ 1, 1, 1 }));
}

// Frames in haste are drawn coarser, the next one with time exactly again.
TEST_F(TerrainActor, IsCoarseInHasteAndExactWhenStill)
{
  const auto exact = this->Draw();
  this->Scene.Window->SetDesiredUpdateRate(1e9); // never met
  for (const double tolerance : { 2.0, 4.0, 8.0, 16.0, 16.0 })
  {
    this->Draw();
    EXPECT_DOUBLE_EQ(this->Terrain->GetInteractionTolerance(), tolerance);
  }
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(this->Draw(), exact, 2), 100);
  EXPECT_DOUBLE_EQ(this->Terrain->GetTerrainMapper()->GetPixelTolerance(), 0.0);
  this->Scene.Window->SetDesiredUpdateRate(1e-4);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), exact), 0);
  this->Scene.Window->SetDesiredUpdateRate(1e9);
  this->Terrain->SetLevelOfDetail(false);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), exact), 0);
}

TEST_F(TerrainActor, CopiesShareEverything)
{
  this->Terrain->SetTechnique(Techniques::Equidistant);
  const auto picture = this->Draw();
  vtkNew<vtkTerrainActor> copy;
  copy->ShallowCopy(this->Terrain);
  EXPECT_EQ(copy->GetMapper(), this->Terrain->GetMapper());
  EXPECT_EQ(copy->GetTerrainMapper(), this->Terrain->GetTerrainMapper());
  this->Scene.Renderer->RemoveActor(this->Terrain);
  this->Scene.Renderer->AddActor(copy);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(this->Draw(), picture), 0);
}
