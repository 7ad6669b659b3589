// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Clipboard.h"

#ifdef TERRAIN_VIEW_HAS_X11

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>

/// Owner of the selection CLIPBOARD, as the ICCCM has it, section 2: a window that nobody sees.
class Clipboard::Connection
{
public:
  Connection()
    : Server(XOpenDisplay(nullptr))
  {
    if (this->Server)
    {
      this->Owner =
        XCreateSimpleWindow(this->Server, DefaultRootWindow(this->Server), 0, 0, 1, 1, 0, 0, 0);
    }
  }
  ~Connection()
  {
    if (this->Server)
    {
      XCloseDisplay(this->Server);
    }
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool Offer(const std::string& text)
  {
    if (!this->Server)
    {
      return false;
    }
    this->Text = text;
    const Atom clipboard = this->Name("CLIPBOARD");
    XSetSelectionOwner(this->Server, clipboard, this->Owner, CurrentTime);
    return XGetSelectionOwner(this->Server, clipboard) == this->Owner;
  }

  void Serve()
  {
    // a program that asked may have gone: that is no reason to end
    const auto before = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    this->AnswerAll();
    if (this->Server)
    {
      XSync(this->Server, False);
    }
    XSetErrorHandler(before);
  }

private:
  void AnswerAll()
  {
    while (this->Server && XPending(this->Server) > 0)
    {
      XEvent event;
      XNextEvent(this->Server, &event);
      if (event.type == SelectionRequest)
      {
        this->Answer(event.xselectionrequest);
      }
    }
  }

  Atom Name(const char* name)
  {
    return XInternAtom(this->Server, name, False);
  }

  void Answer(const XSelectionRequestEvent& request)
  {
    const Atom utf8 = this->Name("UTF8_STRING");
    const Atom targets = this->Name("TARGETS");
    // programs of old name no property: the target stands for it
    const Atom property = request.property != None ? request.property : request.target;
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.time = request.time;
    event.xselection.property = property;
    if (request.target == targets)
    {
      const std::array<Atom, 3> known{ targets, utf8, XA_STRING };
      XChangeProperty(this->Server, request.requestor, property, XA_ATOM, 32, PropModeReplace,
        reinterpret_cast<const unsigned char*>(known.data()), static_cast<int>(known.size()));
    }
    else if (request.target == utf8 || request.target == XA_STRING)
    {
      XChangeProperty(this->Server, request.requestor, property, request.target, 8, PropModeReplace,
        reinterpret_cast<const unsigned char*>(this->Text.data()),
        static_cast<int>(this->Text.size()));
    }
    else
    {
      event.xselection.property = None;
    }
    XSendEvent(this->Server, request.requestor, False, NoEventMask, &event);
  }

  Display* Server;
  Window Owner = None;
  std::string Text;
};

#else

class Clipboard::Connection
{
public:
  bool Offer(const std::string&)
  {
    return false;
  }
  void Serve()
  {
  }
};

#endif

//------------------------------------------------------------------------------
Clipboard::Clipboard() = default;
Clipboard::~Clipboard() = default;

//------------------------------------------------------------------------------
bool Clipboard::Offer(const std::string& text)
{
  if (!this->Server)
  {
    this->Server = std::make_unique<Connection>();
  }
  return this->Server->Offer(text);
}

//------------------------------------------------------------------------------
void Clipboard::Serve()
{
  if (this->Server)
  {
    this->Server->Serve();
  }
}
