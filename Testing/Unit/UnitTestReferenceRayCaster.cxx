// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The reference against closed forms, and against dense sampling of random rays and fields.
#include "core/grid/Constants.h"
#include "core/rays/ReferenceRayCaster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
/// A field with its caster.
struct Scene
{
  template <typename Function>
  Scene(std::int64_t width, std::int64_t height, Function&& heightAt,
    const terrain::GridGeometry& geometry = {})
    : Samples(Fill(width, height, heightAt))
    , View{ this->Samples.data(), width, height, nullptr, 0xff, false, 0.0 }
    , Geometry(geometry)
    , Caster(this->View, geometry, terrain::SerialFor)
  {
  }

  template <typename Function>
  static std::vector<double> Fill(std::int64_t width, std::int64_t height, Function&& heightAt)
  {
    std::vector<double> samples;
    for (std::int64_t j = 0; j < height; ++j)
    {
      for (std::int64_t i = 0; i < width; ++i)
      {
        samples.push_back(heightAt(i, j));
      }
    }
    return samples;
  }

  /// Height of a ray above the surface in height units; NaN where there is none.
  double Above(const terrain::ReferenceRay& ray, double distance) const
  {
    const glm::dvec3 p = this->Geometry.ToGrid(ray.Origin + distance * ray.Direction);
    const auto i = static_cast<std::int64_t>(std::floor(p.x));
    const auto j = static_cast<std::int64_t>(std::floor(p.y));
    if (i < 0 || j < 0 || i >= this->View.Width - 1 || j >= this->View.Height - 1)
    {
      return terrain::kNaN;
    }
    const double x = p.x - static_cast<double>(i);
    const double y = p.y - static_cast<double>(j);
    return p.z -
      ((1.0 - y) * ((1.0 - x) * this->View.At(i, j) + x * this->View.At(i + 1, j)) +
        y * ((1.0 - x) * this->View.At(i, j + 1) + x * this->View.At(i + 1, j + 1)));
  }

  std::vector<double> Samples;
  terrain::HeightfieldView<double> View;
  terrain::GridGeometry Geometry;
  terrain::ReferenceRayCaster<double> Caster;
};

terrain::ReferenceRay MakeReferenceRay(const glm::dvec3& origin, const glm::dvec3& direction)
{
  terrain::ReferenceRay ray;
  ray.Origin = origin;
  ray.Direction = direction;
  return ray;
}

double Flat(std::int64_t, std::int64_t)
{
  return 2.0;
}
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, PlaneFromBothSides)
{
  const Scene scene(100, 80,
    [](std::int64_t i, std::int64_t j) { return 3.0 + 0.5 * static_cast<double>(i - 2 * j); });
  for (const double side : { 1.0, -1.0 })
  {
    const glm::dvec3 target(20.3, 41.8, 3.0 + 0.5 * (20.3 - 2.0 * 41.8));
    const glm::dvec3 direction(0.3, -0.2, -side);
    const auto hit = scene.Caster.Cast(MakeReferenceRay(target - 200.0 * direction, direction));
    ASSERT_TRUE(hit.Found);
    EXPECT_NEAR(hit.Distance, 200.0, 1e-11);
    EXPECT_EQ(hit.CellX, 20);
    EXPECT_EQ(hit.CellY, 41);
    EXPECT_NEAR(hit.Fraction.x, 0.3, 1e-10);
    EXPECT_NEAR(hit.Fraction.y, 0.8, 1e-10);
    EXPECT_EQ(hit.FromAbove, side > 0.0);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 1.0, 1.0));
    EXPECT_NEAR(glm::length(hit.Normal - normal), 0.0, 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, PatchIsAHyperbolicParaboloid)
{
  const Scene scene(
    2, 2, [](std::int64_t i, std::int64_t j) { return i == 1 && j == 1 ? 4.0 : 0.0; });
  // z = 4xy; along x = y = t at height 1 the ray meets it at t = 1/2.
  const auto hit = scene.Caster.Cast(MakeReferenceRay({ 0.0, 0.0, 1.0 }, { 1.0, 1.0, 0.0 }));
  ASSERT_TRUE(hit.Found);
  EXPECT_NEAR(hit.Distance, 0.5, 1e-14);
  EXPECT_NEAR(glm::length(hit.Normal - glm::normalize(glm::dvec3(-2.0, -2.0, 1.0))), 0.0, 1e-13);
  // Along x = 1 - y = t the patch rises to 1 at t = 1/2 above samples of 0: two roots.
  const auto first = scene.Caster.Cast(MakeReferenceRay({ 0.0, 1.0, 0.75 }, { 1.0, -1.0, 0.0 }));
  ASSERT_TRUE(first.Found);
  EXPECT_NEAR(first.Distance, 0.25, 1e-14);
  auto behind = MakeReferenceRay({ 0.0, 1.0, 0.75 }, { 1.0, -1.0, 0.0 });
  behind.Begin = 0.5;
  const auto second = scene.Caster.Cast(behind);
  ASSERT_TRUE(second.Found);
  EXPECT_NEAR(second.Distance, 0.75, 1e-14);
  EXPECT_FALSE(second.FromAbove);
  behind.End = 0.7;
  EXPECT_FALSE(scene.Caster.Cast(behind).Found);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, GeometryAndExaggeration)
{
  terrain::GridGeometry geometry;
  geometry.Origin = { 500000.0, 4000000.0, 100.0 };
  geometry.Spacing = { 30.0, 20.0 };
  geometry.Exaggeration = 3.0;
  const Scene scene(
    50, 50, [](std::int64_t i, std::int64_t) { return static_cast<double>(i); }, geometry);
  const auto hit =
    scene.Caster.Cast(MakeReferenceRay({ 500300.0, 4000410.0, 9100.0 }, { 0.0, 0.0, -2.0 }));
  ASSERT_TRUE(hit.Found);
  EXPECT_NEAR(hit.Distance, 0.5 * (9000.0 - 30.0), 1e-9);
  EXPECT_NEAR(glm::length(hit.Normal - glm::normalize(glm::dvec3(-0.1, 0.0, 1.0))), 0.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, RaysOnGridLinesAndBorders)
{
  const Scene scene(70, 70, Flat);
  const double inf = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& p : { glm::dvec2(0.0, 0.0), glm::dvec2(69.0, 69.0), glm::dvec2(32.0, 64.0),
         glm::dvec2(33.0, 10.5), glm::dvec2(0.0, 69.0) })
  {
    EXPECT_EQ(scene.Caster.Cast(MakeReferenceRay({ p, 5.0 }, { 0.0, 0.0, -1.0 })).Distance, 3.0);
    EXPECT_EQ(scene.Caster.Cast(MakeReferenceRay({ p, -5.0 }, { 0.0, 0.0, 1.0 })).Distance, 7.0);
  }
  EXPECT_FALSE(scene.Caster.Cast(MakeReferenceRay({ 69.001, 3.0, 5.0 }, { 0.0, 0.0, -1.0 })).Found);
  EXPECT_FALSE(scene.Caster.Cast(MakeReferenceRay({ 10.0, 3.0, 5.0 }, { 0.0, 0.0, 1.0 })).Found);
  EXPECT_FALSE(scene.Caster.Cast(MakeReferenceRay({ 10.0, 3.0, 5.0 }, { 0.0, 0.0, 0.0 })).Found);
  EXPECT_FALSE(scene.Caster.Cast(MakeReferenceRay({ -5.0, 3.0, inf }, { 0.0, 1.0, 0.0 })).Found);
  // Along a line of the grid, from west to east and back.
  EXPECT_NEAR(scene.Caster.Cast(MakeReferenceRay({ -1.0, 32.0, 4.0 }, { 1.0, 0.0, -0.1 })).Distance,
    20.0, 1e-12);
  EXPECT_NEAR(
    scene.Caster.Cast(MakeReferenceRay({ 70.0, 32.0, 4.0 }, { -1.0, 0.0, -0.1 })).Distance, 20.0,
    1e-12);
  // Within the surface: where it enters.
  EXPECT_EQ(
    scene.Caster.Cast(MakeReferenceRay({ -1.0, 3.5, 2.0 }, { 1.0, 0.0, 0.0 })).Distance, 1.0);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, CellsWithoutDataHaveNoSurface)
{
  const Scene scene(
    9, 9, [](std::int64_t i, std::int64_t j) { return i == 4 && j == 4 ? terrain::kNaN : 2.0; });
  for (double x = 2.5; x < 6.0; x += 1.0)
  {
    const bool hole = x > 3.0 && x < 5.0;
    EXPECT_EQ(
      scene.Caster.Cast(MakeReferenceRay({ x, 4.5, 9.0 }, { 0.0, 0.0, -1.0 })).Found, !hole);
  }
  // On the line between a cell and a hole there is the cell's edge, whichever side it is on.
  EXPECT_TRUE(scene.Caster.Cast(MakeReferenceRay({ 3.0, 4.5, 9.0 }, { 0.0, 0.0, -1.0 })).Found);
  EXPECT_TRUE(scene.Caster.Cast(MakeReferenceRay({ 5.0, 4.5, 9.0 }, { 0.0, 0.0, -1.0 })).Found);
  EXPECT_TRUE(scene.Caster.Cast(MakeReferenceRay({ 4.5, 3.0, 9.0 }, { 0.0, 0.0, -1.0 })).Found);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, DegenerateGrids)
{
  for (const auto& size :
    { glm::ivec2(0, 0), glm::ivec2(1, 1), glm::ivec2(1, 8), glm::ivec2(8, 1) })
  {
    const Scene scene(size.x, size.y, Flat);
    EXPECT_FALSE(scene.Caster.Cast(MakeReferenceRay({ 0.0, 0.0, 9.0 }, { 0.0, 0.0, -1.0 })).Found);
  }
  const Scene none(9, 9, [](std::int64_t, std::int64_t) { return terrain::kNaN; });
  EXPECT_FALSE(none.Caster.Cast(MakeReferenceRay({ 3.3, 3.3, 9.0 }, { 0.0, 0.0, -1.0 })).Found);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, AgreesWithDenseSampling)
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int hits = 0;
  for (int run = 0; run < 60; ++run)
  {
    const double roughness = run % 3 == 0 ? 8.0 : 1.5;
    const Scene scene(40, 75,
      [&](std::int64_t, std::int64_t) {
        return run % 4 == 3 && uniform(random) > 0.9 ? terrain::kNaN : roughness * uniform(random);
      });
    for (int k = 0; k < 20; ++k)
    {
      const glm::dvec3 from(
        20.0 + 40.0 * uniform(random), 37.0 + 60.0 * uniform(random), 15.0 * uniform(random));
      const glm::dvec3 to(
        20.0 + 19.0 * uniform(random), 37.0 + 36.0 * uniform(random), roughness * uniform(random));
      auto ray = MakeReferenceRay(from, to - from);
      ray.End = 2.0;
      const auto hit = scene.Caster.Cast(ray);
      hits += hit.Found ? 1 : 0;
      // No sign change between neighbouring samples before the hit, and one at it.
      const double step = 1e-3 / glm::length(ray.Direction);
      const double end = hit.Found ? hit.Distance - 1e-9 : ray.End;
      double last = terrain::kNaN;
      for (double s = 0.0; s < end; s += step)
      {
        const double above = scene.Above(ray, s);
        ASSERT_FALSE(last * above < 0.0) << "run " << run << " ray " << k << " at " << s;
        last = above;
      }
      if (hit.Found)
      {
        const glm::dvec3 p = ray.Origin + hit.Distance * ray.Direction;
        EXPECT_NEAR(
          p.x, static_cast<double>(hit.CellX) + hit.Fraction.x, terrain::kReferenceTolerance);
        EXPECT_NEAR(
          p.y, static_cast<double>(hit.CellY) + hit.Fraction.y, terrain::kReferenceTolerance);
        EXPECT_EQ(scene.Above(ray, hit.Distance - 1e-6) < 0.0, !hit.FromAbove);
      }
    }
  }
  EXPECT_GT(hits, 500);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, CameraRendersDistancesAlongTheViewingDirection)
{
  const Scene scene(200, 200, Flat);
  auto camera = terrain::MakeReferenceCamera(
    { 100.0, 100.0, 52.0 }, { 100.0, 100.0, 2.0 }, { 0.0, 1.0, 0.0 }, 90.0, 8, 6);
  for (const double depth : scene.Caster.RenderDepth(camera, terrain::SerialFor))
  {
    EXPECT_NEAR(depth, 50.0, 1e-10);
  }
  camera.Far = 49.0;
  for (const double depth : scene.Caster.RenderDepth(camera, terrain::SerialFor))
  {
    EXPECT_TRUE(std::isnan(depth));
  }
  // The upper left pixel looks north-west.
  const auto ray = camera.PixelRay(0, 0);
  EXPECT_LT(ray.Direction.x, 0.0);
  EXPECT_GT(ray.Direction.y, 0.0);
  EXPECT_NEAR(ray.Direction.x, -4.0 / 3.0 * 7.0 / 8.0, 1e-12);
  camera.Far = 1e9;
  camera.Parallel = true;
  EXPECT_EQ(camera.PixelRay(3, 2).Direction, camera.Forward);
  EXPECT_EQ(scene.Caster.RenderDepth(camera, terrain::SerialFor)[0], 50.0);
}

//------------------------------------------------------------------------------
TEST(ReferenceRayCaster, FindsSilhouettes)
{
  // A ridge along y = 50, 10 high, on a flat field.
  const Scene scene(100, 100, [](std::int64_t, std::int64_t j) { return j == 50 ? 10.0 : 0.0; });
  const auto overRidge = [](double height) {
    return MakeReferenceRay({ 50.3, 10.0, height }, { 0.0, 1.0, 0.0 });
  };
  EXPECT_FALSE(scene.Caster.IsNearSilhouette(overRidge(9.9), 1e-3));
  EXPECT_TRUE(scene.Caster.IsNearSilhouette(overRidge(9.9999), 1e-3));
  EXPECT_TRUE(scene.Caster.IsNearSilhouette(overRidge(10.0001), 1e-3));
  EXPECT_FALSE(scene.Caster.IsNearSilhouette(overRidge(10.1), 1e-3));
  EXPECT_EQ(scene.Caster.SilhouetteDistance(overRidge(10.00005), 1.0), 1e-4);
  EXPECT_FALSE(std::isfinite(scene.Caster.SilhouetteDistance(overRidge(15.0), 1.0)));
  // The border of the grid is a silhouette, too.
  const auto down = MakeReferenceRay({ 98.9995, 20.0, 30.0 }, { 0.0, 0.0, -1.0 });
  EXPECT_EQ(scene.Caster.SilhouetteDistance(down, 1.0), 1e-3);
}
