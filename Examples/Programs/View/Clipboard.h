// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A text for other programs to paste.
 */
#ifndef terrain_view_Clipboard_h
#define terrain_view_Clipboard_h

#include <memory>
#include <string>

/// The clipboard of the X server of DISPLAY, by a connection of its own. A text is offered as long
/// as this object lives and Serve() is called.
class Clipboard
{
public:
  Clipboard();
  ~Clipboard();
  Clipboard(const Clipboard&) = delete;
  Clipboard& operator=(const Clipboard&) = delete;

  /// Offers a text of UTF-8. False where there is no such server, or the program was built without
  /// X11.
  bool Offer(const std::string& text);
  /// Answers programs that ask for it; returns at once.
  void Serve();

private:
  class Connection;
  std::unique_ptr<Connection> Server;
};

#endif
