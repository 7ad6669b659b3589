// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A terrain in VTK's render passes.
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDoubleArray.h"
#include "vtkEDLShading.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTranslucentPass.h"
#include "vtkValuePass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::MakeFineMesh;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
void AddSpheres(TerrainScene& scene)
{
  scene.AddSphere(120.0, 250.0, 150.0, 30.0);
  scene.AddSphere(280.0, 180.0, 170.0, 25.0);
}

/// Sets a pass whose delegate is all that VTK does by default.
template <typename Pass>
void SetPassOverSteps(TerrainScene& scene, Pass* pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  scene.Renderer->SetPass(pass);
}

void CastShadows(TerrainScene& scene, bool positional)
{
  AddSpheres(scene);
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
    { CastShadows(scene, positional); };
    EXPECT_TRUE(DrawsAsTheMesh(cast)) << positional;
  }
}

TEST(OpenGLTerrainMapperPasses, AmbientOcclusion)
{
  auto occlude = [](TerrainScene& scene, const TerrainProp&)
  {
    AddSpheres(scene);
    vtkNew<vtkSSAOPass> pass;
    pass->SetRadius(40.0);
    pass->SetBias(1.0);
    pass->SetKernelSize(32);
    pass->BlurOn();
    SetPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(occlude));
}

TEST(OpenGLTerrainMapperPasses, FastAntialiasing)
{
  auto smooth = [](TerrainScene& scene, const TerrainProp&)
  {
    AddSpheres(scene);
    scene.Renderer->UseFXAAOn();
  };
  EXPECT_TRUE(DrawsAsTheMesh(smooth));
}

TEST(OpenGLTerrainMapperPasses, Supersampling)
{
  auto smooth = [](TerrainScene& scene, const TerrainProp&)
  {
    AddSpheres(scene);
    vtkNew<vtkSSAAPass> pass;
    SetPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(smooth));
}

TEST(OpenGLTerrainMapperPasses, DepthOfField)
{
  auto blur = [](TerrainScene& scene, const TerrainProp&)
  {
    AddSpheres(scene);
    vtkNew<vtkDepthOfFieldPass> pass;
    pass->AutomaticFocalDistanceOff();
    scene.Renderer->GetActiveCamera()->SetFocalDisk(20.0);
    SetPassOverSteps(scene, pass.Get());
    scene.Window->Render(); // the first frame of this pass is black, whatever the scene
  };
  EXPECT_TRUE(DrawsAsTheMesh(blur));
}

TEST(OpenGLTerrainMapperPasses, EyeDomeLighting)
{
  auto light = [](TerrainScene& scene, const TerrainProp&)
  {
    AddSpheres(scene);
    vtkNew<vtkEDLShading> pass;
    SetPassOverSteps(scene, pass.Get());
  };
  EXPECT_TRUE(DrawsAsTheMesh(light));
}

TEST(OpenGLTerrainMapperPasses, Steps)
{
  auto draw = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    AddSpheres(scene);
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
    AddSpheres(scene);
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

namespace
{
/// What a value pass reads of "ramp" from a terrain with a hole in that array, drawn by rays or as
/// triangles by VTK's own mapper.
vtkSmartPointer<vtkFloatArray> ReadValues(bool rays)
{
  TerrainScene scene(vtkOpenGLTerrainMapper::Techniques::Pyramid);
  const auto heights = MakeHills();
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetName("ramp");
  for (vtkIdType i = 0; i < heights->GetNumberOfPoints(); ++i)
  {
    const double* position = heights->GetPoint(i);
    const bool none = std::hypot(position[0] - 150.0, position[1] - 150.0) < 40.0;
    ramp->InsertNextValue(none ? std::numeric_limits<double>::quiet_NaN()
                               : 1000.0 + position[0] + 0.01 * position[0] * position[1]);
  }
  heights->GetPointData()->AddArray(ramp);
  const TerrainProp terrain = scene.AddTerrain(heights);
  vtkNew<vtkTerrainCoarseMesh> coarse;
  coarse->SetInputData(heights);
  coarse->PassPointArraysOn();
  terrain.Mapper->SetInputConnection(coarse->GetOutputPort());
  terrain.Mapper->SetScalarModeToUsePointFieldData();
  terrain.Mapper->SelectColorArray("ramp");
  if (!rays)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeFineMesh(heights));
    terrain.Actor->SetMapper(mapper);
  }
  vtkNew<vtkValuePass> pass;
  pass->SetInputArrayToProcess(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "ramp");
  pass->SetInputComponentToProcess(0);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  scene.Renderer->SetPass(camera);
  scene.Renderer->ResetCameraClippingRange();
  scene.Window->Render();
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->DeepCopy(pass->GetFloatImageDataArray(scene.Renderer));
  pass->ReleaseGraphicsResources(scene.Window);
  return values;
}
}

TEST(OpenGLTerrainMapperPasses, Values)
{
  const auto rays = ReadValues(true);
  const auto mesh = ReadValues(false);
  ASSERT_EQ(rays->GetNumberOfValues(), mesh->GetNumberOfValues());
  int shown = 0;
  int gaps = 0;
  int wrong = 0;
  const int width = 200;
  ASSERT_EQ(rays->GetNumberOfValues() % width, 0);
  const int height = static_cast<int>(rays->GetNumberOfValues()) / width;
  const auto isSame = [](float a, float b)
  { return std::isnan(a) ? std::isnan(b) : std::abs(a - b) < 2.0f; };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const float value = mesh->GetValue(x + width * y);
      shown += value > 900.0f ? 1 : 0;
      gaps += std::isnan(value) ? 1 : 0;
      // at edges: what the mesh shows in a pixel beside
      bool isThere = false;
      for (int k = 0; k < 9; ++k)
      {
        const int i = std::clamp(x + k % 3 - 1, 0, width - 1);
        const int j = std::clamp(y + k / 3 - 1, 0, height - 1);
        isThere = isThere || isSame(rays->GetValue(x + width * y), mesh->GetValue(i + width * j));
      }
      wrong += isThere ? 0 : 1;
    }
  }
  EXPECT_GT(shown, rays->GetNumberOfValues() / 4);
  EXPECT_GT(gaps, 20);
  EXPECT_EQ(wrong, 0);
}
