// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ComputeProgram.h"

#include "render/Driver.h"

#include <vector>

namespace terrain
{
//------------------------------------------------------------------------------
bool ComputeProgram::IsSupported()
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return major > 4 || (major == 4 && minor >= 3);
}

//------------------------------------------------------------------------------
std::string ComputeProgram::Build(const std::string& source)
{
  this->Release();
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const std::string text = "#version 430\n" + source;
  const char* lines = text.c_str();
  glShaderSource(shader, 1, &lines, nullptr);
  glCompileShader(shader);
  this->Program = glCreateProgram();
  glAttachShader(this->Program, shader);
  glLinkProgram(this->Program);

  GLint compiled = 0;
  GLint linked = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  glGetProgramiv(this->Program, GL_LINK_STATUS, &linked);
  std::string words;
  if (!compiled || !linked)
  {
    std::vector<char> log(4096);
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    words = log.data();
    if (compiled)
    {
      glGetProgramInfoLog(this->Program, static_cast<GLsizei>(log.size()), nullptr, log.data());
      words = log.data();
    }
    words = words.empty() ? "the compute shader does not link" : words;
  }
  glDeleteShader(shader);
  if (!words.empty())
  {
    this->Release();
    words = "A compute shader does not build: " + words;
  }
  return words;
}

//------------------------------------------------------------------------------
void ComputeProgram::Use()
{
  glUseProgram(this->Program);
}

//------------------------------------------------------------------------------
void ComputeProgram::Release()
{
  if (this->Program)
  {
    glDeleteProgram(this->Program);
  }
  this->Program = 0;
  this->Locations.clear();
}

//------------------------------------------------------------------------------
int ComputeProgram::Location(const char* name)
{
  const auto found = this->Locations.find(name);
  if (found != this->Locations.end())
  {
    return found->second;
  }
  return this->Locations[name] = glGetUniformLocation(this->Program, name);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, int value)
{
  glUniform1i(this->Location(name), value);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, float value)
{
  glUniform1f(this->Location(name), value);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, const glm::ivec2& value)
{
  glUniform2iv(this->Location(name), 1, &value[0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, const glm::vec2& value)
{
  glUniform2fv(this->Location(name), 1, &value[0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, const glm::vec4& value)
{
  glUniform4fv(this->Location(name), 1, &value[0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, const glm::mat3& value)
{
  glUniformMatrix3fv(this->Location(name), 1, GL_FALSE, &value[0][0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::Set(const char* name, const glm::mat4& value)
{
  glUniformMatrix4fv(this->Location(name), 1, GL_FALSE, &value[0][0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::SetArray(const char* name, int count, const glm::vec3* values)
{
  glUniform3fv(this->Location(name), count, &values[0][0]);
}

//------------------------------------------------------------------------------
void ComputeProgram::SetArray(const char* name, int count, const glm::vec4* values)
{
  glUniform4fv(this->Location(name), count, &values[0][0]);
}
}
