// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGLContext.h"

#include <dlfcn.h>

namespace
{
thread_local vtkTerrainGLContext* CurrentContext = nullptr;
}

//------------------------------------------------------------------------------
vtkTerrainGLContext* vtkTerrainGLContext::GetCurrent()
{
  return CurrentContext;
}

//------------------------------------------------------------------------------
void vtkTerrainGLContext::SetCurrent(vtkTerrainGLContext* context)
{
  CurrentContext = context;
}

//------------------------------------------------------------------------------
void vtkTerrainGLContext::ReleaseGLX()
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
