// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights for lanes: a copy in rows with a margin of NaN all around, so that lanes which have left
 * the grid read what counts for nothing.
 */
#ifndef terrain_PaddedGrid_h
#define terrain_PaddedGrid_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace terrain
{
/// Real is float or double; samples without data are NaN.
template <typename Real>
struct PaddedGrid
{
  /// Samples of the margin beside every row; there is one row of margin below and above.
  static constexpr std::int64_t Margin = 48;

  std::int64_t Width = 0;
  std::int64_t Height = 0;
  /// Samples from one row to the next.
  std::int64_t Stride = 0;
  std::vector<Real> Samples;

  /// read writes the heights of a row, NaN for no data. It is called from many threads.
  PaddedGrid(std::int64_t width, std::int64_t height,
    const std::function<void(std::int64_t row, double* heights)>& read,
    const ParallelFor& parallelFor)
    : Width(width)
    , Height(height)
    , Stride((width + Margin + 15) / 16 * 16)
    , Samples(static_cast<std::size_t>(Margin + this->Stride * (height + 2)),
        std::numeric_limits<Real>::quiet_NaN())
  {
    parallelFor(height,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::vector<double> heights(static_cast<std::size_t>(width));
        for (std::int64_t row = begin; row < end; ++row)
        {
          read(row, heights.data());
          Real* to = this->Samples.data() + this->Index(0, row);
          for (std::int64_t i = 0; i < width; ++i)
          {
            to[i] = static_cast<Real>(heights[static_cast<std::size_t>(i)]);
          }
        }
      });
  }

  std::int64_t Index(std::int64_t i, std::int64_t j) const
  {
    return Margin + i + this->Stride * (j + 1);
  }
  const Real* At(std::int64_t i, std::int64_t j) const
  {
    return this->Samples.data() + this->Index(i, j);
  }
  /// All of it as one heightfield, whose sample (Margin, 1) is the grid's (0, 0).
  HeightfieldView<Real> WithMargin() const
  {
    HeightfieldView<Real> view;
    view.Samples = this->Samples.data();
    view.Width = this->Stride;
    view.Height = this->Height + 2;
    return view;
  }
};
}

#endif
