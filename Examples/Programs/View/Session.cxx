// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

//------------------------------------------------------------------------------
std::string GetSessionPath()
{
  const auto folder = [](const char* variable)
  {
    const char* text = std::getenv(variable);
    const fs::path path = text ? text : "";
    return path.is_absolute() ? path : fs::path(); // others are to be ignored
  };
  fs::path state = folder("XDG_STATE_HOME");
  if (state.empty() && !folder("HOME").empty())
  {
    state = folder("HOME") / ".local" / "state";
  }
  return state.empty() ? std::string() : (state / "vtkterrain" / "terrain-view.toml").string();
}
