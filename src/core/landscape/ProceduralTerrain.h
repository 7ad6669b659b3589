// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A procedural mountain landscape of any size, for demonstrations, tests and benchmarks.
 */
#ifndef terrain_ProceduralTerrain_h
#define terrain_ProceduralTerrain_h

#include "core/grid/ParallelFor.h"

#include <cstdint>
#include <vector>

namespace terrain
{
/// What the landscape looks like; heights are in units of Relief.
struct ProceduralTerrainParameters
{
  /// Samples of the whole heightfield east and north, >= 1.
  std::int64_t Width = 1025;
  std::int64_t Height = 1025;
  /// Another seed, another landscape.
  std::uint32_t Seed = 1;
  /// Upper bound of the heights, which begin at 0; > 0.
  double Relief = 2500.0;
  /// Length of the longer side over Relief, > 0: how steep the mountains are is judged by it.
  double Aspect = 16.0;
  /// Depth of the gullies, which are finer than the simulated valleys, 0 (none) to 1; default 0.5.
  double Roughness = 0.5;

  bool operator==(const ProceduralTerrainParameters& other) const
  {
    return this->Width == other.Width && this->Height == other.Height && this->Seed == other.Seed &&
      this->Relief == other.Relief && this->Aspect == other.Aspect &&
      this->Roughness == other.Roughness;
  }
};

/// Heights of a landscape that rivers have shaped.
///
/// The constructor raises mountains on a grid of up to 512 cells along the longer side (and a
/// margin all around, where the water leaves) against the incision of rivers (StreamErosion.h),
/// from 64 cells on in steps of two. A sample is the uniform cubic B-spline of that grid, looked up
/// at a position that noise displaces, so that nothing shows the grid; plus gullies of all sizes
/// from nine cells to five samples (FlowNoiseRow in LatticeNoise.h), which run down the slope,
/// branch, and are as deep as the slope is steep: furrowed flanks, smooth crests and valley floors.
///
/// The longer side holds the same landscape whatever its number of samples; the shorter side shows
/// a part of it. Every sample depends on the parameters and its own indices only: any window equals
/// that part of the whole, whatever the number of threads, to the bit and on every machine (only
/// integers and IEEE 754's +, -, *, / and square root, without contraction).
///
/// Bound: 0 <= height <= Relief. Cost: 1.3 s for the grid (0.1 s for up to 64 samples a side), then
/// about 0.25 us a sample, on one thread.
class ProceduralTerrain
{
public:
  explicit ProceduralTerrain(const ProceduralTerrainParameters& parameters);

  /// Writes the samples (firstI + i, firstJ + j), 0 <= i < width, 0 <= j < height, to
  /// heights[i + width * j], row 0 being the southernmost. Samples outside the whole are not
  /// allowed.
  void Sample(std::int64_t firstI, std::int64_t firstJ, std::int64_t width, std::int64_t height,
    float* heights, const ParallelFor& parallelFor) const;

private:
  struct Row;
  void Simulate();
  void StoreGrid(const std::vector<double>& heights);
  void SampleRow(std::int64_t j, Row& row, float* heights) const;
  void Warp(std::int64_t j, Row& row) const;
  void LookUp(std::int64_t j, Row& row, float* heights) const;
  void Detail(std::int64_t j, Row& row, float* heights) const;

  ProceduralTerrainParameters Parameters;
  std::int64_t Cells = 0;     // of the grid along the longer side, without the margin
  std::int64_t Margin = 0;    // of the grid, in cells
  std::int64_t GridWidth = 0; // nodes with the margin
  std::int64_t GridHeight = 0;
  double CellsPerSample = 1.0;
  std::vector<float> Grid; // height and smooth height of each node, in units of Relief
};
}

#endif
