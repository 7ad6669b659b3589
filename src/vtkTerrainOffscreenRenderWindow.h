// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainOffscreenRenderWindow
 * @brief   a render window without a display, for VTK < 9.4
 *
 * Draws into framebuffers of its own, in a context of its own, which subclasses choose
 * (vtkTerrainEGLRenderWindow, vtkTerrainOSMesaRenderWindow). Everything a program does with an
 * off-screen window works: several windows at a time, SetSize, GetPixelData, GetZbufferData,
 * vtkWindowToImageFilter, picking. The context is created by Initialize, or by the first Render.
 *
 * The class itself has no context: vtkRenderWindow::New gives it where no other window can be had
 * (vtkTerrainRenderWindowFactory). Such a window reports one error when it is first used, then
 * draws nothing and reads back zeros; SupportsOpenGL is 0 and GetOpenGLSupportMessage says why.
 * A subclass whose context cannot be created behaves the same.
 *
 * Limits: no sharing between windows (SetSharedRenderWindow), no on-screen mode.
 *
 * @sa vtkTerrainRenderWindowFactory
 */
#ifndef vtkTerrainOffscreenRenderWindow_h
#define vtkTerrainOffscreenRenderWindow_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace terrain
{
class GLContext;
}

class VTKTERRAIN_EXPORT vtkTerrainOffscreenRenderWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkTerrainOffscreenRenderWindow* New();
  vtkTypeMacro(vtkTerrainOffscreenRenderWindow, vtkOpenGLRenderWindow)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainOffscreenRenderWindow(const vtkTerrainOffscreenRenderWindow&) = delete;
  void operator=(const vtkTerrainOffscreenRenderWindow&) = delete;

  /// Creates the context without an error message where that fails; true if the window has one.
  bool OpenContext();

  /// Why the window has no context, one sentence; empty unless creating it has failed.
  std::string GetWhyNot() const
  {
    return this->WhyNot;
  }

  /// Sets the sentence that a window without a context reports. For the factory.
  void SetWhyNot(const std::string& whyNot)
  {
    this->WhyNot = whyNot;
  }

  /// Creates the context, if there is none, and prepares it for VTK. One error if that fails.
  void Initialize() override;

  /// Releases what the scene holds in the context, and the context itself.
  void Finalize() override;

  /// 1 if the window has a context or can create it, else 0 (see GetOpenGLSupportMessage).
  int SupportsOpenGL() override;

  void Render() override;
  void Frame() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  void OpenGLInitContext() override;
  const char* ReportCapabilities() override;
  void WindowRemap() override;

  /// What a screen would have: 1920 x 1080 pixels.
  int* GetScreenSize() VTK_SIZEHINT(2) override;

  /// The EGLContext or OSMesaContext, or null before Initialize.
  void* GetGenericContext() override;

  using vtkOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;

protected:
  vtkTerrainOffscreenRenderWindow();
  ~vtkTerrainOffscreenRenderWindow() override;

  /// A new context, or null and one sentence in whyNot.
  virtual std::unique_ptr<terrain::GLContext> CreateContext(std::string& whyNot);

  /// What Finalize does, callable from destructors.
  void Close();

  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;
  void CreateAWindow() override;
  void DestroyWindow() override;

private:
  std::unique_ptr<terrain::GLContext> Context;
  terrain::GLContext* OuterContext = nullptr;
  std::string WhyNot;
  bool ErrorReported = false;
};

#endif
