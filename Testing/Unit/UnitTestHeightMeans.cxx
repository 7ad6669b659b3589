// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/HeightMeans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using terrain::CodedField;
using terrain::MeanLevel;
using terrain::TestField;

template <typename Texel>
std::vector<MeanLevel> means(const CodedField<Texel>& field)
{
  terrain::HeightMeans result;
  result.Build(field.TexelView, field.Codes, terrain::SerialFor);
  return result.GetLevels();
}

double height(const MeanLevel& level, const terrain::HeightCodes& codes, int x, int y)
{
  const auto index = static_cast<std::size_t>(x + level.Size.x * y);
  return codes.ToHeight(level.Texels[index] * codes.MaximumCode / 65535.0);
}

// A texture's levels: each half the size, down to one texel.
TEST(HeightMeans, AreTheLevelsOfATexture)
{
  for (const TestField& test : terrain::AdversarialFields())
  {
    SCOPED_TRACE(test.Name);
    const CodedField<float> field(test);
    const std::vector<MeanLevel> levels = means(field);
    ASSERT_FALSE(levels.empty());
    glm::ivec2 size = glm::max(glm::ivec2(test.Width, test.Height) / 8, glm::ivec2(1));
    for (const MeanLevel& level : levels)
    {
      EXPECT_EQ(level.Size, size);
      EXPECT_EQ(level.Texels.size(), static_cast<std::size_t>(size.x * size.y));
      size = glm::max(size / 2, glm::ivec2(1));
    }
    EXPECT_EQ(levels.back().Size, glm::ivec2(1));
  }
}

// Where sizes divide, a texel is the mean of its samples; at every level.
TEST(HeightMeans, AreMeans)
{
  const TestField test("mean", 64, 32,
    [](int i, int j) { return std::floor(500.0 + 200.0 * std::sin(0.3 * i) + 9.0 * (j % 7)); });
  const CodedField<std::uint16_t> field(test);
  int side = 8;
  for (const MeanLevel& level : means(field))
  {
    for (int y = 0; y < level.Size.y && side <= 32; ++y)
    {
      for (int x = 0; x < level.Size.x; ++x)
      {
        double sum = 0.0;
        for (int k = 0; k < side * side; ++k)
        {
          sum += test.Samples[static_cast<std::size_t>(
            side * x + k % side + test.Width * (side * y + k / side))];
        }
        ASSERT_NEAR(
          height(level, field.Codes, x, y), sum / (side * side), field.Codes.MaximumCode / 65535.0);
      }
    }
    side *= 2;
  }
}

// The mean of a plane is the plane at the middle of a texel, whatever the size.
TEST(HeightMeans, KeepPlanesOfAnySize)
{
  for (const glm::ivec2 size : { glm::ivec2(16, 16), { 37, 61 }, { 100, 23 } })
  {
    const TestField test("plane", size.x, size.y, [](int i, int j) { return 2.0 * i + 3.0 * j; });
    const CodedField<float> field(test);
    for (const MeanLevel& level : means(field))
    {
      const glm::dvec2 texel = glm::dvec2(size) / glm::dvec2(level.Size);
      for (int y = 0; y < level.Size.y; ++y)
      {
        for (int x = 0; x < level.Size.x; ++x)
        {
          const glm::dvec2 middle = (glm::dvec2(x, y) + 0.5) * texel - 0.5;
          // levels take whole samples: one is what they may be off
          ASSERT_NEAR(height(level, field.Codes, x, y), 2.0 * middle.x + 3.0 * middle.y,
            field.Codes.MaximumCode / 65535.0 + 2.0 + 3.0);
        }
      }
    }
  }
}

// Samples without heights do not count; where there are none at all, the surroundings do.
TEST(HeightMeans, PassByNoData)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const TestField test(
    "half", 64, 64, [&](int i, int j) { return i < 20 ? 100.0 : (j < 40 ? none : 300.0); });
  const CodedField<std::uint16_t> field(test);
  const std::vector<MeanLevel> levels = means(field);
  EXPECT_NEAR(height(levels[0], field.Codes, 0, 0), 100.0, 0.01);
  EXPECT_NEAR(height(levels[0], field.Codes, 2, 0), 100.0, 0.01); // half of it is data
  EXPECT_NEAR(height(levels[0], field.Codes, 7, 7), 300.0, 0.01);
  const double filled = height(levels[0], field.Codes, 6, 1);
  EXPECT_GE(filled, 100.0);
  EXPECT_LE(filled, 300.0);
  EXPECT_TRUE(
    means(CodedField<float>(TestField("", 9, 9, [&](int, int) { return none; }))).empty());
  EXPECT_TRUE(means(CodedField<float>(TestField("", 1, 9, [](int, int) { return 1.0; }))).empty());
}

// After an update of a part the levels are those of a new build.
TEST(HeightMeans, FollowChangesOfAPart)
{
  for (const glm::ivec2 size : { glm::ivec2(64, 64), { 83, 45 }, { 9, 100 } })
  {
    const auto heights = [](int i, int j) { return 100.0 * std::sin(0.2 * i) * std::cos(0.1 * j); };
    CodedField<float> field(TestField("", size.x, size.y, heights));
    terrain::HeightMeans updated;
    updated.Build(field.TexelView, field.Codes, terrain::SerialFor);
    for (const terrain::GridRectangle& part : { terrain::GridRectangle{ { 0, 0 }, { 1, 1 } },
           { { 3, 7 }, { 9, 20 } }, { { size.x - 2, size.y - 9 }, size }, { { 5, 5 }, { 5, 9 } } })
    {
      for (int j = part.First.y; j < part.End.y; ++j)
      {
        for (int i = part.First.x; i < part.End.x; ++i)
        {
          field.Texels[static_cast<std::size_t>(i + size.x * j)] *= 0.5f;
        }
      }
      updated.Update(field.TexelView, field.Codes, part, terrain::SerialFor);
      const std::vector<MeanLevel> fresh = means(field);
      ASSERT_EQ(fresh.size(), updated.GetLevels().size());
      for (std::size_t k = 0; k < fresh.size(); ++k)
      {
        EXPECT_EQ(fresh[k].Texels, updated.GetLevels()[k].Texels);
      }
    }
  }
}
}
