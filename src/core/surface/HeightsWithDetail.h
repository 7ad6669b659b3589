// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The heights of a surface with detail in double precision. The sum is the one that
 * core/surface/DetailHeights.h describes for graphics cards:
 *
 *   z(x, y) = base(x, y) + scale * detail(2^level x mod period, 2^level y mod period)
 *
 * A cell of the sum is a cell of the detail; the sum is bilinear on each of them.
 */
#ifndef terrain_HeightsWithDetail_h
#define terrain_HeightsWithDetail_h

#include "core/surface/SurfaceHeights.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace terrain
{
/// One period of detail with its bounds. Immutable.
class DetailPeriod
{
public:
  /// Copies the samples of a view, of which every one must have a height; at least 1 x 1.
  template <typename T>
  explicit DetailPeriod(const HeightfieldView<T>& view)
    : Size(view.Width, view.Height)
  {
    // The first column and row stand once more behind the last ones: all cells are there.
    for (std::int64_t j = 0; j <= view.Height; ++j)
    {
      for (std::int64_t i = 0; i <= view.Width; ++i)
      {
        this->Samples.push_back(view.At(i % view.Width, j % view.Height));
      }
    }
    HeightfieldView<double> wrapped;
    wrapped.Samples = this->Samples.data();
    wrapped.Width = view.Width + 1;
    wrapped.Height = view.Height + 1;
    this->Blocks.Build(wrapped, SerialFor);
    while ((((view.Width | view.Height) >> this->WholeLevel) & 1) == 0)
    {
      ++this->WholeLevel;
    }
  }
  DetailPeriod(const DetailPeriod&) = delete;
  DetailPeriod& operator=(const DetailPeriod&) = delete;

  /// Height of a sample of the repeated detail; sample >= 0.
  double SampleHeight(const glm::i64vec2& sample) const
  {
    const glm::i64vec2 at = sample % this->Size;
    return this->Samples[static_cast<std::size_t>(at.x + (this->Size.x + 1) * at.y)];
  }

  /// Bounds of a node of the repeated detail; level >= BlockBounds::FirstLevel. They are those of
  /// the whole period where it is no whole number of nodes.
  HeightBounds NodeBounds(const glm::i64vec2& node, int level) const
  {
    const bool whole = level <= this->WholeLevel && level <= this->Blocks.LastLevel();
    const glm::i64vec2 nodes(this->Size.x >> level, this->Size.y >> level);
    const BlockNode<double>& bounds = whole ? this->Blocks.At(node % nodes, level)
                                            : this->Blocks.At({ 0, 0 }, this->Blocks.LastLevel());
    return { bounds.Low, bounds.High };
  }

private:
  glm::i64vec2 Size;
  std::vector<double> Samples;
  BlockBounds<double> Blocks;
  /// The highest level of which a whole number of nodes makes the period.
  int WholeLevel = 0;
};

/// A base with detail: 2^level detail cells along a cell of the base, level >= 0, scale >= 0.
class HeightsWithDetail final : public SurfaceHeights
{
public:
  HeightsWithDetail(std::shared_ptr<const SurfaceHeights> base,
    std::shared_ptr<const DetailPeriod> detail, int level, double scale)
    : Base(std::move(base))
    , Detail(std::move(detail))
    , Level(level)
    , Scale(scale)
  {
  }

  glm::i64vec2 CellCount() const override
  {
    return this->Base->CellCount() * (std::int64_t{ 1 } << this->Level);
  }
  double SampleHeight(const glm::i64vec2& sample) const override
  {
    const glm::i64vec2 last = this->CellCount() - std::int64_t{ 1 };
    const glm::i64vec2 cell = glm::min(sample, last);
    const glm::i64vec2 at = sample - cell;
    return this->CellHeights(cell)[static_cast<int>(at.x + 2 * at.y)];
  }
  glm::dvec4 CellHeights(const glm::i64vec2& cell) const override
  {
    const auto detail = [&](std::int64_t east, std::int64_t north)
    { return this->Scale * this->Detail->SampleHeight(cell + glm::i64vec2(east, north)); };
    return this->PartHeights(cell, this->Level) +
      glm::dvec4(detail(0, 0), detail(1, 0), detail(0, 1), detail(1, 1));
  }
  int FirstLevel() const override
  {
    return BlockBounds<double>::FirstLevel;
  }
  int LastLevel() const override
  {
    return this->Base->LastLevel() < this->Base->FirstLevel()
      ? this->FirstLevel() - 1
      : std::max(this->Base->LastLevel() + this->Level, this->FirstLevel());
  }
  HeightBounds NodeBounds(const glm::i64vec2& node, int level) const override
  {
    const HeightBounds base = this->BaseBounds(node, level - this->Level);
    const HeightBounds add = this->Detail->NodeBounds(node, level);
    return base.IsEmpty()
      ? base
      : HeightBounds{ base.Low + this->Scale * add.Low, base.High + this->Scale * add.High };
  }

private:
  /// Heights of the base at the corners of part (x, y) of 2^parts x 2^parts parts of a cell.
  glm::dvec4 PartHeights(const glm::i64vec2& part, int parts) const
  {
    const glm::i64vec2 cell(part.x >> parts, part.y >> parts);
    const glm::dvec4 corners = this->Base->CellHeights(cell);
    const double width = 1.0 / static_cast<double>(std::int64_t{ 1 } << parts);
    const glm::i64vec2 first(cell.x << parts, cell.y << parts);
    const glm::dvec2 low = glm::dvec2(part - first) * width;
    const glm::dvec2 high = low + width;
    return { PatchHeight(corners, low), PatchHeight(corners, { high.x, low.y }),
      PatchHeight(corners, { low.x, high.y }), PatchHeight(corners, high) };
  }

  /// Bounds of the base over a node, of 2^above x 2^above cells of the base or of a part of one.
  HeightBounds BaseBounds(const glm::i64vec2& node, int above) const
  {
    const int first = this->Base->FirstLevel();
    if (above > 0)
    {
      const int up = std::max(first - above, 0);
      return this->Base->NodeBounds({ node.x >> up, node.y >> up }, above + up);
    }
    const glm::i64vec2 last(
      this->Base->CellCount() * (std::int64_t{ 1 } << -above) - std::int64_t{ 1 });
    const glm::dvec4 corners = this->PartHeights(glm::min(node, last), -above);
    return HasSurface(corners)
      ? HeightBounds{ std::min(std::min(corners.x, corners.y), std::min(corners.z, corners.w)),
          std::max(std::max(corners.x, corners.y), std::max(corners.z, corners.w)) }
      : HeightBounds{};
  }

  std::shared_ptr<const SurfaceHeights> Base;
  std::shared_ptr<const DetailPeriod> Detail;
  int Level;
  double Scale;
};
}

#endif
