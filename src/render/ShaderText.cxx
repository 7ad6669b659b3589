// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ShaderText.h"

#include "vtkShaderProgram.h"

#include <cctype>

namespace terrain
{
namespace
{
const std::string kBeginMark = "// terrain begins\n";
const std::string kEndMark = "// terrain ends\n";

/// Where a pattern stands next in a source outside the marks, from a position on; npos for nowhere.
std::size_t FindOutside(const std::string& source, const std::string& pattern, std::size_t from)
{
  while (from != std::string::npos)
  {
    const std::size_t found = source.find(pattern, from);
    const std::size_t begin = source.find(kBeginMark, from);
    if (found == std::string::npos || begin == std::string::npos || found < begin)
    {
      return found;
    }
    from = source.find(kEndMark, begin);
  }
  return from;
}
}

//------------------------------------------------------------------------------
void ShaderText::Note(const std::string& problem)
{
  if (this->Problem.empty())
  {
    this->Problem = problem;
  }
}

//------------------------------------------------------------------------------
void ShaderText::Insert(const std::string& tag, const std::string& before,
  const std::string& behind, const std::string& code)
{
  std::string source = this->Shader->GetSource();
  std::string marked = before;
  marked += "\n" + kBeginMark + code + (code.empty() || code.back() == '\n' ? "" : "\n") + kEndMark;
  marked += behind;
  if (vtkShaderProgram::Substitute(source, tag, marked))
  {
    this->Shader->SetSource(source);
  }
  else
  {
    this->Note("there is no tag " + tag);
  }
}

//------------------------------------------------------------------------------
void ShaderText::Replace(const std::string& tag, const std::string& code)
{
  this->Insert(tag, "", "", code);
}

//------------------------------------------------------------------------------
void ShaderText::Before(const std::string& tag, const std::string& code)
{
  this->Insert(tag, "", tag, code);
}

//------------------------------------------------------------------------------
void ShaderText::Behind(const std::string& tag, const std::string& code)
{
  this->Insert(tag, tag, "", code);
}

//------------------------------------------------------------------------------
bool ShaderText::Follow(const std::string& pattern, const std::string& text)
{
  std::string source = this->Shader->GetSource();
  bool followed = false;
  for (std::size_t at = FindOutside(source, pattern, 0); at != std::string::npos;
       at = FindOutside(source, pattern, at + text.size()))
  {
    source.replace(at, pattern.size(), text);
    followed = true;
  }
  this->Shader->SetSource(source);
  return followed;
}

//------------------------------------------------------------------------------
void ShaderText::Require(
  const std::string& pattern, const std::string& text, const std::string& what)
{
  if (!this->Follow(pattern, text))
  {
    this->Note("there is no \"" + pattern + "\": " + what);
  }
}

//------------------------------------------------------------------------------
void ShaderText::RequireSwizzles(
  const std::string& vector, const std::string& components, const std::string& what)
{
  const std::string source = this->Shader->GetSource();
  for (std::size_t at = FindOutside(source, vector, 0); at != std::string::npos;
       at = FindOutside(source, vector, at + vector.size()))
  {
    const std::size_t dot = at + vector.size();
    const std::size_t end =
      dot < source.size() ? source.find_first_not_of(components, dot + 1) : std::string::npos;
    const bool isNamed = end != std::string::npos && source[dot] == '.' && end > dot + 1 &&
      std::isalnum(static_cast<unsigned char>(source[end])) == 0 && source[end] != '_';
    if (!isNamed)
    {
      this->Note("there is \"" + source.substr(at, source.find('\n', at) - at) + "\": " + what);
      return;
    }
  }
}
}
