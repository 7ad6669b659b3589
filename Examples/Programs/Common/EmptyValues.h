// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Refuses "--option=" without a value, as a variable that is not set makes it: CLI11 takes the word
 * after it, and for a flag its default.
 */
#ifndef terrain_common_EmptyValues_h
#define terrain_common_EmptyValues_h

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/// Throws a CLI::ValidationError, which names the option, if a word of a command line is such.
inline void RefuseEmptyValues(int argc, const char* const* argv)
{
  for (int k = 1; k < argc; ++k)
  {
    const std::string word = argv[k];
    const std::size_t sign = word.find('=');
    if (word == "--") // words after it are no options
    {
      return;
    }
    if (word.compare(0, 2, "--") == 0 && sign != std::string::npos && sign + 1 == word.size())
    {
      throw CLI::ValidationError(word.substr(0, sign), "needs a value after '='");
    }
  }
}

/// Throws a CLI::ValidationError, which names the option, if a command line that was parsed gives
/// an option an empty text, as "--option ''" does; those that may be empty are named.
inline void RefuseNoValue(const CLI::App& app, const std::vector<std::string>& mayBeEmpty)
{
  for (const CLI::Option* option : app.get_options())
  {
    const std::vector<std::string>& texts = option->results();
    const bool isOne = option->nonpositional() && option->get_items_expected_max() > 0 &&
      std::find(texts.begin(), texts.end(), std::string()) != texts.end();
    const std::string name = option->get_name();
    if (isOne && std::find(mayBeEmpty.begin(), mayBeEmpty.end(), name) == mayBeEmpty.end())
    {
      throw CLI::ValidationError(name, "needs a value, and an empty one was given");
    }
  }
}

#endif
