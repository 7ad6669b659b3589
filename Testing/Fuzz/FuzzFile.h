// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files in memory, and damage to their content.
 */
#ifndef FuzzFile_h
#define FuzzFile_h

#include "FuzzInput.h"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

/// A file that has a name as long as the object lives, and no place on a disk.
class FuzzFile
{
public:
  explicit FuzzFile(const std::string& content)
    : Descriptor(memfd_create("fuzz", MFD_CLOEXEC))
  {
    const auto size = static_cast<ssize_t>(content.size());
    Require(
      this->Descriptor >= 0 && write(this->Descriptor, content.data(), content.size()) == size);
  }
  ~FuzzFile()
  {
    close(this->Descriptor);
  }
  FuzzFile(const FuzzFile&) = delete;
  FuzzFile& operator=(const FuzzFile&) = delete;

  std::string Path() const
  {
    return "/proc/self/fd/" + std::to_string(this->Descriptor);
  }

private:
  int Descriptor;
};

/// The content of a file that `write` makes under the name that it is given.
template <typename Write>
std::string ContentWrittenBy(const Write& write)
{
  char folder[] = "/tmp/vtkTerrainFuzzXXXXXX";
  Require(mkdtemp(folder) != nullptr);
  const std::string path = std::string(folder) + "/file";
  Require(write(path).empty());
  std::ifstream file(path, std::ios::binary);
  std::string content{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  unlink(path.c_str());
  rmdir(folder);
  return content;
}

/// Overwrites pieces of a content, each of at most 16 bytes from a place on that the input says;
/// with a last, empty one the content is cut or made longer.
inline void Damage(std::string& content, FuzzInput& input)
{
  while (input.Left() > 3)
  {
    const std::size_t begin = input.Number(static_cast<std::uint32_t>(content.size()));
    std::size_t count = input.Take<std::uint8_t>() % 17u;
    if (count == 0)
    {
      content.resize(begin + input.Number(2) * content.size());
      return;
    }
    for (; count > 0 && input.Left() > 0; --count)
    {
      content[(begin + count) % content.size()] = input.Take<char>();
    }
  }
}

/// Puts a value into a content, where it has the bytes for it.
template <typename T>
void PutValue(std::string& content, std::size_t begin, const T& value)
{
  if (begin + sizeof(T) <= content.size())
  {
    std::memcpy(&content[begin], &value, sizeof(T));
  }
}

#endif
