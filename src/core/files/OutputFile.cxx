// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/files/OutputFile.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terrain
{
namespace
{
/// Longest part of an output's name that its partial file carries: file systems end at 255 bytes.
constexpr std::size_t kLongestStem = 200;

/// A partial file as a signal handler sees it: Path is read only while Listed is true.
struct ListedFile
{
  std::atomic<bool> Taken{ false };
  std::atomic<bool> Listed{ false };
  char Path[PATH_MAX];
};
constexpr int kMaximumListed = 64;
std::array<ListedFile, kMaximumListed> ListedFiles;

/// Remembers a partial file for RemovePartialFiles(); -1 if there are too many, or if its name is
/// too long: such a file is removed by its destructor alone.
int List(const std::string& path)
{
  for (int slot = 0; slot < kMaximumListed && path.size() < PATH_MAX; ++slot)
  {
    ListedFile& file = ListedFiles[slot];
    if (!file.Taken.exchange(true))
    {
      std::memcpy(file.Path, path.c_str(), path.size() + 1);
      file.Listed.store(true);
      return slot;
    }
  }
  return -1;
}

void Unlist(int slot)
{
  if (slot >= 0)
  {
    ListedFiles[slot].Listed.store(false);
    ListedFiles[slot].Taken.store(false);
  }
}

/// The absolute path of what exists, links followed; empty, with errno, if nothing does.
std::string CanonicalPath(const std::string& path)
{
  const std::unique_ptr<char, void (*)(void*)> name(realpath(path.c_str(), nullptr), std::free);
  return name ? std::string(name.get()) : std::string();
}

/// Folder and name of a path: "." and "a" of "a", "/" and "a" of "/a".
void SplitPath(const std::string& path, std::string& folder, std::string& name)
{
  const std::size_t slash = path.rfind('/');
  folder = slash == std::string::npos ? "." : path.substr(0, slash == 0 ? 1 : slash);
  name = slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string RandomDigits()
{
  std::random_device random;
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%08x%08x", random(), random());
  return digits;
}

/// So that a new name in a folder survives a power failure; a file system that cannot is no error.
void FlushFolder(const std::string& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (descriptor >= 0)
  {
    fsync(descriptor);
    close(descriptor);
  }
}
}

//------------------------------------------------------------------------------
std::string WhyNotInput(const std::string& path)
{
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))
  {
    return {};
  }
  return "it is no regular file";
}

//------------------------------------------------------------------------------
bool IsSameFile(const std::string& first, const std::string& second)
{
  struct stat a = {};
  struct stat b = {};
  return stat(first.c_str(), &a) == 0 && stat(second.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
    a.st_ino == b.st_ino;
}

//------------------------------------------------------------------------------
void RemovePartialFiles() noexcept
{
  for (ListedFile& file : ListedFiles)
  {
    if (file.Listed.load())
    {
      unlink(file.Path);
    }
  }
}

//------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  this->Discard();
}

//------------------------------------------------------------------------------
// Sets Target and Permissions.
std::string OutputFile::Resolve(const std::string& path)
{
  this->Permissions = -1;
  struct stat status = {};
  if (stat(path.c_str(), &status) == 0)
  {
    if (!S_ISREG(status.st_mode))
    {
      return S_ISDIR(status.st_mode) ? "is a directory" : "is no regular file";
    }
    if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
    {
      return std::strerror(errno);
    }
    this->Permissions = static_cast<int>(status.st_mode & 07777);
    this->Target = CanonicalPath(path);
    return this->Target.empty() ? std::strerror(errno) : "";
  }
  const int error = errno;
  if (lstat(path.c_str(), &status) == 0)
  {
    return error == ENOENT ? "is a symbolic link to nothing" : std::strerror(error);
  }
  std::string folder;
  std::string name;
  SplitPath(path, folder, name);
  folder = CanonicalPath(folder);
  if (folder.empty() || error != ENOENT)
  {
    return std::strerror(folder.empty() ? errno : error);
  }
  if (name.empty())
  {
    return std::strerror(path.empty() ? ENOENT : EISDIR);
  }
  this->Target = (folder == "/" ? folder : folder + "/") + name;
  return {};
}

//------------------------------------------------------------------------------
std::string OutputFile::Open(const std::string& path)
{
  this->Discard();
  this->Target.clear();
  std::string error = this->Resolve(path);
  if (!error.empty())
  {
    this->Target.clear();
    return error;
  }
  std::string folder;
  std::string name;
  SplitPath(this->Target, folder, name);
  this->PartialPath =
    this->Target.substr(0, this->Target.size() - name.size()) + name.substr(0, kLongestStem);
  this->PartialPath += "." + RandomDigits() + ".partial";
  // Listed first: a signal finds it from its first moment on.
  this->Slot = List(this->PartialPath);
  this->Descriptor =
    open(this->PartialPath.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (this->Descriptor < 0)
  {
    error = std::strerror(errno);
    Unlist(this->Slot);
    this->Slot = -1;
    return error;
  }
  if (this->Permissions >= 0)
  {
    // A file system without permissions is no error.
    static_cast<void>(fchmod(this->Descriptor, static_cast<mode_t>(this->Permissions)) == 0);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string OutputFile::Write(const void* bytes, std::size_t size)
{
  const char* next = static_cast<const char*>(bytes);
  while (size > 0)
  {
    const ssize_t written = write(this->Descriptor, next, size);
    if (written < 0 && errno != EINTR)
    {
      return std::strerror(errno);
    }
    if (written > 0)
    {
      next += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string OutputFile::Commit()
{
  // Some file systems say that they cannot flush; the content is with them all the same.
  const bool flushed =
    fsync(this->Descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
  if (!flushed || std::rename(this->PartialPath.c_str(), this->Target.c_str()) != 0)
  {
    std::string error = std::strerror(errno);
    this->Discard();
    return error;
  }
  Unlist(this->Slot);
  this->Slot = -1;
  close(this->Descriptor);
  this->Descriptor = -1;
  std::string folder;
  std::string name;
  SplitPath(this->Target, folder, name);
  FlushFolder(folder);
  return {};
}

//------------------------------------------------------------------------------
void OutputFile::Discard()
{
  if (this->Descriptor >= 0)
  {
    unlink(this->PartialPath.c_str());
    close(this->Descriptor);
    this->Descriptor = -1;
  }
  Unlist(this->Slot);
  this->Slot = -1;
}
}
