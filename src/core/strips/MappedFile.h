// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A file in memory, read-only, that can shrink or fail to be read without ending the process.
 *
 * Reading a mapped page that the file no longer has raises SIGBUS. While a file is mapped here, a
 * handler answers it: it puts a page of zeros in the place and remembers that the mapping is
 * damaged; the reader goes on and asks IsDamaged() before it trusts what it has read. Other SIGBUS
 * go to the handler that was there before. Nothing is unwound, so any code may read the memory, on
 * any thread. POSIX only.
 */
#ifndef terrain_MappedFile_h
#define terrain_MappedFile_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace terrain
{
/// A mapped file; not copied.
class MappedFile
{
public:
  MappedFile() = default;
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Maps a whole file; returns an error message, empty if all is well.
  std::string Open(const std::string& path);
  void Close();

  /// First byte, null if nothing is mapped.
  const unsigned char* Data() const
  {
    return this->Begin;
  }
  std::size_t Size() const
  {
    return this->Length;
  }
  /// True if some page could not be read since it was mapped: its bytes were 0.
  bool IsDamaged() const;

  /// Tells the system that a range is read here and there: no pages are read ahead.
  void AdviseRandom(std::size_t begin, std::size_t end) const;
  /// Tells the system that a range is needed soon.
  void AdviseNeeded(std::size_t begin, std::size_t end) const;
  /// Gives the pages of a range back; they are read again when they are needed.
  void Release(std::size_t begin, std::size_t end) const;

private:
  unsigned char* Begin = nullptr;
  std::size_t Length = 0;
  int Slot = -1;
};
}

#endif
