// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTesting.h"

#include "render/Driver.h"

#include "vtkCommand.h"
#include "vtkNew.h"

namespace vtkTerrainTesting
{
namespace
{
/// Where messages go in place of being failures.
std::vector<std::string>* Expected = nullptr;

/// Names of objects are looked at up to this one; drivers count them from 1.
constexpr GLuint kLastName = 20000;

//------------------------------------------------------------------------------
void OnMessage(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/,
  GLsizei /*length*/, const GLchar* text, const void* /*user*/)
{
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
  {
    return;
  }
  if (Expected)
  {
    Expected->emplace_back(text);
    return;
  }
  ADD_FAILURE() << "OpenGL: " << text;
}

//------------------------------------------------------------------------------
/// Sets the callback once the context is there and current; again for a context of its own.
class Watch : public vtkCommand
{
public:
  static Watch* New()
  {
    return new Watch;
  }
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    if (glDebugMessageCallback)
    {
      glEnable(GL_DEBUG_OUTPUT);
      glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS); // in the call that is wrong, on this thread
      glDebugMessageCallback(OnMessage, nullptr);
    }
  }
};

//------------------------------------------------------------------------------
template <typename Function>
int CountNames(Function isObject)
{
  int count = 0;
  for (GLuint name = 1; isObject && name <= kLastName; ++name)
  {
    count += isObject(name) == GL_TRUE ? 1 : 0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
void WatchGL(vtkRenderer* renderer)
{
  const vtkNew<Watch> watch;
  renderer->AddObserver(vtkCommand::StartEvent, watch);
}

//------------------------------------------------------------------------------
ExpectedGLErrors::ExpectedGLErrors()
{
  Expected = &this->Messages;
}

//------------------------------------------------------------------------------
ExpectedGLErrors::~ExpectedGLErrors()
{
  Expected = nullptr;
}

//------------------------------------------------------------------------------
GLObjects CountGLObjects(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLObjects objects;
  objects.Textures = CountNames(glIsTexture);
  objects.Buffers = CountNames(glIsBuffer);
  objects.Framebuffers = CountNames(glIsFramebuffer);
  objects.Renderbuffers = CountNames(glIsRenderbuffer);
  objects.VertexArrays = CountNames(glIsVertexArray);
  objects.Queries = CountNames(glIsQuery);
  objects.Programs = CountNames(glIsProgram);
  objects.Shaders = CountNames(glIsShader);
  return objects;
}
}
