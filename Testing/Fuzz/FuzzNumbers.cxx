// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as units of heights and as times of the sun; any numbers as round ones and as labels.
#include "FuzzInput.h"

#include "core/grid/HeightUnits.h"
#include "core/grid/RoundNumbers.h"
#include "core/place/SunPosition.h"

#include <cmath>

namespace
{
void CheckUnit(const std::string& text)
{
  Require(terrain::MetresOfUnit(text) >= 0.0);
  double metres = 0.0;
  bool isNumber = false;
  if (terrain::HeightFactorFromText(text, metres, isNumber))
  {
    Require(std::isfinite(metres) && metres != 0.0);
  }
}

void CheckNumbers(double value, double step)
{
  const double down = terrain::RoundDown(value);
  Require(down >= 0.0 && (down == 0.0 || (down <= value * 1.00001 && down > 0.19 * value)));
  const double angle = terrain::RoundAngleDown(value);
  Require(angle >= 0.0 && (angle == 0.0 || angle <= value * 1.00001));
  Require(!terrain::LengthLabel(value).empty());
  Require(!terrain::AngleLabel(value, step, 'N', 'S').empty());
}

void CheckSun(const std::string& text, double longitude, double latitude)
{
  terrain::UtcTime time;
  std::string message;
  if (!terrain::TimeFromText(text, time, message))
  {
    Require(!message.empty());
    return;
  }
  const terrain::SunAngles sun = terrain::SunPosition({ longitude, latitude, 0.0 }, time);
  Require(sun.Azimuth >= 0.0 && sun.Azimuth < 360.0 && std::abs(sun.Elevation) <= 90.0);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const std::string text = input.Text();
  CheckUnit(text);
  CheckSun(text, 180.0 * input.Real(), 90.0 * input.Real());
  const double value = input.Take<double>();
  CheckNumbers(value, input.Take<double>());
  CheckNumbers(std::abs(value), 360.0 * std::abs(input.Real()));
  return 0;
}
