// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Driver.h"

#include "vtkObject.h"

#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

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
/// What the environment makes of both kinds of drivers.
struct Drivers
{
  std::string Words;
  Driver Kinds[2] = { Driver(), Driver::Software() };

  explicit Drivers(std::string words)
    : Words(std::move(words))
  {
    std::string unknown;
    for (Driver& driver : this->Kinds)
    {
      unknown = driver.Apply(this->Words);
    }
    if (!unknown.empty())
    {
      vtkGenericWarningMacro("VTKTERRAIN_DRIVER has \""
        << unknown << "\"; its words are software, graphics, buffer, levels, passed, plain, "
        << "fragment, compute, gather, fetch, isotropic, anisotropic, with commas between them");
    }
  }
};
}

//------------------------------------------------------------------------------
// Several parts of a frame ask: the words are read again only where they have changed.
Driver Driver::Current()
{
  static std::mutex mutex;
  static Drivers drivers{ std::string() };
  const char* given = std::getenv("VTKTERRAIN_DRIVER");
  const std::string words = given ? given : "";
  const std::lock_guard<std::mutex> lock(mutex);
  if (words != drivers.Words)
  {
    drivers = Drivers(words);
  }
  return drivers.Kinds[IsSoftware() ? 1 : 0];
}
}
