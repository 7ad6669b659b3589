// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A terrain under VTK's lights and materials.
#include "vtkTerrainTestingScene.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

#include <cmath>

using vtkTerrainTesting::Demands;
using vtkTerrainTesting::DrawsAsStock;
using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
enum class Kinds
{
  Head,
  Camera,
  Sun,
  Bulb,
  Spot,
  Count
};

void AddLight(TerrainScene& scene, Kinds kind, double east = 700.0)
{
  vtkNew<vtkLight> light;
  if (kind == Kinds::Head)
  {
    light->SetLightTypeToHeadlight();
  }
  else if (kind == Kinds::Camera)
  {
    light->SetLightTypeToCameraLight();
    light->SetPosition(0.8, 0.6, 0.5);
  }
  else
  {
    light->SetLightTypeToSceneLight();
    light->SetPosition(east, 400.0, 300.0);
    light->SetFocalPoint(200.0, 190.0, 100.0);
    light->SetPositional(kind != Kinds::Sun);
    light->SetConeAngle(kind == Kinds::Spot ? 12.0 : 90.0);
    light->SetExponent(kind == Kinds::Spot ? 3.0 : 1.0);
    light->SetAttenuationValues(
      kind == Kinds::Bulb ? 0.3 : 1.0, kind == Kinds::Bulb ? 0.002 : 0.0, 0.0);
  }
  light->SetColor(1.0, 0.9, 0.7);
  scene.Renderer->AddLight(light);
}

void Shine(const TerrainProp& terrain)
{
  terrain.Actor->GetProperty()->SetSpecular(0.5);
  terrain.Actor->GetProperty()->SetSpecularPower(15.0);
}

/// A sky that is bright in the east and above.
vtkSmartPointer<vtkTexture> MakeSky()
{
  constexpr int width = 64;
  constexpr int height = 32;
  vtkNew<vtkFloatArray> texels;
  texels->SetNumberOfComponents(3);
  texels->SetNumberOfTuples(vtkIdType{ width } * height);
  for (int i = 0; i < width * height; ++i)
  {
    const double around = 0.5 + 0.5 * std::cos(6.28 * (i % width) / width);
    const int row = i / width;
    const double up = static_cast<double>(row) / height;
    texels->SetTuple3(i, around, 0.5 * up + 0.3 * around, up);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(texels);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperLights, EveryKindOfLight)
{
  for (int kind = 0; kind < static_cast<int>(Kinds::Count); ++kind)
  {
    auto light = [kind](TerrainScene& scene, const TerrainProp& terrain)
    {
      AddLight(scene, static_cast<Kinds>(kind));
      Shine(terrain);
    };
    EXPECT_TRUE(DrawsAsTheMesh(light)) << kind;
  }
}

// The comparison itself: rays under a sun two degrees lower than that of the stock mapper.
TEST(OpenGLTerrainMapperLights, ASunTwoDegreesOffIsSeen)
{
  for (const double off : { 0.0, 2.0 })
  {
    auto light = [off](TerrainScene& scene, const TerrainProp& terrain)
    {
      const bool casts =
        terrain.Mapper->GetTechnique() == vtkOpenGLTerrainMapper::Techniques::Pyramid;
      const double up = vtkMath::RadiansFromDegrees(35.0 - (casts ? off : 0.0));
      vtkNew<vtkLight> sun;
      sun->SetLightTypeToSceneLight();
      sun->SetPosition(std::cos(up), 0.0, std::sin(up));
      scene.Renderer->AddLight(sun);
    };
    EXPECT_EQ(DrawsAsStock(light), off == 0.0) << off;
  }
}

TEST(OpenGLTerrainMapperLights, ManyLights)
{
  auto light = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    for (int i = 0; i < 7; ++i)
    {
      AddLight(scene, i % 2 == 0 ? Kinds::Spot : Kinds::Bulb, 200.0 * i - 300.0);
    }
    Shine(terrain);
  };
  EXPECT_TRUE(DrawsAsTheMesh(light));
}

// Where a coarse mesh is seen over a ridge, it is not lit as the far slope below it: stock VTK's
// flat shading of the same triangles tells how light they are.
TEST(OpenGLTerrainMapperLights, RidgesOfCoarseMeshesHaveNoDarkRims)
{
  TerrainScene scene(vtkOpenGLTerrainMapper::Techniques::Mesh);
  vtkNew<vtkFloatArray> samples;
  for (int i = 0; i < 65 * 65; ++i)
  {
    samples->InsertNextValue(static_cast<float>(9.0 * std::abs((i / 65) % 16 - 8.0)));
  }
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(65, 65, 1);
  heights->SetSpacing(10.0, 10.0, 1.0);
  heights->GetPointData()->SetScalars(samples);
  const TerrainProp terrain = scene.AddTerrain(heights);
  vtkNew<vtkTerrainCoarseMesh> mesh;
  mesh->SetInputData(heights);
  mesh->SetCellsPerQuad(5);
  mesh->Update();
  terrain.Mapper->SetInputConnection(mesh->GetOutputPort());
  scene.Look({ 320.0, 1100.0, 190.0 }, { 320.0, 320.0, 40.0 });
  vtkNew<vtkLight> sun; // low, behind the viewer: it lights near slopes and leaves far ones dark
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(320.0, 1100.0, 350.0);
  sun->SetFocalPoint(320.0, 320.0, 40.0);
  scene.Renderer->AddLight(sun);
  scene.Window->Render();
  const auto ours = vtkTerrainTesting::ReadColor(scene.Window);
  terrain.Actor->VisibilityOff();
  vtkNew<vtkPolyDataMapper> stock;
  stock->SetInputConnection(mesh->GetOutputPort());
  vtkNew<vtkActor> triangles;
  triangles->SetMapper(stock);
  triangles->SetProperty(terrain.Actor->GetProperty());
  triangles->GetProperty()->SetInterpolationToFlat();
  scene.Renderer->AddActor(triangles);
  scene.Window->Render();
  const auto flat = vtkTerrainTesting::ReadColor(scene.Window);
  vtkTerrainTesting::WritePicture(ours, vtkTerrainTesting::OutputPath("ridges-ours.png"));
  vtkTerrainTesting::WritePicture(flat, vtkTerrainTesting::OutputPath("ridges-flat.png"));
  const auto* a = static_cast<const unsigned char*>(ours->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(flat->GetScalarPointer());
  int lit = 0;
  int dark = 0;
  for (vtkIdType i = 0; i < 3 * ours->GetNumberOfPoints(); i += 3)
  {
    lit += b[i] > 100 ? 1 : 0;
    dark += b[i] > 100 && a[i] < b[i] / 4 ? 1 : 0;
  }
  EXPECT_GT(lit, 1000);
  EXPECT_EQ(dark, 0);
}

TEST(OpenGLTerrainMapperLights, FlatPatches)
{
  auto flatten = [](TerrainScene&, const TerrainProp& terrain)
  { terrain.Actor->GetProperty()->SetInterpolationToFlat(); };
  Demands demands;
  demands.Share = 0.995; // a stock mapper's triangles, a sixth of a cell, do not end at all creases
  EXPECT_TRUE(DrawsAsStock(flatten, demands));
  demands = Demands();
  demands.StockMean = 0.0;
  EXPECT_TRUE(DrawsAsTheMesh(flatten, demands));
}

TEST(OpenGLTerrainMapperLights, FromBelow)
{
  for (bool back : { false, true })
  {
    auto lookUp = [back](TerrainScene& scene, const TerrainProp& terrain)
    {
      if (back)
      {
        vtkNew<vtkProperty> property;
        property->SetColor(0.2, 0.4, 0.9);
        terrain.Actor->SetBackfaceProperty(property);
      }
      AddLight(scene, Kinds::Sun);
      scene.Look({ 200.0, 500.0, -300.0 }, { 200.0, 190.0, 80.0 });
    };
    EXPECT_TRUE(DrawsAsTheMesh(lookUp)) << back;
  }
}

TEST(OpenGLTerrainMapperLights, AmbientOnly)
{
  for (bool lighting : { false, true })
  {
    auto dim = [lighting](TerrainScene&, const TerrainProp& terrain)
    {
      terrain.Actor->GetProperty()->SetLighting(lighting);
      terrain.Actor->GetProperty()->SetDiffuse(0.0);
      terrain.Actor->GetProperty()->SetAmbient(0.7);
    };
    EXPECT_TRUE(DrawsAsTheMesh(dim)) << lighting;
  }
}

TEST(OpenGLTerrainMapperLights, PhysicallyBased)
{
  for (double coat : { 0.0, 0.7 })
  {
    auto render = [coat](TerrainScene& scene, const TerrainProp& terrain)
    {
      AddLight(scene, Kinds::Sun);
      terrain.Actor->GetProperty()->SetInterpolationToPBR();
      terrain.Actor->GetProperty()->SetMetallic(0.4);
      terrain.Actor->GetProperty()->SetRoughness(0.35);
      terrain.Actor->GetProperty()->SetCoatStrength(coat);
      terrain.Actor->GetProperty()->SetCoatRoughness(0.2);
    };
    EXPECT_TRUE(DrawsAsTheMesh(render)) << coat;
  }
}

TEST(OpenGLTerrainMapperLights, EnvironmentLight)
{
  auto render = [](TerrainScene& scene, const TerrainProp& terrain)
  {
    terrain.Actor->GetProperty()->SetInterpolationToPBR();
    terrain.Actor->GetProperty()->SetMetallic(0.5);
    terrain.Actor->GetProperty()->SetRoughness(0.4);
    scene.Renderer->UseImageBasedLightingOn();
    scene.Renderer->SetEnvironmentTexture(MakeSky());
    scene.Renderer->SetEnvironmentUp(0.0, 0.0, 1.0);
    scene.Renderer->SetEnvironmentRight(1.0, 0.0, 0.0);
  };
  EXPECT_TRUE(DrawsAsTheMesh(render));
}
