// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A terrain among other actors: what hides what, and what is seen through what.
#include "vtkTerrainTestingScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <gtest/gtest.h>

#include <string>

using vtkTerrainTesting::Demands;
using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

void AddSpheres(TerrainScene& scene, const TerrainProp&)
{
  scene.AddSphere(120.0, 250.0, 100.0, 40.0);
  scene.AddSphere(250.0, 150.0, 180.0, 25.0);
  scene.AddSphere(330.0, 280.0, 40.0, 30.0);
}

void AddGhosts(TerrainScene& scene, const TerrainProp&)
{
  scene.AddSphere(120.0, 250.0, 100.0, 60.0)->GetProperty()->SetOpacity(0.5);
  scene.AddSphere(250.0, 150.0, 150.0, 50.0)->GetProperty()->SetOpacity(0.3);
}

void MakeGhost(TerrainScene& scene, const TerrainProp& terrain)
{
  terrain.Actor->GetProperty()->SetOpacity(0.5);
  scene.AddSphere(150.0, 200.0, 60.0, 30.0);
}

/// From the side, so that one ridge is seen through the other.
void MakeGhostFromTheSide(TerrainScene& scene, const TerrainProp& terrain)
{
  MakeGhost(scene, terrain);
  terrain.Mapper->SetMaximumLayers(10);
  scene.Look({ 200.0, 900.0, 160.0 }, { 200.0, 190.0, 100.0 });
}

void AddShiftedTerrain(TerrainScene& scene, const TerrainProp&)
{
  const TerrainProp other = scene.AddTerrain(MakeHills());
  other.Actor->GetProperty()->SetColor(0.3, 0.6, 0.9);
  other.Actor->SetPosition(35.0, 20.0, 4.0);
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperDepth, OpaqueActorsMeetTheSurface)
{
  EXPECT_TRUE(DrawsAsTheMesh(AddSpheres));
}

TEST(OpenGLTerrainMapperDepth, OpaqueActorsMeetTheSearchedSurface)
{
  Demands demands;
  demands.Technique = Techniques::Equidistant;
  EXPECT_TRUE(DrawsAsTheMesh(AddSpheres, demands));
}

TEST(OpenGLTerrainMapperDepth, TranslucentActorsMeetTheSurface)
{
  EXPECT_TRUE(DrawsAsTheMesh(AddGhosts));
}

TEST(OpenGLTerrainMapperDepth, TranslucentActorsAreBlended)
{
  EXPECT_TRUE(DrawsAsTheMesh(MakeGhost));
  EXPECT_TRUE(DrawsAsTheMesh(MakeGhostFromTheSide));
}

TEST(OpenGLTerrainMapperDepth, TranslucentActorsArePeeled)
{
  for (bool dual : { false, true })
  {
    auto peel = [dual](TerrainScene& scene, const TerrainProp& terrain)
    {
      MakeGhostFromTheSide(scene, terrain);
      AddGhosts(scene, terrain);
      scene.Window->AlphaBitPlanesOn();
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(16);
      scene.Renderer->SetUseDepthPeelingForVolumes(dual);
      scene.Renderer->SetOcclusionRatio(0.0);
    };
    EXPECT_TRUE(DrawsAsTheMesh(peel)) << dual;
  }
}

TEST(OpenGLTerrainMapperDepth, TerrainsOverlap)
{
  EXPECT_TRUE(DrawsAsTheMesh(AddShiftedTerrain));
}

TEST(OpenGLTerrainMapperDepth, RenderersShareAWindow)
{
  auto split = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    scene.Renderer->SetViewport(0.0, 0.0, 0.45, 1.0);
    vtkNew<vtkRenderer> other;
    other->SetViewport(0.45, 0.3, 1.0, 1.0);
    other->SetBackground(0.1, 0.4, 0.1);
    other->AddActor(terrain.Actor);
    scene.Window->AddRenderer(other);
    scene.AddSphere(200.0, 250.0, 100.0, 60.0);
    other->GetActiveCamera()->SetPosition(-200.0, 700.0, 500.0);
    other->GetActiveCamera()->SetFocalPoint(200.0, 190.0, 80.0);
    other->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    other->ResetCameraClippingRange();
  };
  EXPECT_TRUE(DrawsAsTheMesh(split));
}

TEST(OpenGLTerrainMapperDepth, LayersLieOverOneAnother)
{
  auto layers = [](TerrainScene& scene, const TerrainProp&)
  {
    vtkNew<vtkRenderer> front;
    scene.Window->SetNumberOfLayers(2);
    front->SetLayer(1);
    front->SetActiveCamera(scene.Renderer->GetActiveCamera());
    scene.Window->AddRenderer(front);
    const TerrainProp other = scene.AddTerrain(MakeHills(true));
    scene.Renderer->RemoveActor(other.Actor);
    front->AddActor(other.Actor);
    other.Actor->SetScale(0.5, 0.5, 1.0);
    other.Actor->GetProperty()->SetColor(0.3, 0.6, 0.9);
    scene.Renderer
      ->ResetCameraClippingRange(); // that of both: rays draw before the near plane, too
  };
  EXPECT_TRUE(DrawsAsTheMesh(layers));
}

TEST(OpenGLTerrainMapperDepth, CoincidentSurfacesAreShifted)
{
  auto shift = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    const TerrainProp other = scene.AddTerrain(MakeHills());
    other.Actor->GetProperty()->SetColor(0.3, 0.6, 0.9);
    terrain.Mapper->SetResolveCoincidentTopologyToPolygonOffset();
    terrain.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 8.0);
    other.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -8.0);
  };
  EXPECT_TRUE(DrawsAsTheMesh(shift));
  Demands search;
  search.Technique = Techniques::Equidistant;
  EXPECT_TRUE(DrawsAsTheMesh(shift, search));
  vtkMapper::SetResolveCoincidentTopology(VTK_RESOLVE_OFF);
}

// A depth that is shifted to the eye may lie before the box: early depth tests must not rely on it.
TEST(OpenGLTerrainMapperDepth, ShiftedDepthsAreNotDeclaredGreater)
{
  for (const double offset : { 0.0, -8.0 })
  {
    std::string source;
    auto shift = [&](TerrainScene&, const TerrainProp& terrain)
    {
      terrain.Mapper->SetResolveCoincidentTopologyToPolygonOffset();
      terrain.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, offset);
      vtkNew<vtkCallbackCommand> read;
      read->SetClientData(&source);
      read->SetCallback(
        [](vtkObject*, unsigned long, void* text, void* program)
        {
          *static_cast<std::string*>(text) =
            static_cast<vtkShaderProgram*>(program)->GetFragmentShader()->GetSource();
        });
      terrain.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, read);
    };
    vtkTerrainTesting::DrawScene(shift);
    vtkMapper::SetResolveCoincidentTopology(VTK_RESOLVE_OFF);
    const bool shifted = source.find("#define TERRAIN_DEPTH_OFFSET\n") != std::string::npos;
    EXPECT_NE(source.find("#define TERRAIN_BELOW_BOX\n"), std::string::npos);
    EXPECT_EQ(shifted, offset != 0.0);
  }
}

TEST(OpenGLTerrainMapperDepth, ParallelProjection)
{
  auto parallel = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    AddSpheres(scene, terrain);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(200.0);
    scene.Renderer->ResetCameraClippingRange();
  };
  EXPECT_TRUE(DrawsAsTheMesh(parallel));
}

TEST(OpenGLTerrainMapperDepth, ActorsAreTurnedMirroredAndScaled)
{
  for (double mirror : { 1.0, -1.0 })
  {
    auto turn = [mirror](TerrainScene& scene, const TerrainProp& terrain)
    {
      terrain.Actor->SetOrigin(200.0, 190.0, 100.0);
      terrain.Actor->SetOrientation(8.0, -12.0, 40.0);
      terrain.Actor->SetScale(0.8 * mirror, 0.7, 1.5);
      scene.Renderer->ResetCameraClippingRange();
    };
    EXPECT_TRUE(DrawsAsTheMesh(turn)) << mirror;
  }
}

TEST(OpenGLTerrainMapperDepth, UserMatrix)
{
  auto shear = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(0, 1, 0.3);
    matrix->SetElement(2, 0, 0.2);
    matrix->SetElement(2, 2, -0.8);
    matrix->SetElement(2, 3, 150.0);
    terrain.Actor->SetUserMatrix(matrix);
    terrain.Mapper->SetVerticalExaggeration(1.3);
    scene.Renderer->ResetCameraClippingRange();
  };
  EXPECT_TRUE(DrawsAsTheMesh(shear));
}

TEST(OpenGLTerrainMapperDepth, ComputedSightingsHaveLayersToo)
{
  auto compute = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    MakeGhostFromTheSide(scene, terrain);
    terrain.Mapper->SetComputeMode(vtkOpenGLTerrainMapper::ComputeModes::On);
  };
  EXPECT_TRUE(DrawsAsTheMesh(compute));
}
