// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/GLContext.h"

#include <dlfcn.h>

namespace terrain
{
namespace
{
thread_local GLContext* CurrentContext = nullptr;
}

//------------------------------------------------------------------------------
GLContext* GLContext::GetCurrent()
{
  return CurrentContext;
}

//------------------------------------------------------------------------------
void GLContext::SetCurrent(GLContext* context)
{
  CurrentContext = context;
}

//------------------------------------------------------------------------------
void GLContext::ReleaseGLX()
{
  using GetCurrentDisplay = void* (*)();
  using GlxMakeCurrent = int (*)(void* display, unsigned long drawable, void* context);
  static const auto getCurrentDisplay =
    reinterpret_cast<GetCurrentDisplay>(dlsym(RTLD_DEFAULT, "glXGetCurrentDisplay"));
  static const auto makeCurrent =
    reinterpret_cast<GlxMakeCurrent>(dlsym(RTLD_DEFAULT, "glXMakeCurrent"));
  void* display = getCurrentDisplay ? getCurrentDisplay() : nullptr;
  if (display && makeCurrent)
  {
    makeCurrent(display, 0, nullptr);
  }
}
}
