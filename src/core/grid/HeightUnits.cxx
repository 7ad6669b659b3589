// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/HeightUnits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace
{
/// Lower case, with spaces for underscores and hyphens, without quotes and spaces around it.
std::string PlainName(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c)
    { return static_cast<char>(c == '_' || c == '-' ? ' ' : std::tolower(c)); });
  const std::size_t first = name.find_first_not_of(" '\"");
  const std::size_t last = name.find_last_not_of(" '\"");
  return first == std::string::npos ? std::string() : name.substr(first, last - first + 1);
}
}

namespace terrain
{
double MetresOfUnit(const std::string& name)
{
  static const std::array<std::pair<double, std::array<const char*, 8>>, 5> units{ {
    { 1.0, { "m", "metre", "meter", "metres", "meters", "", "", "" } },
    { 0.3048,
      { "ft", "foot", "feet", "international foot", "international feet", "ft int", "", "" } },
    { 1200.0 / 3937.0,
      { "us survey foot", "us survey feet", "us ft", "ftus", "us foot", "foot us", "us feet",
        "survey foot" } },
    { 0.01, { "cm", "centimetre", "centimeter", "centimetres", "centimeters", "", "", "" } },
    { 1000.0, { "km", "kilometre", "kilometer", "kilometres", "kilometers", "", "", "" } },
  } };
  const std::string plain = PlainName(name);
  for (const auto& unit : units)
  {
    for (const char* known : unit.second)
    {
      if (!plain.empty() && plain == known)
      {
        return unit.first;
      }
    }
  }
  return 0.0;
}
}
