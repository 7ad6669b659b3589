// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualDisplay.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <system_error>
#include <thread>

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
constexpr std::chrono::seconds kLongestWait{ 60 };
constexpr std::chrono::milliseconds kBetweenLooks{ 50 };
/// Looks that must agree for a window to be still: longer than the program's own timer.
constexpr int kStillLooks = 8;
/// Looks that must find a program at rest: as long as between two of its own looks.
constexpr int kRestingLooks = 3;

bool WaitUntil(const std::function<bool()>& condition)
{
  const auto begin = std::chrono::steady_clock::now();
  while (!condition())
  {
    if (std::chrono::steady_clock::now() - begin > kLongestWait)
    {
      return false;
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return true;
}

/// Whether all threads of a process wait for something: none computes, or would if it had a core.
bool IsAtRest(pid_t process)
{
  std::error_code gone;
  const std::filesystem::path threads = "/proc/" + std::to_string(process) + "/task";
  for (const auto& thread : std::filesystem::directory_iterator(threads, gone))
  {
    std::ifstream stream(thread.path() / "stat");
    std::string words;
    std::getline(stream, words); // the state follows the name, which is in parentheses
    const std::size_t nameEnd = words.rfind(')');
    if (nameEnd != std::string::npos && words.compare(nameEnd, 3, ") S") != 0)
    {
      return false;
    }
  }
  return true;
}

/// In the child: becomes a command found in PATH, or ends with 127.
[[noreturn]] void Become(std::vector<std::string> command)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL); // ends with the test, however that ends
  std::vector<char*> pointers;
  pointers.reserve(command.size() + 1);
  for (std::string& word : command)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

/// What a pipe says up to the end of the line; empty if that takes too long.
std::string ReadLine(int pipe)
{
  std::string line;
  char character = 0;
  struct pollfd waiting = { pipe, POLLIN, 0 };
  const int longest = static_cast<int>(std::chrono::milliseconds(kLongestWait).count());
  while (poll(&waiting, 1, longest) > 0 && read(pipe, &character, 1) == 1 && character != '\n')
  {
    line += character;
  }
  return line;
}

void End(pid_t child)
{
  if (child > 0)
  {
    kill(child, SIGTERM);
    waitpid(child, nullptr, 0);
  }
}
}

//------------------------------------------------------------------------------
int Screenshot::CountDifferent(const Screenshot& other) const
{
  const int count = this->Width * this->Height;
  if (this->Pixels.size() != other.Pixels.size())
  {
    return count;
  }
  int different = 0;
  for (int pixel = 0; pixel < count; ++pixel)
  {
    const auto* mine = &this->Pixels[3 * static_cast<std::size_t>(pixel)];
    different +=
      std::equal(mine, mine + 3, &other.Pixels[3 * static_cast<std::size_t>(pixel)]) ? 0 : 1;
  }
  return different;
}

//------------------------------------------------------------------------------
int Screenshot::CountColors() const
{
  std::set<int> colors;
  for (std::size_t k = 0; k + 2 < this->Pixels.size(); k += 3)
  {
    colors.insert(this->Pixels[k] << 16 | this->Pixels[k + 1] << 8 | this->Pixels[k + 2]);
  }
  return static_cast<int>(colors.size());
}

//------------------------------------------------------------------------------
void Screenshot::Write(const std::string& path) const
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int row = 0; row < this->Height; ++row)
  {
    const auto begin = this->Pixels.begin() + std::ptrdiff_t{ 3 } * this->Width * row;
    std::copy(begin, begin + std::ptrdiff_t{ 3 } * this->Width,
      static_cast<unsigned char*>(image->GetScalarPointer(0, this->Height - 1 - row, 0)));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
VirtualDisplay::VirtualDisplay()
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return;
  }
  this->Server = fork();
  if (this->Server == 0)
  {
    close(ends[0]);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    Become({ "Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "800x600x24",
      "-nolisten", "tcp" });
  }
  close(ends[1]);
  const std::string number = ReadLine(ends[0]);
  close(ends[0]);
  if (!number.empty())
  {
    this->Name = ":" + number;
    this->Display = XOpenDisplay(this->Name.c_str());
    // a window may go between one call and the next; those then answer that it is gone
    XSetErrorHandler([](::Display*, XErrorEvent*) { return 0; });
  }
}

//------------------------------------------------------------------------------
VirtualDisplay::~VirtualDisplay()
{
  End(this->Program);
  if (this->Display)
  {
    XCloseDisplay(this->Display);
  }
  End(this->Server);
}

//------------------------------------------------------------------------------
bool VirtualDisplay::Start(const std::vector<std::string>& command, const std::string& folder,
  const std::string& output, const std::string& title)
{
  this->Program = fork();
  if (this->Program == 0)
  {
    setenv("DISPLAY", this->Name.c_str(), 1);
    unsetenv("VTK_DEFAULT_OPENGL_WINDOW");
    dup2(open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    if (chdir(folder.c_str()) == 0)
    {
      Become(command);
    }
    _exit(127);
  }
  return this->Find(title);
}

//------------------------------------------------------------------------------
bool VirtualDisplay::Find(const std::string& title)
{
  const auto shows = [&]
  {
    this->Window = this->FindWindow(DefaultRootWindow(this->Display), title);
    return this->Window != 0 && this->Capture().CountColors() > 2;
  };
  return WaitUntil(shows);
}

//------------------------------------------------------------------------------
int VirtualDisplay::WaitForExit()
{
  int status = 0;
  const bool ended =
    WaitUntil([&] { return waitpid(this->Program, &status, WNOHANG) == this->Program; });
  this->Program = ended ? -1 : this->Program;
  return ended && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

//------------------------------------------------------------------------------
unsigned long VirtualDisplay::FindWindow(unsigned long root, const std::string& title)
{
  char* name = nullptr;
  const bool named = XFetchName(this->Display, root, &name) != 0 && name;
  const bool found = named && std::string(name).find(title) != std::string::npos;
  XFree(name);
  XWindowAttributes attributes;
  if (found && XGetWindowAttributes(this->Display, root, &attributes) != 0 &&
    attributes.map_state == IsViewable)
  {
    return root;
  }
  ::Window ignored = 0;
  ::Window* children = nullptr;
  unsigned int count = 0;
  unsigned long window = 0;
  if (XQueryTree(this->Display, root, &ignored, &ignored, &children, &count) != 0)
  {
    for (unsigned int k = 0; k < count && window == 0; ++k)
    {
      window = this->FindWindow(children[k], title);
    }
    XFree(children);
  }
  return window;
}

//------------------------------------------------------------------------------
void VirtualDisplay::Send(void* event, long mask)
{
  XSendEvent(this->Display, this->Window, True, mask, static_cast<XEvent*>(event));
  XSync(this->Display, False);
}

//------------------------------------------------------------------------------
void VirtualDisplay::Move(int x, int y)
{
  // a move of the server's own pointer: VTK asks the server where it is
  XWarpPointer(this->Display, None, this->Window, 0, 0, 0, 0, x, y);
  XSync(this->Display, False);
}

//------------------------------------------------------------------------------
void VirtualDisplay::SendButton(int type, long mask, unsigned int button, int x, int y)
{
  this->Move(x, y);
  XEvent event{};
  event.xbutton.type = type;
  event.xbutton.display = this->Display;
  event.xbutton.window = this->Window;
  event.xbutton.root = DefaultRootWindow(this->Display);
  event.xbutton.x = x;
  event.xbutton.y = y;
  event.xbutton.button = button;
  event.xbutton.state = this->Buttons;
  event.xbutton.same_screen = True;
  this->Send(&event, mask);
}

//------------------------------------------------------------------------------
void VirtualDisplay::Press(unsigned int button, int x, int y)
{
  this->SendButton(ButtonPress, ButtonPressMask, button, x, y);
  this->Buttons |= static_cast<unsigned int>(Button1Mask) << (button - 1);
}

//------------------------------------------------------------------------------
void VirtualDisplay::Release(unsigned int button, int x, int y)
{
  this->SendButton(ButtonRelease, ButtonReleaseMask, button, x, y);
  this->Buttons &= ~(static_cast<unsigned int>(Button1Mask) << (button - 1));
}

//------------------------------------------------------------------------------
void VirtualDisplay::Type(char character, int x, int y)
{
  this->Move(x, y);
  // the symbols of ASCII are its codes, those of Backspace, Tab, Return and Escape lie above
  constexpr KeySym kControls = 0xff00;
  const KeySym symbol = static_cast<unsigned char>(character) + (character < ' ' ? kControls : 0);
  const KeyCode code = XKeysymToKeycode(this->Display, symbol);
  XEvent event{};
  event.xkey.display = this->Display;
  event.xkey.window = this->Window;
  event.xkey.root = DefaultRootWindow(this->Display);
  event.xkey.x = x;
  event.xkey.y = y;
  event.xkey.keycode = code;
  event.xkey.same_screen = True;
  const bool shifted = XkbKeycodeToKeysym(this->Display, code, 0, 0) != symbol;
  event.xkey.state = this->Buttons | (shifted ? static_cast<unsigned int>(ShiftMask) : 0u);
  event.xkey.type = KeyPress;
  this->Send(&event, KeyPressMask);
  event.xkey.type = KeyRelease;
  this->Send(&event, KeyReleaseMask);
}

//------------------------------------------------------------------------------
void VirtualDisplay::Resize(int width, int height)
{
  XResizeWindow(this->Display, this->Window, static_cast<unsigned int>(width),
    static_cast<unsigned int>(height));
  XSync(this->Display, False);
}

//------------------------------------------------------------------------------
bool VirtualDisplay::WaitForRest()
{
  int looks = 0;
  return WaitUntil(
           [&]
           {
             looks = IsAtRest(this->Program) ? looks + 1 : 0;
             return looks >= kRestingLooks;
           }) &&
    kill(this->Program, 0) == 0;
}

//------------------------------------------------------------------------------
Screenshot VirtualDisplay::Capture()
{
  Screenshot shot;
  XWindowAttributes attributes;
  if (XGetWindowAttributes(this->Display, this->Window, &attributes) == 0)
  {
    return shot;
  }
  XImage* image =
    XGetImage(this->Display, this->Window, 0, 0, static_cast<unsigned int>(attributes.width),
      static_cast<unsigned int>(attributes.height), AllPlanes, ZPixmap);
  if (!image)
  {
    return shot;
  }
  shot.Width = image->width;
  shot.Height = image->height;
  shot.Pixels.reserve(std::size_t{ 3 } * image->width * image->height);
  for (int y = 0; y < image->height; ++y)
  {
    for (int x = 0; x < image->width; ++x)
    {
      const unsigned long pixel = XGetPixel(image, x, y); // 24 bits: red, green, blue
      for (const int shift : { 16, 8, 0 })
      {
        shot.Pixels.push_back(static_cast<unsigned char>(pixel >> shift & 0xff));
      }
    }
  }
  XDestroyImage(image);
  return shot;
}

//------------------------------------------------------------------------------
Screenshot VirtualDisplay::CaptureStill()
{
  Screenshot last = this->Capture();
  int looks = 0;
  WaitUntil(
    [&]
    {
      Screenshot now = this->Capture();
      looks = now == last && IsAtRest(this->Program) ? looks + 1 : 0;
      last = std::move(now);
      return looks >= kStillLooks;
    });
  return last;
}

//------------------------------------------------------------------------------
bool VirtualDisplay::WaitForChange(const Screenshot& before)
{
  return WaitUntil([&] { return !(this->Capture() == before); });
}

//------------------------------------------------------------------------------
Screenshot VirtualDisplay::CaptureChange(const Screenshot& before)
{
  this->WaitForChange(before);
  return this->CaptureStill();
}

//------------------------------------------------------------------------------
std::string VirtualDisplay::ReadClipboard()
{
  const ::Window window =
    XCreateSimpleWindow(this->Display, DefaultRootWindow(this->Display), 0, 0, 1, 1, 0, 0, 0);
  const Atom text = XInternAtom(this->Display, "UTF8_STRING", False);
  const Atom property = XInternAtom(this->Display, "TERRAIN_TEST", False);
  XConvertSelection(this->Display, XInternAtom(this->Display, "CLIPBOARD", False), text, property,
    window, CurrentTime);
  XEvent event;
  if (!WaitUntil([&] { return XCheckTypedEvent(this->Display, SelectionNotify, &event) != 0; }) ||
    event.xselection.property == None)
  {
    return {};
  }
  Atom type = None;
  int format = 0;
  unsigned long count = 0;
  unsigned long left = 0;
  unsigned char* bytes = nullptr;
  XGetWindowProperty(this->Display, window, property, 0, 1024, True, AnyPropertyType, &type,
    &format, &count, &left, &bytes);
  std::string read(reinterpret_cast<char*>(bytes), count);
  XFree(bytes);
  XDestroyWindow(this->Display, window);
  return read;
}

//------------------------------------------------------------------------------
void VirtualDisplay::SendMessage(const char* type, const std::vector<long>& words)
{
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.display = this->Display;
  event.xclient.window = this->Window;
  event.xclient.message_type = XInternAtom(this->Display, type, False);
  event.xclient.format = 32;
  std::copy(words.begin(), words.end(), event.xclient.data.l);
  this->Send(&event, NoEventMask);
}

//------------------------------------------------------------------------------
bool VirtualDisplay::Drop(const std::string& path)
{
  const ::Window source =
    XCreateSimpleWindow(this->Display, DefaultRootWindow(this->Display), 0, 0, 1, 1, 0, 0, 0);
  XSetSelectionOwner(
    this->Display, XInternAtom(this->Display, "XdndSelection", False), source, CurrentTime);
  const auto owner = static_cast<long>(source);
  const auto list = static_cast<long>(XInternAtom(this->Display, "text/uri-list", False));
  const auto copy = static_cast<long>(XInternAtom(this->Display, "XdndActionCopy", False));
  constexpr long kVersion = 5L << 24;
  this->SendMessage("XdndEnter", { owner, kVersion, list, 0, 0 });
  this->SendMessage("XdndPosition", { owner, 0, 100L << 16 | 100L, CurrentTime, copy });
  this->SendMessage("XdndDrop", { owner, 0, CurrentTime, 0, 0 });
  XEvent asked;
  if (!WaitUntil([&] { return XCheckTypedEvent(this->Display, SelectionRequest, &asked) != 0; }))
  {
    return false;
  }
  const XSelectionRequestEvent& request = asked.xselectionrequest;
  const std::string uri = "file://" + path + "\r\n";
  XChangeProperty(this->Display, request.requestor, request.property, request.target, 8,
    PropModeReplace, reinterpret_cast<const unsigned char*>(uri.data()),
    static_cast<int>(uri.size()));
  XEvent answer{};
  answer.xselection.type = SelectionNotify;
  answer.xselection.requestor = request.requestor;
  answer.xselection.selection = request.selection;
  answer.xselection.target = request.target;
  answer.xselection.property = request.property;
  answer.xselection.time = request.time;
  XSendEvent(this->Display, request.requestor, False, NoEventMask, &answer);
  XSync(this->Display, False);
  return true;
}
