// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples of a level of a tile source as rows of a rectangle, and which level fits into limits.
 */
#ifndef terrain_LevelSamples_h
#define terrain_LevelSamples_h

#include "core/grid/ParallelFor.h"
#include "core/surface/TileSource.h"

#include <functional>
#include <string>

namespace terrain
{
/// Takes `count` codes of a row from sample (x, y) of the level on; called by several threads.
using TakeCodes =
  std::function<void(std::int64_t x, std::int64_t y, std::int64_t count, const float* codes)>;

/// Hands out the samples [first, first + size) of a level, each once, tile by tile. `progress` is
/// called with the share that is done, by one thread at a time, and returns false to stop. Returns
/// an error message, empty if all is well or stopped.
std::string ReadLevel(const TileSource& source, int level, glm::i64vec2 first, glm::i64vec2 size,
  const ParallelFor& parallelFor, const std::function<bool(double)>& progress,
  const TakeCodes& take);

/// The finest level with at most so many samples along a side and in all; 0 is no limit. The top
/// level where none is small enough.
int FindLevel(const TileLayout& layout, std::int64_t mostAlongSide, std::int64_t mostSamples);
}

#endif
