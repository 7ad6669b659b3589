// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An X server without a screen (Xvfb), a program that shows a window on it, and hands on its mouse
 * and keyboard.
 */
#ifndef VirtualDisplay_h
#define VirtualDisplay_h

#include <string>
#include <vector>

#include <sys/types.h>

struct _XDisplay;

/// Pixels of a window: 3 bytes each, red, green, blue, row 0 on top.
struct Screenshot
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels;

  bool operator==(const Screenshot& other) const
  {
    return this->Width == other.Width && this->Pixels == other.Pixels;
  }
  /// Number of pixels that differ; all of them if the sizes do.
  int CountDifferent(const Screenshot& other) const;
  /// Number of different colours.
  int CountColors() const;
  /// Writes a PNG.
  void Write(const std::string& path) const;
};

/// Starts a server, and ends it and the program with itself.
class VirtualDisplay
{
public:
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  void operator=(const VirtualDisplay&) = delete;

  /// False if there is no Xvfb here.
  bool IsThere() const
  {
    return this->Display != nullptr;
  }

  /// As DISPLAY has it.
  const std::string& GetName() const
  {
    return this->Name;
  }

  /// Starts a program in a folder, with its stdout to a file; waits for a window whose title has
  /// `title` in it to show a picture. False if it does not.
  bool Start(const std::vector<std::string>& command, const std::string& folder,
    const std::string& output, const std::string& title);
  /// Waits for another window of the program, by its title. False if there is none.
  bool Find(const std::string& title);
  /// The program that was started; -1 for none.
  pid_t GetProgram() const
  {
    return this->Program;
  }
  /// Exit status of the program, once it ends; -1 if a signal ended it or it does not end.
  int WaitForExit();

  ///@{
  /// Synthetic events, at pixels of the window, y from the top.
  void Move(int x, int y);
  void Press(unsigned int button, int x, int y);
  void Release(unsigned int button, int x, int y);
  void Type(char character, int x, int y);
  ///@}

  /// Gives the window another size, in pixels, as a window manager does.
  void Resize(int width, int height);

  /// What the clipboard holds, as UTF-8; empty if nobody answers.
  std::string ReadClipboard();
  /// Drops a file into the middle of the window, as file managers do (XDND, version 5); false if
  /// the window does not ask for its name.
  bool Drop(const std::string& path);

  /// The window as it is.
  Screenshot Capture();
  /// The window once it has stopped changing, and its program computes nothing more.
  Screenshot CaptureStill();
  /// Waits until the program computes nothing more; false if it goes on, or is gone.
  bool WaitForRest();
  /// Waits for a picture other than one before; false if there comes none.
  bool WaitForChange(const Screenshot& before);
  /// The window once it differs from a picture, and has stopped changing; that picture if it never
  /// does.
  Screenshot CaptureChange(const Screenshot& before);

private:
  unsigned long FindWindow(unsigned long root, const std::string& title);
  void Send(void* event, long mask);
  void SendMessage(const char* type, const std::vector<long>& words);
  void SendButton(int type, long mask, unsigned int button, int x, int y);

  _XDisplay* Display = nullptr;
  std::string Name;
  unsigned long Window = 0;
  pid_t Server = -1;
  pid_t Program = -1;
  unsigned int Buttons = 0;
};

#endif
