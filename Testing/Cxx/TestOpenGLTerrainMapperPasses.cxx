// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A terrain in VTK's render passes.
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkEDLShading.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
void addSpheres(TerrainScene& scene)
{
  scene.AddSphere(120.0, 250.0, 150.0, 30.0);
  scene.AddSphere(280.0, 180.0, 170.0, 25.0);
}

/// Sets a pass whose delegate is all that VTK does by default.
template <typename Pass>
void setPassOverSteps(TerrainScene& scene, Pass* pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  scene.Renderer->SetPass(pass);
}

void castShadows(TerrainScene& scene, bool positional)
{
  addSpheres(scene);
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(900.0, 500.0, 420.0);
  sun->SetFocalPoint(200.0, 190.0, 100.0);
  sun->SetPositional(positional);
  sun->SetConeAngle(30.0);
  sun->SetShadowAttenuation(0.8f);
  scene.Renderer->AddLight(sun);
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(512);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  scene.Renderer->SetPass(camera);
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperPasses, ShadowMaps)
{
  for (bool positional : { false, true })
  {
    auto cast = [positional](TerrainScene& scene, const TerrainProp&)
    { castShadows(scene, positional); };
    EXPECT_TRUE(DrawsAsTheMesh(cast)) << positional;
  }
}

TEST(OpenGLTerrainMapperPasses, AmbientOcclusion)
{
  auto occlude = [](TerrainScene& scene, const TerrainProp&)
  {
    addSpheres(scene);
    vtkNew<vtkSSAOPass> pass;
    pass->SetRadius(40.0);
    pass->SetBias(1.0);
    pass->SetKernelSize(32);
    pass->BlurOn();
    setPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(occlude));
}

TEST(OpenGLTerrainMapperPasses, FastAntialiasing)
{
  auto smooth = [](TerrainScene& scene, const TerrainProp&)
  {
    addSpheres(scene);
    scene.Renderer->UseFXAAOn();
  };
  EXPECT_TRUE(DrawsAsTheMesh(smooth));
}

TEST(OpenGLTerrainMapperPasses, Supersampling)
{
  auto smooth = [](TerrainScene& scene, const TerrainProp&)
  {
    addSpheres(scene);
    vtkNew<vtkSSAAPass> pass;
    setPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(smooth));
}

TEST(OpenGLTerrainMapperPasses, DepthOfField)
{
  auto blur = [](TerrainScene& scene, const TerrainProp&)
  {
    addSpheres(scene);
    vtkNew<vtkDepthOfFieldPass> pass;
    pass->AutomaticFocalDistanceOff();
    scene.Renderer->GetActiveCamera()->SetFocalDisk(20.0);
    setPassOverSteps(scene, pass.Get());
    scene.Window->Render(); // the first frame of this pass is black, whatever the scene
  };
  EXPECT_TRUE(DrawsAsTheMesh(blur));
}

TEST(OpenGLTerrainMapperPasses, EyeDomeLighting)
{
  auto light = [](TerrainScene& scene, const TerrainProp&)
  {
    addSpheres(scene);
    vtkNew<vtkEDLShading> pass;
    setPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(light));
}

TEST(OpenGLTerrainMapperPasses, Steps)
{
  auto draw = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    addSpheres(scene);
    terrain.Actor->GetProperty()->SetOpacity(0.6);
    vtkNew<vtkRenderStepsPass> steps;
    scene.Renderer->SetPass(steps);
  };
  EXPECT_TRUE(DrawsAsTheMesh(draw));
}

TEST(OpenGLTerrainMapperPasses, DepthPeeling)
{
  auto peel = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    addSpheres(scene);
    terrain.Actor->GetProperty()->SetOpacity(0.5);
    terrain.Mapper->SetMaximumLayers(8);
    scene.Window->AlphaBitPlanesOn();
    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkDepthPeelingPass> peeling;
    vtkNew<vtkTranslucentPass> translucent;
    peeling->SetTranslucentPass(translucent);
    peeling->SetMaximumNumberOfPeels(12);
    peeling->SetOcclusionRatio(0.0);
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(lights);
    passes->AddItem(opaque);
    passes->AddItem(peeling);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    scene.Renderer->SetPass(camera);
  };
  EXPECT_TRUE(DrawsAsTheMesh(peel));
}

TEST(OpenGLTerrainMapperPasses, SampleShadingSmoothsSilhouettes)
{
  using Techniques = vtkOpenGLTerrainMapper::Techniques;
  auto differences = [](bool shade)
  {
    auto draw = [shade](TerrainScene& scene, const TerrainProp& terrain)
    {
      scene.Window->SetMultiSamples(4);
      terrain.Mapper->SetSampleShading(shade);
    };
    const auto mesh = vtkTerrainTesting::DrawScene(draw, Techniques::Mesh);
    return vtkTerrainTesting::CountDifferentPixels(vtkTerrainTesting::DrawScene(draw), mesh, 24);
  };
  const vtkIdType jagged = differences(false);
  EXPECT_GT(jagged, 100);
  EXPECT_LT(10 * differences(true), jagged);
}
