// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TilePyramid.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace terrain
{
namespace
{
// Columns that one thread takes at a time.
constexpr std::int64_t kColumns = 1024;

std::size_t Count(std::int64_t width, std::int64_t rows)
{
  return static_cast<std::size_t>(width * rows);
}

/// Calls body(first, count) for pieces of `width` columns.
template <typename Body>
void ForColumns(const ParallelFor& parallelFor, std::int64_t width, const Body& body)
{
  parallelFor((width + kColumns - 1) / kColumns,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t piece = begin; piece < end; ++piece)
      {
        body(piece * kColumns, std::min(kColumns, width - piece * kColumns));
      }
    });
}
}

//------------------------------------------------------------------------------
template <typename T>
TilePyramid<T>::TilePyramid(
  const TileLayout& layout, int firstLevel, TakeRow take, ParallelFor parallelFor)
  : Layout(layout)
  , FirstLevel(firstLevel)
  , Take(std::move(take))
  , For(std::move(parallelFor))
  , Levels(static_cast<std::size_t>(layout.LevelCount()))
{
  for (std::size_t level = 0; level < this->Levels.size(); ++level)
  {
    this->Levels[level].Cells = layout.Cells(static_cast<int>(level));
  }
}

//------------------------------------------------------------------------------
template <typename T>
T* TilePyramid<T>::AddRows(std::int64_t count)
{
  Level& level = this->Levels.front();
  const std::int64_t width = level.Cells.x + 1;
  const std::size_t size = level.Samples.size();
  level.Samples.resize(size + Count(width, count));
  level.EndSampleRow += count;
  return level.Samples.data() + size;
}

//------------------------------------------------------------------------------
template <typename T>
void TilePyramid<T>::Build()
{
  const auto count = static_cast<int>(this->Levels.size());
  for (int level = 0; level < count; ++level)
  {
    if (level > 0)
    {
      this->BuildNodes(level);
      this->BuildSamples(level);
      this->Trim(level - 1);
    }
    if (level >= this->FirstLevel)
    {
      this->HandOut(level);
    }
  }
  if (count > 0)
  {
    this->Trim(count - 1);
  }
}

//------------------------------------------------------------------------------
// A row of nodes lies over two of the finer level, each over two rows of samples of level 0.
template <typename T>
void TilePyramid<T>::BuildNodes(int level)
{
  Level& coarse = this->Levels[static_cast<std::size_t>(level)];
  const Level& finer = this->Levels[static_cast<std::size_t>(level) - 1];
  const std::int64_t ready =
    level == 1 ? std::max<std::int64_t>(finer.EndSampleRow - 1, 0) : finer.EndNodeRow;
  const std::int64_t end = ready == finer.Cells.y ? coarse.Cells.y : ready / 2;
  const std::int64_t begin = coarse.EndNodeRow;
  if (end <= begin)
  {
    return;
  }
  coarse.Nodes.resize(Count(coarse.Cells.x, end - coarse.FirstNodeRow));
  coarse.EndNodeRow = end;
  ForColumns(this->For, coarse.Cells.x,
    [&](std::int64_t first, std::int64_t columns)
    {
      std::vector<PyramidNode<T>> piece(Count(columns, 1));
      for (std::int64_t y = begin; y < end; ++y)
      {
        const LevelPlane<PyramidNode<T>> out{ piece.data(), { first, y }, { columns, 1 } };
        if (level == 1)
        {
          ReduceSamplesToNodes<T>(finer.SamplePlane(), finer.Cells, out);
        }
        else
        {
          ReduceNodes<T>(finer.NodePlane(), finer.Cells, out);
        }
        std::copy(piece.begin(), piece.end(),
          coarse.Nodes.data() + first + coarse.Cells.x * (y - coarse.FirstNodeRow));
      }
    });
}

//------------------------------------------------------------------------------
// A sample lies amidst three rows of samples of the finer level, and two rows of nodes of its own.
template <typename T>
void TilePyramid<T>::BuildSamples(int level)
{
  Level& coarse = this->Levels[static_cast<std::size_t>(level)];
  const Level& finer = this->Levels[static_cast<std::size_t>(level) - 1];
  const std::int64_t width = coarse.Cells.x + 1;
  const bool nodesEnd = coarse.EndNodeRow == coarse.Cells.y;
  const bool samplesEnd = finer.EndSampleRow == finer.Cells.y + 1;
  const std::int64_t last = coarse.Cells.y + 1;
  const std::int64_t end =
    std::min(nodesEnd ? last : coarse.EndNodeRow, samplesEnd ? last : finer.EndSampleRow / 2);
  const std::int64_t begin = coarse.EndSampleRow;
  if (end <= begin)
  {
    return;
  }
  coarse.Samples.resize(Count(width, end - coarse.FirstSampleRow));
  coarse.EndSampleRow = end;
  ForColumns(this->For, width,
    [&](std::int64_t first, std::int64_t columns)
    {
      std::vector<T> piece(Count(columns, 1));
      for (std::int64_t y = begin; y < end; ++y)
      {
        const LevelPlane<T> out{ piece.data(), { first, y }, { columns, 1 } };
        ReduceSamples<T>(finer.SamplePlane(), finer.Cells, coarse.NodePlane(), coarse.Cells, out);
        std::copy(piece.begin(), piece.end(),
          coarse.Samples.data() + first + width * (y - coarse.FirstSampleRow));
      }
    });
}

//------------------------------------------------------------------------------
template <typename T>
void TilePyramid<T>::HandOut(int level)
{
  Level& rows = this->Levels[static_cast<std::size_t>(level)];
  const std::int64_t tileRows = this->Layout.Tiles(level).y;
  while (rows.TileRows < tileRows)
  {
    const std::int64_t end = std::min((rows.TileRows + 1) * this->Layout.TileCells(), rows.Cells.y);
    if (rows.EndSampleRow < end + 1 || (level > 0 && rows.EndNodeRow < end))
    {
      return;
    }
    this->Take(level, rows.TileRows, rows.SamplePlane(), rows.NodePlane());
    ++rows.TileRows;
  }
}

//------------------------------------------------------------------------------
// Forgets the rows that neither the coarser level nor the next row of tiles needs.
template <typename T>
void TilePyramid<T>::Trim(int level)
{
  Level& rows = this->Levels[static_cast<std::size_t>(level)];
  std::int64_t samples = rows.EndSampleRow;
  std::int64_t nodes = std::max<std::int64_t>(rows.EndSampleRow - 1, rows.FirstNodeRow);
  if (static_cast<std::size_t>(level) + 1 < this->Levels.size())
  {
    const Level& coarse = this->Levels[static_cast<std::size_t>(level) + 1];
    samples = std::min(samples, 2 * coarse.EndSampleRow - 1);
    samples = level == 0 ? std::min(samples, 2 * coarse.EndNodeRow) : samples;
    nodes = std::min(nodes, 2 * coarse.EndNodeRow);
  }
  if (level >= this->FirstLevel)
  {
    samples = std::min(samples, rows.TileRows * this->Layout.TileCells());
    nodes = std::min(nodes, rows.TileRows * this->Layout.TileCells());
  }
  samples = std::clamp(samples, rows.FirstSampleRow, rows.EndSampleRow);
  nodes = std::clamp(nodes, rows.FirstNodeRow, rows.EndNodeRow);
  rows.Samples.erase(rows.Samples.begin(),
    rows.Samples.begin() +
      static_cast<std::ptrdiff_t>(Count(rows.Cells.x + 1, samples - rows.FirstSampleRow)));
  rows.Nodes.erase(rows.Nodes.begin(),
    rows.Nodes.begin() +
      static_cast<std::ptrdiff_t>(level > 0 ? Count(rows.Cells.x, nodes - rows.FirstNodeRow) : 0));
  rows.FirstSampleRow = samples;
  rows.FirstNodeRow = nodes;
}

template class TilePyramid<short>;
template class TilePyramid<unsigned short>;
template class TilePyramid<float>;
}
