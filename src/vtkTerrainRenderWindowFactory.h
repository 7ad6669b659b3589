// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainRenderWindowFactory
 * @brief   lets vtkRenderWindow::New choose a window at run time, for VTK < 9.4
 *
 * VTK 9.1 gives an X window whatever the machine has, and ends the program where no display opens.
 * With this factory vtkRenderWindow::New gives what later versions of VTK give by themselves:
 * - the window that the environment variable VTK_DEFAULT_OPENGL_WINDOW names:
 * vtkXOpenGLRenderWindow, vtkEGLRenderWindow (vtkTerrainEGLRenderWindow here) or
 * vtkOSOpenGLRenderWindow (vtkTerrainOSMesaRenderWindow here);
 * - else, of X, EGL and OSMesa in this order, the first that works on this machine.
 *
 * Where none works, or the variable holds another name, the result is a
 * vtkTerrainOffscreenRenderWindow, whose one error names what was tried.
 *
 * vtkRenderWindowInteractor::New gives a vtkGenericRenderWindowInteractor wherever the window is
 * not X: its Start returns at once. VTK 9.1's own would end the program for want of an X server.
 *
 * The factory is registered, ahead of all others, when the library vtkTerrain is loaded. A program
 * that links to vtkTerrain::Terrain loads it, even if it names none of its symbols and links with
 * --as-needed: the target's link options name one for it.
 *
 * @sa vtkTerrainEGLRenderWindow, vtkTerrainOSMesaRenderWindow
 */
#ifndef vtkTerrainRenderWindowFactory_h
#define vtkTerrainRenderWindowFactory_h

#include "vtkObjectFactory.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainRenderWindowFactory : public vtkObjectFactory
{
public:
  static vtkTerrainRenderWindowFactory* New();
  vtkTypeMacro(vtkTerrainRenderWindowFactory, vtkObjectFactory)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainRenderWindowFactory(const vtkTerrainRenderWindowFactory&) = delete;
  void operator=(const vtkTerrainRenderWindowFactory&) = delete;

  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

  /// Registers a factory ahead of those registered so far; does nothing if there is one already.
  static void Register();

  /// Removes the factory that Register registered, if there is one.
  static void Unregister();

protected:
  vtkTerrainRenderWindowFactory();
  ~vtkTerrainRenderWindowFactory() override = default;
};

#endif
