// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/GLContext.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <map>
#include <mutex>
#include <sstream>
#include <vector>

namespace terrain
{
namespace
{
//------------------------------------------------------------------------------
// True if the extension stands in the list, as a whole word.
bool HasExtension(const char* list, const std::string& extension)
{
  return list && (" " + std::string(list) + " ").find(" " + extension + " ") != std::string::npos;
}

//------------------------------------------------------------------------------
std::string ErrorText(const std::string& call)
{
  std::ostringstream text;
  text << call << " failed with EGL error 0x" << std::hex << eglGetError();
  return text.str();
}

//------------------------------------------------------------------------------
std::vector<EGLDeviceEXT> QueryDevices()
{
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!HasExtension(extensions, "EGL_EXT_platform_device"))
  {
    return {};
  }
  const auto query =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLint count = 0;
  if (!query || !query(0, nullptr, &count) || count <= 0)
  {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  query(count, devices.data(), &count);
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

//------------------------------------------------------------------------------
bool IsSoftware(EGLDeviceEXT device)
{
  const auto query =
    reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  return query && HasExtension(query(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

//------------------------------------------------------------------------------
// The initialised display of a platform, or EGL_NO_DISPLAY. Displays stay initialised until the
// process ends: other users of the same display would lose theirs with it.
EGLDisplay OpenPlatform(EGLenum platform, void* native)
{
  const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!getDisplay)
  {
    return EGL_NO_DISPLAY;
  }
  EGLDisplay display = getDisplay(platform, native, nullptr);
  EGLint major = 0;
  EGLint minor = 0;
  const bool works = display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor) &&
    (major > 1 || minor >= 4) && eglBindAPI(EGL_OPENGL_API);
  return works ? display : EGL_NO_DISPLAY;
}

//------------------------------------------------------------------------------
EGLDisplay OpenSurfaceless()
{
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!HasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    return EGL_NO_DISPLAY;
  }
  return OpenPlatform(EGL_PLATFORM_SURFACELESS_MESA, reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY));
}

//------------------------------------------------------------------------------
EGLDisplay OpenDevice(int device, std::string& whyNot)
{
  const std::vector<EGLDeviceEXT> devices = QueryDevices();
  if (static_cast<std::size_t>(device) >= devices.size())
  {
    whyNot = "EGL device " + std::to_string(device) + " is asked for, but EGL lists " +
      std::to_string(devices.size());
    return EGL_NO_DISPLAY;
  }
  EGLDisplay display =
    OpenPlatform(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(device)]);
  if (display == EGL_NO_DISPLAY)
  {
    whyNot = ErrorText("opening EGL device " + std::to_string(device));
  }
  return display;
}

//------------------------------------------------------------------------------
EGLDisplay OpenAny(std::string& whyNot)
{
  std::vector<EGLDeviceEXT> software;
  for (EGLDeviceEXT device : QueryDevices())
  {
    if (IsSoftware(device))
    {
      software.push_back(device);
      continue;
    }
    EGLDisplay display = OpenPlatform(EGL_PLATFORM_DEVICE_EXT, device);
    if (display != EGL_NO_DISPLAY)
    {
      return display;
    }
  }
  EGLDisplay display = OpenSurfaceless();
  for (std::size_t i = 0; i < software.size() && display == EGL_NO_DISPLAY; ++i)
  {
    display = OpenPlatform(EGL_PLATFORM_DEVICE_EXT, software[i]);
  }
  if (display == EGL_NO_DISPLAY)
  {
    whyNot = "EGL has neither a GPU nor a software renderer that works";
  }
  return display;
}

//------------------------------------------------------------------------------
// Displays that worked are kept, so that later windows do not try GPUs that fail again.
EGLDisplay GetDisplay(int device, std::string& whyNot)
{
  static std::mutex mutex;
  static std::map<int, EGLDisplay> displays;
  const int key = device < 0 ? -1 : device;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = displays.find(key);
  if (found != displays.end())
  {
    return found->second;
  }
  EGLDisplay display = key < 0 ? OpenAny(whyNot) : OpenDevice(key, whyNot);
  if (display != EGL_NO_DISPLAY)
  {
    displays[key] = display;
  }
  return display;
}

//------------------------------------------------------------------------------
class EGLContextOwner final : public GLContext
{
public:
  explicit EGLContextOwner(EGLDisplay display)
    : Display(display)
  {
  }

  ~EGLContextOwner() override
  {
    this->Release();
    if (this->Surface != EGL_NO_SURFACE)
    {
      eglDestroySurface(this->Display, this->Surface);
    }
    if (this->Context != EGL_NO_CONTEXT)
    {
      eglDestroyContext(this->Display, this->Context);
    }
  }

  EGLContextOwner(const EGLContextOwner&) = delete;
  void operator=(const EGLContextOwner&) = delete;

  bool Create(std::string& whyNot);
  bool MakeCurrent() override;
  bool IsCurrent() const override
  {
    return eglGetCurrentContext() == this->Context;
  }
  void Release() override;
  void* GetHandle() const override
  {
    return this->Context;
  }

private:
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
  EGLSurface Surface = EGL_NO_SURFACE;
};

//------------------------------------------------------------------------------
bool EGLContextOwner::Create(std::string& whyNot)
{
  eglBindAPI(EGL_OPENGL_API);
  const std::array<EGLint, 15> wanted = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 8,
    EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_RENDERABLE_TYPE,
    EGL_OPENGL_BIT, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(this->Display, wanted.data(), &config, 1, &count) || count < 1)
  {
    whyNot = "EGL has no configuration for OpenGL";
    return false;
  }
  const std::array<std::array<EGLint, 2>, 2> versions = { { { 4, 5 }, { 3, 2 } } };
  for (const auto& version : versions)
  {
    const std::array<EGLint, 7> attributes = { EGL_CONTEXT_MAJOR_VERSION, version[0],
      EGL_CONTEXT_MINOR_VERSION, version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, attributes.data());
    if (this->Context != EGL_NO_CONTEXT)
    {
      break;
    }
  }
  if (this->Context == EGL_NO_CONTEXT)
  {
    whyNot = ErrorText("eglCreateContext");
    return false;
  }
  // Windows draw into framebuffers of their own; the surface only gives the context a default one.
  const std::array<EGLint, 5> size = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
  this->Surface = eglCreatePbufferSurface(this->Display, config, size.data());
  if (this->Surface == EGL_NO_SURFACE)
  {
    whyNot = ErrorText("eglCreatePbufferSurface");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool EGLContextOwner::MakeCurrent()
{
  if (this->IsCurrent())
  {
    return true;
  }
  if (GLContext* other = GLContext::GetCurrent())
  {
    other->Release();
  }
  GLContext::ReleaseGLX();
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context))
  {
    return false;
  }
  GLContext::SetCurrent(this);
  return true;
}

//------------------------------------------------------------------------------
void EGLContextOwner::Release()
{
  if (this->Context != EGL_NO_CONTEXT && this->IsCurrent())
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  if (GLContext::GetCurrent() == this)
  {
    GLContext::SetCurrent(nullptr);
  }
}
}

//------------------------------------------------------------------------------
std::unique_ptr<GLContext> MakeEGLContext(int device, std::string& whyNot)
{
  EGLDisplay display = GetDisplay(device, whyNot);
  if (display == EGL_NO_DISPLAY)
  {
    return nullptr;
  }
  auto context = std::make_unique<EGLContextOwner>(display);
  if (!context->Create(whyNot))
  {
    return nullptr;
  }
  return context;
}

//------------------------------------------------------------------------------
int GetNumberOfEGLDevices()
{
  return static_cast<int>(QueryDevices().size());
}
}
