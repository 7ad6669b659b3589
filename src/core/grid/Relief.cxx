// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/Relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace terrain
{
namespace
{
/// Parts of the samples that do not count, at both ends.
constexpr double kOutliers = 0.02;

/// The one of the round factors that is nearest by its ratio.
double RoundFactor(double factor)
{
  constexpr std::array<double, 6> kSteps = { 1.0, 1.5, 2.0, 3.0, 5.0, 7.0 };
  constexpr int kPowers = 3;
  double best = 1.0;
  double least = std::abs(std::log(factor));
  for (int power = -kPowers; power <= kPowers; ++power)
  {
    for (const double step : kSteps)
    {
      const double candidate = power == kPowers ? 1e3 : step * std::pow(10.0, power);
      const double distance = std::abs(std::log(factor / candidate));
      if (distance < least)
      {
        least = distance;
        best = candidate;
      }
    }
  }
  return best;
}

void KeepFinite(std::vector<double>& samples)
{
  samples.erase(std::remove_if(samples.begin(), samples.end(),
                  [](double sample) { return !std::isfinite(sample); }),
    samples.end());
}

/// What a part of the samples, from 0 to 1, lies below.
double SampleAt(std::vector<double>& samples, double part)
{
  const auto last = static_cast<double>(samples.size() - 1);
  const auto place = samples.begin() + static_cast<std::ptrdiff_t>(std::lround(part * last));
  std::nth_element(samples.begin(), place, samples.end());
  return *place;
}
}

//------------------------------------------------------------------------------
double ReliefOf(std::vector<double>& samples)
{
  KeepFinite(samples);
  if (samples.size() < 2)
  {
    return 0.0;
  }
  const double low = SampleAt(samples, kOutliers);
  return SampleAt(samples, 1.0 - kOutliers) - low;
}

//------------------------------------------------------------------------------
double SuggestExaggeration(double relief, double extent)
{
  const double share = relief / extent;
  if (!(relief > 0.0) || !(extent > 0.0) || !std::isfinite(share) || !(share > 0.0))
  {
    return 1.0;
  }
  if (share > kSteepestRelief)
  {
    return RoundFactor(kSteepestRelief / share);
  }
  constexpr double kExponent = 0.6;
  return share >= kSeenRelief ? 1.0 : RoundFactor(std::pow(kSeenRelief / share, kExponent));
}

//------------------------------------------------------------------------------
double SuggestSteepest(std::vector<double>& slopes)
{
  constexpr double kOfNone = 60.0;
  constexpr double kStep = 5.0;
  constexpr double kMost = 90.0;
  KeepFinite(slopes);
  if (slopes.empty())
  {
    return kOfNone;
  }
  const double steep = SampleAt(slopes, 1.0 - kOutliers);
  for (const double gentle : { 0.1, 0.2, 0.5, 1.0, 2.0 })
  {
    if (steep <= gentle)
    {
      return gentle;
    }
  }
  return std::min(kStep * std::ceil(steep / kStep), kMost);
}
}
