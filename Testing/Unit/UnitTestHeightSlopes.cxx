// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/surface/HeightSlopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using terrain::CodedField;
using terrain::HeightSlopes;
using terrain::SlopeLevel;
using terrain::TestField;

template <typename Texel>
HeightSlopes Slopes(const CodedField<Texel>& field)
{
  HeightSlopes result;
  result.Build(field.TexelView, field.Codes, terrain::SerialFor);
  return result;
}

/// Codes per cell.
glm::dvec2 Slope(const HeightSlopes& slopes, const SlopeLevel& level, int x, int y)
{
  return slopes.GetScale() / 32767.0 *
    glm::dvec2(level.Texels[static_cast<std::size_t>(x + level.Size.x * y)]);
}

// A texture's levels: each half the size, down to one texel.
TEST(HeightSlopes, AreTheLevelsOfATexture)
{
  for (const TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    const CodedField<float> field(test);
    const HeightSlopes built = Slopes(field);
    ASSERT_FALSE(built.GetLevels().empty());
    glm::ivec2 size = glm::max(glm::ivec2(test.Width - 1, test.Height - 1) / 16, glm::ivec2(1));
    for (const SlopeLevel& level : built.GetLevels())
    {
      EXPECT_EQ(level.Size, size);
      EXPECT_EQ(level.Texels.size(), static_cast<std::size_t>(size.x * size.y));
      size = glm::max(size / 2, glm::ivec2(1));
    }
    EXPECT_EQ(built.GetLevels().back().Size, glm::ivec2(1));
  }
}

// Where sizes divide, a texel is the mean difference between opposite sides of its square.
TEST(HeightSlopes, AreMeans)
{
  const TestField test("mean", 129, 65,
    [](int i, int j) { return std::floor(500.0 + 200.0 * std::sin(0.3 * i) + 9.0 * (j % 7)); });
  const CodedField<std::uint16_t> field(test);
  const HeightSlopes built = Slopes(field);
  int side = 16;
  for (const SlopeLevel& level : built.GetLevels())
  {
    for (int y = 0; y < level.Size.y && side <= 64; ++y)
    {
      for (int x = 0; x < level.Size.x; ++x)
      {
        const auto height = [&](int i, int j)
        { return test.Samples[static_cast<std::size_t>(side * x + i + 129 * (side * y + j))]; };
        glm::dvec2 sum(0.0);
        for (int k = 0; k <= side; ++k)
        {
          const double part = k == 0 || k == side ? 0.5 : 1.0;
          sum += part * glm::dvec2(height(side, k) - height(0, k), height(k, side) - height(k, 0));
        }
        const glm::dvec2 expected = sum / (side * side * field.Codes.Scale);
        const glm::dvec2 found = Slope(built, level, x, y);
        ASSERT_NEAR(found.x, expected.x, built.GetScale() / 65534.0 + 1e-6);
        ASSERT_NEAR(found.y, expected.y, built.GetScale() / 65534.0 + 1e-6);
      }
    }
    side *= 2;
  }
}

// The slope of a plane is the plane's everywhere, whatever the size; and the steepest is exact.
TEST(HeightSlopes, KeepPlanesOfAnySize)
{
  for (const glm::ivec2 size : { glm::ivec2(2, 2), { 37, 61 }, { 100, 23 } })
  {
    const TestField test("plane", size.x, size.y, [](int i, int j) { return 2.0 * i - 3.0 * j; });
    const CodedField<float> field(test);
    const HeightSlopes built = Slopes(field);
    for (const SlopeLevel& level : built.GetLevels())
    {
      for (int y = 0; y < level.Size.y; ++y)
      {
        for (int x = 0; x < level.Size.x; ++x)
        {
          const glm::dvec2 found = Slope(built, level, x, y) * field.Codes.Scale;
          ASSERT_NEAR(found.x, 2.0, 1e-4);
          ASSERT_NEAR(found.y, -3.0, 1e-4);
        }
      }
    }
  }
}

// Cells without surface do not count; where there are no others, the surroundings do.
TEST(HeightSlopes, PassByNoData)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const TestField test("half", 129, 129,
    [&](int i, int j) { return i < 40 ? 5.0 * i : (j < 80 ? none : 200.0 + 8.0 * (i - 40)); });
  const CodedField<std::uint16_t> field(test);
  const HeightSlopes built = Slopes(field);
  const SlopeLevel& first = built.GetLevels()[0];
  const double unit = field.Codes.Scale;
  EXPECT_NEAR(Slope(built, first, 0, 0).x * unit, 5.0, 0.02);
  EXPECT_NEAR(Slope(built, first, 2, 0).x * unit, 5.0, 0.02); // half of it is data
  EXPECT_NEAR(Slope(built, first, 7, 7).x * unit, 8.0, 0.02);
  const double filled = Slope(built, first, 6, 1).x * unit;
  EXPECT_GT(filled, 4.9);
  EXPECT_LT(filled, 8.1);
  const CodedField<float> empty(TestField("", 9, 9, [&](int, int) { return none; }));
  EXPECT_TRUE(Slopes(empty).GetLevels().empty());
  const CodedField<float> line(TestField("", 1, 9, [](int, int) { return 1.0; }));
  EXPECT_TRUE(Slopes(line).GetLevels().empty());
}

/// Makes rubbish of all texels that an update of a part may not read.
void SpoilBeside(CodedField<float>& field, const terrain::GridRectangle& part)
{
  for (int j = 0; j < field.TexelView.Height; ++j)
  {
    for (int i = 0; i < field.TexelView.Width; ++i)
    {
      const bool isNear = i >= part.First.x - terrain::kSlopesReach &&
        i < part.End.x + terrain::kSlopesReach && j >= part.First.y - terrain::kSlopesReach &&
        j < part.End.y + terrain::kSlopesReach;
      float& texel = field.Texels[static_cast<std::size_t>(field.TexelView.Index(i, j))];
      texel = isNear ? texel : 1e6f;
    }
  }
}

// After an update of a part the levels are those of a new build, whatever lies far beside it.
TEST(HeightSlopes, FollowChangesOfAPart)
{
  for (const glm::ivec2 size :
    { glm::ivec2(64, 64), { 83, 45 }, { 9, 100 }, { 160, 161 }, { 32, 32 }, { 96, 33 } })
  {
    const auto heights = [](int i, int j) { return 100.0 * std::sin(0.2 * i) * std::cos(0.1 * j); };
    CodedField<float> field(TestField("", size.x, size.y, heights));
    HeightSlopes updated = Slopes(field);
    for (const terrain::GridRectangle& part : { terrain::GridRectangle{ { 0, 0 }, { 1, 1 } },
           { { 3, 7 }, { 9, 20 } }, { { size.x - 2, size.y - 9 }, size }, { { 5, 5 }, { 5, 9 } },
           { { size.x / 16 * 8, 16 }, { size.x / 16 * 8 + 1, 17 } } })
    {
      for (int j = part.First.y; j < part.End.y; ++j)
      {
        for (int i = part.First.x; i < part.End.x; ++i)
        {
          field.Texels[static_cast<std::size_t>(i + size.x * j)] *= 0.5f;
        }
      }
      const std::vector<float> kept = field.Texels;
      SpoilBeside(field, part);
      updated.Update(field.TexelView, part, terrain::SerialFor);
      std::copy(kept.begin(), kept.end(), field.Texels.begin());
      const HeightSlopes fresh = Slopes(field);
      ASSERT_EQ(fresh.GetLevels().size(), updated.GetLevels().size());
      EXPECT_EQ(fresh.GetScale(), updated.GetScale());
      for (std::size_t k = 0; k < fresh.GetLevels().size(); ++k)
      {
        EXPECT_EQ(fresh.GetLevels()[k].Texels, updated.GetLevels()[k].Texels);
      }
    }
  }
}
}
