// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When the bounds of a sun's rays over the heights are built.
#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTestingScene.h"

#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/// A terrain at a place as large as those of maps, in its own shadow.
class BoundedDrawing : public vtkTerrainTesting::Drawing
{
public:
  BoundedDrawing()
    : Drawing(vtkTerrainTesting::MakeHills())
  {
    this->Actor->SetPosition(4.0e5, 5.0e6, 10.0);
    this->Actor->RotateZ(17.0);
    this->Mapper->SetSunShadows(true);
    this->Mapper->SetSunAngle(0.53);
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Shine(100.0, 12.0);
    this->Scene.Renderer->AddLight(this->Sun);
    this->Camera()->SetViewUp(0.0, 1.0, 0.0);
    this->Scene.Renderer->ResetCamera();
  }

  /// Degrees clockwise from north, and above the horizon.
  void Shine(double azimuth, double altitude)
  {
    const double around = vtkMath::RadiansFromDegrees(azimuth);
    const double up = vtkMath::RadiansFromDegrees(altitude);
    this->Sun->SetPosition(
      std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up));
  }

  /// How often bounds were built once it is drawn.
  int Builds()
  {
    this->Scene.Window->Render();
    return this->Mapper->GetNumberOfShadowBoundsBuilds();
  }

  vtkNew<vtkLight> Sun;
};
}

// The rays' direction comes from view coordinates, and is rounded otherwise in each view.
TEST(OpenGLTerrainMapperShadowBounds, AreKeptWhileOnlyTheCameraMoves)
{
  BoundedDrawing drawing;
  EXPECT_EQ(drawing.Mapper->GetNumberOfShadowBoundsBuilds(), 0);
  for (int k = 0; k < 10; ++k)
  {
    drawing.Camera()->Azimuth(7.3);
    drawing.Camera()->Elevation(2.1);
    drawing.Camera()->Zoom(1.02);
    EXPECT_EQ(drawing.Builds(), 1) << k;
  }
}

TEST(OpenGLTerrainMapperShadowBounds, AreBuiltForOtherRaysAndHeights)
{
  BoundedDrawing drawing;
  EXPECT_EQ(drawing.Builds(), 1);
  drawing.Shine(100.001, 12.0);
  EXPECT_EQ(drawing.Builds(), 2);
  drawing.Shine(100.001, 12.001);
  EXPECT_EQ(drawing.Builds(), 3);
  drawing.Mapper->SetSunAngle(0.54);
  EXPECT_EQ(drawing.Builds(), 4);
  drawing.Mapper->SetVerticalExaggeration(1.5);
  EXPECT_EQ(drawing.Builds(), 5);
  vtkDataArray* heights = drawing.Heights->GetPointData()->GetScalars();
  heights->SetComponent(500, 0, 70.0);
  heights->Modified();
  drawing.Heights->Modified();
  EXPECT_EQ(drawing.Builds(), 6);
  vtkNew<vtkPlane> wall;
  wall->SetOrigin(4.0e5, 5.0e6, 0.0);
  wall->SetNormal(0.0, 1.0, 0.0);
  drawing.Mapper->AddClippingPlane(wall);
  EXPECT_EQ(drawing.Builds(), 7);
  EXPECT_EQ(drawing.Builds(), 7);
}

// Nothing reads bounds of lights that cast no shadow of one direction over the land.
TEST(OpenGLTerrainMapperShadowBounds, AreNotBuiltForOtherLights)
{
  BoundedDrawing drawing;
  drawing.Shine(100.0, -3.0);
  EXPECT_EQ(drawing.Builds(), 0);
  drawing.Shine(100.0, 12.0);
  drawing.Sun->SetPositional(true);
  EXPECT_EQ(drawing.Builds(), 0);
  drawing.Sun->SetPositional(false);
  drawing.Sun->SetLightTypeToCameraLight();
  EXPECT_EQ(drawing.Builds(), 0);
  drawing.Sun->SetLightTypeToSceneLight();
  drawing.Mapper->SetSunShadows(false);
  EXPECT_EQ(drawing.Builds(), 0);
  drawing.Mapper->SetSunShadows(true);
  EXPECT_EQ(drawing.Builds(), 1);
}
