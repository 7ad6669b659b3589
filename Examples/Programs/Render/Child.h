// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A program of the PATH that this one starts, feeds and waits for.
 */
#ifndef terrain_render_Child_h
#define terrain_render_Child_h

#include <cstddef>
#include <future>
#include <string>
#include <vector>

#include <sys/types.h>

/// Ends the program if it still runs when this object goes.
class Child
{
public:
  /// How a program ended.
  struct Ending
  {
    /// Exit status; 127 if it was not run, 128 and the signal if one ended it.
    int Status = 127;
    /// What it wrote on stderr.
    std::string Said;
  };

  /// Starts it; its stdin is what it is fed with, its stdout goes nowhere.
  explicit Child(std::vector<std::string> words);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Hands bytes on, and waits until they are taken. False once the program takes no more.
  bool Feed(const void* bytes, std::size_t size);
  /// Ends its input, and waits until it has ended.
  Ending Wait();

private:
  void CloseInput();
  /// Waits for the process; its status as waitpid() has it.
  int Reap();

  pid_t Process = -1;
  int Input = -1;
  std::future<std::string> Said;
};

/// The last line of a text that is not empty.
std::string LastLine(const std::string& text);

#endif
