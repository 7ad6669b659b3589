// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of a command line in a small text file.
 */
#ifndef terrain_common_SceneFile_h
#define terrain_common_SceneFile_h

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Names of options whose values are files, without dashes.
struct SceneNames
{
  /// Always a file.
  std::set<std::string> Files;
  /// A file or a word: a file if there is one of that name.
  std::set<std::string> FilesOrWords;
  /// Options that are not of a scene: help, and those of the scene itself.
  std::set<std::string> Others;
  /// Options one of which leaves no room for the others: of those in the file none counts when
  /// another one is given beside it.
  std::vector<std::set<std::string>> Rivals;
  /// True to keep options that the command line does not have, for another program's sake.
  bool KeepsUnknown = false;
};

/**
 * A file of TOML: `key = value` lines, where a key is an option without dashes, `heights` for the
 * file that needs none, and a value is a text in quotes, a number, true, false, or a list of these.
 * Options that are given beside the file win. Names of files are relative to the folder of the
 * scene. What is wrong with a file is one sentence with its line.
 */
class SceneFile
{
public:
  /// Adds --scene and --save-scene to a command line that has all its other options; it must live
  /// as long as this object. Calls that follow are about this command line.
  void Declare(CLI::App& app, SceneNames names);

  /// The scene that was read, and that is to be saved; empty for none.
  const std::string& GetInput() const
  {
    return this->Input;
  }
  const std::string& GetOutput() const
  {
    return this->Output;
  }

  /// Names of options of the scene that the command line does not have.
  std::vector<std::string> GetUnknown() const;

  /// Puts values in the place of those that were given for an option; none: it was not given.
  void Replace(const std::string& name, const std::vector<std::string>& values);

  /// The options that were given, but for some, as a file that lies at `path`. Those that the
  /// command line does not have come last.
  std::string ToText(const std::string& path, const std::set<std::string>& without = {}) const;

  /// An error of the command line, with the place in the scene that brought the option.
  std::string Explain(const std::string& error) const;

private:
  class Reader;

  std::string ToLine(const std::string& name, std::vector<std::string> values,
    const std::filesystem::path& folder) const;

  std::string Input;
  std::string Output;
  SceneNames Names;
  CLI::App* App = nullptr;
  /// Options that the command line does not have, as they were in the file, files found from here.
  std::shared_ptr<std::map<std::string, std::vector<std::string>>> Unknown =
    std::make_shared<std::map<std::string, std::vector<std::string>>>();
  /// Line of each key that the scene brought.
  std::shared_ptr<std::map<std::string, int>> Lines =
    std::make_shared<std::map<std::string, int>>();
  /// Those of them that count.
  std::shared_ptr<std::set<std::string>> Brought = std::make_shared<std::set<std::string>>();
  /// Options as they were given, in the order of the command line.
  std::shared_ptr<std::map<std::string, std::vector<std::string>>> Given =
    std::make_shared<std::map<std::string, std::vector<std::string>>>();
};

#endif
