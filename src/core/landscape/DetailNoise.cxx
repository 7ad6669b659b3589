// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/landscape/DetailNoise.h"

#include "core/landscape/LatticeNoise.h"

#include <algorithm>
#include <cstddef>

namespace terrain
{
namespace
{
constexpr int kFewestLatticeCells = 4; // of the lattice of the first octave
constexpr int kShortestSamples = 4;    // length of the last octave's lattice cells
constexpr int kSmoothOctaves = 2;      // before those that are folded
constexpr float kFalloff = 0.55F;      // amplitude of an octave over that of the one before

/// Adds the row of an octave whose lattice has cells x cells cells over the period.
void AddOctaveRow(int size, int row, std::int64_t cells, bool folded, std::uint32_t seed,
  float amplitude, float* heights)
{
  const double step = static_cast<double>(cells) / size;
  const LatticeAxis axis(0, size, 0.0, step);
  const LatticeAxis here(row, 1, 0.0, step);
  std::vector<float> values(static_cast<std::size_t>(size));
  NoiseRow(axis, here.Cells[0], here.Offsets[0], seed, values.data(), cells);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const float value = values[i];
    const float ridge = 0.25F - (value < 0.0F ? -value : value);
    heights[i] += amplitude * (folded ? ridge : value);
  }
}

/// Moves and scales heights to span -0.5 to 0.5.
void Normalize(std::vector<float>& heights)
{
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const float low = *lowest;
  const float span = *highest - low;
  for (float& height : heights)
  {
    height = span > 0.0F ? (height - low) / span - 0.5F : 0.0F;
  }
}
}

//------------------------------------------------------------------------------
std::vector<float> MakeDetailNoise(int size, std::uint32_t seed, const ParallelFor& parallelFor)
{
  std::vector<float> heights(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  parallelFor(size,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        float amplitude = 1.0F;
        int octave = 0;
        for (std::int64_t cells = kFewestLatticeCells; cells * kShortestSamples <= size; cells *= 2)
        {
          AddOctaveRow(size, static_cast<int>(row), cells, octave >= kSmoothOctaves,
            seed + static_cast<std::uint32_t>(octave), amplitude, heights.data() + row * size);
          amplitude *= kFalloff;
          ++octave;
        }
      }
    });
  Normalize(heights);
  return heights;
}
}
