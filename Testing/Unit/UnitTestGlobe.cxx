// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestGlobe.h"

#include <gtest/gtest.h>

namespace
{
using terrain::GlobeRays;
using terrain::kDegree;

// How casts of Real agree with the reference: hits, and depths within a part of them and of a
// length.
template <typename Real>
void CompareWithReference(int count, double part, double length)
{
  for (const terrain::TestGlobe& globe : terrain::TestGlobes())
  {
    SCOPED_TRACE(globe.Name);
    ASSERT_EQ(globe.Grid.WhyNot(), "");
    const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
    const terrain::GlobeReference reference = world.Reference();
    for (int kind = 0; kind < GlobeRays::Count; ++kind)
    {
      SCOPED_TRACE(kind);
      GlobeRays rays(globe, static_cast<unsigned>(kind) + 1);
      for (int i = 0; i < count; ++i)
      {
        const terrain::GlobeReferenceRay ray = rays.Make(kind);
        const terrain::WorldTracer<Real, std::uint16_t> tracer(world, ray.Origin);
        const auto hit = tracer.Trace(ray);
        const auto expected = reference.Cast(ray);
        // a ray that touches a summit may be told either way
        ASSERT_TRUE(hit.Found == expected.Found || expected.Nearest < length)
          << "ray " << i << " misses by " << expected.Nearest << " m";
        if (hit.Found && expected.Found)
        {
          ASSERT_NEAR(hit.T, expected.T, part * expected.T + length) << "ray " << i;
        }
      }
    }
  }
}

TEST(Globe, IsExactInDouble)
{
  CompareWithReference<double>(6, 0.0, terrain::kGlobeError);
}

TEST(Globe, IsExactInFloat)
{
  CompareWithReference<float>(6, terrain::kGlobeFloatPartError, terrain::kGlobeFloatError);
}

// 2 m above the ground of a raster of 8192 columns depths are as exact as from space.
TEST(Globe, ResolvesTheGroundBesideTheEye)
{
  const terrain::TestGlobe globe{ "fine",
    terrain::MakeGrid({}, 6.0, 360.0 / 8192.0, 400, terrain::Parallels(44.0, 360.0 / 8192.0, 300)),
    [](int i, int j)
    { return std::floor(2000.0 + 300.0 * std::sin(0.9 * i) * std::cos(0.7 * j)); } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const terrain::GlobeReference reference = world.Reference();
  GlobeRays rays(globe, 7);
  int off = 0;
  constexpr int count = 400;
  for (int i = 0; i < count; ++i)
  {
    const terrain::GlobeReferenceRay ray = rays.Make(GlobeRays::Ground);
    const terrain::WorldTracer<float, std::uint16_t> tracer(world, ray.Origin);
    const auto hit = tracer.Trace(ray);
    const auto expected = reference.Cast(ray);
    const bool agree = hit.Found == expected.Found &&
      (!hit.Found || std::abs(hit.T - expected.T) < terrain::kGlobeDrawnError * expected.T);
    off += agree ? 0 : 1;
  }
  EXPECT_LE(off, count / 1000);
}

// Rays at points of the surface on the lines between cells, in float: none passes between two
// cells, and none sees the underside.
TEST(Globe, IsWatertight)
{
  const double step = 360.0 / 2048.0;
  const terrain::TestGlobe globe{ "smooth",
    terrain::MakeGrid({}, -180.0, step, 2049, terrain::Parallels(-90.0, step, 1025)),
    [](int i, int j)
    { return std::floor(3000.0 * std::sin(0.021 * i) * std::cos(0.017 * j) + 20.0 * (i % 3)); } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const glm::dvec3 eye = globe.Grid.Body.ToPosition({ 0.3, 0.4, 4e6 });
  const terrain::WorldTracer<float, std::uint16_t> tracer(
    world, globe.Grid.Body.ToPosition({ 0.3, 0.4, 0.0 }));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int leaks = 0;
  for (int k = 0; k < 50000; ++k)
  {
    double column = (0.3 + 0.5 * uniform(generator)) / globe.Grid.Step + 1024.0;
    const int row = 512 + static_cast<int>((0.4 + 0.5 * uniform(generator)) / globe.Grid.Step);
    column = k % 2 == 0 ? column : std::floor(column);
    const int cell = static_cast<int>(column);
    const double height =
      glm::mix(world.Height(cell, row), world.Height(std::min(cell + 1, 2048), row), column - cell);
    const glm::dvec3 target =
      globe.Grid.Body.ToPosition({ globe.Grid.West + column * globe.Grid.Step,
        globe.Grid.Latitudes[static_cast<std::size_t>(row)], height });
    terrain::GlobeReferenceRay ray;
    ray.Direction = glm::normalize(target - eye);
    ray.Origin = target - 1e5 * ray.Direction;
    ray.End = 1e8;
    const auto hit = tracer.Trace(ray);
    leaks += hit.Found && hit.Front && hit.T < 1.01e5f ? 0 : 1;
  }
  EXPECT_EQ(leaks, 0);
}

// Flat ground, as the sea of global rasters is: the box of a node has no height there, and float,
// which counts from an anchor far away, rounds the place where a ray comes to it to below the
// ground.
TEST(Globe, HasNoHolesInFlatGround)
{
  const double step = 360.0 / 2048.0;
  const terrain::TestGlobe globe{ "flat",
    terrain::MakeGrid({}, -180.0, step, 2049, terrain::Parallels(-90.0, step, 1025)),
    [](int i, int j) { return (i / 97 + j / 61) % 5 == 0 ? 5000.0 : 0.0; } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const glm::dvec3 eye = globe.Grid.Body.ToPosition({ 0.3, 0.4, 1.5e7 });
  const terrain::WorldTracer<float, std::uint16_t> tracer(
    world, globe.Grid.Body.ToPosition({ 0.3, 0.4, 0.0 }));
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int holes = 0;
  for (int k = 0; k < 100000; ++k)
  {
    const glm::dvec3 target = globe.Grid.Body.ToPosition(
      { 0.3 + 0.9 * uniform(generator), 0.4 + 0.9 * uniform(generator), 0.0 });
    terrain::GlobeReferenceRay ray;
    ray.Direction = glm::normalize(target - eye);
    if (glm::dot(ray.Direction, glm::normalize(target)) > -0.05)
    {
      continue;
    }
    ray.Origin = target - 3e5 * ray.Direction;
    ray.End = 1e8;
    const auto hit = tracer.Trace(ray);
    holes += hit.Found && hit.Front && hit.T < 3.01e5f ? 0 : 1;
  }
  EXPECT_EQ(holes, 0);
}

// Flat ground about an anchor, along its parallel: what is rounded there is a part of the way along
// the ray alone, for the place itself is near the anchor.
TEST(Globe, HasNoHolesAboutItsAnchor)
{
  const double step = 1.0 / 120.0;
  const terrain::TestGlobe globe{ "flat",
    terrain::MakeGrid({}, 24.0, step, 1025, terrain::Parallels(24.0, step, 1025)),
    [](int i, int j) { return (i / 97 + j / 61) % 5 == 0 ? 8000.0 : 0.0; } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const terrain::Ellipsoid& body = globe.Grid.Body;
  std::mt19937 generator(29);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int holes = 0;
  for (int view = 0; view < 40; ++view)
  {
    // the eye is above a place near the line of its anchor and the planet's centre
    const glm::dvec2 place(
      kDegree * (28.0 + 2.0 * uniform(generator)), kDegree * (28.0 + 2.0 * uniform(generator)));
    const glm::dvec3 anchor = body.ToPosition({ place, 0.0 });
    const glm::dvec3 eye = 3.2 * anchor;
    const terrain::WorldTracer<float, std::uint16_t> tracer(world, anchor);
    for (int k = 0; k < 8000; ++k)
    {
      const glm::dvec3 target = body.ToPosition(
        { place.x + 0.03 * uniform(generator), place.y + 0.0003 * uniform(generator), 0.0 });
      terrain::GlobeReferenceRay ray;
      ray.Direction = glm::normalize(target - eye);
      ray.Origin = target - 1.8e5 * ray.Direction;
      ray.End = 1e8;
      const auto hit = tracer.Trace(ray);
      holes += hit.Found && hit.Front && hit.T < 1.81e5f ? 0 : 1;
    }
  }
  EXPECT_EQ(holes, 0);
}

// A million points of a planet, poles and date line among them, each seen by one of a thousand
// eyes.
TEST(Globe, PicksPlacesToAMillimetre)
{
  const double step = 0.25;
  const terrain::TestGlobe globe{ "smooth",
    terrain::MakeGrid({}, -180.0, step, 1441, terrain::Parallels(-90.0, step, 721)),
    [step](int i, int j)
    {
      const double cosine = std::cos((step * j - 90.0) * kDegree);
      return std::floor(
        4000.0 + 2500.0 * std::sin(0.05 * i) * cosine * cosine + 1500.0 * std::sin(0.09 * j));
    } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const terrain::GlobeGrid& grid = globe.Grid;
  const auto position = [&world, &grid](const glm::dvec2& cells)
  {
    const glm::ivec2 cell = glm::min(glm::ivec2(cells), grid.Cells() - 1);
    const glm::dvec2 part = cells - glm::dvec2(cell);
    const auto row = static_cast<std::size_t>(cell.y);
    const auto height = [&](int i, int j) { return world.Height(cell.x + i, cell.y + j); };
    return grid.Body.ToPosition({ grid.West + cells.x * grid.Step,
      glm::mix(grid.Latitudes[row], grid.Latitudes[row + 1], part.y),
      glm::mix(glm::mix(height(0, 0), height(1, 0), part.x),
        glm::mix(height(0, 1), height(1, 1), part.x), part.y) });
  };
  std::mt19937 generator(23);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double farthest = 0.0;
  int missed = 0;
  for (int view = 0; view < 1000; ++view)
  {
    const glm::dvec2 below(1440.0 * uniform(generator), 720.0 * uniform(generator));
    const double above = 1e4 * std::pow(2000.0, uniform(generator));
    const glm::dvec3 ground = position(below);
    const glm::dvec3 eye = ground + above * glm::normalize(ground);
    const terrain::WorldTracer<double, std::uint16_t> tracer(world, eye);
    const double reach = std::min(0.5 * above / grid.Body.Equatorial, 0.5) / grid.Step;
    for (int k = 0; k < 1000; ++k)
    {
      const glm::dvec2 away(2.0 * uniform(generator) - 1.0, 2.0 * uniform(generator) - 1.0);
      glm::dvec2 target = below + reach * away;
      target.x -= 1440.0 * std::floor(target.x / 1440.0);
      target.y = std::clamp(target.y, 0.0, 720.0);
      terrain::GlobeReferenceRay ray;
      ray.Origin = eye;
      ray.Direction = glm::normalize(position(target) - eye);
      ray.End = 1e8;
      const auto hit = tracer.Trace(ray);
      missed += hit.Found ? 0 : 1;
      const glm::dvec3 found = position(glm::dvec2(hit.Cell) + hit.Fraction);
      farthest = std::max(farthest, hit.Found ? glm::length(found - position(target)) : 0.0);
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_LT(farthest, terrain::kGlobePickError);
}

// Where meridians meet, longitude changes fast along a ray, and heights of the last row with it.
TEST(Globe, HitsLieOnTheSurfaceAtThePoles)
{
  for (const double step : { 1.0, 0.25, 1.0 / 120.0 })
  {
    const terrain::TestGlobe globe = terrain::RoughPole(step);
    const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
    const terrain::GlobeReference reference = world.Reference();
    GlobeRays rays(globe, 5);
    int found = 0;
    for (int i = 0; i < 20000; ++i)
    {
      const terrain::GlobeReferenceRay ray =
        rays.Make(i % 2 == 0 ? GlobeRays::Space : GlobeRays::Grazing);
      const terrain::WorldTracer<double, std::uint16_t> tracer(world, ray.Origin);
      terrain::GlobeHit<double> hit = tracer.Trace(ray);
      if (hit.Found)
      {
        glm::dvec2 fraction;
        const glm::dvec3 position = ray.Origin + hit.T * ray.Direction;
        const double error =
          terrain::HeightErrorAt(world, hit.Cell, world.Grid.Body.ToPlace(position).y);
        EXPECT_NEAR(reference.Above(position, hit.Cell, fraction, true), 0.0, error)
          << step << " " << i << " " << hit.Cell.x << " " << hit.Cell.y;
        ++found;
      }
    }
    EXPECT_GT(found, 1000);
  }
}

// A ray that begins on the axis is on all meridians there: of a raster that does not go round, it
// goes on over the one where it goes.
TEST(Globe, LooksFromItsPole)
{
  const terrain::TestGlobe globe{ "sector",
    terrain::MakeGrid({}, 20.0, 1.0, 41, terrain::Parallels(-90.0, 1.0, 11)), [](int i, int j) {
      return j == 0 ? 500.0 : std::floor(900.0 + 700.0 * std::sin(1.3 * i + j));
    } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const terrain::GlobeReference reference = world.Reference();
  int hits = 0;
  for (int k = 0; k < 360; ++k)
  {
    terrain::GlobeReferenceRay ray;
    ray.Origin.z = -globe.Grid.Body.Polar - 510.0;
    const double longitude = (k + 0.5) * kDegree;
    ray.Direction = glm::normalize(glm::dvec3(std::cos(longitude), std::sin(longitude), 1e-3));
    ray.End = 1e8;
    const terrain::WorldTracer<double, std::uint16_t> tracer(world, ray.Origin);
    const auto hit = tracer.Trace(ray);
    const auto expected = reference.Cast(ray);
    ASSERT_EQ(hit.Found, expected.Found) << k;
    EXPECT_TRUE(!hit.Found || std::abs(hit.T - expected.T) < terrain::kGlobeError) << k;
    hits += hit.Found ? 1 : 0;
  }
  EXPECT_GT(hits, 20);
}

// Heights may be met from below, and the far side is seen through a hole.
TEST(Globe, HasTwoSides)
{
  const terrain::TestGlobe globe = terrain::TestGlobes().front();
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  terrain::GlobeReferenceRay ray;
  ray.Origin = { 0.0, 0.0, 0.0 };
  ray.Direction = { 0.6, 0.0, 0.8 };
  ray.End = 1e8;
  const terrain::WorldTracer<double, std::uint16_t> tracer(world, ray.Origin);
  const auto inside = tracer.Trace(ray);
  ASSERT_TRUE(inside.Found);
  EXPECT_FALSE(inside.Front);
  ray.Origin = 3e7 * ray.Direction;
  ray.Direction = -ray.Direction;
  const terrain::WorldTracer<double, std::uint16_t> above(world, ray.Origin);
  const auto outside = above.Trace(ray);
  ASSERT_TRUE(outside.Found);
  EXPECT_TRUE(outside.Front);
  EXPECT_NEAR(outside.T, 3e7 - inside.T, 1e-3);
}

// Height bounds let most rays cross few nodes.
TEST(Globe, CrossesFewNodes)
{
  const terrain::TestGlobe globe = terrain::TestGlobes().front();
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  GlobeRays rays(globe, 3);
  int crossings = 0;
  for (int i = 0; i < 200; ++i)
  {
    const terrain::GlobeReferenceRay ray = rays.Make(GlobeRays::Grazing);
    const terrain::WorldTracer<double, std::uint16_t> tracer(world, ray.Origin);
    crossings += tracer.Trace(ray).Crossings;
  }
  EXPECT_LT(crossings, 200 * 20);
}

// The box against positions all over the surface, the lowest and the highest.
TEST(Globe, HasTheLeastBox)
{
  std::vector<terrain::TestGlobe> globes = terrain::TestGlobes();
  const auto level = [](int, int) { return 0.0; };
  for (const double west : { -190.0, -100.0, -20.0, 30.0, 80.0, 170.0, 260.0 })
  {
    globes.push_back({ "a part, " + std::to_string(west),
      terrain::MakeGrid({}, west, 1.0, 41, terrain::Parallels(-40.0, 1.0, 31)), level });
  }
  const terrain::GlobeRange range{ -5000.0, 9000.0 };
  for (const terrain::TestGlobe& globe : globes)
  {
    SCOPED_TRACE(globe.Name);
    const terrain::GlobeGrid& grid = globe.Grid;
    glm::dvec3 low(terrain::kInfinity);
    glm::dvec3 high(-terrain::kInfinity);
    constexpr int parts = 400;
    for (int k = 0; k <= parts * parts; ++k)
    {
      const double x = k % parts / (parts - 1.0) * grid.Cells().x * grid.Step;
      const double y = std::min(k / parts / (parts - 1.0), 1.0);
      for (const double height : { range.Lowest, range.Highest })
      {
        const glm::dvec3 point = grid.Body.ToPosition(
          { grid.West + x, glm::mix(grid.Latitudes.front(), grid.Latitudes.back(), y), height });
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
    }
    const auto box = grid.BoxOf(range);
    // the positions are up to half a part from where the box is touched
    const double slack = grid.Body.Equatorial * std::pow(0.5 * terrain::kTurn / (parts - 1), 2);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(box[0][axis], low[axis] + 1e-6);
      EXPECT_GE(box[0][axis], low[axis] - slack);
      EXPECT_GE(box[1][axis], high[axis] - 1e-6);
      EXPECT_LE(box[1][axis], high[axis] + slack);
    }
  }
}

TEST(Globe, TellsRowsFromLatitudes)
{
  const terrain::GlobeGrid grid =
    terrain::MakeGrid({}, -179.5, 1.0, 361, terrain::ParallelsOfCells(1.0));
  EXPECT_DOUBLE_EQ(grid.RowOf(-90.0 * kDegree), 0.0);
  EXPECT_NEAR(grid.RowOf(-89.75 * kDegree), 0.5, 1e-12);
  EXPECT_NEAR(grid.RowOf(0.0), 90.5, 1e-12);
  EXPECT_NEAR(grid.RowOf(90.0 * kDegree), 181.0, 1e-12);
  EXPECT_NEAR(grid.RowOf(-90.25 * kDegree), -0.5, 1e-12);
  for (const double row : { -1.5, 0.0, 0.4, 1.0, 77.7, 180.0, 180.9, 181.0, 182.5 })
  {
    EXPECT_NEAR(grid.RowOf(grid.LatitudeOf(row)), row, 1e-12);
  }
}

TEST(Globe, AnswersRaysThatAreNone)
{
  const terrain::TestGlobe globe = terrain::TestGlobes().front();
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  for (const glm::dvec3& direction : { glm::dvec3(0.0), glm::dvec3(terrain::kNaN),
         glm::dvec3(1e300, 0.0, 0.0), glm::dvec3(0.0, 1e-300, 0.0) })
  {
    terrain::GlobeReferenceRay ray;
    ray.Origin = { 1e7, 0.0, 0.0 };
    ray.Direction = direction;
    ray.End = 1e8;
    const terrain::WorldTracer<float, std::uint16_t> tracer(world, ray.Origin);
    EXPECT_FALSE(tracer.Trace(ray).Found);
  }
}

TEST(Globe, RefusesWhatIsNoGlobe)
{
  const terrain::Ellipsoid earth;
  const auto latitudes = terrain::Parallels(-10.0, 1.0, 21);
  EXPECT_EQ(terrain::MakeGrid(earth, -180.0, 1.0, 361, latitudes).WhyNot(), "");
  EXPECT_EQ(terrain::MakeGrid({ 6378137.0, 0.9 * 6378137.0 }, 0.0, 1.0, 3, latitudes).WhyNot(), "");
  for (const terrain::GlobeGrid& grid : {
         terrain::MakeGrid(earth, -180.0, 1.0, 1, latitudes),
         terrain::MakeGrid(earth, -180.0, 1.0, 720, latitudes),
         terrain::MakeGrid(earth, -180.0, 0.0, 361, latitudes),
         terrain::MakeGrid(earth, -180.0, 1.0, 361, terrain::Parallels(-95.0, 1.0, 20)),
         terrain::MakeGrid(earth, -180.0, 1.0, 361, { 0.1 }),
         terrain::MakeGrid(earth, -180.0, 1.0, 361, { 0.1, 0.1 }),
         terrain::MakeGrid({ 6378137.0, 0.8 * 6378137.0 }, -180.0, 1.0, 361, latitudes),
         terrain::MakeGrid({ 6356752.0, 6378137.0 }, -180.0, 1.0, 361, latitudes),
         terrain::MakeGrid({ terrain::kNaN, 1.0 }, -180.0, 1.0, 361, latitudes),
       })
  {
    EXPECT_NE(grid.WhyNot(), "");
  }
}
}
