// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's pickers and selection on a terrain, judged by vtkTerrainPicker.
#include "vtkTerrainTestingScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPropPicker.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTerrainPicker.h"
#include "vtkWorldPointPicker.h"

#include <gtest/gtest.h>

#include <cmath>

using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

class TerrainToPick
{
public:
  TerrainToPick()
    : Scene(Techniques::Pyramid)
    , Terrain(Scene.AddTerrain(MakeHills()))
  {
    this->Sphere = this->Scene.AddSphere(120.0, 250.0, 140.0, 30.0);
    this->Scene.Look({ 200.0, 900.0, 420.0 }, { 200.0, 190.0, 80.0 });
    this->Scene.Window->Render();
  }

  /// Calls check(x, y) for pixels that show the terrain, judged by Exact; returns their number.
  template <typename Check>
  int ForTerrainPixels(Check&& check)
  {
    int pixels = 0;
    for (int y = 5; y < 150; y += 7)
    {
      for (int x = 5; x < 200; x += 7)
      {
        if (this->Exact->Pick(x + 0.5, y + 0.5, 0.0, this->Scene.Renderer) &&
          this->Exact->IsTerrainPicked())
        {
          check(x, y);
          ++pixels;
        }
      }
    }
    return pixels;
  }

  TerrainScene Scene;
  TerrainProp Terrain;
  vtkSmartPointer<vtkActor> Sphere;
  vtkNew<vtkTerrainPicker> Exact;
};

double DistanceOf(vtkAbstractPicker* picker, const double place[3])
{
  const double* at = picker->GetPickPosition();
  return std::hypot(at[0] - place[0], std::hypot(at[1] - place[1], at[2] - place[2]));
}

/// True if an exact pick somewhere in a pixel, or a quarter of one beside it, is at a place: what
/// the z-buffer has of the pixel. A silhouette may pass through it.
bool IsSeenInPixel(TerrainToPick& scene, int x, int y, const double place[3])
{
  for (int part = 0; part < 49; ++part)
  {
    const double right = x - 0.25 + 0.25 * (part % 7);
    const double up = y - 0.25 + 0.25 * (part / 7);
    if (scene.Exact->Pick(right, up, 0.0, scene.Scene.Renderer) &&
      DistanceOf(scene.Exact, place) < 4.0) // a pixel is 3 wide
    {
      return true;
    }
  }
  return false;
}

/// How many picks are at a place that their pixel does not show.
int CountWrongPicks(TerrainToPick& scene, vtkAbstractPicker* picker, int& pixels)
{
  int wrong = 0;
  pixels = scene.ForTerrainPixels(
    [&](int x, int y)
    {
      picker->Pick(x, y, 0.0, scene.Scene.Renderer);
      double place[3];
      picker->GetPickPosition(place);
      wrong += IsSeenInPixel(scene, x, y, place) ? 0 : 1;
    });
  return wrong;
}

/// True if a number is that of a cell or sample at a grid position, but for what float rounds at
/// the border to the next.
bool IsAtGridPosition(vtkIdType id, const double position[2], bool cells)
{
  constexpr double rounding = 1e-3;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double offset = cells ? 0.0 : 0.5;
    const double east = corner % 2 == 0 ? -rounding : rounding;
    const double north = corner / 2 == 0 ? -rounding : rounding;
    const auto i = static_cast<vtkIdType>(std::floor(position[0] + offset + east));
    const auto j = static_cast<vtkIdType>(std::floor(position[1] + offset + north));
    if (id == i + (cells ? 40 : 41) * j)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperPicking, SelectionHasCellsAndSamplesOfTheGrid)
{
  for (bool cells : { true, false })
  {
    TerrainToPick scene;
    scene.Sphere->SetVisibility(cells); // samples are selected before the points of others
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Scene.Renderer);
    selector->SetArea(0, 0, 199, 149);
    selector->SetFieldAssociation(
      cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
    ASSERT_TRUE(selector->CaptureBuffers());
    int wrong = 0;
    const int pixels = scene.ForTerrainPixels(
      [&](int x, int y)
      {
        const unsigned int at[2] = { static_cast<unsigned int>(x), static_cast<unsigned int>(y) };
        const auto information = selector->GetPixelInformation(at);
        const double* position = scene.Exact->GetGridPosition();
        const bool same = information.Valid && information.Prop == scene.Terrain.Actor &&
          IsAtGridPosition(information.AttributeID, position, cells);
        wrong += same ? 0 : 1;
      });
    EXPECT_GT(pixels, 100);
    EXPECT_EQ(wrong, 0) << cells;
  }
}

// Selection draws numbers, which have no light: no rays to a sun are cast for them.
TEST(OpenGLTerrainMapperPicking, SelectionCastsNoShadows)
{
  TerrainToPick scene;
  const vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->PositionalOff();
  sun->SetPosition(1.0, 1.0, 0.5);
  scene.Scene.Renderer->AddLight(sun);
  auto* mapper = static_cast<vtkOpenGLTerrainMapper*>(scene.Terrain.Actor->GetMapper());
  mapper->SetSunShadows(true);
  mapper->SetSkyLight(0.5);
  int shadows = 0;
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&shadows);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* program)
    {
      const std::string text =
        static_cast<vtkShaderProgram*>(program)->GetFragmentShader()->GetSource();
      *static_cast<int*>(client) += text.find("#define TERRAIN_SHADOWS") != std::string::npos ||
          text.find("#define TERRAIN_SKY") != std::string::npos
        ? 1
        : 0;
    });
  mapper->AddObserver(vtkCommand::UpdateShaderEvent, command);
  scene.Scene.Window->Render();
  EXPECT_GT(shadows, 0);
  shadows = 0;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Scene.Renderer);
  selector->SetArea(0, 0, 199, 149);
  ASSERT_TRUE(selector->CaptureBuffers());
  EXPECT_EQ(shadows, 0);
}

TEST(OpenGLTerrainMapperPicking, WorldPointPicker)
{
  TerrainToPick scene;
  vtkNew<vtkWorldPointPicker> picker;
  int pixels = 0;
  EXPECT_EQ(CountWrongPicks(scene, picker, pixels), 0);
  EXPECT_GT(pixels, 100);
}

TEST(OpenGLTerrainMapperPicking, PropPicker)
{
  TerrainToPick scene;
  vtkNew<vtkPropPicker> picker;
  int pixels = 0;
  EXPECT_EQ(CountWrongPicks(scene, picker, pixels), 0);
  EXPECT_TRUE(picker->Pick(100.0, 60.0, 0.0, scene.Scene.Renderer));
  EXPECT_EQ(picker->GetActor(), scene.Terrain.Actor);
}

// It meets the mesh of port 0, which lies above the surface: vtkTerrainPicker is to replace it.
TEST(OpenGLTerrainMapperPicking, CellPickerMeetsTheCoarseMesh)
{
  TerrainToPick scene;
  vtkNew<vtkCellPicker> picker;
  int below = 0;
  int above = 0;
  const int pixels = scene.ForTerrainPixels(
    [&](int x, int y)
    {
      picker->Pick(x + 0.5, y + 0.5, 0.0, scene.Scene.Renderer);
      const double rise = picker->GetPickPosition()[2] - scene.Exact->GetPickPosition()[2];
      below += rise < -1e-3 ? 1 : 0;
      above += rise > 1.0 ? 1 : 0;
    });
  EXPECT_GT(pixels, 100);
  EXPECT_EQ(below, 0);
  EXPECT_GT(above, pixels / 2);
}
