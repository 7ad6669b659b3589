// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Other programs, started beside this one.
 */
#ifndef terrain_programs_Spawn_h
#define terrain_programs_Spawn_h

#include <initializer_list>
#include <string>
#include <vector>

#include <sys/types.h>

/// A descriptor of this program that is one of the other's: STDIN_FILENO and the like.
struct SpawnEnd
{
  int Here;
  int There;
};

/// Starts a program of the PATH with its arguments; -1 if there is none of that name. What it
/// writes on stdout and stderr goes nowhere, unless an end is given for it.
pid_t Spawn(std::vector<std::string> words, std::initializer_list<SpawnEnd> ends);

#endif
