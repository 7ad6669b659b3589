// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/colors/ColorFile.h"

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
std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string Trimmed(const std::string& text)
{
  const char* blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// A number that is the whole of a text, whatever the locale.
std::optional<double> ToNumber(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() ||
    !std::isfinite(number))
  {
    return std::nullopt;
  }
  return number;
}

std::vector<std::string> Split(const std::string& line, const char* separators)
{
  std::vector<std::string> words;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string::npos;)
  {
    const std::size_t end = line.find_first_of(separators, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

std::vector<std::string> Lines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(Trimmed(line));
  }
  return lines;
}

/// Hue in degrees, saturation and value from 0 to 1. Source: A. R. Smith, "Color Gamut Transform
/// Pairs", 1978.
Color FromHSV(double hue, double saturation, double value)
{
  const auto channel = [&](double shift)
  {
    const double k = std::fmod(shift + hue / 60.0, 6.0);
    return value - value * saturation * std::max(0.0, std::min({ k, 4.0 - k, 1.0 }));
  };
  return { channel(5.0), channel(3.0), channel(1.0) };
}

bool IsWithin(const std::vector<double>& numbers, double highest)
{
  return std::all_of(numbers.begin(), numbers.end(),
    [highest](double number) { return number >= 0.0 && number <= highest; });
}

enum class Model
{
  RGB,
  HSV,
  CMYK
};

std::optional<Color> FromNumbers(const std::vector<double>& numbers, Model model)
{
  if (model == Model::HSV && numbers.size() == 3 && IsWithin({ numbers[1], numbers[2] }, 1.0) &&
    numbers[0] >= 0.0 && numbers[0] <= 360.0)
  {
    return FromHSV(numbers[0], numbers[1], numbers[2]);
  }
  if (model == Model::CMYK && numbers.size() == 4 && IsWithin(numbers, 100.0))
  {
    return Color(100.0 - numbers[0], 100.0 - numbers[1], 100.0 - numbers[2]) / 100.0 *
      (1.0 - numbers[3] / 100.0);
  }
  if (model == Model::RGB && numbers.size() == 3 && IsWithin(numbers, 255.0))
  {
    return Color(numbers[0], numbers[1], numbers[2]) / 255.0;
  }
  return std::nullopt;
}

std::optional<Color> FromParts(const std::string& word, const char* separator, Model model)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(word, separator))
  {
    const std::optional<double> number = ToNumber(part);
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return FromNumbers(numbers, model);
}

/// A colour in one word of a palette table: r/g/b, c/m/y/k, h-s-v, a grey, a name. "@", which
/// begins a transparency, ends it.
std::optional<Color> FromWord(const std::string& word)
{
  const std::string text = word.substr(0, word.find('@'));
  if (text.find('/') != std::string::npos)
  {
    const auto slashes = std::count(text.begin(), text.end(), '/');
    return FromParts(text, "/", slashes == 3 ? Model::CMYK : Model::RGB);
  }
  if (const std::optional<double> grey = ToNumber(text))
  {
    return FromNumbers({ *grey, *grey, *grey }, Model::RGB);
  }
  if (std::count(text.begin(), text.end(), '-') == 2)
  {
    return FromParts(text, "-", Model::HSV);
  }
  return ColorFromName(text);
}

/// Takes a colour of one word, or of as many numbers as the model has, from words at a position
/// that moves on.
std::optional<Color> TakeColor(const std::vector<std::string>& words, std::size_t& at, Model model)
{
  const std::size_t count = model == Model::CMYK ? 4 : 3;
  if (at + count <= words.size() && ToNumber(words[at]) && ToNumber(words[at + 1]))
  {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < count; ++k, ++at)
    {
      numbers.push_back(ToNumber(words[at]).value_or(-1.0));
    }
    return FromNumbers(numbers, model);
  }
  return at < words.size() ? FromWord(words[at++]) : std::nullopt;
}

/// The colour after a value: three numbers, or a name by itself.
std::optional<Color> ColorAfterValue(const std::vector<std::string>& words)
{
  std::size_t at = 1;
  const std::optional<Color> color = TakeColor(words, at, Model::RGB);
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
      this->Colors = line.find("hsv") != std::string::npos ? Model::HSV
        : line.find("cmyk") != std::string::npos           ? Model::CMYK
                                                           : Model::RGB;
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
  Model Colors = Model::RGB;
};

/// The same colour at the end of a slice and at the beginning of the next is one stop.
void DropRepeated(std::vector<ColorStop>& stops)
{
  const auto isSame = [](const ColorStop& a, const ColorStop& b)
  { return a.Value == b.Value && a.Shade == b.Shade; };
  stops.erase(std::unique(stops.begin(), stops.end(), isSame), stops.end());
}
}

//--------------------------------------------------------------------------------------------------
std::optional<Color> ColorFromName(const std::string& name)
{
  struct Named
  {
    const char* Name;
    unsigned Code;
  };
  static constexpr std::array<Named, 34> kNames{ { { "white", 0xFFFFFF }, { "black", 0x000000 },
    { "red", 0xFF0000 }, { "green", 0x00FF00 }, { "blue", 0x0000FF }, { "yellow", 0xFFFF00 },
    { "magenta", 0xFF00FF }, { "cyan", 0x00FFFF }, { "aqua", 0x00BFBF }, { "grey", 0xBEBEBE },
    { "gray", 0xBEBEBE }, { "orange", 0xFFA500 }, { "brown", 0xA52A2A }, { "purple", 0xA020F0 },
    { "violet", 0xEE82EE }, { "indigo", 0x4B0082 }, { "lightblue", 0xADD8E6 },
    { "darkblue", 0x00008B }, { "navy", 0x000080 }, { "steelblue", 0x4682B4 },
    { "skyblue", 0x87CEEB }, { "turquoise", 0x40E0D0 }, { "lightgreen", 0x90EE90 },
    { "darkgreen", 0x006400 }, { "forestgreen", 0x228B22 }, { "olive", 0x808000 },
    { "khaki", 0xF0E68C }, { "gold", 0xFFD700 }, { "tan", 0xD2B48C }, { "beige", 0xF5F5DC },
    { "wheat", 0xF5DEB3 }, { "lightgray", 0xD3D3D3 }, { "lightgrey", 0xD3D3D3 },
    { "darkgray", 0xA9A9A9 } } };
  const std::string lower = LowerCase(name);
  unsigned code = 0;
  if (lower.size() == 7 && lower[0] == '#' &&
    lower.find_first_not_of("0123456789abcdef", 1) == std::string::npos)
  {
    code = static_cast<unsigned>(std::stoul(lower.substr(1), nullptr, 16));
  }
  else
  {
    const auto* found = std::find_if(
      kNames.begin(), kNames.end(), [&lower](const Named& named) { return lower == named.Name; });
    if (found == kNames.end())
    {
      return std::nullopt;
    }
    code = found->Code;
  }
  return Color((code >> 16U) & 0xFFU, (code >> 8U) & 0xFFU, code & 0xFFU) / 255.0;
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
    if (fields.size() > 5 && !isInfinite)
    {
      scheme.Classes.push_back({ *value, Trimmed(fields[5]) });
    }
  }
  if (kind != "interpolated" && kind != "discrete" && kind != "exact")
  {
    return Refused(
      "the interpolation '" + kind + "' is not known: INTERPOLATED, DISCRETE or EXACT");
  }
  ColorFileResult result = Finished(std::move(scheme));
  if (kind != "interpolated" && result.WhyNot.empty())
  {
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
