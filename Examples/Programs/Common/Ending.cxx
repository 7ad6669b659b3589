// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ending.h"

#include "vtkTerrainOutputFile.h"

#include <csignal>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace
{
const char* Line = "";

/// Only what is safe in a signal handler: system calls.
void End(int)
{
  vtkTerrainOutputFile::RemovePartialFiles();
  static_cast<void>(write(STDERR_FILENO, Line, std::strlen(Line)) == 0);
  _exit(EXIT_FAILURE);
}

/// As above. The default action is back (SA_RESETHAND), and follows on return.
void CleanUp(int signal)
{
  vtkTerrainOutputFile::RemovePartialFiles();
  static_cast<void>(raise(signal));
}

void Handle(int signal, void (*handler)(int), int flags)
{
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
  {
    return;
  }
  action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  // None of them interrupts another.
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}
}

//------------------------------------------------------------------------------
void EndOnSignals(const char* line)
{
  Line = line;
  for (const int signal : { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU })
  {
    Handle(signal, End, 0);
  }
  for (const int signal : { SIGABRT, SIGSEGV, SIGBUS, SIGILL, SIGFPE })
  {
    Handle(signal, CleanUp, SA_RESETHAND);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}
