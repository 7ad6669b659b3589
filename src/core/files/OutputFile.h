// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that appear complete or not at all, and never in place of what must stay.
 *
 * The content goes to a partial file beside the output, under a name of its own that no other
 * process uses (made with O_EXCL, so that nothing is followed or opened twice). Commit() flushes
 * it to the disk and renames it. A symbolic link is followed: its target is replaced, the link
 * stays. A file that is replaced hands its permissions on.
 *
 * The destructor removes what was not committed. A process that ends by a signal calls
 * RemovePartialFiles() in its handler; SIGKILL alone leaves a partial file behind.
 */
#ifndef terrain_OutputFile_h
#define terrain_OutputFile_h

#include <cstddef>
#include <string>

namespace terrain
{
/// One sentence why `path` cannot be read as a file, or empty: it is neither a regular file nor a
/// directory (a pipe would wait for a writer for ever). What does not exist is left to its reader.
std::string WhyNotInput(const std::string& path);

/// True if both names lead to one existing file, through links of either kind.
bool IsSameFile(const std::string& first, const std::string& second);

/// Removes the partial files of this process. For signal handlers: calls nothing but unlink().
void RemovePartialFiles() noexcept;

/// An output under construction. All messages are one sentence, empty if all is well.
class OutputFile
{
public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Makes the partial file, open for reading and writing. Refuses what is no regular file, what
  /// is protected against writing, and links to nothing. A partial file before it is discarded.
  std::string Open(const std::string& path);

  /// Appends bytes.
  std::string Write(const void* bytes, std::size_t size);

  /// Flushes the file to the disk and gives it its name.
  std::string Commit();

  /// Closes and removes the partial file; nothing if there is none.
  void Discard();

  bool IsOpen() const
  {
    return this->Descriptor >= 0;
  }
  /// True if there was a file of this name when the partial file was made.
  bool ReplacesFile() const
  {
    return this->Permissions >= 0;
  }
  int GetDescriptor() const
  {
    return this->Descriptor;
  }
  /// Absolute path that Commit() gives the file, links followed; empty before Open().
  const std::string& GetTarget() const
  {
    return this->Target;
  }
  const std::string& GetPartialPath() const
  {
    return this->PartialPath;
  }

private:
  std::string Resolve(const std::string& path);

  std::string Target;
  std::string PartialPath;
  /// Permissions of the file that is replaced; -1: there is none.
  int Permissions = -1;
  int Descriptor = -1;
  int Slot = -1;
};
}

#endif
