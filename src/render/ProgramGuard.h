// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps programs that do not build away from VTK, which reports them anew in each frame, and up to
 * VTK 9.1 draws with them and ends the process. Private to the module.
 */
#ifndef vtkTerrain_render_ProgramGuard_h
#define vtkTerrain_render_ProgramGuard_h

#include "vtkShader.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>

class vtkRenderWindow;

namespace terrain
{
class ProgramGuard
{
public:
  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  /// Builds a program from complete texts in the window, whose context is current; VTK then finds
  /// it built. Where it does not build, the texts become those of a program that draws nothing.
  /// Returns a sentence with the driver's words in that case, once for each program, else an empty
  /// string.
  std::string Check(const Shaders& shaders, vtkRenderWindow* window);

private:
  /// Hashes of the texts whose errors were returned.
  std::set<std::size_t> Reported;
};
}
#endif
