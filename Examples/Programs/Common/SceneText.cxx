// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneText.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <map>

namespace
{
const std::map<char, char> kEscapes = { { 'n', '\n' }, { 't', '\t' }, { 'r', '\r' }, { '"', '"' },
  { '\\', '\\' } };

/// What is wrong at the place that is read.
struct TextError
{
  std::string Reason;
};

/// Reads one line after another, and parts of lines.
class LineReader
{
public:
  explicit LineReader(std::istream& text)
    : Text(text)
  {
  }
  int Line = 0;

  bool NextLine()
  {
    this->At = 0;
    if (!std::getline(this->Text, this->Content))
    {
      return false;
    }
    ++this->Line;
    if (!this->Content.empty() && this->Content.back() == '\r')
    {
      this->Content.pop_back();
    }
    return true;
  }
  /// The character that follows blanks; 0 at the end or before a comment.
  char Peek()
  {
    this->At = std::min(this->Content.find_first_not_of(" \t", this->At), this->Content.size());
    return this->At == this->Content.size() || this->Content[this->At] == '#'
      ? '\0'
      : this->Content[this->At];
  }
  /// The same over the ends of lines.
  char PeekOverLines()
  {
    while (this->Peek() == '\0')
    {
      if (!this->NextLine())
      {
        throw TextError{ "a list does not end: ']' is missing" };
      }
    }
    return this->Peek();
  }
  void Skip()
  {
    ++this->At;
  }
  std::string ReadUntil(const char* ends)
  {
    const std::size_t begin = this->At;
    this->At = std::min(this->Content.find_first_of(ends, begin), this->Content.size());
    return this->Content.substr(begin, this->At - begin);
  }
  std::string ReadQuoted()
  {
    const char quote = this->Content[this->At++];
    std::string value;
    for (; this->At < this->Content.size(); ++this->At)
    {
      char letter = this->Content[this->At];
      if (letter == quote)
      {
        ++this->At;
        return value;
      }
      if (letter == '\\' && quote == '"')
      {
        const auto escape = ++this->At < this->Content.size()
          ? kEscapes.find(this->Content[this->At])
          : kEscapes.end();
        if (escape == kEscapes.end())
        {
          throw TextError{ R"(after \ only n, t, r, " and \ may follow)" };
        }
        letter = escape->second;
      }
      value += letter;
    }
    throw TextError{ "a text does not end: a quote is missing" };
  }

private:
  std::istream& Text;
  std::string Content;
  std::size_t At = 0;
};

/// Where the digits end that begin at a place; the place itself if there are none.
std::size_t EndOfDigits(const std::string& value, std::size_t begin)
{
  return std::min(value.find_first_not_of("0123456789", begin), value.size());
}

/// True for [+-]?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?
/// By hand: std::regex takes stack for each letter, and a file may have any number of them.
bool IsNumber(const std::string& value)
{
  const auto isAnyOf = [&value](std::size_t at, const char* letters)
  { return at < value.size() && value[at] != 0 && std::strchr(letters, value[at]); };
  const std::size_t begin = isAnyOf(0, "+-") ? 1 : 0;
  std::size_t at = EndOfDigits(value, begin);
  if (at == begin || (value[begin] == '0' && at > begin + 1))
  {
    return false;
  }
  if (isAnyOf(at, "."))
  {
    const std::size_t fraction = at + 1;
    at = EndOfDigits(value, fraction);
    if (at == fraction)
    {
      return false;
    }
  }
  if (isAnyOf(at, "eE"))
  {
    const std::size_t exponent = at + (isAnyOf(at + 1, "+-") ? 2 : 1);
    at = EndOfDigits(value, exponent);
    return at > exponent && at == value.size();
  }
  return at == value.size();
}

bool IsPlain(const std::string& value)
{
  return value == "true" || value == "false" || IsNumber(value);
}

std::string ReadValue(LineReader& reader)
{
  const char first = reader.Peek();
  if (first == '"' || first == '\'')
  {
    return reader.ReadQuoted();
  }
  std::string value = reader.ReadUntil(" \t,]#");
  if (!IsPlain(value))
  {
    throw TextError{ value.empty() ? "there is no value"
                                   : "'" + value + "' is no number: texts stand in quotes" };
  }
  return value;
}

std::vector<std::string> ReadValues(LineReader& reader)
{
  if (reader.Peek() != '[')
  {
    return { ReadValue(reader) };
  }
  reader.Skip();
  std::vector<std::string> values;
  while (reader.PeekOverLines() != ']')
  {
    values.push_back(ReadValue(reader));
    if (reader.PeekOverLines() == ',')
    {
      reader.Skip();
    }
    else if (reader.Peek() != ']')
    {
      throw TextError{ "in a list a comma is missing" };
    }
  }
  reader.Skip();
  return values;
}

SceneEntry ReadEntry(LineReader& reader)
{
  SceneEntry entry;
  entry.Line = reader.Line;
  const char first = reader.Peek();
  if (first == '[')
  {
    throw TextError{ "a scene has no sections" };
  }
  entry.Key = first == '"' || first == '\'' ? reader.ReadQuoted() : reader.ReadUntil(" \t=#");
  if (reader.Peek() != '=' || entry.Key.empty())
  {
    throw TextError{ "it is not of the form key = value" };
  }
  reader.Skip();
  entry.Values = ReadValues(reader);
  if (reader.Peek() != '\0')
  {
    throw TextError{ "something follows the value" };
  }
  return entry;
}

std::string InQuotes(const std::string& value)
{
  std::string quoted = "\"";
  for (const char letter : value)
  {
    std::string text(1, letter);
    for (const auto& [name, escaped] : kEscapes)
    {
      text = letter == escaped ? std::string("\\") + name : text;
    }
    quoted += text;
  }
  return quoted + "\"";
}

/// True for keys that need no quotes.
bool IsBare(const std::string& key)
{
  return !key.empty() &&
    std::all_of(key.begin(), key.end(),
      [](unsigned char letter)
      { return std::isalnum(letter) != 0 || letter == '-' || letter == '_'; });
}
}

//------------------------------------------------------------------------------
SceneEntries ReadSceneText(std::istream& text)
{
  SceneEntries result;
  LineReader reader(text);
  try
  {
    while (reader.NextLine())
    {
      if (reader.Peek() != '\0')
      {
        result.Entries.push_back(ReadEntry(reader));
      }
    }
  }
  catch (const TextError& error)
  {
    result.Error = error.Reason;
    result.Line = reader.Line;
  }
  return result;
}

//------------------------------------------------------------------------------
std::string SceneLine(const std::string& key, const std::vector<std::string>& values)
{
  std::string list;
  for (const std::string& value : values)
  {
    list.append(list.empty() ? "" : ", ").append(IsPlain(value) ? value : InQuotes(value));
  }
  return (IsBare(key) ? key : InQuotes(key)) + " = " +
    (values.size() == 1 ? list : "[" + list + "]") + "\n";
}
