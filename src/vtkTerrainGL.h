// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * OpenGL's names through the loader that VTK was built with, and who draws. Private to the module.
 */
#ifndef vtkTerrainGL_h
#define vtkTerrainGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // IWYU pragma: export
#else
#include "vtk_glew.h" // IWYU pragma: export
#endif

#include <cstring>

/// True if the current context draws on the processor, with Mesa's llvmpipe.
inline bool vtkTerrainIsSoftware()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && std::strstr(renderer, "llvmpipe");
}

#endif
