// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures of the mapper: the procedural landscape under one light from the north-west, coloured by
// height, by each technique. Beside each picture one number: the share of pixels that show terrain.
#include "vtkTerrainTesting.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <array>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

constexpr int Width = 240;
constexpr int Height = 180;
constexpr double Side = 40960.0; // metres, the source's own

class Landscape
{
public:
  Landscape()
    : Scene(vtkTerrainTesting::MakeScene(Width, Height))
  {
    this->Source->SetDimensions(257, 257);
    this->Source->SetOutputScalarTypeToUnsignedShort();
    this->Mesh->SetInputConnection(this->Source->GetOutputPort());
    this->Mapper->SetInputConnection(this->Mesh->GetOutputPort());
    this->Mapper->SetHeightsConnection(this->Source->GetOutputPort());
    vtkNew<vtkLookupTable> colors;
    colors->SetHueRange(0.33, 0.08);
    colors->SetSaturationRange(0.5, 0.3);
    colors->SetValueRange(0.5, 1.0);
    this->Mapper->SetLookupTable(colors);
    this->Mapper->SetScalarRange(0.0, 2500.0);
    this->Mapper->ScalarVisibilityOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Mapper);
    actor->GetProperty()->SetAmbient(0.1); // no part of the terrain is black
    this->Scene.Renderer->AddActor(actor);
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(-1.0, 1.0, 0.8);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Scene.Renderer->AddLight(sun);
  }

  vtkSmartPointer<vtkImageData> Draw(
    const std::array<double, 3>& eye, const std::array<double, 3>& focus)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    return vtkTerrainTesting::Render(this->Scene.Window);
  }

  vtkTerrainTesting::Scene Scene;
  vtkNew<vtkTerrainSource> Source;
  vtkNew<vtkTerrainCoarseMesh> Mesh;
  vtkNew<vtkOpenGLTerrainMapper> Mapper;
};

constexpr std::array<double, 3> ObliqueEye{ 0.5 * Side, -0.75 * Side, 0.7 * Side };
constexpr std::array<double, 3> ObliqueFocus{ 0.5 * Side, 0.45 * Side, 0.0 };
constexpr std::array<double, 3> ValleyEye{ 0.42 * Side, 0.4 * Side, 2600.0 };
constexpr std::array<double, 3> ValleyFocus{ 0.7 * Side, 0.6 * Side, 1500.0 };
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperImage, Pyramid)
{
  Landscape landscape;
  const auto picture = landscape.Draw(ObliqueEye, ObliqueFocus);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPyramid"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.660, 0.005);
}

TEST(OpenGLTerrainMapperImage, PyramidFromWithin)
{
  Landscape landscape;
  const auto picture = landscape.Draw(ValleyEye, ValleyFocus);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPyramidFromWithin"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.568, 0.005);
}

TEST(OpenGLTerrainMapperImage, Columns)
{
  Landscape landscape;
  landscape.Mapper->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  const auto picture = landscape.Draw(ValleyEye, ValleyFocus);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainColumns"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.570, 0.005);
}

TEST(OpenGLTerrainMapperImage, EquidistantDrawsAsThePyramid)
{
  Landscape landscape;
  landscape.Mapper->SetTechnique(Techniques::Equidistant);
  const auto picture = landscape.Draw(ObliqueEye, ObliqueFocus);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPyramid", { 12, 0.02 }));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.660, 0.005);
}

TEST(OpenGLTerrainMapperImage, MeshDrawsAsThePyramid)
{
  Landscape landscape;
  landscape.Mesh->SetPushUp(false);
  landscape.Mesh->SetCellsPerQuad(1);
  landscape.Mapper->SetTechnique(Techniques::Mesh);
  const auto picture = landscape.Draw(ObliqueEye, ObliqueFocus);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPyramid", { 12, 0.02 }));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.660, 0.005);
}
