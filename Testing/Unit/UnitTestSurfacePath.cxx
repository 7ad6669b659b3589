// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/HeightSampling.h"
#include "core/rays/SurfacePath.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{
struct PathField
{
  std::vector<double> Samples;
  terrain::HeightfieldView<double> View;
};

PathField Random(std::int64_t width, std::int64_t height, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-100.0, 100.0);
  PathField field;
  for (std::int64_t i = 0; i < width * height; ++i)
  {
    field.Samples.push_back(value(random));
  }
  field.View.Samples = field.Samples.data();
  field.View.Width = width;
  field.View.Height = height;
  return field;
}

std::vector<terrain::SurfacePiece> Walk(
  const terrain::HeightfieldView<double>& view, const glm::dvec2& from, const glm::dvec2& to)
{
  std::vector<terrain::SurfacePiece> pieces;
  terrain::WalkSurface(
    view, from, to, [&pieces](const terrain::SurfacePiece& piece) { pieces.push_back(piece); });
  return pieces;
}
}

TEST(SurfacePath, PiecesAreTheSurface)
{
  const PathField field = Random(12, 9, 1);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(-3.0, 14.0);
  std::uniform_real_distribution<double> y(-3.0, 11.0);
  for (int n = 0; n < 2000; ++n)
  {
    const glm::dvec2 from(x(random), y(random));
    const glm::dvec2 to(x(random), y(random));
    double end = 0.0;
    for (const terrain::SurfacePiece& piece : Walk(field.View, from, to))
    {
      EXPECT_EQ(piece.Begin, end);
      end = piece.End;
      for (double share : { 0.1, 0.5, 0.9 })
      {
        const double t = (1.0 - share) * piece.Begin + share * piece.End;
        const glm::dvec2 p = (1.0 - t) * from + t * to;
        const double expected = terrain::SampleBilinear(field.View, p.x, p.y);
        if (piece.HasSurface)
        {
          EXPECT_NEAR(piece.HeightAt(t), expected, 1e-9);
          const double chord =
            (1.0 - share) * piece.HeightAt(piece.Begin) + share * piece.HeightAt(piece.End);
          EXPECT_LE(std::abs(piece.HeightAt(t) - chord), piece.ChordError() + 1e-9);
        }
        else
        {
          EXPECT_TRUE(std::isnan(expected)) << p.x << " " << p.y;
        }
      }
    }
    EXPECT_EQ(end, 1.0);
  }
}

TEST(SurfacePath, ChordErrorIsReached)
{
  const std::vector<double> saddle{ 0.0, 0.0, 0.0, 4.0 };
  terrain::HeightfieldView<double> view;
  view.Samples = saddle.data();
  view.Width = view.Height = 2;
  const auto pieces = Walk(view, { 0.0, 0.0 }, { 1.0, 1.0 });
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_DOUBLE_EQ(pieces[0].ChordError(), 1.0);
  EXPECT_DOUBLE_EQ(
    0.5 * (pieces[0].HeightAt(0.0) + pieces[0].HeightAt(1.0)) - pieces[0].HeightAt(0.5), 1.0);
}

TEST(SurfacePath, AlongGridLinesAndBorders)
{
  PathField field = Random(5, 5, 3);
  // Along the outermost line, along an inner one, and a point.
  for (double y : { 0.0, 2.0, 4.0 })
  {
    for (const terrain::SurfacePiece& piece : Walk(field.View, { 0.0, y }, { 4.0, y }))
    {
      EXPECT_TRUE(piece.HasSurface) << y;
    }
  }
  // One side of the line has no data: the other serves.
  field.Samples[2 + 5 * 3] = std::nan("");
  for (const terrain::SurfacePiece& piece : Walk(field.View, { 0.0, 2.0 }, { 4.0, 2.0 }))
  {
    EXPECT_TRUE(piece.HasSurface);
  }
  const auto point = Walk(field.View, { 4.0, 0.0 }, { 4.0, 0.0 });
  ASSERT_EQ(point.size(), 1u);
  EXPECT_TRUE(point[0].HasSurface);
  EXPECT_NEAR(point[0].HeightAt(0.5), field.Samples[4], 1e-12);
}

TEST(SurfacePath, DegenerateGrids)
{
  const PathField line = Random(1, 7, 4);
  for (const terrain::SurfacePiece& piece : Walk(line.View, { 0.0, 0.0 }, { 0.0, 6.0 }))
  {
    EXPECT_FALSE(piece.HasSurface) << "a single column has no cells";
  }
  EXPECT_EQ(Walk(terrain::HeightfieldView<double>(), { 0.0, 0.0 }, { 1.0, 1.0 }).size(), 1u);
}

// Numbers so large that their neighbours are further than a cell away.
TEST(SurfacePath, FarBeyondTheGrid)
{
  const PathField field = Random(4, 4, 5);
  for (const double far : { 1e17, -1e17, 1e300, -1e300 })
  {
    const auto point = Walk(field.View, { far, 1.5 }, { far, 1.5 });
    ASSERT_EQ(point.size(), 1u);
    EXPECT_FALSE(point[0].HasSurface);
    EXPECT_FALSE(Walk(field.View, { 1.5, far }, { 1.5, far })[0].HasSurface);
  }
  const auto across = Walk(field.View, { 1.5, 1.5 }, { 1.5, 1e17 });
  EXPECT_TRUE(across.front().HasSurface);
  EXPECT_FALSE(across.back().HasSurface);
}

TEST(SurfacePath, HighestOfParabolas)
{
  const terrain::Highest top = terrain::HighestOf(0.0, 1.0, -1.0, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(top.Parameter, 0.5);
  EXPECT_DOUBLE_EQ(top.Value, 0.25);
  EXPECT_DOUBLE_EQ(terrain::HighestOf(0.0, 1.0, -1.0, 0.6, 1.0).Parameter, 0.6);
  EXPECT_DOUBLE_EQ(terrain::HighestOf(0.0, 0.0, 1.0, -1.0, 2.0).Value, 4.0);
}
