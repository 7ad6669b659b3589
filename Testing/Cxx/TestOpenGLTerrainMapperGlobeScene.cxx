// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A globe among lights and other actors, and on a flight from space to the ground, against the
// reference in double precision.
#include "vtkTerrainTestGlobeDrawing.h"

#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

using namespace vtkTerrainTesting;

// Shadows of hills, and of the planet itself on its night side, against rays in double precision.
TEST(OpenGLTerrainMapperGlobeScene, CastsShadows)
{
  struct Case
  {
    vtkSmartPointer<vtkImageData> Heights;
    glm::dvec3 Eye;
    glm::dvec3 Focus;
    glm::dvec3 Sun; ///< longitude and latitude where it stands overhead
    double Exaggeration;
  };
  const auto fine = LayOnGlobe(MakeDegrees(6.0, 44.0, 1.0 / 120.0, 300, 300, GlobeHills));
  const Case cases[] = {
    { MakeWorld(), { 10.0, 20.0, 4e6 }, { 10.0, 10.0, 0.0 }, { 75.0, 10.0, 0.0 }, 60.0 },
    { MakeWorld(), { 170.0, 80.0, 3e6 }, { 190.0, 85.0, 0.0 }, { 90.0, 0.0, 0.0 }, 10.0 },
    { fine, { 7.2, 45.0, 60000.0 }, { 7.3, 45.2, 0.0 }, { -60.0, 20.0, 0.0 }, 1.0 },
    { fine, { 7.2, 45.0, 9000.0 }, { 7.3, 45.2, 0.0 }, { 75.0, -10.0, 0.0 }, 1.0 },
  };
  for (const Case& which : cases)
  {
    SCOPED_TRACE(which.Eye.z);
    Globe globe(which.Heights);
    globe.Exaggeration = which.Exaggeration;
    globe.Shown.Mapper->SetVerticalExaggeration(which.Exaggeration);
    globe.Look(which.Eye, which.Focus);
    const glm::dvec3 sun = glm::normalize(globe.Grid.Body.ToPosition(kDegree * which.Sun));
    const Shadowed result = globe.CompareShadows(sun);
    EXPECT_GE(result.Dark, 5);
    EXPECT_GE(result.Lit, 10);
    EXPECT_LE(result.Wrong, terrain::kGlobeShadowError * (result.Dark + result.Lit))
      << result.Dark << " dark, " << result.Lit << " lit";
  }
}

// The rest of the planet is opaque where a raster covers a part of it.
TEST(OpenGLTerrainMapperGlobeScene, HasNightOnAPart)
{
  Globe globe(LayOnGlobe(MakeDegrees(6.0, 44.0, 1.0 / 120.0, 300, 300, GlobeHills)));
  globe.Look({ 7.2, 45.0, 60000.0 }, { 7.3, 45.2, 0.0 });
  // 15 degrees below the horizon: above it for the steepest slopes alone
  const glm::dvec3 sun =
    glm::normalize(globe.Grid.Body.ToPosition(kDegree * glm::dvec3(7.3 + 105.0, 0.0, 0.0)));
  const Shadowed result = globe.CompareShadows(sun, true);
  EXPECT_EQ(result.Bright, 0);
}

// On the way from three radii down to 2 m above the ground, where a contour crosses the middle row
// of the picture: against the pixel at which rays in double precision meet its height.
TEST(OpenGLTerrainMapperGlobeScene, StandsStillOnAFlight)
{
  constexpr double level = 15000.0;
  Globe part(
    LayOnGlobe(MakeDegrees(8.0, 46.0, 1.0 / 120.0, 61, 61, [](int i, int) { return 500.0 * i; })));
  part.Shown.Actor->GetProperty()->LightingOff();
  part.Shown.Actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  part.Shown.Mapper->ScalarVisibilityOff();
  part.Shown.Mapper->SetContours(true);
  part.Shown.Mapper->SetContourInterval(level);
  part.Shown.Mapper->SetContourWidth(3.0);
  part.Shown.Mapper->SetContourColor(1.0, 1.0, 1.0);
  part.Shown.Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const glm::dvec3 there(8.0 + 30.0 / 120.0, 46.25, level);
  double worst = 0.0;
  for (double above = 1.9e7; above >= 2.0; above *= 0.63)
  {
    SCOPED_TRACE(above);
    // the picture is about 20 km wide at most
    part.Shown.Camera()->SetViewAngle(std::min(30.0, 2.0 * std::atan(8000.0 / above) / kDegree));
    const double aside = std::min(above, 20000.0) / 1e5;
    part.Look({ there.x - aside, there.y - 0.3 * aside, level + above }, there);
    part.Shown.Camera()->SetViewUp(0.0, 0.0, 1.0);
    part.Shown.Camera()->SetClippingRange(0.2 * above, 10.0 * above + 1e5);
    worst = std::max(worst, part.ContourError(level));
  }
  EXPECT_LT(worst, terrain::kGlobeJitterError) << "pixels";
}

// VTK's actors half a metre above the ground are seen, and half a metre below it not, between the
// clipping planes of a globe: from a hundred-thousandth of what can be seen to the horizon.
TEST(OpenGLTerrainMapperGlobeScene, HasDepthsOfVTKActors)
{
  Globe part(LayOnGlobe(MakeDegrees(8.0, 46.0, 0.01, 101, 101, [](int, int) { return 300.0; })));
  part.Shown.Actor->GetProperty()->LightingOff();
  part.Shown.Mapper->ScalarVisibilityOff();
  part.Shown.Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  for (const double above : { 2.0, 20.0, 200.0, 2000.0 })
  {
    for (const double off : { -0.5, 0.5 })
    {
      SCOPED_TRACE(std::to_string(above) + " " + std::to_string(off));
      part.Look({ 8.5, 46.5, 300.0 + above }, { 8.5, 46.5 + 4.0 * above / 1.1e5, 300.0 });
      const double far = std::sqrt(2.0 * 6.4e6 * above) + std::sqrt(2.0 * 6.4e6 * 300.0);
      part.Shown.Camera()->SetClippingRange(std::max(1e-5 * far, 0.5 * above), far);
      const auto at = [&part, off](double x, double y) {
        return part.Grid.Body.ToPosition({ x * kDegree, y * kDegree, 300.0 + off });
      };
      const double half = 0.5 * above / 1.1e5;
      const double north = 46.5 + 4.0 * above / 1.1e5;
      const glm::dvec3 origin = at(8.5 - half, north - half);
      const glm::dvec3 east = at(8.5 + half, north - half);
      const glm::dvec3 up = at(8.5 - half, north + half);
      const vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(origin.x, origin.y, origin.z);
      plane->SetPoint1(east.x, east.y, east.z);
      plane->SetPoint2(up.x, up.y, up.z);
      const vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(plane->GetOutputPort());
      const vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->LightingOff();
      actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
      part.Shown.Scene.Renderer->AddActor(actor);
      const auto count = [&part]
      {
        const auto picture = vtkTerrainTesting::Render(part.Shown.Scene.Window);
        int red = 0;
        for (int k = 0; k < DrawingWidth * DrawingHeight; ++k)
        {
          red +=
            picture->GetScalarComponentAsDouble(k % DrawingWidth, k / DrawingWidth, 0, 0) > 128.0;
        }
        return red;
      };
      const int seen = count();
      part.Shown.Actor->VisibilityOff();
      const int alone = count();
      part.Shown.Actor->VisibilityOn();
      part.Shown.Scene.Renderer->RemoveActor(actor);
      EXPECT_GT(alone, 30);
      EXPECT_EQ(seen, off > 0.0 ? alone : 0);
    }
  }
}
