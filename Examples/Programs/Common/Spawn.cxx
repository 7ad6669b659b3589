// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Spawn.h"

#include <algorithm>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

extern char** environ;

//------------------------------------------------------------------------------
pid_t Spawn(std::vector<std::string> words, std::initializer_list<SpawnEnd> ends)
{
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const SpawnEnd& end : ends)
  {
    posix_spawn_file_actions_adddup2(&files, end.Here, end.There);
  }
  for (const int output : { STDOUT_FILENO, STDERR_FILENO })
  {
    if (std::none_of(
          ends.begin(), ends.end(), [output](const SpawnEnd& end) { return end.There == output; }))
    {
      posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
    }
  }
  pid_t process = -1;
  const int error = posix_spawnp(&process, pointers[0], &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return error == 0 ? process : -1;
}
