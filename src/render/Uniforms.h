// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where uniforms go: a program of VTK's, or a compute program of ours. Private to the module.
 */
#ifndef vtkTerrain_render_Uniforms_h
#define vtkTerrain_render_Uniforms_h

#include "vtkShaderProgram.h"

#include <glm/glm.hpp>

namespace terrain
{
class Uniforms
{
public:
  virtual ~Uniforms() = default;
  /// True if the program has the uniform; setting one that it has not does nothing.
  virtual bool Uses(const char* name) = 0;
  virtual void Set(const char* name, int value) = 0;
  virtual void Set(const char* name, float value) = 0;
  virtual void Set(const char* name, const glm::ivec2& value) = 0;
  virtual void Set(const char* name, const glm::vec2& value) = 0;
  virtual void Set(const char* name, const glm::vec4& value) = 0;
  virtual void Set(const char* name, const glm::mat3& value) = 0;
  virtual void Set(const char* name, const glm::mat4& value) = 0;
  virtual void SetArray(const char* name, int count, const glm::vec3* values) = 0;
  virtual void SetArray(const char* name, int count, const glm::vec4* values) = 0;
};

/// The uniforms of a program that VTK made.
class ProgramUniforms final : public Uniforms
{
public:
  explicit ProgramUniforms(vtkShaderProgram* program)
    : Program(program)
  {
  }
  bool Uses(const char* name) override
  {
    return this->Program->IsUniformUsed(name);
  }
  void Set(const char* name, int value) override
  {
    this->Program->SetUniformi(name, value);
  }
  void Set(const char* name, float value) override
  {
    this->Program->SetUniformf(name, value);
  }
  void Set(const char* name, const glm::ivec2& value) override
  {
    this->Program->SetUniform2i(name, &value[0]);
  }
  void Set(const char* name, const glm::vec2& value) override
  {
    this->Program->SetUniform2f(name, &value[0]);
  }
  void Set(const char* name, const glm::vec4& value) override
  {
    this->Program->SetUniform4f(name, &value[0]);
  }
  void Set(const char* name, const glm::mat3& value) override
  {
    glm::mat3 copy = value;
    this->Program->SetUniformMatrix3x3(name, &copy[0][0]);
  }
  void Set(const char* name, const glm::mat4& value) override
  {
    glm::mat4 copy = value;
    this->Program->SetUniformMatrix4x4(name, &copy[0][0]);
  }
  void SetArray(const char* name, int count, const glm::vec3* values) override
  {
    this->Program->SetUniform3fv(name, count, &values[0][0]);
  }
  void SetArray(const char* name, int count, const glm::vec4* values) override
  {
    this->Program->SetUniform4fv(name, count, &values[0][0]);
  }

private:
  vtkShaderProgram* Program;
};
}
#endif
