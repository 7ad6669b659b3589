// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileReduction.h"

#include <algorithm>
#include <cstddef>

namespace terrain
{
namespace
{
/// Sums of heights with small weights.
template <typename T>
using SumType = std::conditional_t<std::is_same_v<T, float>, float, std::int32_t>;

/// Adds the bounds of another node.
template <typename T>
void Unite(PyramidNode<T>& node, const PyramidNode<T>& other)
{
  node.Maximum = std::max(node.Maximum, other.Maximum);
  node.Minimum = std::min(node.Minimum, other.Minimum);
}

/// Bounds of a cell by its corners; empty if one has no height.
template <typename T>
PyramidNode<T> CellBounds(T southWest, T southEast, T northWest, T northEast)
{
  if (!IsStoredHeight(southWest) || !IsStoredHeight(southEast) || !IsStoredHeight(northWest) ||
    !IsStoredHeight(northEast))
  {
    return PyramidNode<T>::Empty();
  }
  return { std::max(std::max(southWest, southEast), std::max(northWest, northEast)),
    std::min(std::min(southWest, southEast), std::min(northWest, northEast)) };
}

/// Extremes of three rows by column, and whether one of the three has no height.
template <typename T>
struct ColumnExtremes
{
  std::vector<T> Maxima;
  std::vector<T> Minima;
  std::vector<unsigned char> Lacks;

  explicit ColumnExtremes(std::size_t count)
    : Maxima(count)
    , Minima(count)
    , Lacks(count)
  {
  }
  void Take(const T* a, const T* b, const T* c)
  {
    for (std::size_t i = 0; i < this->Maxima.size(); ++i)
    {
      this->Maxima[i] = std::max(std::max(a[i], b[i]), c[i]);
      this->Minima[i] = std::min(std::min(a[i], b[i]), c[i]);
      this->Lacks[i] = static_cast<unsigned char>(unsigned{ !IsStoredHeight(a[i]) } |
        unsigned{ !IsStoredHeight(b[i]) } | unsigned{ !IsStoredHeight(c[i]) });
    }
  }
};

/// Sums of three rows by column with the weights 1 2 1, and whether one of the three has no height.
template <typename T>
struct ColumnSums
{
  std::vector<SumType<T>> Sums;
  std::vector<unsigned char> Lacks;

  explicit ColumnSums(std::size_t count)
    : Sums(count)
    , Lacks(count)
  {
  }
  void Take(const T* a, const T* b, const T* c)
  {
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      this->Sums[i] = SumType<T>(a[i]) + 2 * SumType<T>(b[i]) + SumType<T>(c[i]);
      this->Lacks[i] = static_cast<unsigned char>(unsigned{ !IsStoredHeight(a[i]) } |
        unsigned{ !IsStoredHeight(b[i]) } | unsigned{ !IsStoredHeight(c[i]) });
    }
  }
};

/// A sixteenth of a sum; whole numbers are rounded to the nearest.
template <typename T>
T Sixteenth(SumType<T> sum)
{
  if constexpr (std::is_same_v<T, float>)
  {
    return sum * 0.0625F;
  }
  else
  {
    return static_cast<T>((sum + 8) >> 4);
  }
}

/// The average around (x, y) of what has heights, if half of the weight has; else no height.
template <typename T>
T AverageWithHoles(const T* const rows[3], const std::int64_t columns[3])
{
  constexpr int weights[3] = { 1, 2, 1 };
  double sum = 0.0;
  int weight = 0;
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      const T value = rows[r][columns[c]];
      const int share = weights[r] * weights[c];
      sum += IsStoredHeight(value) ? share * static_cast<double>(value) : 0.0;
      weight += IsStoredHeight(value) ? share : 0;
    }
  }
  if (weight < 8)
  {
    return NoStoredHeight<T>();
  }
  const double mean = sum / weight;
  return static_cast<T>(std::is_same_v<T, float> ? mean : std::floor(mean + 0.5));
}

/// A sample brought into the bounds of all cells around it that have a surface; no height where
/// there are none or they have nothing in common.
template <typename T>
T ClampToCells(T value, const LevelPlane<const PyramidNode<T>>& nodes, glm::i64vec2 cells,
  std::int64_t x, std::int64_t y)
{
  T low = std::numeric_limits<T>::lowest();
  T high = std::numeric_limits<T>::max();
  bool any = false;
  for (std::int64_t j = std::max<std::int64_t>(y - 1, 0); j <= std::min(y, cells.y - 1); ++j)
  {
    for (std::int64_t i = std::max<std::int64_t>(x - 1, 0); i <= std::min(x, cells.x - 1); ++i)
    {
      const PyramidNode<T>& node = nodes.At(i, j);
      if (!node.IsEmpty())
      {
        low = std::max(low, node.Minimum);
        high = std::min(high, node.Maximum);
        any = true;
      }
    }
  }
  if (!any || low > high || !IsStoredHeight(value))
  {
    return NoStoredHeight<T>();
  }
  return std::min(std::max(value, low), high);
}
}

//------------------------------------------------------------------------------
template <typename T>
void ReduceSamplesToNodes(
  const LevelPlane<const T>& samples, glm::i64vec2 cells, const LevelPlane<PyramidNode<T>>& nodes)
{
  const std::int64_t first = 2 * nodes.First.x;
  const std::int64_t last = std::min(2 * (nodes.First.x + nodes.Size.x), cells.x); // sample
  ColumnExtremes<T> columns(static_cast<std::size_t>(last - first + 1));
  for (std::int64_t y = nodes.First.y; y < nodes.First.y + nodes.Size.y; ++y)
  {
    const std::int64_t offset = first - samples.First.x;
    const T* south = samples.Row(2 * y) + offset;
    const T* middle = samples.Row(2 * y + 1) + offset;
    const T* north = samples.Row(std::min(2 * y + 2, cells.y)) + offset;
    columns.Take(south, middle, north);
    PyramidNode<T>* out = nodes.Row(y);
    for (std::int64_t k = 0; k < nodes.Size.x; ++k)
    {
      const auto west = static_cast<std::size_t>(2 * k);
      const std::size_t centre = west + 1;
      const auto east = static_cast<std::size_t>(std::min(2 * k + 2, last - first));
      if (columns.Lacks[west] | columns.Lacks[centre] | columns.Lacks[east])
      {
        out[k] = CellBounds(south[west], south[centre], middle[west], middle[centre]);
        Unite(out[k], CellBounds(south[centre], south[east], middle[centre], middle[east]));
        Unite(out[k], CellBounds(middle[west], middle[centre], north[west], north[centre]));
        Unite(out[k], CellBounds(middle[centre], middle[east], north[centre], north[east]));
        continue;
      }
      out[k] = { std::max(
                   std::max(columns.Maxima[west], columns.Maxima[centre]), columns.Maxima[east]),
        std::min(std::min(columns.Minima[west], columns.Minima[centre]), columns.Minima[east]) };
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
void ReduceNodes(const LevelPlane<const PyramidNode<T>>& finer, glm::i64vec2 cells,
  const LevelPlane<PyramidNode<T>>& nodes)
{
  for (std::int64_t y = nodes.First.y; y < nodes.First.y + nodes.Size.y; ++y)
  {
    const PyramidNode<T>* south = finer.Row(2 * y) - finer.First.x;
    const PyramidNode<T>* north = finer.Row(std::min(2 * y + 1, cells.y - 1)) - finer.First.x;
    PyramidNode<T>* out = nodes.Row(y);
    for (std::int64_t k = 0; k < nodes.Size.x; ++k)
    {
      const std::int64_t west = 2 * (nodes.First.x + k);
      const std::int64_t east = std::min(west + 1, cells.x - 1);
      PyramidNode<T> node = south[west];
      Unite(node, south[east]);
      Unite(node, north[west]);
      Unite(node, north[east]);
      out[k] = node;
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
void ReduceSamples(const LevelPlane<const T>& finer, glm::i64vec2 finerCells,
  const LevelPlane<const PyramidNode<T>>& nodes, glm::i64vec2 cells, const LevelPlane<T>& out)
{
  const auto clamp = [](std::int64_t value, std::int64_t last)
  { return std::clamp<std::int64_t>(value, 0, last); };
  const std::int64_t first = clamp(2 * out.First.x - 1, finerCells.x);
  const std::int64_t last = clamp(2 * (out.First.x + out.Size.x) - 1, finerCells.x);
  ColumnSums<T> columns(static_cast<std::size_t>(last - first + 1));
  for (std::int64_t y = out.First.y; y < out.First.y + out.Size.y; ++y)
  {
    const std::int64_t offset = first - finer.First.x;
    const T* const rows[3] = { finer.Row(clamp(2 * y - 1, finerCells.y)) + offset,
      finer.Row(clamp(2 * y, finerCells.y)) + offset,
      finer.Row(clamp(2 * y + 1, finerCells.y)) + offset };
    columns.Take(rows[0], rows[1], rows[2]);
    T* to = out.Row(y);
    for (std::int64_t k = 0; k < out.Size.x; ++k)
    {
      const std::int64_t x = out.First.x + k;
      const std::int64_t at[3] = { clamp(2 * x - 1, finerCells.x) - first,
        clamp(2 * x, finerCells.x) - first, clamp(2 * x + 1, finerCells.x) - first };
      const auto west = static_cast<std::size_t>(at[0]);
      const auto centre = static_cast<std::size_t>(at[1]);
      const auto east = static_cast<std::size_t>(at[2]);
      const T value = columns.Lacks[west] | columns.Lacks[centre] | columns.Lacks[east]
        ? AverageWithHoles<T>(rows, at)
        : Sixteenth<T>(columns.Sums[west] + 2 * columns.Sums[centre] + columns.Sums[east]);
      to[k] = ClampToCells(value, nodes, cells, x, y);
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
void CutTile(const TileLayout& layout, const TileKey& key, const LevelPlane<const T>& samples,
  const LevelPlane<const PyramidNode<T>>& nodes, const HeightCodes& codes, Tile& tile)
{
  const glm::i64vec2 first = layout.FirstCell(key);
  const glm::i64vec2 count = layout.CellCount(key);
  tile.Cells = glm::ivec2(count);
  tile.Samples.resize(static_cast<std::size_t>((count.x + 1) * (count.y + 1)));
  float* sample = tile.Samples.data();
  for (std::int64_t y = 0; y <= count.y; ++y)
  {
    for (std::int64_t x = 0; x <= count.x; ++x)
    {
      const T value = samples.At(first.x + x, first.y + y);
      *sample++ = IsStoredHeight(value)
        ? static_cast<float>(codes.ToCode(static_cast<double>(value)))
        : kNoDataCode;
    }
  }
  tile.Nodes.resize(key.Level > 0 ? static_cast<std::size_t>(count.x * count.y) : 0);
  tile.Relief = 0.0F;
  PyramidNode<float>* node = tile.Nodes.data();
  for (std::int64_t y = 0; key.Level > 0 && y < count.y; ++y)
  {
    for (std::int64_t x = 0; x < count.x; ++x)
    {
      *node = ToCodes(nodes.At(first.x + x, first.y + y), codes);
      const float relief = node->IsEmpty() ? 0.0F : node->Maximum - node->Minimum;
      tile.Relief = std::max(tile.Relief, relief);
      ++node;
    }
  }
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type in a template's arguments takes none
#define TERRAIN_INSTANTIATE(T)                                                                     \
  template void ReduceSamplesToNodes<T>(                                                           \
    const LevelPlane<const T>&, glm::i64vec2, const LevelPlane<PyramidNode<T>>&);                  \
  template void ReduceNodes<T>(                                                                    \
    const LevelPlane<const PyramidNode<T>>&, glm::i64vec2, const LevelPlane<PyramidNode<T>>&);     \
  template void ReduceSamples<T>(const LevelPlane<const T>&, glm::i64vec2,                         \
    const LevelPlane<const PyramidNode<T>>&, glm::i64vec2, const LevelPlane<T>&);                  \
  template void CutTile<T>(const TileLayout&, const TileKey&, const LevelPlane<const T>&,          \
    const LevelPlane<const PyramidNode<T>>&, const HeightCodes&, Tile&);
TERRAIN_INSTANTIATE(short)
TERRAIN_INSTANTIATE(unsigned short)
TERRAIN_INSTANTIATE(float)
#undef TERRAIN_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)
}
