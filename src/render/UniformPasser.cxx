// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/UniformPasser.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace terrain
{
namespace
{
/// Components of the uniforms that are passed; drivers have 128 for all varyings.
constexpr int kMostPassedComponents = 120;

int ComponentsOf(const std::string& type)
{
  return type == "mat3" ? 9 : type == "float" || type == "int" ? 1 : type.back() - '0';
}

/// Follows which lines of a source the names that it defines leave out: those under #ifdef and
/// #ifndef of our own names, whose other branch is read instead. Other conditions count as met.
class Branches
{
public:
  /// True if a line is read.
  bool Read(const std::string& line)
  {
    std::istringstream words(line);
    std::string directive;
    std::string name;
    words >> directive >> name;
    const bool ours = name.rfind("TERRAIN_", 0) == 0;
    if (directive == "#define")
    {
      this->Defined.insert(name);
    }
    else if (directive == "#ifdef" || directive == "#ifndef" || directive == "#if")
    {
      const bool met = (this->Defined.count(name) != 0) == (directive == "#ifdef");
      const bool known = ours && directive != "#if";
      this->Open.push_back({ known, !known || met });
    }
    else if (!this->Open.empty() && (directive == "#else" || directive == "#elif"))
    {
      this->Open.back().Read = !this->Open.back().Known || !this->Open.back().Read;
    }
    else if (!this->Open.empty() && directive == "#endif")
    {
      this->Open.pop_back();
    }
    return std::all_of(
      this->Open.begin(), this->Open.end(), [](const Branch& branch) { return branch.Read; });
  }

private:
  struct Branch
  {
    bool Known;
    bool Read;
  };
  std::set<std::string> Defined;
  std::vector<Branch> Open;
};

class Passer
{
public:
  explicit Passer(const std::string& vertexSource)
    : VertexSource(vertexSource)
  {
  }

  /// A line with inputs instead of uniforms.
  std::string WithInputs(const std::string& line)
  {
    static const std::regex uniform("uniform (float|int|ivec2|vec[234]|mat3) (\\w+);");
    std::smatch match;
    if (!std::regex_search(line, match, uniform))
    {
      return line;
    }
    const std::string type = match[1];
    const std::string name = match[2];
    const std::string rest = this->WithInputs(match.suffix());
    if (this->Left < ComponentsOf(type) || this->VertexSource.find(name) != std::string::npos)
    {
      return match.prefix().str() + match[0].str() + rest;
    }
    this->Left -= ComponentsOf(type);
    const std::string passed = name + "VSOutput";
    this->Declarations += "uniform " + type + " " + name + ";\n";
    this->Declarations += "flat out " + type + " " + passed + ";\n";
    this->Assignments += "  " + passed + " = " + name + ";\n";
    return match.prefix().str() + "flat in " + type + " " + passed + ";" + rest + "\n#define " +
      name + " " + passed;
  }

  std::string Declarations;
  std::string Assignments;

private:
  const std::string& VertexSource;
  int Left = kMostPassedComponents;
};
}

//------------------------------------------------------------------------------
void PassUniforms(std::string& vertexSource, std::string& fragmentSource)
{
  const std::size_t mainAt = vertexSource.find("void main()");
  const std::size_t bodyAt =
    mainAt == std::string::npos ? std::string::npos : vertexSource.find('{', mainAt);
  if (bodyAt == std::string::npos)
  {
    return;
  }
  Branches branches;
  Passer passer(vertexSource);
  std::istringstream lines(fragmentSource);
  std::string fragment;
  for (std::string line; std::getline(lines, line);)
  {
    fragment += (branches.Read(line) ? passer.WithInputs(line) : line) + "\n";
  }
  fragmentSource = fragment;
  vertexSource.insert(bodyAt + 1, "\n" + passer.Assignments);
  vertexSource.insert(mainAt, passer.Declarations);
}
}
