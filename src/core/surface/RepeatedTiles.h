// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A heightfield of any size without a file: a small one, repeated. For tests and benchmarks.
 */
#ifndef terrain_RepeatedTiles_h
#define terrain_RepeatedTiles_h

#include "core/grid/ParallelFor.h"
#include "core/surface/TileSource.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace terrain
{
/// Samples of a heightfield of (n + 1) x (n + 1) samples, row by row, and their mirror images to
/// the east and north: (2 n + 1) x (2 n + 1) samples, the last row and column of which are the
/// first. Levels of it are mirrored too, so that copies of it meet on all levels.
template <typename T>
std::vector<T> MirrorSamples(const std::vector<T>& samples, std::int64_t n)
{
  std::vector<T> mirrored;
  mirrored.reserve(static_cast<std::size_t>((2 * n + 1) * (2 * n + 1)));
  for (std::int64_t j = 0; j <= 2 * n; ++j)
  {
    for (std::int64_t i = 0; i <= 2 * n; ++i)
    {
      const std::int64_t x = i <= n ? i : 2 * n - i;
      const std::int64_t y = j <= n ? j : 2 * n - j;
      mirrored.push_back(samples[static_cast<std::size_t>(x + (n + 1) * y)]);
    }
  }
  return mirrored;
}

class RepeatedTiles : public TileSource
{
public:
  /// Repeats a period so many times east and north. It has 2^m + 1 samples a side, all with a
  /// height, and is its own mirror image: MirrorSamples().
  RepeatedTiles(std::vector<float> period, int m, std::int64_t times, int tileLevel,
    const ParallelFor& parallelFor);

  TileLayout GetLayout() const override
  {
    return this->Layout;
  }
  HeightCodes GetCodes() const override
  {
    return this->Codes;
  }
  bool AreBoundsTrue() const override
  {
    return true;
  }
  PyramidNode<float> GetBounds(const TileKey& key) const override;
  std::string Read(const TileKey& key, Tile& tile) const override;

private:
  /// A level of the period.
  struct Level
  {
    std::int64_t Cells = 1;
    std::vector<float> Samples;
    std::vector<PyramidNode<float>> Nodes;
  };
  const Level& Find(int level) const
  {
    return this->Levels[std::min(static_cast<std::size_t>(level), this->Levels.size() - 1)];
  }

  TileLayout Layout;
  HeightCodes Codes;
  std::vector<Level> Levels; // up to the one of a single cell
};
}

#endif
