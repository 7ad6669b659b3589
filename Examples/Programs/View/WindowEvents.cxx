// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowEvents.h"

#ifdef TERRAIN_VIEW_HAS_X11

#include "vtkRenderWindow.h"

#include <X11/Xlib.h>

#include <cstdint>

//------------------------------------------------------------------------------
void ForgetEvents(vtkRenderWindow* window)
{
  auto* server = static_cast<Display*>(window->GetGenericDisplayId());
  const auto id =
    static_cast<Window>(reinterpret_cast<std::uintptr_t>(window->GetGenericWindowId()));
  if (server && id != None)
  {
    XSelectInput(server, id, NoEventMask);
    XSync(server, True);
  }
}

#else

//------------------------------------------------------------------------------
void ForgetEvents(vtkRenderWindow*)
{
}

#endif
