// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled for GeographicLib's string ABI: no std::string crosses the border of this file.
#include "core/place/GeographicText.h"

#include <GeographicLib/GeoCoords.hpp>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <cstdio>
#include <exception>
#include <string>

namespace terrain
{
bool WriteUtmText(
  double latitude, double longitude, int precision, char (&text)[kGeographicTextSize])
{
  try
  {
    const GeographicLib::GeoCoords coordinates(latitude, longitude);
    std::snprintf(text, sizeof(text), "%s", coordinates.UTMUPSRepresentation(precision).c_str());
    return true;
  }
  catch (const std::exception&)
  {
    return false;
  }
}

bool WriteMgrs(double latitude, double longitude, int precision, char (&text)[kGeographicTextSize])
{
  try
  {
    int zone = 0;
    bool northern = true;
    double easting = 0.0;
    double northing = 0.0;
    GeographicLib::UTMUPS::Forward(latitude, longitude, zone, northern, easting, northing);
    std::string reference;
    GeographicLib::MGRS::Forward(zone, northern, easting, northing, latitude, precision, reference);
    std::snprintf(text, sizeof(text), "%s", reference.c_str());
    return true;
  }
  catch (const std::exception&)
  {
    return false;
  }
}

bool ReadGeographicText(
  const char* text, double& latitude, double& longitude, char (&message)[kGeographicTextSize])
{
  try
  {
    const GeographicLib::GeoCoords coordinates(text, true, true);
    latitude = coordinates.Latitude();
    longitude = coordinates.Longitude();
    return true;
  }
  catch (const std::exception& error)
  {
    std::snprintf(message, sizeof(message), "%s", error.what());
    return false;
  }
}
}
