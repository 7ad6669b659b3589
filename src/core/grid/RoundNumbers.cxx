// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/RoundNumbers.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace
{
// Relative slack, so that a product which should be round is taken as round.
constexpr double kSlack = 1e-9;

std::string Text(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}
}

namespace terrain
{
double RoundDown(double value)
{
  if (!(value > 0.0) || !std::isfinite(value))
  {
    return 0.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(value * (1.0 + kSlack))));
  for (double digit : { 5.0, 2.0 })
  {
    if (digit * power <= value * (1.0 + kSlack))
    {
      return digit * power;
    }
  }
  return power;
}

double RoundAngleDown(double value)
{
  if (!(value > 0.0) || !std::isfinite(value))
  {
    return 0.0;
  }
  constexpr std::array<double, 20> seconds{ 324000.0, 162000.0, 108000.0, 72000.0, 36000.0, 18000.0,
    7200.0, 3600.0, 1800.0, 1200.0, 600.0, 300.0, 120.0, 60.0, 30.0, 20.0, 10.0, 5.0, 2.0, 1.0 };
  for (double step : seconds)
  {
    if (step <= value * 3600.0 * (1.0 + kSlack))
    {
      return step / 3600.0;
    }
  }
  return RoundDown(value * 3600.0) / 3600.0;
}

std::string LengthLabel(double metres)
{
  if (std::abs(metres) >= 1000.0 * (1.0 - kSlack))
  {
    return Text("%.10g km", metres / 1000.0);
  }
  if (std::abs(metres) >= 1.0 - kSlack || metres == 0.0)
  {
    return Text("%.10g m", metres);
  }
  return Text("%.10g cm", metres * 100.0);
}

std::string AngleLabel(double degrees, double step, char positive, char negative)
{
  const double seconds = std::abs(degrees) * 3600.0;
  const double whole = std::floor(seconds + 0.5 * kSlack * 3600.0 + 1e-6);
  const double fraction = seconds - whole;
  std::string label = Text("%.0f", std::floor(whole / 3600.0)) + "\xc2\xb0";
  const bool hasMinutes = step < 1.0 - kSlack;
  const bool hasSeconds = step < (1.0 - kSlack) / 60.0;
  if (hasMinutes)
  {
    label += Text("%02.0f'", std::floor(std::fmod(whole, 3600.0) / 60.0));
  }
  if (hasSeconds)
  {
    const double rest = std::fmod(whole, 60.0);
    const bool fractional = step * 3600.0 < 1.0 - kSlack && fraction > 1e-6;
    label += fractional ? Text("%.6g\"", rest + fraction) : Text("%02.0f\"", rest);
  }
  if (whole == 0.0 && fraction < 1e-6)
  {
    return label;
  }
  return label + (degrees < 0.0 ? negative : positive);
}
}
