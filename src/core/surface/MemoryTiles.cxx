// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/MemoryTiles.h"

#include "core/grid/SampleTypes.h"

#include <algorithm>
#include <cstddef>

namespace terrain
{
namespace
{
/// Calls body(first row, rows) for the rows of a level.
template <typename Body>
void ForRows(const ParallelFor& parallelFor, std::int64_t rows, const Body& body)
{
  parallelFor(rows, [&](std::int64_t begin, std::int64_t end) { body(begin, end - begin); });
}

/// The type that samples are stored in: short and unsigned short hold all samples but one, which
/// stands for no height.
template <typename T>
using Stored = std::conditional_t<std::is_integral_v<T> && sizeof(T) < sizeof(short), short, float>;

template <typename Out, typename T>
std::unique_ptr<TileSource> StoreAs(
  const HeightfieldView<T>& view, int tileLevel, const ParallelFor& parallelFor)
{
  std::vector<Out> samples(static_cast<std::size_t>(view.Width * view.Height));
  Out* out = samples.data();
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    for (std::int64_t i = 0; i < view.Width; ++i)
    {
      const std::int64_t index = view.Index(i, j);
      *out++ = view.IsValid(index) ? static_cast<Out>(view.Samples[index]) : NoStoredHeight<Out>();
    }
  }
  return std::make_unique<MemoryTiles<Out>>(
    samples.data(), TileLayout{ view.Width, view.Height, tileLevel }, parallelFor);
}
}

//------------------------------------------------------------------------------
template <typename T>
MemoryTiles<T>::MemoryTiles(
  const T* samples, const TileLayout& layout, const ParallelFor& parallelFor)
  : Layout(layout)
{
  HeightfieldView<T> view;
  view.Samples = samples;
  view.Width = layout.Width;
  view.Height = layout.Height;
  view.HasNoData = true;
  view.NoData = NoStoredHeight<T>();
  this->Codes = ChooseHeightCodes(FindHeightRange(view, parallelFor));
  const int count = layout.LevelCount() > 0 ? layout.LevelCount() + layout.TileLevel : 0;
  this->Levels.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    Level& level = this->Levels[static_cast<std::size_t>(k)];
    level.Cells = layout.Cells(k);
    const glm::i64vec2 size = level.Cells + std::int64_t{ 1 };
    if (k == 0)
    {
      level.Samples.assign(samples, samples + size.x * size.y);
      continue;
    }
    const Level& finer = this->Levels[static_cast<std::size_t>(k) - 1];
    level.Nodes.resize(static_cast<std::size_t>(level.Cells.x * level.Cells.y));
    level.Samples.resize(static_cast<std::size_t>(size.x * size.y));
    ForRows(parallelFor, level.Cells.y,
      [&](std::int64_t first, std::int64_t rows)
      {
        const LevelPlane<PyramidNode<T>> out{ level.Nodes.data() + level.Cells.x * first,
          { 0, first }, { level.Cells.x, rows } };
        k == 1 ? ReduceSamplesToNodes<T>(finer.SamplePlane(), finer.Cells, out)
               : ReduceNodes<T>(finer.NodePlane(), finer.Cells, out);
      });
    ForRows(parallelFor, size.y,
      [&](std::int64_t first, std::int64_t rows)
      {
        const LevelPlane<T> out{ level.Samples.data() + size.x * first, { 0, first },
          { size.x, rows } };
        ReduceSamples<T>(finer.SamplePlane(), finer.Cells, level.NodePlane(), level.Cells, out);
      });
  }
}

//------------------------------------------------------------------------------
template <typename T>
PyramidNode<float> MemoryTiles<T>::GetBounds(const TileKey& key) const
{
  const auto level =
    static_cast<std::size_t>(key.Level) + static_cast<std::size_t>(this->Layout.TileLevel);
  return ToCodes(this->Levels[level].NodePlane().At(key.Column, key.Row), this->Codes);
}

//------------------------------------------------------------------------------
template <typename T>
std::string MemoryTiles<T>::Read(const TileKey& key, Tile& tile) const
{
  if (!this->Layout.Contains(key))
  {
    return "there is no such tile";
  }
  const Level& level = this->Levels[static_cast<std::size_t>(key.Level)];
  CutTile<T>(this->Layout, key, level.SamplePlane(), level.NodePlane(), this->Codes, tile);
  return {};
}

//------------------------------------------------------------------------------
template <typename T>
std::unique_ptr<TileSource> MakeMemoryTiles(
  const HeightfieldView<T>& view, int tileLevel, const ParallelFor& parallelFor)
{
  if constexpr (std::is_same_v<T, short> || std::is_same_v<T, unsigned short>)
  {
    // 16-bit heights that use the value that stands for none are kept as float.
    const std::int64_t first = std::min<std::int64_t>(view.Index(0, view.Height - 1), 0);
    for (std::int64_t index = first; index < first + view.Width * view.Height; ++index)
    {
      if (view.Samples[index] == NoStoredHeight<T>() && view.IsValid(index))
      {
        return StoreAs<float>(view, tileLevel, parallelFor);
      }
    }
    return StoreAs<T>(view, tileLevel, parallelFor);
  }
  else
  {
    return StoreAs<Stored<T>>(view, tileLevel, parallelFor);
  }
}

template class MemoryTiles<short>;
template class MemoryTiles<unsigned short>;
template class MemoryTiles<float>;

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template std::unique_ptr<TileSource> MakeMemoryTiles<T>(                                         \
    const HeightfieldView<T>&, int, const ParallelFor&);
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
