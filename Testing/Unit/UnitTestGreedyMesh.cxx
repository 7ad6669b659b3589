// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitTestFields.h"

#include "core/mesh/GreedyMesh.h"
#include "core/mesh/MeshError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using namespace terrain;

GreedyMeshOptions Options(double maximumError, int cellsPerTile)
{
  GreedyMeshOptions options;
  options.MaximumError = maximumError;
  options.CellsPerTile = cellsPerTile;
  return options;
}

double Cross(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
{
  return static_cast<double>(b.x - a.x) * (c.y - a.y) -
    static_cast<double>(b.y - a.y) * (c.x - a.x);
}

/// The height of the mesh at a sample by looking at every triangle; NaN if none covers it.
double HeightByAllTriangles(const TestField& field, const GridMesh& mesh, const glm::ivec2& p)
{
  for (std::size_t k = 0; k < mesh.Triangles.size(); k += 3)
  {
    glm::ivec2 corners[3];
    double heights[3];
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = mesh.Vertices[mesh.Triangles[k + c]];
      heights[c] = field.View().At(corners[c].x, corners[c].y);
    }
    const double weights[3] = { Cross(corners[1], corners[2], p), Cross(corners[2], corners[0], p),
      Cross(corners[0], corners[1], p) };
    if (weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0)
    {
      return (weights[0] * heights[0] + weights[1] * heights[1] + weights[2] * heights[2]) /
        (weights[0] + weights[1] + weights[2]);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool HasCell(const HeightfieldView<double>& view, std::int64_t i, std::int64_t j)
{
  return i >= 0 && j >= 0 && i < view.Width - 1 && j < view.Height - 1 && view.IsCellValid(i, j);
}

/// Number of cells with a surface, and length of the border between cells with and without one.
std::pair<double, double> AreaAndBorder(const HeightfieldView<double>& view)
{
  double area = 0.0;
  double border = 0.0;
  for (std::int64_t j = 0; j < view.Height - 1; ++j)
  {
    for (std::int64_t i = 0; i < view.Width - 1; ++i)
    {
      if (HasCell(view, i, j))
      {
        area += 1.0;
        border += !HasCell(view, i - 1, j) + !HasCell(view, i + 1, j) + !HasCell(view, i, j - 1) +
          !HasCell(view, i, j + 1);
      }
    }
  }
  return { area, border };
}
}

TEST(GreedyMesh, IsEmptyWithoutCells)
{
  const std::vector<double> samples{ 1.0, 2.0, 3.0 };
  HeightfieldView<double> view;
  EXPECT_TRUE(BuildGreedyMesh(view, Options(1.0, 8), SerialFor).Triangles.empty());
  view.Samples = samples.data();
  view.Width = 3;
  view.Height = 1;
  EXPECT_TRUE(BuildGreedyMesh(view, Options(1.0, 8), SerialFor).Vertices.empty());
  const double none = std::numeric_limits<double>::quiet_NaN();
  const TestField field(
    "hole", 3, 3, [none](int i, int j) { return i == 1 && j == 1 ? none : 0.0; });
  EXPECT_TRUE(BuildGreedyMesh(field.View(), Options(1.0, 8), SerialFor).Vertices.empty());
}

TEST(GreedyMesh, KeepsItsErrorAtEverySample)
{
  for (const TestField& field : AdversarialFields())
  {
    const HeightfieldView<double> view = field.View();
    double highest = 0.0;
    for (const double sample : field.Samples)
    {
      highest = std::isnan(sample) ? highest : std::max(highest, std::abs(sample));
    }
    const double rounding = 2.0 * terrain::kMeshErrorSlack * highest;
    for (const double tolerance : { 0.0, 0.004, 1.0, 30.0, 1e9 })
    {
      for (const int cells : { 1, 7, 16, 1024 })
      {
        SCOPED_TRACE(field.Name + ", tolerance " + std::to_string(tolerance) + ", tiles of " +
          std::to_string(cells));
        const GridMesh mesh = BuildGreedyMesh(view, Options(tolerance, cells), SerialFor);
        EXPECT_LE(FindMeshError(view, mesh, SerialFor), std::max(tolerance, rounding));
        if (cells == 7 && tolerance == 1.0)
        {
          double largest = 0.0;
          for (int j = 0; j < field.Height; ++j)
          {
            for (int i = 0; i < field.Width; ++i)
            {
              const bool isCovered = HasCell(view, i, j) || HasCell(view, i - 1, j) ||
                HasCell(view, i, j - 1) || HasCell(view, i - 1, j - 1);
              const double height = HeightByAllTriangles(field, mesh, { i, j });
              EXPECT_EQ(std::isnan(height), !isCovered);
              largest = isCovered ? std::max(largest, std::abs(height - view.At(i, j))) : largest;
            }
          }
          EXPECT_NEAR(largest, FindMeshError(view, mesh, SerialFor), rounding);
        }
      }
    }
  }
}

// A vertex inside of a neighbour's edge would leave both with a border there; a triangle too many
// or too few would change the area.
TEST(GreedyMesh, CoversEachCellOnceWithoutCracks)
{
  for (const TestField& field : AdversarialFields())
  {
    const auto [area, border] = AreaAndBorder(field.View());
    for (const int cells : { 1, 5, 16, 1024 })
    {
      SCOPED_TRACE(field.Name + ", tiles of " + std::to_string(cells));
      const GridMesh mesh = BuildGreedyMesh(field.View(), Options(2.0, cells), SerialFor);
      double covered = 0.0;
      for (std::size_t k = 0; k < mesh.Triangles.size(); k += 3)
      {
        const double twice = Cross(mesh.Vertices[mesh.Triangles[k]],
          mesh.Vertices[mesh.Triangles[k + 1]], mesh.Vertices[mesh.Triangles[k + 2]]);
        EXPECT_GT(twice, 0.0);
        covered += 0.5 * twice;
      }
      EXPECT_DOUBLE_EQ(covered, area);
      double length = 0.0;
      for (const glm::ivec2& edge : FindBorderEdges(mesh))
      {
        length += glm::length(glm::dvec2(mesh.Vertices[edge.y] - mesh.Vertices[edge.x]));
      }
      EXPECT_DOUBLE_EQ(length, border);
    }
  }
}

TEST(GreedyMesh, SpendsNothingOnPlanes)
{
  const TestField plane("plane", 65, 33, [](int i, int j) { return 1e6 + 3.0 * i - 2.0 * j; });
  EXPECT_EQ(BuildGreedyMesh(plane.View(), Options(0.0, 1024), SerialFor).Triangles.size(), 6u);
}

TEST(GreedyMesh, FindsWhatIsNotCoveredAndWhatIsOff)
{
  const TestField field("bump", 3, 3, [](int i, int j) { return i == 1 && j == 1 ? 4.0 : 0.0; });
  GridMesh mesh;
  mesh.Vertices = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  mesh.Triangles = { 0, 1, 2 };
  EXPECT_TRUE(std::isinf(FindMeshError(field.View(), mesh, SerialFor)));
  mesh.Triangles = { 0, 1, 2, 0, 2, 3 };
  EXPECT_EQ(FindMeshError(field.View(), mesh, SerialFor), 4.0);
}

// The judge solves for the plane through three points of 32 bits, in model coordinates.
TEST(GreedyMesh, FindsTheErrorOfRoundedPoints)
{
  const TestField field("waves", 9, 7, [](int i, int j) { return 40.0 * std::sin(i + 0.7 * j); });
  const HeightfieldView<double> view = field.View();
  GridGeometry geometry;
  geometry.Origin = { 399970.3, 5200010.7, 11.0 };
  geometry.Spacing = { 9.7, 10.3 };
  geometry.Exaggeration = 1.7;
  const GridMesh mesh = BuildGreedyMesh(view, Options(3.0, 16), SerialFor);
  double expected = 0.0;
  for (std::size_t k = 0; k < mesh.Triangles.size(); k += 3)
  {
    glm::ivec2 corners[3];
    glm::dvec3 points[3];
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = mesh.Vertices[mesh.Triangles[k + c]];
      points[c] = glm::vec3(geometry.ToModel(corners[c], view.At(corners[c].x, corners[c].y)));
    }
    const glm::dvec3 normal = glm::cross(points[1] - points[0], points[2] - points[0]);
    for (int index = 0; index < 9 * 7; ++index)
    {
      const glm::ivec2 p(index % 9, index / 9);
      if (Cross(corners[1], corners[2], p) >= 0.0 && Cross(corners[2], corners[0], p) >= 0.0 &&
        Cross(corners[0], corners[1], p) >= 0.0)
      {
        const glm::dvec3 sample = geometry.ToModel(p, view.At(p.x, p.y));
        const double off = glm::dot(normal, sample - points[0]) / normal.z;
        expected = std::max(expected, std::abs(off) / geometry.Exaggeration);
      }
    }
  }
  const double exact = FindMeshError(view, mesh, SerialFor);
  const double rounded = FindMeshError(view, mesh, BackwardFor, &geometry);
  EXPECT_NEAR(rounded, expected, 1e-6);
  EXPECT_GT(std::abs(rounded - exact), 1e-3);
  const glm::dvec3 margin = FindRoundingMargin(view, geometry, BackwardFor);
  EXPECT_LE(std::abs(rounded - exact), margin.z);
  EXPECT_DOUBLE_EQ(margin.x, 0.5 / 32.0 / 9.7); // 24 bits hold 2^18 to 2^19 in steps of 1/32
  EXPECT_DOUBLE_EQ(margin.y, 0.5 / 2.0 / 10.3);
}

TEST(GreedyMesh, IsTheSameHoweverRangesAreSplit)
{
  for (const TestField& field : AdversarialFields())
  {
    for (const int cells : { 2, 8 })
    {
      const GridMesh serial = BuildGreedyMesh(field.View(), Options(1.0, cells), SerialFor);
      const GridMesh split = BuildGreedyMesh(field.View(), Options(1.0, cells), BackwardFor);
      EXPECT_EQ(serial.Triangles, split.Triangles) << field.Name;
      EXPECT_EQ(serial.Vertices, split.Vertices) << field.Name;
    }
  }
}
