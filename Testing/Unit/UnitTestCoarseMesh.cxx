// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// No point of any patch lies above the coarse mesh, on a hundred thousand random and adversarial
// fields; and the mesh is no higher than it must be.
#include "core/grid/Constants.h"
#include "core/mesh/CoarseMesh.h"
#include "core/mesh/CoarseMeshSurface.h"

#include "UnitTestFields.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace
{
using Real = long double;
using Vector2 = glm::tvec2<Real>;
/// Rounding of the sums of this test in long double, as a fraction of their largest term; far below
/// what the mesh must absorb (doubles).
constexpr Real kTestRounding = 32 * std::numeric_limits<Real>::epsilon();

template <typename T>
struct Field
{
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::vector<T> Samples;

  terrain::HeightfieldView<T> View() const
  {
    terrain::HeightfieldView<T> view;
    view.Samples = this->Samples.data();
    view.Width = this->Width;
    view.Height = this->Height;
    return view;
  }
};

template <typename T, typename Function>
Field<T> MakeField(std::int64_t width, std::int64_t height, Function&& heightAt)
{
  Field<T> field{ width, height, {} };
  field.Samples.reserve(width * height);
  for (std::int64_t j = 0; j < height; ++j)
  {
    for (std::int64_t i = 0; i < width; ++i)
    {
      field.Samples.push_back(static_cast<T>(heightAt(i, j)));
    }
  }
  return field;
}

/// Kinds of adversarial fields, by number.
constexpr int kKinds = 10;

double AdversarialHeight(int kind, std::int64_t i, std::int64_t j, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double noise = uniform(random);
  switch (kind)
  {
    case 0: // noise
      return 100.0 * noise;
    case 1: // spikes
      return noise > 0.9 ? 1e4 : 0.0;
    case 2: // checkerboard
      return ((i + j) & 1) != 0 ? 50.0 : -50.0;
    case 3: // valley along the diagonal
      return static_cast<double>(std::abs(i - j)) + 0.2 * noise;
    case 4: // valley across the diagonal, steep
      return std::abs(static_cast<double>(i + j) - 7.0) * 13.0 + noise;
    case 5: // cliff
      return (2 * i < 3 * j ? 1000.0 : 0.0) + noise;
    case 6: // small relief on a large offset
      return 1e6 + 1e-2 * noise;
    case 7: // heights of very different size
      return std::ldexp(noise, static_cast<int>(40.0 * uniform(random)));
    case 8: // smooth
      return 20.0 * std::sin(0.7 * static_cast<double>(i)) * std::cos(0.5 * static_cast<double>(j));
    default: // small whole numbers
      return std::floor(3.0 * noise);
  }
}

/// A triangle of the mesh over grid positions: height = Start + Slope . (position - Origin).
struct Plane
{
  Vector2 Origin;
  Real Start;
  Vector2 Slope;

  Real At(const Vector2& p) const
  {
    return this->Start + this->Slope.x * (p.x - this->Origin.x) +
      this->Slope.y * (p.y - this->Origin.y);
  }
};

/// A quad of a mesh in long double, from the heights of its corners (SW, SE, NW, NE). Heights are
/// relative to the first corner, so that an offset costs no precision.
struct ExactQuad
{
  ExactQuad(const terrain::CoarseMesh& mesh, std::int64_t qx, std::int64_t qy,
    const std::array<double, 4>& corners)
    : First(mesh.Column(qx), mesh.Row(qy))
    , Last(mesh.Column(qx + 1), mesh.Row(qy + 1))
  {
    const Real w = Last.x - First.x;
    const Real h = Last.y - First.y;
    this->Reference = corners[0];
    std::array<Real, 4> z{};
    for (std::size_t k = 0; k < 4; ++k)
    {
      z[k] = corners[k] - this->Reference;
      this->Relief = std::max(this->Relief, std::abs(z[k]));
    }
    this->South = { First, z[0], { (z[1] - z[0]) / w, (z[3] - z[1]) / h } };
    this->North = { First, z[0], { (z[3] - z[2]) / w, (z[2] - z[0]) / h } };
  }

  /// > 0 south of the diagonal.
  Real Side(const Vector2& p) const
  {
    return (p.x - First.x) * (Last.y - First.y) - (p.y - First.y) * (Last.x - First.x);
  }

  Vector2 First;
  Vector2 Last;
  Real Reference = 0;
  /// Largest relative height at a corner.
  Real Relief = 0;
  Plane South;
  Plane North;
};

struct Cell
{
  Vector2 Corner;
  std::array<Real, 4> Heights;

  Real At(const Vector2& p) const
  {
    const Vector2 f = p - this->Corner;
    const Real south = this->Heights[0] + f.x * (this->Heights[1] - this->Heights[0]);
    const Real north = this->Heights[2] + f.x * (this->Heights[3] - this->Heights[2]);
    return south + f.y * (north - south);
  }
};

template <typename T>
Cell MakeCell(const Field<T>& field, std::int64_t i, std::int64_t j, Real reference)
{
  const auto view = field.View();
  return { Vector2(i, j),
    { view.At(i, j) - reference, view.At(i + 1, j) - reference, view.At(i, j + 1) - reference,
      view.At(i + 1, j + 1) - reference } };
}

struct Extremes
{
  Real Low = std::numeric_limits<Real>::infinity();
  Real High = -std::numeric_limits<Real>::infinity();

  void Add(Real value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
};

/// Part of the cell's square where sign * quad.Side >= 0.
std::vector<Vector2> ClipCell(const Cell& cell, const ExactQuad& quad, Real sign)
{
  const std::array<Vector2, 4> square{ cell.Corner, cell.Corner + Vector2(1, 0),
    cell.Corner + Vector2(1, 1), cell.Corner + Vector2(0, 1) };
  std::vector<Vector2> polygon;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Vector2 a = square[k];
    const Vector2 b = square[(k + 1) % 4];
    const Real sideA = sign * quad.Side(a);
    const Real sideB = sign * quad.Side(b);
    if (sideA >= 0)
    {
      polygon.push_back(a);
    }
    if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0))
    {
      polygon.push_back(a + (b - a) * (sideA / (sideA - sideB)));
    }
  }
  return polygon;
}

/// Extremes of patch minus mesh over a cell: they lie on the border of its parts on either side of
/// the diagonal, where the difference is quadratic.
void AddCellExtremes(const Cell& cell, const ExactQuad& quad, Extremes& extremes)
{
  for (const Real sign : { 1.0L, -1.0L })
  {
    const Plane& plane = sign > 0 ? quad.South : quad.North;
    const std::vector<Vector2> polygon = ClipCell(cell, quad, sign);
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const Vector2 a = polygon[k];
      const Vector2 b = polygon[(k + 1) % polygon.size()];
      const Vector2 m = (a + b) / 2.0L;
      const Real fa = cell.At(a) - plane.At(a);
      const Real fm = cell.At(m) - plane.At(m);
      const Real fb = cell.At(b) - plane.At(b);
      extremes.Add(fa);
      // f(t) = fa + slope t + curvature t^2
      const Real curvature = 2 * (fa + fb - 2 * fm);
      const Real slope = fb - fa - curvature;
      const Real t = curvature != 0 ? -slope / (2 * curvature) : 0;
      if (t > 0 && t < 1)
      {
        const Vector2 p = a + (b - a) * t;
        extremes.Add(cell.At(p) - plane.At(p));
      }
    }
  }
}

/// Patch minus mesh at a lattice of positions of a cell.
void AddCellLattice(const Cell& cell, const ExactQuad& quad, Extremes& extremes)
{
  constexpr int kSteps = 4;
  for (int k = 0; k < (kSteps + 1) * (kSteps + 1); ++k)
  {
    const Vector2 p =
      cell.Corner + Vector2(k % (kSteps + 1), k / (kSteps + 1)) / static_cast<Real>(kSteps);
    extremes.Add(cell.At(p) - (quad.Side(p) > 0 ? quad.South : quad.North).At(p));
  }
}

/// Extremes of surface minus a quad with the given corners; empty if no cell has a surface.
template <typename T>
Extremes QuadExtremes(const Field<T>& field, const terrain::CoarseMesh& mesh, std::int64_t qx,
  std::int64_t qy, const std::array<double, 4>& corners, bool lattice)
{
  const ExactQuad quad(mesh, qx, qy, corners);
  const auto view = field.View();
  Extremes extremes;
  for (std::int64_t j = mesh.Row(qy); j < mesh.Row(qy + 1); ++j)
  {
    for (std::int64_t i = mesh.Column(qx); i < mesh.Column(qx + 1); ++i)
    {
      if (view.IsCellValid(i, j))
      {
        const Cell cell = MakeCell(field, i, j, quad.Reference);
        AddCellExtremes(cell, quad, extremes);
        if (lattice)
        {
          AddCellLattice(cell, quad, extremes);
        }
      }
    }
  }
  return extremes;
}

std::array<double, 4> MeshCorners(const terrain::CoarseMesh& mesh, std::int64_t qx, std::int64_t qy)
{
  return { mesh.VertexHeight(qx, qy), mesh.VertexHeight(qx + 1, qy), mesh.VertexHeight(qx, qy + 1),
    mesh.VertexHeight(qx + 1, qy + 1) };
}

/// Checks one mesh: nothing above it, quads kept by the rule, gap as reported.
template <typename T>
void CheckConservative(const Field<T>& field, const terrain::CoarseMesh& mesh)
{
  Real gap = 0;
  Real relief = 0;
  for (std::int64_t qy = 0; qy < mesh.QuadsY; ++qy)
  {
    for (std::int64_t qx = 0; qx < mesh.QuadsX; ++qx)
    {
      const Extremes extremes = QuadExtremes(field, mesh, qx, qy, MeshCorners(mesh, qx, qy), true);
      const bool hasSurface = extremes.Low <= extremes.High;
      ASSERT_EQ(mesh.IsKept(qx, qy), hasSurface) << "quad " << qx << ", " << qy;
      if (hasSurface)
      {
        const auto corners = MeshCorners(mesh, qx, qy);
        const Real cornerRelief = ExactQuad(mesh, qx, qy, corners).Relief;
        ASSERT_LE(extremes.High, kTestRounding * std::max(-extremes.Low, cornerRelief))
          << "surface above quad " << qx << ", " << qy;
        gap = std::max(gap, -extremes.Low);
        relief = std::max<Real>({ relief, mesh.MaximumHeight - mesh.MinimumHeight, gap });
      }
    }
  }
  ASSERT_NEAR(mesh.LargestGap, static_cast<double>(gap), static_cast<double>(relief * 1e-14L));
}

/// Checks that quads without gaps were pushed no farther than to touch the surface, and that
/// vertices were raised no farther than to the highest of their quads.
template <typename T>
void CheckTight(const Field<T>& field, const terrain::CoarseMesh& mesh)
{
  const auto view = field.View();
  std::vector<double> highest(mesh.VertexHeights.size(), -std::numeric_limits<double>::infinity());
  for (std::int64_t qy = 0; qy < mesh.QuadsY; ++qy)
  {
    for (std::int64_t qx = 0; qx < mesh.QuadsX; ++qx)
    {
      std::array<double, 4> corners{};
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = view.At(mesh.Column(qx + (k & 1)), mesh.Row(qy + (k >> 1)));
      }
      const Extremes extremes = QuadExtremes(field, mesh, qx, qy, corners, false);
      const double push = mesh.QuadPushes[qx + mesh.QuadsX * qy];
      const double relief = mesh.MaximumHeight - mesh.MinimumHeight;
      ASSERT_GE(push, static_cast<double>(extremes.High));
      ASSERT_LE(push - static_cast<double>(extremes.High), 2.0 * terrain::kPushSlack * relief);
      for (int k = 0; k < 4; ++k)
      {
        double& vertex = highest[qx + (k & 1) + (mesh.QuadsX + 1) * (qy + (k >> 1))];
        vertex = std::max(vertex, corners[k] + push);
      }
    }
  }
  for (std::size_t k = 0; k < highest.size(); ++k)
  {
    const double rounding =
      4e-15 * (std::abs(highest[k]) + mesh.MaximumHeight - mesh.MinimumHeight);
    ASSERT_NEAR(mesh.VertexHeights[k], highest[k], rounding);
  }
}

terrain::CoarseMesh Build(const Field<double>& field, std::int64_t cellsPerQuad)
{
  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = cellsPerQuad;
  return terrain::BuildCoarseMesh(field.View(), options, terrain::SerialFor);
}
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, NoPatchPointAboveCompleteFields)
{
  std::mt19937 random(20240607);
  for (int run = 0; run < 42000; ++run)
  {
    const int kind = run % kKinds;
    const std::int64_t width = 2 + random() % 8;
    const std::int64_t height = 2 + random() % 8;
    const auto field = MakeField<double>(width, height,
      [&](std::int64_t i, std::int64_t j) { return AdversarialHeight(kind, i, j, random); });
    const terrain::CoarseMesh mesh = Build(field, 1 + random() % 7);
    CheckConservative(field, mesh);
    CheckTight(field, mesh);
    ASSERT_FALSE(HasFatalFailure()) << "run " << run << ", kind " << kind;
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, NoPatchPointAboveFieldsWithoutData)
{
  std::mt19937 random(7071);
  for (int run = 0; run < 40000; ++run)
  {
    const int kind = run % kKinds;
    const std::int64_t width = 1 + random() % 9;
    const std::int64_t height = 1 + random() % 9;
    const unsigned int missing = random() % 70;
    const auto field = MakeField<double>(width, height,
      [&](std::int64_t i, std::int64_t j)
      {
        const double value = AdversarialHeight(kind, i, j, random);
        const bool none = random() % 100 < missing;
        return none ? ((random() & 1) != 0 ? terrain::kNaN : HUGE_VAL) : value;
      });
    const terrain::CoarseMesh mesh = Build(field, 1 + random() % 7);
    CheckConservative(field, mesh);
    ASSERT_FALSE(HasFatalFailure()) << "run " << run << ", kind " << kind;
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, NoPatchPointAboveIntegerFields)
{
  std::mt19937 random(31);
  for (int run = 0; run < 20000; ++run)
  {
    auto field = MakeField<std::int16_t>(2 + random() % 12, 2 + random() % 5,
      [&](std::int64_t, std::int64_t) { return static_cast<std::int16_t>(random()); });
    terrain::CoarseMeshOptions options;
    options.CellsPerQuad = 1 + random() % 9;
    const auto mesh = terrain::BuildCoarseMesh(field.View(), options, terrain::SerialFor);
    CheckConservative(field, mesh);
    CheckTight(field, mesh);
    ASSERT_FALSE(HasFatalFailure()) << "run " << run;
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, DiagonalValleyIsPushedAboveItsPatch)
{
  // The diagonal is at 0 and the middle of the patch at 0.5.
  const Field<double> field{ 2, 2, { 0.0, 1.0, 1.0, 0.0 } };
  const terrain::CoarseMesh mesh = Build(field, 1);
  EXPECT_NEAR(mesh.QuadPushes[0], 0.5, 1e-12);
  EXPECT_NEAR(mesh.VertexHeight(0, 0), 0.5, 1e-12);
  EXPECT_NEAR(mesh.LargestGap, 0.5, 1e-12);
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, DegenerateSizesHaveNoQuads)
{
  for (const auto& size : { std::pair<int, int>{ 0, 0 }, { 1, 1 }, { 1, 9 }, { 9, 1 } })
  {
    const auto field =
      MakeField<double>(size.first, size.second, [](std::int64_t, std::int64_t) { return 1.0; });
    const terrain::CoarseMesh mesh = Build(field, 0);
    EXPECT_EQ(mesh.QuadsX * mesh.QuadsY, 0);
    const terrain::CoarseMeshSurface surface(mesh, true, 0.0);
    EXPECT_EQ(surface.NumberOfVertices(), 0);
    EXPECT_EQ(surface.NumberOfTriangles(), 0);
    surface.ForEachVertex([](std::int64_t, const terrain::CoarseMeshVertex&) { FAIL(); });
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, FlatFieldIsTouched)
{
  const auto field = MakeField<double>(7, 5, [](std::int64_t, std::int64_t) { return 8848.0; });
  const terrain::CoarseMesh mesh = Build(field, 4);
  EXPECT_EQ(mesh.QuadsX, 2);
  EXPECT_EQ(mesh.QuadsY, 1);
  EXPECT_EQ(mesh.LargestGap, 0.0);
  EXPECT_EQ(mesh.VertexHeight(2, 1), 8848.0);
  EXPECT_EQ(mesh.MinimumHeight, 8848.0);
  EXPECT_EQ(mesh.MaximumHeight, 8848.0);
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, NoDataOnlyKeepsNothing)
{
  auto field = MakeField<double>(9, 9, [](std::int64_t, std::int64_t) { return terrain::kNaN; });
  EXPECT_EQ(Build(field, 4).QuadKept, std::vector<unsigned char>(4, 0));
  // A single height makes no cell.
  field.Samples[40] = 1.0;
  EXPECT_EQ(Build(field, 4).QuadKept, std::vector<unsigned char>(4, 0));
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, MaskAndValueMeanNoData)
{
  auto field = MakeField<int>(5, 5, [](std::int64_t i, std::int64_t) { return i < 2 ? -1 : 10; });
  auto view = field.View();
  view.HasNoData = true;
  view.NoData = -1;
  std::vector<unsigned char> mask(25, 0);
  mask[4] = 2;
  view.Mask = mask.data();
  view.MaskBits = 2;
  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = 1;
  const auto mesh = terrain::BuildCoarseMesh(view, options, terrain::SerialFor);
  EXPECT_FALSE(mesh.IsKept(0, 0));
  EXPECT_FALSE(mesh.IsKept(1, 3));
  EXPECT_TRUE(mesh.IsKept(2, 0));
  EXPECT_FALSE(mesh.IsKept(3, 0));
  EXPECT_EQ(mesh.MinimumHeight, 10.0);
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, AutomaticSizeLeavesAtMost128Quads)
{
  EXPECT_EQ(terrain::AutomaticCellsPerQuad(2, 2), 4);
  EXPECT_EQ(terrain::AutomaticCellsPerQuad(513, 3), 4);
  EXPECT_EQ(terrain::AutomaticCellsPerQuad(3, 514), 8);
  EXPECT_EQ(terrain::AutomaticCellsPerQuad(8192, 5120), 64);
  EXPECT_EQ(terrain::AutomaticCellsPerQuad(1000000001, 1), 1 << 23);
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, WithoutPushUpTheSamplesAreKept)
{
  std::mt19937 random(5);
  const auto field = MakeField<float>(
    6, 8, [&](std::int64_t i, std::int64_t j) { return AdversarialHeight(0, i, j, random); });
  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = 1;
  options.PushUp = false;
  const auto mesh = terrain::BuildCoarseMesh(field.View(), options, terrain::SerialFor);
  EXPECT_TRUE(mesh.QuadPushes.empty());
  for (std::size_t k = 0; k < field.Samples.size(); ++k)
  {
    EXPECT_EQ(mesh.VertexHeights[k], field.Samples[k]);
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, SameHoweverRangesAreSplit)
{
  std::mt19937 random(6);
  const auto field = MakeField<double>(61, 37,
    [&](std::int64_t i, std::int64_t j)
    { return random() % 9 == 0 ? terrain::kNaN : AdversarialHeight(0, i, j, random); });
  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = 5;
  const auto once = terrain::BuildCoarseMesh(field.View(), options, terrain::SerialFor);
  const auto split = terrain::BuildCoarseMesh(field.View(), options, terrain::BackwardFor);
  EXPECT_EQ(once.LargestGap, split.LargestGap);
  EXPECT_EQ(once.QuadKept, split.QuadKept);
  EXPECT_EQ(once.MinimumHeight, split.MinimumHeight);
  for (std::size_t k = 0; k < once.VertexHeights.size(); ++k)
  {
    const double a = once.VertexHeights[k];
    const double b = split.VertexHeights[k];
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
  }
}

//------------------------------------------------------------------------------
TEST(CoarseMesh, HullIsAClosedManifoldOrientedOutward)
{
  std::mt19937 random(8);
  for (int run = 0; run < 500; ++run)
  {
    const auto field = MakeField<double>(2 + random() % 9, 2 + random() % 9,
      [&](std::int64_t i, std::int64_t j)
      { return random() % 4 == 0 ? terrain::kNaN : AdversarialHeight(0, i, j, random); });
    const terrain::CoarseMesh mesh = Build(field, 1 + random() % 3);
    const terrain::CoarseMeshSurface surface(mesh, true, mesh.MinimumHeight - 1.0);
    std::vector<glm::dvec3> points(surface.NumberOfVertices(), glm::dvec3(terrain::kNaN));
    surface.ForEachVertex(
      [&](std::int64_t id, const terrain::CoarseMeshVertex& v) {
        points[id] = { v.Column, v.Row, v.Height };
      });
    std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
    std::int64_t triangles = 0;
    double volume = 0.0;
    surface.ForEachTriangle(
      [&](std::int64_t a, std::int64_t b, std::int64_t c)
      {
        ++triangles;
        ++edges[{ a, b }];
        ++edges[{ b, c }];
        ++edges[{ c, a }];
        volume += glm::dot(points[a], glm::cross(points[b], points[c])) / 6.0;
      });
    EXPECT_EQ(triangles, surface.NumberOfTriangles());
    for (const auto& edge : edges)
    {
      ASSERT_EQ(edge.second, 1) << "run " << run;
      const auto reverse = edges.find({ edge.first.second, edge.first.first });
      ASSERT_NE(reverse, edges.end()) << "run " << run;
    }
    for (const glm::dvec3& point : points)
    {
      ASSERT_FALSE(std::isnan(point.x));
    }
    EXPECT_TRUE(points.empty() || volume > 0.0);
  }
}
