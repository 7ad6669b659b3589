// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * OpenGL contexts without a display: what the windows of this module draw with. Private.
 *
 * A thread has one current context at most, whichever interface (GLX, EGL, OSMesa) made it.
 * libglvnd refuses to make a context current while one of another interface is, so MakeCurrent
 * releases that one first.
 */
#ifndef vtkTerrain_windows_GLContext_h
#define vtkTerrain_windows_GLContext_h

#include <memory>
#include <string>

namespace terrain
{
class GLContext
{
public:
  GLContext() = default;
  virtual ~GLContext() = default;
  GLContext(const GLContext&) = delete;
  void operator=(const GLContext&) = delete;

  /// Makes the context current on this thread; false if that failed.
  virtual bool MakeCurrent() = 0;

  /// True if the context is current on this thread.
  virtual bool IsCurrent() const = 0;

  /// Leaves this thread without a current context, if this one is current.
  virtual void Release() = 0;

  /// The EGLContext or OSMesaContext.
  virtual void* GetHandle() const = 0;

  /// The context of this module that is current on this thread, or null.
  static GLContext* GetCurrent();

protected:
  static void SetCurrent(GLContext* context);

  /// Releases a current context of GLX. libGLX is used only if the program has loaded it.
  static void ReleaseGLX();
};

/// An EGL context: OpenGL 3.2 or later, core profile.
/// @param device index into what eglQueryDevicesEXT lists; below 0: the first GPU that works, else
///        Mesa's software renderer.
/// @param[out] whyNot one sentence if null is returned.
std::unique_ptr<GLContext> MakeEGLContext(int device, std::string& whyNot);

/// Number of devices that EGL lists, software renderers included.
int GetNumberOfEGLDevices();

/// An OSMesa context: OpenGL 3.2 or later, core profile. libOSMesa is loaded by the first call.
/// @param[out] whyNot one sentence if null is returned.
std::unique_ptr<GLContext> MakeOSMesaContext(std::string& whyNot);
}
#endif
