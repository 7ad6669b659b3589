// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainEGLRenderWindow
 * @brief   a render window without a display through EGL, for VTK < 9.4
 *
 * DeviceIndex (of vtkRenderWindow) chooses the device, by its place in what eglQueryDevicesEXT
 * lists. Its default is the environment variable VTK_DEFAULT_EGL_DEVICE_INDEX, as in later versions
 * of VTK; where that is not set, -1: the first GPU that works, else Mesa's software renderer. A
 * device that is asked for and does not exist is an error, not replaced by another.
 *
 * @sa vtkTerrainOffscreenRenderWindow, vtkTerrainRenderWindowFactory
 */
#ifndef vtkTerrainEGLRenderWindow_h
#define vtkTerrainEGLRenderWindow_h

#include "vtkTerrainModule.h" // For export macro
#include "vtkTerrainOffscreenRenderWindow.h"

class VTKTERRAIN_EXPORT vtkTerrainEGLRenderWindow : public vtkTerrainOffscreenRenderWindow
{
public:
  static vtkTerrainEGLRenderWindow* New();
  vtkTypeMacro(vtkTerrainEGLRenderWindow, vtkTerrainOffscreenRenderWindow)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainEGLRenderWindow(const vtkTerrainEGLRenderWindow&) = delete;
  void operator=(const vtkTerrainEGLRenderWindow&) = delete;

  /// Chooses the device; a context on another device is closed, and created anew when next needed.
  void SetDeviceIndex(int index) override;

  /// Number of devices that EGL lists, software renderers included.
  int GetNumberOfDevices() override;

protected:
  vtkTerrainEGLRenderWindow();
  ~vtkTerrainEGLRenderWindow() override;

  std::unique_ptr<terrain::GLContext> CreateContext(std::string& whyNot) override;
};

#endif
