// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/PreparedTiles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace terrain
{
namespace
{
std::size_t Area(glm::i64vec2 size)
{
  return static_cast<std::size_t>(size.x * size.y);
}
}

//------------------------------------------------------------------------------
template <typename T>
std::string PreparedTiles<T>::Open(std::unique_ptr<TileFile> file, ReadTileSamples<T> read)
{
  this->File = std::move(file);
  this->ReadSamples = std::move(read);
  const TileFileContent& content = this->File->GetContent();
  if (content.Type != StoredTypeOf<T>())
  {
    return "the file's heights are of another type";
  }
  const bool any = content.Minimum <= content.Maximum;
  this->Codes =
    ChooseStoredCodes<T>(any ? static_cast<T>(content.Minimum) : std::numeric_limits<T>::max(),
      any ? static_cast<T>(content.Maximum) : std::numeric_limits<T>::lowest(), content.HasNoData);
  return this->ReadBounds();
}

//------------------------------------------------------------------------------
template <typename T>
std::string PreparedTiles<T>::ReadBounds()
{
  const TileLayout layout = this->GetLayout();
  const int top = layout.LevelCount() - 1;
  this->BoundsLevel = std::min(layout.TileLevel, top);
  const glm::i64vec2 size = layout.Cells(this->BoundsLevel);
  std::vector<PyramidNode<T>> bounds(Area(size), PyramidNode<T>::Empty());
  std::vector<T> samples;
  std::vector<PyramidNode<T>> nodes;
  const glm::i64vec2 tiles = layout.Tiles(this->BoundsLevel);
  for (std::int64_t tile = 0; tile < tiles.x * tiles.y; ++tile)
  {
    const TileKey key{ this->BoundsLevel, tile % tiles.x, tile / tiles.x };
    std::string error = this->ReadStored(key, samples, nodes);
    if (!error.empty())
    {
      return error;
    }
    const glm::i64vec2 first = layout.FirstCell(key);
    const glm::i64vec2 count = layout.CellCount(key);
    for (std::int64_t y = 0; y < count.y; ++y)
    {
      std::copy_n(
        nodes.data() + count.x * y, count.x, bounds.data() + first.x + size.x * (first.y + y));
    }
  }
  this->Bounds.push_back(std::move(bounds));
  for (int level = this->BoundsLevel + 1; level <= top + layout.TileLevel; ++level)
  {
    const glm::i64vec2 finer = layout.Cells(level - 1);
    const glm::i64vec2 cells = layout.Cells(level);
    std::vector<PyramidNode<T>> coarse(Area(cells));
    ReduceNodes<T>(
      { this->Bounds.back().data(), { 0, 0 }, finer }, finer, { coarse.data(), { 0, 0 }, cells });
    this->Bounds.push_back(std::move(coarse));
  }
  return {};
}

//------------------------------------------------------------------------------
template <typename T>
PyramidNode<float> PreparedTiles<T>::GetBounds(const TileKey& key) const
{
  const TileLayout layout = this->GetLayout();
  const int level = key.Level + layout.TileLevel;
  const std::size_t index = static_cast<std::size_t>(key.Column + layout.Cells(level).x * key.Row);
  return ToCodes(
    this->Bounds[static_cast<std::size_t>(level - this->BoundsLevel)][index], this->Codes);
}

//------------------------------------------------------------------------------
// Samples and nodes of a rectangle of a level that is not stored, from those of the finer one.
template <typename T>
std::string PreparedTiles<T>::MakeWindow(
  int level, const Rectangle& samples, const Rectangle& cells, Window& window) const
{
  const TileLayout layout = this->GetLayout();
  const glm::i64vec2 zero(0);
  const glm::i64vec2 one(1);
  if (level == 0)
  {
    const glm::i64vec2 first = glm::min(samples.First, cells.First);
    const glm::i64vec2 size = glm::max(samples.End, cells.End + one) - first;
    window.Samples.resize(Area(size));
    window.SamplePlane = { window.Samples.data(), first, size };
    return this->ReadSamples(first, size, window.Samples.data());
  }
  const glm::i64vec2 finerCells = layout.Cells(level - 1);
  const Rectangle nodes{ glm::min(cells.First, glm::max(samples.First - one, zero)),
    glm::max(cells.End, glm::min(samples.End, layout.Cells(level))) };
  const Rectangle finerNodes{ std::int64_t{ 2 } * nodes.First,
    glm::min(std::int64_t{ 2 } * nodes.End, finerCells) };
  const Rectangle finerSamples{ glm::max(std::int64_t{ 2 } * samples.First - one, zero),
    glm::min(std::int64_t{ 2 } * samples.End, finerCells + one) };
  Window finer;
  std::string error = this->MakeWindow(level - 1, finerSamples, finerNodes, finer);
  if (!error.empty())
  {
    return error;
  }
  const glm::i64vec2 nodeSize = nodes.End - nodes.First;
  window.Nodes.resize(Area(nodeSize));
  const LevelPlane<PyramidNode<T>> nodePlane{ window.Nodes.data(), nodes.First, nodeSize };
  if (level == 1)
  {
    ReduceSamplesToNodes<T>(finer.SamplePlane, finerCells, nodePlane);
  }
  else
  {
    ReduceNodes<T>(finer.NodePlane, finerCells, nodePlane);
  }
  window.NodePlane = { window.Nodes.data(), nodes.First, nodeSize };
  const glm::i64vec2 size = samples.End - samples.First;
  window.Samples.resize(Area(size));
  ReduceSamples<T>(finer.SamplePlane, finerCells, window.NodePlane, layout.Cells(level),
    { window.Samples.data(), samples.First, size });
  window.SamplePlane = { window.Samples.data(), samples.First, size };
  return {};
}

//------------------------------------------------------------------------------
template <typename T>
std::string PreparedTiles<T>::ReadStored(
  const TileKey& key, std::vector<T>& samples, std::vector<PyramidNode<T>>& nodes) const
{
  const TileLayout layout = this->GetLayout();
  if (!layout.Contains(key))
  {
    return "there is no such tile";
  }
  if (key.Level >= this->File->GetContent().FirstLevel)
  {
    return this->File->Read(key, samples, nodes);
  }
  const glm::i64vec2 first = layout.FirstCell(key);
  const glm::i64vec2 count = layout.CellCount(key);
  Window window;
  std::string error = this->MakeWindow(
    key.Level, { first, first + count + std::int64_t{ 1 } }, { first, first + count }, window);
  if (!error.empty())
  {
    return error;
  }
  samples =
    std::move(window.Samples); // of level 0 and of coarser ones they are just those asked for
  nodes.resize(key.Level > 0 ? Area(count) : 0);
  for (std::int64_t y = 0; key.Level > 0 && y < count.y; ++y)
  {
    std::copy_n(&window.NodePlane.At(first.x, first.y + y), count.x, nodes.data() + count.x * y);
  }
  return {};
}

//------------------------------------------------------------------------------
template <typename T>
std::string PreparedTiles<T>::Read(const TileKey& key, Tile& tile) const
{
  std::vector<T> samples;
  std::vector<PyramidNode<T>> nodes;
  std::string error = this->ReadStored(key, samples, nodes);
  if (error.empty())
  {
    const glm::i64vec2 first = this->GetLayout().FirstCell(key);
    const glm::i64vec2 count = this->GetLayout().CellCount(key);
    CutTile<T>(this->GetLayout(), key, { samples.data(), first, count + std::int64_t{ 1 } },
      { nodes.data(), first, count }, this->Codes, tile);
  }
  return error;
}

template class PreparedTiles<short>;
template class PreparedTiles<unsigned short>;
template class PreparedTiles<float>;
}
