// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The text of one of VTK's shaders while the terrain's code goes into it; only UniformPasser and
 * vtkTerrainDepthPass edit such text besides. What must be there and is not becomes a problem, of
 * which the first is kept: a picture would be silently wrong. Private to the module.
 *
 * The terrain's code stands between two lines of comment, its marks; what follows VTK's own text
 * leaves it alone. Tags stay outside, for those who come later.
 */
#ifndef vtkTerrain_render_ShaderText_h
#define vtkTerrain_render_ShaderText_h

#include "vtkShader.h"

#include <string>

namespace terrain
{
class ShaderText
{
public:
  /// Edits a shader; problem is left alone unless it is empty.
  ShaderText(vtkShader* shader, std::string& problem)
    : Shader(shader)
    , Problem(problem)
  {
  }

  /// Replaces one of VTK's tags, which must be there, by code.
  void Replace(const std::string& tag, const std::string& code);
  /// Extends: code before or behind one of VTK's tags, which must be there and stays.
  void Before(const std::string& tag, const std::string& code);
  void Behind(const std::string& tag, const std::string& code);

  /// Puts text in the place of a pattern wherever VTK's own text has it; false if it has it
  /// nowhere.
  bool Follow(const std::string& pattern, const std::string& text);
  /// The same where it must be there; what: the terrain's part that would be wrong without.
  void Require(const std::string& pattern, const std::string& text, const std::string& what);
  /// A vector must have some of its components named, out of these, wherever VTK's own text has it.
  void RequireSwizzles(
    const std::string& vector, const std::string& components, const std::string& what);

private:
  void Insert(const std::string& tag, const std::string& before, const std::string& behind,
    const std::string& code);
  void Note(const std::string& problem);

  vtkShader* Shader;
  std::string& Problem;
};
}
#endif
