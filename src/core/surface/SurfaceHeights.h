// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The heights of a surface and their bounds, whatever type the samples have and wherever they come
 * from. Heights are doubles in height units, positions are in GC (core/grid/Coordinates.h).
 */
#ifndef terrain_SurfaceHeights_h
#define terrain_SurfaceHeights_h

#include "core/grid/Constants.h"
#include "core/grid/HeightCodes.h"
#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"
#include "core/surface/BlockBounds.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace terrain
{
/// Lowest and highest height of a part of a surface, in height units; Low > High if it has none.
struct HeightBounds
{
  double Low = kInfinity;
  double High = -kInfinity;

  bool IsEmpty() const
  {
    return this->Low > this->High;
  }
};

/**
 * The heights of one grid. Implementations are immutable: all methods may be called from many
 * threads at once.
 */
class SurfaceHeights
{
public:
  SurfaceHeights() = default;
  virtual ~SurfaceHeights() = default;
  SurfaceHeights(const SurfaceHeights&) = delete;
  SurfaceHeights& operator=(const SurfaceHeights&) = delete;

  /// Number of cells east and north; 0 or less in a direction if there is no surface.
  virtual glm::i64vec2 CellCount() const = 0;

  /// Height of a sample, NaN if it has none; 0 <= sample <= CellCount().
  virtual double SampleHeight(const glm::i64vec2& sample) const = 0;

  /// Heights of the south-west, south-east, north-west and north-east corner of a cell; one of
  /// them is NaN if and only if the cell has no surface. 0 <= cell < CellCount().
  virtual glm::dvec4 CellHeights(const glm::i64vec2& cell) const
  {
    return { this->SampleHeight(cell), this->SampleHeight(cell + glm::i64vec2(1, 0)),
      this->SampleHeight(cell + glm::i64vec2(0, 1)),
      this->SampleHeight(cell + glm::i64vec2(1, 1)) };
  }

  ///@{
  /// The levels of the pyramid that NodeBounds() knows, FirstLevel() >= 1. The only node of the
  /// last level covers the grid. LastLevel() < FirstLevel() if there is no surface.
  virtual int FirstLevel() const = 0;
  virtual int LastLevel() const = 0;
  ///@}

  /// Bounds of the surface over the cells node 2^level <= cell < (node + 1) 2^level. Conservative:
  /// no height of the surface is outside. 0 <= node < ceil(CellCount() / 2^level).
  virtual HeightBounds NodeBounds(const glm::i64vec2& node, int level) const = 0;

  /// Bounds of the whole surface.
  HeightBounds Bounds() const
  {
    const int last = this->LastLevel();
    return last < this->FirstLevel() ? HeightBounds{} : this->NodeBounds({ 0, 0 }, last);
  }
};

/// True if a cell of these corners has a surface.
inline bool HasSurface(const glm::dvec4& corners)
{
  return !std::isnan(corners.x + corners.y + corners.z + corners.w);
}

/// Height of the bilinear patch of a cell at 0 <= fraction <= 1. At a side of the cell it depends
/// on the samples of that side alone, so that both cells that share it have the same height there.
inline double PatchHeight(const glm::dvec4& corners, const glm::dvec2& fraction)
{
  const double south = corners.x * (1.0 - fraction.x) + corners.y * fraction.x;
  const double north = corners.z * (1.0 - fraction.x) + corners.w * fraction.x;
  return south * (1.0 - fraction.y) + north * fraction.y;
}

/// Change of the height per cell east and north at 0 <= fraction <= 1 of a cell.
inline glm::dvec2 PatchSlopes(const glm::dvec4& corners, const glm::dvec2& fraction)
{
  return { (1.0 - fraction.y) * (corners.y - corners.x) + fraction.y * (corners.w - corners.z),
    (1.0 - fraction.x) * (corners.z - corners.x) + fraction.x * (corners.w - corners.y) };
}

/**
 * Heights in memory: a view of samples, which must outlive this object and must not change, and
 * bounds of its own. Samples are heights, or the texels of codes (core/grid/HeightCodes.h).
 */
template <typename T>
class SampledHeights final : public SurfaceHeights
{
public:
  /// Reads all samples once, for the bounds.
  SampledHeights(
    const HeightfieldView<T>& view, const ParallelFor& parallelFor, const HeightCodes& codes = {})
    : View(view)
    , Codes(codes)
  {
    this->Blocks.Build(view, parallelFor);
  }

  glm::i64vec2 CellCount() const override
  {
    return { this->View.Width - 1, this->View.Height - 1 };
  }
  double SampleHeight(const glm::i64vec2& sample) const override
  {
    return this->ToHeight(this->View.At(sample.x, sample.y));
  }
  glm::dvec4 CellHeights(const glm::i64vec2& cell) const override
  {
    const auto at = [&](std::int64_t east, std::int64_t north)
    { return this->ToHeight(this->View.At(cell.x + east, cell.y + north)); };
    return { at(0, 0), at(1, 0), at(0, 1), at(1, 1) };
  }
  int FirstLevel() const override
  {
    return BlockBounds<T>::FirstLevel;
  }
  int LastLevel() const override
  {
    return this->Blocks.LastLevel();
  }
  HeightBounds NodeBounds(const glm::i64vec2& node, int level) const override
  {
    const BlockNode<T>& block = this->Blocks.At(node, level);
    return block.IsEmpty() ? HeightBounds{}
                           : HeightBounds{ this->ToHeight(static_cast<double>(block.Low)),
                               this->ToHeight(static_cast<double>(block.High)) };
  }

private:
  double ToHeight(double sample) const
  {
    return this->Codes.ToHeight(sample - this->Codes.Bias);
  }

  HeightfieldView<T> View;
  HeightCodes Codes;
  BlockBounds<T> Blocks;
};
}

#endif
