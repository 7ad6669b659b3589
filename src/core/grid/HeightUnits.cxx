// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/grid/HeightUnits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace
{
constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

/// Words of a name: lower case, brackets, quotes, points, underscores and hyphens taken for spaces,
/// one space between words.
std::string PlainName(const std::string& name)
{
  std::string plain;
  for (const char c : name)
  {
    const auto code = static_cast<unsigned char>(c);
    const bool separates =
      std::isspace(code) != 0 || std::string("_-'\"()[].,").find(c) != std::string::npos;
    if (!separates)
    {
      plain += static_cast<char>(std::tolower(code));
    }
    else if (!plain.empty() && plain.back() != ' ')
    {
      plain += ' ';
    }
  }
  while (!plain.empty() && plain.back() == ' ')
  {
    plain.pop_back();
  }
  return plain;
}

bool HasWord(const std::string& plain, const std::string& word)
{
  return (" " + plain + " ").find(" " + word + " ") != std::string::npos;
}

/// The feet of surveys, by the words that stand beside "foot": EPSG's guidance note 7-1 and
/// UDUNITS.
double MetresOfFoot(const std::string& plain)
{
  static const std::array<std::pair<const char*, double>, 8> others{ {
    { "clarke", 0.3047972654 },
    { "sears", 0.3047994715389248 },
    { "benoit", 0.3047997347632708 },
    { "gold coast", 0.3047997101815088 },
    { "indian", 0.3047995102481469 },
    { "br36", 0.3048007491 },
    { "1936", 0.3048007491 },
    { "1865", 0.30480083333333335 },
  } };
  for (const auto& [word, metres] : others)
  {
    if (HasWord(plain, word))
    {
      return metres;
    }
  }
  const bool survey = HasWord(plain, "survey") || HasWord(plain, "us") || HasWord(plain, "u s");
  return survey ? kSurveyFoot : kFoot;
}

/// Names without case, and metres.
constexpr std::array<std::pair<const char*, double>, 58> kUnits{ {
  { "m", 1.0 },
  { "metre", 1.0 },
  { "meter", 1.0 },
  { "mtr", 1.0 },
  { "mts", 1.0 },
  { "gpm", 1.0 }, // of geopotential: within 0.5 % below 10 km
  { "ellipsoidal metre", 1.0 },
  { "german legal metre", 1.0000135965 },
  { "km", 1000.0 },
  { "kilometre", 1000.0 },
  { "kilometer", 1000.0 },
  { "hm", 100.0 },
  { "hectometre", 100.0 },
  { "hectometer", 100.0 },
  { "dam", 10.0 },
  { "decametre", 10.0 },
  { "decameter", 10.0 },
  { "dm", 0.1 },
  { "decimetre", 0.1 },
  { "decimeter", 0.1 },
  { "cm", 0.01 },
  { "centimetre", 0.01 },
  { "centimeter", 0.01 },
  { "mm", 1e-3 },
  { "millimetre", 1e-3 },
  { "millimeter", 1e-3 },
  { "um", 1e-6 },
  { "micrometre", 1e-6 },
  { "micrometer", 1e-6 },
  { "micron", 1e-6 },
  { "nm", 1e-9 },
  { "nanometre", 1e-9 },
  { "nanometer", 1e-9 },
  { "ft", kFoot },
  { "ift", kFoot },
  { "foot", kFoot },
  { "ftus", kSurveyFoot },
  { "usft", kSurveyFoot },
  { "sft", kSurveyFoot },
  { "in", kFoot / 12.0 },
  { "inch", kFoot / 12.0 },
  { "inches", kFoot / 12.0 },
  { "us in", kSurveyFoot / 12.0 },
  { "yd", 3.0 * kFoot },
  { "yard", 3.0 * kFoot },
  { "us yd", 3.0 * kSurveyFoot },
  { "us survey yard", 3.0 * kSurveyFoot },
  { "fathom", 6.0 * kFoot },
  { "fath", 6.0 * kFoot },
  { "fth", 6.0 * kFoot },
  { "fm", 6.0 * kFoot },
  { "ftm", 6.0 * kFoot },
  { "mi", 5280.0 * kFoot },
  { "mile", 5280.0 * kFoot },
  { "us mi", 5280.0 * kSurveyFoot },
  { "nautical mile", 1852.0 },
  { "nmi", 1852.0 },
  { "international nautical mile", 1852.0 },
} };

/// Metres of a unit by its name alone.
double MetresOfName(const std::string& name)
{
  const std::string plain = PlainName(name);
  for (std::string word :
    { plain, plain.substr(0, plain.size() - (plain.empty() || plain.back() != 's' ? 0 : 1)) })
  {
    const auto* found = std::find_if(
      kUnits.begin(), kUnits.end(), [&word](const auto& unit) { return word == unit.first; });
    if (found != kUnits.end())
    {
      return found->second;
    }
  }
  for (const char* foot : { "foot", "feet", "ft" })
  {
    if (HasWord(plain, foot))
    {
      return MetresOfFoot(plain);
    }
  }
  for (const char* metre : { "metre", "meter", "metres", "meters" })
  {
    if (HasWord(plain, metre) && !HasWord(plain, "per") && !HasWord(plain, "square"))
    {
      return 1.0; // "meters above mean sea level"
    }
  }
  return plain == "m above sea level" || plain == "m amsl" || plain == "m asl" || plain == "m msl"
    ? 1.0
    : 0.0;
}
}

namespace terrain
{
//------------------------------------------------------------------------------
double MetresOfUnit(const std::string& name)
{
  char* rest = nullptr;
  const double factor = std::strtod(name.c_str(), &rest);
  if (rest != name.c_str() && factor > 0.0 && *rest == ' ') // "0.3048006096 metre" of CF
  {
    const double metres = std::isfinite(factor) ? factor * MetresOfName(rest + 1) : 0.0;
    return std::isfinite(metres) ? metres : 0.0;
  }
  return MetresOfName(name);
}

//------------------------------------------------------------------------------
bool HeightFactorFromText(const std::string& text, double& metres, bool& isNumber)
{
  char* end = nullptr;
  metres = std::strtod(text.c_str(), &end);
  isNumber = !text.empty() && *end == '\0';
  if (!isNumber)
  {
    const bool down = !text.empty() && text.front() == '-';
    metres = MetresOfUnit(down ? text.substr(1) : text) * (down ? -1.0 : 1.0);
  }
  return std::isfinite(metres) && metres != 0.0;
}
}
