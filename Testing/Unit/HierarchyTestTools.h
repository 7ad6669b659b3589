// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heightfields, brute-force errors and mesh checks that the tests of the hierarchy share.
 */
#ifndef HierarchyTestTools_h
#define HierarchyTestTools_h

#include "core/strips/HierarchyBuild.h"
#include "core/strips/Refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace hierarchytest
{
using Sample = std::array<std::int64_t, 2>;
using Triangle = std::array<Sample, 3>;

constexpr float None = std::numeric_limits<float>::quiet_NaN();

/// A raster of heights, NaN where there are none.
struct Raster
{
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::vector<float> Heights;

  float At(std::int64_t x, std::int64_t y) const
  {
    return this->Heights[x + this->Width * y];
  }
  /// Height of the bilinear surface; corners of weight 0 do not spread their NaN.
  double HeightAt(double x, double y) const
  {
    const std::int64_t i = std::min(static_cast<std::int64_t>(x), this->Width - 2);
    const std::int64_t j = std::min(static_cast<std::int64_t>(y), this->Height - 2);
    const double u = x - i;
    const double v = y - j;
    double height = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int east = corner & 1;
      const int north = corner >> 1;
      const double weight = (east != 0 ? u : 1.0 - u) * (north != 0 ? v : 1.0 - v);
      height += weight > 0.0 ? weight * this->At(i + east, j + north) : 0.0;
    }
    return height;
  }
  bool IsCellValid(std::int64_t x, std::int64_t y) const
  {
    return std::isfinite(this->Twist(x, y));
  }
  float Twist(std::int64_t x, std::int64_t y) const
  {
    return this->At(x, y) + this->At(x + 1, y + 1) - this->At(x + 1, y) - this->At(x, y + 1);
  }
  std::int64_t ValidCells() const
  {
    std::int64_t count = 0;
    for (std::int64_t y = 0; y + 1 < this->Height; ++y)
    {
      for (std::int64_t x = 0; x + 1 < this->Width; ++x)
      {
        count += this->IsCellValid(x, y) ? 1 : 0;
      }
    }
    return count;
  }
};

/// Hills of several sizes with some noise.
inline Raster MakeHills(std::int64_t width, std::int64_t height, unsigned seed = 7)
{
  Raster raster{ width, height, {} };
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(-1.0f, 1.0f);
  for (std::int64_t y = 0; y < height; ++y)
  {
    for (std::int64_t x = 0; x < width; ++x)
    {
      const auto u = static_cast<float>(x);
      const auto v = static_cast<float>(y);
      raster.Heights.push_back(100.0f + 20.0f * std::sin(0.05f * u) * std::cos(0.07f * v) +
        4.0f * std::sin(0.31f * u + 0.2f * v) + 0.5f * noise(random));
    }
  }
  return raster;
}

inline Raster WithHoles(Raster raster, const std::string& pattern, unsigned seed = 3)
{
  std::mt19937 random(seed);
  for (std::int64_t y = 0; y < raster.Height; ++y)
  {
    for (std::int64_t x = 0; x < raster.Width; ++x)
    {
      const bool hole = pattern == "all" || (pattern == "speckles" && random() % 50 == 0) ||
        (pattern == "corner" && x + y < (raster.Width + raster.Height) / 4) ||
        (pattern == "lake" &&
          (x - raster.Width / 2) * (x - raster.Width / 2) +
              (y - raster.Height / 2) * (y - raster.Height / 2) <
            raster.Width * raster.Height / 16) ||
        (pattern == "single" && x == raster.Width / 3 && y == raster.Height / 2);
      if (hole)
      {
        raster.Heights[x + raster.Width * y] = None;
      }
    }
  }
  return raster;
}

inline terrain::HeightRows RowsOf(const Raster& raster)
{
  return [&raster](std::int64_t first, std::int64_t count, float* heights)
  {
    std::copy_n(raster.Heights.begin() + first * raster.Width, count * raster.Width, heights);
    return std::string();
  };
}

inline terrain::GridGeometry MakeGeometry(double dx = 3.0, double dy = 4.0)
{
  terrain::GridGeometry geometry;
  geometry.Origin = { 500000.0, 4000000.0, 0.0 };
  geometry.Spacing = { dx, dy };
  return geometry;
}

inline terrain::MemoryHierarchy Build(const Raster& raster,
  const terrain::GridGeometry& geometry = MakeGeometry(), bool keepsBorder = false)
{
  terrain::MemoryHierarchy hierarchy;
  const std::string error = terrain::BuildHierarchy(hierarchy, raster.Width, raster.Height,
    geometry, RowsOf(raster), terrain::SerialFor, {}, keepsBorder);
  return error.empty() ? std::move(hierarchy) : terrain::MemoryHierarchy();
}

/// An eye above the raster at a part of its size, 720 pixels of 30 degrees.
inline terrain::RefinementView MakeView(const Raster& raster, double u, double v, double above,
  const terrain::GridGeometry& geometry = MakeGeometry())
{
  terrain::RefinementView view;
  view.Eye = geometry.Origin +
    glm::dvec3(u * static_cast<double>(raster.Width) * geometry.Spacing.x,
      v * static_cast<double>(raster.Height) * geometry.Spacing.y, 100.0 + above);
  view.PixelsPerUnit = 720.0 / (2.0 * std::tan(0.2617993877991494));
  return view;
}

/// The triangles of a strip that are not degenerate, counter-clockwise as the strip winds them,
/// as indices of its vertices.
inline std::vector<std::array<std::uint32_t, 3>> IndexTriangles(const terrain::StripMesh& mesh)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 2; i < mesh.Strip.size(); ++i)
  {
    std::array<std::uint32_t, 3> t{ { mesh.Strip[i - 2], mesh.Strip[i - 1], mesh.Strip[i] } };
    if (i % 2 != 0)
    {
      std::swap(t[0], t[1]);
    }
    if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2])
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

inline Sample SampleOf(const terrain::StripMesh& mesh, std::uint32_t index)
{
  return { { mesh.Vertices[index].Column, mesh.Vertices[index].Row } };
}

inline std::vector<Triangle> Triangles(const terrain::StripMesh& mesh)
{
  std::vector<Triangle> triangles;
  for (const auto& t : IndexTriangles(mesh))
  {
    triangles.push_back({ { SampleOf(mesh, t[0]), SampleOf(mesh, t[1]), SampleOf(mesh, t[2]) } });
  }
  return triangles;
}

/// Twice the signed area, in cells.
inline std::int64_t Area2(const Triangle& t)
{
  return (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
}

/// The same triangle begun at its smallest corner, for comparing sets.
inline Triangle Rotated(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

inline std::set<Triangle> TriangleSet(const terrain::StripMesh& mesh)
{
  std::set<Triangle> set;
  for (const Triangle& t : Triangles(mesh))
  {
    set.insert(Rotated(t));
  }
  return set;
}

/// True if two vertices of the mesh are the same sample.
inline bool HasTwins(const terrain::StripMesh& mesh)
{
  std::set<Sample> samples;
  for (std::uint32_t i = 0; i < mesh.Vertices.size(); ++i)
  {
    samples.insert(SampleOf(mesh, i));
  }
  return samples.size() != mesh.Vertices.size();
}

/// Empty, or what is wrong with the mesh: a triangle turned round, an edge used twice the same way,
/// or a vertex of one triangle inside the edge of another.
inline std::string WhyNotConforming(const terrain::StripMesh& mesh)
{
  std::vector<std::array<Sample, 2>> edges;
  std::set<Sample> vertices;
  const std::vector<Triangle> triangles = Triangles(mesh);
  for (const Triangle& t : triangles)
  {
    if (Area2(t) <= 0)
    {
      return "a triangle is turned round or empty";
    }
    for (int i = 0; i < 3; ++i)
    {
      vertices.insert(t[i]);
      edges.push_back({ { t[i], t[(i + 1) % 3] } });
    }
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
  {
    return "an edge is used twice in the same direction";
  }
  if (static_cast<std::int64_t>(triangles.size()) != mesh.Triangles)
  {
    return "the number of triangles is " + std::to_string(triangles.size()) + ", not " +
      std::to_string(mesh.Triangles);
  }
  for (const auto& edge : edges)
  {
    const std::int64_t dx = edge[1][0] - edge[0][0];
    const std::int64_t dy = edge[1][1] - edge[0][1];
    const std::int64_t steps = std::gcd(dx, dy);
    for (std::int64_t i = 1; i < steps; ++i)
    {
      if (vertices.count({ { edge[0][0] + i * dx / steps, edge[0][1] + i * dy / steps } }) != 0)
      {
        return "a vertex lies inside an edge";
      }
    }
  }
  return std::string();
}

inline terrain::RefinementOptions WithTolerance(double tolerance)
{
  terrain::RefinementOptions options;
  options.Tolerance = tolerance;
  return options;
}

/// Refines a raster between two planes through the eye, in six directions and with both cullings.
/// Empty, or what is wrong: nothing was culled, the mesh does not conform, or a triangle of the
/// whole mesh with a corner inside both planes is missing. refine(view, options) makes a mesh of
/// the raster, whose cells have the geometry.
template <typename Refine>
std::string WhyCullingLoses(const Raster& raster, const terrain::GridGeometry& geometry,
  terrain::RefinementView view, const Refine& refine)
{
  terrain::RefinementOptions options = WithTolerance(2.0);
  options.Culling = terrain::CullingMethod::None;
  const std::set<Triangle> whole = TriangleSet(refine(view, options));
  for (int turn = 0; turn < 6; ++turn)
  {
    const double angle = 1.0471975511965976 * turn;
    const glm::dvec3 left(std::cos(angle), std::sin(angle), 0.0);
    const glm::dvec3 right(-std::sin(angle), std::cos(angle), 0.1);
    view.Planes = { glm::dvec4(left, -glm::dot(left, view.Eye)),
      glm::dvec4(right, -glm::dot(right, view.Eye)) };
    const auto isSeen = [&](const Sample& sample)
    {
      const glm::dvec3 way =
        geometry.ToModel(glm::dvec2(sample[0], sample[1]), raster.At(sample[0], sample[1])) -
        view.Eye;
      return glm::dot(left, way) > 0.0 && glm::dot(right, way) > 0.0;
    };
    for (const auto culling : { terrain::CullingMethod::Nested, terrain::CullingMethod::Lazy })
    {
      options.Culling = culling;
      const terrain::StripMesh mesh = refine(view, options);
      const std::set<Triangle> kept = TriangleSet(mesh);
      const bool isLost = std::any_of(whole.begin(), whole.end(),
        [&](const Triangle& t)
        { return kept.count(t) == 0 && std::any_of(t.begin(), t.end(), isSeen); });
      if (isLost)
      {
        return "a triangle that is seen is lost in direction " + std::to_string(turn);
      }
      if (kept.size() >= whole.size())
      {
        return "nothing is culled in direction " + std::to_string(turn);
      }
      const std::string flaw = WhyNotConforming(mesh);
      if (!flaw.empty())
      {
        return flaw;
      }
    }
  }
  return std::string();
}

/// Height of the triangle's plane at (x, y) in cells, with heights of a mesh's vertices.
inline double PlaneAt(const Triangle& t, const std::array<double, 3>& heights, double x, double y)
{
  const auto area = static_cast<double>(Area2(t));
  const auto weight = [&](int i)
  {
    const Sample& a = t[(i + 1) % 3];
    const Sample& b = t[(i + 2) % 3];
    return ((static_cast<double>(a[0]) - x) * (static_cast<double>(b[1]) - y) -
             (static_cast<double>(a[1]) - y) * (static_cast<double>(b[0]) - x)) /
      area;
  };
  return weight(0) * heights[0] + weight(1) * heights[1] + weight(2) * heights[2];
}

/// A triangle of a mesh, and the heights of its corners.
struct Drawn
{
  Triangle Corners;
  std::array<double, 3> Heights{};
};

inline Drawn DrawnOf(const terrain::StripMesh& mesh, const std::array<std::uint32_t, 3>& indices)
{
  Drawn drawn;
  for (int i = 0; i < 3; ++i)
  {
    const terrain::StripVertex& vertex = mesh.Vertices[indices[i]];
    drawn.Corners[i] = { { vertex.Column, vertex.Row } };
    drawn.Heights[i] = static_cast<double>(vertex.Height) + vertex.Displacement;
  }
  return drawn;
}

/// Over a grid of points finer than the samples.
struct ErrorOfTriangle
{
  double Height = 0.0;                                      ///< largest vertical distance
  double Nearest = std::numeric_limits<double>::infinity(); ///< the surface's distance to the eye
};

inline ErrorOfTriangle FindError(const Raster& raster, const glm::dvec3& eye, const Drawn& drawn)
{
  const Triangle& t = drawn.Corners;
  const std::array<double, 3>& heights = drawn.Heights;
  const terrain::GridGeometry geometry = MakeGeometry();
  const auto [west, east] = std::minmax({ t[0][0], t[1][0], t[2][0] });
  const auto [south, north] = std::minmax({ t[0][1], t[1][1], t[2][1] });
  ErrorOfTriangle error;
  for (std::int64_t y2 = 2 * south; y2 <= 2 * north; ++y2)
  {
    for (std::int64_t x2 = 2 * west; x2 <= 2 * east; ++x2)
    {
      const double x = 0.5 * static_cast<double>(x2);
      const double y = 0.5 * static_cast<double>(y2);
      bool inside = true;
      for (int i = 0; i < 3; ++i)
      {
        std::array<double, 3> one{ { 0.0, 0.0, 0.0 } };
        one[i] = 1.0;
        inside = inside && PlaneAt(t, one, x, y) >= -1e-12;
      }
      if (!inside)
      {
        continue;
      }
      const std::int64_t i = std::min<std::int64_t>(x2 / 2, raster.Width - 2);
      const std::int64_t j = std::min<std::int64_t>(y2 / 2, raster.Height - 2);
      const double u = x - static_cast<double>(i);
      const double v = y - static_cast<double>(j);
      const double h = (1 - u) * (1 - v) * raster.At(i, j) + u * (1 - v) * raster.At(i + 1, j) +
        (1 - u) * v * raster.At(i, j + 1) + u * v * raster.At(i + 1, j + 1);
      error.Height = std::max(error.Height, std::abs(h - PlaneAt(t, heights, x, y)));
      error.Nearest = std::min(error.Nearest, glm::distance(eye, geometry.ToModel({ x, y }, h)));
    }
  }
  return error;
}
}

#endif
