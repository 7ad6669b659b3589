// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * OpenGL's names through the loader that VTK was built with, and who draws. Private to the module.
 */
#ifndef vtkTerrain_render_Driver_h
#define vtkTerrain_render_Driver_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // IWYU pragma: export
#else
#include "vtk_glew.h" // IWYU pragma: export
#endif

#include <cstring>

namespace terrain
{
/// True if the current context draws on the processor, with Mesa's llvmpipe.
inline bool IsSoftware()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && std::strstr(renderer, "llvmpipe");
}
}
#endif
