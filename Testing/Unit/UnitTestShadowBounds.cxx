// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds of shadows against rays in double precision.
#include "UnitTestFields.h"

#include "core/grid/HeightSampling.h"
#include "core/rays/RayQuery.h"
#include "core/rays/ShadowBounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace
{
using terrain::ShadowBounds;

/// Hills, with a few samples of noise.
std::vector<float> Hills(int width, int height)
{
  std::mt19937 random(11);
  std::vector<float> samples;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const auto noise = static_cast<float>(random() % 1000) / 1000.0f;
      samples.push_back(20.0f + 12.0f * std::sin(0.13f * i) * std::cos(0.17f * j) + noise);
    }
  }
  return samples;
}

struct Told
{
  int Hidden = 0;
  int Free = 0;
  int Rays = 0;
  int Wrong = 0;
};

Told Judge(int width, int height, double azimuth, double low, double high, int level)
{
  const std::vector<float> samples = Hills(width, height);
  terrain::HeightfieldView<float> view;
  view.Samples = samples.data();
  view.Width = width;
  view.Height = height;
  terrain::MinMaxPyramid<float> pyramid;
  pyramid.Build(view, terrain::BackwardFor);
  terrain::Surface surface;
  surface.Heights = std::make_shared<terrain::SampledHeights<float>>(view, terrain::BackwardFor);
  const terrain::RayQuery query(surface);
  terrain::ShadowRays rays;
  rays.Direction = { std::sin(azimuth), std::cos(azimuth) };
  rays.Low = low;
  rays.High = high;
  const ShadowBounds bounds =
    terrain::MakeShadowBounds(pyramid, level, 0.0, rays, 40.0, true, terrain::BackwardFor);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Told told;
  for (int k = 0; k < 600; ++k)
  {
    const glm::dvec2 at((width - 1) * part(random), (height - 1) * part(random));
    const double code = query.HeightAt(at.x, at.y) + (k % 3 == 0 ? 5.0 * part(random) : 0.0);
    const terrain::ShadowStrip strip = terrain::FindShadowStrip(bounds, at, code, rays.Direction);
    const double s = 12.0 * part(random);
    terrain::QueryRay ray;
    ray.Origin = { at.x, at.y, code };
    ray.Direction = { rays.Direction.x, rays.Direction.y, high };
    ray.Begin = 1e-6;
    const bool hidden = terrain::IsHidden(bounds, strip);
    told.Wrong += hidden && query.Highest(ray).Height <= 0.0 ? 1 : 0;
    ray.Direction.z = low;
    ray.Begin = s;
    const bool free = terrain::IsFree(bounds, strip, s);
    told.Wrong += free && query.Highest(ray).Height > 0.0 ? 1 : 0;
    told.Hidden += hidden ? 1 : 0;
    told.Free += free ? 1 : 0;
    ++told.Rays;
  }
  return told;
}
}

//------------------------------------------------------------------------------
TEST(ShadowBounds, NeverTellWhatIsNotSo)
{
  for (const auto& [width, height] : { std::pair(97, 64), { 33, 120 }, { 2, 2 }, { 66, 3 } })
  {
    for (int k = 0; k < 24; ++k)
    {
      for (const double rise : { 0.02, 0.2, 1.0 })
      {
        const double azimuth = 2.0 * terrain::kDegree * 180.0 * k / 24.0;
        EXPECT_EQ(Judge(width, height, azimuth, rise, 1.1 * rise, 1).Wrong, 0)
          << width << " " << height << " " << k << " " << rise;
      }
    }
  }
}

// Rays are the same up to what rounding does, and no farther.
TEST(ShadowBounds, AreKeptForRaysThatRoundingMoved)
{
  terrain::ShadowRays rays;
  rays.Direction = { 0.6, 0.8 };
  rays.Low = 0.3;
  rays.High = 0.31;
  terrain::ShadowRays moved = rays;
  EXPECT_TRUE(terrain::AreSameRays(rays, moved));
  moved.Direction += 0.5 * terrain::kSameShadowRays * glm::dvec2(0.8, -0.6);
  moved.Low *= 1.0 - 0.5 * terrain::kSameShadowRays;
  moved.High *= 1.0 + 0.5 * terrain::kSameShadowRays;
  EXPECT_TRUE(terrain::AreSameRays(rays, moved));
  for (const double sign : { -1.0, 1.0 })
  {
    moved = rays;
    moved.Direction += sign * 2.0 * terrain::kSameShadowRays * glm::dvec2(0.8, -0.6);
    EXPECT_FALSE(terrain::AreSameRays(rays, moved));
    moved = rays;
    moved.Low *= 1.0 + sign * 2.0 * terrain::kSameShadowRays;
    EXPECT_FALSE(terrain::AreSameRays(rays, moved));
    moved = rays;
    moved.High *= 1.0 + sign * 2.0 * terrain::kSameShadowRays;
    EXPECT_FALSE(terrain::AreSameRays(rays, moved));
  }
}

TEST(ShadowBounds, TellMostOfAllRays)
{
  const Told told = Judge(257, 257, 0.7, 0.3, 0.3, 1);
  EXPECT_EQ(told.Wrong, 0);
  EXPECT_GT(told.Hidden, told.Rays / 50);
  EXPECT_GT(told.Free, told.Rays / 4);
}

TEST(ShadowBounds, HideNothingWhereSomethingIsMissing)
{
  const std::vector<float> samples = Hills(40, 40);
  terrain::HeightfieldView<float> view;
  view.Samples = samples.data();
  view.Width = 40;
  view.Height = 40;
  terrain::MinMaxPyramid<float> pyramid;
  pyramid.Build(view, terrain::BackwardFor);
  const ShadowBounds bounds =
    terrain::MakeShadowBounds(pyramid, 1, 0.0, {}, 40.0, false, terrain::BackwardFor);
  for (const glm::vec2& texel : bounds.Texels)
  {
    EXPECT_LT(texel.y, -1e29f);
  }
}
