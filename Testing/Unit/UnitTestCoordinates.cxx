// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// GridGeometry against the formula z = origin z + exaggeration * height, and its parts against one
// another.
#include "core/grid/Coordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using terrain::GridGeometry;

/// Of rounding, as a part of the largest number.
constexpr double kRounding = 1e-12;

std::vector<GridGeometry> Geometries()
{
  return { {}, { { 100.0, -200.0, 700.0 }, { 10.0, 12.0 }, 1.0 },
    { { 478000.0, 3088000.0, -431.0 }, { 30.0, 20.0 }, 2.5 },
    { { -5.0, 1e7, 1e6 }, { 1e-3, 4e3 }, 50.0 }, { { 1.0, 2.0, 3.0 }, { 7.0, 7.0 }, 0.02 } };
}

void ExpectNear(const glm::dvec3& a, const glm::dvec3& b, double scale)
{
  EXPECT_LE(glm::length(a - b), kRounding * scale);
}
}

TEST(GridGeometry, DrawsHeightsFromItsOrigin)
{
  const GridGeometry geometry{ { 100.0, 200.0, 700.0 }, { 10.0, 12.0 }, 3.0 };
  const glm::dvec3 model = geometry.ToModel({ 2.0, 5.0 }, 40.0);
  EXPECT_EQ(model, glm::dvec3(120.0, 260.0, 820.0));
  EXPECT_EQ(geometry.ToDrawnZ(740.0), 820.0);
  EXPECT_EQ(geometry.ToTrueZ(820.0), 740.0);
  EXPECT_EQ(geometry.ToDrawnZ(700.0), 700.0) << "the height 0 stays where it is";
  EXPECT_EQ(geometry.RiseToModel(40.0), 120.0);
  EXPECT_EQ(geometry.RiseToHeights(120.0), 40.0);
  // sqrt(10 * 12) long: as high as that when drawn three times
  EXPECT_DOUBLE_EQ(geometry.RiseToModel(geometry.HeightOfCellSide()), std::sqrt(120.0));
}

TEST(GridGeometry, WaysThereAndBackAgree)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> cells(-50.0, 5000.0);
  std::uniform_real_distribution<double> heights(-9000.0, 9000.0);
  for (const GridGeometry& geometry : Geometries())
  {
    for (int k = 0; k < 200; ++k)
    {
      const glm::dvec3 grid(cells(random), cells(random), heights(random));
      const glm::dvec3 model = geometry.ToModel(glm::dvec2(grid), grid.z);
      const double scale = glm::length(model) + glm::length(grid) + glm::length(geometry.Origin);
      const double smallest =
        std::min({ geometry.Spacing.x, geometry.Spacing.y, geometry.Exaggeration, 1.0 });
      ExpectNear(geometry.ToGrid(model), grid, scale / smallest);
      ExpectNear(glm::dvec3(geometry.GridToModel() * glm::dvec4(grid, 1.0)), model, scale);
      // a point with its true z, and where it is drawn
      const glm::dvec3 plain(model.x, model.y, geometry.Origin.z + grid.z);
      ExpectNear(glm::dvec3(geometry.TrueToDrawn() * glm::dvec4(plain, 1.0)), model, scale);
      EXPECT_NEAR(geometry.ToDrawnZ(plain.z), model.z, kRounding * scale);
      EXPECT_NEAR(geometry.ToTrueZ(model.z), plain.z, kRounding * scale / smallest);
    }
  }
}

TEST(GridGeometry, DirectionsPlanesAndNormalsBelongToThePoints)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-100.0, 100.0);
  const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  for (const GridGeometry& geometry : Geometries())
  {
    for (int k = 0; k < 200; ++k)
    {
      const glm::dvec3 a = vector();
      const glm::dvec3 b = vector();
      const glm::dvec3 c = vector();
      const auto toModel = [&](const glm::dvec3& grid)
      { return geometry.ToModel(glm::dvec2(grid), grid.z); };
      const double scale = glm::length(toModel(a)) + glm::length(toModel(b)) + 1e4;
      const double smallest =
        std::min({ geometry.Spacing.x, geometry.Spacing.y, geometry.Exaggeration, 1.0 });
      ExpectNear(geometry.DirectionToGrid(toModel(b) - toModel(a)), b - a, scale / smallest);
      // the normal of a triangle of the grid, brought to the model, is that of the drawn triangle
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const glm::dvec3 drawn = glm::cross(toModel(b) - toModel(a), toModel(c) - toModel(a));
      const glm::dvec3 moved = geometry.NormalToModel(normal);
      EXPECT_NEAR(glm::dot(glm::normalize(moved), glm::normalize(drawn)), 1.0, 1e-6);
      // a plane of the model has the same points on the same sides
      const glm::dvec4 plane(vector(), number(random));
      const double inModel = glm::dot(plane, glm::dvec4(toModel(a), 1.0));
      const double inGrid = glm::dot(geometry.PlaneToGrid(plane), glm::dvec4(a, 1.0));
      EXPECT_NEAR(
        inGrid, inModel, kRounding * 100.0 * scale * (1.0 + glm::length(geometry.Origin)));
    }
  }
}
