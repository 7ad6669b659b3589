// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A dialog for files, of the desktop: zenity's or kdialog's, in a process of its own.
 */
#ifndef terrain_view_FileDialog_h
#define terrain_view_FileDialog_h

#include <optional>
#include <string>

#include <sys/types.h>

class FileDialog
{
public:
  FileDialog() = default;
  /// Closes it.
  ~FileDialog();
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;

  /// Shows the dialog, and does not wait for it. False if there is no program for one.
  bool Open();
  bool IsOpen() const
  {
    return this->Process > 0;
  }
  /// The file that was chosen, empty if none was; nothing while the dialog is open, or was not.
  std::optional<std::string> Poll();

private:
  pid_t Process = -1;
  /// Its stdout.
  int Output = -1;
  std::string Text;
};

#endif
