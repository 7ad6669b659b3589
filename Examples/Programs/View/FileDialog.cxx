// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileDialog.h"

#include "Spawn.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using Words = std::vector<std::string>;
}

//------------------------------------------------------------------------------
FileDialog::~FileDialog()
{
  if (this->IsOpen())
  {
    kill(this->Process, SIGTERM);
    waitpid(this->Process, nullptr, 0);
    close(this->Output);
  }
}

//------------------------------------------------------------------------------
bool FileDialog::Open()
{
  const char* const title = "Open a raster or a scene";
  std::array<int, 2> ends{ -1, -1 };
  if (this->IsOpen() || pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    return this->IsOpen();
  }
  for (const Words& words : { Words{ "zenity", "--file-selection", "--title", title },
         Words{ "kdialog", "--title", title, "--getopenfilename", "." } })
  {
    // toolkits have much to say on stderr that is no concern of the terrain
    this->Process = this->IsOpen() ? this->Process : Spawn(words, { { ends[1], STDOUT_FILENO } });
  }
  close(ends[1]);
  if (!this->IsOpen())
  {
    close(ends[0]);
    return false;
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  this->Output = ends[0];
  this->Text.clear();
  return true;
}

//------------------------------------------------------------------------------
std::optional<std::string> FileDialog::Poll()
{
  std::array<char, 4096> part{};
  while (this->IsOpen())
  {
    const ssize_t count = read(this->Output, part.data(), part.size());
    if (count > 0)
    {
      this->Text.append(part.data(), static_cast<std::size_t>(count));
    }
    else if (count == 0)
    {
      waitpid(this->Process, nullptr, 0);
      close(this->Output);
      this->Process = -1;
      return this->Text.substr(0, this->Text.find('\n'));
    }
    else if (errno != EINTR)
    {
      break; // nothing yet
    }
  }
  return std::nullopt;
}
