// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights on a globe as the mapper draws them, against the reference in double precision: from
// space to eye height, over the poles and the date line, on several bodies.
#include "vtkTerrainTestGlobeDrawing.h"

#include "render/Globe.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainPicker.h"

#include "vtkAssembly.h"
#include "vtkCommand.h"
#include "vtkTestErrorObserver.h"

using namespace vtkTerrainTesting;

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperGlobe, IsExactFromSpace)
{
  Globe globe(MakeWorld());
  for (const glm::dvec3& eye : { glm::dvec3(10.0, 40.0, 1.9e7), glm::dvec3(180.0, 3.0, 1e7),
         glm::dvec3(20.0, 90.0, 8e6), glm::dvec3(20.0, -89.0, 5e6), glm::dvec3(-100.0, 20.0, 4e5) })
  {
    SCOPED_TRACE(eye.x);
    globe.Look(eye, { eye.x + 1.0, eye.y - 1.0, 0.0 });
    ExpectAgreement(globe, 100);
  }
}

// What matters in float: 2 m above the ground, and a kilometre across seen from space.
TEST(OpenGLTerrainMapperGlobe, IsExactNearAndFar)
{
  Globe globe(LayOnGlobe(MakeDegrees(6.0, 44.0, 1.0 / 120.0, 500, 400, GlobeHills)));
  const double ground = globe.Ground(8.0, 46.0);
  for (const double above : { 2.0, 50.0, 2000.0, 30000.0 })
  {
    SCOPED_TRACE(above);
    globe.Look({ 8.0, 46.0, ground + above }, { 8.3, 46.1, ground - above });
    ExpectAgreement(globe, 100);
  }
  globe.Shown.Camera()->SetViewAngle(0.002);
  globe.Look({ 8.0, 46.0, 1.9e7 }, { 8.0, 46.0, ground });
  ExpectAgreement(globe, 500);
}

TEST(OpenGLTerrainMapperGlobe, IsExactOnAnyBody)
{
  for (const auto& [equatorial, polar] : { std::pair(3396190.0, 3376200.0),
         std::pair(1737400.0, 1737400.0), std::pair(284500.0, 0.9 * 284500.0) })
  {
    SCOPED_TRACE(equatorial);
    Globe globe(MakeWorld(1.0, equatorial, polar));
    globe.Look({ 100.0, 30.0, 2.0 * equatorial }, { 100.0, 20.0, 0.0 });
    ExpectAgreement(globe, 100);
    globe.Look({ 100.0, 30.0, globe.Ground(100.0, 30.0) + 20.0 }, { 101.0, 30.2, 0.0 });
    ExpectAgreement(globe, 30);
  }
}

// Partial rasters, exaggeration.
TEST(OpenGLTerrainMapperGlobe, ShowsWhatIsThere)
{
  Globe part(LayOnGlobe(MakeDegrees(170.0, -15.0, 0.5, 61, 61, GlobeHills)));
  part.Look({ 185.0, -3.0, 4e6 }, { 183.0, 1.0, 0.0 });
  ExpectAgreement(part, 50);
  part.Exaggeration = 20.0;
  part.Shown.Mapper->SetVerticalExaggeration(20.0);
  part.Look({ 185.0, -40.0, 4e6 }, { 183.0, 1.0, 0.0 });
  ExpectAgreement(part, 50);
}

// Holes without data, through which space is seen and no underside.
TEST(OpenGLTerrainMapperGlobe, HasHoles)
{
  const auto heights = MakeDegrees(170.0, -15.0, 0.5, 61, 61, GlobeHills);
  vtkUnsignedCharArray* ghosts = heights->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < heights->GetNumberOfPoints(); ++i)
  {
    const bool hidden = (i % 61 > 20 && i % 61 < 30) || (i * 7) % 37 == 0;
    ghosts->SetValue(i, hidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  Globe part(LayOnGlobe(heights));
  part.Look({ 185.0, -3.0, 2e6 }, { 183.0, 1.0, 0.0 });
  ExpectAgreement(part, 50);
  const Agreement result = part.Compare();
  EXPECT_GT(result.Pixels - result.Hits, 150);
}

// Contours of heights that rise to the north, against what the picker tells of their pixels.
TEST(OpenGLTerrainMapperGlobe, HasContours)
{
  Globe part(
    LayOnGlobe(MakeDegrees(0.0, -30.0, 1.0, 61, 61, [](int, int j) { return 100.0 * j; })));
  part.Look({ 30.0, 0.0, 4e6 }, { 30.0, 0.0, 0.0 });
  part.Shown.Camera()->SetViewUp(0.0, 0.0, 1.0);
  part.Shown.Actor->GetProperty()->LightingOff();
  part.Shown.Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  part.Shown.Mapper->ScalarVisibilityOff();
  part.Shown.Mapper->SetContours(true);
  part.Shown.Mapper->SetContourInterval(500.0);
  part.Shown.Mapper->SetContourWidth(1.0);
  part.Shown.Mapper->SetContourColor(1.0, 0.0, 0.0);
  const vtkSmartPointer<vtkImageData> picture = vtkTerrainTesting::Render(part.Shown.Scene.Window);
  const vtkNew<vtkTerrainPicker> picker;
  int lines = 0;
  int wrong = 0;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    const double x = 0.5 * DrawingWidth + 0.5;
    const auto apart = [&](double row)
    {
      picker->Pick(x, row, 0.0, part.Shown.Scene.Renderer);
      return std::remainder(picker->GetHeight(), 500.0);
    };
    const bool isLine = picture->GetScalarComponentAsDouble(DrawingWidth / 2, y, 0, 0) > 100.0;
    const bool crosses = apart(y - 0.5) * apart(y + 1.5) < 0.0 && std::abs(apart(y + 0.5)) < 200.0;
    lines += isLine ? 1 : 0;
    wrong += isLine && !crosses ? 1 : 0;
  }
  EXPECT_GE(lines, 3);
  EXPECT_EQ(wrong, 0);
}

// The planet is opaque: from within it, and from behind it, nothing is seen of the underside.
TEST(OpenGLTerrainMapperGlobe, HidesItsUnderside)
{
  Globe part(LayOnGlobe(MakeDegrees(170.0, -15.0, 0.5, 61, 61, GlobeHills)));
  const vtkNew<vtkTerrainPicker> picker;
  for (const glm::dvec3& eye : { glm::dvec3(185.0, 10.0, -3e6), glm::dvec3(5.0, 10.0, 1e6) })
  {
    SCOPED_TRACE(eye.x);
    part.Look(eye, { 183.0, 1.0, 0.0 });
    const Agreement result = part.Compare();
    EXPECT_EQ(result.Hits, 0);
    EXPECT_EQ(result.Disagreements, 0);
    EXPECT_FALSE(
      picker->Pick(0.5 * DrawingWidth, 0.5 * DrawingHeight, 0.0, part.Shown.Scene.Renderer));
  }
}

// From below the ground rays go on through it to what they meet from above, in any unit of length.
TEST(OpenGLTerrainMapperGlobe, ShowsWhatLiesBehindItsUnderside)
{
  for (const double scale : { 1.0, 1e-3 })
  {
    SCOPED_TRACE(scale);
    Globe globe(LayOnGlobe(MakeDegrees(6.0, 44.0, 1.0 / 120.0, 500, 400, GlobeHills)));
    globe.Scale = scale;
    globe.Shown.Actor->SetScale(scale, scale, scale);
    const double ground = globe.Ground(8.0, 46.0);
    globe.Look({ 8.0, 46.0, ground - 30.0 }, { 8.06, 46.03, ground + 300.0 });
    ExpectAgreement(globe, 100);
  }
}

// A grid that has not changed is not read again for each frame.
TEST(OpenGLTerrainMapperGlobe, ReadsItsGridOnce)
{
  const auto heights = MakeWorld(10.0);
  terrain::Globe globe;
  EXPECT_EQ(globe.SetImage(heights), "");
  EXPECT_EQ(globe.SetImage(heights), "");
  EXPECT_EQ(globe.GetNumberOfScans(), 1);
  heights->Modified();
  EXPECT_EQ(globe.SetImage(heights), "");
  EXPECT_EQ(globe.GetNumberOfScans(), 2);
  heights->GetFieldData()->GetArray("GlobeLatitudes")->SetNumberOfTuples(5);
  heights->Modified();
  EXPECT_NE(globe.SetImage(heights), "");
  EXPECT_NE(globe.SetImage(heights), "");
  EXPECT_EQ(globe.SetImage(nullptr), "");
  EXPECT_FALSE(globe.IsRound());
}

// Places on the border of a raster, rounded to either side, lie on it.
TEST(OpenGLTerrainMapperGlobe, HasHeightsOnItsBorder)
{
  for (const double west : { 170.0, -180.0, 0.1 })
  {
    const auto heights = LayOnGlobe(MakeDegrees(west, -15.3, 0.1, 61, 61, GlobeHills));
    terrain::GlobeSurface surface;
    ASSERT_TRUE(surface.SetImage(heights));
    const double east = west + 6.0;
    for (const double side : { -1e3, 1e3 })
    {
      for (const double longitude : { west, west - 360.0, east, east + 360.0 })
      {
        EXPECT_FALSE(std::isnan(surface.HeightAt(std::nextafter(longitude, side), -13.0)))
          << longitude;
      }
      for (const double latitude : { -15.3, -9.3 })
      {
        EXPECT_FALSE(std::isnan(surface.HeightAt(west + 1.0, std::nextafter(latitude, side))))
          << latitude;
      }
    }
    EXPECT_TRUE(std::isnan(surface.HeightAt(west - 1e-6, -13.0)));
    EXPECT_TRUE(std::isnan(surface.HeightAt(east + 1e-6, -13.0)));
    EXPECT_TRUE(std::isnan(surface.HeightAt(west + 1.0, -15.3 - 1e-6)));
    EXPECT_TRUE(std::isnan(surface.HeightAt(terrain::kNaN, -13.0)));
  }
}

TEST(OpenGLTerrainMapperGlobe, IsExactInParallelProjection)
{
  Globe globe(MakeWorld());
  globe.Shown.Camera()->ParallelProjectionOn();
  globe.Shown.Camera()->SetParallelScale(5e6);
  globe.Look({ 30.0, 50.0, 1.5e7 }, { 31.0, 48.0, 0.0 });
  ExpectAgreement(globe, 100);
}

// Day and night come with normals: a light from the east lights the east.
TEST(OpenGLTerrainMapperGlobe, HasDayAndNight)
{
  Globe globe(MakeWorld());
  globe.Look({ 0.0, 0.0, 1.5e7 }, { 0.0, 0.0, 0.0 });
  globe.Shown.Camera()->SetViewUp(0.0, 0.0, 1.0);
  vtkRenderer* renderer = globe.Shown.Scene.Renderer;
  renderer->RemoveAllLights();
  const vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(0.0, 1.0, 0.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  renderer->SetBackground(0.0, 0.0, 1.0);
  globe.Shown.Actor->GetProperty()->SetAmbient(0.0);
  const vtkSmartPointer<vtkImageData> picture = vtkTerrainTesting::Render(globe.Shown.Scene.Window);
  const auto red = [&picture](int x)
  { return picture->GetScalarComponentAsDouble(x, DrawingHeight / 2, 0, 0); };
  EXPECT_GT(red(DrawingWidth / 2 + 9), 40.0);
  EXPECT_LT(red(DrawingWidth / 2 - 9), 5.0);
}

TEST(OpenGLTerrainMapperGlobe, PicksAndSees)
{
  Globe globe(MakeWorld());
  globe.Look({ 25.0, 30.0, 3e6 }, { 25.0, 30.0, 0.0 });
  globe.Shown.Scene.Window->Render();
  const vtkNew<vtkTerrainPicker> picker;
  const terrain::GlobeReference reference = globe.Reference();
  const terrain::PixelRays rays = globe.Rays();
  for (int x = 5; x < DrawingWidth; x += 10)
  {
    ASSERT_TRUE(picker->Pick(x + 0.5, 20.5, 0.0, globe.Shown.Scene.Renderer));
    terrain::GlobeReferenceRay ray;
    ray.Origin = terrain::AtPixel(rays.OriginGC, { x + 0.5, 20.5 });
    ray.Direction = terrain::AtPixel(rays.DirectionGC, { x + 0.5, 20.5 });
    ray.End = rays.Far;
    const auto hit = reference.Cast(ray);
    ASSERT_TRUE(hit.Found);
    const glm::dvec3 expected = ray.Origin + hit.T * ray.Direction;
    const double* picked = picker->GetPickPosition();
    EXPECT_NEAR(glm::length(expected - glm::dvec3(picked[0], picked[1], picked[2])), 0.0, 0.01);
    EXPECT_NEAR(picker->GetHeight(), globe.Grid.Body.ToPlace(expected).z, 0.01);
    EXPECT_NEAR(picker->GetGridPosition()[0], hit.Cell.x + hit.Fraction.x, 1e-5);
  }
  // over the horizon, and beside it
  const auto position = [&globe](double longitude, double height) {
    return globe.Grid.Body.ToPosition({ longitude * kDegree, 0.0, height });
  };
  const glm::dvec3 from = position(0.0, 6000.0);
  const glm::dvec3 near = position(0.5, 6500.0);
  const glm::dvec3 far = position(12.0, 6500.0);
  double obstacle[3];
  EXPECT_FALSE(picker->HasLineOfSight(globe.Shown.Actor, &from.x, &far.x, obstacle));
  EXPECT_TRUE(picker->HasLineOfSight(globe.Shown.Actor, &from.x, &near.x, obstacle));
}

// An actor of the module has a mesh for VTK's pickers, but on a globe. There, too, it is picked by
// rays, by itself and in an assembly.
TEST(OpenGLTerrainMapperGlobe, IsPickedAsAnActor)
{
  const auto heights = MakeWorld();
  Globe globe(heights);
  globe.Look({ 25.0, 30.0, 3e6 }, { 25.0, 30.0, 0.0 });
  vtkRenderer* renderer = globe.Shown.Scene.Renderer;
  globe.Shown.Scene.Window->Render();
  const vtkNew<vtkTerrainPicker> picker;
  ASSERT_TRUE(picker->Pick(30.5, 20.5, 0.0, renderer));
  const double expected[2] = { picker->GetGridPosition()[0], picker->GetGridPosition()[1] };
  const double height = picker->GetHeight();
  renderer->RemoveActor(globe.Shown.Actor);
  const vtkNew<vtkTerrainActor> actor;
  actor->SetInputData(heights);
  const vtkNew<vtkAssembly> assembly;
  for (vtkProp* prop : { static_cast<vtkProp*>(actor), static_cast<vtkProp*>(assembly) })
  {
    renderer->AddViewProp(prop);
    globe.Shown.Scene.Window->Render();
    ASSERT_TRUE(picker->Pick(30.5, 20.5, 0.0, renderer));
    EXPECT_NEAR(picker->GetGridPosition()[0], expected[0], 1e-6);
    EXPECT_NEAR(picker->GetGridPosition()[1], expected[1], 1e-6);
    EXPECT_NEAR(picker->GetHeight(), height, 1e-3);
    renderer->RemoveViewProp(prop);
    assembly->AddPart(actor);
  }
  actor->PickableOff();
  renderer->AddActor(actor);
  EXPECT_FALSE(picker->Pick(30.5, 20.5, 0.0, renderer));
}

// What is not to be had is one sentence, not a wrong picture.
TEST(OpenGLTerrainMapperGlobe, RefusesOtherTechniques)
{
  Globe globe(MakeWorld());
  globe.Look({ 0.0, 0.0, 1.5e7 }, { 0.0, 0.0, 0.0 });
  globe.Shown.Mapper->SetTechnique(vtkOpenGLTerrainMapper::Techniques::Equidistant);
  const vtkNew<vtkTest::ErrorObserver> errors;
  globe.Shown.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  globe.Shown.Scene.Window->Render();
  EXPECT_NE(errors->GetErrorMessage().find("technique Pyramid"), std::string::npos);
}
