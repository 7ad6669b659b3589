// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/GridReference.h"

#include "core/place/GeographicText.h"

#include <GeographicLib/UTMUPS.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

namespace
{
bool IsOnEarth(const glm::dvec3& place)
{
  return std::abs(place.y) <= 90.0 && std::isfinite(place.x);
}

/// Longest text that is read as a place, in bytes.
constexpr std::size_t kLongestPlace = 100;

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Not so of the end of `characters`, which std::strchr finds, too.
bool IsOneOf(char c, const char* characters)
{
  return c != '\0' && std::strchr(characters, c);
}

/// Reads a word from left to right by what it may consist of.
class WordReader
{
public:
  explicit WordReader(const std::string& word)
    : Word(word)
  {
  }
  bool IsAtEnd() const
  {
    return this->Position == this->Word.size();
  }
  bool Sees(bool (*isOfKind)(char)) const
  {
    return !this->IsAtEnd() && isOfKind(this->Word[this->Position]);
  }
  /// Takes the next character if it is one of these.
  bool Take(const char* characters)
  {
    const bool is = !this->IsAtEnd() && IsOneOf(this->Word[this->Position], characters);
    this->Position += is ? 1 : 0;
    return is;
  }
  /// Takes up to `most` characters of a kind, and returns how many.
  std::size_t Take(bool (*isOfKind)(char), std::size_t most)
  {
    std::size_t count = 0;
    while (count < most && this->Sees(isOfKind))
    {
      ++this->Position;
      ++count;
    }
    return count;
  }

private:
  const std::string& Word;
  std::size_t Position = 0;
};

/// The words between spaces and commas.
std::vector<std::string> SplitWords(const std::string& text)
{
  std::vector<std::string> words;
  bool inWord = false;
  for (const char c : text)
  {
    const bool between = IsOneOf(c, " \t\n\r,");
    if (!between && !inWord)
    {
      words.emplace_back();
    }
    if (!between)
    {
      words.back() += c;
    }
    inWord = !between;
  }
  return words;
}

/// The text with the signs of degrees, minutes and seconds of UTF-8 as d, ' and ".
std::string WithPlainSigns(std::string text)
{
  for (const auto& [sign, plain] :
    { std::pair<const char*, const char*>{ "\u00b0", "d" }, { "\u00ba", "d" }, { "\u2032", "'" },
      { "\u2019", "'" }, { "\u2033", "\"" }, { "\u201d", "\"" }, { "''", "\"" } })
  {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + 1))
    {
      text.replace(at, std::strlen(sign), plain);
    }
  }
  return text;
}

/// 45RVL9300095000, VL930950, ZAH: zone, letters, digits.
bool LooksLikeMgrs(const std::string& word)
{
  WordReader reader(word);
  reader.Take(IsDigit, 2);
  const std::size_t letters = reader.Take(IsLetter, 3);
  return reader.Take(IsDigit, 22) % 2 == 0 && letters > 0 && reader.IsAtEnd();
}

/// 45N, n, 12south: zone and hemisphere of UTM and UPS.
bool LooksLikeZone(const std::string& word)
{
  WordReader reader(word);
  reader.Take(IsDigit, 2);
  return reader.Take(IsLetter, 5) > 0 && reader.IsAtEnd();
}

/// Digits with a point among them or without; at least one digit.
bool TakeNumber(WordReader& reader, std::size_t most, bool& isWhole)
{
  std::size_t digits = reader.Take(IsDigit, most);
  isWhole = !reader.Take(".");
  digits += isWhole ? 0 : reader.Take(IsDigit, 17);
  return digits > 0;
}

/// 493000.5: metres.
bool LooksLikeNumber(const std::string& word)
{
  WordReader reader(word);
  reader.Take("+-");
  bool isWhole = false;
  return TakeNumber(reader, 9, isWhole) && reader.IsAtEnd();
}

/// 86.925, E86d55.5, 86:55:31.5, 27d59'17"N: degrees, minutes, seconds, only the last with a
/// fraction, and the hemisphere before or after them.
bool LooksLikeAngle(const std::string& word)
{
  WordReader reader(word);
  const char* hemispheres = "NSEWnsew";
  const bool isNamed = reader.Take(hemispheres);
  reader.Take("+-");
  const char* const signs[3] = { "dD", "'", "\"" };
  bool hasColons = false;
  for (int part = 0; part < 3; ++part)
  {
    bool isWhole = false;
    if (!TakeNumber(reader, 3, isWhole))
    {
      return false;
    }
    const bool mayGoOn = isWhole && part < 2;
    if (mayGoOn && (part == 0 || hasColons) && reader.Take(":"))
    {
      hasColons = true;
    }
    else if (hasColons || !reader.Take(signs[part]) || !mayGoOn || !reader.Sees(IsDigit))
    {
      break;
    }
  }
  if (!isNamed)
  {
    reader.Take(hemispheres);
  }
  return reader.IsAtEnd();
}

/// GeographicLib is shown only what a place can look like: what it does with any other text is not
/// to be relied on.
bool LooksLikePlace(const std::string& text)
{
  const std::vector<std::string> words = SplitWords(text);
  switch (text.size() <= kLongestPlace ? words.size() : 0)
  {
    case 1:
      return LooksLikeMgrs(words[0]);
    case 2:
      return LooksLikeAngle(words[0]) && LooksLikeAngle(words[1]);
    case 3:
      return (LooksLikeZone(words[0]) && LooksLikeNumber(words[1]) && LooksLikeNumber(words[2])) ||
        (LooksLikeNumber(words[0]) && LooksLikeNumber(words[1]) && LooksLikeZone(words[2]));
    default:
      return false;
  }
}
}

namespace terrain
{
GridPosition ToGridPosition(const glm::dvec3& place)
{
  GridPosition position;
  if (!IsOnEarth(place))
  {
    return position;
  }
  try
  {
    GeographicLib::UTMUPS::Forward(
      place.y, place.x, position.Zone, position.Northern, position.Easting, position.Northing);
  }
  catch (const std::exception&)
  {
    position.Zone = -1;
  }
  return position;
}

std::string ToUtmText(const glm::dvec3& place, int precision)
{
  char text[kGeographicTextSize];
  return IsOnEarth(place) && WriteUtmText(place.y, place.x, precision, text) ? text : "-";
}

std::string ToMgrs(const glm::dvec3& place, int precision)
{
  char text[kGeographicTextSize];
  const int digits = std::clamp(precision, 0, 11);
  return IsOnEarth(place) && WriteMgrs(place.y, place.x, digits, text) ? text : "-";
}

bool PlaceFromText(const std::string& text, glm::dvec3& place, std::string& message)
{
  double latitude = 0.0;
  double longitude = 0.0;
  char reason[kGeographicTextSize] =
    "it is neither a longitude and a latitude in degrees, nor an MGRS or UTM reference";
  const std::string plain = WithPlainSigns(text);
  if (!LooksLikePlace(plain) || !ReadGeographicText(plain.c_str(), latitude, longitude, reason))
  {
    message = "'" + text + "' is no place: " + reason;
    return false;
  }
  if (!IsOnEarth({ longitude, latitude, 0.0 }))
  {
    message = "'" + text + "' is no place on earth";
    return false;
  }
  place.x = longitude;
  place.y = latitude;
  return true;
}

std::string ToDegreesText(const glm::dvec3& place, int decimals)
{
  if (!IsOnEarth(place))
  {
    return "-";
  }
  char text[80];
  const int digits = std::clamp(decimals, 0, 12);
  std::snprintf(text, sizeof(text), "%.*f%c %.*f%c", digits, std::abs(place.y),
    place.y < 0.0 ? 'S' : 'N', digits, std::abs(place.x), place.x < 0.0 ? 'W' : 'E');
  return text;
}
}
