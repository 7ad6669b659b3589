// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/MappedFile.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terrain
{
namespace
{
/// A mapping as the signal handler sees it: Begin is set last and cleared first.
struct GuardedRange
{
  std::atomic<std::uintptr_t> Begin{ 0 };
  std::atomic<std::uintptr_t> End{ 0 };
  std::atomic<bool> Damaged{ false };
};
constexpr int kMaximumFiles = 256;
std::array<GuardedRange, kMaximumFiles> Ranges;
std::mutex RangesMutex;
std::atomic<std::uintptr_t> PageSize{ 4096 };
struct sigaction PreviousAction;

/// Only what is safe in a signal handler: atomics and system calls.
void OnBusError(int signal, siginfo_t* info, void* context)
{
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  for (GuardedRange& range : Ranges)
  {
    const std::uintptr_t begin = range.Begin.load();
    if (begin != 0 && address >= begin && address < range.End.load())
    {
      const int error = errno;
      void* page = static_cast<char*>(info->si_addr) - address % PageSize.load();
      void* zeros =
        mmap(page, PageSize.load(), PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
      errno = error;
      if (zeros == page)
      {
        range.Damaged.store(true);
        return;
      }
    }
  }
  if ((PreviousAction.sa_flags & SA_SIGINFO) != 0 && PreviousAction.sa_sigaction)
  {
    PreviousAction.sa_sigaction(signal, info, context);
    return;
  }
  if (PreviousAction.sa_handler != SIG_DFL && PreviousAction.sa_handler != SIG_IGN)
  {
    PreviousAction.sa_handler(signal);
    return;
  }
  // The access is repeated on return, and ends the process as it would have without us.
  std::signal(SIGBUS, SIG_DFL);
}

/// Remembers a mapping and, with the first one, installs the handler.
int Guard(std::uintptr_t begin, std::uintptr_t end)
{
  const std::lock_guard<std::mutex> lock(RangesMutex);
  static bool installed = false;
  if (!installed)
  {
    PageSize.store(static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)));
    struct sigaction action = {};
    action.sa_sigaction = OnBusError;
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    installed = sigaction(SIGBUS, &action, &PreviousAction) == 0;
  }
  for (int slot = 0; installed && slot < kMaximumFiles; ++slot)
  {
    if (Ranges[slot].Begin.load() == 0)
    {
      Ranges[slot].Damaged.store(false);
      Ranges[slot].End.store(end);
      Ranges[slot].Begin.store(begin);
      return slot;
    }
  }
  return -1;
}

/// The whole pages inside [begin, end) of a mapping.
void Advise(unsigned char* data, std::size_t begin, std::size_t end, int advice)
{
  const std::uintptr_t page = PageSize.load();
  const std::size_t first = (begin + page - 1) & ~(page - 1);
  const std::size_t last = end & ~(page - 1);
  if (data && first < last)
  {
    madvise(data + first, last - first, advice);
  }
}
}

MappedFile::~MappedFile()
{
  this->Close();
}

std::string MappedFile::Open(const std::string& path)
{
  this->Close();
  // Opening a pipe would wait for its writer.
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
  {
    return std::strerror(errno);
  }
  struct stat status = {};
  std::string error;
  if (fstat(file, &status) != 0)
  {
    error = std::strerror(errno);
  }
  else if (!S_ISREG(status.st_mode))
  {
    error = "not a regular file";
  }
  else if (status.st_size == 0)
  {
    error = "the file is empty";
  }
  else
  {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* begin = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
    if (begin == MAP_FAILED)
    {
      error = std::strerror(errno);
    }
    else
    {
      this->Begin = static_cast<unsigned char*>(begin);
      this->Length = size;
      const auto address = reinterpret_cast<std::uintptr_t>(begin);
      this->Slot = Guard(address, address + size);
      error = this->Slot < 0 ? "too many files are mapped" : "";
    }
  }
  close(file);
  if (!error.empty())
  {
    this->Close();
  }
  return error;
}

void MappedFile::Close()
{
  if (this->Slot >= 0)
  {
    const std::lock_guard<std::mutex> lock(RangesMutex);
    Ranges[this->Slot].Begin.store(0);
  }
  if (this->Begin)
  {
    munmap(this->Begin, this->Length);
  }
  this->Begin = nullptr;
  this->Length = 0;
  this->Slot = -1;
}

bool MappedFile::IsDamaged() const
{
  return this->Slot >= 0 && Ranges[this->Slot].Damaged.load();
}

void MappedFile::AdviseRandom(std::size_t begin, std::size_t end) const
{
  Advise(this->Begin, begin, end, MADV_RANDOM);
}

void MappedFile::AdviseNeeded(std::size_t begin, std::size_t end) const
{
  Advise(this->Begin, begin, end, MADV_WILLNEED);
}

void MappedFile::Release(std::size_t begin, std::size_t end) const
{
  Advise(this->Begin, begin, end, MADV_DONTNEED);
}
}
