// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Refuses "nan" where a command line wants a number: CLI::Range and the other bounds of CLI11 let
 * it pass, for it is neither below nor above anything.
 */
#ifndef terrain_common_NotNumbers_h
#define terrain_common_NotNumbers_h

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

/// True if an option wants a number: CLI11 says so, or one of its checks refuses a word.
inline bool WantsNumber(CLI::Option& option)
{
  if (option.get_type_name().find("FLOAT") != std::string::npos)
  {
    return true;
  }
  try
  {
    for (int check = 0;; ++check)
    {
      std::string word = "word";
      if (!(*option.get_validator(check))(word).empty())
      {
        return true;
      }
    }
  }
  catch (const CLI::OptionNotFound&) // there are no more checks
  {
    return false;
  }
}

/// Throws a CLI::ValidationError, which names the option, if a command line that was parsed gives
/// "nan" for a number, in any spelling; commands of the application are looked through as well.
inline void RefuseNotANumber(CLI::App& app)
{
  for (CLI::Option* option : app.get_options())
  {
    for (const std::string& text : option->results())
    {
      double number = 0.0;
      if (CLI::detail::lexical_cast(text, number) && std::isnan(number) && WantsNumber(*option))
      {
        throw CLI::ValidationError(option->get_name(), "'" + text + "' is not a number");
      }
    }
  }
  for (CLI::App* command : app.get_subcommands())
  {
    RefuseNotANumber(*command);
  }
}

#endif
