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
#include "core/grid/LargeArray.h"
#include "core/grid/ParallelFor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace terrain
{
/// Writes the heights of a row, in height units, NaN for no data. It is called from many threads.
using RowReader = std::function<void(std::int64_t row, double* heights)>;

/// Reads the rows of a view, which must live on.
template <typename T>
RowReader ReadRows(const HeightfieldView<T>& view)
{
  return [&view](std::int64_t row, double* heights)
  {
    for (std::int64_t i = 0; i < view.Width; ++i)
    {
      heights[i] = view.At(i, row);
    }
  };
}

/// Real is float or double; samples without data are NaN.
template <typename Real>
struct PaddedGrid
{
  /// Samples of the margin beside every row; there is one row of margin below and above.
  static constexpr std::int64_t Margin = 48;

  std::int64_t Width;
  std::int64_t Height;
  /// Samples from one row to the next.
  std::int64_t Stride;
  /// Memory is taken, page by page, by the threads that fill it.
  LargeArray<Real> Samples;

  PaddedGrid(
    std::int64_t width, std::int64_t height, const RowReader& read, const ParallelFor& parallelFor)
    : PaddedGrid(width, height)
  {
    parallelFor(height,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::vector<double> heights(static_cast<std::size_t>(width));
        for (std::int64_t row = begin; row < end; ++row)
        {
          read(row, heights.data());
          Real* to = this->To(row);
          for (std::int64_t i = 0; i < width; ++i)
          {
            to[i] = static_cast<Real>(heights[static_cast<std::size_t>(i)]);
          }
        }
      });
  }

  /// The grid transposed: its sample (i, j) is sample (j, i) here.
  PaddedGrid Transposed(const ParallelFor& parallelFor) const
  {
    PaddedGrid turned(this->Height, this->Width);
    parallelFor((this->Width + Turned - 1) / Turned,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin * Turned; i < std::min(end * Turned, this->Width); i += Turned)
        {
          for (std::int64_t j = 0; j < this->Height; j += Turned)
          {
            this->TransposeBlock(i, j, turned);
          }
        }
      });
    return turned;
  }

  std::int64_t Index(std::int64_t i, std::int64_t j) const
  {
    return Margin + i + this->Stride * (j + 1);
  }
  const Real* At(std::int64_t i, std::int64_t j) const
  {
    return this->Samples.get() + this->Index(i, j);
  }
  /// All of it as one heightfield, whose sample (Margin, 1) is the grid's (0, 0).
  HeightfieldView<Real> WithMargin() const
  {
    HeightfieldView<Real> view;
    view.Samples = this->Samples.get();
    view.Width = this->Stride;
    view.Height = this->Height + 2;
    return view;
  }

private:
  /// Samples along a side of the blocks that are transposed, so that both grids are read and
  /// written in lines of memory.
  static constexpr std::int64_t Turned = 16;

  /// Only the margin is filled.
  PaddedGrid(std::int64_t width, std::int64_t height)
    : Width(width)
    , Height(height)
    , Stride((width + Margin + 15) / 16 * 16)
    , Samples(MakeLargeArray<Real>(static_cast<std::size_t>(Margin + this->Stride * (height + 2))))
  {
    const Real none = std::numeric_limits<Real>::quiet_NaN();
    std::fill(this->Samples.get(), this->To(0), none);
    for (std::int64_t row = 0; row < height; ++row)
    {
      std::fill(this->To(row) + width, this->To(row + 1), none);
    }
    std::fill(this->To(height), this->To(height) - Margin + this->Stride, none);
  }

  Real* To(std::int64_t row)
  {
    return this->Samples.get() + this->Index(0, row);
  }

  void TransposeBlock(std::int64_t i, std::int64_t j, PaddedGrid& turned) const
  {
    const std::int64_t rows = std::min(Turned, this->Height - j);
    for (std::int64_t k = i; k < std::min(i + Turned, this->Width); ++k)
    {
      const Real* from = this->At(k, j);
      Real* to = turned.To(k) + j;
      for (std::int64_t row = 0; row < rows; ++row)
      {
        to[row] = from[row * this->Stride];
      }
    }
  }
};
}

#endif
