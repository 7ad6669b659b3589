// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights between the samples of a heightfield. Positions in GC (Coordinates.h), heights in height
 * units; NaN outside the grid and where a sample with weight has no data.
 */
#ifndef terrain_HeightSampling_h
#define terrain_HeightSampling_h

#include "core/grid/Heightfield.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace terrain
{
/// Positions this far beyond the border, in cells, count as on it; weights of that size count as
/// none. Makes up for the rounding of transformations.
constexpr double kSamplingSlack = 1e-6;

/// Cell and fraction in it of a coordinate between 0 and count - 1, one axis at a time.
struct SamplePosition
{
  std::int64_t Cell = 0;
  double Fraction = 0.0;
  bool IsInside = false;
};

inline SamplePosition FindSample(double coordinate, std::int64_t count)
{
  SamplePosition position;
  const double last = static_cast<double>(count - 1);
  if (count < 1 || !(coordinate >= -kSamplingSlack && coordinate <= last + kSamplingSlack))
  {
    return position;
  }
  const double inside = std::clamp(coordinate, 0.0, last);
  position.Cell = std::min(static_cast<std::int64_t>(inside), std::max<std::int64_t>(count - 2, 0));
  position.Fraction = inside - static_cast<double>(position.Cell);
  if (position.Fraction < kSamplingSlack)
  {
    position.Fraction = 0.0;
  }
  else if (position.Fraction > 1.0 - kSamplingSlack)
  {
    position.Fraction = 1.0;
  }
  position.IsInside = true;
  return position;
}

/// The surface itself: the bilinear patch of the cell. Exact. Heights is a HeightfieldView, or has
/// Width, Height and At() as it has.
template <typename Heights>
double SampleBilinear(const Heights& heights, double x, double y)
{
  const SamplePosition i = FindSample(x, heights.Width);
  const SamplePosition j = FindSample(y, heights.Height);
  if (!i.IsInside || !j.IsInside)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::array<double, 2> u{ 1.0 - i.Fraction, i.Fraction };
  const std::array<double, 2> v{ 1.0 - j.Fraction, j.Fraction };
  double sum = 0.0;
  for (std::size_t b = 0; b < 2; ++b)
  {
    for (std::size_t a = 0; a < 2; ++a)
    {
      const double weight = u[a] * v[b];
      if (weight > 0.0)
      {
        sum += weight *
          heights.At(i.Cell + static_cast<std::int64_t>(a), j.Cell + static_cast<std::int64_t>(b));
      }
    }
  }
  return sum;
}

/// Weights of four neighbours at a fraction between the middle two. Source: R. Keys, Cubic
/// convolution interpolation for digital image processing, IEEE Trans. ASSP 29 (1981), Eq. (15)
/// with a = -1/2: exact for quadratic heights.
inline std::array<double, 4> CubicWeights(double t)
{
  const double t2 = t * t;
  const double t3 = t2 * t;
  return { 0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
    0.5 * (-3.0 * t3 + 4.0 * t2 + t), 0.5 * (t3 - t2) };
}

/// Cubic convolution over 4 x 4 samples, smoother than the surface; where one of them lies outside
/// or has no data, the bilinear patch.
template <typename T>
double SampleCubic(const HeightfieldView<T>& heights, double x, double y)
{
  const SamplePosition i = FindSample(x, heights.Width);
  const SamplePosition j = FindSample(y, heights.Height);
  if (!i.IsInside || !j.IsInside || i.Cell < 1 || j.Cell < 1 || i.Cell + 2 >= heights.Width ||
    j.Cell + 2 >= heights.Height)
  {
    return SampleBilinear(heights, x, y);
  }
  const std::array<double, 4> u = CubicWeights(i.Fraction);
  const std::array<double, 4> v = CubicWeights(j.Fraction);
  double sum = 0.0;
  for (std::int64_t b = 0; b < 4; ++b)
  {
    double row = 0.0;
    for (std::int64_t a = 0; a < 4; ++a)
    {
      row += u[static_cast<std::size_t>(a)] * heights.At(i.Cell - 1 + a, j.Cell - 1 + b);
    }
    sum += v[static_cast<std::size_t>(b)] * row;
  }
  return std::isnan(sum) ? SampleBilinear(heights, x, y) : sum;
}
}

#endif
