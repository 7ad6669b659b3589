// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/colors/ColorFile.h"

#include "core/colors/ColorText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

namespace terrain
{
namespace
{
/// The colour after a value: three numbers, or a name by itself.
std::optional<Color> ColorAfterValue(const std::vector<std::string>& words)
{
  std::size_t at = 1;
  const std::optional<Color> color = TakeColor(words, at, ColorModel::RGB);
  const bool isName = at == 2 && words.size() == 2 && !ToNumber(words[1]);
  return at == 4 || isName ? color : std::nullopt;
}

std::string AtLine(std::size_t index, const std::string& what)
{
  return "line " + std::to_string(index + 1) + ": " + what;
}

ColorFileResult Refused(const std::string& why)
{
  ColorFileResult result;
  result.WhyNot = why;
  return result;
}

/// The end of reading: sorted stops, at least one.
ColorFileResult Finished(ColorScheme scheme)
{
  scheme.Along = ColorScheme::Axis::Values;
  if (scheme.Stops.empty())
  {
    return Refused("there are no colours in it");
  }
  std::stable_sort(scheme.Stops.begin(), scheme.Stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Value < b.Value; });
  return { std::move(scheme), {} };
}

/// Fields of a line of comma-separated values, without quotes and the blanks around them.
std::vector<std::string> Fields(const std::string& line)
{
  const char* separator = line.find(';') != std::string::npos ? ";"
    : line.find('\t') != std::string::npos                    ? "\t"
                                                              : ",";
  std::vector<std::string> fields(1);
  bool isInQuotes = false;
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    const bool isDouble = isInQuotes && line[k] == '"' && k + 1 < line.size() && line[k + 1] == '"';
    if (line[k] == '"' && !isDouble)
    {
      isInQuotes = !isInQuotes;
    }
    else if (line[k] == *separator && !isInQuotes)
    {
      fields.emplace_back();
    }
    else
    {
      fields.back() += line[k];
    }
    k += isDouble ? 1 : 0;
  }
  std::transform(fields.begin(), fields.end(), fields.begin(), Trimmed);
  return fields;
}

/// Finds value, colour and name among the names of columns; false without the first two.
bool FindColumns(const std::vector<std::string>& names, std::array<std::size_t, 3>& columns)
{
  const std::array<std::vector<std::string>, 3> words = { { { "value", "class", "code", "id" },
    { "colour", "color" }, { "name", "label", "class name" } } };
  bool isThere = true;
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const auto is = [&](const std::string& name)
    {
      const std::vector<std::string>& known = words[column];
      return std::find(known.begin(), known.end(), LowerCase(name)) != known.end();
    };
    const auto found = std::find_if(names.begin(), names.end(), is);
    columns[column] = static_cast<std::size_t>(found - names.begin()); // beyond them: no name
    isThere = isThere && (column == 2 || found != names.end());
  }
  return isThere;
}

/// One palette table, line by line.
class PaletteReader
{
public:
  /// Empty, or why the line cannot be read.
  std::string Read(const std::string& line)
  {
    if (line.empty())
    {
      return {};
    }
    if (line[0] == '#')
    {
      this->ReadComment(LowerCase(line));
      return {};
    }
    const std::size_t semicolon = line.find(';');
    const std::string name =
      semicolon == std::string::npos ? std::string() : Trimmed(line.substr(semicolon + 1));
    std::vector<std::string> words = Split(line.substr(0, semicolon), " \t,");
    if (words.size() > 2 && words.back().find_first_not_of("LUB") == std::string::npos)
    {
      words.pop_back(); // which labels GMT draws
    }
    if (words.size() < 2)
    {
      return "a value and a colour are expected";
    }
    if (words[0] == "B" || words[0] == "F" || words[0] == "N")
    {
      return this->ReadOutside(words);
    }
    return this->ReadSlice(words, name);
  }

  ColorScheme Take()
  {
    if (!this->Keys.empty())
    {
      this->Scheme.Stops = ExactStops(this->Keys);
    }
    return std::move(this->Scheme);
  }

private:
  void ReadComment(const std::string& line)
  {
    if (line.find("color_model") != std::string::npos)
    {
      this->Colors = line.find("hsv") != std::string::npos ? ColorModel::HSV
        : line.find("cmyk") != std::string::npos           ? ColorModel::CMYK
                                                           : ColorModel::RGB;
    }
  }

  std::string ReadOutside(const std::vector<std::string>& words)
  {
    std::size_t at = 1;
    const std::optional<Color> color = TakeColor(words, at, this->Colors);
    if (!color)
    {
      return "'" + words[1] + "' is no colour";
    }
    (words[0] == "B"      ? this->Scheme.Below
        : words[0] == "F" ? this->Scheme.Above
                          : this->Scheme.None) = color;
    return {};
  }

  std::string ReadSlice(const std::vector<std::string>& words, const std::string& name)
  {
    const std::optional<double> low = ToNumber(words[0]);
    std::size_t at = 1;
    const std::optional<Color> first = TakeColor(words, at, this->Colors);
    if (!low || !first)
    {
      return low ? "'" + words[1] + "' is no colour" : "'" + words[0] + "' is no number";
    }
    if (!name.empty())
    {
      this->Scheme.Classes.push_back({ *low, name });
    }
    if (at == words.size())
    {
      this->Keys.push_back({ *low, *first });
      return {};
    }
    const std::optional<double> high = ToNumber(words[at++]);
    const std::optional<Color> second = TakeColor(words, at, this->Colors);
    if (!high || !second || *high < *low)
    {
      return "a slice is 'low colour high colour', with high above low";
    }
    this->Scheme.Stops.push_back({ *low, *first });
    this->Scheme.Stops.push_back({ *high, *second });
    return {};
  }

  ColorScheme Scheme;
  std::vector<ColorStop> Keys;
  ColorModel Colors = ColorModel::RGB;
};

/// The same colour at the end of a slice and at the beginning of the next is one stop.
void DropRepeated(std::vector<ColorStop>& stops)
{
  const auto isSame = [](const ColorStop& a, const ColorStop& b)
  { return a.Value == b.Value && a.Shade == b.Shade; };
  stops.erase(std::unique(stops.begin(), stops.end(), isSame), stops.end());
}
}

bool HasLastOnly(const std::vector<ColorStop>& table, bool isExact)
{
  const auto infinite = std::count_if(
    table.begin(), table.end(), [](const ColorStop& stop) { return std::isinf(stop.Value); });
  return infinite <= (isExact ? 0 : 1);
}

std::vector<ColorStop> DiscreteStops(const std::vector<ColorStop>& table)
{
  std::vector<ColorStop> stops;
  for (std::size_t k = 0; k < table.size(); ++k)
  {
    const bool isLast = k + 1 == table.size();
    if (k > 0)
    {
      stops.push_back({ table[k - 1].Value, table[k].Shade });
    }
    if (std::isfinite(table[k].Value))
    {
      stops.push_back({ table[k].Value, table[k].Shade });
    }
    else if (isLast && table.size() == 1)
    {
      stops.push_back({ 0.0, table[k].Shade });
    }
  }
  return stops;
}

void BeginClasses(std::vector<ColorScheme::ClassName>& classes)
{
  std::stable_sort(classes.begin(), classes.end(),
    [](const ColorScheme::ClassName& a, const ColorScheme::ClassName& b)
    { return a.Value < b.Value; });
  double begin = -std::numeric_limits<double>::infinity();
  for (ColorScheme::ClassName& name : classes)
  {
    std::swap(begin, name.Value);
  }
}

std::vector<ColorStop> ExactStops(const std::vector<ColorStop>& table)
{
  std::vector<ColorStop> stops;
  for (std::size_t k = 0; k < table.size(); ++k)
  {
    if (k > 0)
    {
      const double middle = 0.5 * (table[k - 1].Value + table[k].Value);
      stops.push_back({ middle, table[k - 1].Shade });
      stops.push_back({ middle, table[k].Shade });
    }
    stops.push_back(table[k]);
  }
  return stops;
}

namespace
{
/// The end of reading a colour map of QGIS: stops as it interpolates them.
ColorFileResult Interpolated(ColorScheme scheme, const std::string& kind)
{
  if (kind != "interpolated" && kind != "discrete" && kind != "exact")
  {
    return Refused(
      "the interpolation '" + kind + "' is not known: INTERPOLATED, DISCRETE or EXACT");
  }
  if (!HasLastOnly(scheme.Stops, kind == "exact"))
  {
    return Refused("'inf' ends the last class only: write it once, and with DISCRETE");
  }
  ColorFileResult result = Finished(std::move(scheme));
  if (kind != "interpolated" && result.WhyNot.empty())
  {
    if (kind == "discrete")
    {
      BeginClasses(result.Scheme.Classes);
    }
    result.Scheme.Stops =
      kind == "discrete" ? DiscreteStops(result.Scheme.Stops) : ExactStops(result.Scheme.Stops);
  }
  else if (result.WhyNot.empty() && std::isinf(result.Scheme.Stops.back().Value))
  {
    result.Scheme.Stops.pop_back();
  }
  return result.Scheme.Stops.empty() && result.WhyNot.empty()
    ? Refused("there are no colours in it")
    : result;
}
}

ColorFileResult ReadColorPaletteTable(const std::string& text)
{
  PaletteReader reader;
  const std::vector<std::string> lines = Lines(text);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const std::string why = reader.Read(lines[k]);
    if (!why.empty())
    {
      return Refused(AtLine(k, why));
    }
  }
  ColorFileResult result = Finished(reader.Take());
  DropRepeated(result.Scheme.Stops);
  return result;
}

ColorFileResult ReadColorReliefText(const std::string& text)
{
  ColorScheme scheme;
  std::size_t shares = 0;
  const std::vector<std::string> lines = Lines(text);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    std::vector<std::string> words = Split(lines[k], " \t,:");
    if (words.empty() || words[0][0] == '#')
    {
      continue;
    }
    const bool isShare = words[0].back() == '%';
    const bool isNone = LowerCase(words[0]) == "nv";
    const std::optional<double> value =
      isNone ? 0.0 : ToNumber(words[0].substr(0, words[0].size() - (isShare ? 1 : 0)));
    const std::optional<Color> color = ColorAfterValue(words);
    if (!value || !color)
    {
      return Refused(AtLine(k, "'value red green blue' is expected, with colours from 0 to 255"));
    }
    shares += isShare ? 1 : 0;
    if (isNone)
    {
      scheme.None = color;
      continue;
    }
    scheme.Stops.push_back({ isShare ? *value / 100.0 : *value, *color });
  }
  if (shares != 0 && shares != scheme.Stops.size())
  {
    return Refused("values and percentages cannot be mixed: write all in one of them");
  }
  ColorFileResult result = Finished(std::move(scheme));
  result.Scheme.Along = shares != 0 ? ColorScheme::Axis::Shares : ColorScheme::Axis::Values;
  return result;
}

ColorFileResult ReadColorMapText(const std::string& text)
{
  ColorScheme scheme;
  std::string kind = "exact"; // ESRI's
  const std::vector<std::string> lines = Lines(text);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const std::string lower = LowerCase(lines[k]);
    if (lower.empty() || lower[0] == '#')
    {
      continue;
    }
    if (lower.compare(0, 14, "interpolation:") == 0)
    {
      kind = Trimmed(lower.substr(14));
      continue;
    }
    const std::vector<std::string> words = Split(lines[k], " \t,");
    const bool isInfinite = !words.empty() && LowerCase(words[0]) == "inf";
    const std::optional<double> value = isInfinite ? std::numeric_limits<double>::infinity()
                                                   : ToNumber(words.empty() ? "" : words[0]);
    const std::optional<Color> color = ColorAfterValue(words);
    if (!value || !color)
    {
      return Refused(
        AtLine(k, "'value, red, green, blue' is expected, with colours from 0 to 255"));
    }
    scheme.Stops.push_back({ *value, *color });
    const std::vector<std::string> fields = Split(lines[k], ",");
    if (fields.size() > 5 && !(isInfinite && kind == "interpolated"))
    {
      scheme.Classes.push_back({ *value, Trimmed(fields[5]) });
    }
  }
  return Interpolated(std::move(scheme), kind);
}

ColorFileResult ReadClassTable(const std::string& text)
{
  ColorScheme scheme;
  std::array<std::size_t, 3> columns = { 0, 1, 2 }; // of value, colour and name
  bool isFirst = true;
  const std::vector<std::string> lines = Lines(text);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const std::vector<std::string> fields = Fields(lines[k]);
    if (lines[k].empty() || lines[k][0] == '#')
    {
      continue;
    }
    const bool isHeader = isFirst && !ToNumber(fields[0]) && FindColumns(fields, columns);
    isFirst = false;
    if (isHeader)
    {
      continue;
    }
    const auto field = [&](std::size_t column)
    { return columns[column] < fields.size() ? fields[columns[column]] : std::string(); };
    const std::optional<double> value = ToNumber(field(0));
    const std::vector<std::string> words = Split(field(1), " ");
    std::size_t at = 0;
    const std::optional<Color> color = TakeColor(words, at, ColorModel::RGB);
    if (!value || !color || at != words.size())
    {
      return Refused(AtLine(
        k, "'value,colour,name' is expected, the colour as #RRGGBB, a name, or 'red green blue'"));
    }
    scheme.Stops.push_back({ *value, *color });
    scheme.Classes.push_back({ *value, field(2) });
  }
  ColorFileResult result = Finished(std::move(scheme));
  const std::vector<ColorStop>& stops = result.Scheme.Stops;
  const auto twice = std::adjacent_find(stops.begin(), stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Value == b.Value; });
  if (result.WhyNot.empty() && twice != stops.end())
  {
    std::ostringstream why;
    why.imbue(std::locale::classic());
    why << "the value " << twice->Value << " is there twice";
    return Refused(why.str());
  }
  result.Scheme.Stops = ExactStops(stops);
  return result;
}
}
