// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
void Refuse(const std::string& option, const std::string& reason)
{
  throw CLI::ValidationError(option, reason);
}

//------------------------------------------------------------------------------
double ParseNumber(
  const std::string& option, const std::string& text, double minimum, double maximum)
{
  double value = 0.0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value))
  {
    Refuse(option, "'" + text + "' is not a finite number");
  }
  if (value < minimum || value > maximum)
  {
    std::ostringstream reason;
    reason << text << " is not between " << minimum << " and " << maximum;
    Refuse(option, reason.str());
  }
  return value;
}

//------------------------------------------------------------------------------
int ParseInteger(const std::string& option, const std::string& text, int minimum, int maximum)
{
  const double value = ParseNumber(option, text, minimum, maximum);
  if (value != std::floor(value))
  {
    Refuse(option, "'" + text + "' is not a whole number");
  }
  return static_cast<int>(value);
}

//------------------------------------------------------------------------------
std::vector<double> ParseNumbers(const std::string& option, const std::string& text, double largest)
{
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');)
  {
    numbers.push_back(ParseNumber(option, item, -largest, largest));
  }
  return numbers;
}
