// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The one place where versions of VTK are told apart. Private to the module and its tests.
 *
 * VTKTERRAIN_OWN_WINDOWS is 1 where the module brings render windows of its own (VTK < 9.4), else
 * 0. Driver.h, included, is the header of VTK's OpenGL functions.
 */
#ifndef vtkTerrain_render_Compatibility_h
#define vtkTerrain_render_Compatibility_h

#include "render/Driver.h" // IWYU pragma: export

#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 4)
#define VTKTERRAIN_OWN_WINDOWS 0
#else
#define VTKTERRAIN_OWN_WINDOWS 1
#endif

#endif
