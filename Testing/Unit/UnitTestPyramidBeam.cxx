// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestRays.h"

#include "core/rays/PyramidBeam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using terrain::CodedField;
using terrain::PyramidBeam;
using terrain::TerrainBeam;
using terrain::TerrainRay;

// Rays of a camera: position(x, y, s) = origin(x, y) + s * direction(x, y), affine in the pixel.
struct Camera
{
  glm::dvec3 Origin[3];
  glm::dvec3 Direction[3];

  glm::dvec3 OriginAt(double x, double y) const
  {
    return this->Origin[0] + x * this->Origin[1] + y * this->Origin[2];
  }
  glm::dvec3 DirectionAt(double x, double y) const
  {
    return this->Direction[0] + x * this->Direction[1] + y * this->Direction[2];
  }
  TerrainRay Ray(double x, double y, float length) const
  {
    TerrainRay ray =
      terrain::RayBetween(this->OriginAt(x, y), this->OriginAt(x, y) + this->DirectionAt(x, y));
    ray.directionGC = glm::vec3(this->DirectionAt(x, y));
    ray.sEnd = length;
    return ray;
  }
  TerrainBeam Beam(double x, double y, double half, float length) const
  {
    TerrainBeam beam;
    beam.ray = this->Ray(x, y, length);
    beam.radius = glm::vec3(half * (glm::abs(this->Origin[1]) + glm::abs(this->Origin[2])));
    beam.growth = glm::vec3(half * (glm::abs(this->Direction[1]) + glm::abs(this->Direction[2])));
    return beam;
  }
};

// A camera anywhere about the field, looking anywhere; perspective or parallel, wide or narrow.
Camera RandomCamera(terrain::RayMaker& maker, const TerrainRay& axis)
{
  Camera camera{};
  const glm::dvec3 scale(
    1.0, 1.0, std::max(1e-3, static_cast<double>(std::abs(axis.originGC.z))) * 0.1);
  const bool parallel = maker.Uniform(0.0, 1.0) < 0.3;
  const double width = std::pow(10.0, maker.Uniform(-4.0, -0.5));
  camera.Origin[0] =
    glm::dvec3(axis.originGC) + glm::dvec3(axis.anchorCell.x, axis.anchorCell.y, 0.0);
  camera.Direction[0] = glm::dvec3(axis.directionGC);
  for (int k = 1; k < 3; ++k)
  {
    const glm::dvec3 across(
      maker.Uniform(-1.0, 1.0), maker.Uniform(-1.0, 1.0), maker.Uniform(-1.0, 1.0));
    (parallel ? camera.Origin : camera.Direction)[k] = across * scale * width * 30.0;
  }
  return camera;
}

// The rays of a tile's pixels lie within the beam at any distance.
TEST(PyramidBeam, HoldsTheRaysOfItsTile)
{
  terrain::PixelRays rays;
  rays.OriginGC = { glm::dvec3(5.0, 6.0, 700.0), glm::dvec3(0.1, -0.2, 0.3),
    glm::dvec3(0.05, 0.1, -0.5) };
  rays.DirectionGC = { glm::dvec3(0.3, 0.2, -5.0), glm::dvec3(0.01, -0.02, 0.03),
    glm::dvec3(0.0, 0.01, 0.07) };
  const glm::dvec2 middle(12.0, 20.0);
  constexpr double start = 3.0;
  const TerrainBeam beam = terrain::TileBeam(rays, middle, 4.0, start, 90.0);
  for (const double s : { 0.0, 10.0, 80.0 })
  {
    const auto at = [&rays, s](const glm::dvec2& pixel)
    {
      return terrain::AtPixel(rays.OriginGC, pixel) +
        (start + s) * terrain::AtPixel(rays.DirectionGC, pixel);
    };
    const glm::dvec3 reach = glm::dvec3(beam.radius) + s * glm::dvec3(beam.growth);
    glm::dvec3 most(0.0);
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec2 pixel =
        middle + glm::dvec2(corner & 1 ? 4.0 : -4.0, corner & 2 ? 4.0 : -4.0);
      const glm::dvec3 off = glm::abs(at(pixel) - at(middle));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(off, reach * (1.0 + 1e-6)))) << s;
      most = glm::max(most, off);
    }
    EXPECT_TRUE(glm::all(glm::greaterThan(most, 0.3 * reach)))
      << s; // and it is no wider than need be
  }
}

// No ray of a tile meets the surface before the beam's start, by the brute-force reference.
TEST(PyramidBeam, IsNeverBeyondTheFirstHitOfItsRays)
{
  unsigned seed = 100;
  double advanced = 0.0;
  int hits = 0;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    const CodedField<std::uint16_t> field(test);
    const PyramidBeam<std::uint16_t> beams(field.Coded);
    terrain::RayMaker maker({ test.Width, test.Height }, field.Codes.MaximumCode, ++seed);
    for (int trial = 0; trial < 200; ++trial)
    {
      const Camera camera = RandomCamera(maker, maker.Make());
      constexpr float length = 3.0f;
      const double half = 0.5;
      int steps = 0;
      const float start = beams.BeamStart(camera.Beam(0.5, 0.5, half, length), steps);
      ASSERT_GE(start, 0.0f);
      ASSERT_LE(start, length);
      ASSERT_LE(steps, terrain::kBeamSteps);
      for (int k = 0; k < 9; ++k)
      {
        // The centres and corners of the tile's pixels lie within its square.
        const int row = k / 3;
        const TerrainRay ray = camera.Ray(0.5 * (k % 3), 0.5 * row, length);
        const double first = terrain::FirstMeeting(terrain::RayPieces(field.Coded.heights, ray));
        ASSERT_GE(first, start) << "trial " << trial << " ray " << k;
        hits += !std::isinf(first);
        advanced += std::isinf(first) ? 0.0 : start / std::max(first, 1e-9);
      }
    }
  }
  // They do get on: more than a third of the way to the first hit.
  ASSERT_GT(hits, 4000);
  EXPECT_GT(advanced / hits, 0.33);
}

// What the shaders do: start a ray where its beam ends, and find the same.
TEST(PyramidBeam, LeavesEveryHitToBeFound)
{
  unsigned seed = 500;
  for (const terrain::TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    const CodedField<float> field(test);
    const PyramidBeam<float> beams(field.Coded);
    terrain::RayMaker maker({ test.Width, test.Height }, field.Codes.MaximumCode, ++seed);
    int differ = 0;
    for (int trial = 0; trial < 3000; ++trial)
    {
      const Camera camera = RandomCamera(maker, maker.Make());
      TerrainRay ray = camera.Ray(maker.Uniform(0.0, 1.0), maker.Uniform(0.0, 1.0), 3.0f);
      const terrain::TerrainHit whole = field.Coded.TracePyramid(ray);
      int steps = 0;
      ray.sBegin = beams.BeamStart(camera.Beam(0.5, 0.5, 0.5, 3.0f), steps);
      const terrain::TerrainHit rest = field.Coded.TracePyramid(ray);
      differ += whole.found != rest.found || (whole.found && std::abs(whole.s - rest.s) > 1e-4f);
    }
    EXPECT_LE(differ, 3); // rays that graze
  }
}

// An eye just above the ground that looks along it: the start must get on, far beyond the first
// cell.
TEST(PyramidBeam, GetsOnCloseToTheGround)
{
  const CodedField<std::uint16_t> field(
    terrain::TestField("", 300, 300, [](int i, int j) { return std::floor(20.0 * i + 7.0 * j); }));
  const PyramidBeam<std::uint16_t> beams(field.Coded);
  TerrainBeam beam;
  // 2 codes above a plane that rises by 20 codes a cell; meets it 200 cells away.
  beam.ray = terrain::RayBetween({ 20.5, 30.5, 623.5 + 2.0 }, { 220.5, 30.5, 4623.5 });
  beam.growth = glm::vec3(0.05f, 0.05f, 0.1f);
  int steps = 0;
  const float start = beams.BeamStart(beam, steps);
  EXPECT_GT(start, 0.4f);
  EXPECT_LT(start, 1.0f);
}

TEST(PyramidBeam, PassesWhereThereIsNothing)
{
  const CodedField<std::uint16_t> field(terrain::AdversarialFields()[7]); // hills
  const PyramidBeam<std::uint16_t> beams(field.Coded);
  const double high = 2.0 * field.Codes.MaximumCode;
  for (const auto& [begin, end] : { std::pair{ glm::dvec3(-9, 3, high), glm::dvec3(90, 60, high) },
         { glm::dvec3(-9, 3, -high), glm::dvec3(90, 60, -1.0) },
         { glm::dvec3(-9, 3, 0.5 * high), glm::dvec3(-9, 90, 0.1 * high) },
         { glm::dvec3(99, 3, 0.5 * high), glm::dvec3(150, 90, 0.1 * high) },
         { glm::dvec3(30, 30, high), glm::dvec3(30, 30, 2.0 * high) } })
  {
    TerrainBeam beam;
    beam.ray = terrain::RayBetween(begin, end);
    beam.growth = glm::vec3(0.1f, 0.1f, 0.1f);
    int steps = 0;
    EXPECT_EQ(beams.BeamStart(beam, steps), 1.0f);
  }
  const CodedField<std::uint16_t> strip(terrain::TestField("", 1, 9, [](int, int) { return 1.0; }));
  TerrainBeam beam;
  beam.ray = terrain::RayBetween({ 0.0, 0.0, 5.0 }, { 0.0, 1.0, -5.0 });
  int steps = 0;
  EXPECT_EQ(PyramidBeam<std::uint16_t>(strip.Coded).BeamStart(beam, steps), 1.0f);
}

TEST(PyramidBeam, StaysAtTheEyeOfAWideBeam)
{
  const CodedField<std::uint16_t> field(terrain::AdversarialFields()[7]); // hills
  TerrainBeam beam;
  beam.ray = terrain::RayBetween({ 30.0, 30.0, 300.0 }, { 31.0, 31.0, 299.0 });
  beam.radius = glm::vec3(100.0f, 100.0f, 1000.0f);
  int steps = 0;
  EXPECT_EQ(PyramidBeam<std::uint16_t>(field.Coded).BeamStart(beam, steps), 0.0f);
}
}
