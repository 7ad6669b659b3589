// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of TOML that a scene is written in.
 */
#ifndef terrain_common_SceneText_h
#define terrain_common_SceneText_h

#include <istream>
#include <string>
#include <vector>

/// One `key = value`.
struct SceneEntry
{
  std::string Key;
  /// One, or those of a list.
  std::vector<std::string> Values;
  /// From 1 on.
  int Line = 0;
};

/// Entries of a text, and what is wrong with it: empty, or a reason and its line.
struct SceneEntries
{
  std::vector<SceneEntry> Entries;
  std::string Error;
  int Line = 0;
};

/// Reads a text; lists may go over several lines.
SceneEntries ReadSceneText(std::istream& text);

/// One line of such a text, with its end. Numbers, true, and keys of letters, digits, - and _ stand
/// as they are, the rest in quotes.
std::string SceneLine(const std::string& key, const std::vector<std::string>& values);

#endif
