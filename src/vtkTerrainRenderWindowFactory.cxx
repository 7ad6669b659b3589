// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRenderWindowFactory.h"

#include "vtkTerrainEGLRenderWindow.h"
#include "vtkTerrainOSMesaRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <dlfcn.h>
#include <map>
#include <string>

vtkStandardNewMacro(vtkTerrainRenderWindowFactory);

namespace
{
constexpr const char* kWindowVariable = "VTK_DEFAULT_OPENGL_WINDOW";

//------------------------------------------------------------------------------
// Empty if the display in DISPLAY opens and has GLX, else why not. VTK's X window would end the
// program in these cases. The libraries are those that VTK has loaded.
std::string WhyNoX()
{
  using Open = void* (*)(const char* name);
  using Query = int (*)(void* display, int* error, int* event);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  const auto query = reinterpret_cast<Query>(dlsym(RTLD_DEFAULT, "glXQueryExtension"));
  if (!open || !query)
  {
    return "the program has no X library";
  }
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return "DISPLAY is not set";
  }
  // The connection stays open: closing the only one would make some servers reset themselves, just
  // when the window is about to connect.
  static std::map<std::string, void*> displays;
  void*& display = displays[name];
  display = display ? display : open(name);
  if (!display)
  {
    return std::string("the display ") + name + " does not open";
  }
  const bool hasGLX = query(display, nullptr, nullptr) != 0;
  return hasGLX ? std::string() : std::string("the display ") + name + " has no GLX";
}

//------------------------------------------------------------------------------
// Appends to tried, for the error message.
void Append(std::string& tried, const char* what, const std::string& whyNot)
{
  tried += (tried.empty() ? "" : "; ") + std::string(what) + ": " + whyNot;
}

//------------------------------------------------------------------------------
template <typename Window>
vtkSmartPointer<vtkTerrainOffscreenRenderWindow> Try(const char* what, std::string& tried)
{
  vtkSmartPointer<vtkTerrainOffscreenRenderWindow> window = vtkSmartPointer<Window>::New();
  if (window->OpenContext())
  {
    return window;
  }
  Append(tried, what, window->GetWhyNot());
  return nullptr;
}

//------------------------------------------------------------------------------
// The window that is asked for; empty: any.
std::string WantedWindow()
{
  const char* value = std::getenv(kWindowVariable);
  return value ? value : "";
}

//------------------------------------------------------------------------------
// True if the window is to be VTK's own, through X; else tried says why not, if X was considered.
bool ChoosesX(const std::string& wanted, std::string& tried)
{
  if (!wanted.empty() && wanted != "vtkXOpenGLRenderWindow")
  {
    return false;
  }
  const std::string whyNot = WhyNoX();
  if (!whyNot.empty())
  {
    Append(tried, "X", whyNot);
  }
  return whyNot.empty();
}

//------------------------------------------------------------------------------
// Null leaves the choice to the next factory, which is VTK's own and gives an X window.
vtkObject* CreateWindow()
{
  const std::string wanted = WantedWindow();
  const bool any = wanted.empty();
  std::string tried;
  if (ChoosesX(wanted, tried))
  {
    return nullptr;
  }
  vtkSmartPointer<vtkTerrainOffscreenRenderWindow> window;
  if (any || wanted == "vtkEGLRenderWindow")
  {
    window = Try<vtkTerrainEGLRenderWindow>("EGL", tried);
  }
  if (!window && (any || wanted == "vtkOSOpenGLRenderWindow"))
  {
    window = Try<vtkTerrainOSMesaRenderWindow>("OSMesa", tried);
  }
  if (!window)
  {
    if (tried.empty())
    {
      tried = "it is none of vtkXOpenGLRenderWindow, vtkEGLRenderWindow, vtkOSOpenGLRenderWindow";
    }
    window = vtkSmartPointer<vtkTerrainOffscreenRenderWindow>::New();
    window->SetWhyNot(
      any ? tried : std::string(kWindowVariable) + " is \"" + wanted + "\"; " + tried);
  }
  window->Register(nullptr);
  return window;
}

//------------------------------------------------------------------------------
// VTK's own interactor talks to the X server, and ends the program where there is none.
vtkObject* CreateInteractor()
{
  std::string tried;
  return ChoosesX(WantedWindow(), tried) ? nullptr : vtkGenericRenderWindowInteractor::New();
}

//------------------------------------------------------------------------------
vtkObjectFactory* FindRegistered()
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  factories->InitTraversal(iterator);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(iterator))
  {
    if (vtkTerrainRenderWindowFactory::SafeDownCast(factory))
    {
      return factory;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
vtkTerrainRenderWindowFactory::vtkTerrainRenderWindowFactory()
{
  this->RegisterOverride("vtkRenderWindow", "vtkTerrainOffscreenRenderWindow",
    "X, EGL or OSMesa, whichever works", 1, CreateWindow);
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
    "for windows without a display", 1, CreateInteractor);
}

//------------------------------------------------------------------------------
void vtkTerrainRenderWindowFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkTerrainRenderWindowFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkTerrainRenderWindowFactory::GetDescription()
{
  return "vtkTerrain: render windows without a display";
}

//------------------------------------------------------------------------------
void vtkTerrainRenderWindowFactory::Register()
{
  if (FindRegistered())
  {
    return;
  }
  const auto factory = vtkSmartPointer<vtkTerrainRenderWindowFactory>::New();
  vtkObjectFactory::RegisterFactory(factory);
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  const int last = factories->GetNumberOfItems() - 1;
  if (last > 0)
  {
    factories->InsertItem(-1, factory);
    factories->RemoveItem(last + 1);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRenderWindowFactory::Unregister()
{
  if (vtkObjectFactory* factory = FindRegistered())
  {
    vtkObjectFactory::UnRegisterFactory(factory);
  }
}

namespace
{
// Lives as long as the library is loaded. The registry itself lives longer (vtkObjectFactory.h).
struct Registration
{
  Registration()
  {
    vtkTerrainRenderWindowFactory::Register();
  }
  ~Registration()
  {
    vtkTerrainRenderWindowFactory::Unregister();
  }
  Registration(const Registration&) = delete;
  void operator=(const Registration&) = delete;
} TheRegistration;
}

// Named by the link options of vtkTerrain::Terrain: keeps this file, and the library, linked.
extern "C"
{
  extern VTKTERRAIN_EXPORT const int vtkTerrainRenderWindowFactoryLinked;
  const int vtkTerrainRenderWindowFactoryLinked = 1;
}
