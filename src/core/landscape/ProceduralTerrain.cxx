// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/landscape/ProceduralTerrain.h"

#include "core/landscape/LatticeNoise.h"
#include "core/landscape/StreamErosion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace terrain
{
namespace
{
// Cells along the longer side at which the simulation begins, and at which it ends at the latest.
constexpr std::int64_t kCoarsestCells = 64;
constexpr std::int64_t kFinestCells = 512;
// Share of the longer side that is added on every side.
constexpr std::int64_t kMarginDivisor = 8;
// The shorter side never has fewer cells at the coarsest grid.
constexpr std::int64_t kFewestCells = 8;
// The grid's heights end here, in units of Relief; the rest on both sides is for detail.
constexpr double kGridLow = 0.05;
constexpr double kGridHigh = 0.95;
// Gullies: sizes from this many cells down to this many samples, and height over size and slope.
constexpr double kCoarsestGully = 9.0;
constexpr double kFinestGully = 5.0;
constexpr double kGullyStrength = 0.22;
constexpr double kGullyGain = 0.85; // of the next finer ones, beyond that for their size
// Passes of smoothing before the slope is taken: gullies end where it turns, at crests and
// thalwegs.
constexpr int kSmoothings = 5;
constexpr float kPi = 3.14159265F;
// Steepest slope of the simulation, rise over run.
constexpr double kSteepestSlope = 0.75;
// Rate of uplift, in units of Relief a unit of time: low enough for rivers to shape all but the
// crests.
constexpr double kUpliftScale = 0.2;
// Displacement of positions: sizes from this share of the longer side down to this many cells, and
// the largest displacement over size.
constexpr double kCoarsestWarp = 0.18;
constexpr double kFinestWarp = 1.2;
constexpr double kWarpStrength = 0.36;
constexpr double kWarpGain = 0.8; // of the next finer one, likewise
// Seeds of independent noises.
constexpr std::uint32_t kUpliftSeed = 0x5eed0001U;
constexpr std::uint32_t kUndulateSeed = 0x5eed0010U;
constexpr std::uint32_t kRefineSeed = 0x5eed0002U;
constexpr std::uint32_t kWarpSeed = 0x5eed0003U;
constexpr std::uint32_t kDetailSeed = 0x5eed0004U;

/// Noise at one position; see NoiseRow.
double Noise(double x, double y, std::uint32_t seed)
{
  const LatticeAxis column(0, 1, x, 0.0);
  const LatticeAxis row(0, 1, y, 0.0);
  float value = 0.0F;
  NoiseRow(column, row.Cells[0], row.Offsets[0], seed, &value);
  return static_cast<double>(value);
}

/// Rate of uplift at a position, in units of the longer side: ranges and basins, 0.15 to 1.
double UpliftRate(double x, double y, std::uint32_t seed)
{
  const double warpX = x + 0.25 * Noise(2.1 * x, 2.1 * y, seed + 1);
  const double warpY = y + 0.25 * Noise(2.1 * x, 2.1 * y, seed + 2);
  const double broad = Noise(1.7 * warpX, 1.7 * warpY, seed + 3);
  const double range = 1.0 - 2.6 * std::fabs(Noise(2.6 * warpX, 2.6 * warpY, seed + 4));
  const double rate = 0.45 + 0.7 * broad + 0.4 * range;
  return std::clamp(rate, 0.12, 1.0);
}

/// The simulation on a grid of `cells` cells along the longer side; positions in units of that
/// side.
struct Level
{
  std::int64_t Cells;
  StreamErosion Erosion;

  Level(std::int64_t cells, std::int64_t width, std::int64_t height, double reliefOverLength,
    std::uint32_t seed)
    : Cells(cells)
    , Erosion(width, height, 1.0 / static_cast<double>(cells), seed)
  {
    this->Erosion.SteepestSlope = kSteepestSlope;
    const auto n = static_cast<double>(cells);
    for (std::int64_t j = 1; j < height - 1; ++j)
    {
      for (std::int64_t i = 1; i < width - 1; ++i)
      {
        const double rate = UpliftRate(
          static_cast<double>(i) / n, static_cast<double>(j) / n, Mix(seed ^ kUpliftSeed));
        this->Erosion.Uplift[static_cast<std::size_t>(i + width * j)] =
          rate * kUpliftScale * reliefOverLength;
      }
    }
  }

  /// Broad random relief, so that the first rivers wind.
  void Undulate(double amplitude, std::uint32_t seed)
  {
    const std::int64_t width = this->Erosion.GetWidth();
    for (std::int64_t j = 1; j < this->Erosion.GetHeight() - 1; ++j)
    {
      for (std::int64_t i = 1; i < width - 1; ++i)
      {
        double size = 0.31;
        double sum = 0.0;
        double share = 1.0;
        for (std::uint32_t k = 0; k < 4; ++k, size *= 0.47, share *= 0.6)
        {
          const double scale = 1.0 / (size * static_cast<double>(this->Cells));
          sum += share *
            Noise(static_cast<double>(i) * scale, static_cast<double>(j) * scale, Mix(seed + k));
        }
        this->Erosion.Heights[static_cast<std::size_t>(i + width * j)] +=
          amplitude * std::max(0.0, sum + 0.5);
      }
    }
  }

  /// A little random relief, so that finer rivers have somewhere to go.
  void Roughen(double amplitude, std::uint32_t seed)
  {
    const std::int64_t width = this->Erosion.GetWidth();
    for (std::int64_t j = 1; j < this->Erosion.GetHeight() - 1; ++j)
    {
      for (std::int64_t i = 1; i < width - 1; ++i)
      {
        this->Erosion.Heights[static_cast<std::size_t>(i + width * j)] +=
          amplitude * UnitReal(LatticeHash(i, j, seed));
      }
    }
  }

  /// Takes the heights of a level of half as many cells.
  void Refine(const Level& coarse)
  {
    const std::int64_t width = this->Erosion.GetWidth();
    const std::int64_t coarseWidth = coarse.Erosion.GetWidth();
    for (std::int64_t j = 0; j < this->Erosion.GetHeight(); ++j)
    {
      for (std::int64_t i = 0; i < width; ++i)
      {
        const auto at = [&](std::int64_t x, std::int64_t y)
        { return coarse.Erosion.Heights[static_cast<std::size_t>(x + coarseWidth * y)]; };
        const std::int64_t x0 = i / 2;
        const std::int64_t y0 = j / 2;
        const std::int64_t x1 = x0 + i % 2;
        const std::int64_t y1 = y0 + j % 2;
        this->Erosion.Heights[static_cast<std::size_t>(i + width * j)] =
          0.25 * ((at(x0, y0) + at(x1, y0)) + (at(x0, y1) + at(x1, y1)));
      }
    }
  }

  void Run(int steps, double timeStep)
  {
    for (int step = 0; step < steps; ++step)
    {
      this->Erosion.Step(timeStep);
    }
  }
};

/// Binomial weights 1 2 1 along one axis of a grid, whose nodes lie `step` apart in memory and
/// number `count`; the first and last ones stay.
void Smooth(std::vector<double>& heights, std::int64_t step, std::int64_t count)
{
  const std::vector<double> before = heights;
  const auto size = static_cast<std::int64_t>(heights.size());
  for (std::int64_t node = 0; node < size; ++node)
  {
    const std::int64_t k = node / step % count;
    if (k > 0 && k < count - 1)
    {
      heights[static_cast<std::size_t>(node)] = 0.5 * before[static_cast<std::size_t>(node)] +
        0.25 *
          (before[static_cast<std::size_t>(node - step)] +
            before[static_cast<std::size_t>(node + step)]);
    }
  }
}

/// Weights of the uniform cubic B-spline at offset t in [0, 1) of a cell (their sum is 1), and
/// their derivatives.
struct SplineWeights
{
  std::array<float, 4> Values;
  std::array<float, 4> Slopes;

  explicit SplineWeights(float t)
  {
    const float s = 1.0F - t;
    const float sixth = 1.0F / 6.0F;
    this->Values = { s * s * s * sixth, (3.0F * t * t * t - 6.0F * t * t + 4.0F) * sixth,
      (3.0F * s * s * s - 6.0F * s * s + 4.0F) * sixth, t * t * t * sixth };
    this->Slopes = { -0.5F * s * s, 1.5F * t * t - 2.0F * t, -1.5F * s * s + 2.0F * s,
      0.5F * t * t };
  }
};
}

ProceduralTerrain::ProceduralTerrain(const ProceduralTerrainParameters& parameters)
  : Parameters(parameters)
{
  const std::int64_t longer = std::max(parameters.Width, parameters.Height);
  const std::int64_t shorter = std::min(parameters.Width, parameters.Height);
  this->Cells = kCoarsestCells;
  while (this->Cells < kFinestCells && this->Cells < longer)
  {
    this->Cells *= 2;
  }
  const std::int64_t longerCells = std::max<std::int64_t>(longer - 1, 1);
  this->CellsPerSample = static_cast<double>(this->Cells) / static_cast<double>(longerCells);
  this->Margin = this->Cells / kMarginDivisor;
  // In coarsest cells, so that every level covers the same area.
  const std::int64_t scale = this->Cells / kCoarsestCells;
  const std::int64_t coarseShorter =
    std::max((kCoarsestCells * (shorter - 1) + longerCells - 1) / longerCells, kFewestCells);
  const std::int64_t shorterCells = coarseShorter * scale;
  const bool wide = parameters.Width >= parameters.Height;
  this->GridWidth = (wide ? this->Cells : shorterCells) + 2 * this->Margin + 1;
  this->GridHeight = (wide ? shorterCells : this->Cells) + 2 * this->Margin + 1;
  this->Simulate();
}

void ProceduralTerrain::Simulate()
{
  const double reliefOverLength = 1.0 / this->Parameters.Aspect;
  const std::uint32_t seed = Mix(this->Parameters.Seed);
  const auto makeLevel = [&](std::int64_t cells)
  {
    const std::int64_t ratio = this->Cells / cells;
    return Level(cells, (this->GridWidth - 1) / ratio + 1, (this->GridHeight - 1) / ratio + 1,
      reliefOverLength, seed);
  };
  Level level = makeLevel(kCoarsestCells);
  level.Undulate(1.0 * reliefOverLength, Mix(seed ^ kUndulateSeed));
  level.Roughen(0.02 * reliefOverLength, seed ^ kRefineSeed);
  level.Run(60, 0.3);
  while (level.Cells < this->Cells)
  {
    Level finer = makeLevel(2 * level.Cells);
    finer.Refine(level);
    finer.Roughen(1.0 * reliefOverLength / static_cast<double>(finer.Cells), seed ^ kRefineSeed);
    finer.Run(static_cast<int>(24 * kCoarsestCells / level.Cells) + 4, 0.1);
    level = std::move(finer);
  }
  this->StoreGrid(level.Erosion.Heights);
}

// Heights to units of Relief, beside each the smooth one that leads the gullies; with room for
// detail on both sides.
void ProceduralTerrain::StoreGrid(const std::vector<double>& heights)
{
  const double highest = *std::max_element(heights.begin(), heights.end());
  const double scale = highest > 0.0 ? (kGridHigh - kGridLow) / highest : 0.0;
  std::vector<double> smooth = heights;
  for (int pass = 0; pass < kSmoothings; ++pass)
  {
    Smooth(smooth, 1, this->GridWidth);
    Smooth(smooth, this->GridWidth, this->GridHeight);
  }
  this->Grid.resize(2 * heights.size());
  for (std::size_t node = 0; node < heights.size(); ++node)
  {
    this->Grid[2 * node] = static_cast<float>(kGridLow + scale * heights[node]);
    this->Grid[2 * node + 1] = static_cast<float>(scale * smooth[node]);
  }
}

/// What the rows of one window share: positions on the axes of each noise, and scratch rows.
struct ProceduralTerrain::Row
{
  struct Octave
  {
    LatticeAxis Axis;
    double Step;   // lattice cells a sample
    double Origin; // lattice position of sample 0, both axes
    float Amplitude;
    std::uint32_t Seed;
  };

  std::int64_t FirstI;
  std::int64_t Count;
  std::vector<Octave> Warps;   // for x and y in turn, coarsest first
  std::vector<Octave> Details; // coarsest first
  std::vector<float> Noise;
  std::vector<float> Rate;
  std::vector<float> WarpX; // in cells of the grid, as all that follows
  std::vector<float> WarpY;
  std::vector<float> AcrossX; // unit vector across the slope
  std::vector<float> AcrossY;
  std::vector<float> SlopeX; // of the detail so far too
  std::vector<float> SlopeY;
  std::vector<float> Steepness; // of the smooth grid

  Octave MakeOctave(double size, double cellsPerSample, float amplitude, std::uint32_t seed) const
  {
    const double step = cellsPerSample / size;
    // Another place of the lattice for each octave: zeros of the noise never coincide.
    const double origin = 1000.0 + 64.0 * UnitReal(seed);
    return { LatticeAxis(this->FirstI, this->Count, origin, step), step, origin, amplitude, seed };
  }

  Row(const ProceduralTerrain& owner, std::int64_t firstI, std::int64_t count)
    : FirstI(firstI)
    , Count(count)
  {
    const std::uint32_t seed = Mix(owner.Parameters.Seed);
    const double cellsPerSample = owner.CellsPerSample;
    std::uint32_t warp = 0;
    double strength = kWarpStrength;
    for (double size = kCoarsestWarp * static_cast<double>(owner.Cells); size > kFinestWarp;
         size /= 3.0)
    {
      for (int axis = 0; axis < 2; ++axis, ++warp)
      {
        this->Warps.push_back(this->MakeOctave(size, cellsPerSample,
          static_cast<float>(strength * size), Mix(seed ^ (kWarpSeed + warp))));
      }
      strength *= kWarpGain;
    }
    double gain = 1.0;
    std::uint32_t k = 0;
    for (double size = kCoarsestGully; size > kFinestGully * cellsPerSample; size *= 0.5)
    {
      this->Details.push_back(this->MakeOctave(
        size, cellsPerSample, static_cast<float>(gain * size), Mix(seed ^ (kDetailSeed + k))));
      gain *= kGullyGain;
      ++k;
    }
    const auto n = static_cast<std::size_t>(count);
    for (std::vector<float>* row : { &this->Noise, &this->Rate, &this->WarpX, &this->WarpY,
           &this->AcrossX, &this->AcrossY, &this->SlopeX, &this->SlopeY, &this->Steepness })
    {
      row->resize(n);
    }
  }

  /// The octave's noise along row j, in this->Noise.
  void Evaluate(const Octave& octave, std::int64_t j)
  {
    const LatticeAxis axis(j, 1, octave.Origin, octave.Step);
    NoiseRow(octave.Axis, axis.Cells[0], axis.Offsets[0], octave.Seed, this->Noise.data());
  }
};

// Where noise moves the samples of the row, before they are looked up in the grid.
void ProceduralTerrain::Warp(std::int64_t j, Row& row) const
{
  const auto n = static_cast<std::size_t>(row.Count);
  std::fill(row.WarpX.begin(), row.WarpX.end(), 0.0F);
  std::fill(row.WarpY.begin(), row.WarpY.end(), 0.0F);
  for (std::size_t w = 0; w < row.Warps.size(); ++w)
  {
    row.Evaluate(row.Warps[w], j);
    std::vector<float>& warp = w % 2 == 0 ? row.WarpX : row.WarpY;
    for (std::size_t k = 0; k < n; ++k)
    {
      warp[k] += row.Warps[w].Amplitude * row.Noise[k];
    }
  }
}

// Height of the grid's spline, and slope of the smooth one, at the samples of the row.
void ProceduralTerrain::LookUp(std::int64_t j, Row& row, float* heights) const
{
  const auto margin = static_cast<double>(this->Margin);
  const double y = margin + static_cast<double>(j) * this->CellsPerSample;
  // Within the grid even if every noise were at its bound.
  const auto lastX = static_cast<double>(this->GridWidth - 3);
  const auto lastY = static_cast<double>(this->GridHeight - 3);
  for (std::size_t k = 0; k < static_cast<std::size_t>(row.Count); ++k)
  {
    const auto i = static_cast<double>(row.FirstI + static_cast<std::int64_t>(k));
    const double u =
      std::clamp(margin + i * this->CellsPerSample + static_cast<double>(row.WarpX[k]), 1.0, lastX);
    const double v = std::clamp(y + static_cast<double>(row.WarpY[k]), 1.0, lastY);
    const auto x0 = static_cast<std::int64_t>(u);
    const auto y0 = static_cast<std::int64_t>(v);
    const SplineWeights wx(static_cast<float>(u - static_cast<double>(x0)));
    const SplineWeights wy(static_cast<float>(v - static_cast<double>(y0)));
    float height = 0.0F;
    float slopeX = 0.0F;
    float slopeY = 0.0F;
    const float* node =
      &this->Grid[static_cast<std::size_t>(2 * (x0 - 1 + this->GridWidth * (y0 - 1)))];
    for (std::size_t b = 0; b < 4; ++b, node += 2 * this->GridWidth)
    {
      height += wy.Values[b] *
        (wx.Values[0] * node[0] + wx.Values[1] * node[2] + wx.Values[2] * node[4] +
          wx.Values[3] * node[6]);
      slopeX += wy.Values[b] *
        (wx.Slopes[0] * node[1] + wx.Slopes[1] * node[3] + wx.Slopes[2] * node[5] +
          wx.Slopes[3] * node[7]);
      slopeY += wy.Slopes[b] *
        (wx.Values[0] * node[1] + wx.Values[1] * node[3] + wx.Values[2] * node[5] +
          wx.Values[3] * node[7]);
    }
    heights[k] = height;
    row.SlopeX[k] = slopeX;
    row.SlopeY[k] = slopeY;
    row.Steepness[k] = std::sqrt(slopeX * slopeX + slopeY * slopeY);
  }
}

// Gullies down the slope, each size down the slope that the coarser ones have left: they branch.
void ProceduralTerrain::Detail(std::int64_t j, Row& row, float* heights) const
{
  const auto n = static_cast<std::size_t>(row.Count);
  const auto strength = static_cast<float>(kGullyStrength * this->Parameters.Roughness);
  for (const Row::Octave& octave : row.Details)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      const float x = row.SlopeX[k];
      const float y = row.SlopeY[k];
      const float inverse = 1.0F / std::sqrt(x * x + y * y + 1e-12F);
      row.AcrossX[k] = -y * inverse;
      row.AcrossY[k] = x * inverse;
    }
    const LatticeAxis axis(j, 1, octave.Origin, octave.Step);
    FlowNoiseRow(octave.Axis, axis.Cells[0], axis.Offsets[0], octave.Seed, row.AcrossX.data(),
      row.AcrossY.data(), row.Noise.data(), row.Rate.data());
    for (std::size_t k = 0; k < n; ++k)
    {
      const float amplitude = strength * row.Steepness[k];
      const float rate = 2.0F * kPi * amplitude * row.Rate[k];
      heights[k] += amplitude * octave.Amplitude * row.Noise[k];
      row.SlopeX[k] += rate * row.AcrossX[k];
      row.SlopeY[k] += rate * row.AcrossY[k];
    }
  }
}

void ProceduralTerrain::SampleRow(std::int64_t j, Row& row, float* heights) const
{
  this->Warp(j, row);
  this->LookUp(j, row, heights);
  this->Detail(j, row, heights);
  const auto relief = static_cast<float>(this->Parameters.Relief);
  for (std::int64_t k = 0; k < row.Count; ++k)
  {
    heights[k] = relief * std::clamp(heights[k], 0.0F, 1.0F);
  }
}

void ProceduralTerrain::Sample(std::int64_t firstI, std::int64_t firstJ, std::int64_t width,
  std::int64_t height, float* heights, const ParallelFor& parallelFor) const
{
  if (width < 1 || height < 1)
  {
    return;
  }
  parallelFor(height,
    [&](std::int64_t begin, std::int64_t end)
    {
      Row row(*this, firstI, width);
      for (std::int64_t j = begin; j < end; ++j)
      {
        this->SampleRow(firstJ + j, row, heights + width * j);
      }
    });
}
}
