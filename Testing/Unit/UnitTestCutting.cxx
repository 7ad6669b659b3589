// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/Cutting.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
constexpr double Base = -3.0;

terrain::Cutting ExtractOf(glm::ivec2 first, glm::ivec2 last)
{
  terrain::Cutting cutting;
  cutting.Extracts = true;
  cutting.First = first;
  cutting.Last = last;
  return cutting;
}

bool IsKept(const std::vector<glm::dvec4>& planes, const glm::dvec3& positionGC)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const glm::dvec4& plane) { return glm::dot(plane, glm::dvec4(positionGC, 1.0)) >= 0.0; });
}
}

//------------------------------------------------------------------------------
TEST(Cutting, DrawsAllByDefault)
{
  const terrain::Cutting cutting;
  const terrain::SampleRectangle drawn = cutting.Drawn({ 9, 5 }, 1);
  EXPECT_EQ(drawn.First, glm::dvec2(0.0, 0.0));
  EXPECT_EQ(drawn.Last, glm::dvec2(8.0, 4.0));
  EXPECT_TRUE(cutting.PlanesGC(drawn, Base).empty());
  EXPECT_EQ(cutting.Lowest(7.0), 7.0);
}

TEST(Cutting, ExtractsWhatTheGridHas)
{
  const terrain::Cutting cutting = ExtractOf({ -4, 2 }, { 100, 3 });
  const terrain::SampleRectangle drawn = cutting.Drawn({ 9, 5 }, 1);
  EXPECT_EQ(drawn.First, glm::dvec2(0.0, 2.0));
  EXPECT_EQ(drawn.Last, glm::dvec2(8.0, 3.0));
}

TEST(Cutting, ExtractsSamplesWithoutDetail)
{
  const terrain::SampleRectangle drawn = ExtractOf({ 1, 2 }, { 3, 4 }).Drawn({ 65, 65 }, 16);
  EXPECT_EQ(drawn.First, glm::dvec2(16.0, 32.0));
  EXPECT_EQ(drawn.Last, glm::dvec2(48.0, 64.0));
}

TEST(Cutting, PlanesKeepTheExtract)
{
  const terrain::Cutting cutting = ExtractOf({ 2, 1 }, { 6, 3 });
  const auto planes = cutting.PlanesGC(cutting.Drawn({ 9, 5 }, 1), Base);
  EXPECT_EQ(planes.size(), 4U);
  EXPECT_TRUE(IsKept(planes, { 2.0, 1.0, -100.0 }));
  EXPECT_TRUE(IsKept(planes, { 6.0, 3.0, 100.0 }));
  EXPECT_FALSE(IsKept(planes, { 1.99, 2.0, 0.0 }));
  EXPECT_FALSE(IsKept(planes, { 6.01, 2.0, 0.0 }));
  EXPECT_FALSE(IsKept(planes, { 4.0, 0.99, 0.0 }));
  EXPECT_FALSE(IsKept(planes, { 4.0, 3.01, 0.0 }));
}

TEST(Cutting, BlocksHaveAFloor)
{
  terrain::Cutting cutting;
  cutting.Block = true;
  cutting.BlockBase = 50.0;
  EXPECT_EQ(cutting.Lowest(70.0), 50.0);
  EXPECT_EQ(cutting.Lowest(40.0), 40.0); // a base above the surface adds nothing
  const auto planes = cutting.PlanesGC(cutting.Drawn({ 9, 5 }, 1), Base);
  EXPECT_LE(planes.size() + 6, static_cast<std::size_t>(terrain::kMaximumClipPlanes));
  EXPECT_TRUE(IsKept(planes, { 4.0, 2.0, Base }));
  EXPECT_FALSE(IsKept(planes, { 4.0, 2.0, Base - 0.01 }));
}
