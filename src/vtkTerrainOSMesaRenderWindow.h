// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainOSMesaRenderWindow
 * @brief   a render window without a display through OSMesa, for VTK < 9.4
 *
 * The library libOSMesa is loaded when the first such window is used; Mesa brings it up to its
 * version 25.0. Draws the same pixels as vtkTerrainEGLRenderWindow with Mesa's software renderer.
 *
 * @sa vtkTerrainOffscreenRenderWindow, vtkTerrainRenderWindowFactory
 */
#ifndef vtkTerrainOSMesaRenderWindow_h
#define vtkTerrainOSMesaRenderWindow_h

#include "vtkTerrainModule.h" // For export macro
#include "vtkTerrainOffscreenRenderWindow.h"

class VTKTERRAIN_EXPORT vtkTerrainOSMesaRenderWindow : public vtkTerrainOffscreenRenderWindow
{
public:
  static vtkTerrainOSMesaRenderWindow* New();
  vtkTypeMacro(vtkTerrainOSMesaRenderWindow, vtkTerrainOffscreenRenderWindow)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainOSMesaRenderWindow(const vtkTerrainOSMesaRenderWindow&) = delete;
  void operator=(const vtkTerrainOSMesaRenderWindow&) = delete;

protected:
  vtkTerrainOSMesaRenderWindow() = default;
  ~vtkTerrainOSMesaRenderWindow() override;

  std::unique_ptr<terrain::GLContext> CreateContext(std::string& whyNot) override;
};

#endif
