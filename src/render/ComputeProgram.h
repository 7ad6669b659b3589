// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A compute program, which vtkShaderProgram does not know in every version. Private to the module.
 */
#ifndef vtkTerrain_render_ComputeProgram_h
#define vtkTerrain_render_ComputeProgram_h

#include "render/Uniforms.h"

#include <map>
#include <string>

class vtkOpenGLRenderWindow;

namespace terrain
{
class ComputeProgram final : public Uniforms
{
public:
  /// True if the window's OpenGL, which must be current, has compute shaders (4.3).
  static bool IsSupported();

  /// Compiles and links a source without its version line. Returns an empty string, or the
  /// compiler's words.
  std::string Build(const std::string& source);
  bool IsBuilt() const
  {
    return this->Program != 0;
  }
  /// Makes the program current; VTK must be told to make its own current afterwards.
  void Use();
  /// Deletes the program; its context must be current.
  void Release();

  bool Uses(const char* name) override
  {
    return this->Location(name) >= 0;
  }
  void Set(const char* name, int value) override;
  void Set(const char* name, float value) override;
  void Set(const char* name, const glm::ivec2& value) override;
  void Set(const char* name, const glm::vec2& value) override;
  void Set(const char* name, const glm::vec4& value) override;
  void Set(const char* name, const glm::mat3& value) override;
  void Set(const char* name, const glm::mat4& value) override;
  void SetArray(const char* name, int count, const glm::vec3* values) override;
  void SetArray(const char* name, int count, const glm::vec4* values) override;

private:
  int Location(const char* name);

  unsigned int Program = 0;
  std::map<std::string, int> Locations;
};
}
#endif
