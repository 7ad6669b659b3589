// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of the surface on itself, judged pixel by pixel by rays in double precision.
#include "vtkTerrainTestSunlit.h"
#include "vtkTerrainTestingScene.h"

#include "core/rays/RayQuery.h"
#include "core/surface/Cutting.h"
#include "data/ImageSurface.h"
#include "vtkTerrainSource.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using vtkTerrainTesting::DrawingHeight;
using vtkTerrainTesting::DrawingWidth;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;
using vtkTerrainTesting::LookOver;
using vtkTerrainTesting::Sunlit;
using vtkTerrainTesting::SurfaceOf;
using vtkTerrainTesting::WayTo;

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
  int Beside = 0;
  int Wrong = 0;
};

/// The share that the point in a place of the picture should get; NaN if that cannot be told. The
/// point is on the surface below or above that of a distance that was drawn or, without one, where
/// the ray meets the surface.
double ShareAt(Sunlit& drawing, const terrain::RayQuery& query, const glm::dvec2& pixel,
  const ShareFunction& share, double distance = terrain::kInfinity)
{
  const terrain::GridGeometry& frame = query.GetSurface().Frame;
  const terrain::PixelRays rays = drawing.Rays();
  terrain::QueryRay ray;
  const double cells = drawing.Heights->GetSpacing()[0] / frame.Spacing.x; // of detail
  const glm::dvec3 scale(frame.Spacing * cells, frame.Exaggeration);
  ray.Origin = frame.Origin + scale * terrain::AtPixel(rays.OriginGC, pixel);
  ray.Direction = scale * terrain::AtPixel(rays.DirectionGC, pixel);
  if (!std::isinf(distance))
  {
    glm::dvec3 point = ray.Origin + distance * ray.Direction;
    const auto groundAt = [&](const glm::dvec3& at)
    { return frame.Origin.z + frame.Exaggeration * query.HeightAt(at.x, at.y); };
    const glm::dvec3 step =
      1e-4 * frame.Spacing.x / glm::length(glm::dvec2(ray.Direction)) * ray.Direction;
    if (groundAt(point + step) - groundAt(point - step) < 2.0 * step.z)
    {
      return terrain::kNaN; // seen from below, where a search has passed the surface by
    }
    point.z = groundAt(point);
    return share(query, point, {});
  }
  const terrain::SurfaceHit hit = query.First(ray);
  return hit.Found && hit.FromAbove ? share(query, ray.Origin + hit.Distance * ray.Direction, hit)
                                    : terrain::kNaN;
}

/// What a light gives of itself in a pixel of two pictures, without and with shadows, is a share.
bool IsShare(double before, double after, double share)
{
  return std::isnan(share) || std::abs(after - share * before) <= 2.0;
}

/// Compares the pixels that the light reaches without shadows with the share that they should get:
/// that of their centre or, counted apart, of a point at most so many pixels beside it. Distances:
/// as drawn, at which the points are instead.
Count Judge(Sunlit& drawing, const terrain::Surface& surface, const ShareFunction& share,
  double beside = 0.0, vtkImageData* distances = nullptr)
{
  const terrain::RayQuery query(surface);
  const auto open = drawing.Picture(false);
  const auto shadowed = drawing.Picture(true);
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
      const glm::dvec2 centre(x + 0.5, y + 0.5);
      const double expected = ShareAt(drawing, query, centre, share,
        distances ? distances->GetScalarComponentAsDouble(x, y, 0, 0) : terrain::kInfinity);
      if (std::isnan(expected))
      {
        ++count.Undecided;
        continue;
      }
      const double after = shadowed->GetScalarComponentAsDouble(x, y, 0, 0);
      count.Lit += expected == 1.0 ? 1 : 0;
      count.Dark += expected == 0.0 ? 1 : 0;
      count.Between += expected > 0.0 && expected < 1.0 ? 1 : 0;
      bool right = IsShare(before, after, expected);
      for (int k = 0; k < 25 && beside > 0.0 && !right; ++k)
      {
        const glm::dvec2 way(0.5 * beside * (k % 5 - 2), 0.5 * beside * (k / 5 - 2));
        right = IsShare(before, after, ShareAt(drawing, query, centre + way, share));
        count.Beside += right ? 1 : 0;
      }
      count.Wrong += right ? 0 : 1;
    }
  }
  return count;
}

/// Whether a point of the surface sees a light, asked of it and of points a little beside, all a
/// hair above the surface; NaN where they disagree.
ShareFunction SeesLight(const glm::dvec3& toLight, double end = terrain::kInfinity)
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

glm::dvec3 WayOf(vtkLight* light)
{
  const double* position = light->GetPosition();
  return { position[0], position[1], position[2] };
}

Count JudgeSun(Sunlit& drawing)
{
  return Judge(drawing, SurfaceOf(drawing), SeesLight(WayOf(drawing.Sun)));
}

void ExpectRight(const Count& count, const std::string& what = "")
{
  EXPECT_EQ(count.Wrong, 0) << what;
  EXPECT_GT(count.Lit, 100) << what;
  EXPECT_GT(count.Dark, 100) << what;
  EXPECT_LT(count.Undecided, (count.Lit + count.Dark) / 20 + 5) << what;
}

vtkSmartPointer<vtkImageData> Landscape(int size)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(size, size);
  source->Update();
  return source->GetOutput();
}

}

//------------------------------------------------------------------------------
// Hard shadows of every pixel, of high and low suns from all sides, through both ways of drawing.
TEST(OpenGLTerrainMapperShadows, AgreeWithRaysInDouble)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
  for (const double azimuth : { 0.0, 77.0, 135.0, 200.0, 270.0, 315.0 })
  {
    hills.Shine(azimuth, 8.0);
    ExpectRight(JudgeSun(hills), "azimuth " + std::to_string(azimuth));
  }
  hills.Shine(250.0, 1.0);
  EXPECT_EQ(JudgeSun(hills).Wrong, 0);
  hills.Shine(250.0, 89.0);
  EXPECT_EQ(JudgeSun(hills).Wrong, 0);
  hills.Shine(250.0, 90.0);
  EXPECT_EQ(JudgeSun(hills).Wrong, 0);
}

TEST(OpenGLTerrainMapperShadows, AgreeWithRaysFromNearAndFar)
{
  for (const auto mode : { vtkTerrainLook::ComputeModes::Off, vtkTerrainLook::ComputeModes::On })
  {
    Sunlit land(Landscape(513));
    land.Mapper->SetComputeMode(mode);
    land.Shine(100.0, 12.0);
    LookOver(land);
    ExpectRight(JudgeSun(land), "above");
    land.Look(200.0, 210.0, 2500.0, 260.0, 300.0, 300.0);
    ExpectRight(JudgeSun(land), "near");
    land.Look(250.0, -9000.0, 90000.0, 256.0, 256.0, 300.0);
    land.Camera()->SetViewAngle(2.0);
    ExpectRight(JudgeSun(land), "far");
  }
}

// Every technique finds the shadows of the points that it draws, which searches and meshes find a
// little beside.
TEST(OpenGLTerrainMapperShadows, AreThoseOfEveryTechnique)
{
  for (const auto technique : { Techniques::Mesh, Techniques::Equidistant, Techniques::Linear })
  {
    Sunlit hills(vtkTerrainTesting::MakeHills(), technique);
    hills.Mesh->SetCellsPerQuad(1);
    LookOver(hills);
    hills.Shine(135.0, 8.0);
    const Count count =
      Judge(hills, SurfaceOf(hills), SeesLight(WayOf(hills.Sun)), 0.0, hills.Distances());
    EXPECT_EQ(count.Wrong, 0);
    EXPECT_LT(count.Undecided, (count.Lit + count.Dark) / 10);
    EXPECT_GT(count.Dark, (count.Lit + count.Dark) / 10); // else no shadow would do
  }
}

// A tolerance moves the points that are seen, by no more than it allows, and not what is in their
// shadow.
TEST(OpenGLTerrainMapperShadows, StartOnTheSurfaceUnderATolerance)
{
  Sunlit land(Landscape(513));
  land.Mapper->SetPixelTolerance(0.25);
  land.Shine(100.0, 12.0);
  LookOver(land);
  const Count count = Judge(land, SurfaceOf(land), SeesLight(WayOf(land.Sun)), 0.25);
  EXPECT_EQ(count.Wrong, 0);
  EXPECT_LE(count.Beside, (count.Lit + count.Dark) / 30);
  EXPECT_GT(count.Dark, (count.Lit + count.Dark) / 10);
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperShadows, AreThoseOfTheExaggeratedSurface)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  hills.Mapper->SetVerticalExaggeration(2.5);
  hills.Look(20.0, -20.0, 600.0, 20.0, 16.0, 250.0);
  hills.Shine(110.0, 20.0);
  ExpectRight(JudgeSun(hills));
}

// The rays are those of the world, however the actor stands in it.
TEST(OpenGLTerrainMapperShadows, FollowTurnedActors)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
  hills.Shine(110.0, 9.0);
  const glm::dvec3 way = WayOf(hills.Sun);
  hills.Actor->SetOrigin(200.0, 190.0, 100.0);
  hills.Actor->RotateZ(40.0);
  hills.Actor->SetScale(1.0, 1.0, 1.5);
  // into the model: turned back, and lower by the scale
  const double turn = vtkMath::RadiansFromDegrees(-40.0);
  const glm::dvec3 model(std::cos(turn) * way.x - std::sin(turn) * way.y,
    std::sin(turn) * way.x + std::cos(turn) * way.y, way.z / 1.5);
  ExpectRight(Judge(hills, SurfaceOf(hills), SeesLight(model)));
}

TEST(OpenGLTerrainMapperShadows, HolesLetLightThrough)
{
  Sunlit hills(vtkTerrainTesting::MakeHills(true));
  LookOver(hills);
  hills.Shine(135.0, 8.0);
  ExpectRight(JudgeSun(hills));
}

// What is cut away hides nothing.
TEST(OpenGLTerrainMapperShadows, EndAtPlanes)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
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
  terrain::Surface surface = SurfaceOf(hills);
  surface.Planes.emplace_back(surface.Frame.PlaneToGrid({ -1.0, 0.0, 0.0, east }));
  surface.Planes.emplace_back(surface.Frame.PlaneToGrid({ 0.0, 0.0, -1.0, top }));
  ExpectRight(Judge(hills, surface, SeesLight(WayOf(hills.Sun))));
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
  terrain::Surface surface = SurfaceOf(hills);
  surface.Block = true;
  surface.Planes = { { 1.0, 0.0, 0.0, -8.0 }, { -1.0, 0.0, 0.0, 33.0 }, { 0.0, 1.0, 0.0, -5.0 },
    { 0.0, -1.0, 0.0, 28.0 }, { 0.0, 0.0, 1.0, 0.0 } };
  const Count top = Judge(hills, surface, SeesLight(WayOf(hills.Sun)));
  EXPECT_EQ(top.Wrong, 0);
  EXPECT_GT(top.Dark, 100);
  const Count walls = Judge(hills, surface,
    [](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& /*hit*/)
    { return point.z < query.HeightAt(point.x, point.y) - 1.0 ? 1.0 : terrain::kNaN; });
  EXPECT_EQ(walls.Wrong, 0);
  EXPECT_GT(walls.Lit, 100);
}

TEST(OpenGLTerrainMapperShadows, OfColumns)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
  hills.Mapper->SetSurface(vtkTerrainLook::Surfaces::Columns);
  hills.Shine(140.0, 10.0);
  terrain::Surface surface = SurfaceOf(hills);
  surface.Kind = terrain::SurfaceKind::Columns;
  const glm::dvec3 way = WayOf(hills.Sun);
  ExpectRight(Judge(hills, surface,
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
  const auto bumps = Landscape(32);
  LookOver(hills);
  hills.Mapper->SetDetailData(bumps);
  hills.Mapper->SetDetailCells(4);
  hills.Mapper->SetDetailScale(0.02);
  hills.Shine(140.0, 10.0);
  terrain::ImageSurface image;
  image.SetImage(hills.Heights);
  image.SetDetail(bumps);
  ExpectRight(Judge(hills, image.GetDetailedSurface(1.0, 4, 0.02), SeesLight(WayOf(hills.Sun))));
}

//------------------------------------------------------------------------------
// A lamp over the land: rays end there.
TEST(OpenGLTerrainMapperShadows, OfLamps)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
  hills.Sun->SetPositional(true);
  hills.Sun->SetConeAngle(90.0);
  const glm::dvec3 lamp(150.0, 170.0, 150.0);
  hills.Sun->SetPosition(lamp.x, lamp.y, lamp.z);
  const Count count = Judge(hills, SurfaceOf(hills),
    [&](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)
    { return SeesLight(lamp - point, 1.0)(query, point, hit); });
  EXPECT_EQ(count.Wrong, 0);
  EXPECT_GT(count.Lit, 100);
  EXPECT_GT(count.Dark, 20);
}

// Shares of a wide sun against its horizon, bisected by rays in double; also of one whose lower
// part is below all of the terrain.
TEST(OpenGLTerrainMapperShadows, HaveTheEdgeOfADisc)
{
  const double azimuth = 135.0;
  const double radius = 3.0;
  for (const double altitude : { 9.0, 1.0 })
  {
    Sunlit hills(vtkTerrainTesting::MakeHills());
    LookOver(hills);
    hills.Mapper->SetSunAngle(2.0 * radius);
    hills.Shine(azimuth, altitude);
    const Count count = Judge(hills, SurfaceOf(hills),
      [&](
        const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& /*hit*/)
      {
        const auto isOver = [&](double degrees)
        {
          terrain::QueryRay ray;
          ray.Origin = point + glm::dvec3(0.0, 0.0, 1e-7);
          ray.Direction = WayTo(azimuth, degrees);
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
    EXPECT_EQ(count.Wrong, 0) << altitude;
    EXPECT_GT(count.Dark, 100) << altitude;
    EXPECT_GT(count.Between, 300) << altitude;
  }
}

//------------------------------------------------------------------------------
// Lights that cast none, and such as have no direction.
TEST(OpenGLTerrainMapperShadows, AreOnlyOfLightsThatCastThem)
{
  Sunlit hills(vtkTerrainTesting::MakeHills());
  LookOver(hills);
  hills.Shine(135.0, 8.0);
  const auto plain = hills.Picture(false);
  const auto shadowed = hills.Picture(true);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(plain, shadowed, 8), 200);
  hills.Sun->SetShadowAttenuation(0.0f);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(plain, hills.Picture(true), 0), 0);
  hills.Sun->SetShadowAttenuation(0.5f);
  const Count half = Judge(hills, SurfaceOf(hills),
    [&](const terrain::RayQuery& query, const glm::dvec3& point, const terrain::SurfaceHit& hit)
    { return 0.5 + 0.5 * SeesLight(WayOf(hills.Sun))(query, point, hit); });
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
  LookOver(hills);
  hills.Shine(135.0, -5.0);
  EXPECT_EQ(JudgeSun(hills).Wrong, 0);
  hills.Mapper->SetSunAngle(4.0);
  hills.Shine(135.0, -88.0);
  hills.Picture(true);
}
