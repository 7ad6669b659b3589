// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as colour files of each kind, and laid over a range of values: colours in ascending order
// between black and white, or one sentence.
#include "FuzzInput.h"

#include "core/colors/ColorFile.h"
#include "core/colors/ColorText.h"

#include <array>
#include <cmath>
#include <limits>

namespace
{
void RequireColor(const terrain::Color& color)
{
  for (int k = 0; k < 3; ++k)
  {
    Require(color[k] >= -1e-9 && color[k] <= 1.0 + 1e-9);
  }
}

void RequireScheme(const terrain::ColorScheme& scheme)
{
  Require(!scheme.Stops.empty());
  for (std::size_t k = 0; k < scheme.Stops.size(); ++k)
  {
    Require(std::isfinite(scheme.Stops[k].Value));
    Require(k == 0 || scheme.Stops[k - 1].Value <= scheme.Stops[k].Value);
    RequireColor(scheme.Stops[k].Shade);
  }
}

void Check(const terrain::ColorScheme& scheme, FuzzInput& input)
{
  RequireScheme(scheme);
  terrain::ColorRange range;
  range.Lowest = 1000.0 * input.Real();
  range.Highest = range.Lowest + 1000.0 * std::abs(input.Real());
  range.HasSea = input.Number(2) != 0;
  const terrain::ColorScheme laid = terrain::LaidOver(scheme, range);
  RequireScheme(laid);
  RequireScheme(terrain::Reversed(laid));
  RequireScheme(terrain::Stretched(laid, range.Lowest, range.Highest));
  const std::array<double, 5> values{ range.Lowest, range.Highest, input.Take<double>(),
    std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity() };
  for (const double value : values)
  {
    RequireColor(terrain::ColorOf(laid, value));
  }
  terrain::IsDiscrete(laid);
  const std::vector<int> classes = terrain::ClassesOf(laid, { values.begin(), values.end() });
  for (const int number : classes)
  {
    Require(number >= -1 && number < static_cast<int>(laid.Classes.size()));
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::array readers{ terrain::ReadColorPaletteTable, terrain::ReadColorReliefText,
    terrain::ReadColorMapText, terrain::ReadClassTable };
  // the text comes first, so that a file is a seed; what follows its end says the rest
  FuzzInput input(data, size);
  const std::string text = input.Text();
  const std::size_t only = input.Left() > 0 ? input.Number(readers.size()) : readers.size();
  for (std::size_t k = 0; k < readers.size(); ++k)
  {
    if (only < readers.size() && k != only)
    {
      continue;
    }
    const terrain::ColorFileResult result = readers[k](text);
    if (result.WhyNot.empty())
    {
      Check(result.Scheme, input);
    }
    else
    {
      Require(result.WhyNot.find('\n') == std::string::npos);
    }
  }
  return 0;
}
