// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gradient noise on the integer lattice, evaluated row by row: the same bits on every machine.
 *
 * Only integer arithmetic and the correctly rounded +, -, * of IEEE 754 are used, no function of
 * libm; the files that include this are compiled without contraction to fused operations.
 */
#ifndef terrain_LatticeNoise_h
#define terrain_LatticeNoise_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrain
{
/// Bijective mixing of 32 bits (constants by C. Wellons, "Prospecting for Hash Functions", 2018).
inline std::uint32_t Mix(std::uint32_t value)
{
  value ^= value >> 16;
  value *= 0x7feb352dU;
  value ^= value >> 15;
  value *= 0x846ca68bU;
  value ^= value >> 16;
  return value;
}

/// 32 random bits of lattice node (x, y) and a seed.
inline std::uint32_t LatticeHash(std::int64_t x, std::int64_t y, std::uint32_t seed)
{
  const std::uint32_t row = Mix(static_cast<std::uint32_t>(y) + 0x9e3779b9U * seed);
  return Mix(static_cast<std::uint32_t>(x) ^ row);
}

/// Uniform in [0, 1) from 32 random bits (the upper 24 of them).
inline double UnitReal(std::uint32_t bits)
{
  return static_cast<double>(bits >> 8) * (1.0 / 16777216.0);
}

/// Positions along one axis of the lattice: cell and offset in it, for first <= k < first + count.
struct LatticeAxis
{
  std::vector<std::int64_t> Cells;
  std::vector<float> Offsets;

  /// Sample k lies at origin + k * step, in lattice cells; the same whatever first and count are.
  LatticeAxis(std::int64_t first, std::int64_t count, double origin, double step)
    : Cells(static_cast<std::size_t>(count))
    , Offsets(static_cast<std::size_t>(count))
  {
    for (std::int64_t k = 0; k < count; ++k)
    {
      const double position = origin + static_cast<double>(first + k) * step;
      std::int64_t cell = static_cast<std::int64_t>(position);
      cell -= static_cast<double>(cell) > position ? 1 : 0;
      this->Cells[static_cast<std::size_t>(k)] = cell;
      this->Offsets[static_cast<std::size_t>(k)] =
        static_cast<float>(position - static_cast<double>(cell));
    }
  }
};

/// Gradient of a lattice node; both components in [-1, 1).
struct LatticeGradient
{
  float X;
  float Y;

  LatticeGradient(std::int64_t x, std::int64_t y, std::uint32_t seed)
  {
    const std::uint32_t bits = LatticeHash(x, y, seed);
    this->X = static_cast<float>(static_cast<std::int32_t>(bits & 0xffffU) - 32768) / 32768.0F;
    this->Y = static_cast<float>(static_cast<std::int32_t>(bits >> 16) - 32768) / 32768.0F;
  }
};

/// Smooth step with zero first and second derivatives at 0 and 1 (Perlin 2002, "Improving Noise").
inline float Fade(float t)
{
  return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

/// Noise at the samples of one row, written to values[0 .. axis.Cells.size()); every value lies in
/// [-1, 1], with a mean of 0 and a standard deviation of about 0.25. With a period the noise
/// repeats after that many lattice cells in both directions; cells are then >= 0. Source: Perlin
/// 1985, "An Image Synthesizer", in two dimensions.
inline void NoiseRow(const LatticeAxis& axis, std::int64_t cellY, float offsetY, std::uint32_t seed,
  float* values, std::int64_t period = 0)
{
  const auto gradient = [&](std::int64_t x, std::int64_t y)
  {
    return period > 0 ? LatticeGradient(x % period, y % period, seed) : LatticeGradient(x, y, seed);
  };
  const std::size_t count = axis.Cells.size();
  const float fadeY = Fade(offsetY);
  std::size_t begin = 0;
  while (begin < count)
  {
    const std::int64_t cell = axis.Cells[begin];
    std::size_t end = begin + 1;
    while (end < count && axis.Cells[end] == cell)
    {
      ++end;
    }
    const LatticeGradient g00 = gradient(cell, cellY);
    const LatticeGradient g10 = gradient(cell + 1, cellY);
    const LatticeGradient g01 = gradient(cell, cellY + 1);
    const LatticeGradient g11 = gradient(cell + 1, cellY + 1);
    const float* offsets = axis.Offsets.data();
    for (std::size_t k = begin; k < end; ++k)
    {
      const float x = offsets[k];
      const float fadeX = Fade(x);
      const float v00 = g00.X * x + g00.Y * offsetY;
      const float v10 = g10.X * (x - 1.0F) + g10.Y * offsetY;
      const float v01 = g01.X * x + g01.Y * (offsetY - 1.0F);
      const float v11 = g11.X * (x - 1.0F) + g11.Y * (offsetY - 1.0F);
      const float south = v00 + fadeX * (v10 - v00);
      const float north = v01 + fadeX * (v11 - v01);
      values[k] = south + fadeY * (north - south);
    }
    begin = end;
  }
}

/// Largest error of PeriodicCosine().
constexpr float kPeriodicCosineError = 0.021F;

/// cos(2 pi x) within kPeriodicCosineError, of period 1 to the bit, for |x| < 2^31: a cubic of a
/// triangle wave.
inline float PeriodicCosine(float x)
{
  const float part =
    x - static_cast<float>(static_cast<std::int32_t>(x)); // (-1, 1), cosine is even
  const float magnitude = part < 0.0F ? -part : part;
  const float half = magnitude - 0.5F;
  const float triangle = 4.0F * (half < 0.0F ? -half : half) - 1.0F;
  return triangle * (1.5F - 0.5F * triangle * triangle);
}

/// Waves across a direction of flow that changes from sample to sample: gullies down a slope.
///
/// About the four lattice nodes around a sample, waves of one cell's length run along (acrossX,
/// acrossY)[k] (unit vectors, lattice axes) with a random phase each; blended, they give values[k],
/// in [-1, 1], and rates[k], their change per cell in that direction, over 2 pi.
/// Source: the idea of Phacelle noise (R. Johansen 2025, after C. John's erosion noise), here with
/// the four nearest nodes and a polynomial wave.
inline void FlowNoiseRow(const LatticeAxis& axis, std::int64_t cellY, float offsetY,
  std::uint32_t seed, const float* acrossX, const float* acrossY, float* values, float* rates)
{
  const std::size_t count = axis.Cells.size();
  const float fadeY = Fade(offsetY);
  std::size_t begin = 0;
  while (begin < count)
  {
    const std::int64_t cell = axis.Cells[begin];
    std::size_t end = begin + 1;
    while (end < count && axis.Cells[end] == cell)
    {
      ++end;
    }
    float phases[4];
    for (std::size_t node = 0; node < 4; ++node)
    {
      const auto x = static_cast<std::int64_t>(node % 2);
      const auto y = static_cast<std::int64_t>(node / 2);
      phases[node] = static_cast<float>(UnitReal(LatticeHash(cell + x, cellY + y, seed)));
    }
    const float* offsets = axis.Offsets.data();
    for (std::size_t k = begin; k < end; ++k)
    {
      const float x = offsets[k];
      const float fadeX = Fade(x);
      // Distance from node (0, 0) along the wave; the other nodes lie a step further.
      const float along = acrossX[k] * x + acrossY[k] * offsetY;
      const float p00 = along + phases[0];
      const float p10 = along - acrossX[k] + phases[1];
      const float p01 = along - acrossY[k] + phases[2];
      const float p11 = along - acrossX[k] - acrossY[k] + phases[3];
      const float w00 = (1.0F - fadeX) * (1.0F - fadeY);
      const float w10 = fadeX * (1.0F - fadeY);
      const float w01 = (1.0F - fadeX) * fadeY;
      const float w11 = fadeX * fadeY;
      values[k] = w00 * PeriodicCosine(p00) + w10 * PeriodicCosine(p10) +
        w01 * PeriodicCosine(p01) + w11 * PeriodicCosine(p11);
      rates[k] = w00 * PeriodicCosine(p00 + 0.25F) + w10 * PeriodicCosine(p10 + 0.25F) +
        w01 * PeriodicCosine(p01 + 0.25F) + w11 * PeriodicCosine(p11 + 0.25F);
    }
    begin = end;
  }
}
}

#endif
