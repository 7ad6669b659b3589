// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/RepeatedTiles.h"

#include "core/surface/TileReduction.h"

#include <utility>

namespace terrain
{
//------------------------------------------------------------------------------
RepeatedTiles::RepeatedTiles(std::vector<float> period, int m, std::int64_t times, int tileLevel,
  const ParallelFor& parallelFor)
  : Layout{ (times << m) + 1, (times << m) + 1, tileLevel }
{
  HeightfieldView<float> view;
  view.Samples = period.data();
  view.Width = (std::int64_t{ 1 } << m) + 1;
  view.Height = view.Width;
  this->Codes = ChooseHeightCodes(FindHeightRange(view, parallelFor));
  this->Levels.resize(static_cast<std::size_t>(m) + 1);
  this->Levels.front().Cells = view.Width - 1;
  this->Levels.front().Samples = std::move(period);
  for (std::size_t k = 1; k < this->Levels.size(); ++k)
  {
    const Level& finer = this->Levels[k - 1];
    Level& level = this->Levels[k];
    level.Cells = finer.Cells / 2;
    const glm::i64vec2 cells(level.Cells);
    const glm::i64vec2 finerCells(finer.Cells);
    const glm::i64vec2 samples = cells + std::int64_t{ 1 };
    level.Nodes.resize(static_cast<std::size_t>(cells.x * cells.y));
    level.Samples.resize(static_cast<std::size_t>(samples.x * samples.y));
    const LevelPlane<const float> finerPlane{ finer.Samples.data(), { 0, 0 },
      finerCells + std::int64_t{ 1 } };
    const LevelPlane<PyramidNode<float>> nodes{ level.Nodes.data(), { 0, 0 }, cells };
    k == 1 ? ReduceSamplesToNodes<float>(finerPlane, finerCells, nodes)
           : ReduceNodes<float>({ finer.Nodes.data(), { 0, 0 }, finerCells }, finerCells, nodes);
    ReduceSamples<float>(finerPlane, finerCells, { level.Nodes.data(), { 0, 0 }, cells }, cells,
      { level.Samples.data(), { 0, 0 }, samples });
  }
}

//------------------------------------------------------------------------------
PyramidNode<float> RepeatedTiles::GetBounds(const TileKey& key) const
{
  const Level& level = this->Find(key.Level + this->Layout.TileLevel);
  const std::int64_t node = key.Column % level.Cells + level.Cells * (key.Row % level.Cells);
  return ToCodes(level.Nodes[static_cast<std::size_t>(node)], this->Codes);
}

//------------------------------------------------------------------------------
std::string RepeatedTiles::Read(const TileKey& key, Tile& tile) const
{
  if (!this->Layout.Contains(key))
  {
    return "there is no such tile";
  }
  const Level& level = this->Find(key.Level);
  const glm::i64vec2 first = this->Layout.FirstCell(key);
  const glm::i64vec2 count = this->Layout.CellCount(key);
  std::vector<float> samples;
  std::vector<PyramidNode<float>> nodes;
  for (std::int64_t y = first.y; y <= first.y + count.y; ++y)
  {
    for (std::int64_t x = first.x; x <= first.x + count.x; ++x)
    {
      samples.push_back(level.Samples[static_cast<std::size_t>(
        x % level.Cells + (level.Cells + 1) * (y % level.Cells))]);
      if (key.Level > 0 && x < first.x + count.x && y < first.y + count.y)
      {
        nodes.push_back(
          level.Nodes[static_cast<std::size_t>(x % level.Cells + level.Cells * (y % level.Cells))]);
      }
    }
  }
  CutTile<float>(this->Layout, key, { samples.data(), first, count + std::int64_t{ 1 } },
    { nodes.data(), first, count }, this->Codes, tile);
  return {};
}
}
