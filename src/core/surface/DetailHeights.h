// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A heightfield with detail: the sum of a base and of a small field that is repeated all over it,
 * read as if it were one large heightfield, which is never made. Twin of the parts of
 * shaders/vtkTerrainHeights.glsl and vtkTerrainPyramid.glsl under TERRAIN_DETAIL.
 *
 * Source: the idea of base and tileable detail is L. Balogh, "Real-time Visualization of Detailed
 * Terrain" (SOAR with detail geometry), chapter 6. Here the surface is
 *
 *   z(x, y) = base(x, y) + scale * detail(2^level x mod period, 2^level y mod period)
 *
 * with x, y in base cells and both fields bilinear. On a cell of the detail the base's patch is
 * bilinear too, and so is the sum: it is the heightfield of (W - 1) 2^level + 1 samples, and every
 * function that reads cells and nodes of a heightfield works on it unchanged.
 *
 * Bounds: a node of level k is bounded by the sum of the bounds of both parts. That of the base is,
 * up to level k = level, that of the four corners of a part of one patch (a bilinear patch has its
 * extremes at corners), above it the base's own node of level k - level; that of the detail is its
 * node of level k within the period, or the whole period's where the period does not divide by 2^k.
 * Nodes of the detail are 16-bit parts of its largest code, rounded outwards.
 */
#ifndef terrain_DetailHeights_h
#define terrain_DetailHeights_h

#include "core/surface/CodedHeights.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace terrain
{
/// The highest level of which a whole number of nodes makes the period.
inline int WholeLevels(glm::ivec2 period)
{
  int level = 0;
  while ((((period.x | period.y) >> level) & 1) == 0)
  {
    ++level;
  }
  return level;
}

/// The level of a number of detail cells along a base cell, which must be a power of two.
inline int LevelOfCells(int cells)
{
  int level = 0;
  while ((1 << level) < cells)
  {
    ++level;
  }
  return level;
}

/// Twin of terrainWrap(): index % period of an index >= 0.
inline glm::ivec2 Wrap(glm::ivec2 index, glm::ivec2 period)
{
  return index % period;
}

/// Bounds of the codes of a node.
struct CodeBounds
{
  float Maximum;
  float Minimum;
};

/// The codes of a sum, with the functions of CodedHeights.
template <typename Texel>
struct DetailedHeights
{
  CodedHeights<Texel> base;
  /// One period of codes >= 0; sample (i + n period.x, j + m period.y) is sample (i, j).
  const float* detail = nullptr;
  glm::ivec2 period{ 1, 1 };
  /// Detail cells along a base cell: 2^level, level >= 0.
  int level = 0;
  /// Base codes per code of the detail, >= 0.
  float scale = 1.0f;
  /// Samples of the sum, (W - 1) 2^level + 1; its largest code; codes are not biased.
  glm::ivec2 size{ 0, 0 };
  float maximumCode = 0.0f;
  int bias = 0;

  /// As in terrainDetailCodes(): the scaled code of a sample of the repeated detail; sample >= 0.
  float DetailCode(glm::ivec2 sample) const
  {
    const glm::ivec2 wrapped = Wrap(sample, this->period);
    return this->scale *
      this->detail[wrapped.x + static_cast<std::int64_t>(this->period.x) * wrapped.y];
  }

  /// Twin of terrainPartCodes(): the base's codes at the corners of part (x, y) of 2^parts x
  /// 2^parts parts of a base cell, cell = part >> parts; all negative where the cell has no
  /// surface.
  glm::vec4 PartCodes(glm::ivec2 part, int parts) const
  {
    const glm::ivec2 cell = part >> parts;
    const glm::vec4 codes = this->base.CellCodes(cell);
    if (!glm::all(glm::greaterThanEqual(codes, glm::vec4(0.0f))))
    {
      return glm::vec4(kNoDataCode);
    }
    const float width = 1.0f / static_cast<float>(1 << parts);
    const glm::vec2 low = glm::vec2(part - (cell << parts)) * width;
    const glm::vec2 high = low + width;
    return { PatchCode(codes, low), PatchCode(codes, { high.x, low.y }),
      PatchCode(codes, { low.x, high.y }), PatchCode(codes, high) };
  }

  /// Twin of terrainCellCodes(): south-west, south-east, north-west, north-east.
  glm::vec4 CellCodes(glm::ivec2 cell) const
  {
    const glm::vec4 codes = this->PartCodes(cell, this->level);
    if (codes.x < 0.0f)
    {
      return codes;
    }
    return codes +
      glm::vec4(this->DetailCode(cell), this->DetailCode(cell + glm::ivec2(1, 0)),
        this->DetailCode(cell + glm::ivec2(0, 1)), this->DetailCode(cell + 1));
  }
};

/// One period of detail with its first column and row once more behind the last ones, so that its
/// cells are period.x x period.y: (period.x + 1) x (period.y + 1) values.
inline std::vector<float> WrapPeriod(const float* detail, glm::ivec2 period)
{
  std::vector<float> wrapped;
  wrapped.reserve(
    (static_cast<std::size_t>(period.x) + 1) * (static_cast<std::size_t>(period.y) + 1));
  for (int j = 0; j <= period.y; ++j)
  {
    const float* row = detail + static_cast<std::int64_t>(period.x) * (j % period.y);
    wrapped.insert(wrapped.end(), row, row + period.x);
    wrapped.push_back(row[0]);
  }
  return wrapped;
}

/// Bounds of the codes of one period of detail, in 16 bits.
struct DetailNodes
{
  MinMaxPyramid<std::uint16_t> Pyramid;
  /// Code of the detail per unit of the nodes.
  float Unit = 1.0f;
  /// Largest code of the period.
  float Maximum = 0.0f;

  /// Of codes from 0 to a maximum.
  void Build(const float* detail, glm::ivec2 period, float maximum, const ParallelFor& parallelFor)
  {
    const std::vector<float> wrapped = WrapPeriod(detail, period);
    HeightfieldView<float> view;
    view.Samples = wrapped.data();
    view.Width = period.x + 1;
    view.Height = period.y + 1;
    MinMaxPyramid<float> bounds;
    bounds.Build(view, parallelFor);
    this->Maximum = maximum;
    this->Unit = std::max(maximum, 1e-30f) / 65534.0f; // 65535 of them are more than the maximum
    this->Pyramid.BuildFrom(bounds,
      [this](const PyramidNode<float>& node)
      {
        const double unit = this->Unit;
        return PyramidNode<std::uint16_t>{ static_cast<std::uint16_t>(
                                             std::min(std::ceil(node.Maximum / unit), 65535.0)),
          static_cast<std::uint16_t>(std::max(std::floor(node.Minimum / unit), 0.0)) };
      });
  }
};

/// The bounds of a sum, with the functions of MinMaxPyramid.
template <typename Texel>
struct DetailedPyramid
{
  const DetailedHeights<Texel>* heights = nullptr;
  const MinMaxPyramid<Texel>* base = nullptr;
  const DetailNodes* detail = nullptr;

  int LevelCount() const
  {
    const int top = this->base->LevelCount();
    return top > 0 ? top + this->heights->level : 0;
  }

  /// Bounds of node (x, y) of a level; 1 <= level <= LevelCount().
  CodeBounds At(glm::ivec2 node, int level) const
  {
    const CodeBounds low = this->BaseExtremes(node, level);
    const CodeBounds add = this->DetailExtremes(node, level);
    return { low.Maximum + add.Maximum, low.Minimum + add.Minimum };
  }

  /// Twin of terrainBaseExtremes().
  CodeBounds BaseExtremes(glm::ivec2 node, int level) const
  {
    const int above = level - this->heights->level;
    if (above > 0)
    {
      const PyramidNode<Texel>& bounds = this->base->At(node, above);
      const auto bias = static_cast<float>(this->heights->base.bias);
      return { static_cast<float>(bounds.Maximum) - bias,
        static_cast<float>(bounds.Minimum) - bias };
    }
    const glm::ivec2 last = (this->heights->size - 2) >> level;
    const glm::vec4 codes = this->heights->PartCodes(glm::min(node, last), -above);
    return { std::max(std::max(codes.x, codes.y), std::max(codes.z, codes.w)),
      std::min(std::min(codes.x, codes.y), std::min(codes.z, codes.w)) };
  }

  /// Twin of terrainDetailExtremes().
  CodeBounds DetailExtremes(glm::ivec2 node, int level) const
  {
    const int top = WholeLevels(this->heights->period);
    const float scale = this->heights->scale;
    if (level > top)
    {
      return { scale * this->detail->Maximum, 0.0f };
    }
    const float unit = scale * this->detail->Unit;
    const PyramidNode<std::uint16_t>& bounds =
      this->detail->Pyramid.At(Wrap(node, this->heights->period >> level), level);
    return { unit * static_cast<float>(bounds.Maximum), unit * static_cast<float>(bounds.Minimum) };
  }
};

/// Texel type of CodedPyramid for heights with detail over a base of Texels.
template <typename Texel>
struct WithDetail
{
};

template <typename Texel>
struct CodedTypes<WithDetail<Texel>>
{
  using Heights = DetailedHeights<Texel>;
  using Pyramid = DetailedPyramid<Texel>;
};
}

#endif
