// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterHoles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace terrain
{
namespace
{
// Beyond this values are fill in any case, and need not be found.
constexpr double kLeastCertainFill = 1e30;
// Of the widest gap between two other values; of their range.
constexpr double kShareOfGaps = 5.0;
constexpr double kShareOfRange = 0.2;
// Values beyond this are no heights in metres, whatever they are called; so far from all others, in
// ranges of those, they are fill.
constexpr double kBeyondHeights = 2e4;
constexpr double kFarAway = 3.0;

/// Values that programs fill with, without their sign.
bool IsUsualFill(double value)
{
  static const std::array<double, 24> usual{ { 999.0, 9999.0, 99999.0, 999999.0, 9999999.0, 9999.9,
    99999.9, 9999.99, 8888.0, 88888.0, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 32766.0, 32767.0,
    32768.0, 65535.0, 2147483647.0, 2147483648.0, 4294967295.0 } };
  const double size = std::abs(value);
  return std::any_of(usual.begin(), usual.end(),
           [size](double other) { return std::abs(size - other) <= 1e-6 * other; }) ||
    size >= 1e12;
}

struct Level
{
  double Value;
  std::size_t Count;
};

std::vector<Level> CountLevels(std::vector<double>& values)
{
  values.erase(std::remove_if(values.begin(), values.end(),
                 [](double value) { return !(std::abs(value) < kLeastCertainFill); }),
    values.end());
  std::sort(values.begin(), values.end());
  std::vector<Level> levels;
  for (const double value : values)
  {
    if (levels.empty() || levels.back().Value != value)
    {
      levels.push_back({ value, 0 });
    }
    ++levels.back().Count;
  }
  return levels;
}

bool MayBeFill(double value)
{
  return IsUsualFill(value) || std::abs(value) > kBeyondHeights;
}

/// Fewer samples than this show no pattern.
constexpr std::size_t kFewestSamples = 16;
// Of two values, one may be fill only if it is far from any height.
constexpr double kLeastLoneFill = 9000.0;

/// Values of fill at one end are no more than this.
constexpr std::size_t kMostFills = 8;

/// How many levels at the lowest (or the highest) end of [first, end) are fill among the others; 0
/// for none. Those at the other end may be fill of their own, and are not counted then.
std::size_t CountFill(
  const std::vector<Level>& levels, std::size_t first, std::size_t end, bool low)
{
  const auto at = [&](std::size_t k) { return low ? levels[first + k] : levels[end - 1 - k]; };
  const std::size_t total = end - first;
  std::size_t others = total;
  while (others > 2 && total - others < kMostFills && MayBeFill(at(others - 1).Value))
  {
    --others;
  }
  bool usual = false;
  double widest = 0.0;
  for (std::size_t k = 1; k <= kMostFills && k < others && MayBeFill(at(k - 1).Value); ++k)
  {
    usual = usual || IsUsualFill(at(k - 1).Value);
    const double gap = std::abs(at(k).Value - at(k - 1).Value);
    const double range = std::abs(at(others - 1).Value - at(k).Value);
    widest = 0.0;
    for (std::size_t i = k + 1; i < others; ++i)
    {
      widest = std::max(widest, std::abs(at(i).Value - at(i - 1).Value));
    }
    const bool lone = others - k == 1;
    if (lone && (std::abs(at(0).Value) < kLeastLoneFill || MayBeFill(at(k).Value)))
    {
      continue;
    }
    const bool isBeyond = std::abs(at(k - 1).Value) > kBeyondHeights && at(0).Count > 1;
    if (gap > kShareOfGaps * widest &&
      ((usual && gap > kShareOfRange * range) || (isBeyond && gap > kFarAway * range)))
    {
      return k;
    }
  }
  return 0;
}

/// Metres of a cell that can show buildings, of the tallest of these (828 m), rounded up, and of
/// masts that a single sample shows.
constexpr double kWidestOfTowns = 15.0;
constexpr double kTallest = 900.0;
constexpr double kTallestMast = 100.0;

/// True for values that programs fill with, and for those that a byte or a round number would be.
bool LooksLikeFill(double value)
{
  constexpr double kRound = 100.0;
  constexpr double kLeastPower = 127.0;
  const double power = std::exp2(std::round(std::log2(std::max(std::abs(value), 1.0))));
  const double above = power - std::abs(value);
  return IsUsualFill(value) || std::fmod(value, kRound) == 0.0 ||
    (std::abs(value) >= kLeastPower && (above == 0.0 || above == 1.0));
}

/// Fills in what there is to say of the levels [first, end) that are no fill.
void Summarize(
  const std::vector<Level>& levels, std::size_t first, std::size_t end, FillFindings& findings)
{
  double count = 0.0;
  for (std::size_t k = first; k < end; ++k)
  {
    count += static_cast<double>(levels[k].Count);
  }
  findings.LevelCount = end - first;
  findings.Low = levels[first].Value;
  findings.High = levels[end - 1].Value;
  findings.LowShare = static_cast<double>(levels[first].Count) / count;
  findings.HighShare = static_cast<double>(levels[end - 1].Count) / count;
  findings.LowGap = end - first > 1 ? levels[first + 1].Value - findings.Low : 0.0;
  findings.HighGap = end - first > 1 ? findings.High - levels[end - 2].Value : 0.0;
  double below = 0.0;
  for (std::size_t k = first + 1; k < end; ++k)
  {
    below += static_cast<double>(levels[k - 1].Count);
    const double gap = levels[k].Value - levels[k - 1].Value;
    if (gap > findings.WidestGap)
    {
      findings.WidestGap = gap;
      findings.GapShare = std::min(below, count - below) / count;
      findings.IsGapLow = below < count - below;
      findings.GapEnd = levels[findings.IsGapLow ? k - 1 : k].Value;
      findings.IsGapOne = findings.IsGapLow ? k - 1 == first : k + 1 == end;
    }
  }
}
}

//------------------------------------------------------------------------------
FillFindings FindFill(std::vector<double> values)
{
  const std::vector<Level> levels = CountLevels(values);
  FillFindings findings;
  std::size_t first = 0;
  std::size_t end = levels.size();
  for (bool found = values.size() >= kFewestSamples; found && end - first > 1;)
  {
    const std::size_t low = CountFill(levels, first, end, true);
    const std::size_t high = low > 0 ? 0 : CountFill(levels, first, end, false);
    found = low + high > 0;
    for (std::size_t k = 0; k < low + high; ++k)
    {
      findings.Values.push_back(low > 0 ? levels[first++].Value : levels[--end].Value);
    }
  }
  if (first < end)
  {
    Summarize(levels, first, end, findings);
  }
  return findings;
}

//------------------------------------------------------------------------------
void FindLone(const std::vector<double>& values, std::size_t width, FillFindings& findings)
{
  const auto isFar = [&](std::size_t k)
  {
    const double value = values[k];
    return findings.IsGapLow ? value <= findings.GapEnd && value >= findings.Low
                             : value >= findings.GapEnd && value <= findings.High;
  };
  const std::size_t height = width > 0 ? values.size() / width : 0;
  std::size_t far = 0;
  std::size_t lone = 0;
  for (std::size_t k = 0; k < width * height; ++k)
  {
    if (!isFar(k))
    {
      continue;
    }
    ++far;
    const std::size_t row = k / width;
    const std::size_t column = k % width;
    bool hasOther = false;
    for (std::size_t j = row - std::min<std::size_t>(row, 1); j <= row + 1 && j < height; ++j)
    {
      for (std::size_t i = column - std::min<std::size_t>(column, 1); i <= column + 1 && i < width;
           ++i)
      {
        hasOther = hasOther || (j * width + i != k && isFar(j * width + i));
      }
    }
    lone += hasOther ? 0 : 1;
  }
  findings.LoneShare = far > 0 ? static_cast<double>(lone) / static_cast<double>(far) : 0.0;
}

//------------------------------------------------------------------------------
bool AreNeedles(const FillFindings& findings, double perUnit, double cell)
{
  constexpr double kFewest = 0.01;
  constexpr double kCells = 10.0;
  constexpr double kShareOfAll = 1.0 / 3.0; // of the range with them
  constexpr double kMostlyLone = 0.5;
  const double gap = std::abs(perUnit) * findings.WidestGap;
  if (!(findings.GapShare < kFewest) || !(gap > kCells * cell) ||
    !(findings.WidestGap > kShareOfAll * (findings.High - findings.Low)))
  {
    return false;
  }
  const bool rises = findings.IsGapLow == (perUnit < 0.0);
  if (!rises || gap > kTallest || cell > kWidestOfTowns ||
    (findings.IsGapOne && LooksLikeFill(findings.GapEnd)))
  {
    return true;
  }
  return findings.LoneShare > kMostlyLone && gap > kTallestMast;
}

//------------------------------------------------------------------------------
double FindAloof(const FillFindings& findings, double perUnit)
{
  constexpr std::size_t kFewestLevels = 10;
  constexpr double kLeastShare = 0.01;
  const auto isAloof = [&](double gap, double share, double value, bool isLow)
  {
    const bool rises = isLow == (perUnit < 0.0);
    return findings.LevelCount > kFewestLevels && share >= kLeastShare &&
      (!rises || LooksLikeFill(value)) && gap > findings.High - findings.Low - gap &&
      std::abs(perUnit) * gap > kTallestMast;
  };
  return isAloof(findings.LowGap, findings.LowShare, findings.Low, true) ? findings.Low
    : isAloof(findings.HighGap, findings.HighShare, findings.High, false)
    ? findings.High
    : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
bool HasZeroVoids(const FillFindings& findings)
{
  constexpr std::size_t kFewestLevels = 10;
  constexpr double kMostVoids = 0.5;
  constexpr double kLeastGap = 0.25;
  return findings.LevelCount > kFewestLevels && findings.Low == 0.0 && findings.IsGapOne &&
    findings.GapEnd == 0.0 && findings.LowShare <= kMostVoids &&
    findings.WidestGap > kLeastGap * findings.High;
}
}
