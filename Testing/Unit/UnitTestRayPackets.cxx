// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Packets of rays against every cell of a field in double precision, against RayQuery, and each
// kind of processor against the others.
#include "UnitTestQueries.h"

#include "core/rays/RayPackets.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

using namespace terrain;

namespace
{
/// Height of the surface of a cell over the ray that hit it, where it did.
double HeightOverRay(const TestField& field, const QueryRay& ray, const SurfaceHit& hit)
{
  const HeightfieldView<double> view = field.View();
  const glm::i64vec2 c = hit.Cell;
  const glm::dvec4 corners{ view.At(c.x, c.y), view.At(c.x + 1, c.y), view.At(c.x, c.y + 1),
    view.At(c.x + 1, c.y + 1) };
  const glm::dvec3 at = ray.Origin + hit.Distance * ray.Direction;
  return PatchHeight(corners, glm::dvec2(at) - glm::dvec2(c)) - at.z;
}

/// Checks the hits of rays of all kinds against all cells of a field.
void ExpectHits(const TestField& field, const LaneKernels& kernels)
{
  SCOPED_TRACE(field.Name + " " + kernels.Name);
  const FieldCodes codes(field);
  const RayPackets packets(field.View(), GridGeometry{}, BackwardFor);
  const double relief = std::max(codes.High - codes.Low, 1e-3);
  const bool holes =
    std::any_of(field.Samples.begin(), field.Samples.end(), [](double h) { return std::isnan(h); });
  RayMaker maker(codes.size, codes.High - codes.Low, 43, !holes);
  std::vector<TerrainRay> rays;
  std::vector<QueryRay> asked;
  for (int i = 0; i < 1501; ++i) // the last packet is not full
  {
    rays.push_back(maker.Make());
    asked.push_back(ToQuery(rays.back(), codes.Low));
  }
  std::vector<SurfaceHit> hits(asked.size());
  packets.First(asked.data(), static_cast<std::int64_t>(asked.size()), hits.data(), kernels);
  int found = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const SurfaceHit& hit = hits[i];
    const QueryRay& ray = asked[i];
    // how far it may run until it has left the grid, in cells and heights
    const double cells = 1.0 + glm::length(glm::dvec2(ray.Origin)) +
      glm::length(glm::dvec2(codes.size)) + glm::length(ray.Begin * glm::dvec2(ray.Direction));
    const double rise = std::abs(ray.Origin.z - codes.Low) + std::abs(ray.Begin * ray.Direction.z);
    const double tolerance = kPacketError * (relief * cells + rise + std::abs(codes.Low) * 1e-6);
    const std::vector<CellPiece> pieces = RayPieces(codes, rays[i], false);
    const double speed = glm::length(ray.Direction * glm::dvec3(1.0, 1.0, 1.0 / relief));
    const double before = hit.Distance - kPacketError * cells / speed;
    EXPECT_LE(Penetration(pieces, hit.Found ? before : kInfinity), tolerance) << i;
    if (hit.Found)
    {
      ++found;
      EXPECT_LE(std::abs(HeightOverRay(field, ray, hit)), tolerance) << i;
      EXPECT_TRUE(hit.Distance >= ray.Begin && hit.Distance <= ray.End * (1.0 + 1e-6)) << i;
      EXPECT_NEAR(glm::length(hit.Normal), 1.0, 1e-12);
    }
  }
  EXPECT_GT(found, holes ? 50 : 200);
}

std::unique_ptr<RayQuery> TwinOf(const TestField& field, const GridGeometry& frame)
{
  Surface surface;
  surface.Heights = SurfaceOf(field).Heights;
  surface.Frame = frame;
  return std::make_unique<RayQuery>(surface);
}
}

//------------------------------------------------------------------------------
// Nothing to meet, and rays that are none, first.
TEST(RayPackets, MeetNothingWhereThereIsNothing)
{
  std::vector<QueryRay> rays(3);
  rays[0].Origin = { 0.5, 0.5, 10.0 };
  rays[1].Origin = { kNaN, 0.5, 10.0 };
  rays[2].Origin = { 0.5, 0.5, 10.0 };
  rays[2].Direction = { 0.0, 0.0, kInfinity };
  std::vector<SurfaceHit> hits(3);
  const double nan = kNaN;
  for (const LaneKernels& kernels : RunnableLaneKernels())
  {
    for (const glm::ivec2 size : { glm::ivec2(0, 0), glm::ivec2(1, 5), glm::ivec2(3, 1) })
    {
      const TestField field("none", size.x, size.y, [](int, int) { return 0.0; });
      RayPackets(field.View(), {}, SerialFor).First(rays.data(), 3, hits.data(), kernels);
      EXPECT_FALSE(hits[0].Found || hits[1].Found || hits[2].Found);
    }
    const TestField hole("hole", 4, 4, [nan](int, int) { return nan; });
    RayPackets(hole.View(), {}, SerialFor).First(rays.data(), 3, hits.data(), kernels);
    EXPECT_FALSE(hits[0].Found || hits[1].Found || hits[2].Found);
    const TestField flat("flat", 4, 4, [](int, int) { return 0.0; });
    const RayPackets packets(flat.View(), {}, SerialFor);
    packets.First(rays.data(), 3, hits.data(), kernels);
    EXPECT_TRUE(hits[0].Found);
    EXPECT_DOUBLE_EQ(hits[0].Distance, 10.0);
    EXPECT_FALSE(hits[1].Found || hits[2].Found);
    packets.First(rays.data(), 0, nullptr, kernels);
  }
}

//------------------------------------------------------------------------------
TEST(RayPackets, BruteForceOnAdversarialFields)
{
  for (const TestField& field : AdversarialFields())
  {
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      ExpectHits(field, kernels);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RayPackets, KindsOfProcessorsAgreeToTheBit)
{
  for (const TestField& field : AdversarialFields())
  {
    const FieldCodes codes(field);
    const RayPackets packets(field.View(), {}, SerialFor);
    RayMaker maker(codes.size, codes.High - codes.Low, 44, true);
    std::vector<QueryRay> rays;
    for (int i = 0; i < 640; ++i)
    {
      rays.push_back(ToQuery(maker.Make(), codes.Low));
    }
    std::vector<SurfaceHit> plain(rays.size());
    std::vector<SurfaceHit> hits(rays.size());
    packets.First(rays.data(), 640, plain.data(), RunnableLaneKernels().front());
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      packets.First(rays.data(), 640, hits.data(), kernels);
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_EQ(std::memcmp(&hits[i].Distance, &plain[i].Distance, sizeof(double)), 0)
          << field.Name << " " << kernels.Name << " " << i;
        ASSERT_EQ(hits[i].Cell, plain[i].Cell);
        ASSERT_EQ(hits[i].Normal, plain[i].Normal);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Whole numbers are kept as 16-bit codes, others as floats: the same surface, moved, hits the same.
TEST(RayPackets, PictureAgainstTheTwin)
{
  GridGeometry frame;
  frame.Origin = { 1000.0, -2000.0, 7.0 };
  frame.Spacing = { 3.0, 4.0 };
  frame.Exaggeration = 2.0;
  for (const double shift : { 0.0, 0.25 })
  {
    const TestField field("town", 150, 130,
      [shift](int i, int j)
      {
        const double ground = std::floor(20.0 * std::sin(0.05 * i) * std::cos(0.07 * j));
        return shift + ground + ((i / 9) % 3 == 1 && (j / 7) % 3 == 1 ? 25.0 : 0.0);
      });
    const RayPackets packets(field.View(), frame, SerialFor);
    const std::unique_ptr<RayQuery> twin = TwinOf(field, frame);
    const glm::dvec3 eye = frame.ToModel({ 20.0, -15.0 }, 60.0);
    const glm::ivec2 size(100, 70); // no whole number of tiles
    const glm::dvec3 corner(-0.2, 1.0, -0.55);
    PixelRays rays;
    rays.OriginGC = { frame.ToGrid(eye), glm::dvec3(0.0), glm::dvec3(0.0) };
    rays.DirectionGC = { frame.DirectionToGrid(corner),
      frame.DirectionToGrid({ 0.012, 0.002, 0.0 }), frame.DirectionToGrid({ 0.0, 0.0, 0.01 }) };
    for (const LaneKernels& kernels : RunnableLaneKernels())
    {
      PacketPicture picture;
      packets.Picture(rays, size, 1.0, 2000.0, picture, BackwardFor, kernels);
      int hits = 0;
      int differ = 0;
      for (int y = 0; y < size.y; ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          QueryRay ray;
          ray.Origin = eye;
          ray.Direction = corner + (x + 0.5) * glm::dvec3(0.012, 0.002, 0.0) +
            (y + 0.5) * glm::dvec3(0.0, 0.0, 0.01);
          ray.Begin = 1.0;
          ray.End = 2000.0;
          const SurfaceHit hit = twin->First(ray);
          const auto index = static_cast<std::size_t>(x + size.x * y);
          const double distance = static_cast<double>(picture.Distance[index]);
          hits += hit.Found ? 1 : 0;
          const bool same = hit.Found == std::isfinite(distance) &&
            (!hit.Found ||
              (std::abs(distance - hit.Distance) <= 1e-5 * hit.Distance &&
                glm::length(glm::dvec3(picture.Normal[index]) - hit.Normal) < 1e-3));
          differ += same ? 0 : 1;
        }
      }
      EXPECT_GT(hits, 3000) << kernels.Name;
      EXPECT_LE(differ, 3) << kernels.Name << " " << shift; // edges of walls that a ray grazes
    }
  }
}

//------------------------------------------------------------------------------
// A column of cells so long that their number, four times over, is beyond 32 bits.
TEST(RayPackets, HaveStepsForTheLongestGrids)
{
  const std::vector<std::uint16_t> samples(64, 5);
  PacketGrid grid;
  grid.CellsX = 1;
  grid.CellsY = 1 << 29;
  grid.Stride = 2;
  grid.Samples = samples.data();
  grid.Highest = 5.0f;
  PacketRays rays;
  rays.Count = 1;
  for (int k = 0; k < PacketRays::Most; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      rays.Origin[axis][k] = axis < 2 ? 0.5 : 10.0;
      rays.Direction[axis][k] = axis < 2 ? 0.0 : -1.0;
    }
    rays.End[k] = 100.0;
  }
  for (const LaneKernels& kernels : RunnableLaneKernels())
  {
    PacketHits hits;
    kernels.Packet(grid, rays, hits);
    EXPECT_EQ(hits.Distance[0], 5.0f) << kernels.Name;
  }
}
