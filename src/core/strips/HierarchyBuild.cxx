// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyBuild.h"

#include "core/strips/HierarchyBands.h"
#include "core/strips/HierarchyNesting.h"

#include <cmath>
#include <exception>
#include <limits>
#include <new>

namespace terrain
{
const char* const kBuildAborted = "stopped on request";

namespace
{
/// Part of the work that the first pass is.
constexpr double kBandShare = 0.8;

/// Gives the samples of the border an error that is above all others, and yet a known one.
void KeepBorder(HierarchyTarget& target)
{
  const HierarchyLayout& layout = *target.Layout;
  const auto keep = [&](std::int64_t x, std::int64_t y)
  {
    const int pair = layout.PairOf(x, y);
    if (pair >= 0)
    {
      const int shift = layout.Shift(pair);
      target.Records[layout.Index(pair, x >> shift, y >> shift)].SetError(
        0.5f * std::numeric_limits<float>::max());
    }
  };
  for (std::int64_t x = 0; x < layout.Width(); ++x)
  {
    keep(x, 0);
    keep(x, layout.Height() - 1);
  }
  for (std::int64_t y = 0; y < layout.Height(); ++y)
  {
    keep(0, y);
    keep(layout.Width() - 1, y);
  }
}
}

std::string BuildHierarchy(HierarchyTarget& target, const HeightRows& rows,
  const ParallelFor& parallelFor, const BuildProgress& progress)
{
  const HierarchyLayout& layout = *target.Layout;
  const glm::dvec2 spacing = target.Geometry.Spacing;
  if (!(spacing.x > 0.0) || !(spacing.y > 0.0) || !std::isfinite(spacing.x) ||
    !std::isfinite(spacing.y))
  {
    return "the spacing of the samples must be positive, not " + std::to_string(spacing.x) + " x " +
      std::to_string(spacing.y);
  }
  const auto goOn = [&progress](double part) { return !progress || progress(part); };
  target.Summary = HierarchySummary();
  target.Summary.HasHoles =
    layout.Width() - 1 != layout.Cells() || layout.Height() - 1 != layout.Cells();
  HierarchyBands bands(target, rows, parallelFor);
  for (std::int64_t band = bands.Count() - 1; band >= 0; --band)
  {
    std::string error = bands.Process(band);
    if (!error.empty())
    {
      return error;
    }
    const double done = static_cast<double>(bands.Count() - band);
    if (!goOn(kBandShare * done / static_cast<double>(bands.Count())))
    {
      return kBuildAborted;
    }
  }
  bands.Finish();
  if (target.KeepsBorder)
  {
    KeepBorder(target);
  }
  double left = 1.0 - kBandShare;
  for (int depth = layout.Depths() - 2; depth >= 0; --depth)
  {
    NestDepth(target, depth, parallelFor);
    left *= 0.5;
    if (!goOn(1.0 - left))
    {
      return kBuildAborted;
    }
  }
  goOn(1.0);
  return {};
}

std::string BuildHierarchy(MemoryHierarchy& hierarchy, std::int64_t width, std::int64_t height,
  const GridGeometry& geometry, const HeightRows& rows, const ParallelFor& parallelFor,
  const BuildProgress& progress, bool keepsBorder)
{
  try
  {
    hierarchy.Layout = HierarchyLayout(width, height);
    hierarchy.Geometry = geometry;
    hierarchy.Geometry.Exaggeration = 1.0;
    const auto count = static_cast<std::size_t>(hierarchy.Layout.RecordCount());
    hierarchy.Records.assign(count, HierarchyRecord());
    hierarchy.Gradients.assign(count, HierarchyGradient());
  }
  catch (const std::bad_alloc&)
  {
    return "not enough memory for the hierarchy";
  }
  HierarchyTarget target;
  target.Layout = &hierarchy.Layout;
  target.Geometry = hierarchy.Geometry;
  target.Records = hierarchy.Records.data();
  target.Gradients = hierarchy.Gradients.data();
  target.KeepsBorder = keepsBorder;
  std::string error = BuildHierarchy(target, rows, parallelFor, progress);
  hierarchy.Summary = target.Summary;
  return error;
}
}
