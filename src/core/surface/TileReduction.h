// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a level of tiles from the next finer one (TileSource.h says what levels are).
 *
 * Heights are stored as short, unsigned short or float, with one value kept for no height.
 */
#ifndef terrain_TileReduction_h
#define terrain_TileReduction_h

#include "core/grid/Heightfield.h"
#include "core/surface/TileSource.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace terrain
{
/// The value that stands for no height: -32768, 65535 or NaN.
template <typename T>
constexpr T NoStoredHeight()
{
  static_assert(
    std::is_same_v<T, short> || std::is_same_v<T, unsigned short> || std::is_same_v<T, float>,
    "heights are stored in these types");
  if constexpr (std::is_same_v<T, float>)
  {
    return std::numeric_limits<float>::quiet_NaN();
  }
  return std::is_signed_v<T> ? std::numeric_limits<T>::min() : std::numeric_limits<T>::max();
}

template <typename T>
bool IsStoredHeight(T value)
{
  if constexpr (std::is_same_v<T, float>)
  {
    return IsHeight(value);
  }
  return value != NoStoredHeight<T>();
}

/// A rectangle of a level's samples or cells in memory, row by row without gaps; Data is that of
/// (First.x, First.y).
template <typename T>
struct LevelPlane
{
  T* Data = nullptr;
  glm::i64vec2 First{ 0, 0 };
  glm::i64vec2 Size{ 0, 0 };

  T* Row(std::int64_t y) const // to be indexed from First.x
  {
    return this->Data + (y - this->First.y) * this->Size.x;
  }
  T& At(std::int64_t x, std::int64_t y) const
  {
    return this->Row(y)[x - this->First.x];
  }
};

/// Bounds of cells of level 1 from the samples of level 0, for all of `nodes`; cells: of level 0.
/// The samples of all cells below must be there.
template <typename T>
void ReduceSamplesToNodes(
  const LevelPlane<const T>& samples, glm::i64vec2 cells, const LevelPlane<PyramidNode<T>>& nodes);

/// Bounds of cells of a level from those of the next finer one, which has `cells`.
template <typename T>
void ReduceNodes(const LevelPlane<const PyramidNode<T>>& finer, glm::i64vec2 cells,
  const LevelPlane<PyramidNode<T>>& nodes);

/// Samples of a level, for all of `out`, from those of the next finer one. finerCells, cells: of
/// the two levels; nodes: bounds of the cells around the samples.
template <typename T>
void ReduceSamples(const LevelPlane<const T>& finer, glm::i64vec2 finerCells,
  const LevelPlane<const PyramidNode<T>>& nodes, glm::i64vec2 cells, const LevelPlane<T>& out);

/// Codes for stored heights between two bounds; minimum > maximum if there are none.
template <typename T>
HeightCodes ChooseStoredCodes(T minimum, T maximum, bool hasNoData)
{
  HeightRange<T> range;
  range.Minimum = minimum;
  range.Maximum = maximum;
  range.HasNoData = hasNoData;
  return ChooseHeightCodes(range);
}

/// Bounds in codes.
template <typename T>
PyramidNode<float> ToCodes(const PyramidNode<T>& node, const HeightCodes& codes)
{
  return node.IsEmpty()
    ? PyramidNode<float>::Empty()
    : PyramidNode<float>{ static_cast<float>(codes.ToCode(static_cast<double>(node.Maximum))),
        static_cast<float>(codes.ToCode(static_cast<double>(node.Minimum))) };
}

/// The tile of a layout, from planes that hold its samples and, from level 1 on, its nodes.
template <typename T>
void CutTile(const TileLayout& layout, const TileKey& key, const LevelPlane<const T>& samples,
  const LevelPlane<const PyramidNode<T>>& nodes, const HeightCodes& codes, Tile& tile);
}

#endif
