// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/ProgramGuard.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <functional>

namespace terrain
{
namespace
{
// VTK reports each error twice, with thousands of lines of source.
class ScopedSilence
{
public:
  ScopedSilence()
  {
    vtkObject::SetGlobalWarningDisplay(0);
  }
  ~ScopedSilence()
  {
    vtkObject::SetGlobalWarningDisplay(this->Before);
  }
  ScopedSilence(const ScopedSilence&) = delete;
  void operator=(const ScopedSilence&) = delete;

private:
  int Before = vtkObject::GetGlobalWarningDisplay();
};

// What the driver says of texts that do not compile, or else do not link.
std::string FindWords(ProgramGuard::Shaders& shaders, vtkOpenGLRenderWindow* window)
{
  const vtkNew<vtkShaderProgram> program;
  program->GetVertexShader()->SetSource(shaders[vtkShader::Vertex]->GetSource());
  program->GetFragmentShader()->SetSource(shaders[vtkShader::Fragment]->GetSource());
  program->GetGeometryShader()->SetSource(shaders[vtkShader::Geometry]->GetSource());
  window->GetShaderCache()->ReadyShaderProgram(program);
  std::string words = program->GetVertexShader()->GetError() +
    program->GetFragmentShader()->GetError() + program->GetGeometryShader()->GetError() +
    program->GetError();
  program->ReleaseGraphicsResources(window);
  return "Cannot draw the terrain, its shaders do not build: " +
    (words.empty() ? "the driver says nothing" : words);
}
}

//------------------------------------------------------------------------------
std::string ProgramGuard::Check(const Shaders& shaders, vtkRenderWindow* window)
{
  const ScopedSilence silence;
  auto* glWindow = static_cast<vtkOpenGLRenderWindow*>(window);
  // VTK's cache keeps the objects that it is given first: copies, for the texts may change below
  std::map<vtkShader::Type, vtkSmartPointer<vtkShader>> copies;
  Shaders built;
  std::string whole;
  for (const auto& [stage, shader] : shaders)
  {
    copies[stage] = vtkSmartPointer<vtkShader>::New();
    copies[stage]->SetType(stage);
    copies[stage]->SetSource(shader->GetSource());
    built[stage] = copies[stage];
    whole += shader->GetSource();
  }
  if (glWindow->GetShaderCache()->ReadyShaderProgram(built))
  {
    return {};
  }
  // all vertices in one place beyond the far plane
  shaders.at(vtkShader::Vertex)
    ->SetSource("//VTK::System::Dec\nvoid main() { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); }\n");
  shaders.at(vtkShader::Geometry)->SetSource("");
  shaders.at(vtkShader::Fragment)
    ->SetSource("//VTK::System::Dec\n//VTK::Output::Dec\nvoid main() { discard; }\n");
  const bool isNew = this->Reported.insert(std::hash<std::string>()(whole)).second;
  return isNew ? FindWords(built, glWindow) : std::string();
}
}
