// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/colors/ColorText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <locale>
#include <sstream>

namespace terrain
{
namespace
{
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

std::optional<Color> FromNumbers(const std::vector<double>& numbers, ColorModel model)
{
  if (model == ColorModel::HSV && numbers.size() == 3 &&
    IsWithin({ numbers[1], numbers[2] }, 1.0) && numbers[0] >= 0.0 && numbers[0] <= 360.0)
  {
    return FromHSV(numbers[0], numbers[1], numbers[2]);
  }
  if (model == ColorModel::CMYK && numbers.size() == 4 && IsWithin(numbers, 100.0))
  {
    return Color(100.0 - numbers[0], 100.0 - numbers[1], 100.0 - numbers[2]) / 100.0 *
      (1.0 - numbers[3] / 100.0);
  }
  if (model == ColorModel::RGB && numbers.size() == 3 && IsWithin(numbers, 255.0))
  {
    return Color(numbers[0], numbers[1], numbers[2]) / 255.0;
  }
  return std::nullopt;
}

std::optional<Color> FromParts(const std::string& word, const char* separator, ColorModel model)
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
    return FromParts(text, "/", slashes == 3 ? ColorModel::CMYK : ColorModel::RGB);
  }
  if (const std::optional<double> grey = ToNumber(text))
  {
    return FromNumbers({ *grey, *grey, *grey }, ColorModel::RGB);
  }
  if (std::count(text.begin(), text.end(), '-') == 2)
  {
    return FromParts(text, "-", ColorModel::HSV);
  }
  return ColorFromName(text);
}
}

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

std::optional<double> ToNumber(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  constexpr double kMost = 1e300;
  double number = 0.0;
  stream >> number;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() ||
    !(std::abs(number) <= kMost))
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

std::optional<Color> TakeColor(
  const std::vector<std::string>& words, std::size_t& at, ColorModel model)
{
  const std::size_t count = model == ColorModel::CMYK ? 4 : 3;
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
}
