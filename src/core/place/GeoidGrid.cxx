// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled for GeographicLib's string ABI: no std::string crosses the border of this file.
#include "core/place/GeoidGrid.h"

#include <GeographicLib/Geoid.hpp>

#include <cstdio>
#include <exception>
#include <limits>

namespace terrain
{
namespace
{
class GeographicGeoidGrid final : public GeoidGrid
{
public:
  GeographicGeoidGrid(const char* name, const char* directory, bool holdInMemory)
    : Geoid(name, directory, true, holdInMemory)
  {
  }

  double GetHeight(double latitude, double longitude) const override
  {
    try
    {
      return this->Geoid(latitude, longitude);
    }
    catch (const std::exception&)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

private:
  GeographicLib::Geoid Geoid;
};
}

std::unique_ptr<GeoidGrid> GeoidGrid::Open(
  const char* name, const char* directory, bool holdInMemory, char (&message)[kGeoidTextSize])
{
  try
  {
    return std::make_unique<GeographicGeoidGrid>(name, directory, holdInMemory);
  }
  catch (const std::exception& error)
  {
    std::snprintf(message, sizeof(message), "%s", error.what());
    return nullptr;
  }
}

void GeoidGrid::GetDefaultDirectory(char (&directory)[kGeoidTextSize])
{
  std::snprintf(
    directory, sizeof(directory), "%s", GeographicLib::Geoid::DefaultGeoidPath().c_str());
}
}
