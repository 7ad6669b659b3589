// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Child.h"

#include "Spawn.h"

#include <array>
#include <cerrno>
#include <sstream>
#include <utility>

#include <csignal>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
constexpr int kNotRun = 127;
constexpr int kSignalled = 128;
/// Bytes that wait between the programs.
constexpr int kWaitingBytes = 1 << 20;

/// Reads until all writers have closed, and closes.
std::string ReadAll(int descriptor)
{
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t count = 1; count != 0;)
  {
    count = read(descriptor, part.data(), part.size());
    text.append(part.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    if (count < 0 && errno != EINTR)
    {
      break;
    }
  }
  close(descriptor);
  return text;
}
}

//------------------------------------------------------------------------------
Child::Child(std::vector<std::string> words)
{
  std::array<int, 2> input{ -1, -1 };
  std::array<int, 2> errors{ -1, -1 };
  // A socket: unlike a pipe it can tell that nobody reads any more by an error alone, no signal.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input.data()) != 0)
  {
    return;
  }
  this->Input = input[1];
  if (pipe2(errors.data(), O_CLOEXEC) == 0)
  {
    setsockopt(input[1], SOL_SOCKET, SO_SNDBUF, &kWaitingBytes, sizeof(kWaitingBytes));
    this->Process =
      Spawn(std::move(words), { { input[0], STDIN_FILENO }, { errors[1], STDERR_FILENO } });
    close(errors[1]);
    this->Said = std::async(std::launch::async, ReadAll, errors[0]);
  }
  close(input[0]);
}

//------------------------------------------------------------------------------
Child::~Child()
{
  if (this->Process > 0)
  {
    kill(this->Process, SIGKILL);
    this->Reap();
  }
  this->CloseInput();
}

//------------------------------------------------------------------------------
bool Child::Feed(const void* bytes, std::size_t size)
{
  const char* next = static_cast<const char*>(bytes);
  while (size > 0 && this->Process > 0)
  {
    const ssize_t written = send(this->Input, next, size, MSG_NOSIGNAL);
    if (written < 0 && errno != EINTR)
    {
      return false;
    }
    next += written > 0 ? written : 0;
    size -= written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return this->Process > 0;
}

//------------------------------------------------------------------------------
Child::Ending Child::Wait()
{
  this->CloseInput();
  Ending ending;
  if (this->Process > 0)
  {
    const int status = this->Reap();
    ending.Status = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
  }
  if (this->Said.valid())
  {
    ending.Said = this->Said.get();
  }
  return ending;
}

//------------------------------------------------------------------------------
void Child::CloseInput()
{
  if (this->Input >= 0)
  {
    close(this->Input);
    this->Input = -1;
  }
}

//------------------------------------------------------------------------------
int Child::Reap()
{
  int status = kNotRun;
  while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
  {
  }
  this->Process = -1;
  return status;
}

//------------------------------------------------------------------------------
std::string LastLine(const std::string& text)
{
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
  {
    last = line.empty() ? last : line;
  }
  return last;
}
