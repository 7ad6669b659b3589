// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A path that is typed into the window.
 */
#ifndef terrain_view_TypedPath_h
#define terrain_view_TypedPath_h

#include <string>

class TypedPath
{
public:
  enum class State
  {
    Off,
    Typing,
    /// Return was typed: GetPath() is what is meant.
    Done
  };

  /// Begins with an empty path.
  void Begin();
  /// Takes a key: Backspace takes a letter away, Tab completes what files and folders there are,
  /// Return ends, Escape gives up.
  State Take(char key);
  bool IsOn() const
  {
    return this->Now == State::Typing;
  }

  /// A first "~/" stands for the user's folder.
  std::string GetPath() const;
  /// What is shown while it is typed.
  std::string GetPrompt() const;

private:
  void Complete();

  State Now = State::Off;
  std::string Text;
};

#endif
