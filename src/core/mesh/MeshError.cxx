// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/MeshError.h"

#include "core/grid/SampleTypes.h"
#include "core/mesh/HeightExtremes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

namespace terrain
{
namespace
{
/// Half a step between numbers of 32 bits of that size.
double HalfStep(double value)
{
  const auto size = static_cast<float>(std::abs(value));
  return 0.5 * (std::nextafter(size, std::numeric_limits<float>::infinity()) - size);
}

/// The nearest number of 32 bits. Not inlined: the vectors of two that GCC 12 makes with -O3 leave
/// out a rounding that is taken back to 64 bits at once.
[[gnu::noinline]] float ToSingle(double value)
{
  return static_cast<float>(value);
}

/// Where vertices stand, in grid coordinates with heights: on their samples, or where 32 bits of
/// model coordinates put them.
class VertexPlaces
{
public:
  VertexPlaces(std::int64_t width, std::int64_t height, const GridGeometry* rounded)
    : Rounded(rounded)
  {
    const std::int64_t count = rounded ? std::max(width, height) : 0;
    for (std::int64_t k = 0; k < count; ++k)
    {
      const glm::dvec3 place = this->Round({ k, k }, 0.0);
      this->Columns.push_back(place.x);
      this->Rows.push_back(place.y);
    }
  }

  glm::dvec3 Of(const glm::ivec2& sample, double height) const
  {
    return this->Rounded
      ? glm::dvec3(this->Columns[sample.x], this->Rows[sample.y], this->RoundHeight(height))
      : glm::dvec3(sample, height);
  }

private:
  double RoundHeight(double height) const
  {
    const double z = ToSingle(this->Rounded->ToModel({ 0.0, 0.0 }, height).z);
    return this->Rounded->RiseToHeights(z - this->Rounded->Origin.z);
  }

  glm::dvec3 Round(const glm::dvec2& position, double height) const
  {
    const glm::dvec3 exact = this->Rounded->ToModel(position, height);
    return this->Rounded->ToGrid({ ToSingle(exact.x), ToSingle(exact.y), ToSingle(exact.z) });
  }

  const GridGeometry* Rounded;
  std::vector<double> Columns; ///< x of each column
  std::vector<double> Rows;    ///< y of each row
};

/// Twice the area of the triangle between two points and a position, on whose left it is if > 0.
template <typename Point, typename Position>
auto Cross(const Point& from, const Point& to, const Position& p)
{
  return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

/// Largest vertical distance of the samples on a triangle, whose samples are marked as covered.
template <typename T>
double CompareTriangle(const HeightfieldView<T>& view, const glm::ivec2* corners,
  const VertexPlaces& places, std::vector<std::atomic<bool>>& covered)
{
  const glm::ivec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const glm::ivec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  glm::i64vec2 samples[3]; // all relative to the box, for precision
  glm::dvec3 points[3];
  for (int k = 0; k < 3; ++k)
  {
    samples[k] = corners[k] - low;
    points[k] = places.Of(corners[k], view.At(corners[k].x, corners[k].y));
    points[k] -= glm::dvec3(low, 0.0);
  }
  const double area = Cross(points[0], points[1], points[2]);
  double largest = 0.0;
  glm::i64vec2 at(0, 0);
  for (at.y = 0; at.y <= high.y - low.y; ++at.y)
  {
    for (at.x = 0; at.x <= high.x - low.x; ++at.x)
    {
      if (Cross(samples[1], samples[2], at) < 0 || Cross(samples[2], samples[0], at) < 0 ||
        Cross(samples[0], samples[1], at) < 0)
      {
        continue;
      }
      const glm::dvec2 p(at);
      const double onPlane = (Cross(points[1], points[2], p) * points[0].z +
                               Cross(points[2], points[0], p) * points[1].z +
                               Cross(points[0], points[1], p) * points[2].z) /
        area;
      const std::int64_t x = low.x + at.x;
      const std::int64_t y = low.y + at.y;
      covered[x + view.Width * y].store(true, std::memory_order_relaxed);
      largest = std::max(largest, std::abs(onPlane - view.At(x, y)));
    }
  }
  return largest;
}

/// True if the sample belongs to a cell with a surface.
template <typename T>
bool HasCell(const HeightfieldView<T>& view, std::int64_t i, std::int64_t j)
{
  for (std::int64_t y = std::max<std::int64_t>(j - 1, 0); y <= j && y < view.Height - 1; ++y)
  {
    for (std::int64_t x = std::max<std::int64_t>(i - 1, 0); x <= i && x < view.Width - 1; ++x)
    {
      if (view.IsCellValid(x, y))
      {
        return true;
      }
    }
  }
  return false;
}

template <typename T>
bool IsCovered(const HeightfieldView<T>& view, const std::vector<std::atomic<bool>>& covered,
  const ParallelFor& parallelFor)
{
  std::atomic<bool> result{ true };
  parallelFor(view.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = view.Width * begin; k < view.Width * end; ++k)
      {
        if (!covered[k].load(std::memory_order_relaxed) &&
          HasCell(view, k % view.Width, k / view.Width))
        {
          result = false;
          return;
        }
      }
    });
  return result;
}
}

//--------------------------------------------------------------------------------------------------
template <typename T>
double FindMeshError(const HeightfieldView<T>& view, const GridMesh& mesh,
  const ParallelFor& parallelFor, const GridGeometry* rounded)
{
  std::vector<std::atomic<bool>> covered(view.Width * view.Height);
  const VertexPlaces places(view.Width, view.Height, rounded);
  std::mutex mutex;
  double largest = 0.0;
  parallelFor(static_cast<std::int64_t>(mesh.Triangles.size() / 3),
    [&](std::int64_t begin, std::int64_t end)
    {
      double ofRange = 0.0;
      for (std::int64_t k = 3 * begin; k < 3 * end; k += 3)
      {
        const glm::ivec2 corners[3] = { mesh.Vertices[mesh.Triangles[k]],
          mesh.Vertices[mesh.Triangles[k + 1]], mesh.Vertices[mesh.Triangles[k + 2]] };
        ofRange = std::max(ofRange, CompareTriangle(view, corners, places, covered));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      largest = std::max(largest, ofRange);
    });
  return IsCovered(view, covered, parallelFor) ? largest : std::numeric_limits<double>::infinity();
}

//--------------------------------------------------------------------------------------------------
template <typename T>
glm::dvec3 FindRoundingMargin(
  const HeightfieldView<T>& view, const GridGeometry& geometry, const ParallelFor& parallelFor)
{
  const HeightExtremes extremes = FindHeightExtremes(view, parallelFor);
  const glm::dvec3 first = glm::abs(geometry.ToModel({ 0.0, 0.0 }, extremes.Height));
  const glm::dvec3 last =
    glm::abs(geometry.ToModel({ view.Width - 1, view.Height - 1 }, -extremes.Height));
  const glm::dvec3 size = glm::max(first, last);
  const glm::dvec2 moved(
    HalfStep(size.x) / geometry.Spacing.x, HalfStep(size.y) / geometry.Spacing.y);
  return { moved, geometry.RiseToHeights(HalfStep(size.z)) + glm::dot(extremes.Step, moved) };
}

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template double FindMeshError(                                                                   \
    const HeightfieldView<T>&, const GridMesh&, const ParallelFor&, const GridGeometry*);          \
  template glm::dvec3 FindRoundingMargin(                                                          \
    const HeightfieldView<T>&, const GridGeometry&, const ParallelFor&);
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
