// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What meshes must know of all samples before they begin.
 */
#ifndef terrain_HeightExtremes_h
#define terrain_HeightExtremes_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>

namespace terrain
{
/// Extremes of a heightfield, in height units.
struct HeightExtremes
{
  /// Largest magnitude of a height.
  double Height = 0.0;
  /// Largest difference of neighbouring heights east and north.
  glm::dvec2 Step{ 0.0, 0.0 };
  /// Whether all samples have heights.
  bool IsComplete = true;

  void Add(const HeightExtremes& other)
  {
    this->Height = glm::max(this->Height, other.Height);
    this->Step = glm::max(this->Step, other.Step);
    this->IsComplete = this->IsComplete && other.IsComplete;
  }
};

/// Extremes of row j.
template <typename T>
HeightExtremes FindExtremesOfRow(const HeightfieldView<T>& view, std::int64_t j)
{
  const auto largest = [](double a, double b) { return b > a ? b : a; }; // a where b is NaN
  HeightExtremes extremes;
  double west = std::numeric_limits<double>::quiet_NaN();
  for (std::int64_t i = 0; i < view.Width; ++i)
  {
    const double height = view.At(i, j);
    extremes.IsComplete = extremes.IsComplete && height == height;
    extremes.Height = largest(extremes.Height, std::abs(height));
    extremes.Step.x = largest(extremes.Step.x, std::abs(height - west));
    if (j + 1 < view.Height)
    {
      extremes.Step.y = largest(extremes.Step.y, std::abs(view.At(i, j + 1) - height));
    }
    west = height;
  }
  return extremes;
}

template <typename T>
HeightExtremes FindHeightExtremes(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
{
  HeightExtremes extremes;
  std::mutex mutex;
  parallelFor(view.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      HeightExtremes ofRange;
      for (std::int64_t j = begin; j < end; ++j)
      {
        ofRange.Add(FindExtremesOfRow(view, j));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      extremes.Add(ofRange);
    });
  return extremes;
}
}

#endif
