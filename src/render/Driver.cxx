// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Driver.h"

#include "vtkObject.h"

#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>

namespace terrain
{
//------------------------------------------------------------------------------
Driver Driver::Software()
{
  Driver driver;
  driver.BuffersPyramid = true;
  driver.PassesUniforms = true;
  driver.ComputesSightings = false;
  driver.Anisotropy = 1.0f;
  return driver;
}

//------------------------------------------------------------------------------
std::string Driver::Apply(const std::string& words)
{
  static const std::map<std::string, std::function<void(Driver&)>> changes{
    { "software", [](Driver& driver) { driver = Driver::Software(); } },
    { "graphics", [](Driver& driver) { driver = Driver(); } },
    { "buffer", [](Driver& driver) { driver.BuffersPyramid = true; } },
    { "levels", [](Driver& driver) { driver.BuffersPyramid = false; } },
    { "passed", [](Driver& driver) { driver.PassesUniforms = true; } },
    { "plain", [](Driver& driver) { driver.PassesUniforms = false; } },
    { "fragment", [](Driver& driver) { driver.ComputesSightings = false; } },
    { "compute", [](Driver& driver) { driver.ComputesSightings = true; } },
    { "gather", [](Driver& driver) { driver.Gathers = true; } },
    { "fetch", [](Driver& driver) { driver.Gathers = false; } },
    { "isotropic", [](Driver& driver) { driver.Anisotropy = 1.0f; } },
    { "anisotropic", [](Driver& driver) { driver.Anisotropy = 16.0f; } },
  };
  std::istringstream list(words);
  for (std::string word; std::getline(list, word, ',');)
  {
    const auto change = changes.find(word);
    if (change == changes.end())
    {
      return word;
    }
    change->second(*this);
  }
  return {};
}

namespace
{
/// A driver changed by the environment, which is warned of.
Driver fromEnvironment(Driver driver, bool warn)
{
  const char* words = std::getenv("VTKTERRAIN_DRIVER");
  const std::string unknown = words ? driver.Apply(words) : std::string();
  if (warn && !unknown.empty())
  {
    vtkGenericWarningMacro("VTKTERRAIN_DRIVER has \""
      << unknown << "\"; its words are software, graphics, buffer, levels, passed, plain, "
      << "fragment, compute, gather, fetch, isotropic, anisotropic, with commas between them");
  }
  return driver;
}
}

//------------------------------------------------------------------------------
// The environment is read once in a process: several parts of a frame ask.
Driver Driver::Current()
{
  static const Driver software = fromEnvironment(Driver::Software(), true);
  static const Driver graphics = fromEnvironment(Driver(), false);
  return IsSoftware() ? software : graphics;
}
}
