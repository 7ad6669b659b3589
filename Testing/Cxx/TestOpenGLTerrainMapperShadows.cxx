// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of the surface on itself, judged pixel by pixel by rays in double precision.
#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTestingScene.h"

#include "core/rays/RayQuery.h"
#include "core/surface/Cutting.h"
#include "data/ImageSurface.h"
#include "vtkTerrainHorizon.h"
#include "vtkTerrainSource.h"

#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using vtkTerrainTesting::Drawing;
using vtkTerrainTesting::DrawingHeight;
using vtkTerrainTesting::DrawingWidth;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

/// A terrain under one light, with nothing but what that light gives.
class Sunlit : public Drawing
{
public:
  explicit Sunlit(vtkImageData* heights, Techniques technique = Techniques::Pyramid)
    : Drawing(heights, technique)
  {
    this->Actor->GetProperty()->SetSpecular(0.0);
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer()->AddLight(this->Sun);
  }

  vtkRenderer* Renderer()
  {
    return this->Scene.Renderer;
  }

  /// Degrees clockwise from north, and above the horizon.
  void Shine(double azimuth, double altitude)
  {
    const double around = vtkMath::RadiansFromDegrees(azimuth);
    const double up = vtkMath::RadiansFromDegrees(altitude);
    this->Sun->SetPosition(
      std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up));
  }

  vtkSmartPointer<vtkImageData> Picture(bool shadows)
  {
    this->Mapper->SetSunShadows(shadows);
    return vtkTerrainTesting::Render(this->Scene.Window);
  }

  vtkNew<vtkLight> Sun;
};

/// What a light gives of itself at a point of the surface, in model coordinates, 0 to 1; NaN where
/// that cannot be told from a picture.
using ShareFunction = std::function<double(
  const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)>;

struct Count
{
  int Lit = 0;
  int Dark = 0;
  int Between = 0;
  int Undecided = 0;
  int Wrong = 0;
};

/// Compares the pixels that the light reaches without shadows with the share that they should get.
Count judge(Sunlit& drawing, const terrain::Surface& surface, const ShareFunction& share)
{
  const terrain::RayQuery query(surface);
  const terrain::PixelRays rays = drawing.Rays();
  const auto open = drawing.Picture(false);
  const auto shadowed = drawing.Picture(true);
  const terrain::GridGeometry& frame = surface.Frame;
  Count count;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    for (int x = 0; x < DrawingWidth; ++x)
    {
      const double before = open->GetScalarComponentAsDouble(x, y, 0, 0);
      if (before < 12.0)
      {
        continue;
      }
      terrain::QueryRay ray;
      const double cells = drawing.Heights->GetSpacing()[0] / frame.Spacing.x; // of detail
      const glm::dvec3 scale(frame.Spacing * cells, frame.Exaggeration);
      ray.Origin = frame.Origin + scale * terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 });
      ray.Direction = scale * terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 });
      const terrain::SurfaceHit hit = query.First(ray);
      const double expected = hit.Found && hit.FromAbove
        ? share(query, ray.Origin + hit.Distance * ray.Direction, hit)
        : terrain::kNaN;
      if (std::isnan(expected))
      {
        ++count.Undecided;
        continue;
      }
      const double after = shadowed->GetScalarComponentAsDouble(x, y, 0, 0);
      count.Lit += expected == 1.0 ? 1 : 0;
      count.Dark += expected == 0.0 ? 1 : 0;
      count.Between += expected > 0.0 && expected < 1.0 ? 1 : 0;
      count.Wrong += std::abs(after - expected * before) > 2.0 ? 1 : 0;
    }
  }
  return count;
}

/// Whether a point of the surface sees a light, asked of it and of points a little beside, all a
/// hair above the surface; NaN where they disagree.
ShareFunction seesLight(const glm::dvec3& toLight, double end = terrain::kInfinity)
{
  return [toLight, end](const terrain::RayQuery& query, const glm::dvec3& point,
           const terrain::SurfaceHit& /*hit*/)
  {
    const terrain::GridGeometry& frame = query.GetSurface().Frame;
    int seen = 0;
    int asked = 0;
    for (const auto& [dx, dy] :
      { std::pair(0.0, 0.0), { 3e-4, 0.0 }, { -3e-4, 0.0 }, { 0.0, 3e-4 }, { 0.0, -3e-4 } })
    {
      const double x = point.x + dx * frame.Spacing.x;
      const double y = point.y + dy * frame.Spacing.y;
      terrain::QueryRay ray;
      const double top = frame.Origin.z + frame.Exaggeration * query.HeightAt(x, y);
      ray.Origin = { x, y, top };
      if (std::abs(top - point.z) > 0.05 * frame.Spacing.x)
      {
        return terrain::kNaN; // a wall, or a hole
      }
      ray.Origin.z += 1e-7 * frame.Spacing.x;
      ray.Direction = toLight;
      ray.End = end;
      seen += query.Any(ray) ? 0 : 1;
      ++asked;
    }
    return seen == 0 ? 0.0 : seen == asked ? 1.0 : terrain::kNaN;
  };
}

glm::dvec3 wayOf(vtkLight* light)
{
  const double* position = light->GetPosition();
  return { position[0], position[1], position[2] };
}

/// The surface that a drawing shows.
terrain::Surface surfaceOf(Sunlit& drawing)
{
  terrain::ImageSurface image;
  image.SetImage(drawing.Heights);
  return image.GetSurface(drawing.Mapper->GetVerticalExaggeration());
}

Count judgeSun(Sunlit& drawing)
{
  return judge(drawing, surfaceOf(drawing), seesLight(wayOf(drawing.Sun)));
}

void expectRight(const Count& count, const std::string& what = "")
{
  EXPECT_EQ(count.Wrong, 0) << what;
  EXPECT_GT(count.Lit, 100) << what;
  EXPECT_GT(count.Dark, 100) << what;
  EXPECT_LT(count.Undecided, (count.Lit + count.Dark) / 20 + 5) << what;
}

vtkSmartPointer<vtkImageData> landscape(int size)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(size, size);
  source->Update();
  return source->GetOutput();
}

void lookOver(Sunlit& drawing)
{
  const int* size = drawing.Heights->GetDimensions();
  double range[2];
  drawing.Heights->GetScalarRange(range);
  const double high = range[1] + 0.2 * size[0] * drawing.Heights->GetSpacing()[0];
  drawing.Look(0.5 * size[0], -0.2 * size[1], high, 0.5 * size[0], 0.5 * size[1], range[0]);
}
}

//------------------------------------------------------------------------------
// Hard shadows of every pixel, of high and low suns from all sides, through both ways of drawing.
TEST(OpenGLTerrainMapperShadows, AgreeWithRaysInDouble)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  for (const double azimuth : { 0.0, 77.0, 135.0, 200.0, 270.0, 315.0 })
  {
    hills.Shine(azimuth, 8.0);
    expectRight(judgeSun(hills), "azimuth " + std::to_string(azimuth));
  }
  hills.Shine(250.0, 1.0);
  EXPECT_EQ(judgeSun(hills).Wrong, 0);
  hills.Shine(250.0, 89.0);
  EXPECT_EQ(judgeSun(hills).Wrong, 0);
  hills.Shine(250.0, 90.0);
  EXPECT_EQ(judgeSun(hills).Wrong, 0);
}

TEST(OpenGLTerrainMapperShadows, AgreeWithRaysFromNearAndFar)
{
  for (const auto mode : { vtkTerrainLook::ComputeModes::Off, vtkTerrainLook::ComputeModes::On })
  {
    Sunlit land(landscape(513));
    land.Mapper->SetComputeMode(mode);
    land.Shine(100.0, 12.0);
    lookOver(land);
    expectRight(judgeSun(land), "above");
    land.Look(200.0, 210.0, 2500.0, 260.0, 300.0, 300.0);
    expectRight(judgeSun(land), "near");
    land.Look(250.0, -9000.0, 90000.0, 256.0, 256.0, 300.0);
    land.Camera()->SetViewAngle(2.0);
    expectRight(judgeSun(land), "far");
  }
}

// Every technique finds the same shadows: the searches and meshes find points a little beside.
TEST(OpenGLTerrainMapperShadows, AreThoseOfEveryTechnique)
{
  for (const auto technique : { Techniques::Mesh, Techniques::Equidistant, Techniques::Linear })
  {
    Sunlit hills(vtkTerrainTesting::MakeHills(), technique);
    hills.Mesh->SetCellsPerQuad(1);
    lookOver(hills);
    hills.Shine(135.0, 8.0);
    const Count count = judgeSun(hills);
    EXPECT_LE(count.Wrong, (count.Lit + count.Dark) / 20);
    EXPECT_GT(count.Dark, (count.Lit + count.Dark) / 10); // else no shadow would do
  }
}

// A tolerance moves the points that are seen, and not what is in their shadow.
TEST(OpenGLTerrainMapperShadows, StartOnTheSurfaceUnderATolerance)
{
  Sunlit land(landscape(513));
  land.Mapper->SetPixelTolerance(0.25);
  land.Shine(100.0, 12.0);
  lookOver(land);
  const Count count = judgeSun(land);
  EXPECT_LE(count.Wrong, (count.Lit + count.Dark) / 30);
  EXPECT_GT(count.Dark, (count.Lit + count.Dark) / 10);
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperShadows, AreThoseOfTheExaggeratedSurface)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  hills.Mapper->SetVerticalExaggeration(2.5);
  hills.Look(20.0, -20.0, 600.0, 20.0, 16.0, 250.0);
  hills.Shine(110.0, 20.0);
  expectRight(judgeSun(hills));
}

// The rays are those of the world, however the actor stands in it.
TEST(OpenGLTerrainMapperShadows, FollowTurnedActors)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Shine(110.0, 9.0);
  const glm::dvec3 way = wayOf(hills.Sun);
  hills.Actor->SetOrigin(200.0, 190.0, 100.0);
  hills.Actor->RotateZ(40.0);
  hills.Actor->SetScale(1.0, 1.0, 1.5);
  // into the model: turned back, and lower by the scale
  const double turn = vtkMath::RadiansFromDegrees(-40.0);
  const glm::dvec3 model(std::cos(turn) * way.x - std::sin(turn) * way.y,
    std::sin(turn) * way.x + std::cos(turn) * way.y, way.z / 1.5);
  expectRight(judge(hills, surfaceOf(hills), seesLight(model)));
}

TEST(OpenGLTerrainMapperShadows, HolesLetLightThrough)
{
  Sunlit hills(vtkTerrainTesting::MakeHills(true));
  lookOver(hills);
  hills.Shine(135.0, 8.0);
  expectRight(judgeSun(hills));
}

// What is cut away hides nothing.
TEST(OpenGLTerrainMapperShadows, EndAtPlanes)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Shine(90.0, 8.0);
  const double east = 260.0;
  const double top = 118.0;
  vtkNew<vtkPlane> wall;
  wall->SetOrigin(east, 0.0, 0.0);
  wall->SetNormal(-1.0, 0.0, 0.0);
  hills.Mapper->AddClippingPlane(wall);
  vtkNew<vtkPlane> lid;
  lid->SetOrigin(0.0, 0.0, top);
  lid->SetNormal(0.0, 0.0, -1.0);
  hills.Mapper->AddClippingPlane(lid);
  terrain::Surface surface = surfaceOf(hills);
  surface.Planes.emplace_back(surface.Frame.PlaneToGrid({ -1.0, 0.0, 0.0, east }));
  surface.Planes.emplace_back(surface.Frame.PlaneToGrid({ 0.0, 0.0, -1.0, top }));
  expectRight(judge(hills, surface, seesLight(wayOf(hills.Sun))));
}

// Nothing stands before the faces at which a block is cut; its top has its shadows.
TEST(OpenGLTerrainMapperShadows, BlocksHaveLightOnTheirCutFaces)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  hills.Look(-20.0, -30.0, 500.0, 20.0, 16.0, 80.0);
  hills.Mapper->SetBlock(true);
  const int first[2] = { 8, 5 };
  const int last[2] = { 33, 28 };
  hills.Mapper->SetExtract(first, last);
  hills.Shine(200.0, 8.0);
  terrain::Surface surface = surfaceOf(hills);
  surface.Block = true;
  surface.Planes = { { 1.0, 0.0, 0.0, -8.0 }, { -1.0, 0.0, 0.0, 33.0 }, { 0.0, 1.0, 0.0, -5.0 },
    { 0.0, -1.0, 0.0, 28.0 }, { 0.0, 0.0, 1.0, 0.0 } };
  const Count top = judge(hills, surface, seesLight(wayOf(hills.Sun)));
  EXPECT_EQ(top.Wrong, 0);
  EXPECT_GT(top.Dark, 100);
  const Count walls = judge(hills, surface,
    [](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& /*hit*/)
    { return point.z < query.HeightAt(point.x, point.y) - 1.0 ? 1.0 : terrain::kNaN; });
  EXPECT_EQ(walls.Wrong, 0);
  EXPECT_GT(walls.Lit, 100);
}

TEST(OpenGLTerrainMapperShadows, OfColumns)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Mapper->SetSurface(vtkTerrainLook::Surfaces::Columns);
  hills.Shine(140.0, 10.0);
  terrain::Surface surface = surfaceOf(hills);
  surface.Kind = terrain::SurfaceKind::Columns;
  const glm::dvec3 way = wayOf(hills.Sun);
  expectRight(judge(hills, surface,
    [way](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)
    {
      // a thousandth of a cell is what tells walls from tops
      constexpr double reach = 0.02;
      const glm::dvec3 along(hit.Normal.y, hit.Normal.z, hit.Normal.x);
      const glm::dvec3 across(hit.Normal.z, hit.Normal.x, hit.Normal.y);
      int seen = 0;
      int asked = 0;
      for (const glm::dvec3& beside :
        { glm::dvec3(0.0), reach * along, -reach * along, reach * across, -reach * across })
      {
        terrain::QueryRay ray;
        ray.Origin = point + beside + (asked == 0 ? 1e-6 : reach) * hit.Normal;
        ray.Direction = way;
        seen += query.Any(ray) ? 0 : 1;
        ++asked;
      }
      return seen == 0 ? 0.0 : seen == asked ? 1.0 : terrain::kNaN;
    }));
}

TEST(OpenGLTerrainMapperShadows, OfDetail)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  const auto bumps = landscape(32);
  lookOver(hills);
  hills.Mapper->SetDetailData(bumps);
  hills.Mapper->SetDetailCells(4);
  hills.Mapper->SetDetailScale(0.02);
  hills.Shine(140.0, 10.0);
  terrain::ImageSurface image;
  image.SetImage(hills.Heights);
  image.SetDetail(bumps);
  expectRight(judge(hills, image.GetDetailedSurface(1.0, 4, 0.02), seesLight(wayOf(hills.Sun))));
}

//------------------------------------------------------------------------------
// A lamp over the land: rays end there.
TEST(OpenGLTerrainMapperShadows, OfLamps)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Sun->SetPositional(true);
  hills.Sun->SetConeAngle(90.0);
  const glm::dvec3 lamp(150.0, 170.0, 150.0);
  hills.Sun->SetPosition(lamp.x, lamp.y, lamp.z);
  const Count count = judge(hills, surfaceOf(hills),
    [&](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)
    { return seesLight(lamp - point, 1.0)(query, point, hit); });
  EXPECT_EQ(count.Wrong, 0);
  EXPECT_GT(count.Lit, 100);
  EXPECT_GT(count.Dark, 20);
}

// Shares of a wide sun against its horizon, bisected by rays in double.
TEST(OpenGLTerrainMapperShadows, HaveTheEdgeOfADisc)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  const double azimuth = 135.0;
  const double altitude = 9.0;
  const double radius = 3.0;
  hills.Shine(azimuth, altitude);
  hills.Mapper->SetSunAngle(2.0 * radius);
  auto at = [&](double degrees)
  {
    hills.Shine(azimuth, degrees);
    const glm::dvec3 way = wayOf(hills.Sun);
    hills.Shine(azimuth, altitude);
    return way;
  };
  const Count count = judge(hills, surfaceOf(hills),
    [&](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& /*hit*/)
    {
      auto isOver = [&](double degrees)
      {
        terrain::QueryRay ray;
        ray.Origin = point + glm::dvec3(0.0, 0.0, 1e-7);
        ray.Direction = at(degrees);
        return query.Any(ray);
      };
      double low = altitude - radius;
      double high = altitude + radius;
      if (!isOver(low) || isOver(high))
      {
        return isOver(high) ? 0.0 : 1.0;
      }
      for (int k = 0; k < 20; ++k)
      {
        const double middle = 0.5 * (low + high);
        (isOver(middle) ? low : high) = middle;
      }
      const double x = (low - altitude) / radius;
      return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / vtkMath::Pi();
    });
  EXPECT_EQ(count.Wrong, 0);
  EXPECT_GT(count.Lit, 100);
  EXPECT_GT(count.Dark, 100);
  EXPECT_GT(count.Between, 300);
}

//------------------------------------------------------------------------------
// Lights that cast none, and such as have no direction.
TEST(OpenGLTerrainMapperShadows, AreOnlyOfLightsThatCastThem)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Shine(135.0, 8.0);
  const auto plain = hills.Picture(false);
  const auto shadowed = hills.Picture(true);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(plain, shadowed, 8), 200);
  hills.Sun->SetShadowAttenuation(0.0f);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(plain, hills.Picture(true), 0), 0);
  hills.Sun->SetShadowAttenuation(0.5f);
  const Count half = judge(hills, surfaceOf(hills),
    [&](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)
    { return 0.5 + 0.5 * seesLight(wayOf(hills.Sun))(query, point, hit); });
  EXPECT_EQ(half.Wrong, 0);
  hills.Sun->SetShadowAttenuation(1.0f);
  hills.Actor->GetProperty()->SetLighting(false);
  const auto unlit = hills.Picture(false);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(unlit, hills.Picture(true), 0), 0);
  hills.Actor->GetProperty()->SetLighting(true);
  hills.Sun->SetLightTypeToHeadlight();
  const auto headlit = hills.Picture(false);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(headlit, hills.Picture(true), 0), 0);
  hills.Sun->SetLightTypeToSceneLight();
  hills.Sun->SetPosition(0.0, 0.0, 0.0); // as the focal point
  hills.Picture(true);
  hills.Sun->SetPosition(vtkMath::Nan(), 0.0, 0.0);
  hills.Picture(true);
}

// A sun below the horizon.
TEST(OpenGLTerrainMapperShadows, CoverAllUnderASunBelowTheHorizon)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  lookOver(hills);
  hills.Shine(135.0, -5.0);
  EXPECT_EQ(judgeSun(hills).Wrong, 0);
  hills.Mapper->SetSunAngle(4.0);
  hills.Shine(135.0, -88.0);
  hills.Picture(true);
}

//------------------------------------------------------------------------------
namespace
{
/// A point array of an image between its samples.
double valueAt(vtkImageData* image, const char* name, double x, double y)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  const int* size = image->GetDimensions();
  const int i = std::clamp(static_cast<int>(x), 0, size[0] - 2);
  const int j = std::clamp(static_cast<int>(y), 0, size[1] - 2);
  double value = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double share =
      (corner % 2 == 1 ? x - i : 1.0 - (x - i)) * (corner / 2 == 1 ? y - j : 1.0 - (y - j));
    const vtkIdType sample = i + corner % 2 + vtkIdType{ size[0] } * (j + corner / 2);
    value += share * array->GetComponent(sample, 0);
  }
  return value;
}
}

// The light of the sky is the sky view factor of vtkTerrainHorizon.
TEST(OpenGLTerrainMapperShadows, SkyLightIsTheShareOfTheSkyThatIsSeen)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  hills.Mapper->SetVerticalExaggeration(3.0);
  hills.Look(20.0, -20.0, 600.0, 20.0, 16.0, 250.0);
  hills.Sun->SetIntensity(0.0);
  hills.Actor->GetProperty()->SetDiffuse(0.9);
  hills.Mapper->SetSkyLight(0.8);
  vtkNew<vtkImageData> drawn; // of the heights as drawn
  drawn->DeepCopy(hills.Heights);
  vtkDataArray* heights = drawn->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < heights->GetNumberOfTuples(); ++k)
  {
    heights->SetComponent(k, 0, 3.0 * heights->GetComponent(k, 0));
  }
  vtkNew<vtkTerrainHorizon> horizon;
  horizon->SetInputData(drawn);
  horizon->Update();
  const auto picture = vtkTerrainTesting::Render(hills.Scene.Window);
  const terrain::RayQuery query(surfaceOf(hills));
  const terrain::PixelRays rays = hills.Rays();
  const glm::dvec3 scale(10.0, 12.0, 3.0);
  int pixels = 0;
  int wrong = 0;
  double darkest = 1.0;
  for (int y = 0; y < DrawingHeight; ++y)
  {
    for (int x = 0; x < DrawingWidth; ++x)
    {
      terrain::QueryRay ray;
      ray.Origin = scale * terrain::AtPixel(rays.OriginGC, { x + 0.5, y + 0.5 });
      ray.Direction = scale * terrain::AtPixel(rays.DirectionGC, { x + 0.5, y + 0.5 });
      const terrain::SurfaceHit hit = query.First(ray);
      if (hit.Found && hit.FromAbove)
      {
        const glm::dvec2 at = glm::dvec2(hit.Cell) + hit.Fraction;
        const double share = valueAt(horizon->GetOutput(), "SkyView", at.x, at.y);
        const double expected = 255.0 * 0.8 * 0.9 * share;
        ++pixels;
        wrong += std::abs(picture->GetScalarComponentAsDouble(x, y, 0, 0) - expected) > 1.6 ? 1 : 0;
        darkest = std::min(darkest, share);
      }
    }
  }
  EXPECT_GT(pixels, 1000);
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(darkest, 0.7);
}

TEST(OpenGLTerrainMapperShadows, SkyLightIsAddedToEveryMaterial)
{
  Sunlit hills(vtkTerrainTesting::MakeHills(true));
  lookOver(hills);
  hills.Shine(135.0, 30.0);
  for (const int interpolation : { VTK_GOURAUD, VTK_PBR })
  {
    hills.Actor->GetProperty()->SetInterpolation(interpolation);
    hills.Mapper->SetSkyLight(0.0);
    const auto without = vtkTerrainTesting::Render(hills.Scene.Window);
    hills.Mapper->SetSkyLight(0.4);
    const auto with = vtkTerrainTesting::Render(hills.Scene.Window);
    int brighter = 0;
    int darker = 0;
    for (vtkIdType k = 0; k < with->GetNumberOfPoints(); ++k)
    {
      const double change = with->GetPointData()->GetScalars()->GetComponent(k, 0) -
        without->GetPointData()->GetScalars()->GetComponent(k, 0);
      brighter += change > 8.0 ? 1 : 0;
      darker += change < 0.0 ? 1 : 0;
    }
    EXPECT_GT(brighter, 1000) << interpolation;
    EXPECT_EQ(darker, 0) << interpolation;
  }
}
