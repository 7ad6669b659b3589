// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// OSMesa's own OpenGL functions are not those that VTK calls: VTK's come from libglvnd, which
// passes calls on to whatever table libGLX or libEGL has set. Here libglvnd is given a table of
// OSMesa's functions, through the interface between libGLdispatch and its window-system libraries
// (ABI version 1, src/GLdispatch/GLdispatch.h of libglvnd).
#include "windows/GLContext.h"

#include <EGL/egl.h>
#include <dlfcn.h>

#include <array>
#include <initializer_list>

namespace terrain
{
namespace
{
// Values of GL/osmesa.h, which newer versions of Mesa no longer bring.
constexpr int kOSMesaFormat = 0x22;
constexpr int kOSMesaRGBA = 0x1908;
constexpr int kOSMesaDepthBits = 0x30;
constexpr int kOSMesaProfile = 0x33;
constexpr int kOSMesaCoreProfile = 0x34;
constexpr int kOSMesaMajorVersion = 0x36;
constexpr int kOSMesaMinorVersion = 0x37;
constexpr unsigned int kGLUnsignedByte = 0x1401;

constexpr int kDispatchABIVersion = 1;
// Owners of a thread's state: 0 is GLX, 1 is EGL.
constexpr int kDispatchTag = 2;

// Layout given by the ABI.
struct DispatchThreadState
{
  int Tag;
  void (*ThreadDestroyed)(DispatchThreadState*);
  void* Private;
};

using Procedure = void (*)();

//------------------------------------------------------------------------------
// The functions of libOSMesa and libGLdispatch, loaded once and never unloaded.
struct Libraries
{
  void* (*CreateContextAttribs)(const int* attributes, void* shared) = nullptr;
  void (*DestroyContext)(void* context) = nullptr;
  unsigned char (*OSMesaMakeCurrent)(
    void* context, void* buffer, unsigned int type, int width, int height) = nullptr;
  void* (*GetCurrentContext)() = nullptr;
  Procedure (*GetProcAddress)(const char* name) = nullptr;

  int (*DispatchGetABIVersion)() = nullptr;
  void (*DispatchInit)() = nullptr;
  int (*DispatchNewVendorID)() = nullptr;
  void* (*DispatchCreateTable)(void* (*getProcAddress)(const char*, void*), void*) = nullptr;
  unsigned char (*DispatchMakeCurrent)(
    DispatchThreadState* state, void* table, int vendor, const void* patch) = nullptr;
  void (*DispatchLoseCurrent)() = nullptr;
  DispatchThreadState* (*DispatchGetCurrentThreadState)() = nullptr;

  void* Table = nullptr;
  int Vendor = 0;
  std::string WhyNot; ///< empty if all is loaded

  Libraries();

private:
  void* Open(std::initializer_list<const char*> names);
  template <typename Function>
  void Load(void* library, const char* name, Function& function);
};

//------------------------------------------------------------------------------
void* Libraries::Open(std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL))
    {
      return library;
    }
  }
  if (this->WhyNot.empty())
  {
    this->WhyNot = std::string("the library ") + *names.begin() + " cannot be loaded";
  }
  return nullptr;
}

//------------------------------------------------------------------------------
template <typename Function>
void Libraries::Load(void* library, const char* name, Function& function)
{
  function = library ? reinterpret_cast<Function>(dlsym(library, name)) : nullptr;
  if (!function && this->WhyNot.empty())
  {
    this->WhyNot = std::string("the function ") + name + " is missing";
  }
}

//------------------------------------------------------------------------------
Libraries::Libraries()
{
  void* mesa = this->Open({ "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" });
  this->Load(mesa, "OSMesaCreateContextAttribs", this->CreateContextAttribs);
  this->Load(mesa, "OSMesaDestroyContext", this->DestroyContext);
  this->Load(mesa, "OSMesaMakeCurrent", this->OSMesaMakeCurrent);
  this->Load(mesa, "OSMesaGetCurrentContext", this->GetCurrentContext);
  this->Load(mesa, "OSMesaGetProcAddress", this->GetProcAddress);

  void* dispatch = this->Open({ "libGLdispatch.so.0" });
  this->Load(dispatch, "__glDispatchGetABIVersion", this->DispatchGetABIVersion);
  this->Load(dispatch, "__glDispatchInit", this->DispatchInit);
  this->Load(dispatch, "__glDispatchNewVendorID", this->DispatchNewVendorID);
  this->Load(dispatch, "__glDispatchCreateTable", this->DispatchCreateTable);
  this->Load(dispatch, "__glDispatchMakeCurrent", this->DispatchMakeCurrent);
  this->Load(dispatch, "__glDispatchLoseCurrent", this->DispatchLoseCurrent);
  this->Load(dispatch, "__glDispatchGetCurrentThreadState", this->DispatchGetCurrentThreadState);
  if (!this->WhyNot.empty())
  {
    return;
  }
  if (this->DispatchGetABIVersion() != kDispatchABIVersion)
  {
    this->WhyNot = "libGLdispatch has ABI version " +
      std::to_string(this->DispatchGetABIVersion()) + " instead of 1";
    return;
  }
  this->DispatchInit();
  this->Vendor = this->DispatchNewVendorID();
  this->Table = this->DispatchCreateTable([](const char* name, void* self)
    { return reinterpret_cast<void*>(static_cast<Libraries*>(self)->GetProcAddress(name)); },
    this);
  if (!this->Table)
  {
    this->WhyNot = "libGLdispatch gives no dispatch table";
  }
}

//------------------------------------------------------------------------------
Libraries& GetLibraries()
{
  static Libraries libraries;
  return libraries;
}

//------------------------------------------------------------------------------
// All OSMesa contexts of a thread share its one state in libGLdispatch.
DispatchThreadState& GetThreadState()
{
  thread_local DispatchThreadState state = { kDispatchTag, [](DispatchThreadState*) {}, nullptr };
  return state;
}

//------------------------------------------------------------------------------
class OSMesaContextOwner final : public GLContext
{
public:
  explicit OSMesaContextOwner(void* context)
    : Context(context)
  {
  }

  ~OSMesaContextOwner() override
  {
    this->Release();
    GetLibraries().DestroyContext(this->Context);
  }

  OSMesaContextOwner(const OSMesaContextOwner&) = delete;
  void operator=(const OSMesaContextOwner&) = delete;

  bool MakeCurrent() override;
  bool IsCurrent() const override;
  void Release() override;
  void* GetHandle() const override
  {
    return this->Context;
  }

private:
  void* Context = nullptr;
  // Windows draw into framebuffers of their own; OSMesa asks for a buffer all the same.
  alignas(16) std::array<unsigned char, 1024> Buffer{}; // 16 x 16 RGBA
};

//------------------------------------------------------------------------------
bool OSMesaContextOwner::IsCurrent() const
{
  const Libraries& libraries = GetLibraries();
  return libraries.DispatchGetCurrentThreadState() == &GetThreadState() &&
    libraries.GetCurrentContext() == this->Context;
}

//------------------------------------------------------------------------------
bool OSMesaContextOwner::MakeCurrent()
{
  if (this->IsCurrent())
  {
    return true;
  }
  const Libraries& libraries = GetLibraries();
  if (eglGetCurrentContext() != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  GLContext::ReleaseGLX();
  GLContext::SetCurrent(nullptr);
  if (!libraries.OSMesaMakeCurrent(this->Context, this->Buffer.data(), kGLUnsignedByte, 16, 16))
  {
    return false;
  }
  if (libraries.DispatchGetCurrentThreadState() != &GetThreadState() &&
    !libraries.DispatchMakeCurrent(&GetThreadState(), libraries.Table, libraries.Vendor, nullptr))
  {
    libraries.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    return false;
  }
  GLContext::SetCurrent(this);
  return true;
}

//------------------------------------------------------------------------------
void OSMesaContextOwner::Release()
{
  const Libraries& libraries = GetLibraries();
  if (this->IsCurrent())
  {
    libraries.DispatchLoseCurrent();
    libraries.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  }
  if (GLContext::GetCurrent() == this)
  {
    GLContext::SetCurrent(nullptr);
  }
}
}

//------------------------------------------------------------------------------
std::unique_ptr<GLContext> MakeOSMesaContext(std::string& whyNot)
{
  const Libraries& libraries = GetLibraries();
  if (!libraries.WhyNot.empty())
  {
    whyNot = libraries.WhyNot;
    return nullptr;
  }
  const std::array<int, 11> attributes = { kOSMesaFormat, kOSMesaRGBA, kOSMesaDepthBits, 24,
    kOSMesaProfile, kOSMesaCoreProfile, kOSMesaMajorVersion, 3, kOSMesaMinorVersion, 2, 0 };
  void* context = libraries.CreateContextAttribs(attributes.data(), nullptr);
  if (!context)
  {
    whyNot = "OSMesaCreateContextAttribs gives no OpenGL 3.2 context";
    return nullptr;
  }
  return std::make_unique<OSMesaContextOwner>(context);
}
}
